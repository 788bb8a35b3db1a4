#include "mv/demo/lesson.h"

#include "mv/demo/seen.h"

namespace mv {

void Numbers::set(const char* name, double value) {
    for (Readout* readout : demo_.readouts()) {
        if (readout->name() == std::string_view(name)) {
            *readout = value;
            return;
        }
    }
    throw Error("readout " + std::string(name), "must be one of the lesson's");
}

Scene seen(Scene scene, const Frame& frame) {
    if (const auto& camera = frame.camera()) {
        scene.viewFromWorld = camera->viewFromWorld;
        scene.clipFromView = camera->clipFromView;
    }
    return scene;
}

}  // namespace mv

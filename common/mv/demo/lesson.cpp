#include "mv/demo/lesson.h"

#include "mv/demo/seen.h"

namespace mv {

void LessonBase::addRow(const AnyRow& row, void* settings, const void* initial) {
    made_.push_back(std::make_unique<Knob>(row, settings, initial));
    add(made_.back().get());
}

void LessonBase::addControl(const Control& control) {
    Knob& moved = knob(control.knob);
    switch (control.gesture) {
        case Gesture::key:
            if (control.other.empty())
                bindKeys(control.key, control.otherKey, moved, control.amount);
            else
                bindKey(control.key, moved, control.other);
            break;
        case Gesture::dragAcross:
        case Gesture::dragDown:
            bindDrag(moved, control.amount, knob(control.other), control.otherAmount);
            break;
        case Gesture::wheel:
            bindWheel(moved, control.amount);
            break;
    }
}

void LessonBase::addReadout(const Probe::Number& number) {
    told_.push_back(std::make_unique<Readout>(this, number.name, number.help, number.unit));
}

void LessonBase::checkFiles() const {
    for (const Knob* knob : knobs()) {
        if (knob->kind() == Knob::Kind::file) knob->checkFile();
    }
}

std::vector<Knob*> LessonBase::numbers(const std::vector<Literal>& names) const {
    std::vector<Knob*> found;
    for (const Literal name : names) {
        found.push_back(&knob(name));
        const Knob::Kind kind = found.back()->kind();
        if (kind != Knob::Kind::number && kind != Knob::Kind::angle)
            throw Error("handle", "must name rows that are numbers", name);
    }
    return found;
}

Knob& LessonBase::points(Literal name) const {
    if (knob(name).kind() != Knob::Kind::points) throw Error("handle", "must name a row of points", name);
    return knob(name);
}

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

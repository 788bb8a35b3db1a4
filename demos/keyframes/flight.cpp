// A camera all of whose properties have keys: where its eye is, where it looks, what is up, the shape of its picture, and its angle.
#include <algorithm>
#include <cmath>

#include "keyframes.h"
#include "mv/gl/functions.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

namespace mv::keyframes {

void drawFlight(Gpu& gpu, const Settings& s, const Frame& frame) {
    // Find each property at this time, and make the matrices of them
    const double now = std::fmod(frame.time(), lap);
    const CameraAt camera = cameraAt(s, now);
    const mat4 viewFromWorld = lookAt(camera.eye, camera.center, camera.up);
    const mat4 clipFromView = perspective(camera.fovy, camera.aspect, 0.1, 300);
    frame.show("viewFromWorld", viewFromWorld);
    frame.show("clipFromView", clipFromView);

    // Draw the street into as much of the pane as has the camera's shape
    const Pane pane = shapedPane(leftPane(frame), camera.aspect);
    glEnable(GL_DEPTH_TEST);
    drawStreet(gpu, pane, clipFromView * viewFromWorld, frame);
    glDisable(GL_DEPTH_TEST);

    const FrameInfo units = frame.inUnits();
    showFlight(gpu.drawing, s, now, shapedPane(leftPane(units), camera.aspect), units);
}

// The keys are two seconds apart; the last is the first again.
const std::vector<CameraAt>& cameraKeys() {
    static const std::vector<CameraAt> keys{
        {{0, 1, 6}, {0, 1, 0}, {0, 1, 0}, 1, 50},
        {{3.5, 2.5, 5}, {0, 1.6, 0}, {0.4, 1, 0}, 2.35, 35},
        {{-3, 4, 8}, {0.5, 1.5, -4}, {0, 1, 0}, 0.6, 70},
    };
    return keys;
}

// A curve for each property that moves. The others keep the value of their first key.
CameraAt cameraAt(const Settings& s, double time) {
    const auto at = [&](Moves which, auto CameraAt::*property) {
        using Value = std::remove_cvref_t<decltype(CameraAt{}.*property)>;
        if (s.flight != Moves::all && s.flight != which) return cameraKeys().front().*property;
        std::vector<Keyframe<Value>> keys;
        for (const CameraAt& key : cameraKeys()) keys.push_back({2.0 * double(keys.size()), key.*property});
        keys.push_back({lap, keys.front().value});
        return s.curve.through(keys, Value(0), Value(0)).position(time);
    };
    return {at(Moves::eye, &CameraAt::eye), at(Moves::center, &CameraAt::center), at(Moves::up, &CameraAt::up),
            at(Moves::aspect, &CameraAt::aspect), at(Moves::fovy, &CameraAt::fovy)};
}

// The largest part of a pane with this ratio of width to height, in its middle.
Pane shapedPane(const Pane& pane, double aspect) {
    const int width = std::clamp(int(std::lround(pane.height * aspect)), 1, pane.width),
              height = std::clamp(int(std::lround(pane.width / aspect)), 1, pane.height);
    return {pane.x + (pane.width - width) / 2, pane.y + (pane.height - height) / 2, width, height};
}

}  // namespace mv::keyframes

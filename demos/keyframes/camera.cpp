// A camera that goes away from its subject and zooms in: its distance and its angle of view have keys.
#include <cmath>

#include "keyframes.h"
#include "mv/gl/functions.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

namespace mv::keyframes {

void drawCamera(Gpu& gpu, const Settings& s, const Frame& frame) {
    // Look at the middle of the subject from the present distance, by the present angle
    const double now = std::fmod(frame.time(), lap);
    const View view = viewAt(s.camera, s.curve, now, s.camera.zoom);
    const Pane pane = leftPane(frame);
    const vec3 middle(0, figureHeight / 2, 0);
    const mat4 viewFromWorld = lookAt(middle + vec3(0, 0, view.distance), middle, vec3(0, 1, 0));
    const mat4 clipFromView = perspective(view.fovy, pane.aspect(), 0.5, 300);
    frame.show("viewFromWorld", viewFromWorld);
    frame.show("clipFromView", clipFromView);

    // Draw the street. Its parts are in an order that needs no depth buffer
    drawStreet(gpu, pane, clipFromView * viewFromWorld, frame);

    showZoom(gpu.drawing, s, now, frame.inUnits());
}

void drawStreet(Gpu& gpu, const Pane& pane, const mat4& clipFromWorld, const Frame& frame) {
    glEnable(GL_CULL_FACE);
    glViewport(pane.x, pane.y, pane.width, pane.height);
    gpu.street->program.use();
    gpu.street->program.set("clipFromWorld", clipFromWorld);
    gpu.street->mesh.draw();
    glViewport(0, 0, frame.width(), frame.height());
}

// The view at a time. The distance goes near, far and near again. The angle is computed from it, or has keys at the same
// times.
View viewAt(const DollyZoom& camera, const KeyCurve& curve, double time, Zoom zoomedBy) {
    const auto between = [&](double end, double middle) {
        return curve.through<double>({{0, end}, {lap / 2, middle}, {lap, end}}, 0, 0).position(time);
    };
    const double distance = between(camera.nearest, camera.farthest);
    if (zoomedBy == Zoom::computed) return {distance, fovyFor(camera, distance)};
    return {distance, between(camera.fovy, fovyFor(camera, camera.farthest))};
}

// The dolly zoom: the angle for which the subject is as large as at the first key.
double fovyFor(const DollyZoom& camera, double distance) {
    return 2 * degrees(std::atan(camera.nearest * std::tan(radians(camera.fovy / 2)) / distance));
}

double View::sizeOf(double height, double behind) const {
    return height / (2 * (distance + behind) * std::tan(radians(fovy / 2)));
}

}  // namespace mv::keyframes

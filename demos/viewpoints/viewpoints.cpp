// viewpoints: a car on a round track, seen from nine places, each by one lookAt and an order of matrices.
#include "viewpoints.h"

#include <array>
#include <cmath>
#include <cstddef>

#include "mv/geometry/in_view.h"
#include "mv/gl/functions.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/car.h"

namespace mv::viewpoints {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    // Let near things hide far ones, and draw below the figure of the camera
    glEnable(GL_DEPTH_TEST);
    const Pane pane = lowerPane(s, frame);
    glViewport(pane.x, pane.y, pane.width, pane.height);

    // Place the car, and look from the chosen view
    const Car car = carAt(frame.index());
    const auto [viewFromWorld, viewFromCar] = lookFrom(s, car);
    const mat4 clipFromView = perspective(50, pane.aspect(), 1, 500);
    frame.show("viewFromWorld", viewFromWorld);
    frame.show("viewFromCar", viewFromCar);
    frame.show("clipFromView", clipFromView);

    // Draw car or scenery first, whichever is in the space of lookAt, as its matrix comes first. With the depth test any order is
    // right
    gpu.program.use();
    setSun(gpu, s, viewFromWorld);
    if (s.lit) drawSkyAndGround(gpu, viewFromWorld, infinitePerspective(50, pane.aspect(), 1));
    gpu.program.set("clipFromView", clipFromView);
    if (gazeOf(s, car).space == Space::car) {
        drawCar(gpu, viewFromCar);
        drawScenery(gpu, clipFromView, viewFromWorld);
    } else {
        drawScenery(gpu, clipFromView, viewFromWorld);
        drawCar(gpu, viewFromCar);
    }
}

// Drive clockwise, seen from above, by 3 degrees a frame.
Car carAt(int frame) {
    const double d = 3.0 * (frame % 120);
    const vec3 place(100 * std::sin(radians(d)), 100 * std::cos(radians(d)), 0);
    return {d, place, translate(place) * rotateZ(-d), rotateZ(d) * translate(-place)};
}

// Put the car into the world when lookAt is in world space, or the world around the car when lookAt is in the car's space.
Look lookFrom(const Settings& s, const Car& car) {
    const Gaze gaze = gazeOf(s, car);
    const mat4 look = lookAt(gaze.eye, gaze.at, gaze.up);
    if (gaze.space == Space::world) return {look, look * car.worldFromCar};
    // The slide's view 5 looks from a car that is not turned, and then turns the picture
    const mat4 viewFromCar = s.view == View::house ? rotateY(-car.direction) * look : look;
    return {viewFromCar * car.carFromWorld, viewFromCar};
}

// The page's table, with a line for each view. View 5 has a second line, which is exact.
Gaze gazeOf(const Settings& s, const Car& car) {
    const double h = s.height;
    const vec3 house = watchedPlace(s), seat(3, 0, 5 + h);
    if (s.view == View::house && s.exact) return {vec3(car.worldFromCar * vec4(seat, 1)), house, Space::world};
    const std::array<Gaze, 9> gazes{{
        {vec3(250, 0, 100 + h), vec3(0, 0, 0), Space::world},
        {vec3(75, 0, 5 + h), car.place, Space::world},
        {vec3(125, 0, 5 + h), car.place, Space::world},
        {vec3(-3, 0, 5 + h), vec3(12, 0, 2 + h), Space::car},
        {seat, house - car.place, Space::car},
        {vec3(-12, 0, 6 + h), vec3(15, 0, 4), Space::car},
        {vec3(25, 5, 5 + h), vec3(0, 0, 2), Space::car},
        {vec3(2, 20, 5 + h), vec3(2, 0, 2), Space::car},
        {vec3(0, 0, 200 + h), vec3(0, 0, 0), Space::world, vec3(0, 1, 0)},  // looks along z, so up must differ
    }};
    return gazes[std::size_t(s.view)];
}

// The house that view 5 looks at.
vec3 watchedPlace(const Settings& s) { return {40, 120, s.aim}; }

struct House {
    double x, y, size;
};
constexpr House houses[] = {{-20, 50, 5},  {0, 70, 10},   {20, -10, 8}, {40, 120, 10},
                            {-30, -50, 7}, {10, -60, 10}, {-20, 75, 8}, {-40, 140, 10}};

// Draw sky and ground first, without depths: all else lies over them. No far plane may cut off the ground before the horizon.
void drawSkyAndGround(Gpu& gpu, const mat4& viewFromWorld, const mat4& clipFromView) {
    glClearColor(0.62F, 0.80F, 0.95F, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glDisable(GL_DEPTH_TEST);
    gpu.program.set("paint", vec4(0.66, 0.84, 0.62, 1));
    gpu.program.set("isBox", false);
    gpu.program.set("clipFromView", clipFromView);
    gpu.program.set("viewFromModel", viewFromWorld * rotateX(90) * scale(1e5, 1, 1e5));
    gpu.ground->draw();
    glEnable(GL_DEPTH_TEST);
}

// Light boxes from the side, each face by its own normal: without it they are silhouettes.
void setSun(const Gpu& gpu, const Settings& s, const mat4& viewFromWorld) {
    gpu.program.set("sun", s.lit ? vec3(viewFromWorld * vec4(0.45, -0.3, 0.84, 0)) : vec3(0));
}

void drawScenery(Gpu& gpu, const mat4& clipFromView, const mat4& viewFromWorld) {
    // Draw the track in grey
    gpu.program.set("paint", vec4(0.4, 0.4, 0.4, 1));
    gpu.program.set("isBox", false);
    gpu.program.set("viewFromModel", viewFromWorld);
    gpu.track.draw();

    // Draw the houses that are in view in red
    gpu.program.set("paint", vec4(1, 0, 0, 1));
    gpu.program.set("isBox", true);
    for (const auto& [x, y, size] : houses) {
        const mat4 viewFromHouse = viewFromWorld * translate(x, y, size / 2) * scale(size);
        if (!isInView(gpu.plainCube, clipFromView * viewFromHouse)) continue;
        gpu.program.set("viewFromModel", viewFromHouse);
        gpu.cube.draw();
    }
}

void drawCar(Gpu& gpu, const mat4& viewFromCar) {
    gpu.program.set("paint", vec4(0, 0, 1, 1));
    gpu.program.set("isBox", true);
    for (const mat4& carFromCube : carFromCubes()) {
        gpu.program.set("viewFromModel", viewFromCar * carFromCube);
        gpu.cube.draw();
    }
}

}  // namespace mv::viewpoints

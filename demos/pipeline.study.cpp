// What measures pipeline: where points of the cube fall, against products in long double.
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

using namespace mv;
using namespace mv::claims;

namespace {

// The demo's matrices once more, from its knobs, for a square view.
mat4 worldFromModel(const Demo& demo) {
    const mat4 m = translate(demo.number("offset") + 0.2, 0.1, 0) * rotateX(demo.number("spin-x")) *
                   rotateY(demo.number("spin-y"));
    return demo.word("matrices") == "slide-model" ? glm::transpose(m) : m;
}

mat4 cameraFromWorld(const Demo& demo) {
    const vec3 gaze = vec3(-3, -2, -6) / 7.0, eye = vec3(demo.number("offset"), 0, 0) - gaze * demo.number("distance");
    return lookAt(eye, eye + gaze, vec3(0, 1, 0));
}

mat4 clipFromCamera(const Demo& demo) {
    const double near = demo.number("near"), far = demo.number("far");
    mat4 m = perspective(50, 1, near, far);
    if (demo.word("matrices") == "slide-projection") {
        m[2] = vec4(0, 0, far / (far - near), 1);
        m[3] = vec4(0, 0, near * far / (near - far), 0);
    }
    return m;
}

// With 64 bits of mantissa all the way; the points are the float ones.
Reference placesInLongDouble(const Demo& demo) {
    using Wide = glm::mat<4, 4, long double>;
    const Wide all = Wide(clipFromCamera(demo)) * Wide(cameraFromWorld(demo)) * Wide(worldFromModel(demo));
    constexpr int side = 8, pictureSide = 560;
    constexpr double half = 0.6;
    Reference right;
    for (int i = 0; i < side * side * side; ++i) {
        const vec3 point = half * (2.0 / (side - 1) * vec3(i % side, i / side % side, i / (side * side)) - 1.0);
        const auto clip = all * glm::vec<4, long double>(fvec3(point), 1);
        for (int axis = 0; axis < 2; ++axis)
            right.values.push_back(double((clip[axis] / clip.w + 1) / 2 * pictureSide));
    }
    return right;
}

Study study() {
    Study study;
    study.quantity = "where 512 points of the cube fall, x and y in pixels of a picture 560 wide";
    study.reference = "the same matrices and points in long double, rounded nowhere else";
    study.makeReference = [](const Demo& demo, const ReferenceFrame&, const auto&) { return placesInLongDouble(demo); };
    study.problem = "offset";
    study.scenes = {{"the cube at 3"}};
    const std::vector<std::string> offsets{"0", "1e2", "1e4", "1e6", "1e7"};
    study.lines = {{"three products, float", {{"products", "shader"}}, "offset", offsets},
                   {"one product, float matrices", {{"products", "single"}}, "offset", offsets},
                   {"one product, double matrices", {{"products", "once"}}, "offset", offsets}};
    const auto three = rows("three products, float"), single = rows("one product, float matrices"),
               once = rows("one product, double matrices");
    study.says = {
        claim("float-cancels",
              "Far from the origin a matrix has large numbers that cancel. In float the error of what is left "
              "grows like the distance from the origin.",
              {slope(of::rms, rows("three products, float", "one product, float matrices").from(100), 0.8, 1.2)}),
        claim("in-pixels", "It is a twentieth to an eighth of a pixel at 1e4, and one to six pixels at 1e6.",
              {value(of::rms, three.at(1e4), 0.05, 0.125), value(of::rms, single.at(1e4), 0.05, 0.125),
               value(of::rms, three.at(1e6), 1, 6), value(of::rms, single.at(1e6), 1, 6)}),
        claim("double-cancels-first",
              "Multiplied in double the numbers cancel before they are rounded, and the error is at most 3e-5 "
              "pixels, as near the origin as far from it.",
              {settled(of::rms, once, 1.01), atMost(of::max, once, 3e-5)}),
        claim("double-unbeaten", "From 100 on no product in float is as near and as fast.",
              {unbeaten(once.from(100), rows("three products, float", "one product, float matrices"))})};
    study.ofValues = true;
    return study;
}

const bool studied = addStudy("pipeline", study());

}  // namespace

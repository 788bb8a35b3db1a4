// The readouts of pipeline, and its study: where points of the cube fall, against products in long double.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "gpu_product.h"
#include "mv/demo/lesson.h"
#include "mv/geometry/closest.h"
#include "mv/gl/feedback.h"
#include "mv/math/projection.h"
#include "mv/math/unproject.h"
#include "pipeline.h"

namespace mv::pipeline {

// Compare transform feedback with the products shown, each from what the GPU had before it; and those with what another order
// of rounding would make of them.
static void readProducts(Gpu& gpu, const Settings& s, double aspect, Numbers& numbers) {
    fvec4 before(corner(s.vertex), 1);
    double most = 0;
    int fusedCount = 0, onceCount = 0, wanted = 0;
    for (const Step& step : steps(s, aspect)) {
        if (s.products == Products::shader) programOf(gpu, s).set("wanted", wanted = (wanted + 1) % 3);
        const fvec4 captured = transformedPositions(gpu.corners)[std::size_t(s.vertex)];
        const fmat4 m(step.uploaded);
        const fvec4 mine = gpuProduct(m, before), other = fusedProduct(m, before);
        const fvec4 once(mat4(m) * vec4(before));
        const vec4 unit = productUnit(m, before);
        for (int row = 0; row < 4; ++row) {
            if (captured[row] != mine[row])
                most = std::max(most, std::abs(double(captured[row]) - mine[row]) / unit[row]);
            fusedCount += int(other[row] != mine[row]);
            onceCount += int(once[row] != mine[row]);
        }
        before = captured;
    }
    numbers.set("gpu-off", most);
    numbers.set("fused-differ", fusedCount);
    numbers.set("once-differ", onceCount);
}

// Go from the pixel back to the point, in the cube's own space, by the matrices as they are in double.
static void readWayBack(const Settings& s, const Pane& pane, const vec3& pixel, Numbers& numbers) {
    mat4 clipFromModel(1);
    for (const Step& step : steps(s, pane.aspect())) clipFromModel = step.exact * clipFromModel;
    const auto pointAt = [&](double kept) {
        return unProject(vec2(pixel), kept, clipFromModel, pane.width, pane.height);
    };
    const double step = 1.0 / ((1 << 24) - 1);
    const vec3 along = directionThroughPixel(vec2(pixel), clipFromModel, pane.width, pane.height);
    const vec3 vertex = corner(s.vertex), foot = closestOnLine(vertex, pointAt(0), pointAt(0) + along);
    numbers.set("back-off", glm::distance(pointAt(pixel.z), vertex));
    numbers.set("depth-step",
                glm::distance(pointAt(pixel.z), pointAt(pixel.z > 0.5 ? pixel.z - step : pixel.z + step)));
    numbers.set("ray-miss", glm::distance(vertex, foot));
}

void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers) {
    const Pane pane = viewIn(frame);
    readProducts(gpu, s, pane.aspect(), numbers);
    const auto [clip, exact] = clipOf(s, pane.aspect());
    numbers.set("w", clip.w);
    if (clip.w == 0 || exact.w == 0 || !isInView(clip)) return;
    const vec3 pixel = pixelFromDevice(deviceFromClip(clip), pane),
               exactPixel = pixelFromDevice(deviceFromClip(exact), pane);
    numbers.set("pixel-x", pixel.x);
    numbers.set("pixel-y", pixel.y);
    numbers.set("depth", pixel.z);
    numbers.set("float-error", std::hypot(pixel.x - exactPixel.x, pixel.y - exactPixel.y));
    readWayBack(s, pane, pixel, numbers);
}

// Points of the cube, and the side of the picture where the study looks for them.
static constexpr int side = 8, pictureSide = 560;
static std::vector<vec3> points() {
    std::vector<vec3> all;
    all.reserve(side * side * side);
    for (int i = 0; i < side * side * side; ++i)
        all.push_back(half * (2.0 / (side - 1) * vec3(i % side, i / side % side, i / (side * side)) - 1.0));
    return all;
}

std::vector<double> values(const Settings& s) {
    std::vector<fmat4> uploaded;
    for (const Step& step : steps(s, 1)) uploaded.emplace_back(step.uploaded);
    std::vector<double> pixels;
    for (const vec3& point : points()) {
        fvec4 value(point, 1);
        for (const fmat4& m : uploaded) value = gpuProduct(m, value);
        const vec2 pixel = pixelFromNdc(ndcFromClip(vec4(value)), pictureSide, pictureSide);
        pixels.insert(pixels.end(), {pixel.x, pixel.y});
    }
    return pixels;
}

namespace {

using namespace mv::claims;

// With 64 bits of mantissa all the way; the points are the float ones.
Reference placesInLongDouble(const Settings& s) {
    using Wide = glm::mat<4, 4, long double>;
    const Wide all = Wide(clipFromCamera(s, 1)) * Wide(cameraFromWorld(s)) * Wide(worldFromModel(s));
    Reference right;
    for (const vec3& point : points()) {
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
    study.makeReference = [](const Demo& demo, const ReferenceFrame&, const auto&) {
        return placesInLongDouble(settingsOf<Settings>(demo));
    };
    study.reads = {"distance", "spin-x", "spin-y", "near", "far", "offset", "matrices"};
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

[[maybe_unused]] const bool studied = addStudy("pipeline", study());

}  // namespace
}  // namespace mv::pipeline

// The readouts of texture-map, and its study: how far from its place each pixel's texture lies on the square.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <vector>

#include "mv/demo/lesson.h"
#include "perspective_quad.h"
#include "texture-map.h"

namespace mv::texture_map {

using namespace claims;

void readOut(Gpu&, const Settings& s, const Frame& frame, Numbers& numbers) {
    if (s.shape == Shape::quad && !isForward(s))
        numbers.set("slip", largestSlip(s.surface.ratio, s.surface.divisions, paneOf(frame)).pixels);
    if (!isTriangle(s)) return;
    const TexturedTriangle corners = cornersOf(s.triangle);
    numbers.set("determinant", glm::determinant(pointFromTexture(corners)));
    numbers.set("off", errorInFloats(planeMap(s.triangle), corners));
}

// The surface with the texture, for those who count its triangles.
Scene sceneOf(const Settings& s, const FrameInfo&) {
    Scene scene;
    scene.objects = {
        {.name = "surface", .mesh = isTriangle(s) ? withoutTexCoords(triangleMesh(s.triangle)) : meshOf(s)}};
    return scene;
}

namespace {

// Pixels of the square that are compared, the upper row first: those a thousandth of the square from its edges.
std::vector<int> regionsOf(const Settings& s, const FrameInfo& frame) {
    std::vector<int> regions(static_cast<std::size_t>(frame.width()) * static_cast<std::size_t>(frame.height()), -1);
    if (s.shape != Shape::quad) return regions;
    const mat3 map = quadFromPixel(s.surface.ratio, {0, 0, frame.width(), frame.height()});
    for (int row = 0; row < frame.height(); ++row) {
        for (int x = 0; x < frame.width(); ++x) {
            const vec2 at = projected(map, {x + 0.5, frame.height() - row - 0.5});
            if (std::min({at.x, at.y, 1 - at.x, 1 - at.y}) > 0.001) regions[pixelIndex(x, row, frame.width())] = 0;
        }
    }
    return regions;
}

Reference noSlip(const Settings& s, const ReferenceFrame& frame) {
    Reference reference{.values = {}, .regions = regionsOf(s, frame)};
    for (const int region : reference.regions) reference.values.push_back(region);
    return reference;
}

constexpr int side = 480;  // of the study's picture

// Measured as large as the demo shows the square.
struct Seen {
    std::vector<float> slips;
    std::vector<int> regions;
};
Seen seen(Probing& probing) {
    const FrameInfo pane(probing.frame().index(), std::max(1, probing.frame().width() * 5 / 8),
                         probing.frame().height());
    return {probing.measured(pane.width(), pane.height()), regionsOf(settingsOf<Settings>(probing.demo()), pane)};
}

std::vector<double> slipSeen(Probing& probing) {
    const auto s = settingsOf<Settings>(probing.demo());
    if (s.shape != Shape::quad || isForward(s)) return {};
    const auto [slips, regions] = seen(probing);
    if (slips.empty()) return {};
    return {std::max(0.0, double(*std::max_element(slips.begin(), slips.end())))};
}

std::vector<double> holesSeen(Probing& probing) {
    const auto s = settingsOf<Settings>(probing.demo());
    if (s.shape != Shape::quad || !isForward(s)) return {};
    const auto [slips, regions] = seen(probing);
    double holes = 0, all = 0;
    for (std::size_t i = 0; i < slips.size(); ++i) {
        if (regions[i] < 0) continue;
        ++all;
        holes += slips[i] < 0;
    }
    if (all == 0) return {};
    return {holes, 100 * holes / all};
}

// The surface's triangles: their area, how many show the texture the other way round than most, and how much of it none
// shows the right way.
std::vector<double> trianglesCounted(Probing& probing) {
    const Scene scene = probing.demo().scene(probing.frame());
    const MeshData& mesh = scene.objects.front().mesh;
    if (mesh.indices.empty()) return {};  // points, or a triangle by itself
    double area = 0, shown = 0, backward = 0;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const auto point = [&](std::size_t k) { return vec3(mesh.positions[mesh.indices[i + k]]); };
        const auto at = [&](std::size_t k) { return vec2(mesh.texCoords[mesh.indices[i + k]]); };
        const vec2 first = at(1) - at(0), second = at(2) - at(0);
        const double inTexture = (first.x * second.y - first.y * second.x) / 2;
        area += glm::length(glm::cross(point(1) - point(0), point(2) - point(0))) / 2;
        shown += std::max(0.0, inTexture);
        backward += inTexture < 0;
    }
    return {area, backward, 100 * std::max(0.0, 1 - shown)};
}

Study study() {
    Study study;
    study.quantity =
        "how far from its pixel the texture that it shows belongs, in px; 480 x 480 of them show the square";
    study.reference = "none is off: which pixels the square covers is computed in double precision";
    study.makeReference = [](const Demo& demo, const ReferenceFrame& frame, const auto&) {
        return noSlip(settingsOf<Settings>(demo), frame);
    };
    study.reads = {"shape", "ratio"};
    study.axis = ErrorAxis::max;
    study.width = side;
    study.height = side;
    study.wrongBeyond = 0.5;
    study.scenes = {{"W = 1.5", {{"ratio", "1.5"}}}, {"W = 2", {{"ratio", "2"}}}, {"W = 10", {{"ratio", "10"}}}};
    const std::vector<std::string> divisions{"1", "2", "4", "8", "16", "32", "48", "64"};
    for (const std::string method : {"affine", "correct", "by-hand"}) {
        study.lines.push_back(
            {.method = method, .settings = {{"method", method}}, .knob = "divisions", .values = divisions});
    }
    const auto affine = rows("affine");
    study.says = {
        claim("square",
              "With W = 1.5 and 2 the slip falls as the square of the divisions, to a tenth in the power, from 8 of "
              "them on.",
              {slope(of::max, affine.in("W = 1.5").from(8), -2.1, -1.9),
               slope(of::max, affine.in("W = 2").from(8), -2.1, -1.9)}),
        claim("later", "With W = 10 it falls as their power 1.7 near 64 divisions.",
              {slope(of::max, affine.in("W = 10").from(32), -1.8, -1.6)}),
        claim("flat-start", "With W = 10 it falls more slowly than 1/n while there are 4 divisions at most.",
              {slope(of::max, affine.in("W = 10").upTo(4), -1, 0)}),
        claim("correct", "Divided by the driver or by hand, nothing is off by a hundredth of a pixel.",
              {atMost(of::max, rows("correct", "by-hand"), 0.01)}),
        claim("at-once",
              "One cell, divided by the driver, is a hundred times nearer than 64 affine ones, and no slower.",
              {ratio(of::max, rows("correct").at(1), affine.at(64), 0, 0.01),
               ratio(of::time, rows("correct").at(1), affine.at(64), 0, 1)}),
        note("Largest in the picture: the largest over all pixels at least a thousandth of the square from its edges. "
             "The "
             "formula's largest lies between pixels, and on the page.")};
    return study;
}

const bool studied = addStudy("texture-map", study());
const bool probed =
    addProbes("texture-map", {{{{"slip-seen", "the largest in the picture's pixels", "px"}}, slipSeen},
                              {{{"holes", "pixels of the square that no texel falls on"},
                                {"holes-part", "the same, of all pixels of the square", "%"}},
                               holesSeen},
                              {{{"area", "of the surface's triangles; the radius is 1, and so is the square's side"},
                                {"backward", "triangles that show the texture the other way round than most"},
                                {"lost", "the part of the texture that no triangle shows the right way round", "%"}},
                               trianglesCounted}});

}  // namespace
}  // namespace mv::texture_map

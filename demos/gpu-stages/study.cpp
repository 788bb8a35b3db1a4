// The readouts of gpu-stages, and its study: how far its triangles are from the patch itself, and whether two
// kinds of shader make one picture.
#include <algorithm>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <vector>

#include "exact_patch.h"
#include "gpu-stages.h"
#include "mv/demo/lesson.h"
#include "shared/seen_pixels.h"

namespace mv::gpu_stages {

void readOut(Gpu& gpu, const Settings& s, const Frame&, Numbers& numbers) {
    if (s.show == Show::stages && s.counts) {
        numbers.set("into-geometry", double(gpu.toGeometry.number.generated));
        numbers.set("out-of-geometry", double(gpu.sent.number.generated));
        numbers.set("written", double(gpu.sent.number.written));
        numbers.set("found", gpu.sent.found());
        numbers.set("fragments-passed", double(gpu.passed));
    }
    if (s.show == Show::primitives && s.counts) numbers.set("primitives", double(gpu.types.counted()));
    if (s.show == Show::meshes) numbers.set("irregular", double(gpu.bodies.irregular()));
}

namespace {

using namespace mv::claims;

// How deep in the picture the patch itself is, in each pixel, the upper row first; -1 where there is none.
std::vector<double> exactDepths(const Demo& demo, const FrameInfo& frame) {
    if (demo.word("show") != "stages") throw Error("--show", "must be the stages to be measured", demo.word("show"));
    const ExactPatch exact(demo.number("bend"));
    const mat4 clipFromWorld = demo.scene(frame).clipFromWorld(), worldFromClip = glm::inverse(clipFromWorld);
    std::vector<double> depths;
    depths.reserve(static_cast<std::size_t>(frame.width()) * static_cast<std::size_t>(frame.height()));
    for (int row = 0; row < frame.height(); ++row) {
        for (int x = 0; x < frame.width(); ++x) {
            const double across = 2 * (x + 0.5) / frame.width() - 1, up = 1 - 2 * (row + 0.5) / frame.height();
            const vec4 near = worldFromClip * vec4(across, up, -1, 1), far = worldFromClip * vec4(across, up, 1, 1);
            const vec3 from = vec3(near) / near.w, to = vec3(far) / far.w;
            const auto hit = exact.firstHit(from, to);
            depths.push_back(hit ? (clipFromWorld * vec4(glm::mix(from, to, *hit), 1)).w : -1);
        }
    }
    return depths;
}

// Whether the outline, which a few triangles move, is at most so many pixels away.
bool isNearOutline(const std::vector<double>& depths, const FrameInfo& frame, int x, int row) {
    constexpr int reach = 6;
    const bool isOn = depths[pixelIndex(x, row, frame.width())] > 0;
    for (int v = std::max(row - reach, 0); v <= std::min(row + reach, frame.height() - 1); ++v) {
        for (int u = std::max(x - reach, 0); u <= std::min(x + reach, frame.width() - 1); ++u) {
            if ((depths[pixelIndex(u, v, frame.width())] > 0) != isOn) return true;
        }
    }
    return false;
}

Reference exactPatch(const Demo& demo, const ReferenceFrame& frame) {
    Reference right{.values = exactDepths(demo, frame)};
    // Near the outline each pixel is a region of its own: so all of these are in the edge band. Outside they are negative.
    for (int row = 0; row < frame.height(); ++row) {
        for (int x = 0; x < frame.width(); ++x) {
            const bool isOn = right.values[pixelIndex(x, row, frame.width())] > 0;
            const int other = isNearOutline(right.values, frame, x, row) ? (x + row) % 2 : 0;
            right.regions.push_back(isOn ? other : -1 - other);
        }
    }
    right.work = double(right.values.size());
    return right;
}

// The errors of the present settings, where both the triangles and the patch are seen.
std::vector<double> depthErrors(Probing& probing) {
    const Demo& demo = probing.demo();
    const std::string stage = demo.word("geometry");
    const bool isWhole = stage == "off" || stage == "pass" || stage == "wireframe";
    if (demo.word("show") != "stages" || demo.word("fragments") == "off" || !isWhole) return {};
    const FrameInfo frame(probing.frame().index(), 240, 140);
    const std::vector<float> shown = probing.measured(frame.width(), frame.height());
    if (shown.empty()) return {};
    return rmsOfShown(shown, exactDepths(demo, frame));
}

// Pixels of the two panes that differ in any channel; of what cannot be compared, nothing.
std::vector<double> differing(Probing& probing) {
    const Demo& demo = probing.demo();
    if (demo.word("show") != "compute" || demo.word("kernel") != "rings") return {};
    if (!fallback(settingsOf<Settings>(demo)).computes) return {};
    const std::vector<Pane> panes{belowHeading(probing.frame(), 0), belowHeading(probing.frame(), 1)};
    const Picture picture = probing.picture();
    long count = 0;
    for (int y = 0; y < panes[0].height; ++y) {
        const int row = picture.height - 1 - y;  // the picture's upper row is 0
        for (int x = 0; x < panes[0].width; ++x) {
            if (panes[1].x + x >= picture.width || panes[0].y + y >= picture.height) return {};
            count +=
                picture.at(panes[0].x + x, row - panes[0].y) != picture.at(panes[1].x + x, row - panes[1].y) ? 1 : 0;
        }
    }
    return {double(count)};
}

Study study() {
    Study study;
    study.quantity = "depth of the patch in each pixel, seen from above, where a cell of the net is 1 wide";
    study.reference =
        "a line of sight a pixel to the patch itself: the first zero of a polynomial of degree 6, in double precision";
    study.reads = {"show", "bend", "spin-x", "spin-y"};
    study.makeReference = [](const Demo& demo, const ReferenceFrame& frame, const auto&) {
        return exactPatch(demo, frame);
    };
    study.width = 480;
    study.height = 280;
    study.wrongBeyond = 0.05;
    const auto seenFromAbove = [](std::vector<KnobSetting> settings) {
        settings.insert(settings.end(), {{"spin-x", "90"}, {"spin-y", "0"}, {"hidden", "off"}});
        return settings;
    };
    study.scenes = {{"sheet", seenFromAbove({{"bend", "0"}})}, {"bent", seenFromAbove({{"bend", "0.3"}})}};
    const std::vector<std::string> levels{"1", "2", "4", "8", "16", "32", "64"};
    study.lines = {{"tessellated", {{"geometry", "off"}}, "inner", levels},
                   {"geometry: pass", {{"geometry", "pass"}}, "inner", levels},
                   {"geometry: wireframe", {{"geometry", "wireframe"}}, "inner", levels},
                   {"edges of level 4", {{"geometry", "off"}, {"own-edges", "on"}, {"outer", "4"}}, "inner", levels},
                   {"net", {{"geometry", "off"}, {"tessellation", "off"}}}};
    const auto plain = rows("tessellated"), pass = rows("geometry: pass"), wires = rows("geometry: wireframe");
    const auto coarse = rows("edges of level 4");
    const auto rasterized = of::count("primitives for the rasterizer");
    study.says = {
        claim(
            "square",
            "From level 8 on the error falls as the square of the level, to a twentieth in the power, and so does the "
            "largest one, to a tenth.",
            {slope(of::rms, plain.from(8), -2.05, -1.95), slope(of::max, plain.from(8), -2.1, -1.9)}),
        claim("too-coarse",
              "Below level 4 it falls more slowly: twice the level leaves a third of it at least, not a quarter.",
              {ratio(of::rms, plain.at(2), plain.at(1), 1.0 / 3, 1),
               ratio(of::rms, plain.at(4), plain.at(2), 1.0 / 3, 1)}),
        claim("triangles", "The number of triangles grows as the square of the level.",
              {slope(rasterized, plain, 1.99, 2.01)}),
        claim("edges",
              "Edges of level 4 hold the largest error: by levels from 8 to 64 inside it moves by less than a sixth, "
              "and at 64 the error is at least 15 times that of edges of level 64.",
              {settled(of::max, coarse.from(8), 7.0 / 6), ratio(of::rms, coarse.at(64), plain.at(64), 15, 100)}),
        claim("net", "The net of the control points, 18 triangles, is farther off than the patch's two of level 1.",
              {ratio(of::rms, rows("net"), plain.at(1), 1, 10), value(rasterized, rows("net"), 18, 18)}),
        claim("equal", "A geometry stage that passes triangles on leaves the error as it is, to a thousandth.",
              {ratio(of::rms, pass, plain, 0.999, 1.001), ratio(of::rms, wires, plain, 0.999, 1.001)}),
        claim("stage-costs", "At level 64 such a stage makes the frame longer by a tenth at least on a processor.",
              {ratio(of::time, pass.at(64), plain.at(64), 1.1, 20),
               ratio(of::time, wires.at(64), plain.at(64), 1.1, 20)}),
        claim("stage-is-nearly-free", "On this GPU it changes the frame's time by an eighth at most.",
              {ratio(of::time, pass.at(64), plain.at(64), 0.875, 1.125),
               ratio(of::time, wires.at(64), plain.at(64), 0.875, 1.125)}),
        note(
            "Seen from above nothing is hidden. A pixel at most 6 pixels from the outline, which a few triangles move, "
            "counts as one at an edge."),
        note("Which diagonal cuts a cell of the tessellator into two triangles is the driver's choice. The error "
             "depends on it."),
        note("The time is that of a whole frame, with the words beside the patch.")};
    return study;
}

const bool studied = addStudy("gpu-stages", study());
const bool probed =
    addProbes("gpu-stages",
              {{{{"depth-error",
                  "root mean square of the triangles' depth against the patch itself; a cell of the net is 1 wide"}},
                depthErrors},
               {{{"differing", "pixels in which the two shaders' pictures differ", "px"}}, differing}});

}  // namespace
}  // namespace mv::gpu_stages

// X09, X10, X17: shadows as the demos draw them, against rays in double through all pixels of the same picture.
#include <cmath>

#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/gl.h"
#include "mv/math/transform.h"
#include "mv/study/study.h"
#include "shared/lit_reference.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

using Settings = std::vector<KnobSetting>;

// The maps' pictures are larger: a texel's step along an edge is to be some pixels there, and not one in four.
struct Size {
    int width, height;
};
constexpr Size ofVolumes{320, 240}, ofMaps{640, 480};

void strike(DemoRun& run, const Settings& settings) {
    for (const KnobSetting& setting : settings) run.set(setting.name, setting.text);
}

// The whole picture, pixel by pixel, against a ray through each pixel's middle and one from there to the light.
struct Judged {
    long wrong = 0, wrongOffEdges = 0;  // off edges: all eight neighbours show the same object, as lit as this pixel
    long pixels = 0, pixelsOffEdges = 0;
};
Judged judged(DemoRun& run, const Size& size) {
    const auto [width, height] = size;
    run.picture();
    const FrameInfo frame(1, width, height);
    const Reference right = litReference(run.demo().scene(frame), frame, {}, {});
    const std::vector<float> drawn = stage().measure(1);
    Judged result;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t here = pixelIndex(x, y, width);
            if (right.regions[here] < 0) continue;
            bool atEdge = x == 0 || y == 0 || x + 1 == width || y + 1 == height;
            for (int i = 0; i < 9 && !atEdge; ++i) {
                const std::size_t there = pixelIndex(x + i % 3 - 1, y + i / 3 - 1, width);
                atEdge = right.regions[here] != right.regions[there] || right.values[here] != right.values[there];
            }
            // Less than 0 is no surface of the scene, which only rounding at its outline may make of one.
            const bool isWrong = drawn[here] < 0 || (drawn[here] > 0.5F) != (right.values[here] > 0.5);
            result.wrong += isWrong ? 1 : 0;
            ++result.pixels;
            if (atEdge) continue;
            result.wrongOffEdges += isWrong ? 1 : 0;
            ++result.pixelsOffEdges;
        }
    }
    if (result.pixelsOffEdges < width * height / 5) throw Error("judged", "a fifth of the picture must be compared");
    return result;
}

// ---- volumes

Row volumes(const std::string& id, const std::string& input, const Settings& both, const std::string& naive,
            const KnobSetting& naiveSetting, const std::string& ours, const KnobSetting& ourSetting) {
    DemoRun run("shadow-volume", ofVolumes.width, ofVolumes.height);
    strike(run, both);
    const auto wrong = [&](const KnobSetting& setting) {
        strike(run, {setting});
        return double(judged(run, ofVolumes).wrongOffEdges);
    };
    const double naiveWrong = wrong(naiveSetting);
    return {.id = id,
            .input = input + ", 320x240 pixels",
            .measured = "pixels with a false shadow, or without their true one, off the band of a pixel at edges",
            .naive = naive,
            .naiveError = naiveWrong,
            .ours = ours,
            .ourError = wrong(ourSetting),
            .tolerance = 0,
            .reason = "volumes have exact edges: only the pixel on one is left to rounding"};
}
[[maybe_unused]] const bool x09a = addRow([] {
    return volumes("X09 eye", "a cube on a floor, the eye in the shadow's volume",
                   {{"scene", "cube"}, {"eye", "in-volume"}}, "z-pass: counts from 0", {"method", "z-pass"},
                   "z-fail, infinitePerspective", {"method", "z-fail"});
});
[[maybe_unused]] const bool x09b = addRow([] {
    return volumes("X09 caster", "a low light behind a cube 5 away, which throws its shadow towards the eye",
                   {{"scene", "cube"}, {"light-turn", "180"}, {"light-height", "0.4"}},
                   "z-fail with far = 5: the volume is cut off", {"far", "5"}, "z-fail, infinitePerspective",
                   {"far", "0"});
});
[[maybe_unused]] const bool x09c = addRow([] {
    return volumes("X09 far", "a cube on a floor, all of it within 10", {{"scene", "cube"}},
                   "z-fail with far = 10: the volume goes on behind it", {"far", "10"}, "z-fail, infinitePerspective",
                   {"far", "0"});
});
[[maybe_unused]] const bool x10a = addRow([] {
    return volumes("X10 256", "256 boxes in one another over a floor, a stencil buffer of 8 bits",
                   {{"scene", "nested"}, {"shells", "256"}, {"show", "shadow"}}, "one count: 256 reads as 0, as lit",
                   {"groups", "off"}, "counts of 127 at most, one after the other", {"groups", "on"});
});

// The count that 300 ways in and then 100 out leave in the stencil buffer of a few pixels.
double countAfter(GLenum in, GLenum out) {
    glEnable(GL_STENCIL_TEST);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glStencilMask(~0U);
    glClearStencil(0);
    glClear(GL_STENCIL_BUFFER_BIT);
    glStencilFunc(GL_ALWAYS, 0, ~0U);
    const Program program("shadow-volume", "volume");
    program.use();
    program.set("clipFromObject", rotateX(90) * scale(2));
    const Mesh all(square());
    for (int i = 0; i < 400; ++i) {
        glStencilOp(GL_KEEP, GL_KEEP, i < 300 ? in : out);
        all.draw();
    }
    unsigned char count = 0;
    glReadPixels(0, 0, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, &count);
    return count;
}
[[maybe_unused]] const bool x10b = addRow([] {
    DemoRun run("shadow-volume", 8, 8);
    run.picture();
    stage().front().bind();
    const double stopped = countAfter(GL_INCR, GL_DECR), wrapped = countAfter(GL_INCR_WRAP, GL_DECR_WRAP);
    return Row{.id = "X10 300",
               .input = "300 fragments on the way in, then 100 on the way out, a stencil buffer of 8 bits",
               .measured = "error of the count, which is 200",
               .naive = "GL_INCR and GL_DECR, which stop at 255",
               .naiveError = std::abs(stopped - 200),
               .ours = "GL_INCR_WRAP and GL_DECR_WRAP",
               .ourError = std::abs(wrapped - 200),
               .tolerance = 0,
               .reason = "whole numbers modulo 256, in any order"};
});

// ---- maps

// The cube on its floor, and parallel light from `elevation` degrees above the floor.
Settings mapUnder(double elevation) {
    const double up = radians(elevation), around = radians(26);
    const vec3 towards(-std::cos(up) * std::cos(around), std::sin(up), std::cos(up) * std::sin(around));
    const vec3 middle(0, 0.5, 0), light = middle + 6.0 * towards, target = middle - 0.4 * towards;
    const auto text = [](double x) { return numberText(std::round(1e6 * x) / 1e6); };  // cos(90°) is not quite 0
    return {{"scene", "cube-on-plane"},   {"projection", "orthographic"}, {"window-width", "8"},
            {"window-height", "8"},       {"resolution", "1024"},         {"light-x", text(light.x)},
            {"light-y", text(light.y)},   {"light-z", text(light.z)},     {"target-x", text(target.x)},
            {"target-y", text(target.y)}, {"target-z", text(target.z)},   {"bias", "0"},
            {"slope-bias", "0"}};
}

double wrongUnder(double elevation, const Settings& settings) {
    DemoRun run("shadow-map", ofMaps.width, ofMaps.height);
    strike(run, mapUnder(elevation));
    strike(run, settings);
    const Judged result = judged(run, ofMaps);
    return 100.0 * double(result.wrong) / double(result.pixels);
}

// The error by the steps of the texels at this angle, by a map in which nothing else can be wrong: back faces alone, without
// the floor and without a bias.
const Settings stepsAlone{{"map-faces", "back"}, {"receiver", "off"}};

Row map(const std::string& id, double elevation, const std::string& naive, const Settings& naiveSettings,
        const std::string& ours, const Settings& ourSettings, const Settings& floorSettings = stepsAlone) {
    return {.id = id,
            .input = "a map of 1024 texels for 8 m of floor, light at " + numberText(elevation) + "°, 640x480 pixels",
            .measured = "pixels that are falsely dark or falsely lit (%)",
            .naive = naive,
            .naiveError = wrongUnder(elevation, naiveSettings),
            .ours = ours,
            .ourError = wrongUnder(elevation, ourSettings),
            .tolerance = 1.5 * wrongUnder(elevation, floorSettings),
            .reason =
                "1.5 times what the steps of the texels cost at this angle, by the other of two maps: back faces "
                "without the floor, and slope-scaled"};
}
const Settings slope{{"slope-bias", "2"}};
[[maybe_unused]] const bool x17a = addRow([] {
    return map("X17 5°", 5, "a constant bias of 3e-3, which is enough at 15°", {{"bias", "0.003"}}, "slope-scaled, 2",
               slope);
});
[[maybe_unused]] const bool x17b = addRow([] {
    return map("X17 15°", 15, "a constant bias of 3e-4, which is enough at 90°", {{"bias", "0.0003"}},
               "slope-scaled, 2", slope);
});
[[maybe_unused]] const bool x17c = addRow([] {
    return map("X17 30°", 30, "a constant bias of 3e-4", {{"bias", "0.0003"}}, "slope-scaled, 2", slope);
});
[[maybe_unused]] const bool x17d =
    addRow([] { return map("X17 60°", 60, "no bias: acne", {}, "slope-scaled, 2", slope); });
// From straight above no edge of the shadow shows, so there are no steps; slope-scaling still errs at the cube's foot.
[[maybe_unused]] const bool x17e = addRow([] {
    return map("X17 90°", 90, "no bias: acne", {}, "back faces, without the floor and without a bias", stepsAlone,
               slope);
});
[[maybe_unused]] const bool x17f = addRow([] {
    return map("X17 3e-2", 30, "back faces in the map, with a bias of 3e-2: light at the cube's foot",
               {{"map-faces", "back"}, {"bias", "0.03"}}, "back faces, without the floor and without a bias",
               stepsAlone, slope);
});

}  // namespace

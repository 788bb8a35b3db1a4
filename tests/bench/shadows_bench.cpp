// Frames of shadow-map with one setting changed, both finished.
#include <string>
#include <vector>

#include "bench/benches.h"
#include "mv/gl/gl.h"
#include "mv/run/render.h"

namespace mv::bench {
namespace {

struct Comparison {
    std::string name;
    std::vector<KnobSetting> a, b;
    double bound;
    int width = 640, height = 480;
};

Row mapRow(const Comparison& comparison, int rounds) {
    HeadlessStage headless;
    Stage& stage = headless.stage;
    stage.open(findDemo("shadow-map"), comparison.width, comparison.height);
    applyKnobs(stage.demo(), {{"scene", "cube-on-plane"},
                              {"light-x", "-2.2"},
                              {"light-y", "3.6"},
                              {"light-z", "1.4"},
                              {"target-x", "0"},
                              {"target-z", "0"},
                              {"fov", "60"},
                              {"resolution", "2048"},
                              {"show-map", "off"},
                              {"show-frustum", "off"}});
    const auto frames = [&](const std::vector<KnobSetting>& settings) {
        applyKnobs(stage.demo(), settings);
        constexpr int repeats = 4;
        for (int i = 0; i < repeats; ++i) {
            stage.draw(1);
            glFinish();
        }
    };
    Row row{"shadow map, " + comparison.name, {}, comparison.bound};
    row.ratio = interleaved([&] { frames(comparison.a); }, [&] { frames(comparison.b); }, rounds);
    return row;
}

}  // namespace

std::vector<Row> shadowsBench(int rounds) {
    // Both settings draw the same picture; one of them leaves out work, so it must not take longer: bound 1. How much less
    // it takes depends on what share of the frame the map is. That grows with the map's texels and falls with the picture's
    // pixels, so bounds below 1 are for maps of 2048 and 4096 texels a side, and for a picture a sixteenth as large.
    const std::vector<KnobSetting> kept{{"resolution", "1024"}, {"keep", "on"}},
        drawn{{"resolution", "1024"}, {"keep", "off"}, {"receiver", "on"}},
        leftOut{{"resolution", "1024"}, {"keep", "off"}, {"receiver", "off"}};
    const std::vector<Comparison> comparisons{
        {"1024, kept / drawn again", kept, drawn, 1},
        {"1024, receiver left out / in it", leftOut, drawn, 1},
        {"1024, 160x120, kept / drawn again", kept, drawn, 0.8, 160, 120},
        {"1024, 160x120, receiver left out / in it", leftOut, drawn, 0.85, 160, 120},
        {"2048, kept / drawn again", {{"keep", "on"}}, {{"keep", "off"}}, 0.8},
        {"4096, receiver left out / in it",
         {{"resolution", "4096"}, {"keep", "off"}, {"receiver", "off"}},
         {{"resolution", "4096"}, {"keep", "off"}, {"receiver", "on"}},
         0.85},
        {"2048, 3 x 3 looks / one", {{"filter", "pcf3"}}, {{"filter", "none"}}, 3},
    };
    std::vector<Row> rows;
    for (const Comparison& comparison : comparisons) rows.push_back(mapRow(comparison, rounds));
    return rows;
}

}  // namespace mv::bench

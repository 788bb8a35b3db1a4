// Pictures of extreme shapes, and the frame after a whole day.
#include <algorithm>
#include <cstdio>

#include "mv/image/compare.h"
#include "visits/visit.h"

namespace mv::test {
namespace {

// A single pixel, a column and a row of them, odd sizes, and other shapes than the original's.
TEST_P(Visits, sizes) {
    DemoRun run(GetParam(), 1, 1);
    const int by = coarserIfSanitized(stage().info());
    for (const auto& [width, height] : {std::pair{1, 1}, {37, 91}, {640 / by, 200 / by}, {1, 4096}, {16384, 16}}) {
        if (sanitized && width * height > 640 * 200) continue;
        stage().resize(width, height);
        const Picture picture = visit().value_or(Picture());
        EXPECT_EQ(picture.width, width);
        EXPECT_EQ(picture.height, height);
    }
}

// In a picture of twice its sides a preset shows the same: a figure's lines and words have grown with it, and what lies over a scene lies
// where it lay. Of both the means of squares of 8 x 8 pixels, of the smaller one, are compared, in which edges are alike: what is
// computed of pixels, and lines that are a pixel wide in both, differ by less; a figure that is left out, in another place or half as
// large, by more. 7 levels are a choice between what was seen of the two, 5.6 and 9. The first preset; in ./test --long each.
TEST_P(Visits, twice_as_large) {
    // How many pixels lie between texels is what those two show.
    if (sanitized || GetParam() == "texture-filter" || GetParam() == "texture-map") return;
    DemoRun run(GetParam());
    const DemoInfo& info = stage().info();
    // What the processor computes in passes takes seconds: of half the sides, in which words of ray-trace's other presets would have their
    // least height.
    const int by = hasPasses(info) && !isLong() ? 2 : 1;
    const auto meansIn = [&](int times) {
        stage().resize(info.width / by * times, info.height / by * times);
        return shrink(run.picture(20), info.width / by / 8, info.height / by / 8);
    };
    double most = 0;
    for (const Preset& preset : info.presets) {
        run.preset(preset.name);
        const double apart = compare(meansIn(1), meansIn(2)).rmse;
        EXPECT_LE(apart, 7) << preset.name;
        most = std::max(most, apart);
        if (!isLong()) break;
    }
    std::printf("%s: %.2f levels\n", GetParam().c_str(), most);
}

// Frame 5 184 000 is the one after 24 hours at 60 a second. A demo is a pure function of the frame's number: the picture
// is the same whatever was drawn before, and the first frame is again what it was. A demo that has to compute each frame
// from the one before, in milliseconds, is given fewer by affordable(), as a knob "frame".
TEST_P(Visits, a_day_of_frames) {
    if (sanitized) return;
    DemoRun run(GetParam(), 64, 48);
    const int day = std::stoi(affordable("frame", "5184000"));
    const auto first = drawnOnce(1, true), later = drawnOnce(day, true);
    visit(day - 1);
    EXPECT_EQ(drawnOnce(day, true), later) << "another picture after the frame before";
    EXPECT_EQ(drawnOnce(1, true), first) << "another first picture after a day";
    if (stage().info().animated) {
        EXPECT_NE(drawnOnce(day + 17, true), later) << "it no longer moves";
    } else {
        EXPECT_EQ(later, first);
    }
}

}  // namespace
}  // namespace mv::test

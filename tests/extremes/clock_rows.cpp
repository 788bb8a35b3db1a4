// X32: time after a day.
#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/demo/frame.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr int framesADay = 24 * 3600 * 60;

[[maybe_unused]] const bool x32 = addRow([] {
    float clock = 0;
    for (int i = 0; i < framesADay; ++i) clock += 1.0f / 60;
    const double ours = FrameInfo(framesADay, 640, 480).time();
    return Row{.id = "X32",
               .input = "24 hours at 60 frames a second",
               .measured = "seconds that the clock is off",
               .naive = "t += 1/60 in float",
               .naiveError = std::abs(static_cast<double>(clock) - 86400),
               .ours = "frame.time(): index/60 in double",
               .ourError = std::abs(ours - 86400),
               .tolerance = 8.64e-5,
               .reason = "1e-9 of the time: a frame is 1.7e-2"};
});

[[maybe_unused]] const bool x32steps = addRow([] {
    float clock = 0;
    double naive = 0, ours = 0;
    for (int i = 1; i <= framesADay; ++i) {
        const float before = clock;
        clock += 1.0f / 60;
        naive = std::max(naive, std::abs(static_cast<double>(clock - before) * 60 - 1));
        ours = std::max(ours, std::abs((FrameInfo(i, 1, 1).time() - FrameInfo(i - 1, 1, 1).time()) * 60 - 1));
    }
    return Row{.id = "X32 steps",
               .input = "each step of those 24 hours",
               .measured = "how far the longest or shortest is from 1/60 s, as a part of it",
               .naive = "t += 1/60 in float",
               .naiveError = naive,
               .ours = "frame.time()",
               .ourError = ours,
               .tolerance = 1e-8,
               .reason = "a rounding of 86400 s is 7e-12 s, twice in a difference of 1.7e-2 s"};
});

}  // namespace

#include "clip_steps.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>

#include "mv/formatted.h"

namespace mv {

using namespace clip;

namespace {

std::string wordsOf(const CodeRound& round) {
    if (round.does == CodeRound::Does::accept) return "OR is 0000: keep";
    if (round.does == CodeRound::Does::reject) return "AND is not 0000: reject";
    const char* side = round.side == above     ? "top"
                       : round.side == below   ? "bottom"
                       : round.side == rightOf ? "right"
                                               : "left";
    return std::string("cut ") + (round.cutsA ? "a" : "b") + " at the " + side;
}

}  // namespace

void showRounds(ClipFigure& figure, const std::vector<CodeRound>& rounds, int round, double offset) {
    figure.say("code: above top, below bottom, right, left");
    figure.say("");
    const int count = static_cast<int>(rounds.size()), made = std::min(round, count);
    for (int i = 0; i < count; ++i) {
        const CodeRound& one = rounds[static_cast<std::size_t>(i)];
        figure.say(
            std::to_string(i + 1) + ":  " + codeText(one.codeA) + "  " + codeText(one.codeB) + "  " + wordsOf(one),
            i >= made       ? vec4(0.8, 0.8, 0.8, 1)
            : i + 1 == made ? blue
                            : ink);
        if (i >= made || one.does != CodeRound::Does::cut) continue;
        const Segment& after = rounds[static_cast<std::size_t>(i) + 1].segment;
        const vec2 cut = (one.cutsA ? after.a : after.b) - offset;
        figure.stroke((one.cutsA ? one.segment.a : one.segment.b) - offset, cut, {red, 3});
        figure.point(cut, 7, red);
    }
    const CodeRound& now = rounds[static_cast<std::size_t>(std::min(made, count - 1))];
    const bool rejected = made == count && now.does == CodeRound::Does::reject;
    figure.stroke(now.segment.a - offset, now.segment.b - offset, {rejected ? red : blue, 4});
    figure.say("");
    figure.say(made < count ? "blue: what is left so far"
               : rejected   ? "rejected"
                            : "kept: what is blue",
               rejected ? red : blue);
}

// The parameters t at which the segment's line crosses the lines of the four sides.
void showParameters(ClipFigure& figure, const Segment& whole, const Box& box, double offset, bool withDistances) {
    figure.say("a + t (b - a), t from 0 to 1");
    static const std::array<const char*, 4> names{"left", "right", "bottom", "top"};
    const auto planes = halfPlanes(box);
    double from = 0, until = 1;
    for (std::size_t i = 0; i < 4; ++i) {
        const double atA = planes.at(i).of(whole.a), atB = planes.at(i).of(whole.b), t = atA / (atA - atB);
        if (atA == atB) {
            figure.say(std::string(names.at(i)) + ": parallel, " + (atA < 0 ? "outside" : "inside"));
            continue;
        }
        const bool enters = atA < atB;
        (enters ? from : until) = enters ? std::max(from, t) : std::min(until, t);
        const std::string how = withDistances ? formatted(" (%.2f", atA) + formatted(" to %.2f)", atB) : "";
        figure.say(names.at(i) + formatted(enters ? ": enters at %.3f" : ": leaves at %.3f", t) + how,
                   enters ? green : red);
        const vec2 at = (whole.a + t * (whole.b - whole.a)) - offset;
        if (plane.holds(at)) figure.point(at, 8, enters ? green : red);
    }
    figure.say("");
    figure.say(formatted("last entry, or 0:  %.3f", from), green);
    figure.say(formatted("first exit, or 1:  %.3f", until), red);
}

// The side of the segment's line on which each corner lies.
void showCorners(ClipFigure& figure, const Segment& whole, const Box& box, double offset) {
    figure.say("the corners' sides of the line a b, exactly:");
    for (const vec2& corner : {box.low, vec2(box.high.x, box.low.y), box.high, vec2(box.low.x, box.high.y)}) {
        const int side = orientation(whole.a, whole.b, corner);
        const vec4& color = side > 0 ? green : side < 0 ? red : ink;
        const vec2 at = (corner)-offset;
        figure.point(at, 11, color);
        figure.say(formatted("(%.2f, ", at.x) + formatted("%.2f)", at.y) +
                       (side > 0   ? " left"
                        : side < 0 ? " right"
                                   : " on it"),
                   color);
    }
    figure.say("all on one side: it misses the window");
}

}  // namespace mv

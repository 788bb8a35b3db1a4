// A segment is clipped to a window by one of four methods, and each shows how it comes to its answer.
#include <cmath>

#include "clip_steps.h"
#include "clipping.h"
#include "mv/formatted.h"
#include "mv/gl/text.h"

namespace mv::clipping {

using namespace clip;

std::optional<Segment> clipped(Method method, const Segment& whole, const Box& window) {
    if (method == Method::liangBarsky) return liangBarsky(whole, window);
    if (method == Method::cyrusBeck) return cyrusBeck(whole, halfPlanes(window));
    if (method == Method::exact) return clipSegment(whole, window);
    const CodeRound last = cohenSutherland(whole, window).back();
    if (last.does == CodeRound::Does::reject) return {};
    return last.segment;
}

// Draw the part that is kept, all at once: these methods have no rounds.
static void showPart(ClipFigure& figure, const InPlane& s, const Segment& whole, const Box& window) {
    const double offset = s.offset;
    if (s.method == Method::exact)
        showCorners(figure, whole, window, offset);
    else
        showParameters(figure, whole, window, offset, s.method == Method::cyrusBeck);
    const auto part = clipped(s.method, whole, window);
    figure.say(part ? "kept: what is blue" : "rejected", part ? blue : red);
    if (part) figure.stroke(part->a - offset, part->b - offset, {blue, 4});
}

void drawSegment(ClipFigure& figure, const Settings& s, const Frame&) {
    const auto& [a, b] = s.plane.ends;
    const double offset = s.plane.offset;
    const Segment whole{a + offset, b + offset};
    const Box window = farWindowOf(s.plane);
    figure.window(windowOf(s.plane));
    figure.stroke(a, b, {grey, 1.5});
    if (offset > 0) figure.say(formatted("all coordinates 1e%.0f larger", std::log10(offset)), grey);
    if (s.plane.method == Method::cohenSutherland) {
        figure.codes(windowOf(s.plane));
        showRounds(figure, cohenSutherland(whole, window), s.round, offset);
    } else {
        showPart(figure, s.plane, whole, window);
    }
    for (const vec2& end : {a, b}) figure.point(end, 9, ink);
    figure.name(a, "a");
    figure.name(b, "b");
}

}  // namespace mv::clipping

// A segment in space is clipped before the projection, before the division or after it: seen from above, with its picture.
#include <algorithm>
#include <glm/geometric.hpp>
#include <span>
#include <string>

#include "clipping.h"
#include "mv/formatted.h"
#include "mv/gl/text.h"
#include "mv/math/clip.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

namespace mv::clipping {

using namespace clip;

static mat4 clipFromView() { return perspective(70, 1, 0.25, 2.75); }

static std::vector<vec4> segmentOf(const InSpace& s) {
    return {vec4(s.ends[0].x, -0.35, s.ends[0].y, 1), vec4(s.ends[1].x, 0.3, s.ends[1].y, 1)};
}

// The six planes of the view volume in view space: the plane h of clip space is h M there.
static std::vector<vec4> viewVolume() {
    std::vector<vec4> planes(clipVolume().begin(), clipVolume().end());
    for (vec4& plane : planes) plane = plane * clipFromView();
    return planes;
}

// The ends of the visible part, in the picture.
static std::vector<vec2> seenPart(std::vector<vec4> ends, Where where) {
    if (where == Where::view) ends = clipPolygon(ends, viewVolume());
    for (vec4& end : ends) end = clipFromView() * end;
    if (where == Where::divided) {
        for (vec4& end : ends) {
            if (end.w == 0) return {};  // an end at infinity cannot be clipped
            end /= end.w;
        }
    }
    const std::span bounds(clipVolume());
    if (where == Where::clip) ends = clipPolygon(ends, bounds);
    if (where == Where::divided) ends = clipPolygon(ends, bounds.first(4));  // the square's four sides
    std::vector<vec2> seen;
    seen.reserve(ends.size());
    for (const vec4& end : ends) seen.push_back(vec2(end) / end.w);
    return seen;
}

static std::vector<vec2> rightPart(const InSpace& s) { return seenPart(segmentOf(s), Where::clip); }
static std::vector<vec2> shownPart(const InSpace& s) { return seenPart(segmentOf(s), s.where); }

double missInSpace(const InSpace& s) {
    const auto right = rightPart(s), shown = shownPart(s);
    if (right.size() != shown.size()) return 2;
    double most = 0;
    for (std::size_t i = 0; i < right.size(); ++i) most = std::max(most, glm::distance(right[i], shown[i]));
    return most;
}

// Draw the view volume from above, the eye at the origin looking down along -z, and the segment in it.
static void drawFromAbove(ClipFigure& figure, const InSpace& s) {
    const vec2 nearEdge = 0.25 * vec2(std::tan(radians(35)), -1), farEdge = 11.0 * nearEdge;
    figure.outline({nearEdge, farEdge, {-farEdge.x, farEdge.y}, {-nearEdge.x, nearEdge.y}}, {ink, 1.5});
    figure.stroke({plane.low.x, 0}, {plane.high.x, 0}, {grey, 1});
    figure.name({plane.low.x, 0}, "w = 0: the eye's plane", grey);
    figure.point({0, 0}, 10, ink);
    figure.name({0, 0}, "eye");
    figure.stroke(s.ends[0], s.ends[1], {grey, 2.5});
    const auto inside = clipPolygon(segmentOf(s), viewVolume());
    if (inside.size() == 2) figure.stroke({inside[0].x, inside[0].z}, {inside[1].x, inside[1].z}, {blue, 4});
    for (std::size_t i = 0; i < 2; ++i) {
        figure.point(s.ends.at(i), 9, ink);
        figure.name(s.ends.at(i), (i == 0 ? "a: w = " : "b: w = ") + formatted("%.2f", -s.ends.at(i).y));
    }
}

// Draw the picture that the eye sees: the shown part of the segment and, where it is wrong, the right part.
static void drawPicture(ClipFigure& figure, const InSpace& s, const Frame& frame, bool isRight) {
    const Pane left = ClipFigure::leftPane(frame);
    const double side = frame.isUpright() ? std::min(0.45 * frame.width(), 0.7 * left.y)
                                          : std::min((frame.width() - left.width) * 0.85, frame.height() * 0.62);
    const vec2 low =
        frame.isUpright() ? vec2(frame.width() - side - 12, 12) : vec2(left.width + 4, frame.height() * 0.2);
    const Plot picture{{low, low + side}, {-1, 1}, {-1, 1}};
    figure.drawing.in({0, 0, frame.width(), frame.height()});
    figure.drawing.fill(picture.box, pale);
    figure.drawing.curve(picture, std::vector<vec2>{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {-1, -1}}, {ink, 1.5});
    if (!isRight) figure.drawing.curve(picture, rightPart(s), {vec4(0.6, 0.72, 0.9, 1), 6});
    figure.drawing.curve(picture, shownPart(s), {isRight ? blue : red, 3});
}

void drawSpace(ClipFigure& figure, const Settings& s, const Frame& frame) {
    drawFromAbove(figure, s.space);
    frame.show("clipFromView", clipFromView());
    const bool isRight = missInSpace(s.space) < 1e-9;
    constexpr std::array words{"clipped before the projection", "clipped before the division",
                               "clipped after the division"};
    figure.say(words.at(std::size_t(s.space.where)));
    figure.say(isRight ? "blue: what is seen" : "red: what is not seen; pale: what is", isRight ? blue : red);
    drawPicture(figure, s.space, frame, isRight);
}

}  // namespace mv::clipping

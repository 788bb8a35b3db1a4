// A polygon is clipped against another one: cut at one edge of it after the other, or joined from parts of both outlines.
#include <algorithm>
#include <cmath>
#include <string>

#include "clipping.h"
#include "mv/formatted.h"
#include "mv/gl/text.h"
#include "mv/math/clip.h"

namespace mv::clipping {

using namespace clip;

GridPolygon onGrid(const std::vector<vec2>& corners) {
    GridPolygon whole;
    for (const vec2& p : corners) whole.push_back({std::lround(p.x / gridStep), std::lround(p.y / gridStep)});
    return whole;
}

// Sutherland and Hodgman's method, as the library has it for space: what is left after so many edges of the window.
static std::vector<vec2> cutAt(const Polygons& s, std::size_t edges) {
    std::vector<vec4> corners, halfSpaces;
    for (const vec2& corner : s.polygon) corners.emplace_back(corner, 0, 1);
    for (const HalfPlane& half : halfPlanes(s.against)) halfSpaces.emplace_back(half.normal, 0, half.distance);
    halfSpaces.resize(std::min(halfSpaces.size(), edges));
    std::vector<vec2> left;
    for (const vec4& corner : clipPolygon(corners, halfSpaces)) left.emplace_back(corner);
    return left;
}
static std::size_t edgesShown(const Settings& s) { return std::min(std::size_t(s.round), s.polygons.against.size()); }

// A slide's proposal: each side of the polygon, clipped as a segment. The window's corners are in none of them.
static Pieces clippedSides(const Polygons& s) {
    const std::vector<HalfPlane> inside = halfPlanes(s.against);
    Pieces sides;
    for (std::size_t i = 0; i < s.polygon.size(); ++i) {
        const auto part = cyrusBeck({s.polygon[i], s.polygon[(i + 1) % s.polygon.size()]}, inside);
        if (part) sides.push_back({part->a, part->b});
    }
    return sides;
}

static Overlap overlapOf(const Polygons& s) { return overlap(onGrid(s.polygon), onGrid(s.against)); }

Pieces piecesOf(const Settings& s) {
    if (s.polygons.method == PolygonMethod::sutherlandHodgman) return {cutAt(s.polygons, edgesShown(s))};
    if (s.polygons.method == PolygonMethod::sides) return clippedSides(s.polygons);
    Pieces pieces = overlapOf(s.polygons).polygons;
    for (std::vector<vec2>& piece : pieces) {
        for (vec2& corner : piece) corner *= gridStep;
    }
    return pieces;
}

double areaOf(const Pieces& pieces) {
    double sum = 0;
    for (const auto& piece : pieces) sum += mv::areaOf(piece);
    return sum;
}

static void showCuts(ClipFigure& figure, const Settings& s) {
    const std::size_t edges = edgesShown(s);
    for (std::size_t i = 0; i <= edges; ++i)
        figure.say("after " + std::to_string(i) + " edges: " + std::to_string(cutAt(s.polygons, i).size()) + " corners",
                   i == edges ? blue : ink);
    if (edges > 0) {
        const std::vector<vec2>& against = s.polygons.against;
        const vec2 a = against[edges - 1], along = against[edges % against.size()] - a;
        figure.stroke(a - 9.0 * along, a + 9.0 * along, {green, 1.5});
    }
    figure.say("one polygon, whatever its pieces");
}

static void showParts(ClipFigure& figure, const Settings& s) {
    const Overlap common = overlapOf(s.polygons);
    const auto count = [&](auto holds) { return std::to_string(std::ranges::count_if(common.parts, holds)); };
    figure.say(std::to_string(common.parts.size()) + " parts of outlines, " +
               count([](const EdgePart& part) { return part.lies >= EdgePart::Lies::alongSame; }) +
               " of them along the other");
    figure.say(count([](const EdgePart& part) { return part.kept; }) + " lie inside the other, or with it");
    const std::size_t pieces = common.polygons.size();
    figure.say("joined: " + std::to_string(pieces) + (pieces == 1 ? " polygon" : " polygons"), blue);
}

static void showSides(ClipFigure& figure, const Settings& s) {
    figure.say(std::to_string(clippedSides(s.polygons).size()) + " sides of " +
               std::to_string(s.polygons.polygon.size()) + " have a part inside");
    figure.say("they do not close: the window's", red);
    figure.say("outline between them is missing", red);
}

void drawPolygon(ClipFigure& figure, const Settings& s, const Frame&) {
    constexpr std::array show{showCuts, showParts, showSides};
    show.at(std::size_t(s.polygons.method))(figure, s);
    const Pieces pieces = piecesOf(s);
    for (const auto& piece : pieces) figure.hatch(piece, vec4(0.45, 0.62, 0.88, 1));
    figure.outline(s.polygons.against, {ink, 2});
    figure.outline(s.polygons.polygon, {red, 1.5});
    for (const auto& piece : pieces) {
        figure.outline(piece, {blue, 4});
        for (const vec2& corner : piece) figure.point(corner, 7, blue);
    }
    figure.say(formatted("area %.4f", areaOf(pieces)), blue);
}

}  // namespace mv::clipping

#include "chromaticity_diagram.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "mv/formatted.h"
#include "mv/gl/word_size.h"
#include "mv/math/clip.h"
#include "mv/math/color.h"
#include "mv/math/transform.h"

namespace mv {
namespace {

// The area of a flat polygon, its corners in the order of clipPolygon().
double area(const std::vector<vec4>& corners) {
    std::vector<vec3> flat;
    flat.reserve(corners.size());
    for (const vec4& corner : corners) flat.emplace_back(vec3(corner) / corner.w);
    return polygonArea(flat);
}

template <typename List>
std::vector<vec4> placesOf(const ChromaticityDiagram& diagram, const List& list) {
    std::vector<vec4> places;
    places.reserve(list.size());
    for (const vec2& xy : list) places.emplace_back(diagram.place(xy), 0, 1);
    return places;
}

}  // namespace

vec2 ChromaticityDiagram::place(const vec2& xy) const { return which == Diagram::uv ? uvFromXy(xy) : xy; }

mat4 ChromaticityDiagram::placeFromXy() const {
    if (which == Diagram::xy) return mat4(1);
    return {4, 0, 0, -2, 0, 9, 0, 12, 0, 0, 1, 0, 0, 0, 0, 3};
}

std::optional<vec2> ChromaticityDiagram::placeOf(const vec3& srgb) const {
    const vec3 xyz = xyzFromLinear() * linearFromSrgb(srgb);
    if (!(xyz.x + xyz.y + xyz.z > 0)) return std::nullopt;
    return place(chromaticity(xyz));
}

double ChromaticityDiagram::heldBySrgb() const {
    return 100 * area(placesOf(*this, srgbPrimaries)) / area(placesOf(*this, spectralLocus()));
}

double ChromaticityDiagram::beyondSide(const vec2& from, const vec2& to) const {
    const vec2 first = place(from), along = place(to) - first;
    const vec3 right(along.y, -along.x, glm::dot(first, vec2(-along.y, along.x)));
    // The third primary is on the other side
    const vec2 inside = place(srgbWhite);
    const double sign = glm::dot(right, vec3(inside, 1)) > 0 ? -1 : 1;
    const std::array<vec4, 1> side{sign * vec4(right.x, right.y, 0, right.z)};
    const std::vector<vec4> spectrum = placesOf(*this, spectralLocus());
    return 100 * area(clipPolygon(spectrum, side)) / area(spectrum);
}

Plot ChromaticityDiagram::plotIn(const FrameInfo& frame) const {
    const bool isXy = which == Diagram::xy;
    const vec2 low(-0.08, 0), high = isXy ? vec2(0.8, 0.9) : vec2(0.7, 0.65), range = high - low;
    const double each =
        std::max(1.0, std::min((frame.width() - 100) / range.x, (frame.height() - 90) / range.y));  // pixels
    const vec2 corner((frame.width() - each * range.x) / 2, 54);
    return {{corner, corner + each * range}, {low.x, high.x, isXy ? "x" : "u'"}, {low.y, high.y, isXy ? "y" : "v'"}};
}

mat4 ChromaticityDiagram::clipFromPlace(const Plot& plot, const FrameInfo& frame) {
    const vec2 size(frame.width(), frame.height());
    const vec2 zero = plot.pixel(vec2(0)) / size, one = plot.pixel(vec2(1)) / size;
    return translate(-1, -1, 0) * scale(2, 2, 1) * translate(zero.x, zero.y, 0) *
           scale(one.x - zero.x, one.y - zero.y, 1);
}

void ChromaticityDiagram::draw(Drawing& drawing, const FrameInfo& frame) const {
    const vec4 ink(0.1, 0.1, 0.1, 1), faint(0.35, 0.35, 0.35, 1);
    const Plot plot = plotIn(frame);
    std::vector<vec2> outline, triangle;
    for (const vec2& xy : spectralLocus()) outline.push_back(place(xy));
    outline.push_back(outline.front());
    for (const vec2& primary : srgbPrimaries) triangle.push_back(place(primary));
    triangle.push_back(triangle.front());
    drawing.axes(plot);
    drawing.curve(plot, outline, {ink, 2});
    drawing.curve(plot, triangle, {ink, 1.5});
    drawing.point(plot.pixel(place(srgbWhite)), 5, ink);

    const double unit = std::min(frame.width() / 960.0, frame.height() / 640.0);
    const int pixels = std::max(leastWords, static_cast<int>(14 * unit));
    const auto note = [&](const vec2& at, const vec2& moved, const std::string& text, const vec4& color) {
        drawing.textAround(plot.pixel(at) + moved * unit, text, {pixels, color, vec4(0)});
    };
    const vec2 middle = place(vec2(1 / 3.0));
    for (const int nanometres : {450, 480, 490, 500, 510, 520, 540, 560, 580, 600, 620, 700}) {
        const vec2 at = outline.at(static_cast<std::size_t>(nanometres - 380) / 5);
        note(at, 24.0 * glm::normalize(at - middle), std::to_string(nanometres), faint);
    }
    note(place(srgbWhite), {0, -14}, "white", ink);
    const vec2 aside = which == Diagram::xy ? vec2(0.62, 0.81) : vec2(0.56, 0.13);
    note(aside, {0, 20}, formatted("sRGB holds %.1f %%", heldBySrgb()), ink);
    note(aside, {0, 0}, "of the area in this diagram", ink);
    note(aside, {0, -20}, "grey: seen, and not in sRGB", faint);
}

}  // namespace mv

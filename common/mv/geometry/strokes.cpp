#include "mv/geometry/strokes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "mv/error.h"
#include "mv/math/clip.h"
#include "mv/math/require.h"
#include "mv/math/robust.h"
#include "mv/math/transform.h"

namespace mv {
namespace {

// A cut across a line: where its middle is, which way its left side lies (as long as the mitre makes it), and how much
// of the colour there is.
struct Section {
    vec3 middle;
    vec2 left;
    double part;
};

vec2 turnedLeft(const vec2& direction) { return {-direction.y, direction.x}; }

vec4 faded(const vec4& color, double part) { return {color.r, color.g, color.b, color.a * part}; }

void addQuad(Painted& painted, const std::array<PaintedVertex, 4>& corners) {
    for (const std::size_t i : {0U, 1U, 2U, 0U, 2U, 3U}) painted.push_back(corners[i]);
}

// The strip between two sections: the core in full colour, and a rim on each side that fades.
void addStrip(Painted& painted, const Section& from, const Section& to, double width, const vec4& color) {
    const double core = std::max(0.0, width - 1) / 2, rim = (std::max(1.0, width) + 1) / 2;
    const std::array<double, 4> offsets{-rim, -core, core, rim}, parts{0, 1, 1, 0};
    const auto vertex = [&](const Section& section, std::size_t i) {
        return PaintedVertex{section.middle + vec3(offsets[i] * section.left, 0),
                             faded(color, parts[i] * section.part * std::min(1.0, width))};
    };
    for (const std::size_t i : {0U, 1U, 2U}) {
        if (offsets[i] == offsets[i + 1]) continue;
        addQuad(painted, {vertex(from, i), vertex(to, i), vertex(to, i + 1), vertex(from, i + 1)});
    }
}

// The sections of an end, which fades from half a pixel within to half a pixel beyond; `outwards` is of unit length.
std::array<Section, 2> endOf(const vec3& point, const vec2& outwards, const vec2& left, double length) {
    return {Section{point - vec3(std::min(0.5, length / 2) * outwards, 0), left, 1},
            Section{point + vec3(0.5 * outwards, 0), left, 0}};
}

}  // namespace

void strokeLine(Painted& painted, std::span<const vec3> points, double width, const vec4& color) {
    if (!(width > 0)) throw Error("strokeLine", "the width must be above 0 px", numberText(width));
    requireFinite("strokeLine", "the width", width);
    std::vector<vec3> places;
    for (const vec3& point : points) {
        requireFinite("strokeLine", "each point", point);
        if (places.empty() || vec2(places.back()) != vec2(point)) places.push_back(point);
    }
    std::vector<Section> sections;  // of the piece that is being drawn
    const auto finish = [&] {
        for (std::size_t i = 1; i < sections.size(); ++i) addStrip(painted, sections[i - 1], sections[i], width, color);
        sections.clear();
    };
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        const vec2 step = vec2(places[i + 1]) - vec2(places[i]);
        const double length = glm::length(step);
        const vec2 along = step / length, left = turnedLeft(along);
        if (sections.empty()) {
            const auto [within, beyond] = endOf(places[i], -along, left, length);
            sections = {beyond, within};
        }
        const bool last = i + 2 == places.size();
        const vec2 next = last ? along : glm::normalize(vec2(places[i + 2]) - vec2(places[i + 1]));
        const double cosine = glm::dot(along, next);
        if (!last && cosine >= 0) {  // mitred: as far out as keeps both sides where they are
            sections.push_back({places[i + 1], (left + turnedLeft(next)) / (1 + cosine), 1});
            continue;
        }
        const auto [within, beyond] = endOf(places[i + 1], along, left, length);
        sections.insert(sections.end(), {within, beyond});
        finish();
        if (!last && width > 2) fillConvex(painted, circle(vec2(places[i + 1]), width / 2), places[i + 1].z, color);
    }
}

void fillConvex(Painted& painted, std::span<const vec2> corners, double depth, const vec4& color) {
    std::vector<vec2> ring;
    for (const vec2& corner : corners) {
        requireFinite("fillConvex", "each corner", vec3(corner, depth));
        if (ring.empty() || ring.back() != corner) ring.push_back(corner);
    }
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    const std::size_t count = ring.size();
    // Computed from differences: far from the origin, products of coordinates would round a thin polygon's area away.
    double area = 0;
    for (std::size_t i = 2; i < count; ++i) {
        const vec2 one = ring[i - 1] - ring[0], other = ring[i] - ring[0];
        area += differenceOfProducts(one.x, other.y, one.y, other.x);
    }
    if (area == 0) return;
    if (area < 0) std::reverse(ring.begin(), ring.end());

    // Each corner moved half a pixel in and out, along the mitre of its two edges; no more than 4 pixels at a sharp one
    std::vector<PaintedVertex> inner, outer;
    for (std::size_t i = 0; i < count; ++i) {
        const vec2 before = glm::normalize(ring[i] - ring[(i + count - 1) % count]),
                   after = glm::normalize(ring[(i + 1) % count] - ring[i]);
        const double stretch = std::max(0.03, 1 + glm::dot(before, after));
        const vec2 in = 0.5 * (turnedLeft(before) + turnedLeft(after)) / stretch;
        inner.push_back({vec3(ring[i] + in, depth), color});
        outer.push_back({vec3(ring[i] - in, depth), faded(color, 0)});
    }
    for (std::size_t i = 1; i + 1 < count; ++i) painted.insert(painted.end(), {inner[0], inner[i], inner[i + 1]});
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t next = (i + 1) % count;
        addQuad(painted, {outer[i], outer[next], inner[next], inner[i]});
    }
}

std::vector<vec2> circle(const vec2& middle, double radius) {
    // A chord is r (1 - cos(pi / n)), about 5 r / n^2, within the circle
    const int count = std::max(8, int(std::ceil(std::sqrt(50 * radius))));
    std::vector<vec2> corners;
    for (int i = 0; i < count; ++i) {
        const double angle = radians(360.0 * i / count);
        corners.push_back(middle + radius * vec2(std::cos(angle), std::sin(angle)));
    }
    return corners;
}

void cutTo(Painted& painted, std::size_t first, const Box& box) {
    Painted kept;  // not what is before `first`: a drawing of n strokes cuts n times
    for (std::size_t i = first; i + 2 < painted.size(); i += 3) {
        const std::array<PaintedVertex, 3> corner{painted[i], painted[i + 1], painted[i + 2]};
        if (std::all_of(corner.begin(), corner.end(), [&](const auto& c) { return box.holds(vec2(c.position)); })) {
            kept.insert(kept.end(), corner.begin(), corner.end());
            continue;
        }
        // A point of the triangle is (a, b, c, 0), so much of each corner; a side of the box is a half space of those
        const vec3 x(corner[0].position.x, corner[1].position.x, corner[2].position.x),
            y(corner[0].position.y, corner[1].position.y, corner[2].position.y);
        const std::array sides{vec4(x - box.low.x, 0), vec4(box.high.x - x, 0), vec4(y - box.low.y, 0),
                               vec4(box.high.y - y, 0)};
        const std::vector<vec4> rest = clipPolygon({vec4(1, 0, 0, 0), vec4(0, 1, 0, 0), vec4(0, 0, 1, 0)}, sides);
        const auto mixed = [&](const vec4& part) {
            PaintedVertex vertex{vec3(0), vec4(0)};
            for (int c = 0; c < 3; ++c) {
                vertex.position += part[c] * corner[std::size_t(c)].position;
                vertex.color += part[c] * corner[std::size_t(c)].color;
            }
            return vertex;
        };
        for (std::size_t k = 1; k + 1 < rest.size(); ++k)
            kept.insert(kept.end(), {mixed(rest[0]), mixed(rest[k]), mixed(rest[k + 1])});
    }
    painted.resize(first);
    painted.insert(painted.end(), kept.begin(), kept.end());
}

}  // namespace mv

// Y21: a ray in the plane of a box's face. Y22: a corner of a polygon at the height of the point.
#include <array>
#include <cmath>
#include <optional>
#include <span>

#include "extremes/row.h"
#include "mv/geometry/ray_forms.h"
#include "ray-cast/textbook_forms.h"

using namespace mv;
using namespace mv::test;

namespace {

// Rays that run in the plane of a face, or along an edge: all touch the closed box.
template <class Meets>
double missedBoxes(Meets meets) {
    double missed = 0;
    for (const double zero : {0.0, -0.0}) {
        for (const double side : {-1.0, 1.0}) {
            for (const double height : {-1.0, -0.5, 0.0, 1.0}) {
                for (int axis = 0; axis < 3; ++axis) {
                    Ray ray{vec3(0), vec3(0)};
                    ray.origin[axis] = side;
                    ray.origin[(axis + 1) % 3] = height;
                    ray.origin[(axis + 2) % 3] = 5;
                    ray.direction = vec3(zero);
                    ray.direction[(axis + 2) % 3] = -1;
                    const auto hit = meets(ray, vec3(-1), vec3(1));
                    missed += !hit || hit->near != 4 || hit->far != 6;
                }
            }
        }
    }
    return missed;
}

[[maybe_unused]] const bool y21 = addRow([] {
    return Row{.id = "Y21",
               .input = "48 rays in the plane of a box's face, with direction 0 and -0 across it",
               .measured = "rays that miss the box, or enter and leave it elsewhere",
               .naive = "slabs as printed: 0/0",
               .naiveError = missedBoxes(
                   [](const Ray& ray, const vec3& low, const vec3& high) { return textbook::box(ray, low, high); }),
               .ours = "intersectBox",
               .ourError = missedBoxes(
                   [](const Ray& ray, const vec3& low, const vec3& high) { return intersectBox(ray, low, high); }),
               .tolerance = 0,
               .reason = "the box is closed, and all numbers are exact"};
});

// Points of a grid, most at the height of a corner, and four triangles round (2, 2) that cover a square without overlap.
template <class IsInside>
double countedWrongly(IsInside isIn) {
    const std::array<vec2, 4> corners{vec2(0, 0), vec2(4, 0), vec2(4, 4), vec2(0, 4)};
    double wrong = 0;
    for (int y = -1; y <= 5; ++y) {
        for (int x = -1; x <= 5; ++x) {
            const vec2 point(x + 0.25, y);  // on no edge but the lowest and the highest
            int times = 0;
            for (std::size_t i = 0; i < 4; ++i) {
                const std::array<vec2, 3> triangle{corners[i], corners[(i + 1) % 4], vec2(2, 2)};
                times += isIn(std::span<const vec2>(triangle), point);
            }
            const bool isCovered = x >= 0 && x < 4 && y >= 0 && y < 4;
            wrong += times != (isCovered ? 1 : 0);
        }
    }
    return wrong;
}

[[maybe_unused]] const bool y22 = addRow([] {
    return Row{.id = "Y22",
               .input = "49 points, most at the height of a corner, and four triangles that cover a square",
               .measured = "points that are in no triangle of the square, or in two, or in one outside",
               .naive = "crossings with s in 0..1",
               .naiveError = countedWrongly(
                   [](std::span<const vec2> corners, const vec2& point) { return textbook::isInside(corners, point); }),
               .ours = "isInside, half-open in y",
               .ourError = countedWrongly(
                   [](std::span<const vec2> corners, const vec2& point) { return isInside(corners, point); }),
               .tolerance = 0,
               .reason = "an edge is crossed where its ends are on different sides, and a corner is on one of them"};
});

}  // namespace

#include "mv/geometry/teapot.h"

#include <array>

namespace mv {
namespace {

// Four control points of a profile: x away from the axis, y up.
using Profile = std::array<vec2, 4>;

// Downwards, with the outside on the left.
constexpr std::array<Profile, 6> profiles{{
    {{{1.4, 2.4}, {1.3375, 2.53125}, {1.4375, 2.53125}, {1.5, 2.4}}},  // rim
    {{{1.5, 2.4}, {1.75, 1.875}, {2, 1.35}, {2, 0.9}}},                // body
    {{{2, 0.9}, {2, 0.45}, {1.5, 0.225}, {1.5, 0.15}}},
    {{{0, 3.15}, {0.8, 3.15}, {0, 2.85}, {0.2, 2.7}}},  // lid
    {{{0.2, 2.7}, {0.4, 2.55}, {1.3, 2.55}, {1.3, 2.4}}},
    {{{1.5, 0.15}, {1.5, 0.075}, {1.425, 0}, {0, 0}}},  // bottom
}};

// Newell's place for the inner control points of a quarter of a circle; 0.5523 would be nearest to a circle.
constexpr double quarter = 0.56;

// A tube in the plane z = 0 whose section is two patches: its inner line, its outer line, and half its width.
struct Tube {
    Profile inner, outer;
    std::array<double, 4> halfWidth;
};
constexpr std::array<Tube, 4> tubes{{
    {{{{-1.6, 2.025}, {-2.3, 2.025}, {-2.7, 2.025}, {-2.7, 1.8}}},  // handle
     {{{-1.5, 2.25}, {-2.5, 2.25}, {-3, 2.25}, {-3, 1.8}}},
     {0.3, 0.3, 0.3, 0.3}},
    {{{{-2.7, 1.8}, {-2.7, 1.575}, {-2.5, 1.125}, {-2, 0.9}}},
     {{{-3, 1.8}, {-3, 1.35}, {-2.65, 0.9375}, {-1.9, 0.6}}},
     {0.3, 0.3, 0.3, 0.3}},
    {{{{1.7, 1.425}, {2.6, 1.425}, {2.3, 2.1}, {2.7, 2.4}}},  // spout
     {{{1.7, 0.6}, {3.1, 0.825}, {2.4, 2.025}, {3.3, 2.4}}},
     {0.66, 0.66, 0.25, 0.25}},
    {{{{2.7, 2.4}, {2.8, 2.475}, {2.9, 2.475}, {2.8, 2.4}}},
     {{{3.3, 2.4}, {3.525, 2.49375}, {3.45, 2.5125}, {3.2, 2.4}}},
     {0.25, 0.25, 0.15, 0.15}},
}};

// A quarter of a turn about the y axis of a profile: rows run up it, columns round, from +x to -z.
BezierPatch turned(const Profile& profile, int quarters) {
    BezierPatch patch;
    for (std::size_t j = 0; j < 4; ++j) {
        const vec2 of = profile[3 - j];
        const double r = of.x;
        const std::array<vec2, 4> round{{{r, 0}, {r, quarter * r}, {quarter * r, r}, {0, r}}};
        for (std::size_t i = 0; i < 4; ++i) {
            vec2 p = round[i];
            for (int k = 0; k < quarters; ++k) p = vec2(-p.y, p.x);
            patch.points[4 * j + i] = vec3(p.x, of.y, -p.y);
        }
    }
    return patch;
}

// Half of a tube, on the side of positive or negative z: columns run across, from the inner line to the outer one or back,
// so that the front is outside.
BezierPatch half(const Tube& tube, double side) {
    BezierPatch patch;
    for (std::size_t j = 0; j < 4; ++j) {
        const vec2 inner = tube.inner[j], outer = tube.outer[j];
        const double z = side * tube.halfWidth[j];
        std::array<vec3, 4> row{vec3(inner, 0), vec3(inner, z), vec3(outer, z), vec3(outer, 0)};
        for (std::size_t i = 0; i < 4; ++i) patch.points[4 * j + i] = row[side > 0 ? i : 3 - i];
    }
    return patch;
}

}  // namespace

std::vector<BezierPatch> teapot() {
    std::vector<BezierPatch> patches;
    for (const Profile& profile : profiles) {
        for (int quarters = 0; quarters < 4; ++quarters) patches.push_back(turned(profile, quarters));
    }
    for (const Tube& tube : tubes) {
        for (const double side : {1.0, -1.0}) patches.push_back(half(tube, side));
    }
    return patches;
}

}  // namespace mv

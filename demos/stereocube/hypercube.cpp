// A cube of four dimensions: turned in six planes, and projected to three as a camera projects three to two.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "stereocube.h"

namespace mv::stereocube {
namespace {

// A turn happens in a plane, not about an axis: four coordinates have six planes. The turn takes `from` towards `to`.
mat4 planeTurn(int from, int to, double angle) {
    const double c = std::cos(radians(angle)), s = std::sin(radians(angle));
    mat4 turn(1);
    turn[from][from] = turn[to][to] = c;
    turn[from][to] = s;
    turn[to][from] = -s;
    return turn;
}

// Corner i of 16 has -0.5 or 0.5 for each of its four coordinates, by the bits of i.
std::array<vec4, 16> corners() {
    std::array<vec4, 16> all;
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (int k = 0; k < 4; ++k) all.at(i)[k] = (i >> k & 1) != 0 ? 0.5 : -0.5;
    }
    return all;
}

}  // namespace

// Turns in planes without w commute with the projection along w: two of these are spin-x (yz) and spin-y (xz), which act
// in three dimensions.
mat4 turnOf(const Hypercube& four) {
    enum { x, y, z, w };
    return planeTurn(x, y, four.xy) * planeTurn(x, w, four.xw) * planeTurn(y, w, four.yw) * planeTurn(z, w, four.zw);
}

// A point is divided by its distance from an eye on the w axis, in units of the nearest cell's distance, w = 0.5. At inner = 1
// the eye is infinitely far away.
double divisorOf(const Hypercube& four, const vec4& turned) { return 1 + (0.5 - turned.w) * (1 / four.inner - 1); }

// 32 edges: two corners that differ in one coordinate.
MeshData wireHypercube(const Hypercube& four) {
    const mat4 turn = turnOf(four);
    const auto place = [&](const vec4& corner) {
        const vec4 turned = turn * corner;
        return fvec3(vec3(turned) / divisorOf(four, turned));
    };
    const std::array<vec4, 16> all = corners();
    MeshData mesh;
    mesh.primitive = Primitive::lines;
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t bit = 1; bit < all.size(); bit *= 2) {
            if ((i & bit) != 0) continue;
            mesh.positions.push_back(place(all.at(i)));
            mesh.positions.push_back(place(all.at(i | bit)));
        }
    }
    return mesh;
}

// The least divisor of all corners. At 0, a corner is as near as the eye.
double leastDivisor(const Hypercube& four) {
    const mat4 turn = turnOf(four);
    double least = std::numeric_limits<double>::infinity();
    for (const vec4& corner : corners()) least = std::min(least, divisorOf(four, turn * corner));
    return least;
}

}  // namespace mv::stereocube

// cube-shadows: what stands before a floor and a wall, and its shadows on them: one matrix for any plane and any light.
//
// Claims (each is a test in tests/claims/cube-shadows.cpp):
// - [cast-by-rays] The picture is what rays show, on floor, wall and leaning wall, from lamps and lights at infinity.
// - [no-shadow-seen-from-the-light] An eye at the light, as in the first picture, sees no shadow.
// - [special-case] On planes across an axis the slide's special case and the general matrix give the same picture.
// - [transposed-is-wrong] The matrix as the slide prints it, for columns transposed, draws another picture (E7).
// - [darkened-once] However many triangles and casters overlap in a shadow, each of its pixels is darkened once.
// - [between-plane-and-light] What is above the light, at its height or behind the plane casts nothing (X11-X13).
// - [clip-or-discard] Clip distances and discard cut the same false shadows off.
// - [light-in-the-plane] A light in the plane or behind it throws no shadow there, and a sentence says so (X14).
// - [grazing-light] Under a light 1e-7 above the plane no pixel beside floor and wall is darkened (X15).
// - [far-from-the-origin] With the plane 1e6 from the origin a shadow's place is right to 1e-5 of the cube (X16).
// - [moved-by-hand] The arrow keys turn the light by 5 degrees.
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "mv/demo/demo.h"
#include "mv/geometry/scene.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/gl.h"
#include "mv/math/projection.h"
#include "mv/math/shadow.h"
#include "mv/math/shadow_caster.h"
#include "mv/math/transform.h"

using namespace mv;

namespace {

enum class Place { plane, room, stillLife };
enum class Formula { general, axisAligned, transposed };
enum class Space { planeLocal, world, worldFloat };
enum class Cut { clip, discard, none };

// For the plane (a, b, c, d), n.L I - L n^T: row i is n.L e_i - L_i (a, b, c, d). The slide prints it transposed.
template <class T>
glm::mat<4, 4, T> ofAnyPlane(const glm::vec<4, T>& light, const glm::vec<4, T>& plane, bool transposed) {
    glm::mat<4, 4, T> m(glm::dot(plane, light));
    for (int column = 0; column < 4; ++column) m[column] -= transposed ? plane * light[column] : light * plane[column];
    return m;
}

// The slide's special case, for the plane where coordinate k is q: P_j = ((L_k - q) V_j - L_j (V_k - q)) / (L_k - V_k).
template <class T>
glm::mat<4, 4, T> acrossAxis(const glm::vec<4, T>& light, const glm::vec<4, T>& plane) {
    const int k = std::abs(plane.x) > T(0.5) ? 0 : std::abs(plane.y) > T(0.5) ? 1 : 2;
    const T q = -plane.w / plane[k];
    glm::mat<4, 4, T> m(light[k] - q * light.w);
    for (int j = 0; j < 3; ++j) {
        m[k][j] = j == k ? -q * light.w : -light[j];
        m[3][j] = q * light[j];
    }
    m[k][3] = -light.w;
    m[3][3] = light[k];
    return m;
}

struct Receiver {
    mat4 worldFromSquare;
    PlaneKind kind;
    vec3 color;
    vec3 origin() const { return vec3(worldFromSquare[3]); }
    vec3 normal() const { return vec3(worldFromSquare[1]); }  // of unit length: squares are not scaled along it
    vec4 plane() const { return {normal(), -glm::dot(normal(), origin())}; }
};

vec3 onSphere(double theta, double phi) {
    const double t = radians(theta), p = radians(phi);
    return {std::sin(p) * std::cos(t), std::sin(p) * std::sin(t), std::cos(p)};
}

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

constexpr double floorBelow = 1.0125;  // the middle of the scene
constexpr double wallX = -3;

// The course's cube, of side 2, in its colours.
MeshData paintedCube() {
    MeshData cube = box(vec3(-1), vec3(1));
    for (const fvec3& face : {fvec3(1, 0, 0), {0, 1, 1}, {1, 1, 0}, {0, 1, 0}, {1, 0, 1}, {0, 0, 1}})
        cube.colors.insert(cube.colors.end(), 6, fvec4(face, 1));
    return cube;
}

// What casts, in coordinates about the middle of the scene, z upwards.
Scene castersOf(Place place) {
    if (place != Place::stillLife) return {.objects = {{.name = "cube", .mesh = paintedCube()}}};
    Scene life = stillLife(1);
    std::erase_if(life.objects, [](const SceneObject& object) { return !object.casts; });
    // Its y up becomes z, its wall's front +z becomes +x, and its wall at -1.6 comes to stand where ours is.
    const mat4 turned(vec4(0, 1, 0, 0), vec4(0, 0, 1, 0), vec4(1, 0, 0, 0), vec4(0, 0, 0, 1));
    for (SceneObject& object : life.objects)
        object.worldFromObject = translate(0, 0, -floorBelow) * turned * scale(wallX / -1.6) * object.worldFromObject;
    return life;
}

struct CubeShadows final : Demo {
    Choice<Place> place{this,
                        "scene",
                        Place::plane,
                        {{"plane", "a cube over the original's plane, which is not drawn"},
                         {"room", "the cube before a floor and a wall"},
                         {"still-life", "a pawn, a ring, a sphere and a box before a floor and a wall"}},
                        "what casts, and on what"};
    Angle lightTheta{this, "light-theta", 20, "where the light stands: its turn about the upright axis, 0 along x"};
    Real lightPhi{this, "light-phi", 80, {0, 180}, "where the light stands: its angle from straight above", "deg"};
    Real lightDistance{this, "light-distance", 8.5, {1.75, 20}, "distance of the light from the middle of the scene"};
    Toggle atInfinity{this, "at-infinity", false, "a light in that direction, infinitely far away: w = 0"};
    Real lift{this, "lift", 0, {-3, 12}, "how far what casts is lifted"};
    Real tilt{this, "tilt", 0, {-30, 60}, "how far the wall leans back; in scene plane, how far the plane rises", "deg"};
    Real darkness{this, "darkness", 0.25, {0, 1}, "how much of the light a shadow takes away; 0: no shadow"};
    Toggle once{this, "once", true, "darken each pixel once, by the stencil buffer"};
    Choice<Cut> cut{this,
                    "cut",
                    Cut::clip,
                    {{"clip", "clip distances: GL cuts the triangles"},
                     {"discard", "the fragment shader discards"},
                     {"none", "not at all: false shadows are seen"}},
                    "how false shadows are cut off: those of what is not between plane and light"};
    Choice<Formula> formula{this,
                            "formula",
                            Formula::general,
                            {{"general", "for any plane"},
                             {"axis-aligned", "the slide's special case, for a plane across an axis"},
                             {"transposed", "as the slide prints the general one: wrong for columns"}},
                            "which matrix flattens"};
    Real planeDistance{this, "plane-distance", floorBelow, {0, 1e8}, "distance of the floor below the world's origin"};
    Choice<Space> space{this,
                        "space",
                        Space::planeLocal,
                        {{"plane-local", "relative to a point of the plane, in double"},
                         {"world", "world coordinates in double"},
                         {"world-float", "world coordinates in float"}},
                        "where the matrix is computed; all are rounded to float when they are uploaded"};
    Angle theta{this, "theta", 20, "where the eye stands: its turn about the upright axis"};
    Real phi{this, "phi", 80, {1, 179}, "where the eye stands: its angle from straight above", "deg"};
    Real distance{this, "distance", 8.5, {2, 30}, "distance of the eye from the middle of the scene"};
    Real fov{this, "fov", 40, {10, 120}, "the view's angle, upwards", "deg"};

    Readout lightHeight{this, "light-height", "height of the light above the floor; at infinity the sine of its angle"};
    Readout placeError{this, "place-error", "largest miss of a shadow's corner on the floor, of a cube of side 2"};

    Program surfaces, shadows;
    Scene casters[2];
    std::vector<Mesh> casterMeshes[2];
    Mesh square2, wires, lamp;

    CubeShadows() {
        bindDrag(theta, -360.0 / 700, phi, -360.0 / 700);
        bindWheel(distance, -0.5);
        bindKeys(Key::left, Key::right, lightTheta, 5);
        bindKeys(Key::up, Key::down, lightPhi, 5);
    }
};
}

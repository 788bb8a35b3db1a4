// Recursive ray tracing: Whitted's paper of 1980 for a ray, and Cook's of 1984 for a light with an area.
//
// The light that reaches the eye along a ray is, at the first surface that it meets: what the surface emits; the
// ambient light's part of its colour; of the lamp, as much as the ray to a point of the lamp lets through; and what
// comes along the mirrored and the refracted ray, in the parts that Fresnel's equations give. All in double precision.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "ball_texture.h"
#include "leaving.h"
#include "mv/geometry/ray.h"
#include "mv/math/types.h"
#include "shared/ray_structures.h"

namespace mv {

struct Surface {
    vec3 color{0};  // Lambert's, 0..1
    vec3 emitted{0};
    double mirrored = 0;  // the part of the light that an opaque surface mirrors, 0..1
    double index = 0;     // of a glass body; 0: opaque
};

struct TracedBall {
    vec3 center{0};
    double radius = 1;
    Surface surface;
    std::shared_ptr<const BallTexture> texture = {};  // instead of the surface's colour
};

// A lamp that is a parallelogram; of no area, and not seen, where both halves are 0.
struct TracedLamp {
    vec3 middle{0, 5, 0}, halfU{0}, halfV{0};
    vec3 light{1};    // on a surface that faces it: at any distance, or with a falloff at the origin's
    vec3 emitted{3};  // along a ray that meets it, from either side
};

struct TracedScene {
    std::vector<TracedBall> balls;
    // A floor y = height with squares of that size in two colours; it has no end.
    struct Floor {
        double height = 0, square = 1;
        Surface light, dark;
    };
    std::optional<Floor> floor;
    std::shared_ptr<const TriangleFinder> mesh;  // may be none
    Surface meshSurface;
    Leave leave = Leave::bounded;  // how rays leave the mesh
    std::vector<TracedLamp> lamps;
    vec3 ambient{0.1};
    vec3 skyBelow{0.75, 0.82, 0.9},
        skyAbove{0.3, 0.5, 0.8};  // the light from the empty sky, at the horizon and from above
};

struct TraceOptions {
    int depth = 8;  // rays that follow each other, at most
    bool shadows = true;
    bool schlick = false;  // instead of Fresnel's equations
    double highlight = 0;  // Phong's exponent, of what is opaque; 0: only Lambert's part
    bool falloff = false;  // the lamps' light falls as the square of the distance
    bool filtered = true;  // squares and textures are averaged over what the ray's cone covers
};

// A place of the lamps, -1..1 along both halves.
using LampPlace = vec2;

struct Traced {
    vec3 light{0};
    double cut = 0;  // the part of the light that rays would bring which the depth leaves out
    long rays = 0;
    bool glass = false;  // whether a ray of them, or one to a lamp, met glass
};

// `spread` is by how much the ray's cone widens in a length of 1, as its radius.
Traced traceRay(const TracedScene& scene, const Ray& ray, double spread, const LampPlace& place,
                const TraceOptions& options);

// The first surface that a ray meets: a ball, a triangle, or else the floor.
struct Met {
    double t = 0;
    vec3 point{0}, normal{0, 1, 0};  // out of the body; a triangle's to the side that the ray comes from
    int ball = -1;
    const SceneTriangle* triangle = nullptr;
};
// `left`: the triangle that the ray has left, if any, which may be met again as scene.leave has it.
std::optional<Met> firstMet(const TracedScene& scene, const Ray& ray, const SceneTriangle* left = nullptr);

// The start of a ray that leaves the place: off the surface, to the side that the direction leads to, by more than the
// place's roundings, so that it does not meet the surface that it leaves.
vec3 startFrom(const TracedScene& scene, const Met& met, const vec3& direction);

// The part of the lamp's light that comes through on the way: 0 behind what is opaque; through glass what is transmitted at each
// surface, as if the ray went straight on.
double letThrough(const TracedScene& scene, const vec3& start, const vec3& lamp, const SceneTriangle* left = nullptr);

// The floor's squares averaged over a box of that width: 0 (dark) to 1 (light).
double squaresAround(double x, double z, double square, double width);

// ---- the sample points in a pixel and on a lamp

enum class SamplePattern { regular, random, jittered, sequence };
// Point `sample` of `count`, in the unit square, for a pixel of that number: two squares, for the pixel and for the lamp.
// regular and jittered need a square number. sequence: Sobol's (0,2)-sequence, scrambled anew for each pixel.
// Source: Kollig and Keller, "Efficient multidimensional sampling", CGF 21(3), 2002.
std::array<vec2, 2> samplePoints(SamplePattern pattern, int sample, int count, std::uint32_t pixel, std::uint32_t seed);

}  // namespace mv

// Light and shadow, found by rays: exact up to double precision, and by a method that shares nothing
// with those that GL uses. The reference that every shadow picture is judged by.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "mv/geometry/ray.h"
#include "mv/geometry/scene.h"

namespace mv {

// Called with the part done, 0..1, now and then and from one thread.
using Progress = std::function<void(double part)>;

struct SceneHit {
    double t = 0;     // along the ray
    int object = -1;  // index in Scene::objects
    int triangle = -1;
    vec3 point{0, 0, 0};
    vec3 normal{0, 0, 0};  // of the triangle as GL draws it: unit length, outwards, in world space
};

struct LitOptions {
    int light = 0;      // index in Scene::lights
    int lightSide = 1;  // an area light is asked at lightSide x lightSide points, the centres of equal cells
    int pixelSide = 1;  // a pixel at pixelSide x pixelSide points, the centres of equal cells
    int threads = 0;    // 0: one for each core
    Progress progress = {};
};

// One entry a pixel, the upper row first.
struct LitPicture {
    int width = 0, height = 0;
    // The part of the light that reaches the surface, 0..1, seen in the pixel; 0 where the surface faces away from the
    // light, and where nothing is seen. Averaged over those of the pixel's points that see `object`; where none of them
    // does, that of its middle. An object that does not receive is never in shadow.
    std::vector<double> lit;
    // The object seen in the middle of the pixel, as an index in Scene::objects; -1: none.
    std::vector<int> object;
    // Whether the triangle seen there has its front towards the (middle of the) light: where it has not, a shadow does
    // not matter.
    std::vector<bool> faces;
    // The rays that were asked: one for each point seen, and from there one for each point of the light that it faces,
    // also where one look at the whole light answered many at once.
    long rays = 0;
};

class RayCaster {
  public:
    // Copies the triangles of all objects into world space, in double. Refused: what validate() refuses, a mesh of lines
    // or points, a worldFromObject that is not finite, affine and invertible, a coordinate beyond 1e70.
    explicit RayCaster(const Scene& scene);
    ~RayCaster();
    RayCaster(RayCaster&&) noexcept;
    RayCaster& operator=(RayCaster&&) noexcept;

    // The first triangle along the ray, of any object, from either side. Refused: NaN, infinity, direction 0.
    std::optional<SceneHit> nearest(const Ray& ray) const;
    // Whether an object that casts stands between the surface point of `hit` and the point or direction `light`
    // (homogeneous, world space). The triangle that was hit does not shade itself, and its neighbours do only where
    // they rise above it by more than the rounding of its coordinates: the ray starts that much above the triangle, on
    // the light's side of it (gamma(8) of pbrt's error bounds, no fixed epsilon).
    // Refused: a hit that is not of this scene, a light that is not finite or (0, 0, 0, w).
    bool inShadow(const SceneHit& hit, const vec4& light) const;

    // The lit fraction of every pixel of a width x height picture through scene.clipFromWorld(): a ray through
    // (i + 1/2, j + 1/2), then one to each point of the light. Rows are shared out over threads; the result does not
    // depend on their number. Only what lies in the view volume is seen, as in GL, and triangles from either side.
    // An exception of options.progress ends the work and is passed on.
    // Refused: a size outside 1..16384, a side outside 1..1024, threads outside 0..1024; a light that is not there, not
    // finite, or neither point nor direction; a clipFromWorld that is not finite or has no inverse.
    LitPicture lit(int width, int height, const LitOptions& options = {}) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace mv

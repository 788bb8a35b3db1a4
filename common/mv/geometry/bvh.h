// Triangles in a tree of boxes, so that a ray asks few of them: what the ray caster stands on. Not part of the package.
#pragma once
#include <array>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "mv/geometry/ray.h"

namespace mv {

// A triangle in world space, with the numbers its scene knows it by.
struct SceneTriangle {
    vec3 a, b, c;
    int object = -1, triangle = -1;
};

struct BvhHit {
    TriangleHit<double> hit;
    const SceneTriangle* triangle = nullptr;
};

struct BvhBuild;

// A bounding volume hierarchy of four boxes a node, split where the surface area heuristic finds it cheapest. The tree
// finds what a loop over all triangles finds, to the last bit: the four boxes are tested at once in float, with room
// for every rounding, and what lies in them in double.
class Bvh {
  public:
    explicit Bvh(std::vector<SceneTriangle> triangles);

    // The hit of smallest t below `end`; of several at the same t the one of the lowest object, then triangle.
    std::optional<BvhHit> nearest(const Ray& ray, double end = std::numeric_limits<double>::infinity()) const;

    // Some triangle met before `end`, other than triangle `exceptTriangle` of object `exceptObject`; null: none.
    // Which of them it is depends on the tree.
    const SceneTriangle* any(const Ray& ray, double end, int exceptObject, int exceptTriangle) const;

    // All triangles that some ray from `origin` with a direction in the box lo..hi may meet at t <= 1, and perhaps some
    // more; false where there are more than `most`, and `found` is then of no use. One question for a whole area light.
    bool mayMeet(const vec3& origin, const vec3& lo, const vec3& hi, std::size_t most,
                 std::vector<const SceneTriangle*>& found) const;

  private:
    static constexpr int lanes = 4;
    struct Children {  // of an inner node; those that are not there have their bounds the wrong way round
        alignas(16) std::array<std::array<float, lanes>, 6> bounds{};  // lo, then hi, outwards of the true ones
        std::array<std::uint32_t, lanes> first{};  // of the triangles; of an inner node: its own number
        std::array<std::uint32_t, lanes> count{};  // of the triangles; 0: an inner node
    };
    struct RayBoxes;
    std::uint32_t gather(const BvhBuild& build, std::uint32_t from);
    double room(const vec3& origin) const;
    template <typename Visit>
    void visit(const Ray& ray, double& end, const Visit& visitTriangle) const;

    std::vector<SceneTriangle> triangles_;
    std::vector<Children> nodes_;
    // The boxes stand in units of their own, (p - middle_) * scale_, in which all lie within -1..1 whatever the scene's size.
    vec3 middle_{0, 0, 0};
    double scale_ = 1;   // a power of 2
    double extent_ = 0;  // the largest size of a coordinate, in the scene's units
};

}  // namespace mv

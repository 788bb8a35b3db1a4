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

// A binary bounding volume hierarchy, split where the surface area heuristic finds it cheapest. What it finds is what a
// loop over all triangles finds, to the last bit: its boxes are tested with room for every rounding.
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
    struct Node {
        std::array<double, 6> bounds{};  // lo, then hi
        std::uint32_t first = 0;         // of the triangles; of an inner node: of its two children, which lie together
        std::uint32_t count = 0;         // of the triangles; 0: an inner node
    };
    class Build;
    double room(const vec3& origin) const;
    template <typename Visit>
    void visit(const Ray& ray, double& end, const Visit& visitTriangle) const;

    std::vector<SceneTriangle> triangles_;
    std::vector<Node> nodes_;
    double extent_ = 0;  // the largest size of a coordinate
};

}  // namespace mv

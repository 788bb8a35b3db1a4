// Triangles sorted into a binary tree of boxes: what the tree that rays go through is gathered from. Not part of the package.
#pragma once
#include <cstdint>
#include <vector>

#include "mv/geometry/bounds.h"
#include "mv/geometry/bvh.h"

namespace mv {

// Half of a box's surface: how likely a ray that comes from anywhere meets it, beside other boxes.
inline double halfArea(const Bounds& box) {
    const vec3 size = box.high - box.low;
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

// Split where the surface area heuristic finds it cheapest; deeper than 64 it never is.
struct BvhBuild {
    struct Node {
        Bounds bounds;
        std::uint32_t first = 0;  // in `order`; of an inner node: of its two children, which lie together in `nodes`
        std::uint32_t count = 0;  // of triangles; 0: an inner node
    };
    std::vector<std::uint32_t> order;  // the triangles' numbers
    std::vector<Node> nodes;           // the root first; none without triangles

    explicit BvhBuild(const std::vector<SceneTriangle>& triangles);
};

}  // namespace mv

#include "shared/ray_structures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/common.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <span>
#include <tuple>
#include <utility>

#include "mv/geometry/teapot.h"
#include "mv/math/transform.h"

namespace mv {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Extent {
    vec3 low{infinite}, high{-infinite};
    void include(const SceneTriangle& triangle) {
        low = glm::min(low, glm::min(triangle.a, glm::min(triangle.b, triangle.c)));
        high = glm::max(high, glm::max(triangle.a, glm::max(triangle.b, triangle.c)));
    }
    // Wider by more than the roundings of whoever asks which box a point is in.
    void grow(const vec3& by) {
        low -= by;
        high += by;
    }
    bool isEmpty() const { return !(low.x <= high.x); }
};

vec3 roomAround(const Extent& box) { return 1e-9 * (glm::abs(box.low) + glm::abs(box.high)) + 1e-300; }

// The nearest so far, on the way through some triangles.
class Search {
  public:
    explicit Search(const Ray& ray) : test_(ray) {}
    void ask(const SceneTriangle& triangle) {
        const auto hit = test_(triangle.a, triangle.b, triangle.c);
        if (!hit || (nearest && hit->t > nearest->hit.t)) return;
        if (nearest && hit->t == nearest->hit.t && numbers(*nearest->triangle) < numbers(triangle)) return;
        nearest = BvhHit{*hit, &triangle};
    }
    std::optional<BvhHit> nearest;

  private:
    static std::pair<int, int> numbers(const SceneTriangle& one) { return {one.object, one.triangle}; }
    TriangleTest<double> test_;
};

class NoStructure final : public TriangleFinder {
  public:
    explicit NoStructure(std::vector<SceneTriangle> triangles) : triangles_(std::move(triangles)) {}
    std::optional<BvhHit> nearest(const Ray& ray) const override {
        Search search(ray);
        for (const SceneTriangle& triangle : triangles_) search.ask(triangle);
        return search.nearest;
    }

  private:
    std::vector<SceneTriangle> triangles_;
};

class Boxes final : public TriangleFinder {
  public:
    explicit Boxes(std::vector<SceneTriangle> triangles) : triangles_(std::move(triangles)) {
        std::ranges::stable_sort(triangles_, {}, &SceneTriangle::object);
        for (std::size_t i = 0; i < triangles_.size(); ++i) {
            if (i == 0 || triangles_[i].object != triangles_[i - 1].object) objects_.push_back({{}, i, i});
            objects_.back().box.include(triangles_[i]);
            objects_.back().end = i + 1;
        }
        for (Object& object : objects_) object.box.grow(roomAround(object.box));
    }
    std::optional<BvhHit> nearest(const Ray& ray) const override {
        Search search(ray);
        for (const Object& object : objects_) {
            if (!intersectBox(ray, object.box.low, object.box.high)) continue;
            for (std::size_t i = object.begin; i < object.end; ++i) search.ask(triangles_[i]);
        }
        return search.nearest;
    }

  private:
    struct Object {
        Extent box;
        std::size_t begin, end;
    };
    std::vector<SceneTriangle> triangles_;
    std::vector<Object> objects_;
};

class Grid final : public TriangleFinder {
  public:
    explicit Grid(std::vector<SceneTriangle> triangles) : triangles_(std::move(triangles)) {
        for (const SceneTriangle& triangle : triangles_) box_.include(triangle);
        if (box_.isEmpty()) return;
        box_.grow(roomAround(box_));
        divide();
        fill();
    }

    std::optional<BvhHit> nearest(const Ray& ray) const override {
        if (triangles_.empty()) return {};
        const auto within = intersectBox(ray, box_.low, box_.high);
        if (!within) return {};
        const Place start = placeOf(ray.at(std::max(0.0, within->near)));
        Place place = start;
        vec3 leaves(infinite);  // the t at which the ray leaves its present cell, by the plane across each axis
        for (int axis = 0; axis < 3; ++axis) leaves[axis] = planeAt(ray, place, axis);
        Search search(ray);
        for (;;) {
            const std::size_t cell = number(place);
            for (std::uint32_t i = first_[cell]; i < first_[cell + 1]; ++i) search.ask(triangles_[inCells_[i]]);
            const int axis = leaves.x <= leaves.y && leaves.x <= leaves.z ? 0 : leaves.y <= leaves.z ? 1 : 2;
            // A triangle in a later cell is met later
            if (search.nearest && search.nearest->hit.t < leaves[axis]) return search.nearest;
            place[static_cast<std::size_t>(axis)] += ray.direction[axis] < 0 ? -1 : 1;
            if (place[static_cast<std::size_t>(axis)] < 0 ||
                place[static_cast<std::size_t>(axis)] >= cells_[static_cast<std::size_t>(axis)])
                return search.nearest;
            leaves[axis] = planeAt(ray, place, axis);
        }
    }

  private:
    using Place = std::array<int, 3>;

    // Cells that are nearly cubes, two for each triangle.
    void divide() {
        vec3 size = box_.high - box_.low;
        const double largest = std::max({size.x, size.y, size.z});
        size = glm::max(size, vec3(1e-3 * largest));
        const double edge = std::cbrt(size.x * size.y * size.z / (2.0 * double(triangles_.size())));
        for (int axis = 0; axis < 3; ++axis) {
            cells_[static_cast<std::size_t>(axis)] =
                std::clamp(static_cast<int>(std::lround(size[axis] / edge)), 1, 512);
            cell_[axis] = (box_.high[axis] - box_.low[axis]) / cells_[static_cast<std::size_t>(axis)];
        }
    }
    // How many triangles each cell has, then which.
    void fill() {
        first_.assign(number({0, 0, cells_[2]}) + 1, 0);
        forAll([&](std::size_t cell, std::uint32_t) { ++first_[cell + 1]; });
        for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
        inCells_.resize(first_.back());
        std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
        forAll([&](std::size_t cell, std::uint32_t triangle) { inCells_[next[cell]++] = triangle; });
    }
    // Calls for each cell that the triangle's bounding box touches.
    template <class Call>
    void forAll(const Call& call) const {
        for (std::uint32_t i = 0; i < triangles_.size(); ++i) {
            Extent around;
            around.include(triangles_[i]);
            around.grow(roomAround(box_));
            const Place low = placeOf(around.low), high = placeOf(around.high);
            for (int z = low[2]; z <= high[2]; ++z) {
                for (int y = low[1]; y <= high[1]; ++y) {
                    for (int x = low[0]; x <= high[0]; ++x) call(number({x, y, z}), i);
                }
            }
        }
    }

    Place placeOf(const vec3& point) const {
        Place place{};
        for (int axis = 0; axis < 3; ++axis) {
            const auto which = static_cast<std::size_t>(axis);
            const double cell = std::floor((point[axis] - box_.low[axis]) / cell_[axis]);
            place[which] = static_cast<int>(std::clamp(cell, 0.0, cells_[which] - 1.0));
        }
        return place;
    }
    std::size_t number(const Place& at) const {
        return (static_cast<std::size_t>(at[2]) * static_cast<std::size_t>(cells_[1]) +
                static_cast<std::size_t>(at[1])) *
                   static_cast<std::size_t>(cells_[0]) +
               static_cast<std::size_t>(at[0]);
    }
    double planeAt(const Ray& ray, const Place& place, int axis) const {
        const double along = ray.direction[axis];
        if (along == 0) return infinite;
        const int plane = place[static_cast<std::size_t>(axis)] + (along > 0 ? 1 : 0);
        return (box_.low[axis] + plane * cell_[axis] - ray.origin[axis]) / along;
    }

    std::vector<SceneTriangle> triangles_;
    Extent box_;
    Place cells_{1, 1, 1};
    vec3 cell_{1};
    std::vector<std::uint32_t> first_, inCells_;  // of a cell: inCells_[first_[cell]] and on
};

class Tree final : public TriangleFinder {
  public:
    explicit Tree(std::vector<SceneTriangle> triangles) : tree_(std::move(triangles)) {}
    std::optional<BvhHit> nearest(const Ray& ray) const override { return tree_.nearest(ray); }

  private:
    Bvh tree_;
};

}  // namespace

std::unique_ptr<const TriangleFinder> findTriangles(RayStructure structure, std::vector<SceneTriangle> triangles) {
    switch (structure) {
        case RayStructure::none:
            return std::make_unique<NoStructure>(std::move(triangles));
        case RayStructure::boxes:
            return std::make_unique<Boxes>(std::move(triangles));
        case RayStructure::grid:
            return std::make_unique<Grid>(std::move(triangles));
        case RayStructure::tree:
            return std::make_unique<Tree>(std::move(triangles));
    }
    return nullptr;
}

std::vector<SceneTriangle> teapotTriangles(int cells) {
    const std::vector<BezierPatch> patches = teapot();
    const mat4 placed = rotateY(-30) * scale(0.51, 0.51, 0.51);
    std::vector<SceneTriangle> triangles;
    triangles.reserve(patches.size() * 2 * static_cast<std::size_t>(cells) * static_cast<std::size_t>(cells));
    for (std::size_t patch = 0; patch < patches.size(); ++patch) {
        const MeshData mesh = tessellated(std::span(&patches[patch], 1), cells);
        const auto corner = [&](std::size_t i) {
            return vec3(placed * vec4(vec3(mesh.positions[mesh.indices[i]]), 1));
        };
        for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
            triangles.push_back(
                {corner(i), corner(i + 1), corner(i + 2), static_cast<int>(patch), static_cast<int>(i / 3)});
        }
    }
    return triangles;
}

}  // namespace mv

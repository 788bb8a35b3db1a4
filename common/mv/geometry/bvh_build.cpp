#include "mv/geometry/bvh_build.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace mv {
namespace {

constexpr std::uint32_t largestLeaf = 4;
constexpr int bins = 16;
// From this depth on the triangles are halved, which ends within 32 more: so the tree is never deeper than the stack.
constexpr int deepestGuess = 32;

Bounds boundsOf(const SceneTriangle& triangle) {
    Bounds bounds;
    bounds.add(triangle.a);
    bounds.add(triangle.b);
    bounds.add(triangle.c);
    return bounds;
}

using Node = BvhBuild::Node;

// Sorts the triangles' numbers, with their bounds beside them.
class Sort {
  public:
    Sort(const std::vector<SceneTriangle>& triangles, BvhBuild& into) : order_(into.order), nodes_(into.nodes) {
        order_.resize(triangles.size());
        std::iota(order_.begin(), order_.end(), 0U);
        bounds_.reserve(triangles.size());
        middles_.reserve(triangles.size());
        for (const SceneTriangle& triangle : triangles) {
            bounds_.push_back(boundsOf(triangle));
            middles_.push_back(bounds_.back().middle());
        }
        if (order_.empty()) return;
        nodes_.emplace_back();
        fill(0, 0, static_cast<std::uint32_t>(order_.size()), 0);
    }

  private:
    using Iterator = std::vector<std::uint32_t>::iterator;

    // Makes `self` the node of the triangles order_[first] to order_[last - 1].
    void fill(std::size_t self, std::uint32_t first, std::uint32_t last, int depth) {
        Bounds all, middles;
        for (std::uint32_t i = first; i < last; ++i) {
            all.add(bounds_[order_[i]]);
            middles.add(middles_[order_[i]]);
        }
        nodes_[self] = {all, first, last - first};
        if (last - first <= largestLeaf) return;
        const auto begin = order_.begin() + first, end = order_.begin() + last;
        Iterator split = depth < deepestGuess ? cheapestSplit(begin, end, middles) : begin;
        if (split == begin || split == end) split = medianSplit(begin, end, middles);

        const std::size_t children = nodes_.size();
        const auto second = static_cast<std::uint32_t>(split - order_.begin());
        nodes_[self].first = static_cast<std::uint32_t>(children);
        nodes_[self].count = 0;
        nodes_.resize(children + 2);
        fill(children, first, second, depth + 1);
        fill(children + 1, second, last, depth + 1);
    }

    // The cut at which count times area, summed over both sides, is least: about how many triangles a ray has to be
    // tested with.
    Iterator cheapestSplit(Iterator begin, Iterator end, const Bounds& middles) const {
        double least = HUGE_VAL;
        int leastAxis = -1, leastBin = 0;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(middles.high[axis] > middles.low[axis])) continue;
            std::array<Bounds, bins> bounds;
            std::array<int, bins> counts{};
            for (auto i = begin; i != end; ++i) {
                const auto bin = static_cast<std::size_t>(binOf(*i, axis, middles));
                bounds[bin].add(bounds_[*i]);
                ++counts[bin];
            }
            std::array<double, bins> upTo{};
            Bounds side;
            int count = 0;
            for (std::size_t bin = 0; bin < bins; ++bin) {
                side.add(bounds[bin]);
                count += counts[bin];
                upTo[bin] = count == 0 ? 0 : count * halfArea(side);
            }
            side = Bounds();
            count = 0;
            for (std::size_t bin = bins - 1; bin > 0; --bin) {
                side.add(bounds[bin]);
                count += counts[bin];
                const double cost = upTo[bin - 1] + (count == 0 ? 0 : count * halfArea(side));
                if (cost >= least) continue;
                least = cost;
                leastAxis = axis;
                leastBin = static_cast<int>(bin);
            }
        }
        if (leastAxis < 0) return begin;
        return std::partition(begin, end,
                              [&](std::uint32_t triangle) { return binOf(triangle, leastAxis, middles) < leastBin; });
    }

    Iterator medianSplit(Iterator begin, Iterator end, const Bounds& middles) const {
        const vec3 size = middles.high - middles.low;
        const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
        const auto half = begin + (end - begin) / 2;
        std::nth_element(begin, half, end, [&](std::uint32_t one, std::uint32_t other) {
            return std::pair(middles_[one][axis], one) < std::pair(middles_[other][axis], other);
        });
        return half;
    }

    int binOf(std::uint32_t triangle, int axis, const Bounds& middles) const {
        const double low = middles.low[axis], part = (middles_[triangle][axis] - low) / (middles.high[axis] - low);
        return std::min(bins - 1, static_cast<int>(bins * part));
    }

    std::vector<Bounds> bounds_;
    std::vector<vec3> middles_;

    std::vector<std::uint32_t>& order_;
    std::vector<Node>& nodes_;
};

}  // namespace

BvhBuild::BvhBuild(const std::vector<SceneTriangle>& triangles) { const Sort sort(triangles, *this); }

}  // namespace mv

#include "mv/geometry/bvh_build.h"

#include <algorithm>
#include <array>
#include <utility>

namespace mv {
namespace {

constexpr std::uint32_t largestLeaf = 4;
constexpr std::size_t bins = 16;
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

// A triangle's number, with what it is sorted by beside it: each level of the tree goes through them all.
struct Item {
    Bounds bounds;
    vec3 middle;
    std::uint32_t number;
};

// A slice of a box across an axis, and the triangles with their middles in it.
struct Bin {
    Bounds bounds;
    int count = 0;

    void add(const Bin& other) {
        bounds.add(other.bounds);
        count += other.count;
    }
    // About how many triangles a ray has to be tested with: all in the box, as often as it meets the box.
    double cost() const { return count == 0 ? 0 : count * halfArea(bounds); }
};

class Sort {
  public:
    Sort(const std::vector<SceneTriangle>& triangles, BvhBuild& into) : nodes_(into.nodes) {
        items_.reserve(triangles.size());
        for (const SceneTriangle& triangle : triangles) {
            const Bounds bounds = boundsOf(triangle);
            items_.push_back({bounds, bounds.middle(), static_cast<std::uint32_t>(items_.size())});
        }
        if (!items_.empty()) {
            nodes_.emplace_back();
            fill(0, 0, static_cast<std::uint32_t>(items_.size()), 0);
        }
        into.order.reserve(items_.size());
        for (const Item& item : items_) into.order.push_back(item.number);
    }

  private:
    using Iterator = std::vector<Item>::iterator;

    // Makes `self` the node of the triangles items_[first] to items_[last - 1].
    void fill(std::size_t self, std::uint32_t first, std::uint32_t last, int depth) {
        const auto begin = items_.begin() + first, end = items_.begin() + last;
        Bounds all, middles;
        for (auto i = begin; i != end; ++i) {
            all.add(i->bounds);
            middles.add(i->middle);
        }
        nodes_[self] = {all, first, last - first};
        if (last - first <= largestLeaf) return;
        Iterator split = depth < deepestGuess ? cheapestSplit(begin, end, middles) : begin;
        if (split == begin || split == end) split = medianSplit(begin, end, middles);

        const std::size_t children = nodes_.size();
        const auto second = static_cast<std::uint32_t>(split - items_.begin());
        nodes_[self].first = static_cast<std::uint32_t>(children);
        nodes_[self].count = 0;
        nodes_.resize(children + 2);
        fill(children, first, second, depth + 1);
        fill(children + 1, second, last, depth + 1);
    }

    // The cut at which the costs of both sides together are least.
    static Iterator cheapestSplit(Iterator begin, Iterator end, const Bounds& middles) {
        std::array<std::array<Bin, bins>, 3> across;
        for (auto i = begin; i != end; ++i) {
            for (int axis = 0; axis < 3; ++axis) {
                if (!(middles.high[axis] > middles.low[axis])) continue;
                across[std::size_t(axis)][binOf(*i, axis, middles)].add({i->bounds, 1});
            }
        }
        double least = HUGE_VAL;
        int leastAxis = -1;
        std::size_t leastBin = 0;
        for (int axis = 0; axis < 3; ++axis) {
            if (!(middles.high[axis] > middles.low[axis])) continue;
            const auto& slices = across[std::size_t(axis)];
            std::array<double, bins> upTo{};
            Bin side;
            for (std::size_t bin = 0; bin < bins; ++bin) {
                side.add(slices[bin]);
                upTo[bin] = side.cost();
            }
            side = Bin();
            for (std::size_t bin = bins - 1; bin > 0; --bin) {
                side.add(slices[bin]);
                const double cost = upTo[bin - 1] + side.cost();
                if (cost >= least) continue;
                least = cost;
                leastAxis = axis;
                leastBin = bin;
            }
        }
        if (leastAxis < 0) return begin;
        return std::partition(begin, end, [&](const Item& item) { return binOf(item, leastAxis, middles) < leastBin; });
    }

    static Iterator medianSplit(Iterator begin, Iterator end, const Bounds& middles) {
        const vec3 size = middles.high - middles.low;
        const int axis = size.x >= size.y ? (size.x >= size.z ? 0 : 2) : (size.y >= size.z ? 1 : 2);
        const auto half = begin + (end - begin) / 2;
        std::nth_element(begin, half, end, [&](const Item& one, const Item& other) {
            return std::pair(one.middle[axis], one.number) < std::pair(other.middle[axis], other.number);
        });
        return half;
    }

    static std::size_t binOf(const Item& item, int axis, const Bounds& middles) {
        const double low = middles.low[axis], part = (item.middle[axis] - low) / (middles.high[axis] - low);
        return std::min(bins - 1, static_cast<std::size_t>(bins * part));
    }

    std::vector<Item> items_;
    std::vector<Node>& nodes_;
};

}  // namespace

BvhBuild::BvhBuild(const std::vector<SceneTriangle>& triangles) { const Sort sort(triangles, *this); }

}  // namespace mv

#include "mv/geometry/bvh.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "mv/geometry/bounds.h"

namespace mv {
namespace {

constexpr std::uint32_t largestLeaf = 4;
constexpr int bins = 16;
// From this depth on the triangles are halved, which ends within 32 more: so the tree is never deeper than the stack.
constexpr int deepestGuess = 32;
constexpr std::size_t stackSize = 64;

double halfArea(const Bounds& box) {
    const vec3 size = box.high - box.low;
    return size.x * size.y + size.y * size.z + size.z * size.x;
}

Bounds boundsOf(const SceneTriangle& triangle) {
    Bounds bounds;
    bounds.add(triangle.a);
    bounds.add(triangle.b);
    bounds.add(triangle.c);
    return bounds;
}

bool comesBefore(const SceneTriangle& one, const SceneTriangle& other) {
    return std::pair(one.object, one.triangle) < std::pair(other.object, other.triangle);
}

}  // namespace

// Sorts triangle numbers, with their bounds beside them, into a tree.
class Bvh::Build {
  public:
    Build(const std::vector<SceneTriangle>& triangles, std::vector<Node>& nodes)
        : nodes_(nodes), order(triangles.size()) {
        std::iota(order.begin(), order.end(), 0U);
        bounds_.reserve(triangles.size());
        middles_.reserve(triangles.size());
        for (const SceneTriangle& triangle : triangles) {
            bounds_.push_back(boundsOf(triangle));
            middles_.push_back(bounds_.back().middle());
        }
        if (order.empty()) return;
        nodes_.emplace_back();
        fill(0, 0, static_cast<std::uint32_t>(order.size()), 0);
    }

  private:
    using Iterator = std::vector<std::uint32_t>::iterator;

    // Makes `self` the node of the triangles order[first] to order[last - 1].
    void fill(std::size_t self, std::uint32_t first, std::uint32_t last, int depth) {
        Bounds all, middles;
        for (std::uint32_t i = first; i < last; ++i) {
            all.add(bounds_[order[i]]);
            middles.add(middles_[order[i]]);
        }
        nodes_[self] = {{all.low.x, all.low.y, all.low.z, all.high.x, all.high.y, all.high.z}, first, last - first};
        if (last - first <= largestLeaf) return;
        const auto begin = order.begin() + first, end = order.begin() + last;
        Iterator split = depth < deepestGuess ? cheapestSplit(begin, end, middles) : begin;
        if (split == begin || split == end) split = medianSplit(begin, end, middles);

        const std::size_t children = nodes_.size();
        const auto second = static_cast<std::uint32_t>(split - order.begin());
        nodes_[self].first = static_cast<std::uint32_t>(children);
        nodes_[self].count = 0;
        nodes_.resize(children + 2);
        fill(children, first, second, depth + 1);
        fill(children + 1, second, last, depth + 1);
    }

    // Where count times area, summed over both sides, is least: about how many triangles a ray has to be tested with.
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

    std::vector<Node>& nodes_;
    std::vector<Bounds> bounds_;
    std::vector<vec3> middles_;

  public:
    std::vector<std::uint32_t> order;
};

Bvh::Bvh(std::vector<SceneTriangle> triangles) {
    // What has no area is met by no ray; left in, rounding could make a hit of it
    std::erase_if(triangles, [](const SceneTriangle& t) { return areOnOneLine(t.a, t.b, t.c); });
    const Build build(triangles, nodes_);
    triangles_.reserve(triangles.size());
    for (const std::uint32_t i : build.order) triangles_.push_back(triangles[i]);
    if (nodes_.empty()) return;
    for (const double bound : nodes_.front().bounds) extent_ = std::max(extent_, std::abs(bound));
}

namespace {

// A ray made ready for boxes: each slab is entered at (near side - entry) * inverse and left at (far side - exit) *
// inverse. Entry and exit are the origin, moved apart by what rounding can shift the corners of a triangle seen along
// the ray; so no box is passed by of which a triangle would be hit.
struct BoxTest {
    std::array<double, 3> entry, exit, inverse;
    std::array<std::size_t, 3> nearSide, farSide;  // where a node's bounds have them

    BoxTest(const Ray& ray, double room) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<int>(axis);
            const bool backwards = std::signbit(ray.direction[i]);
            inverse[axis] = 1 / ray.direction[i];
            entry[axis] = ray.origin[i] + (backwards ? -room : room);
            exit[axis] = ray.origin[i] - (backwards ? -room : room);
            nearSide[axis] = backwards ? axis + 3 : axis;
            farSide[axis] = backwards ? axis : axis + 3;
        }
    }

    // Where the box is entered, at least 0; infinity where it is missed or lies beyond `end`. 0 * infinity, a ray in
    // the plane of a side, is NaN, which no comparison takes: that slab then bounds nothing.
    double operator()(const std::array<double, 6>& bounds, double end) const {
        double near = 0, far = end;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double first = (bounds[nearSide[axis]] - entry[axis]) * inverse[axis];
            const double last = (bounds[farSide[axis]] - exit[axis]) * inverse[axis];
            near = first > near ? first : near;
            far = last < far ? last : far;
        }
        return near <= far ? near : HUGE_VAL;
    }
};

}  // namespace

// How far rounding can shift the corners of a triangle seen from `origin`, with some to spare.
double Bvh::room(const vec3& origin) const {
    const vec3 size = glm::abs(origin);
    return 16 * std::numeric_limits<double>::epsilon() * (extent_ + std::max({size.x, size.y, size.z}));
}

// Calls visitTriangle with each triangle whose boxes the ray meets before `end`, the nearer box first, until it returns
// true. It may lower `end`.
template <typename Visit>
void Bvh::visit(const Ray& ray, double& end, const Visit& visitTriangle) const {
    if (nodes_.empty()) return;
    struct Entry {
        std::uint32_t node;
        double near;
    };
    const BoxTest boxTest(ray, room(ray.origin));
    std::array<Entry, stackSize> stack;
    std::size_t height = 0;
    const double near = boxTest(nodes_[0].bounds, end);
    if (near < HUGE_VAL) stack[height++] = {0, near};
    while (height > 0) {
        const Entry entry = stack[--height];
        if (entry.near > end) continue;
        const Node& node = nodes_[entry.node];
        if (node.count > 0) {
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
                if (visitTriangle(triangles_[i])) return;
            }
            continue;
        }
        Entry closer{node.first, boxTest(nodes_[node.first].bounds, end)};
        Entry farther{node.first + 1, boxTest(nodes_[node.first + 1].bounds, end)};
        if (farther.near < closer.near) std::swap(closer, farther);
        if (farther.near < HUGE_VAL) stack[height++] = farther;
        if (closer.near < HUGE_VAL) stack[height++] = closer;
    }
}

std::optional<BvhHit> Bvh::nearest(const Ray& ray, double end) const {
    const TriangleTest<double> test(ray);
    BvhHit best;
    visit(ray, end, [&](const SceneTriangle& triangle) {
        const auto hit = test(triangle.a, triangle.b, triangle.c);
        if (!hit || hit->t > end) return false;
        if (best.triangle != nullptr && hit->t == end && !comesBefore(triangle, *best.triangle)) return false;
        if (best.triangle == nullptr && hit->t == end) return false;
        end = hit->t;
        best = {*hit, &triangle};
        return false;
    });
    if (best.triangle == nullptr) return {};
    return best;
}

const SceneTriangle* Bvh::any(const Ray& ray, double end, int exceptObject, int exceptTriangle) const {
    const TriangleTest<double> test(ray);
    const SceneTriangle* found = nullptr;
    visit(ray, end, [&](const SceneTriangle& triangle) {
        const auto hit = test(triangle.a, triangle.b, triangle.c);
        if (!hit || hit->t >= end) return false;
        if (triangle.object == exceptObject && triangle.triangle == exceptTriangle) return false;
        found = &triangle;
        return true;
    });
    return found;
}

namespace {

// Whether a ray from 0 with a direction in lo..hi may be within the box at some t of 0..1: on each axis it is so from
// some t on, and up to some t; where the direction may be 0 or of either sign, one of these has no end.
bool mayPass(const vec3& lo, const vec3& hi, const vec3& boxLo, const vec3& boxHi) {
    double first = 0, last = 1;
    for (int axis = 0; axis < 3; ++axis) {
        if (boxLo[axis] > 0) {
            if (!(hi[axis] > 0)) return false;
            first = std::max(first, boxLo[axis] / hi[axis]);
            if (lo[axis] > 0) last = std::min(last, boxHi[axis] / lo[axis]);
        } else if (boxHi[axis] < 0) {
            if (!(lo[axis] < 0)) return false;
            first = std::max(first, boxHi[axis] / lo[axis]);
            if (hi[axis] < 0) last = std::min(last, boxLo[axis] / hi[axis]);
        } else if (lo[axis] > 0) {
            last = std::min(last, boxHi[axis] / lo[axis]);
        } else if (hi[axis] < 0) {
            last = std::min(last, boxLo[axis] / hi[axis]);
        }
    }
    return first <= last * (1 + 16 * std::numeric_limits<double>::epsilon());
}

}  // namespace

bool Bvh::mayMeet(const vec3& origin, const vec3& lo, const vec3& hi, std::size_t most,
                  std::vector<const SceneTriangle*>& found) const {
    found.clear();
    const double aside = room(origin);
    const auto passes = [&](const Node& node) {
        const auto& [loX, loY, loZ, hiX, hiY, hiZ] = node.bounds;
        return mayPass(lo, hi, vec3(loX, loY, loZ) - origin - aside, vec3(hiX, hiY, hiZ) - origin + aside);
    };
    std::array<std::uint32_t, stackSize> stack;
    std::size_t height = 0;
    if (!nodes_.empty() && passes(nodes_[0])) stack[height++] = 0;
    while (height > 0) {
        const Node& node = nodes_[stack[--height]];
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i) {
            if (found.size() == most) return false;
            found.push_back(&triangles_[i]);
        }
        if (node.count > 0) continue;
        for (const std::uint32_t child : {node.first, node.first + 1}) {
            if (passes(nodes_[child])) stack[height++] = child;
        }
    }
    return true;
}

}  // namespace mv

#include "mv/geometry/bvh.h"

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <utility>

#include "mv/geometry/bounds.h"
#include "mv/geometry/bvh_build.h"

namespace mv {
namespace {

constexpr std::size_t stackSize = 3 * 64 + 1;  // a level leaves three of its four behind

// The largest float that is not above x.
float below(double x) {
    const auto nearest = static_cast<float>(x);
    return static_cast<double>(nearest) > x ? std::nextafter(nearest, -HUGE_VALF) : nearest;
}

bool comesBefore(const SceneTriangle& one, const SceneTriangle& other) {
    return std::pair(one.object, one.triangle) < std::pair(other.object, other.triangle);
}

}  // namespace

Bvh::Bvh(std::vector<SceneTriangle> triangles) {
    // A ray meets no triangle without area; left in, rounding could make a hit of it
    std::erase_if(triangles, [](const SceneTriangle& t) { return areOnOneLine(t.a, t.b, t.c); });
    const BvhBuild build(triangles);
    triangles_.reserve(triangles.size());
    for (const std::uint32_t i : build.order) triangles_.push_back(triangles[i]);
    if (build.nodes.empty()) return;
    const Bounds& all = build.nodes.front().bounds;
    middle_ = all.middle();
    double half = 0;
    for (int axis = 0; axis < 3; ++axis) {
        extent_ = std::max({extent_, std::abs(all.low[axis]), std::abs(all.high[axis])});
        half = std::max({half, all.high[axis] - middle_[axis], middle_[axis] - all.low[axis]});
    }
    scale_ = std::ldexp(1, -std::clamp(std::ilogb(half) + 1, -1000, 1000));
    gather(build, 0);
}

// Makes a node of the children of a node of the binary tree, and of theirs, the largest first, as long as there is room.
std::uint32_t Bvh::gather(const BvhBuild& build, std::uint32_t from) {
    std::array<std::uint32_t, lanes> chosen{from};
    std::size_t count = 1;
    while (count < lanes) {
        std::size_t largest = lanes;
        for (std::size_t i = 0; i < count; ++i) {
            const auto& node = build.nodes[chosen[i]];
            if (node.count > 0) continue;
            if (largest == lanes || halfArea(node.bounds) > halfArea(build.nodes[chosen[largest]].bounds)) largest = i;
        }
        if (largest == lanes) break;
        const std::uint32_t first = build.nodes[chosen[largest]].first;
        chosen[largest] = first;
        chosen[count++] = first + 1;
    }
    const auto self = static_cast<std::uint32_t>(nodes_.size());
    nodes_.emplace_back();
    for (std::size_t i = 0; i < lanes; ++i) {
        const Bounds bounds = i < count ? build.nodes[chosen[i]].bounds : Bounds();
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto a = static_cast<int>(axis);
            nodes_[self].bounds[axis][i] = below((bounds.low[a] - middle_[a]) * scale_);
            nodes_[self].bounds[axis + 3][i] = -below((middle_[a] - bounds.high[a]) * scale_);
        }
        if (i >= count) continue;
        const BvhBuild::Node& node = build.nodes[chosen[i]];
        nodes_[self].count[i] = node.count;
        const std::uint32_t first = node.count > 0 ? node.first : gather(build, chosen[i]);
        nodes_[self].first[i] = first;
    }
    return self;
}

// A ray against boxes, four at once: the loops over them are what compilers make vector instructions of. Each box counts as
// larger by `room`, which is more than the triangle test can shift a corner by, and every rounding to float goes the way that
// makes the box larger: where a triangle is hit, so are the boxes around it. With o the origin and d the direction, t runs
// from (lo - o) / d to (hi - o) / d; each of the two has an o and a 1/d of its own, off by more than what rounds.
struct Bvh::RayBoxes {
    std::array<float, 3> entry{}, exit{}, toEntry{}, toExit{};
    std::array<std::size_t, 3> nearSide{}, farSide{};  // where a node's bounds have them
    double unit = 1;                                   // of the ray's t, in the boxes' t

    RayBoxes(const Ray& ray, const vec3& middle, double scale, double room) {
        const vec3 size = glm::abs(ray.direction), origin = (ray.origin - middle) * scale;
        const double largest = std::max({size.x, size.y, size.z});
        const auto aside = static_cast<float>(std::min(room * scale, 1e37));
        // No box is left out where float has no room for it, but those that are not there.
        const bool isFar =
            !(std::max({std::abs(origin.x), std::abs(origin.y), std::abs(origin.z), double(aside)}) < 1e30);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto i = static_cast<int>(axis);
            const bool backwards = std::signbit(ray.direction[i]);
            const float at = isFar ? 0 : static_cast<float>(origin[i]);
            const float off = isFar ? 1e37F : aside + slack * (std::abs(at) + aside) + FLT_MIN;
            // A ray for which it would be more is as good as parallel: t up to 1e38 times the room is beyond all boxes.
            const auto inverse = static_cast<float>(std::clamp(largest / ray.direction[i], -1e38, 1e38));
            entry[axis] = backwards ? at - off : at + off;
            exit[axis] = backwards ? at + off : at - off;
            toEntry[axis] = inverse * (1 - slack);
            toExit[axis] = inverse * (1 + slack);
            nearSide[axis] = backwards ? axis + 3 : axis;
            farSide[axis] = backwards ? axis : axis + 3;
        }
        unit = largest * scale;
    }

    // A t of the ray in the boxes' units, or somewhat more
    float endOf(double t) const {
        const double end = t * unit;
        return end < 1e30 ? static_cast<float>(end) * (1 + slack) + FLT_MIN : HUGE_VALF;
    }

    // The entries into the boxes, at least 0; infinity for boxes that are missed or lie beyond `end`.
    std::array<float, lanes> operator()(const Children& node, float end) const {
        std::array<float, lanes> near{}, far{end, end, end, end};
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto &nearest = node.bounds[nearSide[axis]], &farthest = node.bounds[farSide[axis]];
            for (std::size_t i = 0; i < lanes; ++i) {
                const float first = (nearest[i] - entry[axis]) * toEntry[axis];
                near[i] = first > near[i] ? first : near[i];
            }
            for (std::size_t i = 0; i < lanes; ++i) {
                const float last = (farthest[i] - exit[axis]) * toExit[axis];
                far[i] = last < far[i] ? last : far[i];
            }
        }
        for (std::size_t i = 0; i < lanes; ++i) near[i] = near[i] <= far[i] ? near[i] : HUGE_VALF;
        return near;
    }

  private:
    static constexpr float slack = 5e-7F;  // more than eight roundings
};

// How far rounding can shift the corners of a triangle seen from `origin`, with some to spare.
double Bvh::room(const vec3& origin) const {
    const vec3 size = glm::abs(origin);
    return 16 * std::numeric_limits<double>::epsilon() * (extent_ + std::max({size.x, size.y, size.z}));
}

// Calls visitTriangle with each triangle whose boxes the ray meets before `end`, the nearer box first, until it returns
// true. The call may lower `end`.
template <typename Visit>
void Bvh::visit(const Ray& ray, double& end, const Visit& visitTriangle) const {
    if (nodes_.empty()) return;
    struct Entry {
        std::uint32_t first, count;
        float near;
    };
    const RayBoxes boxes(ray, middle_, scale_, room(ray.origin));
    float nearEnd = boxes.endOf(end);
    std::array<Entry, stackSize> stack;
    std::size_t height = 0;
    stack[height++] = {0, 0, 0};
    while (height > 0) {
        const Entry entry = stack[--height];
        if (entry.near > nearEnd) continue;
        if (entry.count > 0) {
            const double before = end;
            for (std::uint32_t i = entry.first; i < entry.first + entry.count; ++i) {
                if (visitTriangle(triangles_[i])) return;
            }
            if (end != before) nearEnd = boxes.endOf(end);
            continue;
        }
        const Children& node = nodes_[entry.first];
        const std::array<float, lanes> near = boxes(node, nearEnd);
        const std::size_t bottom = height;
        for (std::size_t i = 0; i < lanes; ++i) {
            if (!(near[i] < HUGE_VALF)) continue;
            std::size_t place = height++;
            for (; place > bottom && stack[place - 1].near < near[i]; --place) stack[place] = stack[place - 1];
            stack[place] = {node.first[i], node.count[i], near[i]};
        }
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
    if (nodes_.empty()) return true;
    const double aside = room(origin) * scale_;
    const vec3 from = (origin - middle_) * scale_, near = lo * scale_, far = hi * scale_;
    std::array<std::uint32_t, stackSize> stack;
    std::size_t height = 0;
    stack[height++] = 0;
    while (height > 0) {
        const Children& node = nodes_[stack[--height]];
        for (std::size_t i = 0; i < lanes; ++i) {
            const auto& [loX, loY, loZ, hiX, hiY, hiZ] = node.bounds;
            if (!(loX[i] <= hiX[i]) || !mayPass(near, far, vec3(loX[i], loY[i], loZ[i]) - from - aside,
                                                vec3(hiX[i], hiY[i], hiZ[i]) - from + aside)) {
                continue;
            }
            if (node.count[i] == 0) stack[height++] = node.first[i];
            for (std::uint32_t k = node.first[i]; k < node.first[i] + node.count[i]; ++k) {
                if (found.size() == most) return false;
                found.push_back(&triangles_[k]);
            }
        }
    }
    return true;
}

}  // namespace mv

#include "mv/geometry/ray_caster.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <string>

#include "mv/error.h"
#include "mv/geometry/bounds.h"
#include "mv/geometry/bvh.h"
#include "mv/geometry/check.h"
#include "mv/math/require.h"
#include "mv/math/robust.h"
#include "mv/threads.h"

namespace mv {
namespace {

// Room for the products of four coordinates.
constexpr double largestCast = 1e70;

std::string nameOf(const SceneObject& object) { return "object '" + object.name + "'"; }

void requireObject(const SceneObject& object) {
    requireFinite(nameOf(object), "worldFromObject", object.worldFromObject);
    const mat4& m = object.worldFromObject;
    if (vec4(m[0].w, m[1].w, m[2].w, m[3].w) != vec4(0, 0, 0, 1)) {
        throw Error(nameOf(object), "the last row of worldFromObject must be 0 0 0 1",
                    vectorText(vec4(m[0].w, m[1].w, m[2].w, m[3].w)));
    }
    if (glm::determinant(mat3(m)) == 0) throw Error(nameOf(object), "worldFromObject must have an inverse");
    if (object.mesh.primitive == Primitive::lines || object.mesh.primitive == Primitive::points) {
        throw Error(nameOf(object), "must be made of triangles");
    }
}

// A triangle of the scene, and the normal of its front.
struct Surface {
    SceneTriangle corners;
    vec3 normal;  // unit length; 0 for a triangle without area
};

std::vector<Surface> surfacesOf(const SceneObject& object, int number) {
    requireObject(object);
    std::vector<vec3> world;
    world.reserve(object.mesh.positions.size());
    for (const fvec3& position : object.mesh.positions) {
        world.emplace_back(object.worldFromObject * vec4(position, 1));
        const vec3 size = glm::abs(world.back());
        if (std::max({size.x, size.y, size.z}) <= largestCast) continue;
        throw Error(nameOf(object), "coordinates must lie within " + numberText(largestCast), vectorText(world.back()));
    }
    // A mirror turns the winding round; outwards stays outwards.
    const double side = glm::determinant(mat3(object.worldFromObject)) < 0 ? -1 : 1;
    std::vector<Surface> surfaces;
    int triangle = 0;
    for (const auto& [i, j, k] : trianglesOf(object.mesh)) {
        const SceneTriangle corners{world[i], world[j], world[k], number, triangle++};
        const vec3 normal = accurateCross(corners.b - corners.a, corners.c - corners.a);
        surfaces.push_back({corners, normal == vec3(0) ? vec3(0) : side * unit(normal)});
    }
    return surfaces;
}

Bvh treeOf(const std::vector<std::vector<Surface>>& surfaces, const std::vector<bool>& chosen) {
    std::vector<SceneTriangle> triangles;
    for (std::size_t object = 0; object < surfaces.size(); ++object) {
        if (!chosen[object]) continue;
        for (const Surface& surface : surfaces[object]) {
            if (surface.normal != vec3(0)) triangles.push_back(surface.corners);
        }
    }
    return Bvh(std::move(triangles));
}

// The way from a surface point to a light: towards it, and how far, in lengths of `direction`.
struct WayToLight {
    vec3 direction{0, 0, 0};
    double end = 1;
};

WayToLight wayToLight(const vec3& point, const vec4& light) {
    if (light.w == 0) return {vec3(light), std::numeric_limits<double>::infinity()};
    return {vec3(light) / light.w - point, 1};
}

// The part of a line of sight between the near and the far plane.
struct Sight {
    Ray ray;
    double end = std::numeric_limits<double>::infinity();
};

Sight sightThrough(const mat4& worldFromClip, double x, double y) {
    vec4 near = worldFromClip * vec4(x, y, -1, 1), far = worldFromClip * vec4(x, y, 1, 1);
    if (near.w < 0) near = -near, far = -far;
    // far/far.w - near/near.w times both w, so that a far plane at infinity (far.w = 0) is no special case.
    const double both = near.w * far.w;
    return {{vec3(near) / near.w, vec3(far) * near.w - vec3(near) * far.w},
            both > 0 ? 1 / both : std::numeric_limits<double>::infinity()};
}

void requireSide(const char* name, int value, int most) { requireRange("lit", name, value, 1, most); }

// The things that a thread keeps from one point to the next. The thread counts each ray here, so this stands alone in
// its cache lines (processors fetch two of 64 bytes at once): beside what the other threads read, each count would cost
// them a fetch.
struct alignas(128) Scratch {
    std::vector<const SceneTriangle*> near;
    long rays = 0;
};

// A light as the points it is asked at: the centres of side x side cells.
struct LightPoints {
    std::vector<vec4> points;
    Bounds bounds;  // of a light that is not at infinity

    LightPoints(const SceneLight& light, int side) {
        for (int i = 0; i < side * side; ++i) {
            const int row = i / side, column = i % side;
            const double s = (2 * column + 1.0) / side - 1, t = (2 * row + 1.0) / side - 1;
            points.push_back(light.position + light.position.w * vec4(s * light.halfU + t * light.halfV, 0));
            requireFinite("lit", "each point of the light", points.back());
            if (points.back().w == 0) continue;
            points.back() /= points.back().w;
            bounds.add(vec3(points.back()));
        }
    }
    bool hasShaft() const { return points.size() >= 4 && points.front().w != 0; }
};

// As many triangles as are asked one by one rather than by the tree
constexpr std::size_t mostInShaft = 32;

// Whether one of a few triangles stands in the way. The one that does comes to the front: the next way is much like it.
bool blockedByOne(const Ray& ray, double end, const SceneHit& hit, std::vector<const SceneTriangle*>& few) {
    const TriangleTest<double> test(ray);
    for (auto& triangle : few) {
        if (triangle->object == hit.object && triangle->triangle == hit.triangle) continue;
        const auto met = test(triangle->a, triangle->b, triangle->c);
        if (!met || met->t >= end) continue;
        std::swap(triangle, few.front());
        return true;
    }
    return false;
}

}  // namespace

struct RayCaster::State {
    std::vector<std::vector<Surface>> surfaces;
    std::vector<bool> receives;
    std::vector<SceneLight> lights;
    mat4 clipFromWorld;
    Bvh all, casters;

    std::optional<SceneHit> nearest(const Ray& ray, double end) const;
    vec3 startOf(const SceneHit& hit, const vec3& direction) const;
    double litPart(const SceneHit& hit, const LightPoints& light, Scratch& scratch) const;
    void requireHit(const SceneHit& hit) const;
};

std::optional<SceneHit> RayCaster::State::nearest(const Ray& ray, double end) const {
    const auto found = all.nearest(ray, end);
    if (!found) return {};
    const SceneTriangle& corners = *found->triangle;
    // Computed by the corners' weights, not by t: the point is then as near the triangle as its coordinates, however
    // far the ray came.
    const vec3 point = found->hit.a * corners.a + found->hit.b * corners.b + found->hit.c * corners.c;
    const auto object = static_cast<std::size_t>(corners.object), triangle = static_cast<std::size_t>(corners.triangle);
    return SceneHit{found->hit.t, corners.object, corners.triangle, point, surfaces[object][triangle].normal};
}

// The point of the hit, moved off its triangle to the side of `direction`: it lies off it by at most 8 roundings of the
// corners' coordinates, and above that a ray is clear of the triangle's neighbours too.
vec3 RayCaster::State::startOf(const SceneHit& hit, const vec3& direction) const {
    const SceneTriangle& corners =
        surfaces[static_cast<std::size_t>(hit.object)][static_cast<std::size_t>(hit.triangle)].corners;
    const vec3 size = glm::max(glm::abs(corners.a), glm::max(glm::abs(corners.b), glm::abs(corners.c)));
    return besideSurface(hit.point, hit.normal, direction, size, 8);
}

// The part of the light that reaches the point. All triangles that may stand in the way of an area light are asked for
// at once: often it is nothing, and seldom much.
double RayCaster::State::litPart(const SceneHit& hit, const LightPoints& light, Scratch& scratch) const {
    const vec3 start = startOf(hit, hit.normal);
    const bool few = light.hasShaft() && casters.mayMeet(start, light.bounds.low - hit.point,
                                                         light.bounds.high - hit.point, mostInShaft, scratch.near);
    const bool free = !receives[static_cast<std::size_t>(hit.object)] || (few && scratch.near.empty());
    int reached = 0;
    for (const vec4& point : light.points) {
        const WayToLight way = wayToLight(hit.point, point);
        if (!(glm::dot(hit.normal, way.direction) > 0)) continue;
        ++scratch.rays;
        const Ray ray{start, way.direction};
        const bool blocked = !free && (few ? blockedByOne(ray, way.end, hit, scratch.near)
                                           : casters.any(ray, way.end, hit.object, hit.triangle) != nullptr);
        reached += blocked ? 0 : 1;
    }
    return reached / static_cast<double>(light.points.size());
}

void RayCaster::State::requireHit(const SceneHit& hit) const {
    const bool known = hit.object >= 0 && hit.object < static_cast<int>(surfaces.size()) && hit.triangle >= 0 &&
                       hit.triangle < static_cast<int>(surfaces[static_cast<std::size_t>(hit.object)].size());
    if (known) return;
    throw Error("inShadow", "the hit must be of this scene",
                "object " + std::to_string(hit.object) + ", triangle " + std::to_string(hit.triangle));
}

RayCaster::RayCaster(const Scene& scene) {
    std::vector<std::vector<Surface>> surfaces;
    std::vector<bool> all, casts, receives;
    for (const SceneObject& object : scene.objects) {
        surfaces.push_back(surfacesOf(object, static_cast<int>(surfaces.size())));
        all.push_back(true);
        casts.push_back(object.casts);
        receives.push_back(object.receives);
    }
    Bvh allTree = treeOf(surfaces, all), castersTree = treeOf(surfaces, casts);
    state_ = std::make_unique<State>(State{std::move(surfaces), std::move(receives), scene.lights,
                                           scene.clipFromWorld(), std::move(allTree), std::move(castersTree)});
}

RayCaster::~RayCaster() = default;
RayCaster::RayCaster(RayCaster&&) noexcept = default;
RayCaster& RayCaster::operator=(RayCaster&&) noexcept = default;

std::optional<SceneHit> RayCaster::nearest(const Ray& ray) const {
    requireFinite("nearest", "the origin", ray.origin);
    requireFinite("nearest", "the direction", ray.direction);
    if (ray.direction == vec3(0)) throw Error("nearest", "the direction must not be 0");
    return state_->nearest(ray, std::numeric_limits<double>::infinity());
}

bool RayCaster::inShadow(const SceneHit& hit, const vec4& light) const {
    state_->requireHit(hit);
    requireFinite("inShadow", "light", light);
    if (light == vec4(0)) throw Error("inShadow", "light must be a point or a direction", vectorText(light));
    const WayToLight way = wayToLight(hit.point, light);
    return state_->casters.any({state_->startOf(hit, way.direction), way.direction}, way.end, hit.object,
                               hit.triangle) != nullptr;
}

LitPicture RayCaster::lit(int width, int height, const LitOptions& options) const {
    requireSide("width", width, 16384);
    requireSide("height", height, 16384);
    requireSide("lightSide", options.lightSide, 1024);
    requireSide("pixelSide", options.pixelSide, 1024);
    requireRange("lit", "threads", options.threads, 0, 1024);
    const State& state = *state_;
    if (options.light < 0 || options.light >= static_cast<int>(state.lights.size())) {
        throw Error("lit", "the scene must have the light that is asked for", std::to_string(options.light));
    }
    const SceneLight& light = state.lights[static_cast<std::size_t>(options.light)];
    if (light.position == vec4(0)) {
        throw Error("lit", "the light must be a point or a direction", vectorText(light.position));
    }
    const LightPoints lightPoints(light, options.lightSide);
    const mat4 worldFromClip = glm::inverse(state.clipFromWorld);
    if (!isFinite(worldFromClip)) throw Error("lit", "clipFromWorld must be finite and have an inverse");

    LitPicture picture{width, height, {}, {}, {}, 0};
    const auto pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    picture.lit.assign(pixels, 0);
    picture.object.assign(pixels, -1);
    std::vector<char> faces(pixels, 0);  // neighbouring bits of a vector<bool> are not two threads' to write
    std::atomic<long> rays = 0;

    const auto castRow = [&](int row, Scratch& scratch) {
        const auto seenAt = [&](double x, double y) {
            ++scratch.rays;
            const Sight sight = sightThrough(worldFromClip, 2 * x / width - 1, 1 - 2 * y / height);
            return state.nearest(sight.ray, sight.end);
        };
        for (int column = 0; column < width; ++column) {
            const auto middle = seenAt(column + 0.5, row + 0.5);
            if (!middle) continue;
            const auto pixel =
                static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column);
            picture.object[pixel] = middle->object;
            const WayToLight way = wayToLight(middle->point, light.position);
            faces[pixel] = glm::dot(middle->normal, way.direction) > 0;
            double sum = 0;
            int points = 0;
            const int side = options.pixelSide;
            for (int i = 0; i < side * side; ++i) {
                const int x = i % side, y = i / side;
                const bool isMiddle = 2 * x + 1 == side && 2 * y + 1 == side;
                const auto seen = isMiddle ? middle : seenAt(column + (x + 0.5) / side, row + (y + 0.5) / side);
                if (!seen || seen->object != middle->object) continue;
                sum += state.litPart(*seen, lightPoints, scratch);
                ++points;
            }
            picture.lit[pixel] = points > 0 ? sum / points : state.litPart(*middle, lightPoints, scratch);
        }
    };

    // Each thread takes the next row that nobody has; this one tells how far all are.
    std::atomic<int> nextRow = 0, rowsDone = 0;
    const auto castRows = [&](const Progress& progress) {
        Scratch scratch;
        for (int row = nextRow++; row < height; row = nextRow++) {
            castRow(row, scratch);
            ++rowsDone;
            if (progress) progress(static_cast<double>(rowsDone) / height);
        }
        rays += scratch.rays;
    };
    const int threads = std::min(sharing(options.threads), height);
    {
        Helpers helpers;
        for (int i = 1; i < threads; ++i) helpers.start(castRows, Progress());
        try {
            castRows(options.progress);
        } catch (...) {
            nextRow = height;
            throw;
        }
    }
    if (options.progress) options.progress(1);
    picture.faces.assign(faces.begin(), faces.end());
    picture.rays = rays;
    return picture;
}

}  // namespace mv

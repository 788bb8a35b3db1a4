#include "bench/embree.h"

#include <embree3/rtcore.h>

#include <limits>

#include "mv/geometry/check.h"

namespace mv::bench {
namespace {

constexpr unsigned forSights = 1, forShadows = 2;  // bits of a geometry's mask

void addObject(RTCDevice device, RTCScene scene, const SceneObject& object) {
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    const auto triangles = trianglesOf(object.mesh);
    auto* positions = static_cast<float*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), object.mesh.positions.size()));
    for (const fvec3& position : object.mesh.positions) {
        const vec4 world = object.worldFromObject * vec4(position, 1);
        for (int axis = 0; axis < 3; ++axis) *positions++ = static_cast<float>(world[axis]);
    }
    auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                   3 * sizeof(unsigned), triangles.size()));
    for (const auto& triangle : triangles) {
        for (const auto index : triangle) *indices++ = index;
    }
    rtcSetGeometryMask(geometry, object.casts ? forSights | forShadows : forSights);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene, geometry);
    rtcReleaseGeometry(geometry);
}

RTCRay rayFrom(const vec3& origin, const vec3& direction, float near, float far, unsigned mask) {
    RTCRay ray{};
    ray.org_x = static_cast<float>(origin.x);
    ray.org_y = static_cast<float>(origin.y);
    ray.org_z = static_cast<float>(origin.z);
    ray.dir_x = static_cast<float>(direction.x);
    ray.dir_y = static_cast<float>(direction.y);
    ray.dir_z = static_cast<float>(direction.z);
    ray.tnear = near;
    ray.tfar = far;
    ray.mask = mask;
    return ray;
}

}  // namespace

struct Embree::State {
    RTCDevice device = rtcNewDevice("threads=1");
    // Two scenes, as the reference has two trees: what does not cast is not asked about shadows.
    RTCScene sights = rtcNewScene(device), casters = rtcNewScene(device);
    ~State() {
        rtcReleaseScene(sights);
        rtcReleaseScene(casters);
        rtcReleaseDevice(device);
    }
};

bool Embree::isThere() { return true; }

Embree::Embree(const Scene& scene) : state_(std::make_unique<State>()) {
    // As watertight as the reference.
    for (RTCScene each : {state_->sights, state_->casters}) rtcSetSceneFlags(each, RTC_SCENE_FLAG_ROBUST);
    for (const SceneObject& object : scene.objects) {
        addObject(state_->device, state_->sights, object);
        if (object.casts) addObject(state_->device, state_->casters, object);
    }
    rtcCommitScene(state_->sights);
    rtcCommitScene(state_->casters);
}

Embree::~Embree() = default;

double Embree::countNearest(const std::vector<Ray>& rays) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    double count = 0;
    for (const Ray& ray : rays) {
        RTCRayHit query{};
        query.ray = rayFrom(ray.origin, ray.direction, 0, std::numeric_limits<float>::infinity(), forSights);
        query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(state_->sights, &context, &query);
        count += query.hit.geomID != RTC_INVALID_GEOMETRY_ID ? 1 : 0;
    }
    return count;
}

double Embree::countShadow(const std::vector<SceneHit>& hits, const vec3& light) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    double count = 0;
    for (const SceneHit& hit : hits) {
        // A thousandth of the way is left out, as float programs do.
        RTCRay ray = rayFrom(hit.point, light - hit.point, 1e-3F, 1, forShadows);
        rtcOccluded1(state_->casters, &context, &ray);
        count += ray.tfar < 0 ? 1 : 0;
    }
    return count;
}

}  // namespace mv::bench

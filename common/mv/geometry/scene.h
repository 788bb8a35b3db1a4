// A scene: what GL draws and what the ray caster sees, described once.
//
// Demos upload each object's mesh and draw it with clipFromWorld() * worldFromObject; the ray caster casts the same
// triangles through the same matrix. There are never two descriptions of one scene that could disagree.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "mv/geometry/mesh_data.h"

namespace mv {

struct SceneObject {
    std::string name;
    MeshData mesh;            // triangles, in object space; what casts is closed
    mat4 worldFromObject{1};  // with an inverse
    vec3 color{0.8, 0.8, 0.8};
    bool casts = true;     // throws a shadow
    bool receives = true;  // shows shadows
    bool operator==(const SceneObject&) const = default;
};

// A light that is a point (w = 1), at infinity (w = 0: the direction towards it), or the parallelogram
// position + s halfU + t halfV with s, t in -1..1. One with an aim has a shade, which lets it shine about that way only
// (unit length); the shade is an object like others.
struct SceneLight {
    vec4 position{0, 1, 0, 1};
    vec3 color{1, 1, 1};
    vec3 halfU{0, 0, 0}, halfV{0, 0, 0};
    std::optional<vec3> aim = {};
    bool operator==(const SceneLight&) const = default;
};

// Which object of a scene: what moves one or asks about one says its name, not its number.
struct ObjectId {
    std::size_t index;
};

struct Scene {
    std::vector<SceneObject> objects;
    SceneObject& operator[](ObjectId id) { return objects.at(id.index); }
    const SceneObject& operator[](ObjectId id) const { return objects.at(id.index); }
    std::vector<SceneLight> lights;
    mat4 viewFromWorld{1};
    mat4 clipFromView{1};
    mat4 clipFromWorld() const { return clipFromView * viewFromWorld; }
    bool operator==(const Scene&) const = default;
};

// The places of the casters: with the light's place, all that the shadow map or the shadow volumes of a scene are made
// for.
std::vector<mat4> casterPlaces(const Scene& scene);

// A scene's perspective from other depths on: from `near` to `far`, which may be infinity, for shadow volumes, which a far
// plane would cut off. Error: not a perspective, or depths that perspective() refuses.
mat4 withDepths(const mat4& clipFromView, double near, double far);

// All objects of a scene as one mesh in world space, for a scene that does not move in itself: one draw instead of many.
// Triangles without indices, with positions and colors, and with unit normals where every object has them. Refused: an
// object that is not made of triangles, a position in the world beyond float's range, and what validate refuses.
MeshData meshOf(const Scene& scene);

}  // namespace mv

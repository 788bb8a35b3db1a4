// A scene: what GL draws and what the ray caster sees, described once.
//
// Demos upload each object's mesh and draw it with clipFromWorld() * worldFromObject; the ray caster casts the same
// triangles through the same matrix. There are never two descriptions of one scene that could disagree.
#pragma once
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
};

// A light that is a point (w = 1), at infinity (w = 0: the direction towards it), or the parallelogram
// position + s halfU + t halfV with s, t in -1..1.
struct SceneLight {
    vec4 position{0, 1, 0, 1};
    vec3 color{1, 1, 1};
    vec3 halfU{0, 0, 0}, halfV{0, 0, 0};
};

struct Scene {
    std::vector<SceneObject> objects;
    std::vector<SceneLight> lights;
    mat4 viewFromWorld{1};
    mat4 clipFromView{1};
    mat4 clipFromWorld() const { return clipFromView * viewFromWorld; }
};

// A scene's perspective from other depths on: from `near` to `far`, which may be infinity, for shadow volumes, which a far
// plane would cut off. Error: not a perspective, or depths that perspective() refuses.
mat4 withDepths(const mat4& clipFromView, double near, double far);

// All objects of a scene as one mesh in world space, for a scene that does not move in itself: one draw instead of many.
// Triangles without indices, with positions and colors, and with unit normals where every object has them. Refused: an
// object that is not made of triangles, a position in the world beyond float's range, and what validate refuses.
MeshData meshOf(const Scene& scene);

}  // namespace mv

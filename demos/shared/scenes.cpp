#include "shared/scenes.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "mv/geometry/shapes.h"
#include "mv/math/projection.h"
#include "mv/math/require.h"
#include "mv/math/transform.h"

namespace mv {
namespace {

// A floor or a wall: nothing is behind it, so it casts no shadow that could be seen.
SceneObject ground(const std::string& name, double sizeX, double sizeZ, const mat4& worldFromObject,
                   const vec3& color) {
    return {name, grid(1, 1, sizeX, sizeZ), worldFromObject, color, false, true};
}

SceneObject solid(const std::string& name, MeshData mesh, const mat4& worldFromObject, const vec3& color) {
    return {name, std::move(mesh), worldFromObject, color, true, true};
}

// A box that stands on y = 0.
MeshData standingBox(double sizeX, double sizeY, double sizeZ) {
    return box({-sizeX / 2, 0, -sizeZ / 2}, {sizeX / 2, sizeY, sizeZ / 2});
}

// The prism over a convex polygon from x0 to x1: corners (z, y), counter-clockwise seen from -x, where z is to the right.
MeshData prismAlongX(const std::vector<vec2>& corners, double x0, double x1) {
    MeshData mesh;
    const auto add = [&](const vec3& a, const vec3& b, const vec3& c) {
        for (const vec3& p : {a, b, c}) {
            mesh.positions.emplace_back(p);
            mesh.normals.emplace_back(glm::normalize(glm::cross(b - a, c - a)));
        }
    };
    const auto at = [&](double x, std::size_t i) {
        const vec2& corner = corners[i % corners.size()];
        return vec3(x, corner.y, corner.x);
    };
    for (std::size_t i = 0; i < corners.size(); ++i) {
        add(at(x0, i), at(x1, i), at(x0, i + 1));
        add(at(x1, i), at(x1, i + 1), at(x0, i + 1));
        if (i == 0 || i + 1 == corners.size()) continue;
        add(at(x0, 0), at(x0, i), at(x0, i + 1));
        add(at(x1, 0), at(x1, i + 1), at(x1, i));
    }
    return mesh;
}

// A projection of `fovy` degrees that is as wide as a picture of 4:3 at least: a narrower one gains above and below.
mat4 projectionFor(double aspect, double fovy, double near, double far, double leastAspect = 4.0 / 3) {
    requirePositive("scene", "aspect", aspect);
    const double across = std::tan(radians(fovy) / 2) * leastAspect;
    const double shown = aspect < leastAspect ? 2 * degrees(std::atan(across / aspect)) : fovy;
    return perspective(shown, aspect, near, far);
}

}  // namespace

Scene floorAlone(double aspect) {
    Scene scene;
    scene.objects = {ground("floor", 20, 20, mat4(1), {0.80, 0.78, 0.72})};
    scene.lights = {{.position = vec4(-2.2, 3.6, 1.4, 1)}};
    scene.viewFromWorld = lookAt({0.4, 3.7, 4.8}, {0.4, 0.25, 0}, {0, 1, 0});
    scene.clipFromView = projectionFor(aspect, 40, 0.5, 20);
    return scene;
}

Scene cubeOnPlane(double aspect) {
    Scene scene = floorAlone(aspect);
    scene.objects.push_back(solid("cube", standingBox(1, 1, 1), rotateY(30), {0.85, 0.35, 0.25}));
    return scene;
}

Scene nestedShells(double aspect, int shells) {
    Scene scene = floorAlone(aspect);
    for (int i = 0; i < shells; ++i) {
        const double half = 0.2 + 0.35 * (i + 1) / shells;
        scene.objects.push_back(solid("shell " + std::to_string(i + 1), box(vec3(-half), vec3(half)),
                                      translate(0, 0.8, 0) * rotateY(30), {0.30, 0.52, 0.78}));
    }
    return scene;
}

Scene sphereAndCube(double aspect) {
    Scene scene;
    scene.objects = {
        ground("floor", 20, 20, mat4(1), {0.5, 0.5, 1}),
        solid("sphere", sphere(1, 32, 24), translate(2, 3, 4), {1, 0.5, 0.5}),
        solid("cube", box({-1, -1, -1}, {1, 1, 1}), translate(3, 1, 0), {0.5, 1, 0.5}),
    };
    scene.lights = {{.position = vec4(2.5, 4.8, 4.3, 1)}};
    scene.viewFromWorld = lookAt({6, 5, 7}, {0, 0, 0}, {0, 1, 0});
    scene.clipFromView = projectionFor(aspect, 60, 1, 2000, 1);
    return scene;
}

Scene stillLife(double aspect) {
    // Foot, collar and head, in units of which the pawn is 1.5 high
    const std::vector<vec2> pawn{{0, 0},       {0.42, 0},    {0.44, 0.05},  {0.43, 0.14},  {0.36, 0.20}, {0.34, 0.26},
                                 {0.25, 0.36}, {0.19, 0.50}, {0.155, 0.70}, {0.145, 0.88}, {0.27, 0.93}, {0.285, 0.97},
                                 {0.25, 1.01}, {0.16, 1.04}, {0.21, 1.10},  {0.247, 1.18}, {0.25, 1.25}, {0.235, 1.33},
                                 {0.19, 1.41}, {0.12, 1.47}, {0.06, 1.493}, {0, 1.5}};
    // A ring that stands on the floor and leans on the wall, touching both
    constexpr double wallZ = -1.6, ringRadius = 0.62, tubeRadius = 0.17, lean = 18;
    const double ringHeight = ringRadius * std::cos(radians(lean)) + tubeRadius;
    const double ringZ = wallZ + ringRadius * std::sin(radians(lean)) + tubeRadius;

    // Made once: a scene is asked for in every frame
    static const MeshData pawnMesh = lathe(pawn, 64), ringMesh = torus(ringRadius, tubeRadius, 96, 48),
                          ballMesh = sphere(0.42, 96, 48);
    Scene scene;
    scene.objects = {
        ground("floor", 9, 7, translate(0, 0, wallZ + 3.5), {0.72, 0.66, 0.58}),
        ground("wall", 9, 5, translate(0, 2.5, wallZ) * rotateX(90), {0.82, 0.82, 0.78}),
        solid("pawn", pawnMesh, translate(-1.0, 0, 0.15), {0.93, 0.87, 0.74}),
        solid("ring", ringMesh, translate(0.10, ringHeight, ringZ) * rotateX(90 - lean), {0.85, 0.55, 0.20}),
        solid("sphere", ballMesh, translate(0.58, 0.42, 0.25), {0.30, 0.52, 0.78}),
        solid("box", standingBox(0.8, 1.05, 0.6), translate(1.45, 0, -0.55) * rotateY(-28), {0.45, 0.62, 0.42}),
    };
    scene.lights = {{.position = vec4(-3.4, 4.2, 2.6, 1)}};
    scene.viewFromWorld = lookAt({0.35, 2.5, 5.6}, {0.35, 0.62, -0.4}, {0, 1, 0});
    scene.clipFromView = projectionFor(aspect, 30, 1, 20);
    return scene;
}

Scene table(double aspect) {
    constexpr double topY = 0.72, thickness = 0.04, halfX = 0.75, halfZ = 0.42, legSide = 0.06;
    const vec3 wood{0.72, 0.50, 0.30};
    const std::vector<vec2> vase{{0, 0},        {0.05, 0},     {0.055, 0.01}, {0.07, 0.05},  {0.085, 0.10},
                                 {0.085, 0.14}, {0.07, 0.19},  {0.045, 0.23}, {0.035, 0.26}, {0.04, 0.29},
                                 {0.055, 0.31}, {0.049, 0.31}, {0.03, 0.28},  {0.028, 0.26}, {0.038, 0.225},
                                 {0.06, 0.18},  {0, 0.17}};
    static const MeshData vaseMesh = lathe(vase, 64), appleMesh = sphere(0.06, 64, 32);
    Scene scene;
    scene.objects = {
        ground("floor", 20, 20, mat4(1), {0.78, 0.78, 0.80}),
        solid("top", box({-halfX, topY - thickness, -halfZ}, {halfX, topY, halfZ}), mat4(1), wood),
    };
    for (int i = 0; i < 4; ++i) {
        const double x = (i % 2 == 0 ? -1 : 1) * (halfX - 0.08), z = (i < 2 ? 1 : -1) * (halfZ - 0.08);
        scene.objects.push_back(solid("leg " + std::to_string(i + 1), standingBox(legSide, topY - thickness, legSide),
                                      translate(x, 0, z), wood));
    }
    scene.objects.push_back(solid("vase", vaseMesh, translate(-0.35, topY, -0.05), {0.35, 0.55, 0.70}));
    scene.objects.push_back(solid("apple", appleMesh, translate(0.05, topY + 0.06, 0.15), {0.80, 0.25, 0.20}));
    scene.objects.push_back(
        solid("book", standingBox(0.26, 0.045, 0.19), translate(0.40, topY, 0) * rotateY(20), {0.30, 0.45, 0.35}));
    scene.lights = {{.position = vec4(-1.5, 2.3, 1.3, 1), .halfU = {0.2, 0, 0}, .halfV = {0, 0, 0.2}}};
    scene.viewFromWorld = lookAt({1.5, 2.0, 3.1}, {0.22, 0.38, 0}, {0, 1, 0});
    scene.clipFromView = projectionFor(aspect, 32, 0.5, 20);
    return scene;
}

namespace {

constexpr double roomFloorZ = -1.0125, roomWallX = -3;
// y up becomes z up, and a wall that faces +z faces +x.
const mat4 roomFromUpright(vec4(0, 1, 0, 0), vec4(0, 0, 1, 0), vec4(1, 0, 0, 0), vec4(0, 0, 0, 1));

void addRoom(Scene& scene) {
    constexpr float width = 14, depth = 12, height = 8;
    const mat4 edge = translate(roomWallX, 0, roomFloorZ) * roomFromUpright;
    SceneObject floor = ground("floor", width, depth, edge, {0.80, 0.76, 0.68});
    for (fvec3& position : floor.mesh.positions) position.z += depth / 2;
    SceneObject wall = ground("wall", width, height, edge * rotateX(90), {0.78, 0.82, 0.86});
    for (fvec3& position : wall.mesh.positions) position.z -= height / 2;
    scene.objects.push_back(floor);
    scene.objects.push_back(wall);
}

}  // namespace

Scene cubeInRoom() {
    Scene scene;
    scene.objects = {{.name = "cube", .mesh = box(vec3(-1), vec3(1))}};
    // Its faces in the order of box(): +z, +x, -y, +y, -z, -x
    for (const fvec3& face : {fvec3(1, 0, 0), {0, 1, 1}, {1, 1, 0}, {0, 1, 0}, {1, 0, 1}, {0, 0, 1}})
        scene.objects[0].mesh.colors.insert(scene.objects[0].mesh.colors.end(), 6, fvec4(face, 1));
    addRoom(scene);
    return scene;
}

Scene stillLifeInRoom() {
    Scene scene;
    const Scene life = stillLife(1);
    for (const SceneObject& object : life.objects) {
        if (!object.casts) continue;
        scene.objects.push_back(object);
        // Its wall is 1.6 behind the middle; ours is 3.
        scene.objects.back().worldFromObject =
            translate(0, 0, roomFloorZ) * roomFromUpright * scale(-roomWallX / 1.6) * object.worldFromObject;
    }
    addRoom(scene);
    return scene;
}

Scene house() {
    constexpr double eaves = 3, ridge = 6, halfDepth = 3, overhang = 0.5, thickness = 0.25;
    // The roof's underside starts at the ridge and touches the walls' upper edges
    const double slope = (ridge - thickness - eaves) / halfDepth, low = eaves - slope * overhang;
    const double edge = halfDepth + overhang;
    const vec3 plaster{0.93, 0.88, 0.76}, tiles{0.78, 0.36, 0.26}, glass{0.62, 0.78, 0.88}, wood{0.42, 0.56, 0.44};
    Scene scene;
    scene.objects = {
        solid("walls",
              prismAlongX(
                  {{-halfDepth, 0}, {halfDepth, 0}, {halfDepth, eaves}, {0, ridge - thickness}, {-halfDepth, eaves}},
                  -4, 4),
              mat4(1), plaster),
        solid("roof front",
              prismAlongX({{0, ridge - thickness}, {edge, low}, {edge, low + thickness}, {0, ridge}}, -4.5, 4.5),
              mat4(1), tiles),
        solid("roof back",
              prismAlongX({{0, ridge}, {-edge, low + thickness}, {-edge, low}, {0, ridge - thickness}}, -4.5, 4.5),
              mat4(1), tiles),
        solid("chimney", box({1.9, 4, -1.9}, {2.8, 6.75, -1}), mat4(1), {0.72, 0.48, 0.40}),
        solid("garage", box({4, 0, -3}, {7, 2.5, 1}), mat4(1), {0.80, 0.80, 0.76}),
        solid("gate", box({4.4, 0, 1}, {6.6, 2, 1.05}), mat4(1), wood),
        solid("door", box({-3.1, 0, 3}, {-2.1, 2.1, 3.05}), mat4(1), wood),
        solid("window 1", box({-1.2, 0.9, 3}, {0.3, 2.2, 3.05}), mat4(1), glass),
        solid("window 2", box({1.5, 0.9, 3}, {3, 2.2, 3.05}), mat4(1), glass),
        solid("window 3", box({4, 3.1, -0.6}, {4.05, 4.3, 0.6}), mat4(1), glass),
    };
    return scene;
}

Scene garden() {
    Scene tree;
    tree.objects = {
        solid("trunk", standingBox(0.4, 1.2, 0.4), mat4(1), {0.45, 0.32, 0.22}),
        solid("crown", lathe(std::vector<vec2>{{0, 1}, {1.3, 1}, {0, 5}}, 24), mat4(1), {0.30, 0.55, 0.32}),
    };
    const MeshData treeMesh = meshOf(tree);
    Scene scene;
    scene.objects = {solid("house", meshOf(house()), translate(-1.5, 0, -20), vec3(1))};
    for (int row = 0; row < 7; ++row) {
        for (const double x : {-13.0, -7.5, 7.5, 13.0}) {
            scene.objects.push_back(solid("tree " + std::to_string(scene.objects.size()), treeMesh,
                                          translate(x, 0, -4.0 - 6 * row), vec3(1)));
        }
    }
    return scene;
}

}  // namespace mv

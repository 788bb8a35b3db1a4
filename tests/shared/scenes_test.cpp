#include "shared/scenes.h"

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "../math/support.h"
#include "mv/geometry/bounds.h"
#include "mv/geometry/check.h"
#include "mv/geometry/ray_caster.h"
#include "mv/geometry/shapes.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

using namespace mv;
using namespace mv::test;

namespace {

struct NamedScene {
    std::string name;
    Scene (*make)(double aspect);
};
const std::vector<NamedScene> scenes{{"cubeOnPlane", cubeOnPlane}, {"stillLife", stillLife}, {"table", table}};
// With the one that has a sky.
const std::vector<NamedScene> allScenes{
    {"cubeOnPlane", cubeOnPlane}, {"sphereAndCube", sphereAndCube}, {"stillLife", stillLife}, {"table", table}};

std::vector<vec3> worldPositions(const SceneObject& object) {
    std::vector<vec3> positions;
    for (const fvec3& position : object.mesh.positions)
        positions.emplace_back(object.worldFromObject * vec4(position, 1));
    return positions;
}

TEST(Scenes, CastersAreClosedFaceOutwardsAndStandOnTheFloor) {
    for (const auto& [name, make] : allScenes) {
        std::set<std::string> names;
        for (const SceneObject& object : make(4.0 / 3).objects) {
            EXPECT_TRUE(names.insert(object.name).second) << name << ": " << object.name;
            EXPECT_FALSE(object.name.empty()) << name;
            EXPECT_TRUE(object.receives) << name;
            EXPECT_FALSE(object.mesh.normals.empty()) << object.name;
            EXPECT_GT(glm::determinant(object.worldFromObject), 0) << object.name;
            if (!object.casts) continue;
            EXPECT_TRUE(isClosed(object.mesh)) << object.name;
            EXPECT_GT(signedVolume(object.mesh), 0) << object.name;
            // Nothing reaches through the floor: the ring, turned, is down to it within a rounding of its floats.
            for (const vec3& p : worldPositions(object)) EXPECT_GE(p.y, -1e-6) << object.name;
        }
    }
}

TEST(Scenes, CastersAreInTheViewAtEveryAspect) {
    for (const auto& [name, make] : allScenes) {
        for (const double aspect : {0.4, 1.0, 4.0 / 3, 2.5}) {
            const Scene scene = make(aspect);
            for (const SceneObject& object : scene.objects) {
                if (!object.casts) continue;
                for (const vec3& p : worldPositions(object)) {
                    const vec4 clip = scene.clipFromWorld() * vec4(p, 1);
                    EXPECT_LT(std::max({std::abs(clip.x), std::abs(clip.y), std::abs(clip.z)}), clip.w)
                        << name << " at " << aspect << ": " << object.name;
                }
            }
        }
    }
}

// The picture a class is shown: every object is seen, nothing but the scene is, and a good part of it is in shadow.
TEST(Scenes, ShowEveryObjectAndAShadow) {
    for (const auto& [name, make] : scenes) {
        const Scene scene = make(4.0 / 3);
        const LitPicture picture = RayCaster(scene).lit(160, 120);
        std::vector<int> seen(scene.objects.size(), 0);
        int shadow = 0;
        for (std::size_t i = 0; i < picture.object.size(); ++i) {
            ASSERT_GE(picture.object[i], 0) << name;
            ++seen[static_cast<std::size_t>(picture.object[i])];
            shadow += picture.faces[i] && picture.lit[i] == 0 ? 1 : 0;
        }
        for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_GT(seen[i], 10) << name << ": " << scene.objects[i].name;
        // As measured: 2.5 % of cubeOnPlane, 11 % of stillLife, 16 % of table.
        EXPECT_GT(shadow, 160 * 120 / 60) << name;
        EXPECT_LT(shadow, 160 * 120 / 4) << name;
    }
}

TEST(Scenes, TheRingTouchesFloorAndWall) {
    const Scene scene = stillLife(1);
    double lowest = HUGE_VAL, rearmost = HUGE_VAL;
    for (const SceneObject& object : scene.objects) {
        if (object.name != "ring") continue;
        for (const vec3& p : worldPositions(object)) {
            lowest = std::min(lowest, p.y);
            rearmost = std::min(rearmost, p.z);
        }
    }
    // The polygon of the tube, of 48 corners, stays behind its circle by up to 1 - cos(3.75 deg) of the radius 0.17.
    EXPECT_NEAR(lowest, 0, 4e-4);
    EXPECT_NEAR(rearmost, -1.6, 4e-4);
}

// Floor and wall as the header says: unit normal, a point on their common edge, and leaning back by rotateX(-angle).
TEST(Scenes, RoomsMeetInAnEdge) {
    for (const Scene& room : {cubeInRoom(), stillLifeInRoom()}) {
        const SceneObject &floor = room.objects[room.objects.size() - 2], &wall = room.objects.back();
        EXPECT_EQ(floor.name, "floor");
        EXPECT_EQ(wall.name, "wall");
        EXPECT_EQ(vec3(floor.worldFromObject[1]), vec3(0, 0, 1));
        EXPECT_LT(glm::length(vec3(wall.worldFromObject[1]) - vec3(1, 0, 0)), 1e-15);
        for (const SceneObject* ground : {&floor, &wall}) {
            EXPECT_FALSE(ground->casts);
            EXPECT_EQ(vec3(ground->worldFromObject[3]), vec3(-3, 0, -1.0125));
            for (const vec3& p : worldPositions(*ground)) {
                EXPECT_GE(p.x, -3 - 1e-14);
                EXPECT_GE(p.z, -1.0125 - 1e-14);
            }
        }
        const vec3 leaning((wall.worldFromObject * rotateX(-30))[1]);
        EXPECT_GT(leaning.z, 0.49);  // its front turns upwards
        for (const SceneObject& object : room.objects) {
            if (!object.casts) continue;
            EXPECT_TRUE(isClosed(object.mesh)) << object.name;
            EXPECT_GT(signedVolume(object.mesh), 0) << object.name;
            for (const vec3& p : worldPositions(object)) {
                EXPECT_GE(p.z, -1.0125 - 1e-6) << object.name;
                EXPECT_GE(p.x, -3 - 1e-6) << object.name;
            }
        }
    }
    EXPECT_EQ(cubeInRoom().objects.size(), 3U);
    EXPECT_EQ(stillLifeInRoom().objects.size(), 6U);
}

TEST(Scenes, HandlesNameTheirObjects) {
    const Scene cube = cubeInRoom(), life = stillLifeInRoom();
    EXPECT_EQ(cube[cubeInRoomScene::cube].name, "cube");
    EXPECT_EQ(cube[cubeInRoomScene::floor].name, "floor");
    EXPECT_EQ(cube[cubeInRoomScene::wall].name, "wall");
    EXPECT_EQ(life[stillLifeInRoomScene::pawn].name, "pawn");
    EXPECT_EQ(life[stillLifeInRoomScene::ring].name, "ring");
    EXPECT_EQ(life[stillLifeInRoomScene::sphere].name, "sphere");
    EXPECT_EQ(life[stillLifeInRoomScene::box].name, "box");
    EXPECT_EQ(life[stillLifeInRoomScene::floor].name, "floor");
    EXPECT_EQ(life[stillLifeInRoomScene::wall].name, "wall");
}

TEST(Scenes, TheHouseIsClosedStandsUprightAndHasSixDifferentSides) {
    const Scene scene = house();
    EXPECT_EQ(scene.objects.size(), 10U);
    for (const SceneObject& object : scene.objects) {
        EXPECT_TRUE(isClosed(object.mesh)) << object.name;
        EXPECT_GT(signedVolume(object.mesh), 0) << object.name;
        for (const vec3& p : worldPositions(object)) {
            EXPECT_GE(p.y, 0) << object.name;
            EXPECT_LT(glm::length(p - vec3(1.5, 3, 0)), 8) << object.name;
        }
    }
    // A normal leans the way the corners run round it
    const MeshData mesh = meshOf(scene);
    for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
        const vec3 a(mesh.positions[i]), b(mesh.positions[i + 1]), c(mesh.positions[i + 2]);
        EXPECT_GT(glm::dot(glm::normalize(glm::cross(b - a, c - a)), vec3(mesh.normals[i])), 0.999);
    }
    // Seen along the axes, no mirror image of the house is the house: some corner has no counterpart
    for (int axis = 0; axis < 3; ++axis) {
        double low = HUGE_VAL, high = -HUGE_VAL;
        for (const fvec3& p : mesh.positions) {
            low = std::min(low, double(p[axis]));
            high = std::max(high, double(p[axis]));
        }
        bool alike = true;
        for (fvec3 mirrored : mesh.positions) {
            mirrored[axis] = float(low + high) - mirrored[axis];
            alike &= std::any_of(mesh.positions.begin(), mesh.positions.end(),
                                 [&](const fvec3& p) { return glm::length(p - mirrored) < 1e-3F; });
        }
        EXPECT_FALSE(alike) << "axis " << axis;
    }
}

TEST(Scenes, TheGardenStandsInRows) {
    const Scene scene = garden();
    ASSERT_EQ(scene.objects.size(), 29U);
    std::set<std::string> names;
    for (const SceneObject& object : scene.objects) {
        EXPECT_TRUE(names.insert(object.name).second) << object.name;
        EXPECT_TRUE(isClosed(object.mesh)) << object.name;
        EXPECT_GT(signedVolume(object.mesh), 0) << object.name;
        EXPECT_EQ(object.mesh.colors.size(), object.mesh.positions.size());
        for (const vec3& p : worldPositions(object)) EXPECT_GE(p.y, 0) << object.name;
    }
    EXPECT_EQ(vec3(scene.objects[0].worldFromObject[3]), vec3(-1.5, 0, -20));
    for (std::size_t i = 1; i < 29; ++i) {
        EXPECT_EQ(scene.objects[i].mesh.positions, scene.objects[1].mesh.positions);
        const Bounds bounds = boundsOf(scene.objects[i].mesh, scene.objects[i].worldFromObject);
        EXPECT_EQ(bounds.low.y, 0);
        EXPECT_EQ(bounds.high.y, 5);
        const vec3 foot(scene.objects[i].worldFromObject[3]);
        EXPECT_GT(std::abs(foot.x), 7);  // the middle is free for the house and the way to it
        const std::size_t row = (i - 1) / 4;
        EXPECT_EQ(foot.z, -4.0 - 6.0 * double(row));
    }
}

TEST(Bounds, HoldAMeshAndTouchItOnEverySide) {
    const MeshData mesh = sphere(2, 16, 8);
    const mat4 worldFromModel = translate(1, 2, 3) * scale(1, -3, 0.5);
    const Bounds bounds = boundsOf(mesh, worldFromModel);
    // Positions are floats, of up to 2: a rounding of 1e-7, stretched by 3
    EXPECT_LT(glm::length(bounds.low - vec3(-1, -4, 2)), 1e-6);
    EXPECT_LT(glm::length(bounds.high - vec3(3, 8, 4)), 1e-6);
    EXPECT_LT(glm::length(bounds.middle() - vec3(1, 2, 3)), 1e-6);
    const std::array<vec3, 8> corners = bounds.corners();
    EXPECT_EQ(corners[0], bounds.low);
    EXPECT_EQ(corners[7], bounds.high);
    EXPECT_EQ(corners[5], vec3(bounds.high.x, bounds.low.y, bounds.high.z));  // bits 0 and 2
    Bounds again;
    for (const vec3& corner : corners) again.add(corner);
    EXPECT_EQ(again.low, bounds.low);
    EXPECT_EQ(again.high, bounds.high);
}

TEST(Scenes, AreOneMeshInWorldSpace) {
    Scene scene;
    scene.objects = {{.name = "a", .mesh = square(), .worldFromObject = translate(0, 1, 0), .color = {1, 0, 0}},
                     {.name = "b", .mesh = sphere(1, 8, 4), .worldFromObject = scale(1, 2, 1), .color = {0, 0, 1}}};
    const MeshData mesh = meshOf(scene);
    validate(mesh);
    ASSERT_EQ(mesh.positions.size(), 6 + 3 * triangleCount(scene.objects[1].mesh));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        EXPECT_EQ(mesh.colors[i], i < 6 ? fvec4(1, 0, 0, 1) : fvec4(0, 0, 1, 1));
        EXPECT_NEAR(glm::length(mesh.normals[i]), 1, 1e-6);
        if (i < 6) {
            EXPECT_EQ(mesh.positions[i].y, 1);
        } else {
            // On the ellipsoid the normal is (x, y/4, z), made longer
            const fvec3 normal = glm::normalize(mesh.positions[i] * fvec3(1, 0.25F, 1));
            EXPECT_LT(glm::length(mesh.normals[i] - normal), 1e-6);
        }
    }
    Scene far = scene;
    far.objects[1].worldFromObject = scale(1, 1e39, 1);
    EXPECT_EQ(refusal([&] { meshOf(far); }).rfind("object b: its places in the world must fit into floats, (", 0), 0U);
    scene.objects[0].mesh.normals.clear();
    EXPECT_TRUE(meshOf(scene).normals.empty());
    scene.objects[0].mesh = wireCube();
    EXPECT_EQ(refusal([&] { meshOf(scene); }), "object a: must be made of triangles");
}

TEST(Scenes, RefuseAnAspectThatIsNone) {
    for (const NamedScene& scene : scenes) {
        EXPECT_EQ(refusal([&] { scene.make(0); }), "scene: aspect must be greater than 0 and finite, 0") << scene.name;
        EXPECT_EQ(refusal([&] { scene.make(notANumber); }), "scene: aspect must be greater than 0 and finite, nan")
            << scene.name;
    }
}

TEST(Scenes, OtherDepthsLeaveTheWindowAsItIs) {
    const mat4 as = stillLife(4.0 / 3).clipFromView;
    for (const double far : {5.0, 1e6, HUGE_VAL}) {
        const mat4 clip = withDepths(as, 0.1, far);
        for (int column = 0; column < 4; ++column) {
            for (const int row : {0, 1, 3}) EXPECT_EQ(clip[column][row], as[column][row]) << column << ", " << row;
        }
        const vec4 nearest = clip * vec4(0, 0, -0.1, 1), farthest = clip * vec4(0, 0, -1, 1 / far);
        EXPECT_NEAR(nearest.z / nearest.w, -1, 1e-14);  // some roundings of numbers near 1
        EXPECT_NEAR(farthest.z / farthest.w, 1, 1e-14);
    }
    EXPECT_THROW(withDepths(ortho(-1, 1, -1, 1, 1, 2), 0.1, 10), Error);
    EXPECT_THROW(withDepths(as, 0, 10), Error);
    EXPECT_THROW(withDepths(as, 1, 1), Error);
}

}  // namespace

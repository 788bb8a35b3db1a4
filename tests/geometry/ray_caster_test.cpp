#include "mv/geometry/ray_caster.h"

#include <glm/geometric.hpp>
#include <string>
#include <thread>
#include <vector>

#include "../math/support.h"
#include "mv/geometry/check.h"
#include "mv/geometry/shapes.h"
#include "mv/image/picture.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "support/shadow_rays.h"

using namespace mv;
using namespace mv::test;

namespace {

// Objects of every kind, thrown about: some of them overlap.
Scene randomScene(std::uint64_t seed) {
    Random random(seed);
    Scene scene;
    for (int i = 0; i < 12; ++i) {
        SceneObject object;
        object.name = "object " + std::to_string(i);
        object.mesh = i % 3 == 0 ? colorCube() : i % 3 == 1 ? sphere(0.5, 12, 7) : grid(3, 2, 1.5, 1);
        const mat4 turned = rotate(random.number(0, 360), random.point(1));
        object.worldFromObject = translate(random.point(2)) * turned * scale(i % 4 == 0 ? vec3(-1, 0.3, 1) : vec3(1));
        object.casts = i % 5 != 0;
        scene.objects.push_back(object);
    }
    scene.lights.push_back({.position = vec4(2, 5, 3, 1)});
    scene.lights.push_back({.position = vec4(1, 2, -1, 0)});
    scene.viewFromWorld = lookAt({0, 1, 8}, {0, 0, 0}, {0, 1, 0});
    scene.clipFromView = perspective(40, 1, 0.1, 100);
    return scene;
}

std::vector<vec3> worldCorners(const SceneObject& object) {
    std::vector<vec3> corners;
    for (const auto& triangle : trianglesOf(object.mesh)) {
        for (const auto i : triangle) corners.emplace_back(object.worldFromObject * vec4(object.mesh.positions[i], 1));
    }
    return corners;
}

// ---- the tree of boxes

// The triangle that a loop over all of them finds first.
SceneHit loopOver(const std::vector<std::vector<vec3>>& objects, const Ray& ray) {
    SceneHit best{.t = HUGE_VAL};
    for (std::size_t object = 0; object < objects.size(); ++object) {
        const auto& corners = objects[object];
        for (std::size_t k = 0; k < corners.size(); k += 3) {
            const auto hit = intersectTriangle(ray, corners[k], corners[k + 1], corners[k + 2]);
            if (!hit || hit->t >= best.t) continue;
            best.t = hit->t;
            best.object = static_cast<int>(object);
            best.triangle = static_cast<int>(k / 3);
        }
    }
    return best;
}

std::vector<std::vector<vec3>> worldCorners(const Scene& scene) {
    std::vector<std::vector<vec3>> all;
    for (const SceneObject& object : scene.objects) all.push_back(worldCorners(object));
    return all;
}

// 1 where the caster and the loop met something, and the same.
int expectAsLoop(const RayCaster& caster, const std::vector<std::vector<vec3>>& objects, const Ray& ray) {
    const SceneHit best = loopOver(objects, ray);
    const auto hit = caster.nearest(ray);
    EXPECT_EQ(hit.has_value(), best.object >= 0);
    if (!hit || best.object < 0) return 0;
    EXPECT_EQ(hit->t, best.t);
    EXPECT_EQ(hit->object, best.object);
    EXPECT_EQ(hit->triangle, best.triangle);
    return 1;
}

TEST(RayCaster, FindsWhatALoopOverAllTrianglesFinds) {
    int hits = 0;
    for (const std::uint64_t seed : {1U, 2U, 3U}) {
        const Scene scene = randomScene(seed);
        const RayCaster caster(scene);
        const auto objects = worldCorners(scene);
        Random random(seed + 100);
        for (int i = 0; i < 3000; ++i) {
            // Some along an axis and some in the planes of the boxes' sides: there a slab test has 0/0.
            Ray ray{random.point(4), random.point(1)};
            if (i % 4 == 0) ray.direction = vec3(0), ray.direction[i % 3] = i % 8 == 0 ? 1 : -1;
            if (i % 16 == 0) ray.origin = objects[static_cast<std::size_t>(i / 16 % 12)][1] - 3.0 * ray.direction;
            hits += expectAsLoop(caster, objects, ray);
            ASSERT_FALSE(HasFailure()) << "seed " << seed << ", ray " << i;
        }
    }
    EXPECT_GT(hits, 1000);
}

// The boxes are in float: so scenes far larger, smaller and farther away than float can say, directions of any length,
// origins from which the scene is a point, and rays that graze what they are aimed at.
TEST(RayCaster, FindsItAtAnySizeAndDistance) {
    struct Extreme {
        double size, offset, away, length;  // of the scene; of its middle from 0; of origins from that; of directions
    };
    for (const Extreme& e : {Extreme{1e-60, 0, 1, 1},
                             {1e60, 0, 1, 1},
                             {1, 1e6, 1, 1},
                             {1, 1e12, 1, 1},
                             {1, 0, 1e7, 1},
                             {1, 0, 1e30, 1},
                             {1, 0, 1e60, 1},
                             {1, 0, 1, 1e-200},
                             {1, 0, 1, 1e200},
                             {1e-60, 0, 1e80, 1e-60},
                             {1e30, 1e60, 1, 1e60},
                             {1e-20, 1, 1, 1}}) {
        SCOPED_TRACE(numberText(e.size) + " " + numberText(e.offset) + " " + numberText(e.away) + " " +
                     numberText(e.length));
        Scene scene = randomScene(7);
        for (SceneObject& object : scene.objects) {
            object.worldFromObject =
                translate(e.offset, -e.offset, e.offset) * scale(vec3(e.size)) * object.worldFromObject;
        }
        const RayCaster caster(scene);
        const auto objects = worldCorners(scene);
        const vec3 middle(e.offset, -e.offset, e.offset);
        Random random(8);
        int hits = 0;
        for (int i = 0; i < 400; ++i) {
            const auto& corners = objects[static_cast<std::size_t>(i % 12)];
            const auto k = static_cast<std::size_t>(random.number(0, static_cast<double>(corners.size())));
            const vec3 aim = i % 4 == 0 ? corners[k] : middle + 2.5 * e.size * random.point(1);
            const vec3 origin = middle + 4 * e.size * e.away * random.point(1);
            vec3 direction = aim - origin;
            if (direction == vec3(0)) continue;
            direction *= e.length / std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
            if (i % 8 == 1) direction[i / 8 % 3] = 0;
            if (direction == vec3(0)) continue;
            hits += expectAsLoop(caster, objects, {origin, direction});
            ASSERT_FALSE(HasFailure()) << "ray " << i;
        }
        const bool canBeSeen = e.away <= 1 && e.offset <= 1e6 * e.size;
        EXPECT_GT(hits, canBeSeen ? 50 : -1);
    }
}

// Whether something stands in the way is the same question, asked of another walk through the tree.
TEST(RayCaster, ShadesWhatALoopOverAllTrianglesShades) {
    const Scene scene = randomScene(4);
    const RayCaster caster(scene);
    auto casters = worldCorners(scene);
    for (std::size_t i = 0; i < casters.size(); ++i) {
        if (!scene.objects[i].casts) casters[i].clear();
    }
    Random random(5);
    int shaded = 0, free = 0;
    for (int i = 0; i < 10000; ++i) {
        const auto hit = caster.nearest({random.point(4), random.point(1)});
        if (!hit) continue;
        // From a light that the triangle faces: what is met before the point, but for the triangle itself
        const vec3 light = hit->point + 6.0 * hit->normal + random.point(4);
        const SceneHit first = loopOver(casters, {light, hit->point - light});
        if (first.object == hit->object || std::abs(first.t - 1) < 1e-9) {
            if (first.object == hit->object && first.triangle != hit->triangle)
                continue;  // which of both is not certain
            EXPECT_FALSE(caster.inShadow(*hit, vec4(light, 1)));
            ++free;
        } else {
            EXPECT_EQ(caster.inShadow(*hit, vec4(light, 1)), first.t < 1) << i;
            shaded += first.t < 1 ? 1 : 0;
        }
    }
    EXPECT_GT(shaded, 100);
    EXPECT_GT(free, 100);
}

TEST(RayCaster, MissesNoCornerAndNoEdgeOfAClosedMesh) {
    Scene scene;
    scene.objects.push_back({.name = "sphere", .mesh = sphere(1, 24, 12)});
    scene.objects[0].worldFromObject = translate(3, -2, 5) * rotate(40, {1, 2, 3}) * scale(0.9, 1.3, 1.1);
    const RayCaster caster(scene);
    const auto corners = worldCorners(scene.objects[0]);
    Random random(20);
    int missed = 0;
    for (int i = 0; i < 200000; ++i) {
        const auto first = static_cast<std::size_t>(random.number(0, static_cast<double>(corners.size()))) / 3 * 3;
        const vec3 a = corners[first], b = corners[first + 1];
        const vec3 aim = i % 2 == 0 ? a : a + random.number(0, 1) * (b - a);
        const vec3 origin = vec3(3, -2, 5) + random.point(0.4);
        missed += caster.nearest({origin, aim - origin}) ? 0 : 1;
    }
    EXPECT_EQ(missed, 0);
}

TEST(RayCaster, TellsPointAndNormalOfTheFront) {
    Scene scene;
    scene.objects.push_back({.name = "box", .mesh = box({-1, -1, -1}, {1, 1, 1}), .worldFromObject = scale(2, 1, 1)});
    // A mirror turns the winding round, and outwards is outwards still.
    for (const double side : {2.0, -2.0}) {
        scene.objects[0].worldFromObject = translate(5, 0, 0) * scale(side, 1, 1);
        const RayCaster caster(scene);
        const auto hit = caster.nearest({{1, 0.25, 0.5}, {4, 0, 0}});
        ASSERT_TRUE(hit);
        EXPECT_EQ(hit->t, 0.5);
        EXPECT_EQ(hit->point, vec3(3, 0.25, 0.5));
        EXPECT_EQ(hit->normal, vec3(-1, 0, 0));
        EXPECT_EQ(hit->object, 0);
        // From inside the same face has the same normal.
        const auto inside = caster.nearest({{4, 0.25, 0.5}, {-1, 0, 0}});
        ASSERT_TRUE(inside);
        EXPECT_EQ(inside->normal, vec3(-1, 0, 0));
    }
}

// ---- in shadow or not

// A floor 4 x 4 at y = 0 that does not cast, and above it what the test is about.
Scene floorWith(const SceneObject& object) {
    Scene scene;
    scene.objects.push_back({.name = "floor", .mesh = grid(1, 1, 4, 4), .casts = false});
    scene.objects.push_back(object);
    return scene;
}

TEST(RayCaster, ShadowsEndAtTheLightAndNotAtADirection) {
    const Scene scene = floorWith({.name = "plate", .mesh = box({-1, 1, -1}, {1, 1.1, 1})});
    const RayCaster caster(scene);
    const auto hit = caster.nearest({{0.2, 0.5, 0.1}, {0, -1, 0}});
    ASSERT_TRUE(hit);
    EXPECT_FALSE(caster.inShadow(*hit, {0, 0.9, 0, 1}));  // the light is below the plate
    EXPECT_TRUE(caster.inShadow(*hit, {0, 2, 0, 1}));
    EXPECT_TRUE(caster.inShadow(*hit, {0, 4, 0, 2}));  // the same point
    EXPECT_FALSE(caster.inShadow(*hit, {0, 1.8, 0, 2}));
    EXPECT_TRUE(caster.inShadow(*hit, {0, 1e-3, 0, 0}));  // a direction goes on for ever
    EXPECT_FALSE(caster.inShadow(*hit, {5, 1, 0, 0}));
    EXPECT_FALSE(caster.inShadow(*hit, {0, -1, 0, 0}));  // downwards the floor is in the way, and does not cast
}

TEST(RayCaster, TheTriangleItselfCastsNoShadowOnAPointBehindIt) {
    Scene scene;
    scene.objects.push_back({.name = "box", .mesh = box({-1, -1, -1}, {1, 1, 1})});
    const RayCaster caster(scene);
    auto hit = caster.nearest({{0.3, 5, 0.1}, {0, -1, 0}});
    ASSERT_TRUE(hit);
    hit->point.y -= 1e-9;  // as by one who computes it from t
    EXPECT_FALSE(caster.inShadow(*hit, {1, 2, 3, 0}));
}

TEST(RayCaster, NeitherShadesItselfNorLosesWhatIsNear) {
    // Convex, so that no triangle may shade another one that faces the light. At every scale, and off the origin.
    for (const double size : {1e-3, 1.0, 1e3, 1e6}) {
        Scene scene;
        scene.objects.push_back({.name = "sphere", .mesh = sphere(1, 48, 24)});
        scene.objects[0].worldFromObject = translate(3 * size, size, -2 * size) * rotate(33, {3, 1, 2}) * scale(size);
        const RayCaster caster(scene);
        Random random(22);
        const auto corners = worldCorners(scene.objects[0]);
        int facing = 0, shaded = 0, shadedWithout = 0;
        for (int i = 0; i < 50000; ++i) {
            const vec3 middle(3 * size, size, -2 * size);
            const vec3 origin = middle + 5 * size * random.direction();
            // Half of them to corners and edges, where the neighbours are within a rounding of the point
            const auto first = static_cast<std::size_t>(random.number(0, static_cast<double>(corners.size()))) / 3 * 3;
            const vec3 edge = corners[first] + (i % 4 == 0 ? 0.0 : 0.3) * (corners[first + 1] - corners[first]);
            const vec3 aim = i % 2 == 0 ? edge : middle + 0.9 * size * random.direction();
            const auto hit = caster.nearest({origin, aim - origin});
            const vec3 light = random.direction();
            if (!hit || glm::dot(hit->normal, light) <= 0) continue;
            ++facing;
            shaded += caster.inShadow(*hit, vec4(light, 0)) ? 1 : 0;
            // Without any of it, the ray from the very point.
            shadedWithout += caster.nearest({hit->point, light}) ? 1 : 0;
        }
        EXPECT_GT(facing, 10000) << size;
        EXPECT_EQ(shaded, 0) << size;
        EXPECT_GT(shadedWithout, 1000) << size;

        // A plate that hovers a millionth of a millionth of its size above a floor, and is as thin, shades it nevertheless.
        Scene near = floorWith({.name = "plate", .mesh = box({-1, 0, -1}, {1, 1e-12, 1})});
        const mat4 turned = rotate(30, {1, 2, 3});
        near.objects[0].worldFromObject = turned * scale(size);
        near.objects[1].worldFromObject = turned * translate(0, 1e-12 * size, 0) * scale(size);
        const RayCaster nearCaster(near);
        const auto inWorld = [&](const vec3& v) { return vec3(turned * vec4(v, 0)); };
        const auto hit = nearCaster.nearest({inWorld({0.3 * size, -size, 0.2 * size}), inWorld({0, 1, 0})});
        ASSERT_TRUE(hit);
        ASSERT_EQ(hit->object, 0);
        EXPECT_TRUE(nearCaster.inShadow(*hit, vec4(inWorld({1, 2, 3}), 0))) << size;
    }
}

// ---- pictures

// A camera at (1, 4, 3), and a light.
Scene lookedAt(Scene scene, const SceneLight& light) {
    scene.lights.push_back(light);
    scene.viewFromWorld = lookAt({1, 4, 3}, {0, 0.3, 0}, {0, 1, 0});
    scene.clipFromView = perspective(50, 1.25, 0.5, 20);
    return scene;
}

TEST(LitPicture, EqualsAnAnalyticShadowOfASquare) {
    const mat4 worldFromSquare = translate(0.2, 0.8, -0.1) * rotate(25, {1, 0.5, 0.2});
    const Scene scene = lookedAt(floorWith({.name = "square", .mesh = square(), .worldFromObject = worldFromSquare}),
                                 {.position = {-1, 3, 1, 1}});
    const int width = 200, height = 160;
    const LitPicture picture = RayCaster(scene).lit(width, height);
    const ShadowScene analytic{scene.clipFromWorld(), worldFromSquare, {-1, 3, 1}, 2, false};
    int shadow = 0, different = 0;
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) {
            const std::size_t pixel = pixelIndex(column, row, width);
            const Seen seen = castRay(analytic, {(2 * column + 1.0) / width - 1, 1 - (2 * row + 1.0) / height});
            const int object = seen == Seen::background ? -1 : seen == Seen::square ? 1 : 0;
            different += picture.object[pixel] != object ? 1 : 0;
            if (object != 0) continue;
            EXPECT_TRUE(picture.faces[pixel]);
            different += picture.lit[pixel] != (seen == Seen::shadow ? 0 : 1) ? 1 : 0;
            shadow += seen == Seen::shadow ? 1 : 0;
        }
    }
    EXPECT_GT(shadow, 500);
    EXPECT_EQ(different, 0);  // no pixel of these is within a rounding of an edge
}

// The area in the shadow of a sphere: the cone of the rays that touch it, cut by the floor, is an ellipse.
double shadowArea(const vec3& light, const vec3& center, double radius) {
    const vec3 axis = center - light;
    const double sine = radius / glm::length(axis), tilt = axis.y / glm::length(axis);  // cosine against the vertical
    return pi * light.y * light.y * sine * sine * std::sqrt(1 - sine * sine) / std::pow(tilt * tilt - sine * sine, 1.5);
}

// Summed over the floor, what an area light lacks is the mean of the shadows of its points: no sampling comes into it.
TEST(LitPicture, LacksThePenumbraThatTheoryGivesASphere) {
    const vec3 center(0.1, 1, 0);
    const double radius = 0.4;
    Scene scene = floorWith({.name = "ball", .mesh = sphere(radius, 256, 128), .worldFromObject = translate(center)});
    const SceneLight light{.position = {0.3, 3, -0.2, 1}, .halfU = {0.3, 0.1, 0}, .halfV = {0, 0, 0.4}};
    scene.lights.push_back(light);
    // Seen from below, where the ball does not hide its own shadow; a pixel is 4/200 wide.
    scene.viewFromWorld = lookAt({0, -1, 0}, {0, 0, 0}, {0, 0, -1});
    scene.clipFromView = ortho(-2, 2, -2, 2, 0.5, 1.5);
    const int side = 200, lightSide = 6;
    const LitPicture picture = RayCaster(scene).lit(side, side, {.lightSide = lightSide});
    double lacking = 0;
    int umbra = 0, penumbra = 0;
    for (const double lit : picture.lit) {
        lacking += 1 - lit;
        umbra += lit == 0 ? 1 : 0;
        penumbra += lit > 0 && lit < 1 ? 1 : 0;
    }
    double expected = 0;
    for (int i = 0; i < lightSide * lightSide; ++i) {
        const int row = i / lightSide, column = i % lightSide;
        const double s = (2 * column + 1.0) / lightSide - 1, t = (2 * row + 1.0) / lightSide - 1;
        expected += shadowArea(vec3(light.position) + s * light.halfU + t * light.halfV, center, radius);
    }
    expected /= lightSide * lightSide;
    const double pixelArea = 16.0 / (side * side);
    // The mesh lies within the ball, by 1e-4 of its outline; pixels on 36 outlines count whole or not at all.
    EXPECT_NEAR(lacking * pixelArea / expected, 1, 1e-3);
    EXPECT_GT(umbra, 300);
    EXPECT_GT(penumbra, 1000);
}

TEST(LitPicture, ConvergesAsTheLightIsAskedAtMorePoints) {
    const Scene scene = lookedAt(
        floorWith({.name = "box", .mesh = box({-0.4, 0, -0.4}, {0.4, 0.8, 0.4}), .worldFromObject = rotateY(25)}),
        {.position = {-1, 3, 1, 1}, .halfU = {0.4, 0, 0}, .halfV = {0, 0, 0.4}});
    const RayCaster caster(scene);
    const auto litBy = [&](int side) { return caster.lit(60, 48, {.lightSide = side}).lit; };
    const auto reference = litBy(96);
    std::vector<double> errors;
    for (const int side : {2, 4, 8, 16}) {
        const auto lit = litBy(side);
        double sum = 0;
        for (std::size_t i = 0; i < lit.size(); ++i) sum += (lit[i] - reference[i]) * (lit[i] - reference[i]);
        errors.push_back(std::sqrt(sum / static_cast<double>(lit.size())));
        EXPECT_GT(sum, 0);
    }
    for (std::size_t i = 1; i < errors.size(); ++i) EXPECT_LT(errors[i], errors[i - 1] / 1.6) << i;
    const double slope = std::log2(errors.front() / errors.back()) / 3;
    RecordProperty("slope", std::to_string(-slope));
    // A straight edge across a grid of cells: 1/n where it runs along the rows and all are wrong together, up to 1/n^2
    // where the rows' errors cancel. Measured: 1.8.
    EXPECT_GT(slope, 0.9);
    EXPECT_LT(slope, 2.1);
}

// Which is found by one look at the whole light where little stands between; here by a ray to each of its points.
TEST(LitPicture, EqualsTheMeanOverThePointsOfTheLight) {
    for (const std::uint64_t seed : {11U, 12U, 13U, 14U}) {
        Scene scene = randomScene(seed);
        for (SceneObject& object : scene.objects) object.worldFromObject = object.worldFromObject * scale(0.6);
        // Above all objects, or among them: what is behind the light is near the way to it then, and does not shade.
        const vec4 position = seed % 2 == 0 ? vec4(2, 6, 3, 2) : vec4(0.3, 0.4, 0.6, 1);
        const SceneLight light{.position = position, .halfU = {0.5, 0.1, 0}, .halfV = {0, -0.4, 0.5}};
        scene.lights[0] = light;
        const RayCaster caster(scene);
        const int side = 120, lightSide = 5;
        const LitPicture picture = caster.lit(side, side, {.lightSide = lightSide});
        const mat4 worldFromClip = glm::inverse(scene.clipFromWorld());
        int partly = 0;
        for (int i = 0; i < side * side; ++i) {
            const int row = i / side, column = i % side;
            const vec2 ndc((2 * column + 1.0) / side - 1, 1 - (2 * row + 1.0) / side);
            const vec4 near = worldFromClip * vec4(ndc, -1, 1), far = worldFromClip * vec4(ndc, 1, 1);
            const vec3 origin = vec3(near) / near.w;
            const auto hit = caster.nearest({origin, vec3(far) / far.w - origin});
            const auto pixel = static_cast<std::size_t>(i);
            ASSERT_EQ(picture.object[pixel], hit ? hit->object : -1);
            if (!hit) continue;
            int reached = 0;
            for (int k = 0; k < lightSide * lightSide; ++k) {
                const int across = k % lightSide, along = k / lightSide;
                const double s = (2 * across + 1.0) / lightSide - 1, t = (2 * along + 1.0) / lightSide - 1;
                const vec3 point = vec3(light.position) / light.position.w + s * light.halfU + t * light.halfV;
                if (glm::dot(hit->normal, point - hit->point) <= 0) continue;
                reached += caster.inShadow(*hit, vec4(point, 1)) ? 0 : 1;
            }
            EXPECT_EQ(picture.lit[pixel], static_cast<double>(reached) / (lightSide * lightSide)) << seed;
            partly += reached > 0 && reached < lightSide * lightSide ? 1 : 0;
        }
        EXPECT_GT(partly, 30) << seed;
    }
}

TEST(LitPicture, WhatIsBehindAnAreaLightDoesNotShade) {
    // A plate that slants over light and floor: beside the way to the light, and across it beyond.
    Scene scene = floorWith({.name = "plate",
                             .mesh = box({-3, 0, -3}, {3, 0.1, 3}),
                             .worldFromObject = translate(0, 1.3, 0) * rotateZ(40)});
    scene.objects[0].worldFromObject = scale(0.5);
    scene.lights.push_back({.position = {0, 1, 0, 1}, .halfU = {0.1, 0, 0}, .halfV = {0, 0, 0.1}});
    scene.viewFromWorld = lookAt({0, -1, 0}, {0, 0, 0}, {0, 0, -1});
    scene.clipFromView = ortho(-0.9, 0.9, -0.9, 0.9, 0.5, 1.5);
    for (const double lit : RayCaster(scene).lit(20, 20, {.lightSide = 3}).lit) EXPECT_EQ(lit, 1);
}

TEST(LitPicture, AveragesThePointsOfAPixel) {
    const Scene scene = lookedAt(floorWith({.name = "box", .mesh = box({-0.4, 0, -0.4}, {0.4, 0.8, 0.4})}),
                                 {.position = {-1, 3, 1, 1}});
    const RayCaster caster(scene);
    const int width = 50, height = 40;
    for (const int side : {2, 3}) {
        const LitPicture coarse = caster.lit(width, height, {.pixelSide = side});
        const LitPicture fine = caster.lit(width * side, height * side);
        const LitPicture middles = caster.lit(width, height);
        EXPECT_EQ(coarse.object, middles.object);
        EXPECT_EQ(coarse.faces, middles.faces);
        int mixed = 0;
        for (int row = 0; row < height; ++row) {
            for (int column = 0; column < width; ++column) {
                const std::size_t pixel = pixelIndex(column, row, width);
                double sum = 0;
                int points = 0;
                for (int i = 0; i < side * side; ++i) {
                    const std::size_t point = pixelIndex(column * side + i % side, row * side + i / side, width * side);
                    if (fine.object[point] != coarse.object[pixel]) continue;
                    sum += fine.lit[point];
                    ++points;
                }
                if (points == 0 || coarse.object[pixel] < 0) continue;
                // Both ways through the picture round differently: a point on an edge could differ. None does.
                EXPECT_NEAR(coarse.lit[pixel], sum / points, 1e-12);
                mixed += coarse.lit[pixel] > 0 && coarse.lit[pixel] < 1 ? 1 : 0;
            }
        }
        EXPECT_GT(mixed, 10);
    }
}

TEST(LitPicture, LeavesOutWhatFacesAwayAndWhatDoesNotReceive) {
    Scene scene =
        lookedAt(floorWith({.name = "ball", .mesh = sphere(0.5, 24, 12), .worldFromObject = translate(0, 1, 0)}),
                 {.position = {-1, 3, 1, 1}});
    const auto shadowOn = [](const Scene& s, int object) {
        const LitPicture picture = RayCaster(s).lit(100, 80);
        int count = 0;
        for (std::size_t i = 0; i < picture.lit.size(); ++i) {
            EXPECT_TRUE(picture.lit[i] == 0 || (picture.object[i] >= 0 && picture.faces[i]));
            count += picture.object[i] == object && picture.faces[i] && picture.lit[i] == 0 ? 1 : 0;
        }
        return count;
    };
    EXPECT_GT(shadowOn(scene, 0), 100);
    EXPECT_EQ(shadowOn(scene, 1), 0);  // convex: dark only where it faces away
    Scene without = scene;
    without.objects[0].receives = false;
    EXPECT_EQ(shadowOn(without, 0), 0);
    without = scene;
    without.objects[1].casts = false;
    EXPECT_EQ(shadowOn(without, 0), 0);
}

TEST(LitPicture, SeesOnlyTheViewVolumeAlsoWithoutAFarPlane) {
    Scene scene = lookedAt(floorWith({.name = "box", .mesh = box({-0.4, 0, -0.4}, {0.4, 0.8, 0.4})}),
                           {.position = {-1, 3, 1, 1}});
    const LitPicture all = RayCaster(scene).lit(50, 40);
    const auto seen = [](const LitPicture& picture, int object) {
        return std::count(picture.object.begin(), picture.object.end(), object);
    };
    EXPECT_GT(seen(all, 1), 50);
    // The box is 4.1 to 5.2 from the eye.
    scene.clipFromView = perspective(50, 1.25, 0.5, 3.5);
    EXPECT_EQ(seen(RayCaster(scene).lit(50, 40), 1), 0);
    scene.clipFromView = perspective(50, 1.25, 5.5, 20);
    EXPECT_EQ(seen(RayCaster(scene).lit(50, 40), 1), 0);
    // The far plane at infinity: the limit of perspective() for far without end.
    scene.clipFromView = perspective(50, 1.25, 0.5, 20);
    scene.clipFromView[2][2] = -1;
    scene.clipFromView[3][2] = -2 * 0.5;
    const LitPicture endless = RayCaster(scene).lit(50, 40);
    EXPECT_EQ(endless.object, all.object);
    EXPECT_EQ(endless.lit, all.lit);
}

TEST(LitPicture, DoesNotDependOnTheNumberOfThreads) {
    const Scene scene = randomScene(7);
    const RayCaster caster(scene);
    const LitPicture one = caster.lit(61, 47, {.light = 1, .lightSide = 2, .pixelSide = 2, .threads = 1});
    for (const int threads : {0, 2, 3, 7, 100}) {
        const LitPicture several = caster.lit(61, 47, {.light = 1, .lightSide = 2, .pixelSide = 2, .threads = threads});
        EXPECT_EQ(several.lit, one.lit) << threads;
        EXPECT_EQ(several.object, one.object) << threads;
        EXPECT_EQ(several.faces, one.faces) << threads;
        EXPECT_EQ(several.rays, one.rays) << threads;
    }
}

TEST(LitPicture, TellsItsProgressInOrderAndOnTheCallersThread) {
    const RayCaster caster(randomScene(8));
    const auto self = std::this_thread::get_id();
    double last = 0;
    int calls = 0;
    const auto progress = [&](double part) {
        EXPECT_EQ(std::this_thread::get_id(), self);
        EXPECT_GE(part, last);
        EXPECT_LE(part, 1);
        last = part;
        ++calls;
    };
    caster.lit(20, 40, {.threads = 2, .progress = progress});
    EXPECT_EQ(last, 1);
    // Alone it tells each row's end.
    calls = 0;
    last = 0;
    caster.lit(20, 40, {.threads = 1, .progress = progress});
    EXPECT_EQ(last, 1);
    EXPECT_GE(calls, 40);
    // A progress that throws ends it.
    EXPECT_EQ(
        refusal([&] { caster.lit(20, 40, {.threads = 2, .progress = [](double) { throw Error("user", "stop"); }}); }),
        "user: stop");
}

TEST(RayCaster, RefusalsSayWhatWouldHaveBeenRight) {
    const Scene scene = randomScene(1);
    const RayCaster caster(scene);
    EXPECT_EQ(refusal([&] { caster.lit(0, 1); }), "lit: width must be 1 to 16384, 0");
    EXPECT_EQ(refusal([&] { caster.lit(1, 20000); }), "lit: height must be 1 to 16384, 20000");
    EXPECT_EQ(refusal([&] { caster.lit(1, 1, {.lightSide = 0}); }), "lit: lightSide must be 1 to 1024, 0");
    EXPECT_EQ(refusal([&] { caster.lit(1, 1, {.pixelSide = -1}); }), "lit: pixelSide must be 1 to 1024, -1");
    EXPECT_EQ(refusal([&] { caster.lit(1, 1, {.threads = -1}); }), "lit: threads must be 0 to 1024, -1");
    EXPECT_EQ(refusal([&] { caster.lit(1, 1, {.light = 2}); }),
              "lit: the scene must have the light that is asked for, 2");
    EXPECT_EQ(refusal([&] { caster.nearest({{0, 0, 0}, {0, 0, 0}}); }), "nearest: the direction must not be 0");
    EXPECT_EQ(refusal([&] {
                  caster.nearest({{0, notANumber, 0}, {0, 0, 1}});
              }),
              "nearest: the origin must be finite, (0, nan, 0)");
    EXPECT_EQ(refusal([&] {
                  caster.inShadow({}, {0, 1, 0, 1});
              }),
              "inShadow: the hit must be of this scene, object -1, triangle -1");
    EXPECT_EQ(refusal([&] {
                  caster.inShadow({.object = 0, .triangle = 0}, {0, 0, 0, 0});
              }),
              "inShadow: light must be a point or a direction, (0, 0, 0, 0)");

    const auto with = [&](const std::function<void(Scene&)>& change) {
        Scene changed = scene;
        changed.objects[0].name = "it";
        change(changed);
        return refusal([&] { RayCaster(changed).lit(4, 4); });
    };
    EXPECT_EQ(with([](Scene& s) { s.objects[0].mesh = wireCube(); }), "object 'it': must be made of triangles");
    EXPECT_EQ(with([](Scene& s) { s.objects[0].worldFromObject = scale(1, 0, 1); }),
              "object 'it': worldFromObject must have an inverse");
    EXPECT_EQ(with([](Scene& s) { s.objects[0].worldFromObject[0].w = 1; }),
              "object 'it': the last row of worldFromObject must be 0 0 0 1, (1, 0, 0, 1)");
    EXPECT_EQ(with([](Scene& s) { s.objects[0].worldFromObject = translate(1e80, 0, 0); }),
              "object 'it': coordinates must lie within 1e+70, (1e+80, 0.5, 0.5)");
    EXPECT_EQ(with([](Scene& s) { s.lights[0].position = vec4(0); }),
              "lit: the light must be a point or a direction, (0, 0, 0, 0)");
    EXPECT_EQ(with([](Scene& s) { s.clipFromView = mat4(0); }),
              "lit: clipFromWorld must be finite and have an inverse");
}

}  // namespace

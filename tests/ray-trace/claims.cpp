// The claims of ray-trace, and a test for each.
//
// - [energy] In a white room with mirror and glass alone, the light seen and the light that the depth cuts off add up to 1.
// - [never-itself] A ray meets the surface that it leaves only on the surface's other side.
// - [leaves] Of the rays that leave a floor y = 0 of slender triangles a quarter meet the triangle again, from the point itself and off
//   it by each coordinate's roundings; off it by the largest coordinate's fewer, and with a bound none.
// - [as-one-thread] The picture has the same bits, however many threads share the rows.
// - [bands] A large picture's samples are taken in bands of rows, between which a window answers. No pixel of the result shows them.
// - [soft-contact] A lamp without an area makes shadows that are on or off; one with an area makes them soft, and the softer,
//   the farther the body is from the floor.
// - [through-glass] Glass casts a shadow, with some light in it.
// - [squares-averaged] The floor's squares are averaged over the ray's cone as the mean of many places is.
// - [to-the-texture] A ray that meets a globe has the colour that its picture has there: found in the world, turned back to the ball's
//   own space, and taken to longitude and latitude. A globe that is turned shows another longitude.
// - [texture-averaged] What a mipmap says of a place of the globe is about the mean round it, and of all of it the mean of the picture.
// - [total-reflection] If the slide's root is negative, all light is reflected and none is refracted.
// - [both-ways] Lambert's, the mirror's and Fresnel's parts are the same with light and eye exchanged; the radiance in the glass, and
//   Phong's lobe as it is printed, are not.
// - [schlick-from-within] Schlick's curve by the angle within the glass is off by up to 0.96 near total reflection.
// - [falls-off] With a falloff the lamp's light is as the square of the distance, and that at the origin is as without. Phong's
//   lobe adds half of the lamp where its mirrored direction leads to the eye, and nothing far from there.
// - [more-samples] More samples come nearer; in cells, or in a sequence, faster than at random.
// - [cauchy] Cauchy's formula through a glass' index and Abbe number gives the maker's index at other lines.
// - [white-stays] The shares of any number of wavelengths are 1 together. Where no glass is met the picture has the same bits, and where all
//   wavelengths have one index it is the same but for roundings.
// - [colours-part] Glass that parts colours has coloured edges, and more of them for a smaller Abbe number. Three wavelengths and many,
//   which look the same without glass, do not look the same behind it.
// - [same-answers] None, boxes, grid and tree find the same triangle at the same t, bit for bit.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "mv/math/transform.h"
#include "ray-trace/passes.h"
#include "ray-trace/ray-trace.h"
#include "ray-trace/spectrum.h"
#include "shared/fresnel.h"
#include "support/demo_run.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

// In the unit disc before a ball of radius 1 at the origin, a ray along -z that far from its middle.
Ray besideMiddle(double distance) { return {{distance, 0, 5}, {0, 0, -1}}; }

TracedScene glassBall(double index) {
    TracedScene scene;
    scene.ambient = vec3(0);
    scene.skyBelow = scene.skyAbove = vec3(1);
    scene.balls = {{{0, 0, 0}, 1, {.index = index}}};
    return scene;
}

TracePicture traced(const TracePicture::Plan& plan) {
    TracePicture picture;
    const int passes = TracePicture::passesOf(plan.samples, plan.width, plan.height);
    for (int pass = 0; pass < passes; ++pass) picture.pass(plan, pass);
    return picture;
}

TracePicture::Plan smallPlan(TracedRoom room) {
    return {.scene = tracedRoom(room, 1.1, 1.5),
            .view = {},
            .options = {},
            .pattern = SamplePattern::sequence,
            .samples = 4,
            .width = 61,
            .height = 37};
}

double meanSquare(const std::vector<vec3>& a, const std::vector<vec3>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) sum += glm::dot(a[i] - b[i], a[i] - b[i]);
    return sum / (3 * double(a.size()));
}

}  // namespace

TEST(RayTraceFull, energy) {
    DemoRun run("ray-trace", 120, 80);
    run.set("room", "white").set("samples", 4);
    for (const double index : {1.0, 1.001, 1.5, 2.5}) {
        for (const int depth : {0, 1, 3, 8, 16}) {
            for (const char* form : {"exact", "schlick"}) {
                (void)run.set("index", index).set("depth", depth).set("fresnel", form).picture();
                // Each of up to 2^16 branches is a product of 16 numbers and a sum
                EXPECT_LE(run.readout("missing"), 1e-12) << index << " " << depth << " " << form;
                if (depth > 0) continue;
                EXPECT_NEAR(run.readout("cut-most"), 100, 1e-10);
            }
        }
    }
    // A ray into the ball is cut off after `depth` rays within: (1 - R) R^(depth - 1) of it, which is largest, over all R, at
    // R = (depth - 1) / depth.
    const TracedScene scene = glassBall(1.5);
    for (const int depth : {2, 8, 9}) {
        double most = 0;
        for (int i = 0; i < 100'000; ++i) {
            const double distance = 1 - std::pow(10.0, -9.0 * i / 100'000);
            most = std::max(most, traceRay(scene, besideMiddle(distance), 0, vec2(0), {.depth = depth}).cut);
        }
        EXPECT_NEAR(most, std::pow(depth - 1, depth - 1) / std::pow(depth, depth), 1e-6) << depth;
    }
}

TEST(RayTraceFull, never_itself) {
    Random random(22);
    for (const double size : {1e-3, 1.0, 1e6}) {
        TracedScene scene;
        scene.balls = {{size * vec3(3, 1, -2), size, {.index = 1.5}}};
        int left = 0;
        for (int i = 0; i < 20'000; ++i) {
            const vec3 eye = size * (vec3(3, 1, -2) + 9.0 * random.direction());
            const vec3 aim = size * (vec3(3, 1, -2) + 0.99 * random.direction());
            const auto met = firstMet(scene, {eye, aim - eye});
            if (!met) continue;
            const vec3 way = random.direction();
            const auto next = firstMet(scene, {startFrom(scene, *met, way), way});
            const bool goesIn = glm::dot(way, met->normal) < 0;
            ASSERT_EQ(next.has_value(), goesIn) << size << " " << i;
            // On the other side: the chord that the angle gives, to the start's distance from the surface
            ++left;
            if (!goesIn) continue;
            const double cosine = -glm::dot(way, met->normal);
            ASSERT_NEAR(next->t, 2 * size * cosine, 1e-13 * size / cosine);
        }
        EXPECT_GT(left, 10'000);
    }
    // Triangles: a floor of two in y = 0, of which a ray meets neither again, and the teapot's, of which it does not meet its own.
    // 1e5 rays, and 1e7 where MVGL_LONG is set.
    const long count = std::getenv("MVGL_LONG") != nullptr ? 10'000'000 : 100'000;
    const vec3 a(-4, 0, -4), b(4, 0, -4), c(4, 0, 4), d(-4, 0, 4);
    for (const bool isFloor : {true, false}) {
        TracedScene scene;
        scene.mesh =
            findTriangles(RayStructure::tree,
                          isFloor ? std::vector<SceneTriangle>{{a, b, c, 0, 0}, {a, c, d, 0, 1}} : teapotTriangles(8));
        long left = 0, again = 0;
        for (long i = 0; i < count; ++i) {
            const vec3 eye = 6.0 * random.direction(),
                       aim = isFloor ? vec3(random.number(-4, 4), 0, random.number(-4, 4)) : random.point(1);
            const auto met = firstMet(scene, {eye, aim - eye});
            if (!met) continue;
            ++left;
            const vec3 way = random.direction();
            const auto next = firstMet(scene, {startFrom(scene, *met, way), way});
            again += next && (isFloor || next->triangle == met->triangle) ? 1 : 0;
        }
        EXPECT_EQ(again, 0) << isFloor;
        EXPECT_GT(left, count / 4) << isFloor;
    }
}

TEST(RayTraceFull, leaves) {
    const auto part = [](int triangles, Leave leave) {
        double again = 0;
        const std::vector<double> all = againOffStrips(triangles, leave);
        for (const double one : all) again += one;
        return again / double(all.size());
    };
    for (const int triangles : {1024, 1048576}) {
        EXPECT_GT(part(triangles, Leave::point), 0.25) << triangles;
        EXPECT_EQ(part(triangles, Leave::components), part(triangles, Leave::point)) << triangles;
        EXPECT_GT(part(triangles, Leave::largest), 0.02) << triangles;
        EXPECT_LT(part(triangles, Leave::largest), part(triangles, Leave::point)) << triangles;
        EXPECT_EQ(part(triangles, Leave::bounded), 0) << triangles;
    }
    // The longer, the more
    EXPECT_GT(part(1048576, Leave::largest), 3 * part(1024, Leave::largest));

    // And so in the picture, whose floor is lit as the endless one is, in the lower rows; or a tenth of the picture is speckled.
    DemoRun run("ray-trace", 96, 64);
    run.set("samples", 4).set("eye-height", 5);
    const auto below = [](const Picture& a, const Picture& b, int top) {
        long differ = 0;
        for (int y = top; y < 64; ++y) {
            for (int x = 0; x < 96; ++x) differ += std::abs(a.at(x, y).red - b.at(x, y).red) > 3;
        }
        return differ;
    };
    const Picture endless = run.set("room", "soft-shadow").picture();
    run.set("room", "strips");
    const Picture right = run.set("leave", "bounded").picture();
    EXPECT_EQ(below(right, endless, 48), 0);
    EXPECT_GT(below(run.set("leave", "components").picture(), right, 0), 614);
    EXPECT_GT(below(run.set("leave", "point").picture(), right, 0), 614);
}

TEST(RayTraceFull, as_one_thread) {
    for (const TracedRoom room : {TracedRoom::stillLife, TracedRoom::softShadow, TracedRoom::white}) {
        TracePicture::Plan plan = smallPlan(room);
        for (const SamplePattern pattern :
             {SamplePattern::regular, SamplePattern::random, SamplePattern::jittered, SamplePattern::sequence}) {
            plan.pattern = pattern;
            plan.threads = 1;
            const TracePicture one = traced(plan);
            for (const int threads : {2, 3, 7}) {
                plan.threads = threads;
                const TracePicture many = traced(plan);
                ASSERT_EQ(one.light(), many.light());
                ASSERT_EQ(one.cut(), many.cut());
                ASSERT_EQ(one.rays(), many.rays());
            }
        }
    }
}

TEST(RayTraceFull, bands) {
    EXPECT_EQ(TracePicture::passesOf(16, 480, 320), TracePicture::passesOf(0, 480, 320) + 16);
    TracePicture::Plan plan = smallPlan(TracedRoom::lamp);
    plan.samples = 1;
    plan.width = 1200;
    plan.height = 1001;
    const int blocks = TracePicture::passesOf(0, plan.width, plan.height);
    ASSERT_EQ(TracePicture::passesOf(1, plan.width, plan.height), blocks + 2);
    TracePicture picture;
    std::vector<std::vector<vec3>> lights;
    for (int pass = 0; pass < blocks + 2; ++pass) {
        picture.pass(plan, pass);
        ASSERT_EQ(picture.developed(), developed(picture.light(), plan.width, plan.height)) << pass;
        lights.push_back(picture.light());
    }
    const std::vector<vec3>&before = lights[lights.size() - 3], &between = lights[lights.size() - 2],
          &after = lights.back();
    const auto middle = std::ptrdiff_t(plan.height / 2) * plan.width;
    EXPECT_TRUE(std::equal(between.begin(), between.begin() + middle, after.begin()));
    EXPECT_TRUE(std::equal(between.begin() + middle, between.end(), before.begin() + middle));
    for (int y = 0; y < plan.height; ++y) {
        const auto row = std::ptrdiff_t(y) * plan.width;
        EXPECT_FALSE(std::equal(before.begin() + row, before.begin() + row + plan.width, after.begin() + row)) << y;
    }
}

TEST(RayTrace, soft_contact) {
    // A ball over the floor at y = 0, and the floor's points along x, under a lamp straight above.
    const auto halfShadow = [](double height, double lampSize) {
        TracedScene scene;
        scene.floor = TracedScene::Floor{0, 1, {}, {}};
        scene.balls = {{{0, height, 0}, 1, {}}};
        int partly = 0, dark = 0;
        for (int i = 0; i < 400; ++i) {
            const vec3 point(3.0 * i / 400, 0, 0);
            double through = 0;
            for (int k = 0; k < 40; ++k)
                through += letThrough(scene, point, {(2 * k + 1 - 40) / 40.0 * lampSize, 8, 0}) / 40;
            dark += through < 1e-9;
            partly += through > 1e-9 && through < 1 - 1e-9;
        }
        EXPECT_GT(dark, 20) << height << " " << lampSize;
        return partly;
    };
    EXPECT_EQ(halfShadow(1.4, 0), 0);
    const int touching = halfShadow(1, 1), above = halfShadow(1.5, 1), high = halfShadow(2.5, 1);
    EXPECT_GT(touching, 0);
    EXPECT_GT(above, touching * 5 / 4);
    EXPECT_GT(high, above * 5 / 4);
}

TEST(RayTrace, through_glass) {
    TracedScene scene = glassBall(1.5);
    const vec3 from(0, -3, 0);
    // Through the middle twice head on: (1 - 0.04)^2
    EXPECT_NEAR(letThrough(scene, from, {0, 5, 0}), 0.96 * 0.96, 1e-12);
    EXPECT_EQ(letThrough(scene, from, {0, -1.5, 0}), 1);  // the lamp is before the ball
    EXPECT_EQ(letThrough(scene, from, {4, -3, 0}), 1);    // beside it
    double before = 1;
    for (int i = 0; i < 20; ++i) {
        const double part = letThrough(scene, {0.05 * i, -3, 0}, {0.05 * i, 5, 0});
        EXPECT_LE(part, before + 1e-12);  // the flatter, the less
        EXPECT_GT(part, 0);
        before = part;
    }
    scene.balls[0].surface = {};
    EXPECT_EQ(letThrough(scene, from, {0, 5, 0}), 0);
}

TEST(RayTrace, squares_averaged) {
    Random random(7);
    for (int i = 0; i < 200; ++i) {
        const double x = random.number(-9, 9), z = random.number(-9, 9), square = random.number(0.3, 2),
                     width = std::pow(10, random.number(-2, 1));
        constexpr int side = 100;
        double light = 0;
        for (int k = 0; k < side * side; ++k) {
            const int row = k / side;
            const double u = x + width * ((k % side + 0.5) / side - 0.5), v = z + width * ((row + 0.5) / side - 0.5);
            light += squaresAround(u, v, square, 0);
        }
        // A line between squares may stand anywhere between two places, along both axes
        const double lines = 2 * (std::floor(width / square) + 1);
        EXPECT_NEAR(squaresAround(x, z, square, width), light / (side * side), lines / side) << width / square;
    }
    // Which square is light: (0, 0) to (square, square) is.
    EXPECT_EQ(squaresAround(0.5, 0.5, 1, 0), 1);
    EXPECT_EQ(squaresAround(-0.5, 0.5, 1, 0), 0);
    EXPECT_NEAR(squaresAround(0.3, 0.2, 1, 200), 0.5, 1e-12);
}

TEST(RayTrace, to_the_texture) {
    // The axes: u goes eastwards, seen from the north counter-clockwise, and v to the north
    EXPECT_NEAR(glm::distance(onTexture({1, 0, 0}), vec2(0.5, 0.5)), 0, 1e-15);
    EXPECT_NEAR(glm::distance(onTexture({0, 0, -1}), vec2(0.75, 0.5)), 0, 1e-15);
    EXPECT_NEAR(glm::distance(onTexture({0, 0, 1}), vec2(0.25, 0.5)), 0, 1e-15);
    EXPECT_EQ(onTexture({0, 1, 0}), vec2(0.5, 1));
    EXPECT_EQ(onTexture({0, -1, 0}), vec2(0.5, 0));
    Random random(3);
    for (int i = 0; i < 200; ++i) {
        const double turn = random.number(-360, 360);
        TracedScene scene;
        scene.ambient = vec3(1);
        const auto texture = std::make_shared<const BallTexture>(globeTexture(turn));
        scene.balls = {{{3, -2, 1}, 0.7, {}, texture}};
        // A place by longitude and latitude in the ball's own space, and a ray straight down on it from the world
        const double east = random.number(-179, 179), north = random.number(-85, 85);
        const vec3 model(std::cos(radians(north)) * std::cos(radians(east)), std::sin(radians(north)),
                         -std::cos(radians(north)) * std::sin(radians(east)));
        const vec3 normal = rotateZ(-23.4) * rotateY(turn) * vec4(model, 0);
        const vec3 seen =
            traceRay(scene, {scene.balls[0].center + 5.0 * normal, -normal}, 1e-3, vec2(0), {.filtered = false}).light;
        const FloatPicture& finest = texture->levels->front();
        const auto column = static_cast<std::size_t>((east + 180) / 360 * finest.width),
                   row = static_cast<std::size_t>((north + 90) / 180 * finest.height),
                   at = 3 * (row * static_cast<std::size_t>(finest.width) + column);
        EXPECT_EQ(seen, vec3(finest.values[at], finest.values[at + 1], finest.values[at + 2])) << east << " " << north;
    }
}

TEST(RayTrace, texture_averaged) {
    const BallTexture globe = globeTexture(0);
    Random random(5);
    double worst = 0;
    for (int i = 0; i < 200; ++i) {
        // Away from the poles, where east and west are as far as north and south
        const double north = random.number(-40, 40), east = random.number(-180, 180),
                     width = std::pow(10, random.number(-2, -0.5));
        const auto normalAt = [](double longitude, double latitude) {
            return vec3(std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                        -std::cos(latitude) * std::sin(longitude));
        };
        const auto back = glm::transpose(globe.modelFromWorld);
        vec3 mean(0);
        constexpr int side = 40;
        for (int k = 0; k < side * side; ++k) {
            const int column = k % side, row = k / side;
            const double along = width * ((column + 0.5) / side - 0.5), up = width * ((row + 0.5) / side - 0.5);
            const double latitude = radians(north) + up;
            mean += textureAround(globe, back * normalAt(radians(east) + along, latitude), 0);
        }
        mean /= side * side;
        const vec3 averaged = textureAround(globe, back * normalAt(radians(east), radians(north)), width);
        worst = std::max(worst, glm::distance(mean, averaged));
    }
    // Texels are squares that lie where they lie, and not about the place: up to a quarter of the step from light to dark
    EXPECT_LT(worst, 0.35);
    // The whole: the mean of the picture, from everywhere the same
    const vec3 all = textureAround(globe, vec3(1, 0, 0), 100);
    EXPECT_LT(glm::distance(all, textureAround(globe, vec3(0, 0, 1), 100)), 1e-7);
    vec3 mean(0);
    const FloatPicture& finest = globe.levels->front();
    for (std::size_t i = 0; i < finest.values.size(); i += 3)
        mean += vec3(finest.values[i], finest.values[i + 1], finest.values[i + 2]) / (double(finest.values.size()) / 3);
    EXPECT_LT(glm::distance(all, mean), 1e-6);
}

TEST(RayTrace, total_reflection) {
    // The slide: cos b = sqrt(1 - sin^2 a / eta^2), with eta = n2 / n1 = 1 / 1.5 from within glass
    const double critical = std::asin(1 / 1.5);
    for (const double angle : {critical + 1e-9, 0.8, 1.2, 1.5}) {
        const double sine = std::sin(angle), cosine = std::cos(angle), eta = 1 / 1.5;
        EXPECT_TRUE(std::isnan(std::sqrt(1 - sine * sine / (eta * eta))));
        EXPECT_FALSE(refracted({sine, -cosine, 0}, {0, 1, 0}, eta));
        EXPECT_EQ(fresnel(cosine, eta).reflected, 1);
        EXPECT_EQ(fresnel(cosine, eta).transmitted, 0);
    }
    EXPECT_TRUE(refracted({std::sin(critical - 1e-9), -std::cos(critical - 1e-9), 0}, {0, 1, 0}, 1 / 1.5));
    // In a ray: from within the ball, 0.8 of the radius beside its middle, nothing gets out, however often it is reflected
    const TracedScene scene = glassBall(1.5);
    const Traced seen = traceRay(scene, {{0.8, 0, 0}, {0, 0, -1}}, 0, vec2(0), {.depth = 12});
    EXPECT_EQ(seen.light, vec3(0));
    EXPECT_EQ(seen.cut, 1);
}

TEST(RayTrace, both_ways) {
    Random random(24);
    double largestRadiance = 0;
    for (int i = 0; i < 1000; ++i) {
        const double index = random.number(1.1, 2.5), sine = random.number(0.01, 0.99),
                     cosine = std::sqrt(1 - sine * sine);
        const auto on = refracted({sine, -cosine, 0}, {0, 1, 0}, index);
        ASSERT_TRUE(on);
        // And back along the same way
        const auto back = refracted(-*on, {0, -1, 0}, 1 / index);
        ASSERT_TRUE(back);
        EXPECT_LT(glm::distance(*back, vec3(-sine, cosine, 0)), 1e-12 / cosine);
        const Split in = fresnel(cosine, index), out = fresnel(std::min(1.0, -on->y), 1 / index);
        EXPECT_NEAR(in.reflected, out.reflected, 1e-11);
        EXPECT_NEAR(in.transmitted, out.transmitted, 1e-11);
        // The power is the same; a beam's radiance is the power by area, cosine and solid angle, and within glass the same
        // power goes through a smaller angle: d(sin^2 a) = index^2 d(sin^2 b).
        constexpr double little = 1e-6;
        const double squareIn = (sine + little) * (sine + little) - sine * sine;
        const auto beside =
            refracted({sine + little, -std::sqrt(1 - (sine + little) * (sine + little)), 0}, {0, 1, 0}, index);
        ASSERT_TRUE(beside);
        const double squareOn = beside->x * beside->x - on->x * on->x, radiance = squareIn / squareOn;
        EXPECT_NEAR(radiance / (index * index), 1, 1e-6);
        largestRadiance = std::max(largestRadiance, radiance);
    }
    EXPECT_GT(largestRadiance, 5);  // an energy from nowhere, for whoever takes radiance for power

    // The lecture's lobe cos^n(angle between mirrored light and eye) / cos(angle of light) with its ways exchanged
    const auto lobe = [](double light, double eye) { return std::pow(std::cos(light - eye), 10) / std::cos(light); };
    EXPECT_GT(lobe(1.4, 1.2) / lobe(1.2, 1.4), 2);
    // Lambert's part is the same for every eye, and a mirror shows the lamp from the eye's place as the eye's place from the lamp's.
    const TracedScene scene = tracedRoom(TracedRoom::softShadow, 0, 1.5);
    const vec3 point = scene.balls[0].center + glm::normalize(vec3(0.2, 0.5, 0.9));
    const auto seenFrom = [&](const vec3& eye) { return traceRay(scene, {eye, point - eye}, 0, vec2(0), {}).light; };
    EXPECT_LT(glm::distance(seenFrom({0, 3, 7}), seenFrom({1, 5, 4})), 1e-12);
    TracedScene mirror = glassBall(1.5);
    mirror.balls[0].surface = {.mirrored = 1};
    mirror.lamps = {{.middle = {0, 3, 3}, .halfU = {0.2, 0, 0}, .halfV = {0, 0.2, -0.2}, .emitted = vec3(7)}};
    // The point where an eye at (3, 3, 0) and the lamp have the same angle to the normal, and the way from there
    const vec3 between = glm::normalize(vec3(1, 2, 1));
    const auto sees = [&](const vec3& eye) { return traceRay(mirror, {eye, between - eye}, 0, vec2(0), {}).light.x; };
    EXPECT_EQ(sees({3, 3, 0}), 7);
    mirror.lamps[0].middle = {3, 3, 0};
    mirror.lamps[0].halfU = {0, 0, 0.2};
    mirror.lamps[0].halfV = {0.2, -0.2, 0};
    EXPECT_EQ(sees({0, 3, 3}), 7);
}

TEST(RayTraceFull, schlick_from_within) {
    // By the angle within, as when the cosine is taken for the ray's own side: near total reflection it knows of nothing.
    const double headOn = 0.04, eta = 1 / 1.5;
    double within = 0, outside = 0;
    for (int i = 0; i < 100'000; ++i) {
        const double cosine = i / 100'000.0, behind = std::sqrt(std::max(0.0, 1 - (1 - cosine * cosine) / (eta * eta)));
        const double exactPart = fresnel(cosine, eta).reflected;
        within = std::max(within, exactPart - schlick(cosine, headOn));
        outside = std::max(outside, std::abs(exactPart - schlick(behind, headOn)));
    }
    EXPECT_NEAR(within, 0.96, 0.005);  // 1 - 0.04 - 0.96 (1 - cos(41.8 degrees))^5
    EXPECT_LT(outside, 0.1);
    // Seen: at the rim of what the glass ball shows
    DemoRun run("ray-trace", 120, 80);
    const Picture exact = run.picture();
    EXPECT_GT(differentPixels(exact, run.set("fresnel", "schlick").picture()), 100);
}

TEST(RayTrace, falls_off) {
    // A grey floor below a lamp without area, from above
    TracedScene scene;
    scene.ambient = vec3(0);
    scene.floor = TracedScene::Floor{0, 1, {.color = vec3(0.8)}, {.color = vec3(0.8)}};
    scene.lamps = {{.middle = {0, 2, 0}}};
    const auto light = [&](double x, const TraceOptions& options) {
        return traceRay(scene, {{x, 3, 0}, {0, -1, 0}}, 0, vec2(0), options).light.x;
    };
    for (const double x : {0.01, 0.5, 1.0, 5.0}) {
        const double without = light(x, {}), with = light(x, {.falloff = true});
        EXPECT_NEAR(with / without, 4 / (4 + x * x), 1e-12) << x;  // a few roundings
    }
    // The eye is where the mirrored ray goes at the origin, straight up, and at 0.01 nearly so
    const double more = light(0.01, {.highlight = 60}) - light(0.01, {});
    EXPECT_NEAR(more, 0.5, 0.002);  // 60 times a cosine's 1 - (0.01 / 2)^2 / 2
    EXPECT_LT(light(5, {.highlight = 60}) - light(5, {}), 1e-6) << "the mirrored ray goes far away from the eye";
    EXPECT_NEAR(light(0.01, {.highlight = 60, .falloff = true}) - light(0.01, {.falloff = true}), more, 1e-4);
}

TEST(RayTraceFull, more_samples) {
    TracePicture::Plan plan = smallPlan(TracedRoom::softShadow);
    plan.pattern = SamplePattern::sequence;
    plan.samples = 1024;
    plan.seed = 99;
    const std::vector<vec3> truth = traced(plan).light();
    plan.seed = 1;
    std::array<double, 4> at16{}, at64{};
    for (std::size_t k = 0; k < 4; ++k) {
        plan.pattern = static_cast<SamplePattern>(k);
        plan.samples = 16;
        at16.at(k) = meanSquare(traced(plan).light(), truth);
        plan.samples = 64;
        at64.at(k) = meanSquare(traced(plan).light(), truth);
    }
    const auto random = static_cast<std::size_t>(SamplePattern::random);
    for (std::size_t k = 0; k < 4; ++k) {
        // A fourfold number of samples takes a quarter, at random; here at least a third of it is gone by any of them
        EXPECT_LT(at64.at(k), at16.at(k) / 1.5) << k;
        if (k == random) continue;
        EXPECT_LT(at64.at(k), at64.at(random) / 2) << k;
    }
    EXPECT_NEAR(at64.at(random) / at16.at(random), 0.25, 0.1);
}

TEST(RayTraceFull, same_answers) {
    for (const int cells : {1, 5, 12}) {
        const std::vector<SceneTriangle> triangles = teapotTriangles(cells);
        const auto none = findTriangles(RayStructure::none, triangles);
        for (const RayStructure structure : {RayStructure::boxes, RayStructure::grid, RayStructure::tree}) {
            const auto finder = findTriangles(structure, triangles);
            Random random(5);
            int hits = 0;
            for (int i = 0; i < 3000; ++i) {
                // From without and within, towards anything, along the axes and to corners of triangles too
                const vec3 origin = i % 3 == 0 ? vec3(0, 0.8, 0) : 4.0 * random.direction();
                vec3 way = vec3(random.number(-1, 1), random.number(0, 1.6), random.number(-1, 1)) - origin;
                if (i % 5 == 1) way = triangles[static_cast<std::size_t>(i) % triangles.size()].a - origin;
                if (i % 7 == 2) way = {0, 0, origin.z > 0 ? -1 : 1};
                const auto expected = none->nearest({origin, way}), got = finder->nearest({origin, way});
                ASSERT_EQ(expected.has_value(), got.has_value()) << i;
                if (!expected) continue;
                ++hits;
                ASSERT_EQ(expected->hit.t, got->hit.t) << i;
                ASSERT_EQ(expected->triangle->object, got->triangle->object) << i;
                ASSERT_EQ(expected->triangle->triangle, got->triangle->triangle) << i;
            }
            EXPECT_GT(hits, 1000);
        }
    }
    for (const RayStructure structure :
         {RayStructure::none, RayStructure::boxes, RayStructure::grid, RayStructure::tree})
        EXPECT_FALSE(findTriangles(structure, {})->nearest({{0, 0, 5}, {0, 0, -1}}));
    EXPECT_EQ(teapotTriangles(16).size(), 16U * 16 * 2 * 32 - 8U * 16);

    DemoRun run("ray-trace", 60, 40);
    run.set("room", "teapot").set("triangles", 1024).set("samples", 1);
    const Picture tree = run.picture();
    for (const char* structure : {"none", "boxes", "grid"}) EXPECT_EQ(tree, run.set("structure", structure).picture());
    EXPECT_NE(run.set("structure", "none").set("triangles", 4096).refusal(), "");
    EXPECT_EQ(run.set("structure", "boxes").refusal(), "");
}

TEST(RayTrace, cauchy) {
    // N-BK7, n_d = 1.51680, V_d = 64.17. Two terms are within 2e-4 of the maker's six. Source: Schott, data sheet of N-BK7 (2014).
    const std::vector<std::pair<double, double>> lines{
        {656.2725, 1.51432}, {587.5618, 1.51680}, {486.1327, 1.52238}, {435.8343, 1.52668}, {404.6561, 1.53024}};
    for (const auto& [nanometres, index] : lines)
        EXPECT_NEAR(indexAt(nanometres, 1.5168, 64.17), index, 2e-4) << nanometres;
    // By definition, for any glass
    EXPECT_NEAR((1.7847 - 1) / (indexAt(486.1327, 1.7847, 25.68) - indexAt(656.2725, 1.7847, 25.68)), 25.68, 1e-9);
    EXPECT_EQ(indexAt(450, 1, 30), 1);
}

namespace {

// All passes of the settings' picture, small, with one ray through each pixel.
TracePicture colored(ray_trace::Settings s) {
    s.samples = 1;
    const TracePicture::Plan plan = ray_trace::planOf(s, 120, 80, {});
    TracePicture picture;
    const int passes = TracePicture::passesOf(1, plan.width, plan.height);
    for (int pass = 0; pass < passes; ++pass) picture.pass(plan, pass);
    return picture;
}

// Root mean square of the difference, and the pixels of which any bit differs.
std::pair<double, int> difference(const TracePicture& a, const TracePicture& b) {
    double squares = 0;
    int differ = 0;
    for (std::size_t i = 0; i < a.light().size(); ++i) {
        const vec3 one = a.light()[i] - b.light()[i];
        squares += glm::dot(one, one) / 3;
        differ += one != vec3(0) ? 1 : 0;
    }
    return {std::sqrt(squares / double(a.light().size())), differ};
}

}  // namespace

TEST(RayTrace, white_stays) {
    for (const int count : {3, 4, 5, 8, 16, 32, 256}) {
        mat3 sum(0);
        for (const TracedWavelength& one : tracedWavelengths(count)) sum += one.share;
        for (int i = 0; i < 3; ++i) {
            for (int k = 0; k < 3; ++k) EXPECT_NEAR(sum[i][k], i == k ? 1 : 0, 1e-13) << count;
        }
    }
    for (const int count : {-1, 0, 1, 2, 257}) EXPECT_THROW((void)tracedWavelengths(count), Error);

    ray_trace::Settings s;
    const TracePicture plain = colored(s);
    s.wavelengths = 8;
    s.abbe = 1e15;
    const auto [same, roundings] = difference(plain, colored(s));
    EXPECT_LT(same, 1e-12);
    s.abbe = 25;
    const auto [parted, changed] = difference(plain, colored(s));
    EXPECT_GT(parted, 1e-3);
    EXPECT_GT(changed, 500);
    EXPECT_LT(changed, 120 * 80 / 2);  // nothing but the glass, what shows it and what it shades
    s.room = TracedRoom::softShadow;
    const TracePicture without = colored(s);
    s.wavelengths = 1;
    EXPECT_EQ(difference(without, colored(s)).second, 0);
}

TEST(RayTraceFull, colours_part) {
    const auto ball = [](int wavelengths, double abbe) {
        return colored({.room = TracedRoom::glassBall, .index = 1.7847, .wavelengths = wavelengths, .abbe = abbe});
    };
    const TracePicture grey = ball(1, 25.68), flint = ball(32, 25.68), crown = ball(32, 64.17), three = ball(3, 25.68);
    const double byFlint = difference(grey, flint).first, byCrown = difference(grey, crown).first;
    EXPECT_GT(byFlint, 0.01);
    EXPECT_GT(byFlint, 1.5 * byCrown);
    // Three are better than one, and no better than that.
    EXPECT_LT(difference(three, flint).first, 0.5 * byFlint);
    EXPECT_GT(difference(three, flint).first, 0.05 * byFlint);
}

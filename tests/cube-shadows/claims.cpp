// The claims of cube-shadows, and a test for each; rows X11 to X16 of docs/stability.md.
//
// - [cast-by-rays] The picture is what rays show, on floor, wall and leaning wall, from lamps and lights at infinity.
// - [no-shadow-seen-from-the-light] An eye at the light, as in the original's first picture, sees no shadow.
// - [special-case] On planes across an axis the slide's special case and the general matrix give the same picture.
// - [transposed-is-wrong] The matrix as the slide prints it, for columns transposed, draws another picture.
// - [darkened-once] However many triangles and casters overlap in a shadow, each of its pixels is darkened once.
// - [between-plane-and-light] Parts above the light, at its height or behind the plane cast nothing.
// - [clip-or-discard] Clip distances and discard cut the same false shadows off.
// - [light-in-the-plane] A light in the plane or behind it throws no shadow there, and a sentence says so.
// - [grazing-light] Under a light 1e-7 above the plane no pixel beside floor and wall is darkened.
// - [far-from-the-origin] A shadow's place is right to 1e-5 of the cube with the plane 1e6 from the origin.
// - [moved-by-hand] The arrow keys turn the light by 5 degrees.
// - [lamp-to-drag] As the demo opens its lamp is in the picture, where its handle is.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/matrix.hpp>
#include <map>

#include "mv/demo/demo.h"
#include "mv/geometry/ray_caster.h"
#include "mv/math/projection.h"
#include "mv/math/shadow.h"
#include "mv/math/transform.h"
#include "mv/study/study.h"
#include "shared/scenes.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr double floorZ = -1.0125;
const Pixel lampColor{255, 153, 0};

using Settings = std::map<std::string, std::string>;

// A view of the room from the right, at a size that is cast fast.
DemoRun inRoom(const Settings& settings = {}) {
    DemoRun run("cube-shadows", 320, 320);
    run.preset("original");
    for (const auto& [knob, text] : Settings{{"scene", "room"},
                                             {"theta", "15"},
                                             {"phi", "68"},
                                             {"distance", "14"},
                                             {"light-theta", "50"},
                                             {"light-phi", "60"},
                                             {"darkness", "0.5"}})
        run.set(knob, text);
    for (const auto& [knob, text] : settings) run.set(knob, text);
    return run;
}

double number(DemoRun& run, const std::string& knob) { return std::stod(run.demo().knob(knob).text()); }
std::string word(DemoRun& run, const std::string& knob) { return run.demo().knob(knob).text(); }

vec4 lightOf(DemoRun& run) {
    const double theta = radians(number(run, "light-theta")), phi = radians(number(run, "light-phi"));
    const vec3 direction(std::sin(phi) * std::cos(theta), std::sin(phi) * std::sin(theta), std::cos(phi));
    if (word(run, "at-infinity") == "on") return {direction, 0};
    return {number(run, "light-distance") * direction, 1};
}

// The scene that the demo draws, for rays.
Scene sceneOf(DemoRun& run) {
    const bool bare = word(run, "scene") == "plane";
    Scene scene = word(run, "scene") == "still-life" ? stillLifeInRoom() : cubeInRoom();
    if (bare) scene.objects.pop_back();
    for (SceneObject& object : scene.objects) {
        mat4& placed = object.worldFromObject;
        if (object.casts) placed = translate(0, 0, number(run, "lift")) * placed;
        if (!object.casts && (bare || object.name == "wall")) placed = placed * rotateX(-number(run, "tilt"));
        if (!object.casts && bare) placed = placed * translate(0, 0, -500) * scale(100, 1, 100);
        object.receives = !object.casts;
    }
    scene.lights = {{.position = lightOf(run)}};
    scene.viewFromWorld = run.matrix("viewFromWorld");
    scene.clipFromView = run.matrix("clipFromView");
    return scene;
}

// The part of the light by which the picture is darker than without shadows, 0..1 a pixel.
struct Darkened {
    Picture with, without;
    static double sum(const Pixel& p) { return p.red + p.green + p.blue; }
    double at(int x, int y) const { return 1 - sum(with.at(x, y)) / sum(without.at(x, y)); }
    bool isDark(int x, int y) const { return sum(without.at(x, y)) > 0 && at(x, y) > 0.25; }
    long count() const {
        long dark = 0;
        for (int y = 0; y < with.height; ++y)
            for (int x = 0; x < with.width; ++x) dark += isDark(x, y);
        return dark;
    }
};

Darkened darkened(DemoRun& run) {
    const std::string darkness = word(run, "darkness");
    Darkened result;
    result.without = run.set("darkness", 0).picture();
    result.with = run.set("darkness", darkness).picture();
    return result;
}

// The number of this pixel, of a picture's numbers, one a pixel.
template <class Numbers>
auto at(const Numbers& numbers, int width, int x, int y) {
    return numbers[pixelIndex(x, y, width)];
}

struct Compared {
    long wrong = 0, shadow = 0, compared = 0;
};

// Each pixel is dark or not as the rays say. Passed over: those with a neighbour that sees something else, for which
// rounding decides, and the lamp and the cube's black edges, which the rays do not know.
Compared againstRays(DemoRun& run) {
    const Darkened drawn = darkened(run);
    const Scene scene = sceneOf(run);
    const int width = drawn.with.width, height = drawn.with.height;
    const LitPicture rays = RayCaster(scene).lit(width, height);
    const auto seen = [&](int x, int y) {  // the object and whether it is dark, as one number
        const int object = at(rays.object, width, x, y);
        const bool dark = object >= 0 && scene.objects[static_cast<std::size_t>(object)].receives &&
                          at(rays.faces, width, x, y) && at(rays.lit, width, x, y) < 0.5;
        return 2 * object + (dark ? 1 : 0);
    };
    Compared result;
    for (int y = 1; y + 1 < height; ++y) {
        for (int x = 1; x + 1 < width; ++x) {
            const int here = seen(x, y);
            const Pixel there = drawn.without.at(x, y);
            bool edge = there == lampColor || there == Pixel{0, 0, 0};
            for (int v = y - 1; v <= y + 1; ++v)
                for (int u = x - 1; u <= x + 1; ++u) edge = edge || seen(u, v) != here;
            if (edge) continue;
            const bool dark = here >= 0 && here % 2 == 1;
            ++result.compared;
            result.shadow += dark;
            result.wrong += drawn.isDark(x, y) != dark;
        }
    }
    return result;
}

std::string textOf(double value) { return numberText(value); }

}  // namespace

TEST(CubeShadowsFull, cast_by_rays) {
    for (const Settings& settings : {
             Settings{{"scene", "plane"}},
             {{"scene", "plane"}, {"tilt", "-20"}, {"phi", "50"}},
             {{"scene", "plane"}, {"phi", "125"}},  // through the plane, from below
             {},
             {{"light-phi", "75"}, {"light-theta", "-20"}, {"light-distance", "4"}},
             {{"tilt", "35"}, {"at-infinity", "on"}, {"light-phi", "70"}},
             {{"scene", "still-life"}},
             {{"scene", "still-life"}, {"tilt", "-15"}, {"light-phi", "70"}, {"light-theta", "20"}},
             {{"scene", "still-life"}, {"at-infinity", "on"}, {"light-phi", "35"}, {"light-theta", "100"}},
         }) {
        DemoRun run = inRoom(settings);
        const Compared result = againstRays(run);
        SCOPED_TRACE(testing::PrintToString(settings));
        EXPECT_EQ(result.wrong, 0);
        EXPECT_GT(result.shadow, 400);
        EXPECT_GT(result.compared, 320 * 320 * 0.85);  // few edges are passed over
    }
    // The front is lit: from below the floor has no shadow.
    DemoRun run = inRoom({{"phi", "120"}});
    const Darkened drawn = darkened(run);
    const Scene scene = sceneOf(run);
    const LitPicture rays = RayCaster(scene).lit(320, 320);
    long ofFloor = 0, dark = 0;
    for (int y = 0; y < 320; ++y) {
        for (int x = 0; x < 320; ++x) {
            const int object = at(rays.object, 320, x, y);
            if (object < 0 || scene.objects[static_cast<std::size_t>(object)].name != "floor") continue;
            ++ofFloor;
            dark += drawn.isDark(x, y);
        }
    }
    EXPECT_GT(ofFloor, 10000);
    EXPECT_EQ(dark, 0);
}

TEST(CubeShadows, no_shadow_seen_from_the_light) {
    // The original's first picture. Caster and shadow have one outline here, so rounding may leave a pixel on it.
    DemoRun run("cube-shadows");
    run.preset("original");
    run.set("darkness", 0.5);
    EXPECT_LE(darkened(run).count(), 5);
    run.set("light-theta", 60);
    EXPECT_GT(darkened(run).count(), 5000);  // elsewhere there is one
}

TEST(CubeShadows, special_case) {
    for (const std::string scene : {"plane", "room", "still-life"}) {
        for (const std::string infinity : {"off", "on"}) {
            DemoRun run = inRoom({{"scene", scene}, {"at-infinity", infinity}});
            const Picture general = run.picture();
            const mat4 m = run.matrix("shadowFromWorld");
            const Picture special = run.set("formula", "axis-aligned").picture();
            const mat4 s = run.matrix("shadowFromWorld");
            // A rounding of the matrix may move a pixel on an outline.
            EXPECT_LE(differentPixels(general, special), 3) << scene << ", at infinity " << infinity;
            for (int column = 0; column < 4; ++column)
                for (int row = 0; row < 4; ++row) EXPECT_NEAR(m[column][row], s[column][row], 1e-14);
        }
    }
    DemoRun run = inRoom({{"formula", "axis-aligned"}, {"tilt", "10"}});
    EXPECT_EQ(run.refusal(), "--tilt: must be 0 for --formula axis-aligned, which knows no other planes, 10");
}

TEST(CubeShadows, transposed_is_wrong) {
    DemoRun run = inRoom({{"space", "world"}, {"scene", "plane"}});
    EXPECT_EQ(againstRays(run).wrong, 0);
    EXPECT_LT(run.readout("place-error"), 1e-5);
    const mat4 right = run.matrix("shadowFromWorld");
    run.set("formula", "transposed");
    EXPECT_GT(againstRays(run).wrong, 1000);
    EXPECT_GT(run.readout("place-error"), 1);
    const mat4 slide = run.matrix("shadowFromWorld");
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row) EXPECT_NEAR(slide[column][row], right[row][column], 1e-14);
    // The slide's matrix does not even put points onto the plane; the right one does.
    const vec4 point(1, -1, 1, 1), miss = slide * point, hit = right * point;
    EXPECT_GT(std::abs(miss.z / miss.w - floorZ), 0.5);
    EXPECT_NEAR(hit.z / hit.w, floorZ, 1e-14);
}

TEST(CubeShadows, darkened_once) {
    DemoRun run = inRoom({{"scene", "still-life"}, {"light-theta", "75"}, {"light-phi", "72"}});
    const auto tally = [&] {
        const Darkened drawn = darkened(run);
        std::array<long, 3> pixels{};  // not, once, oftener
        for (int y = 0; y < drawn.with.height; ++y) {
            for (int x = 0; x < drawn.with.width; ++x) {
                // Half of what is there, which is 50 of 255 at least: two levels of rounding are 0.04.
                const double part = drawn.at(x, y);
                ++pixels[part < 0.04 ? 0 : std::abs(part - 0.5) < 0.04 ? 1 : 2];
            }
        }
        return pixels;
    };
    const auto once = tally();
    EXPECT_EQ(once[2], 0);
    EXPECT_GT(once[1], 3000);
    const auto blended = (run.set("once", "off"), tally());  // front and back of each body, and bodies on each other
    EXPECT_GT(blended[2], 2000);
    EXPECT_EQ(blended[0], once[0]);  // on the same pixels
}

TEST(CubeShadowsFull, between_plane_and_light) {
    struct Case {
        double lift;
        std::string sentence;
    };
    // The light is 4.25 high, the cube from -1 to 1, the floor at -1.0125.
    for (const Case& c : {
             Case{8, "The light is below the cube: it casts no shadow on the floor."},     // X11
             Case{4.25, "Only the part of the cube below the light casts a shadow."},      // X11
             Case{5.25, "The light is below the cube: it casts no shadow on the floor."},  // X12
             Case{3.25, "Only the part of the cube below the light casts a shadow."},      // X12
             Case{-3, "The cube is not above the floor: no shadow of it falls there."},    // X13
             Case{-1, "Only the part of the cube above the floor casts a shadow."},        // X13
         }) {
        SCOPED_TRACE(c.lift);
        DemoRun run = inRoom({{"scene", "plane"}, {"light-distance", "8.5"}});
        run.set("lift", c.lift);
        const Compared result = againstRays(run);
        EXPECT_EQ(result.wrong, 0);
        EXPECT_EQ(run.onlyMessage(), c.sentence);
        EXPECT_EQ(run.measured("place-error"), false);
        // On a wall too; there it is the distance from the wall that counts.
        EXPECT_EQ(againstRays(run.set("scene", "room")).wrong, 0);
    }
    // The twins: not cut off, what is behind the plane has a false shadow (X13).
    for (const double lift : {-3.0, -1.0}) {
        DemoRun run = inRoom({{"scene", "plane"}, {"cut", "none"}});
        EXPECT_GT(againstRays(run.set("lift", lift)).wrong, 200) << lift;
    }
    // And what is above the light has one on the other side of the light, with w' below 0 (X11). GL drops that where the
    // plane is before the eye, and where it is behind the eye no pixel has its tag: here the cut saves the work only.
    DemoRun above = inRoom({{"scene", "plane"}, {"cut", "none"}, {"light-distance", "8.5"}});
    EXPECT_EQ(againstRays(above.set("lift", 8)).wrong, 0);
    const vec4 anti = above.matrix("shadowFromWorld") * vec4(0, 0, 8, 1);
    EXPECT_LT(anti.w, 0);
    EXPECT_NEAR(anti.z / anti.w, floorZ, 1e-13);
    // A wall behind the cube, and the light between them.
    DemoRun run = inRoom({{"light-theta", "180"}, {"light-phi", "90"}, {"light-distance", "2"}});
    EXPECT_EQ(againstRays(run).wrong, 0);
    bool said = false;
    for (const std::string& message : run.messages())
        said = said || message == "The light is nearer to the wall than the cube: it casts no shadow there.";
    EXPECT_TRUE(said);
}

TEST(CubeShadows, clip_or_discard) {
    for (const double lift : {0.0, 4.25, -1.0}) {
        for (const std::string scene : {"room", "still-life"}) {
            DemoRun run = inRoom({{"scene", scene}, {"light-distance", "8.5"}});
            const Picture clipped = run.set("lift", lift).picture();
            const Picture discarded = run.set("cut", "discard").picture();
            // On the line of the cut one asks for the pixel's middle, the other for the polygon's edge: the same line,
            // rounded in two ways.
            EXPECT_LE(differentPixels(clipped, discarded), 20) << scene << ", lifted " << lift;
            if (lift < 0) {
                EXPECT_GT(differentPixels(clipped, run.set("cut", "none").picture()), 100);
            }
        }
    }
}

TEST(CubeShadows, light_in_the_plane) {
    const double inPlane = degrees(std::acos(floorZ / 8.5));
    for (const auto& [phi, sentence] : {
             std::pair{inPlane, "The light lies in the floor: there is no shadow."},
             std::pair{inPlane - degrees(1e-8), "The light lies in the floor: there is no shadow."},
             std::pair{inPlane + 1, "The light is below the floor: no shadow falls on its upper side."},
             std::pair{180.0, "The light is below the floor: no shadow falls on its upper side."},
         }) {
        DemoRun run =
            inRoom({{"scene", "plane"}, {"light-phi", textOf(phi)}, {"cut", "none"}, {"light-distance", "8.5"}});
        EXPECT_EQ(darkened(run).count(), 0) << phi;
        EXPECT_EQ(run.onlyMessage(), sentence);
        EXPECT_FALSE(run.measured("place-error"));
    }
    // At infinity the light is in the plane when it is level; there nothing cancels, and 1e-11 rad is enough.
    DemoRun run = inRoom({{"scene", "plane"}, {"light-phi", "90"}, {"at-infinity", "on"}});
    EXPECT_EQ(darkened(run).count(), 0);
    EXPECT_EQ(run.onlyMessage(), "The light lies in the floor: there is no shadow.");
    // Behind the wall, which then has its shadow side.
    DemoRun behind = inRoom({{"light-theta", "180"}, {"light-phi", "80"}});
    EXPECT_EQ(againstRays(behind).wrong, 0);
    EXPECT_EQ(behind.onlyMessage(), "The light is behind the wall: no shadow falls on its front.");
}

TEST(CubeShadows, grazing_light) {
    // The cube stands half in the floor, so that its shadow begins there and has no end.
    const std::string grazing = textOf(90 - degrees(1e-7));
    for (const std::string scene : {"room", "still-life"}) {
        DemoRun run = inRoom({{"scene", scene},
                              {"lift", "-1"},
                              {"light-phi", grazing},
                              {"light-theta", "60"},
                              {"at-infinity", "on"},
                              {"distance", "25"}});
        const Darkened drawn = darkened(run);
        const Scene seen = sceneOf(run);
        const LitPicture rays = RayCaster(seen).lit(320, 320);
        const auto objectAt = [&](int x, int y) { return at(rays.object, 320, x, y); };
        const auto receives = [&](int object) {
            return object >= 0 && seen.objects[static_cast<std::size_t>(object)].receives;
        };
        long dark = 0, beside = 0;
        for (int y = 1; y < 319; ++y) {
            for (int x = 1; x < 319; ++x) {
                if (!drawn.isDark(x, y)) continue;
                ++dark;
                bool near = false;  // beside a receiver's pixel rounding decides whose this one is
                for (int v = y - 1; v <= y + 1; ++v)
                    for (int u = x - 1; u <= x + 1; ++u) near = near || receives(objectAt(u, v));
                beside += !near;
            }
        }
        EXPECT_GT(dark, 1000);
        EXPECT_EQ(beside, 0);
    }
    // A thousandth of a radian is no difficulty at all.
    DemoRun run = inRoom({{"lift", "-1"}, {"light-phi", textOf(90 - degrees(1e-3))}, {"at-infinity", "on"}});
    EXPECT_EQ(againstRays(run).wrong, 0);
}

TEST(CubeShadows, far_from_the_origin) {
    DemoRun run = inRoom();
    const Picture near = run.picture();
    // Each of its places is right to some roundings of float, 6e-8, of coordinates up to 10.
    for (const double distance : {0.0, 1.0, 1e4, 1e6, 1e8}) {
        const Picture picture = run.set("plane-distance", distance).picture();
        EXPECT_LE(run.readout("place-error"), 1e-5 * 2) << distance;
        if (distance <= 1e6) {
            EXPECT_LE(differentPixels(near, picture), 5) << distance;  // on outlines
        }
    }
    // The twin: in world space, float is off by a thousandth of the cube at 1e4 already.
    run.set("space", "world-float").set("plane-distance", 1e4).picture();
    EXPECT_GT(run.readout("place-error"), 5e-4);

    DemoRun fresh("cube-shadows");

    fresh.preset("original");
    const StudyRun result = runStudy(stage(), *findDemo("cube-shadows").study, {.timed = false});
    ASSERT_EQ(result.rows.size(), 54U);
    for (const StudyRow& row : result.rows) {
        SCOPED_TRACE(row.scene + ", " + row.method + " " + row.parameter);
        const double distance = std::stod(row.parameter);
        if (row.method == "plane-local, double") {
            ASSERT_TRUE(row.ok());
            EXPECT_LE(row.all.max, 1e-5 * 2);  // X16
        } else if (row.method == "world space, float" && distance >= 1e4) {
            ASSERT_TRUE(row.ok());
            EXPECT_GT(row.all.max, 1e-5 * 2);
            EXPECT_GT(row.all.fraction, 0.5);
        } else if (row.method == "world space, double" && distance >= 1e7) {
            // Refused: from there on it would be off by more than a rounding of float.
            EXPECT_EQ(row.status.rfind("shadowProjection: the light must be off the plane by more than", 0), 0U);
        }
    }
}

TEST(CubeShadowsFull, moved_by_hand) {
    DemoRun run = inRoom();
    run.picture();
    struct Case {
        Key key;
        std::string knob;
        double step;
    };
    for (const Case& c : {Case{Key::left, "light-theta", -5},
                          {Key::right, "light-theta", 5},
                          {Key::up, "light-phi", -5},
                          {Key::down, "light-phi", 5}}) {
        const double before = number(run, c.knob);
        const mat4 matrix = run.matrix("shadowFromWorld");
        EXPECT_TRUE(run.demo().press(c.key));
        run.picture();
        EXPECT_NEAR(number(run, c.knob), before + c.step, 1e-12);
        EXPECT_NE(run.matrix("shadowFromWorld"), matrix);
        EXPECT_EQ(againstRays(run).wrong, 0);
    }
}

TEST(CubeShadows, lamp_to_drag) {
    DemoRun run("cube-shadows");
    const Picture picture = run.picture();
    const Scene scene = run.demo().scene(FrameInfo(1, 700, 700));
    const vec3 ndc = ndcFromClip(scene.clipFromWorld() * vec4(vec3(scene.lights[0].position), 1));
    const int x = int((ndc.x + 1) * 350), y = 699 - int((ndc.y + 1) * 350);
    ASSERT_TRUE(x > 20 && x < 680 && y > 20 && y < 680) << x << ", " << y;
    const Pixel lamp = picture.at(x, y);
    EXPECT_GT(lamp.red, 200);
    EXPECT_LT(lamp.blue, 60);
}

// The parts of a demo beside its draw: probes, annotations, things made when they are needed.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "mv/demo/cached.h"
#include "mv/demo/demo.h"
#include "mv/demo/made_for.h"
#include "mv/demo/seen.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/audit.h"
#include "mv/gl/gl.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/scene_meshes.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "mv/show/stage.h"
#include "shadow-methods/lit_difference.h"
#include "shared/scenes.h"
#include "support/demo_of.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

const char* const flatVertex =
    "uniform mat4 clipFromObject;\nin vec4 position;\n"
    "void main() { gl_Position = clipFromObject * position; }\n";
const char* const flatFragment =
    "#include \"measure.glsl\"\nuniform float level;\n"
    "void main() { show(vec3(level), level, true); }\n";

// A cube on a plane, all of one brightness, which is also what is measured; and a white mark that is not.
struct Brightness {
    double level = 0.25;
};
struct Flat final : DemoOf<Brightness> {
    Flat() : DemoOf({mv::number("level", &Brightness::level, {0, 1}, "brightness")}) {}
    Program program;
    SceneMeshes meshes;
    void init() override { program = Program::fromText("flat", flatVertex, flatFragment); }
    Scene scene(const FrameInfo& frame) const override { return cubeOnPlane(frame.aspect()); }
    void draw(const Frame& frame) override {
        const Scene now = mv::seen(scene(frame), frame);
        meshes.follow(now);
        program.use();
        program.set("level", s.level);
        for (const auto& [object, mesh] : meshes.of(now)) {
            program.set("clipFromObject", now.clipFromWorld() * object.worldFromObject);
            mesh.draw();
        }
    }
    void annotate(const Frame&) override {
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, 4, 4);
        glClearColor(1, 1, 1, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }
};

DemoInfo flatInfo(std::vector<Probe> probes) {
    DemoInfo made;
    made.name = "flat";
    made.background = vec4(0, 0, 0, 1);
    made.probes = std::move(probes);
    made.make = [] { return std::make_unique<Flat>(); };
    return made;
}

TEST(Probes, get_the_quantity_and_leave_the_picture_alone) {
    std::vector<float> whole, above, none;
    Picture picture;
    const mat4 box = ortho(-1, 1, -1, 1, 1, 20);
    const Camera fromAbove{lookAt({0, 10, 0}, {0, 0, 0}, {0, 0, -1}), box};
    const Camera elsewhere{lookAt({100, 10, 0}, {100, 0, 0}, {0, 0, -1}), box};
    const DemoInfo info = flatInfo({{{}, [&](Probing& probing) {
                                         EXPECT_EQ(probing.frame().width(), 40);
                                         EXPECT_EQ(probing.demo().number("level"), 0.25);
                                         whole = probing.measured(16, 8);
                                         above = probing.measured(8, 8, fromAbove);
                                         none = probing.measured(8, 8, elsewhere);
                                         picture = probing.picture();
                                         return std::vector<double>{};
                                     }}});
    stage().open(info, 40, 30);
    stage().draw(1);
    const Picture plain = stage().picture();
    const long draws = stage().frameCounters().draws;
    EXPECT_TRUE(whole.empty()) << "nobody reads the readouts";
    stage().draw(1, true);
    EXPECT_EQ(stage().picture(), plain);
    EXPECT_EQ(picture, plain);
    EXPECT_EQ(stage().frameCounters().draws, draws) << "of the picture alone";
    ASSERT_EQ(whole.size(), 16U * 8U);
    // The mark in the corner is an annotation: no part of what is measured.
    for (const float value : whole) EXPECT_TRUE(value == 0.25F || value == -1) << value;
    EXPECT_GT(std::count(whole.begin(), whole.end(), 0.25F), 20);
    EXPECT_EQ(std::count(above.begin(), above.end(), 0.25F), 64) << "the floor fills the view from above";
    EXPECT_EQ(std::count(none.begin(), none.end(), -1.0F), 64) << "beside the floor there is nothing";
    EXPECT_EQ(plain.at(0, 29).red, 255) << "the mark is in the picture";
    stage().close();
}

TEST(Probes, must_give_a_value_for_each_number) {
    const DemoInfo info =
        flatInfo({{{{"a", "one number"}, {"b", "another"}}, [](Probing&) { return std::vector<double>{1}; }}});
    stage().open(info, 8, 8);
    EXPECT_NO_THROW(stage().draw(1));
    try {
        stage().draw(1, true);
        ADD_FAILURE() << "one value for two numbers must be refused";
    } catch (const Error& error) {
        EXPECT_STREQ(error.what(), "probe of flat: must give a value for each of its numbers or none, 1");
    }
    stage().close();
}

// A demo's probes are its readouts, behind its own; a second study or set of probes is refused.
TEST(Probes, become_readouts_by_name) {
    DemoRun run("shadow-volume");
    run.set("scene", "cube");
    (void)run.picture();
    EXPECT_EQ(run.demo().readouts().back()->name(), "wrong");
    EXPECT_EQ(run.readout("wrong"), 0);
    EXPECT_GT(run.readout("shadow-pixels"), 100);
    EXPECT_THROW(addProbes("shadow-volume", {}), Error);
    EXPECT_THROW(addStudy("shadow-volume", {}), Error);
}

TEST(Demo, gives_its_knobs_by_name) {
    const auto demo = findDemo("shadow-volume").make();
    EXPECT_EQ(demo->number("shells"), 12);
    EXPECT_EQ(demo->word("method"), "z-fail");
    EXPECT_THROW((void)demo->number("method"), Error);
    EXPECT_THROW((void)demo->word("no-such-knob"), Error);
}

TEST(SceneMeshes, upload_what_has_changed_and_nothing_else) {
    stage().close();
    SceneMeshes meshes;
    Scene scene = cubeOnPlane(1);
    meshes.follow(scene);
    const auto uploads = [&] {
        startAudit();
        beginAuditedFrame(false);
        meshes.follow(scene);
        const long bytes = endAuditedFrame().bytesUploaded;
        (void)stopAudit();
        return bytes;
    };
    EXPECT_EQ(uploads(), 0);
    scene[cubeOnThePlane].worldFromObject = translate(1, 0, 0);
    scene[cubeOnThePlane].color = vec3(1, 0, 0);
    EXPECT_EQ(uploads(), 0) << "where it stands is no part of the mesh";
    scene[cubeOnThePlane].mesh = box(vec3(-1), vec3(2));
    const long one = uploads();
    EXPECT_GT(one, 0);
    scene.objects.push_back(scene.objects.back());
    EXPECT_EQ(uploads(), one);
    EXPECT_EQ(meshes.of(scene).size(), 3U);
    EXPECT_EQ(&meshes.of(scene)[1].first, &scene.objects[1]);
    ASSERT_EQ(meshes.castersOf(scene).size(), 2U) << "the two cubes; the plane only receives";
    EXPECT_EQ(&meshes.castersOf(scene)[1].first, &scene.objects[2]);
    scene.objects.erase(scene.objects.begin());
    EXPECT_THROW((void)meshes.of(scene), Error);
    meshes.follow(scene);
    EXPECT_EQ(meshes.of(scene).size(), 2U);
}

// The plane, with the cube or without it, all in full light and compared with rays.
struct WithCube {
    bool cube = true;
};
struct Unshaded final : DemoOf<WithCube> {
    Unshaded() : DemoOf({toggle("cube", &WithCube::cube, "a cube stands on the plane")}) {}
    Readout different{this, "different", "pixels that rays find in shadow", "%"};
    Program program;
    SceneMeshes meshes;
    LitDifference difference;
    void init() override { program = Program::fromText("flat", flatVertex, flatFragment); }
    void draw(const Frame& frame) override {
        Scene now = cubeOnPlane(frame.aspect());
        if (!s.cube) now.objects.erase(now.objects.begin() + static_cast<std::ptrdiff_t>(cubeOnThePlane.index));
        meshes.follow(now);
        const auto lit = [&] {
            glEnable(GL_DEPTH_TEST);
            program.use();
            program.set("level", 1.0);
            for (const auto& [object, mesh] : meshes.of(now)) {
                program.set("clipFromObject", now.clipFromWorld() * object.worldFromObject);
                mesh.draw();
            }
        };
        different = difference.show(now, frame, lit).beyondHalf;
    }
};

// The camera is the same in both; so the rays must be cast for the scene, and not for the camera.
TEST(LitDifference, casts_its_rays_anew_for_another_scene) {
    DemoInfo info;
    info.name = "unshaded";
    info.background = vec4(0, 0, 0, 1);
    info.needs.depth = true;
    info.make = [] { return std::make_unique<Unshaded>(); };
    stage().open(info, 64, 48);
    const auto different = [](const char* cube) {
        stage().demo().knob("cube").parse(cube);
        stage().draw(1, true);
        return *stage().demo().readouts().front()->value();
    };
    EXPECT_GT(different("on"), 1) << "the cube throws a shadow";
    EXPECT_EQ(different("off"), 0) << "nothing is left that throws one";
    EXPECT_GT(different("on"), 1);
    stage().close();
}

TEST(MadeFor, is_changed_by_each_of_its_values) {
    MadeFor<int, double> made;
    EXPECT_TRUE(made.changed(1, 2));
    EXPECT_FALSE(made.changed(1, 2));
    EXPECT_TRUE(made.changed(1, 3));
    EXPECT_TRUE(made.changed(2, 3));
    EXPECT_FALSE(made.changed(2, 3));
    made.forget();
    EXPECT_TRUE(made.changed(2, 3));
}

TEST(Cached, makes_a_value_anew_only_for_other_settings) {
    Cached<std::string, int, double> cached;
    EXPECT_EQ(*cached, "") << "nothing was asked yet";
    int made = 0;
    const auto ask = [&](int one, double two) {
        return cached.of({one, two},
                         [&] { return std::to_string(one) + (two < 1 ? "low " : "high ") + std::to_string(++made); });
    };
    EXPECT_EQ(ask(1, 2), "1high 1");
    EXPECT_EQ(ask(1, 2), "1high 1");
    EXPECT_EQ(*cached, "1high 1");
    EXPECT_EQ(cached->size(), 7U);
    EXPECT_EQ(ask(1, 0.5), "1low 2");
    EXPECT_EQ(ask(3, 0.5), "3low 3");
    EXPECT_EQ(ask(1, 2), "1high 4") << "one value is kept, not all";
}

TEST(Cached, what_takes_the_settings_has_nothing_else) {
    Cached<int, int, int> cached;
    EXPECT_EQ(cached.of({6, 7}, [](int a, int b) { return a * b; }), 42);
    EXPECT_EQ(cached.of({6, 8}, [](int a, int b) { return a * b; }), 48);
    const auto ofThemAlone = [](int a, int b) { return a + b; };
    const auto ofMore = [more = 1](int a, int b) { return a + b + more; };
    static_assert(decltype(cached)::mayMake<decltype(ofThemAlone)>);
    static_assert(!decltype(cached)::mayMake<decltype(ofMore)>);
}

// A value that could not be made, of a picture that is too large say, is not taken for made.
TEST(Cached, makes_again_what_could_not_be_made) {
    Cached<int, int> cached;
    EXPECT_EQ(cached.of({1}, [] { return 10; }), 10);
    EXPECT_THROW(cached.of({2}, []() -> int { throw Error("--size", "must be smaller"); }), Error);
    EXPECT_EQ(cached.of({2}, [] { return 20; }), 20);
    EXPECT_THROW(cached.of({3}, []() -> int { throw Error("--size", "must be smaller"); }), Error);
    EXPECT_EQ(cached.of({2}, [] { return 21; }), 21) << "asked for what was there before the failure";
}

TEST(OnDemand, makes_one_when_it_is_asked_for) {
    static int made = 0;
    struct Counted {
        explicit Counted(int number) : value(number) { ++made; }
        int value;
    };
    OnDemand<Counted> counted{7};
    EXPECT_EQ(made, 0);
    EXPECT_EQ(counted->value, 7);
    EXPECT_EQ((*counted).value, 7);
    EXPECT_EQ(made, 1);
}

}  // namespace

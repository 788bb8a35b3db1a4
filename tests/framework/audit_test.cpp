#include "mv/paper/audit.h"

#include <gtest/gtest.h>

#include <iterator>
#include <optional>

#include "mv/geometry/shapes.h"
#include "mv/gl/beyond_es.h"
#include "mv/gl/gl.h"
#include "mv/image/mipmap.h"
#include "mv/math/transform.h"
#include "support/demo_of.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

const char* const plainVertex =
    "uniform mat4 clipFromModel;\nin vec4 position;\nvoid main() { gl_Position = clipFromModel * position; }\n";
const char* const plainFragment = "uniform vec4 paint;\nout vec4 color;\nvoid main() { color = paint; }\n";
const char* const solidFragment =
    "uniform sampler3D solid;\nout vec4 color;\nvoid main() { color = texelFetch(solid, ivec3(0), 0); }\n";
const char* const mapFragment =
    "uniform sampler2D map;\nout vec4 color;\nvoid main() { color = texelFetch(map, ivec2(0), 0); }\n";

// Draws a square; told to, wastes work in one way.
enum class Waste {
    none,
    state,
    initial,
    uniform,
    twice,
    upload,
    refill,
    sample,
    outside,
    buffer,
    texture,
    pass,
    repeated,
    object,
    attribute,
    work,
    levels,
    solid
};
struct Wasting {
    Waste kind = Waste::none;
};
struct Wasteful final : DemoOf<Wasting> {
    using Kind = Waste;
    Wasteful()
        : DemoOf({mv::word("kind", &Wasting::kind,
                           {{"none"},
                            {"state-again"},
                            {"initial-state"},
                            {"uniform-again"},
                            {"uniform-twice"},
                            {"upload-again"},
                            {"refill"},
                            {"no-sample"},
                            {"outside-view"},
                            {"unused-buffer"},
                            {"unsampled-texture"},
                            {"unread-pass"},
                            {"repeated-pass"},
                            {"unused-object"},
                            {"unread-part"},
                            {"needless-work"},
                            {"unread-levels"},
                            {"solid"}},
                           "")}) {}
    Program program, reader, viewer;
    Mesh plate;
    std::optional<Mesh> spare;
    Buffer filled;
    std::optional<DepthMap> map;
    std::optional<Texture> picture, levelled;
    TextureObject solid;

    void init() override {
        program = Program::fromText("plain", plainVertex, plainFragment);
        plate = Mesh(positionsOnly(square()), "plate");
    }
    static TextureObject makeSolid() {
        TextureObject made = makeTexture();
        glBindTexture(GL_TEXTURE_3D, made.id());
        labelObject(GL_TEXTURE, made.id(), "solid");
        const std::vector<std::uint8_t> texels(2 * 3 * 4 * 4);
        glTexImage3D(GL_TEXTURE_3D, 0, GL_RGBA8, 2, 3, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, texels.data());
        for (const GLenum filter : {GLenum(GL_TEXTURE_MIN_FILTER), GLenum(GL_TEXTURE_MAG_FILTER)})
            glTexParameteri(GL_TEXTURE_3D, filter, GL_NEAREST);
        return made;
    }
    void drawPlate(const mat4& clipFromModel) {
        program.set("clipFromModel", clipFromModel);
        plate.draw();
    }
    void draw(const Frame& frame) override {
        glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        if (s.kind != Kind::buffer) glEnable(GL_DEPTH_TEST);
        if (s.kind == Kind::initial) glDisable(GL_BLEND);
        const mat4 upright = rotateX(90) * scale(1.5);
        program.use();
        if (s.kind == Kind::state) glEnable(GL_DEPTH_TEST);
        program.set("paint", vec4(1, 0, 0, 1));
        if (s.kind == Kind::uniform) program.set("paint", vec4(1, 0, 0, 1));
        if (s.kind == Kind::twice) program.set("paint", vec4(1, 1, 0, 1));
        if (s.kind == Kind::pass || s.kind == Kind::repeated) {
            if (!map) map = DepthMap(8, "map");
            map->bindForDrawing();
            glClear(GL_DEPTH_BUFFER_BIT);
            drawPlate(scale(0.5) * upright);
            frame.bindTarget();
        }
        drawPlate(upright);
        const mat4 inFront = translate(0, 0, -0.5) * scale(0.3) * upright;
        if (s.kind == Kind::upload) {  // made for each frame
            MeshData corner;
            corner.positions = {{-0.5F, 0, -0.5F}, {0.5F, 0, -0.5F}, {-0.5F, 0, 0.5F}};
            program.set("clipFromModel", inFront);
            Mesh(corner, "corner").draw();
        }
        if (s.kind == Kind::refill) {  // one object, filled for each frame
            if (!filled.id()) filled = makeBuffer();
            glBindBuffer(GL_ARRAY_BUFFER, filled.id());
            const float bytes[2] = {1, 2};
            glBufferData(GL_ARRAY_BUFFER, sizeof bytes, bytes, GL_STATIC_DRAW);
        }
        if (s.kind == Kind::sample) drawPlate(translate(0, 0, 0.5) * upright);  // behind the first
        if (s.kind == Kind::outside) drawPlate(translate(9, 0, 0) * upright);
        if (s.kind == Kind::texture) {
            if (!picture) picture = Texture(Picture(2, 2), GL_NEAREST, "picture");
            picture->bind(1);
        }
        if (s.kind == Kind::object && !spare) spare = Mesh(wireCube(), "spare");
        if (s.kind == Kind::attribute) {  // it has normals, of which the program knows nothing
            if (!spare) spare = Mesh(withoutTexCoords(sphere(0.2, 8, 4)), "ball");
            program.set("clipFromModel", translate(0, 0, -0.5));
            spare->draw();
        }
        if (s.kind == Kind::work) frame.needless("a light that is off");
        if (s.kind == Kind::levels) {
            if (!viewer.id()) viewer = Program::fromText("viewer", plainVertex, mapFragment);
            if (levelled) {
                levelled->bind(0);
            } else {
                levelled.emplace(mipmaps(FloatPicture(2, 2, 4)), TextureOptions{.label = "levelled"});
                levelled->filterBy({.minify = GL_NEAREST, .magnify = GL_NEAREST});
            }
            viewer.use();
            viewer.set("map", 0);
            viewer.set("clipFromModel", inFront);
            plate.draw();
        }
        if (s.kind == Kind::solid) {  // no waste: a draw reads the 3D texture
            if (!viewer.id()) viewer = Program::fromText("viewer", plainVertex, solidFragment);
            if (!solid.id()) solid = makeSolid();
            glBindTexture(GL_TEXTURE_3D, solid.id());
            viewer.use();
            viewer.set("solid", 0);
            viewer.set("clipFromModel", inFront);
            plate.draw();
        }
        if (s.kind == Kind::repeated) {
            if (!reader.id()) reader = Program::fromText("reader", plainVertex, mapFragment);
            reader.use();
            map->bind(0, DepthLookup::depth);
            reader.set("map", 0);
            reader.set("clipFromModel", inFront);
            plate.draw();
        }
    }
};

DemoInfo wasteful() {
    DemoInfo made;
    made.name = "wasteful";
    made.width = made.height = 32;
    made.needs = {.depth = true};
    made.make = [] { return std::make_unique<Wasteful>(); };
    return made;
}

AuditReport auditOf(const std::string& kind, const DemoInfo& made) {
    return auditDemo(stage(), made, {{"kind", kind}}, 1);
}

std::vector<std::string> kindsFound(const AuditReport& report) {
    std::vector<std::string> kinds;
    for (const Finding& finding : report.findings) kinds.push_back(finding.kind);
    for (const Finding& finding : report.again) kinds.push_back(finding.kind);
    return kinds;
}

}  // namespace

TEST(Audit, a_frame_without_waste_is_clean) {
    const DemoInfo made = wasteful();
    const AuditReport report = auditOf("none", made);
    EXPECT_TRUE(report.clean()) << auditText(report);
    EXPECT_EQ(report.first.draws, 1);
    EXPECT_EQ(report.first.passes, 1);
    EXPECT_EQ(report.first.triangles.submitted, 2);
    EXPECT_EQ(report.first.triangles.surviving, 2);
    EXPECT_EQ(report.first.samplesPassed, 24 * 24) << "a square of 1.5 in a picture 2 wide and 32 pixels across";
    EXPECT_EQ(report.first.bytesUploaded, 64 + 16) << "a matrix and a colour";
    const std::vector<std::string> undone{"glBindVertexArray", "glClearColor", "glUseProgram",
                                          "glEnable(GL_DEPTH_TEST)"};
    EXPECT_EQ(report.undone, undone);
    EXPECT_NE(auditText(report).find("undone after it: glBindVertexArray, "), std::string::npos) << auditText(report);
    EXPECT_FALSE(auditing());
}

TEST(Audit, knows_textures_of_three_dimensions) {
    const AuditReport report = auditOf("solid", wasteful());
    EXPECT_TRUE(report.clean()) << auditText(report);
    const AuditReport none = auditOf("none", wasteful());
    EXPECT_EQ(report.first.bytesUploaded - none.first.bytesUploaded, 2 * 3 * 4 * 4 + 4 + 64)
        << "texels, the sampler's unit and a matrix";
}

// One waste of each kind is found, and only that.
TEST(Audit, each_waste_is_found_by_name) {
    const DemoInfo made = wasteful();
    for (const char* kind : waste::all) {
        const AuditReport report = auditOf(kind, made);
        SCOPED_TRACE(std::string(kind) + "\n" + auditText(report));
        // A map nobody reads is also drawn again and its texture is never used: what follows from one thing is said too.
        if (kind == std::string(waste::unreadPass)) {
            const std::vector<std::string> expected{waste::repeatedPass, waste::unreadPass, waste::unusedObject};
            EXPECT_EQ(kindsFound(report), expected);
        } else if (kind == std::string(waste::unsampled)) {
            const std::vector<std::string> expected{waste::unsampled, waste::unusedObject};
            EXPECT_EQ(kindsFound(report), expected);
        } else {
            EXPECT_EQ(kindsFound(report), std::vector<std::string>{kind});
        }
    }
    EXPECT_EQ(kindsFound(auditOf("uniform-twice", made)), std::vector<std::string>{waste::uniformAgain});
    EXPECT_EQ(kindsFound(auditOf("refill", made)), std::vector<std::string>{waste::uploadAgain});
    EXPECT_EQ(kindsFound(auditOf("unread-levels", made)), std::vector<std::string>{waste::unreadPart});
    // A draw begins in OpenGL's initial state: to set that is to set it again.
    const AuditReport initial = auditOf("initial-state", made);
    EXPECT_EQ(kindsFound(initial), std::vector<std::string>{waste::stateAgain});
    EXPECT_EQ(initial.again.at(0).what, "glEnable/glDisable(GL_BLEND)");
}

TEST(Audit, findings_name_the_culprit) {
    const DemoInfo made = wasteful();
    const auto what = [&](const char* kind) { return auditOf(kind, made).findings.at(0).what; };
    const auto again = [&](const char* kind) { return auditOf(kind, made).again.at(0).what; };
    EXPECT_EQ(again(waste::stateAgain), "glEnable/glDisable(GL_DEPTH_TEST)");
    EXPECT_EQ(again(waste::uniformAgain), "uniform paint");
    EXPECT_EQ(what(waste::uploadAgain), "buffer 'corner vertices'");
    EXPECT_EQ(what("refill"), "buffer without a label");
    EXPECT_EQ(auditOf(waste::uploadAgain, made).findings.at(0).bytes, 3 * 12);
    EXPECT_NE(auditText(auditOf(waste::uploadAgain, made)).find("upload-again: buffer 'corner vertices', 36 bytes"),
              std::string::npos);
    EXPECT_EQ(what(waste::noSample), "draw of 'plate'");
    EXPECT_EQ(what(waste::unsampled), "texture 'picture'");
    EXPECT_EQ(what(waste::unusedObject), "mesh 'spare'");
    EXPECT_EQ(what(waste::repeatedPass), "pass into 'map'");
    EXPECT_EQ(what(waste::unreadPart), "attribute normal of 'ball'");
    EXPECT_EQ(what("unread-levels"), "levels of 'levelled'");
    EXPECT_EQ(what(waste::needlessWork), "a light that is off");
    EXPECT_EQ(what(waste::unusedBuffer), "depth of 'wasteful'");
}

// Passes, draws, buffers, uploads and objects are what a scene may not need; state and uniforms set again are told.
TEST(Audit, what_is_set_again_is_told_and_fails_nothing) {
    const DemoInfo made = wasteful();
    for (const char* kind : {waste::stateAgain, waste::uniformAgain}) {
        const AuditReport report = auditOf(kind, made);
        EXPECT_TRUE(report.clean()) << auditText(report);
        EXPECT_TRUE(auditText(report).find(std::string("again     ") + kind + ": ") != std::string::npos);
        EXPECT_TRUE(auditText(report).find("nothing needless\n") != std::string::npos);
    }
    for (const char* kind : waste::all) {
        const bool told = kind == std::string(waste::stateAgain) || kind == std::string(waste::uniformAgain);
        EXPECT_EQ(auditOf(kind, made).clean(), told) << kind;
    }
    // So there is nothing to declare.
    DemoInfo declared = wasteful();
    const std::initializer_list<DeclaredWaste> needless{{waste::stateAgain, "glViewport", "for no reason"}};
    declared.waste = needless;
    EXPECT_THROW(auditOf(waste::stateAgain, declared), Error);
    stage().close();
}

// Looking does not change what is seen.
TEST(Audit, the_picture_stays) {
    const DemoInfo made = wasteful();
    stage().open(made, 32, 32);
    stage().draw(1);
    const Picture before = stage().picture();
    stage().close();
    startAudit();
    stage().open(made, 32, 32);
    beginAuditedFrame(false);
    stage().draw(1);
    endAuditedFrame();
    EXPECT_EQ(stage().picture(), before);
    stopAudit();
    stage().draw(1);
    EXPECT_EQ(stage().picture(), before);
    stage().close();
}

TEST(Audit, declared_waste_is_excused_and_idle_excuses_are_found) {
    DemoInfo made = wasteful();
    const std::initializer_list<DeclaredWaste> right{{waste::outsideView, "draw of 'plate'", "the lesson is about it"}};
    made.waste = right;
    const AuditReport excused = auditOf(waste::outsideView, made);
    EXPECT_TRUE(excused.clean()) << auditText(excused);
    EXPECT_EQ(excused.excused.size(), 1U);
    EXPECT_NE(auditText(excused).find("the lesson is about it"), std::string::npos);
    const AuditReport stale = auditOf("none", made);
    EXPECT_TRUE(stale.clean()) << "other settings may need it";
    EXPECT_EQ(stale.idleExcuses.size(), 1U);
    // An excuse names one finding, word for word: a part of it would excuse others that nobody has thought of.
    const std::initializer_list<DeclaredWaste> half{{waste::outsideView, "draw of", "all of them"}};
    made.waste = half;
    const AuditReport vague = auditOf(waste::outsideView, made);
    EXPECT_EQ(kindsFound(vague), std::vector<std::string>{waste::outsideView});
    EXPECT_EQ(vague.idleExcuses.size(), 1U);
    // But that # stands for a number, and that a number of times may be its limit.
    struct Bounded {
        Literal what;
        bool holds;
    };
    for (const auto& [what, holds] : std::initializer_list<Bounded>{{"draw of 'plate', up to 2 times", true},
                                                                    {"draw of 'plate', up to 1 times", false},
                                                                    {"draw of 'plate#'", false},
                                                                    {"draw of '#'", false},
                                                                    {"draw of 'plate'#", false}}) {
        const DeclaredWaste bounded{waste::outsideView, what, "bounded"};
        const std::initializer_list<DeclaredWaste> one{bounded};
        made.waste = one;
        EXPECT_EQ(auditOf(waste::outsideView, made).clean(), holds) << what;
    }
    const std::initializer_list<DeclaredWaste> unknown{{"laziness", "", ""}};
    made.waste = unknown;
    EXPECT_THROW(auditOf("none", made), Error);
    EXPECT_FALSE(auditing());
}

// Two things beside each other with the same bytes are no waste; nor is what is made anew with others.
TEST(Audit, two_that_hold_the_same_are_two) {
    stage();
    startAudit();
    beginAuditedFrame(false);
    MeshData corner;
    corner.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const Mesh one(corner, "corner"), other(corner, "corner");
    corner.positions.back().y = 2;
    Mesh third(corner, "corner");
    corner.positions.back().y = 3;
    third = Mesh(corner, "corner");
    EXPECT_EQ(endAuditedFrame().bytesUploaded, 4 * 36);
    for (const Finding& finding : stopAudit()) EXPECT_NE(finding.kind, waste::uploadAgain) << finding.what;
}

// The audit names what ES lacks where it is not declared.
TEST(Audit, what_es_lacks_is_declared) {
    struct Nothing {};
    struct Cutting final : DemoOf<Nothing> {
        Program program;
        Mesh plate;
        void init() override {
            program = Program::fromText("plain", plainVertex, plainFragment);
            plate = Mesh(positionsOnly(square()), "plate");
        }
        void draw(const Frame&) override {
            glClear(GL_COLOR_BUFFER_BIT);
            glEnable(GL_CLIP_DISTANCE0);
            program.use();
            program.set("paint", vec4(1));
            program.set("clipFromModel", rotateX(90));
            plate.draw();
            glDisable(GL_CLIP_DISTANCE0);
        }
    };
    DemoInfo made;
    made.name = "cutting";
    made.width = made.height = 32;
    made.make = [] { return std::make_unique<Cutting>(); };
    const AuditReport report = auditDemo(stage(), made, {}, 1);
    EXPECT_FALSE(report.clean());
    EXPECT_NE(auditText(report).find("undeclared  clip distances: OpenGL ES 3.0 lacks it"), std::string::npos)
        << auditText(report);
    const std::initializer_list<BeyondEs> lacking{{beyond_es::clipDistances, "nothing is cut off"}};
    made.needs.beyondEs = lacking;
    EXPECT_TRUE(auditDemo(stage(), made, {}, 1).clean());
}

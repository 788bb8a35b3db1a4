// Programs of more stages than two, and what is counted of what they make.
#include <gtest/gtest.h>

#include "mv/geometry/shapes.h"
#include "mv/geometry/tessellation.h"
#include "mv/gl/audit.h"
#include "mv/gl/beyond_es.h"
#include "mv/gl/feedback.h"
#include "mv/gl/gl.h"
#include "mv/gl/state.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

using Texts = std::vector<std::pair<std::string, std::string>>;

const std::string passes = "in vec3 position;\nvoid main() { gl_Position = vec4(position, 1.0); }\n";
const std::string white = "out vec4 fragColor;\nvoid main() { fragColor = vec4(1.0); }\n";
const std::string twice =
    "layout(triangles) in;\nlayout(line_strip, max_vertices = 4) out;\n"
    "void main() {\n"
    "    for (int i = 0; i < 4; ++i) {\n        gl_Position = gl_in[i % 3].gl_Position;\n        EmitVertex();\n    }\n"
    "    EndPrimitive();\n}\n";
const std::string levels =
    "layout(vertices = 4) out;\nuniform float inner, outer;\n"
    "void main() {\n"
    "    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n"
    "    for (int i = 0; i < 4; ++i) gl_TessLevelOuter[i] = outer;\n"
    "    for (int i = 0; i < 2; ++i) gl_TessLevelInner[i] = inner;\n}\n";
const std::string square4 =
    "layout(quads) in;\n"
    "void main() { gl_Position = mix(mix(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_TessCoord.x),\n"
    "                               mix(gl_in[2].gl_Position, gl_in[3].gl_Position, gl_TessCoord.x), gl_TessCoord.y); "
    "}\n";
const Texts patch{{"vert", passes}, {"tesc", levels}, {"tese", square4}, {"frag", white}};

Mesh corners() {
    MeshData data;
    data.positions = {{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {1, 1, 0}};
    return Mesh(data, "patch");
}

template <class Function>
std::string errorOf(Function function) {
    try {
        function();
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

class Stages : public testing::Test {
  protected:
    void SetUp() override {
        stage();
        allowVersion(33);
    }
    void TearDown() override {
        EXPECT_EQ(takeErrors(), std::vector<std::string>());
        allowVersion(33);
    }
};

}  // namespace

TEST_F(Stages, of_tessellation_are_refused_until_they_are_declared) {
    EXPECT_EQ(errorOf([] { Program::fromTexts("patch", patch); }),
              "program patch: needs tessellation; declare them in .needs = {.beyondEs = ...}, and ask has() before it "
              "is made");
    EXPECT_NE(errorOf([] { glPatchParameteri(GL_PATCH_VERTICES, 4); }).find("needs OpenGL 4.0"), std::string::npos);
    EXPECT_NE(errorOf([] { mv::has(beyond_es::tessellation); }).find("what is declared"), std::string::npos);
    EXPECT_FALSE(isAllowed(Newer::compute));
    ASSERT_TRUE(allow(Newer::tessellation)) << "llvmpipe has it";
    EXPECT_TRUE(mv::has(beyond_es::tessellation));
    EXPECT_FALSE(isAllowed(Newer::compute)) << "each by itself";
    EXPECT_NE(errorOf([] { glDispatchCompute(1, 1, 1); }).find("needs OpenGL 4.3"), std::string::npos);
    EXPECT_EQ(errorOf([] { Program::fromTexts("patch", patch); }), "no error");
    withhold({beyond_es::tessellation});
    EXPECT_FALSE(mv::has(beyond_es::tessellation));
    withhold({});
    takeMissing();
}

TEST_F(Stages, are_known_by_their_endings) {
    EXPECT_EQ(errorOf([] {
                  Program::fromTexts("x", {{"pixel", white}});
              }),
              "shaders/x.pixel: must end in .vert, .tesc, .tese, .geom, .frag or .comp");
    const std::string mistake = errorOf([] {
        Program::fromTexts("x", {{"vert", passes}, {"geom", twice + "oops\n"}, {"frag", white}});
    });
    EXPECT_NE(mistake.find("x.geom:"), std::string::npos) << mistake;
    const Program lines = Program::fromTexts("x", {{"vert", passes}, {"geom", twice}, {"frag", white}});
    EXPECT_EQ(lines.primitiveOut(GL_TRIANGLES), GLenum(GL_LINES));
    const Program plain = Program::fromText("x", passes, white);
    EXPECT_EQ(plain.primitiveOut(GL_TRIANGLE_FAN), GLenum(GL_TRIANGLES));
    EXPECT_EQ(plain.primitiveOut(GL_LINE_LOOP), GLenum(GL_LINES));
    EXPECT_EQ(plain.primitiveOut(GL_POINTS), GLenum(GL_POINTS));
    ASSERT_TRUE(allow(Newer::tessellation));
    EXPECT_EQ(Program::fromTexts("x", patch).primitiveOut(GL_PATCHES), GLenum(GL_TRIANGLES));
    Texts points = patch;
    points[2].second = "layout(quads, point_mode) in;\n" + points[2].second;
    EXPECT_EQ(Program::fromTexts("x", points).primitiveOut(GL_PATCHES), GLenum(GL_POINTS));
}

// Two queries and what is found in the buffer say the same, and as many as the rule of the tessellator.
TEST_F(Stages, are_counted_alike_by_queries_and_by_feedback) {
    ASSERT_TRUE(allow(Newer::tessellation));
    const Program program = Program::fromTexts("patch", patch);
    const Mesh mesh = corners();
    program.use();
    glPatchParameteri(GL_PATCH_VERTICES, 4);
    const Counters before = counters();
    for (const auto& [inner, outer] :
         {std::pair{1.0, 1.0}, {1.0, 5.0}, {2.0, 1.0}, {3.0, 7.0}, {8.5, 8.0}, {64.0, 64.0}}) {
        program.set("inner", inner);
        program.set("outer", outer);
        const Captured found = captured(GL_TRIANGLES, [&] { mesh.drawAs(GL_PATCHES); });
        EXPECT_EQ(found.generated, trianglesOfSquare(inner, outer)) << inner << " " << outer;
        EXPECT_EQ(found.written, found.generated);
        EXPECT_EQ(found.positions.size(), 3U * static_cast<std::size_t>(found.generated));
    }
    EXPECT_EQ(counters().draws, before.draws);
    EXPECT_EQ(changedState(),
              (std::vector<std::string>{"glBindVertexArray", "glPatchParameteri", "glUseProgram", "glBindBuffer"}));

    const Program lines = Program::fromTexts("x", {{"vert", passes}, {"geom", twice}, {"frag", white}});
    const Mesh cube(colorCube());
    lines.use();
    const Captured found = captured(GL_LINES, [&] { cube.draw(); });
    EXPECT_EQ(found.generated, 3 * 12);
    EXPECT_EQ(found.written, 3 * 12);
    EXPECT_EQ(found.positions.size(), 2U * 3 * 12);
}

// A program that makes its own triangles is audited by these, and one that makes lines is no error.
TEST_F(Stages, are_audited) {
    ASSERT_TRUE(allow(Newer::tessellation));
    const Mesh mesh = corners(), cube(colorCube());
    restoreInitialState();
    stage().front();
    const Target target(8, 8, {});
    startAudit();
    const Program program = Program::fromTexts("patch", patch);
    const Program lines = Program::fromTexts("x", {{"vert", passes}, {"geom", twice}, {"frag", white}});
    target.bind();
    beginAuditedFrame(false);
    program.use();
    glPatchParameteri(GL_PATCH_VERTICES, 4);
    program.set("inner", 4.0);
    program.set("outer", 4.0);
    mesh.drawAs(GL_PATCHES);
    lines.use();
    cube.draw();
    EXPECT_EQ(captured(GL_LINES, [&] { cube.draw(); }).written, 36) << "a measurement is no work of the frame";
    const FrameWork work = endAuditedFrame();
    const std::vector<Finding> findings = stopAudit();
    EXPECT_EQ(work.draws, 2);
    EXPECT_EQ(work.triangles.submitted, 32);
    EXPECT_EQ(work.triangles.surviving, 32);
    EXPECT_TRUE(findings.empty()) << findings.front().what;
    EXPECT_EQ(takeBeyondEs(), (std::set<std::string>{beyond_es::countingQueries, beyond_es::expandedFeedback,
                                                     beyond_es::geometryShaders, beyond_es::tessellation}));
    restoreInitialState();
}

TEST_F(Stages, of_compute_write_an_image) {
    const std::string computes =
        "layout(local_size_x = 4, local_size_y = 4) in;\nlayout(rgba8) uniform writeonly image2D image;\n"
        "void main() { imageStore(image, ivec2(gl_GlobalInvocationID.xy), vec4(1.0, 0.5, 0.0, 1.0)); }\n";
    EXPECT_EQ(errorOf([&] {
                  Program::fromTexts("c", {{"comp", computes}});
              }).find("program c: needs compute shaders"),
              0U);
    ASSERT_TRUE(allow(Newer::compute)) << "llvmpipe has it";
    const Program program = Program::fromTexts("c", {{"comp", computes}});
    const Target target(8, 8, {.texture = true});
    target.bind();
    glClear(GL_COLOR_BUFFER_BIT);
    EXPECT_EQ(errorOf([] { Target(8, 8, {}).bindImage(0); }),
              "target: must be made with Buffers::texture, of GL_RGBA8, to be written as an image");
    target.bind();
    program.use();
    target.bindImage(0);
    glDispatchCompute(2, 2, 1);
    glMemoryBarrier(GL_FRAMEBUFFER_BARRIER_BIT);
    glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
    for (const float red : target.readRed()) EXPECT_EQ(red, 1.0F);
    restoreInitialState();
}

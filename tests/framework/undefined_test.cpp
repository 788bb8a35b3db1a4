// The checks find what OpenGL leaves undefined, without a driver that mentions it: each check by one draw that deserves it, beside one
// that does not.
#include "mv/gl/undefined.h"

#include <gtest/gtest.h>

#include "mv/geometry/shapes.h"
#include "mv/gl/depth_map.h"
#include "mv/gl/gl.h"
#include "mv/gl/state.h"
#include "mv/gl/texture.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

const std::string vertex = "in vec3 position;\nvoid main() { gl_Position = vec4(position, 1.0); }\n";

Program reading(const std::string& samplers, const std::string& color) {
    return Program::fromText("reading", vertex,
                             samplers + "out vec4 fragColor;\nvoid main() { fragColor = " + color + "; }\n");
}

MeshData triangle() {
    MeshData data;
    data.positions = {{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}};
    return data;
}

class Undefined : public testing::Test {
  protected:
    void SetUp() override {
        restoreInitialState();
        target = Target(8, 8, {.depth = true}, "target");
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        mesh = Mesh(triangle(), "triangle");
        ASSERT_TRUE(watchingUndefined());
        takeErrors();
    }
    void TearDown() override {
        restoreInitialState();
        EXPECT_EQ(takeErrors(), std::vector<std::string>());
    }
    // The sentences on one draw of the triangle; "" where nothing is.
    std::string faults(const Program& program) const {
        program.use();
        mesh.draw();
        std::string all;
        for (const std::string& one : takeErrors()) all += (all.empty() ? "" : "; ") + one;
        return all;
    }

    Target target;
    Mesh mesh;
    const Program white = (stage(), reading("", "vec4(1.0)"));  // a program needs a context
    const Program image = reading("uniform sampler2D image;\n", "texture(image, vec2(0.5))");
    const Program shadow = reading("uniform sampler2DShadow map;\n", "vec4(texture(map, vec3(0.5)))");
};

const Picture checks(2, 2);

}  // namespace

TEST_F(Undefined, a_draw_without_fault_is_left_in_peace) {
    EXPECT_EQ(faults(white), "");
    const Texture texture(checks, GL_LINEAR, "checks");
    texture.bind(0);
    EXPECT_EQ(faults(image), "");
    DepthMap::empty().bind(0, DepthLookup::compareLinear);
    EXPECT_EQ(faults(shadow), "draw of 'triangle': sampler map reads unit 0, where no texture is bound")
        << "it is deleted";
    const DepthMap map = DepthMap::empty();
    map.bind(0, DepthLookup::compareLinear);
    EXPECT_EQ(faults(shadow), "");
}

TEST_F(Undefined, a_unit_holds_a_texture_of_its_samplers_kind) {
    EXPECT_EQ(faults(image), "draw of 'triangle': sampler image reads unit 0, where no texture is bound");
    const Texture texture(checks, GL_LINEAR, "checks");
    texture.bind(0);
    EXPECT_EQ(
        faults(shadow),
        "draw of 'triangle': sampler map reads unit 0, texture 'checks', which holds no depths, and a shadow sampler "
        "compares depths");
    const DepthMap map = DepthMap::empty("map");
    map.bind(0, DepthLookup::depth);
    EXPECT_EQ(faults(shadow),
              "draw of 'triangle': sampler map reads unit 0, texture 'map', whose comparison is off "
              "(GL_TEXTURE_COMPARE_MODE), and it is read by a shadow sampler");
    map.bind(0, DepthLookup::compareNearest);
    EXPECT_EQ(
        faults(image),
        "draw of 'triangle': sampler image reads unit 0, texture 'map', which compares depths, and it is read by a "
        "sampler that does not");
    texture.bind(0);
    EXPECT_EQ(
        faults(reading("uniform usampler2D image;\n", "vec4(texture(image, vec2(0.5)))")),
        "draw of 'triangle': sampler image reads unit 0, texture 'checks', whose numbers are of another kind than the "
        "sampler's");
    EXPECT_EQ(faults(reading("uniform samplerCube image;\n", "texture(image, vec3(0.5))")),
              "draw of 'triangle': sampler image reads unit 0, where no texture is bound")
        << "what is bound is no cube";
    EXPECT_NE(faults(reading("uniform sampler2D image;\nuniform samplerCube cube;\n",
                             "texture(image, vec2(0.5)) + texture(cube, vec3(0.5))"))
                  .find("as another kind of sampler does"),
              std::string::npos);
}

TEST_F(Undefined, a_uniform_was_set) {
    const Program tinted = reading("uniform vec4 tint;\n", "tint");
    EXPECT_EQ(faults(tinted),
              "draw of 'triangle': uniform tint of program 'reading' is used and was never set: it is 0");
    tinted.set("tint", vec4(1));
    EXPECT_EQ(faults(tinted), "");
    const Program another = reading("uniform vec4 tint;\n", "tint");
    EXPECT_NE(faults(another), "") << "set in one program, not in the next";
    another.set("tint", vec4(0));
    EXPECT_EQ(faults(another), "") << "0 is a value";

    // A program reads as many elements of an array as it is told.
    const Program lit = reading("uniform vec4 lamps[2];\nuniform int count;\n", "count > 1 ? lamps[1] : vec4(0.0)");
    lit.use();
    lit.set("count", 0);
    EXPECT_EQ(faults(lit), "");
}

TEST_F(Undefined, a_texture_is_complete) {
    const Texture texture(checks, GL_LINEAR, "checks");
    texture.bind(0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    EXPECT_EQ(
        faults(image),
        "draw of 'triangle': sampler image reads unit 0, texture 'checks', which is not complete: level 1 is missing "
        "or of another size or format");
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    EXPECT_EQ(faults(image), "") << "one level is all it may have";
    const TextureObject none = makeTexture();
    glBindTexture(GL_TEXTURE_2D, none.id());
    EXPECT_NE(faults(image).find("which has no texels"), std::string::npos);
}

TEST_F(Undefined, no_texture_is_read_that_is_drawn_into_or_was_never_written) {
    const Target texture(8, 8, {.texture = true}, "texture");
    texture.bindColor(0);
    target.bind();
    EXPECT_EQ(faults(image),
              "draw of 'triangle': sampler image reads unit 0, texture 'texture', whose colors were never written");
    texture.bind();
    EXPECT_EQ(
        faults(image),
        "draw of 'triangle': sampler image reads unit 0, texture 'texture', which the draw writes; draw of 'triangle': "
        "sampler image reads unit 0, texture 'texture', whose colors were never written");
    glClear(GL_COLOR_BUFFER_BIT);
    target.bind();
    EXPECT_EQ(faults(image), "");
}

TEST_F(Undefined, buffers_are_written_before_a_test_blending_or_a_read_back_reads_them) {
    const Target fresh(8, 8, {.depth = true, .stencil = true}, "fresh");
    EXPECT_EQ(faults(white), "") << "it only writes";
    glEnable(GL_DEPTH_TEST);
    EXPECT_EQ(faults(white),
              "draw of 'triangle': a test or blending reads the depths of 'fresh', which were never written");
    glClear(GL_DEPTH_BUFFER_BIT);
    EXPECT_EQ(faults(white), "");
    glEnable(GL_STENCIL_TEST);
    EXPECT_EQ(faults(white),
              "draw of 'triangle': a test or blending reads the stencil values of 'fresh', which were never written");
    restoreInitialState();
    const Target blended(8, 8, {}, "blended");
    glEnable(GL_BLEND);
    EXPECT_EQ(faults(white),
              "draw of 'triangle': a test or blending reads the colors of 'blended', which were never written");
    const Target read(8, 8, {}, "read");
    (void)read.read();
    EXPECT_EQ(takeErrors(),
              std::vector<std::string>{"read-back: it reads the colors of 'read', which were never written"});
}

TEST_F(Undefined, attributes_and_indices_stay_within_their_buffers) {
    const VertexArray array = makeVertexArray();
    const Buffer buffer = makeBuffer(), indices = makeBuffer();
    white.use();
    glBindVertexArray(array.id());
    glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
    const float corners[9] = {};
    glBufferData(GL_ARRAY_BUFFER, sizeof corners, corners, GL_STATIC_DRAW);
    glEnableVertexAttribArray(0);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    EXPECT_EQ(takeErrors(), std::vector<std::string>());
    glDrawArrays(GL_TRIANGLES, 1, 3);
    const std::vector<std::string> beyond = takeErrors();
    ASSERT_EQ(beyond.size(), 1U);
    EXPECT_NE(beyond[0].find("attribute 0 ends before vertex 3: its buffer has 36 bytes of 48"), std::string::npos);
    const std::uint8_t three[3] = {0, 1, 3};
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices.id());
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, sizeof three, three, GL_STATIC_DRAW);
    glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_BYTE, nullptr);
    EXPECT_EQ(takeErrors().size(), 1U) << "the largest index is 3";
    glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_SHORT, nullptr);
    const std::vector<std::string> few = takeErrors();
    ASSERT_FALSE(few.empty());
    EXPECT_NE(few[0].find("its indices reach beyond their buffer"), std::string::npos);
}

TEST_F(Undefined, lines_have_no_polygons_offset) {
    glEnable(GL_POLYGON_OFFSET_FILL);
    EXPECT_EQ(faults(white), "");
    MeshData edge = triangle();
    edge.primitive = Primitive::lines;
    edge.positions.pop_back();
    mesh = Mesh(edge, "edge");
    EXPECT_NE(faults(white).find("draw of 'edge': points and lines have no polygon's offset"), std::string::npos);
    glDisable(GL_POLYGON_OFFSET_FILL);
    EXPECT_EQ(faults(white), "");
}

TEST_F(Undefined, queries_and_feedback_are_begun_and_ended_in_order) {
    GLuint query = 0, result = 0;
    glGenQueries(1, &query);
    glBeginQuery(GL_ANY_SAMPLES_PASSED, query);
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &result);
    EXPECT_EQ(takeErrors().front(), "query: asked for its result, and it was not begun and ended");
    glBeginQuery(GL_ANY_SAMPLES_PASSED, query);
    EXPECT_EQ(takeErrors().front(), "query: begun while another of its kind is open");
    glEndQuery(GL_ANY_SAMPLES_PASSED);
    EXPECT_EQ(takeErrors(), std::vector<std::string>());
    glEndQuery(GL_ANY_SAMPLES_PASSED);
    EXPECT_EQ(takeErrors().front(), "query: ended, and none of its kind was begun");
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &result);
    EXPECT_EQ(takeErrors(), std::vector<std::string>());
    glDeleteQueries(1, &query);
    glEndTransformFeedback();
    EXPECT_EQ(takeErrors().front(), "transform feedback: ended, and it was not begun");
}

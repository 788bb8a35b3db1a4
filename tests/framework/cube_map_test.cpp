// Cube maps: what is uploaded or drawn is found again in its direction, across edges and at corners.
#include "mv/gl/cube_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "mv/geometry/shapes.h"
#include "mv/gl/gl.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

class CubeMaps : public testing::Test {
  protected:
    void SetUp() override { stage(); }
    void TearDown() override { EXPECT_EQ(takeErrors(), std::vector<std::string>()); }
};

// One texel a face: red tells the face, 40 levels apart.
std::array<FloatPicture, cubeFaces> plainFaces(int size) {
    std::array<FloatPicture, cubeFaces> faces;
    for (std::size_t face = 0; face < faces.size(); ++face) {
        faces.at(face) = FloatPicture(size, size, 4);
        for (float& value : faces.at(face).values) value = float(40 * (face + 1)) / 255;
    }
    return faces;
}

// The texel that texture() finds in that direction.
Pixel lookedUp(const CubeMap& map, const vec3& way) {
    const Program program = Program::fromText(
        "look", "in vec4 position;\nvoid main() { gl_Position = position; }\n",
        "uniform samplerCube cube;\nuniform vec3 way;\nout vec4 color;\nvoid main() { color = texture(cube, way); }\n");
    const Mesh pane(
        {.primitive = Primitive::triangleStrip, .positions = {{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {1, 1, 0}}});
    const Target target(1, 1, {});
    target.bind();
    program.use();
    program.set("way", way);
    map.bind(0);
    pane.draw();
    return target.read().at(0, 0);
}

}  // namespace

TEST_F(CubeMaps, a_face_is_found_in_its_direction) {
    const CubeMap map(plainFaces(4));
    EXPECT_EQ(map.size(), 4);
    for (int face = 0; face < cubeFaces; ++face)
        EXPECT_EQ(lookedUp(map, cubeDirection({face, {0.5, 0.5}})).red, 40 * (face + 1)) << face;
}

TEST_F(CubeMaps, a_texel_is_found_where_cubePlace_says) {
    for (int face = 0; face < cubeFaces; ++face) {
        auto faces = plainFaces(4);
        FloatPicture& picture = faces.at(static_cast<std::size_t>(face));
        for (std::size_t i = 0; i < 16; ++i) picture.values[4 * i] = float(10 * i) / 255;
        const CubeMap map(faces);
        for (int i = 0; i < 16; ++i) {
            const int row = i / 4;
            const vec2 at((i % 4 + 0.5) / 4, (row + 0.5) / 4);
            // The middle of a texel, where the others have no weight; one level is for the driver's own sums.
            EXPECT_NEAR(lookedUp(map, cubeDirection({face, at})).red, 10 * i, 1) << face << " " << i;
        }
    }
}

TEST_F(CubeMaps, what_is_drawn_is_found_again) {
    CubeMap map(32);
    const Program program =
        Program::fromText("plain", "uniform mat4 m;\nin vec4 position;\nvoid main() { gl_Position = m * position; }\n",
                          "uniform vec4 c;\nout vec4 color;\nvoid main() { color = c; }\n");
    const Mesh ball(sphere(0.5, 16, 8));  // some texels large
    const vec3 places[] = {{3, 1, 0.5}, {-3, 1, 0.5}, {0.5, 3, 1}, {0.5, -3, 1}, {1, 0.5, 3}, {1, 0.5, -3}};
    glViewport(0, 0, 32, 32);
    glEnable(GL_DEPTH_TEST);
    glClearColor(0, 0, 0, 1);
    for (int face = 0; face < cubeFaces; ++face) {
        map.bindForDrawing(face);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        program.use();
        for (int i = 0; i < 6; ++i) {
            program.set("m", perspective(90, 1, 0.1, 10) * cubeFaceView(face) * translate(places[i]));
            program.set("c", vec4(40.0 * (i + 1) / 255, 0, 0, 1));
            ball.draw();
        }
    }
    glDisable(GL_DEPTH_TEST);
    for (int i = 0; i < 6; ++i) {
        EXPECT_EQ(lookedUp(map, places[i]).red, 40 * (i + 1)) << i;
        EXPECT_EQ(lookedUp(map, places[i] + vec3(1.2)).red, 0) << i;
    }
    glClearColor(0, 0, 0, 0);
}

TEST_F(CubeMaps, corners_have_part_of_three_faces) {
    const CubeMap map(plainFaces(2));
    if (!isEs()) glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    // +x 40, +y 120, +z 200: none of them alone, but something between.
    const int corner = lookedUp(map, vec3(1, 1, 1)).red, edge = lookedUp(map, vec3(1, 0, 1)).red;
    EXPECT_NEAR(corner, 120, 2);
    EXPECT_NEAR(edge, 120, 2);
    if (isEs()) return;
    glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    const int alone = lookedUp(map, vec3(1, 0, 1)).red;
    EXPECT_TRUE(alone == 40 || alone == 200) << alone;
}

TEST_F(CubeMaps, what_cannot_be_made_is_refused) {
    EXPECT_THROW(CubeMap(0), Error);
    EXPECT_THROW(CubeMap(1 << 24), Error);
    auto faces = plainFaces(4);
    faces[3] = FloatPicture(4, 5, 4);
    EXPECT_THROW((CubeMap(faces)), Error);
    faces[3] = FloatPicture(4, 4, 3);
    EXPECT_THROW((CubeMap(faces)), Error);
    const CubeMap map(plainFaces(4));
    EXPECT_THROW(map.bindForDrawing(0), Error);
    const CubeMap drawn(4);
    EXPECT_THROW(drawn.bindForDrawing(6), Error);
}

// Shapes over a picture: where they are, what hides them, what they leave, and what they cost.
#include "mv/gl/drawing.h"

#include <gtest/gtest.h>

#include "mv/gl/audit.h"
#include "mv/gl/gl.h"
#include "mv/gl/state.h"
#include "mv/gl/text.h"
#include "mv/math/transform.h"
#include "shared/wide_lines.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

const vec4 red(1, 0, 0, 1);
const Pixel redPixel{255, 0, 0, 255}, white{255, 255, 255, 255};

class DrawingTest : public testing::Test {
  protected:
    DrawingTest() {
        stage().close();
        target = Target(80, 60, {.depth = true}, "picture");
        glClearColor(1, 1, 1, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        drawing.begin(frame);
    }
    ~DrawingTest() override {
        forgetText();
        restoreInitialState();
        EXPECT_EQ(takeErrors(), std::vector<std::string>());
    }
    Picture drawn() {
        drawing.draw(frame);
        return target.read();
    }

    Target target;
    FrameNotes notes;
    Frame frame{{1, 80, 60}, notes, {}};
    Drawing drawing;
};

}  // namespace

TEST_F(DrawingTest, a_pane_has_its_own_pixels_and_cuts_what_is_beyond_it) {
    drawing.in({30, 20, 40, 30});
    drawing.fill({{5, 2}, {10, 8}}, red);
    Picture picture = drawn();
    EXPECT_EQ(countPixels(picture, redPixel), 5 * 6);
    EXPECT_EQ(picture.at(35, 60 - 1 - 22), redPixel) << "the lower left pixel of the box, from the upper left corner";
    EXPECT_EQ(picture.at(39, 60 - 1 - 27), redPixel);
    drawing.begin(frame);
    drawing.in({30, 20, 40, 30});
    drawing.fill({{-100, -100}, {100, 100}}, red);
    drawing.line({-50, 15}, {50, 15}, {.color = vec4(0, 0, 1, 1), .width = 4});
    drawing.arrow({20, 0}, {20, 90});
    drawing.point({0, 0}, 20, vec4(0, 1, 0, 1));
    picture = drawn();
    EXPECT_EQ(countPixels(picture, white), 80 * 60 - 40 * 30);
}

TEST_F(DrawingTest, a_unit_has_as_many_pixels_as_the_picture_is_larger) {
    const auto inkOf = [&](int times) {
        target = Target(80 * times, 60 * times, {.depth = true}, "picture");
        glClearColor(1, 1, 1, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        const Frame larger({1, 80 * times, 60 * times, figureUnit(80 * times, 60 * times, 80, 60)}, notes, {});
        EXPECT_EQ(larger.inUnits().width(), 80);
        EXPECT_EQ(larger.inUnits().inUnits().height(), 60);
        EXPECT_EQ(larger.inUnits().inPixels().width(), 80 * times);
        drawing.begin(larger);
        drawing.in({30, 20, 40, 30});
        drawing.fill({{5, 2}, {10, 8}}, red);
        drawing.text({2, 28}, "words", {.height = 12, .color = vec4(0, 0, 1, 1), .background = vec4(0)});
        drawing.line({0, 1}, {40, 1}, {.color = vec4(0, 1, 0, 1), .width = 2});
        drawing.draw(larger);
        return target.read();
    };
    const Picture once = inkOf(1), thrice = inkOf(3);
    EXPECT_EQ(countPixels(thrice, redPixel), 9 * countPixels(once, redPixel));
    EXPECT_EQ(thrice.at(3 * 35 + 1, 180 - 1 - 3 * 22), redPixel);
    EXPECT_EQ(countPixels(thrice, {0, 255, 0, 255}), 9 * countPixels(once, {0, 255, 0, 255})) << "a sharp line";
    // Words have the same place; and as sharp edges, of which a larger picture has fewer
    const auto words = [](const Picture& picture) {
        Box box{vec2(1e9), vec2(-1)};
        for (int y = 0; y < picture.height; ++y) {
            for (int x = 0; x < picture.width; ++x) {
                const Pixel pixel = picture.at(x, y);
                if (pixel.blue < 250 || pixel.red > 128) continue;
                box.low = glm::min(box.low, vec2(x, y));
                box.high = glm::max(box.high, vec2(x + 1, y + 1));
            }
        }
        return box;
    };
    const Box small = words(once), large = words(thrice);
    for (int axis = 0; axis < 2; ++axis) {
        EXPECT_NEAR(large.low[axis] / 3, small.low[axis], 1.5) << "whole pixels of the smaller one";
        EXPECT_NEAR(large.size()[axis] / 3, small.size()[axis], 3);
    }
}

// As with the words, so with the box behind them: a padding of 4 pixels is one of 12 in a picture that is three times as large.
TEST_F(DrawingTest, the_box_behind_words_grows_with_them) {
    const auto heightOfBox = [&](int times) {
        target = Target(80 * times, 60 * times, {.depth = true}, "picture");
        glClearColor(1, 1, 1, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        const Frame larger({1, 80 * times, 60 * times, figureUnit(80 * times, 60 * times, 80, 60)}, notes, {});
        drawText(larger.inUnits(), 10, 10, "-", {.height = 12, .background = red});
        const Picture picture = target.read();
        int rows = 0;
        for (int y = 0; y < picture.height; ++y) rows += picture.at(11 * times, y) == redPixel;
        return rows;
    };
    EXPECT_EQ(heightOfBox(1), 12 + 2 * 4);
    EXPECT_EQ(heightOfBox(3), 3 * (12 + 2 * 4));
}

TEST(FigureUnits, follow_the_picture_and_stay_readable) {
    EXPECT_EQ(figureUnit(960, 560, 960, 560), 1);
    EXPECT_EQ(figureUnit(1920, 1120, 960, 560), 2);
    EXPECT_EQ(figureUnit(9600, 560, 960, 560), 1) << "the side with less room decides";
    EXPECT_EQ(figureUnit(20, 20, 960, 560), figureUnit(300, 200, 960, 560)) << "words have a least size";
    EXPECT_GE(figureUnit(20, 20, 960, 560), 0.75) << "12 pixels of words of ordinary height, 16";
    EXPECT_EQ(figureUnit(20, 20, 960, 560, 2), 2 * figureUnit(20, 20, 960, 560));
    EXPECT_EQ(figureUnit(1920, 1120, 960, 560, 2), 2) << "a picture that has grown with the screen's density";
    // A pane of units covers the same part of the picture, and panes that meet still do
    const FrameInfo frame(1, 1000, 333, figureUnit(1000, 333, 960, 560));
    const FrameInfo units = frame.inUnits();
    EXPECT_DOUBLE_EQ(units.aspect(), frame.aspect());
    const Pane left = units.pixels({0, 0, 100, units.height()}),
               right = units.pixels({100, 0, units.width() - 100, units.height()});
    EXPECT_EQ(left.x + left.width, right.x);
    EXPECT_EQ(right.x + right.width, 1000);
    EXPECT_EQ(left.height, 333);
    EXPECT_EQ(frame.fromUnits({0, 0, 100, 9}).width, left.width);
    EXPECT_EQ(units.fromUnits({0, 0, 100, 9}).width, 100);
}

TEST_F(DrawingTest, edges_in_space_are_hidden_by_what_is_nearer_and_shapes_are_not) {
    glEnable(GL_DEPTH_TEST);
    const Program plain =
        Program::fromText("plain", "in vec4 position;\nvoid main() { gl_Position = position; }\n",
                          "out vec4 fragColor;\nvoid main() { fragColor = vec4(0.0, 0.0, 1.0, 1.0); }\n");
    MeshData wall;  // the left half, half way down
    wall.positions = {{-1, -1, 0}, {0, -1, 0}, {-1, 1, 0}, {-1, 1, 0}, {0, -1, 0}, {0, 1, 0}};
    plain.use();
    const Mesh mesh(wall, "wall");
    mesh.draw();
    const auto redIn = [](const Picture& picture, int from, int to) {
        int count = 0;
        for (int x = from; x < to; ++x) count += picture.at(x, 30) == redPixel ? 1 : 0;
        return count;
    };
    const Stroke stroke{.color = red, .width = 4};
    drawing.edge(mat4(1), {-1, 0, 0.5}, {1, 0, 0.5}, stroke);
    Picture picture = drawn();
    EXPECT_EQ(redIn(picture, 0, 40), 0);
    EXPECT_EQ(redIn(picture, 41, 79), 38);
    // Nearer than the wall it is before it; and it has written no depth, so the farther one is drawn over it again
    drawing.begin(frame);
    drawing.edge(mat4(1), {-1, 0, -0.5}, {1, 0, -0.5}, stroke);
    drawing.edge(mat4(1), {-1, 0, 0.5}, {1, 0, 0.5}, {.color = vec4(0, 1, 0, 1), .width = 4});
    picture = drawn();
    EXPECT_EQ(redIn(picture, 1, 39), 38);
    EXPECT_EQ(redIn(picture, 41, 79), 0);
    // Beside a tested edge a plain shape is on top all the same
    drawing.begin(frame);
    drawing.edge(mat4(1), {-1, 0.5, 0.5}, {1, 0.5, 0.5}, stroke);
    drawing.fill({{0, 20}, {80, 40}}, red);
    EXPECT_EQ(redIn(drawn(), 0, 80), 80);
}

TEST_F(DrawingTest, an_edge_that_passes_the_eye_is_cut_at_near) {
    // w is -z: from 5 before the eye to 5 behind it
    mat4 clipFromView(1);
    clipFromView[2] = vec4(0, 0, -1, -1);
    clipFromView[3] = vec4(0, 0, -1, 0);
    drawing.edge(clipFromView, {0, 0, -5}, {1, 0, 5}, {.color = red, .width = 4});
    const Picture picture = drawn();
    // x/w = 1 at z = -5/6, w = 5/6: from the middle to the right edge, and nothing on the left
    EXPECT_EQ(picture.at(60, 30), redPixel);
    EXPECT_EQ(picture.at(30, 30), white);
    drawing.begin(frame);
    drawing.edge(clipFromView, {0, 0, 1}, {1, 0, 5}, {.color = red, .width = 4});
    drawing.edge(clipFromView, {0, 0, -5}, {0, 0, -5}, {.color = red, .width = 4});
    EXPECT_EQ(countPixels(drawn(), redPixel), countPixels(picture, redPixel)) << "nothing was added";
}

TEST_F(DrawingTest, leaves_the_state_as_it_was) {
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT_AND_BACK);
    glEnable(GL_POLYGON_OFFSET_FILL);
    glPolygonOffset(0, 1e7F);
    glDepthFunc(GL_NEVER);
    glClearDepth(0.6);  // between the edge, at 0.5, and where the offset would push it
    glClear(GL_DEPTH_BUFFER_BIT);
    const std::vector<std::string> before = changedState();
    drawing.fill({{0, 0}, {4, 4}}, red);
    drawing.edge(mat4(1), {-1, 0, 0}, {1, 0, 0}, {.color = red, .width = 4});
    drawing.text({10, 50}, "words");
    drawing.draw(frame);
    EXPECT_EQ(changedState(), before);
    EXPECT_GT(countPixels(target.read(), redPixel), 100) << "whatever the winding and the depth function were";
}

TEST_F(DrawingTest, what_stays_is_not_uploaded_again_and_state_is_set_once) {
    const auto work = [&](double x) {
        drawing.begin(frame);
        drawing.fill({{x, 0}, {x + 4, 4}}, red);
        drawing.text({10, 50}, "words");
        startAudit();
        beginAuditedFrame(false);
        drawing.draw(frame);
        const FrameWork done = endAuditedFrame();
        for (const Finding& finding : stopAudit()) {
            if (finding.kind == waste::unusedBuffer) continue;  // the depths that other tests need
            ADD_FAILURE() << finding.kind << ": " << finding.what;
        }
        return done;
    };
    EXPECT_GT(work(3).bytesUploaded, 500);
    const long objects = liveObjects();
    const FrameWork again = work(3);
    EXPECT_EQ(again.bytesUploaded, 4) << "the unit of the words' texture";
    EXPECT_EQ(again.draws, 2) << "all shapes, and all words";
    EXPECT_GT(work(5).bytesUploaded, 500);
    EXPECT_EQ(liveObjects(), objects);
    // Nothing at all is nothing to draw
    drawing.begin(frame);
    const long before = counters().draws;
    drawing.draw(frame);
    EXPECT_EQ(counters().draws, before);
}

TEST_F(DrawingTest, a_plot_has_its_curve_where_its_values_are) {
    const Plot plot{{{40, 20}, {76, 56}}, {0, 4}, {0, 4}};
    drawing.axes(plot);
    drawing.curve(plot, std::array{vec2(-9, 2), vec2(9, 2)}, {.color = red, .width = 4});
    Picture picture = drawn();
    EXPECT_EQ(picture.at(60, 60 - 38), redPixel);
    EXPECT_NE(picture.at(30, 60 - 38), redPixel) << "cut at the box";
    EXPECT_LT(picture.at(60, 60 - 20).red, 128) << "the axis";
    drawing.begin(frame);
    glClear(GL_COLOR_BUFFER_BIT);
    drawing.pixelGrid({plot.box, {0, 4}, {0, 4}}, {.color = red, .width = 1});
    drawing.fill({plot.pixel({1, 2}), plot.pixel({2, 3})}, vec4(0, 0, 1, 1));
    picture = drawn();
    EXPECT_EQ(picture.at(53, 60 - 1 - 42), (Pixel{0, 0, 255, 255})) << "the pixel (1, 2), magnified nine times";
    EXPECT_EQ(picture.at(53, 60 - 1 - 33), white);
}

TEST_F(DrawingTest, words_that_do_not_fit_are_smaller_or_left_out) {
    const auto inkOf = [&] {
        glClear(GL_COLOR_BUFFER_BIT);
        const Picture picture = drawn();
        return 80 * 60 - static_cast<int>(countPixels(picture, white));
    };
    const TextStyle plain{.height = 16, .background = vec4(0)};
    drawing.text({2, 58}, "ab", plain);
    const int alone = inkOf();
    ASSERT_GT(alone, 0);
    // Over earlier words, and over the picture's edge on each side
    drawing.begin(frame);
    drawing.text({2, 58}, "ab", plain);
    drawing.text({10, 50}, "cd", plain);
    drawing.textAround({0, 20}, "cd", plain);
    drawing.textAround({40, 0}, "cd", plain);
    drawing.text({2, 70}, "cd", plain);
    EXPECT_EQ(inkOf(), alone);
    // Smaller, where the pane is too narrow; not at all where the least are too many
    drawing.begin(frame);
    drawing.in({0, 0, 40, 60});
    drawing.text({2, 58}, "abcde", {.height = 16, .color = vec4(0, 0, 0, 1), .background = vec4(1, 0, 0, 1)});
    glClear(GL_COLOR_BUFFER_BIT);
    const Picture picture = drawn();
    int right = 0;
    for (int x = 0; x < 80; ++x) {
        for (int y = 0; y < 60; ++y) right = picture.at(x, y) == white ? right : x;
    }
    EXPECT_GT(right, 20);
    EXPECT_LT(right, 40 + 4) << "its box may be beyond the pane by its padding";
    drawing.begin(frame);
    drawing.text({2, 58}, "This sentence is longer than 80 pixels.", plain);
    EXPECT_EQ(inkOf(), 0);
}

// OpenGL's lines are drawn once in the size that the demo declares, and in one of twice its sides as two pixels wide. The
// green axis has then four times as many pixels, where lines of one pixel would have twice as many; ends and what the cube
// hides leave a tenth of it open.
TEST(WideLines, grow_with_the_picture) {
    const auto greenIn = [](int side) {
        const Picture picture = DemoRun("cube-cull", side, side).picture();
        long count = 0;
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) count += picture.at(x, y) == Pixel{0, 255, 0, 255};
        return double(count);
    };
    const double declared = greenIn(600);
    EXPECT_GT(declared, 100);
    EXPECT_NEAR(greenIn(1200) / declared, 4, 0.4);
    EXPECT_EQ(lineWidth(FrameInfo(1, 300, 300, 0.5)), 1) << "no less than a pixel";
    EXPECT_EQ(lineWidth(FrameInfo(1, 1200, 1200, 2), 3), 6);
}

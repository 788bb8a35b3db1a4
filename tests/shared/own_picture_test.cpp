#include "shared/own_picture.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "mv/error.h"
#include "mv/image/load.h"
#include "mv/math/color.h"
#include "shared/relief_maps.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

Picture randomPixels(int width, int height, unsigned seed) {
    Random random(seed);
    Picture picture(width, height);
    for (std::uint8_t& byte : picture.rgba) byte = static_cast<std::uint8_t>(random.number(0, 255.99));
    return picture;
}

vec3 colorOf(const FloatPicture& picture, int x, int y) {
    const float* const texel = &picture.values[4 * pixelIndex(x, y, picture.width)];
    return {texel[0], texel[1], texel[2]};
}
vec3 meanOf(const FloatPicture& picture) {
    vec3 sum(0);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) sum += colorOf(picture, x, y);
    }
    return sum / double(picture.width * picture.height);
}

constexpr double rounding = 1e-7;  // of a float near 1, 6e-8, and a few of them in a mean

}  // namespace

// In its own size each texel is a pixel, from below, in linear light.
TEST(OwnPicture, texels_are_pixels_where_there_are_as_many) {
    const Picture picture = randomPixels(7, 5, 1);
    const FloatPicture texels = ownTexels(picture, 7, 5);
    for (int y = 0; y < 5; ++y) {
        for (int x = 0; x < 7; ++x) {
            const Pixel pixel = picture.at(x, 4 - y);
            const vec3 light = linearFromSrgb(vec3(pixel.red, pixel.green, pixel.blue) / 255.0);
            EXPECT_LT(glm::distance(colorOf(texels, x, y), light), rounding);
            EXPECT_EQ(texels.values[4 * pixelIndex(x, y, 7) + 3], 1.0F);
        }
    }
}

// Nothing is lost and nothing counts twice, in whatever size: the mean of the whole stays.
TEST(OwnPicture, keeps_the_mean_of_the_light) {
    for (const auto& [width, height] : {std::pair(13, 9), std::pair(1, 1), std::pair(64, 3)}) {
        const Picture picture = randomPixels(width, height, 2);
        const vec3 mean = meanOf(ownTexels(picture, width, height));
        for (const auto& [to, down] :
             {std::pair(1, 1), std::pair(5, 4), std::pair(100, 1), std::pair(1, 100), std::pair(256, 256)}) {
            EXPECT_LT(glm::distance(meanOf(ownTexels(picture, to, down)), mean), rounding) << to << " x " << down;
        }
    }
}

TEST(OwnPicture, heights_are_numbers_from_black_to_white) {
    Picture picture(3, 1);
    picture.set(0, 0, {0, 0, 0});
    picture.set(1, 0, {128, 128, 128});
    picture.set(2, 0, {255, 255, 255});
    const FloatPicture heights = ownHeights(picture, 3, 1);
    for (int x = 0; x < 3; ++x) {
        EXPECT_NEAR(double(heights.values[4 * std::size_t(x) + 3]),
                    (x == 0   ? 0
                     : x == 1 ? 128
                              : 255) /
                        255.0,
                    rounding);
        EXPECT_EQ(colorOf(heights, x, 0), vec3(0.5));
    }
    // The mean of black and white is the middle height, whatever light that is.
    EXPECT_NEAR(double(ownHeights(picture, 1, 1).values[3]), (128 + 255) / 3.0 / 255, rounding);
}

TEST(OwnPicture, says_which_sides_surroundings_have) {
    EXPECT_EQ(surroundingOf(Picture(512, 256), "--picture"), Surrounding::panorama);
    EXPECT_EQ(surroundingOf(Picture(8, 6), "--picture"), Surrounding::faces);
    for (const auto& [width, height] :
         {std::pair(511, 256), std::pair(640, 481), std::pair(320, 241), std::pair(6, 8), std::pair(1, 1)}) {
        try {
            (void)surroundingOf(Picture(width, height), "--picture");
            ADD_FAILURE() << width << " x " << height;
        } catch (const Error& error) {
            EXPECT_EQ(std::string(error.what()).rfind("--picture: must be a panorama", 0), 0U) << error.what();
        }
    }
}

TEST(OwnPicture, takes_no_photograph_for_a_cut_cube) {
    const std::string assets = MVGL_SOURCE_DIR "/assets/";
    EXPECT_EQ(surroundingOf(loadPicture(assets + "evening-faces.png"), "--picture"), Surrounding::faces);
    try {
        (void)surroundingOf(loadPicture(assets + "postcard.png"), "--picture");  // of 320 x 240
        ADD_FAILURE() << "accepted";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("with something in squares that no face has"), std::string::npos);
    }
}

// Six faces of as many texels: each texel of the cube is one pixel of the picture, at the place that the layout says.
TEST(OwnPicture, faces_become_the_cube_texel_by_texel) {
    constexpr int side = 5;
    Picture picture = randomPixels(4 * side, 3 * side, 3);
    for (int y = 0; y < 3 * side; ++y) {
        for (int x = 0; x < 4 * side; ++x) {
            if (y / side != 1 && x / side != 1) picture.set(x, y, {0, 0, 0});
        }
    }
    const auto cube = ownCube(picture, side);
    // From the middle of the cell: to the right and up in the picture are these directions in space.
    struct Cell {
        int column, row;
        vec3 middle, right, up;
    };
    for (const Cell& cell :
         {Cell{0, 1, {-1, 0, 0}, {0, 0, -1}, {0, 1, 0}}, Cell{1, 1, {0, 0, -1}, {1, 0, 0}, {0, 1, 0}},
          Cell{2, 1, {1, 0, 0}, {0, 0, 1}, {0, 1, 0}}, Cell{3, 1, {0, 0, 1}, {-1, 0, 0}, {0, 1, 0}},
          Cell{1, 0, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}, Cell{1, 2, {0, -1, 0}, {1, 0, 0}, {0, 0, -1}}}) {
        for (int y = 0; y < side; ++y) {
            for (int x = 0; x < side; ++x) {
                const double right = (2 * x + 1.0) / side - 1, up = 1 - (2 * y + 1.0) / side;
                const CubePlace place = cubePlace(cell.middle + right * cell.right + up * cell.up);
                const vec3 found =
                    colorOf(cube.at(std::size_t(place.face)), int(place.at.x * side), int(place.at.y * side));
                const Pixel pixel = picture.at(cell.column * side + x, cell.row * side + y);
                EXPECT_LT(glm::distance(found, vec3(pixel.red, pixel.green, pixel.blue) / 255.0), rounding)
                    << cell.column << ", " << cell.row << ": " << x << ", " << y;
            }
        }
    }
}

// The two pictures of one evening, made by two formulas, show it alike. The two are not the same where something is finer than
// a pixel of either: the mean over the faces is.
TEST(OwnPicture, panorama_and_faces_of_one_scene_agree) {
    const std::string assets = MVGL_SOURCE_DIR "/assets/";
    const auto one = ownCube(loadPicture(assets + "evening.png"), 64),
               other = ownCube(loadPicture(assets + "evening-faces.png"), 64);
    for (std::size_t face = 0; face < one.size(); ++face) {
        double sum = 0;
        for (std::size_t i = 0; i < one[face].values.size(); ++i)
            sum += std::abs(double(one[face].values[i]) - double(other[face].values[i]));
        // Waves and the lighthouse's edge: a face at a wrong place or turned is off by a tenth and more.
        EXPECT_LT(sum / double(one[face].values.size()), 0.025) << face;
    }
    const vec3 sun(0.6, 0.12, -0.798);  // its upper part, above the mountains
    const CubePlace place = cubePlace(sun);
    for (const auto& cube : {one, other}) {
        const vec3 found = colorOf(cube.at(std::size_t(place.face)), int(place.at.x * 64), int(place.at.y * 64));
        EXPECT_GT(found.x + found.y + found.z, 2.5) << "the sun is where it was painted";
    }
}

// A map of bricks as one's own is nearly the wall itself: heights to what is lost between 512 texels a side, and slopes so.
TEST(OwnRelief, is_as_the_formula_of_which_the_map_was_made) {
    Random random(4);
    for (const ReliefBody body : {ReliefBody::wall, ReliefBody::orange}) {
        const FloatPicture map = paintedMap(body, 512);
        for (const bool isMirrored : {false, true}) {
            if (isMirrored && body == ReliefBody::orange) continue;
            const Relief exact{body, 0.08, isMirrored}, own{body, 0.08, isMirrored, &map};
            double heights = 0, slopes = 0;
            constexpr int points = 4000;
            for (int i = 0; i < points; ++i) {
                const vec3 p =
                    body == ReliefBody::wall
                        ? vec3(random.number(-3, 3), random.number(-1, 1), 0)
                        : glm::normalize(vec3(random.number(-1, 1), random.number(-0.9, 0.9), random.number(-1, 1)));
                const ReliefPoint a = reliefAt(exact, p), b = reliefAt(own, p);
                EXPECT_EQ(b.smooth, a.smooth);
                EXPECT_EQ(b.out, a.out);
                EXPECT_EQ(b.height, reliefHeight(own, p));
                heights += std::pow(a.height - b.height, 2) / points;
                slopes += glm::dot(a.slope - b.slope, a.slope - b.slope) / points;
            }
            // Between texels of 1/256 unit a curve of second derivative 600 (29 heights a unit over 0.05) is off by 600 / 8 / 256^2,
            // and at the far steeper corners of the peel by more; slopes by the square of a texel and a kink at its edge.
            EXPECT_LT(std::sqrt(heights), 0.005) << int(body) << isMirrored;
            EXPECT_LT(std::sqrt(slopes), 0.05 * steepest(body)) << int(body) << isMirrored;
        }
    }
}

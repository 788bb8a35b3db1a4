#include "mv/image/normal_map.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <glm/geometric.hpp>

#include "../math/support.h"

using namespace mv;
using namespace mv::test;

namespace {

FloatPicture heightsOf(int width, int height, const std::function<double(double u, double v)>& at) {
    FloatPicture picture(width, height, 1);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x)
            picture.values[pixelIndex(x, y, width)] = static_cast<float>(at((x + 0.5) / width, (y + 0.5) / height));
    }
    return picture;
}
HeightMapShape shapeOf(double depth, const vec2& texel) {
    return {.depth = depth, .texel = [=](int) { return texel; }};
}
vec3 normalAt(const FloatPicture& map, int x, int y) { return normalOf(&map.values[4 * pixelIndex(x, y, map.width)]); }

}  // namespace

TEST(NormalMap, a_flat_map_points_out) {
    const FloatPicture map = normalMap(FloatPicture(5, 4, 1), shapeOf(3, vec2(1)));
    for (std::size_t i = 0; i < map.values.size(); i += 4) {
        EXPECT_EQ(map.values[i], 0.5F);
        EXPECT_EQ(map.values[i + 1], 0.5F);
        EXPECT_EQ(map.values[i + 2], 1.0F);
        EXPECT_EQ(map.values[i + 3], 1.0F);
    }
}

// Also at the ends that do not repeat: three points of a slope of second degree know it.
TEST(NormalMap, slopes_of_second_degree_are_exact) {
    const FloatPicture heights = heightsOf(8, 16, [](double u, double v) { return u * u - 0.5 * v * v + 0.25 * v; });
    HeightMapShape shape = shapeOf(2, {1.0 / 8, 3.0 / 16});  // 1 unit by 3
    shape.repeatsU = shape.repeatsV = false;
    const FloatPicture map = normalMap(heights, shape);
    for (int y = 0; y < 16; ++y) {
        for (int x = 0; x < 8; ++x) {
            const double u = (x + 0.5) / 8, v = (y + 0.5) / 16;
            const vec3 truth = glm::normalize(vec3(-2 * 2 * u, -2 * (0.25 - v) / 3, 1));
            // A float of 0..1 has 6e-8, a difference of heights over 1/16 sixteen times that, kept and read again
            EXPECT_LT(glm::distance(normalAt(map, x, y), truth), 5e-6) << x << " " << y;
        }
    }
}

TEST(NormalMap, repeats_as_its_picture_does) {
    const auto wave = [](double u, double v) { return 0.5 + 0.25 * std::sin(2 * pi * u) * std::cos(2 * pi * v); };
    const FloatPicture map = normalMap(heightsOf(64, 32, wave), shapeOf(1, {1.0 / 64, 1.0 / 32}));
    for (int y = 0; y < 32; ++y) {
        for (int x = 0; x < 64; ++x) {
            const double u = 2 * pi * (x + 0.5) / 64, v = 2 * pi * (y + 0.5) / 32;
            const vec3 truth =
                glm::normalize(vec3(-0.5 * pi * std::cos(u) * std::cos(v), 0.5 * pi * std::sin(u) * std::sin(v), 1));
            // sin(x)/x of a texel: (2 pi/32)^2/6 of the slope, which is pi/2 at most
            EXPECT_LT(glm::distance(normalAt(map, x, y), truth), std::pow(2 * pi / 32, 2) / 6 * pi / 2)
                << x << " " << y;
        }
    }
}

TEST(NormalMap, of_a_row_its_own_texels) {
    const FloatPicture heights = heightsOf(8, 3, [](double u, double) { return u < 0.5 ? u : 1 - u; });
    HeightMapShape shape{.depth = 1, .texel = [](int row) { return vec2(row + 1, 1); }, .repeatsV = false};
    const FloatPicture map = normalMap(heights, shape);
    for (int y = 0; y < 3; ++y) {
        const vec3 normal = normalAt(map, 2, y);
        EXPECT_NEAR(-normal.x / normal.z, 0.125 / (y + 1), 1e-6);
    }
}

TEST(NormalMap, refuses_what_has_no_slope) {
    const FloatPicture heights(4, 4, 1);
    EXPECT_EQ(refusal([] { (void)normalMap(FloatPicture(2, 4, 1), shapeOf(1, vec2(1))); }),
              "normalMap: must have 3 texels a side at least, 2");
    EXPECT_EQ(refusal([&] { (void)normalMap(heights, shapeOf(-1, vec2(1))); }),
              "normalMap depth: must be 0 or more, -1");
    EXPECT_EQ(refusal([&] { (void)normalMap(heights, shapeOf(NAN, vec2(1))); }),
              "normalMap depth: must be 0 or more, nan");
    EXPECT_EQ(refusal([&] { (void)normalMap(heights, shapeOf(1, vec2(1, 0))); }),
              "normalMap texel: must have sides above 0, 0");
    HeightMapShape shape = shapeOf(1, vec2(1));
    shape.channel = 1;
    EXPECT_EQ(refusal([&] { (void)normalMap(heights, shape); }),
              "normalMap: must be made from a channel of the picture, 1");
}

#include "z-buffer/plates.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <span>

#include "mv/error.h"
#include "mv/math/transform.h"

using namespace mv;

namespace {

const vec3 red(1, 0, 0), blue(0, 0, 1), white(1, 1, 1);

// A square with its middle on the gaze.
Plate facing(const vec3& color, double distance, double side) {
    return {color, translate(0, 0, -distance) * scale(side) * translate(-0.5, 0, 0)};
}

PlateView view(double opacity = 1) {
    return {.tangents = {1, 1},
            .near = 0.5,
            .far = std::numeric_limits<double>::infinity(),
            .opacity = opacity,
            .background = white,
            .width = 20,
            .height = 20};
}

std::optional<vec3> middle(const std::vector<std::optional<vec3>>& colors) { return colors[10 * 20 + 10]; }

Picture painted(const std::vector<std::optional<vec3>>& colors) {
    Picture picture(20, 20);
    for (std::size_t i = 0; i < colors.size(); ++i) {
        for (std::size_t channel = 0; channel < 3; ++channel) {
            const double value = (*colors[i])[static_cast<int>(channel)];
            picture.rgba[4 * i + channel] = static_cast<unsigned char>(std::lround(255 * value));
        }
    }
    return picture;
}

}  // namespace

TEST(Plates, the_nearest_hides_and_the_order_of_the_list_does_not_matter) {
    const Plate front = facing(red, 1, 1), back = facing(blue, 2, 3);
    const auto colors = colorsByRays(std::array{front, back}, view());
    EXPECT_EQ(colors, colorsByRays(std::array{back, front}, view()));
    EXPECT_EQ(middle(colors), red);
    // At the distance 2 the picture is 4 wide: blue covers 15 of its 20 columns, red (2 wide at distance 1) 10 of them.
    int reds = 0, blues = 0;
    for (std::size_t column = 0; column < 20; ++column) {
        reds += colors[10 * 20 + column] == red ? 1 : 0;
        blues += colors[10 * 20 + column] == blue ? 1 : 0;
    }
    EXPECT_EQ(reds, 10);
    EXPECT_EQ(blues, 4);  // of the 5 on its sides one is halved: two middles of pixels on each side lie inside
}

TEST(Plates, translucent_ones_are_laid_over_each_other) {
    const auto colors = colorsByRays(std::array{facing(red, 1, 1), facing(blue, 2, 3)}, view(0.5));
    EXPECT_EQ(middle(colors), vec3(0.75, 0.25, 0.5));  // over (0.5, 0.5, 1): exact in binary
}

TEST(Plates, near_far_the_eye_and_equal_distances) {
    PlateView cut = view();
    cut.far = 1.5;
    EXPECT_EQ(middle(colorsByRays(std::array{facing(blue, 2, 3)}, cut)), white);
    cut.near = 1.2;
    EXPECT_EQ(middle(colorsByRays(std::array{facing(red, 1, 1)}, cut)), white);
    EXPECT_EQ(middle(colorsByRays(std::array{facing(red, -1, 1)}, view())), white);  // behind the eye
    const Plate edgeOn{red, translate(0, 0, -2) * rotateY(90)};
    EXPECT_EQ(middle(colorsByRays(std::array{edgeOn}, view())), white);
    const auto equal = colorsByRays(std::array{facing(red, 2, 1), facing(blue, 2, 3)}, view());
    EXPECT_FALSE(middle(equal));
    EXPECT_EQ(equal[10 * 20 + 4], blue);  // beside the smaller one
}

TEST(Plates, the_scenes_are_what_they_say) {
    const auto seen = [](std::span<const Plate> plates) {
        return colorsByRays(plates, {.tangents = {0.4, 0.4},
                                     .near = 0.1,
                                     .far = 1e6,
                                     .opacity = 1,
                                     .background = white,
                                     .width = 200,
                                     .height = 200});
    };
    const auto one = [&](const std::array<Plate, 3>& plates, std::size_t i) { return seen(std::span(&plates[i], 1)); };
    // One of each two bars that overlap is in front, and in a cycle: each wins once.
    const auto bars = barsInACycle(translate(0, 0, -5));
    const auto all = seen(bars);
    std::array<std::array<long, 3>, 3> over{};
    for (std::size_t front = 0; front < 3; ++front) {
        for (std::size_t back = 0; back < 3; ++back) {
            const auto a = one(bars, front), b = one(bars, back);
            for (std::size_t i = 0; i < all.size(); ++i)
                over[front][back] += front != back && a[i] != white && b[i] != white && all[i] == a[i] ? 1 : 0;
        }
    }
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_GT(over[i][(i + 2) % 3] + over[i][(i + 1) % 3], 100);
        EXPECT_EQ(over[i][(i + 1) % 3] > 100, over[(i + 1) % 3][i] == 0);
        EXPECT_EQ(over[i][(i + 1) % 3] > 100, over[(i + 1) % 3][(i + 2) % 3] > 100);  // all the same way round
    }
    // The distances of mark, road and ground on one ray: as 1, 1 + s and (1 + s)^2.
    const double s = 0.25;
    const auto road = roadOnGround(100, s);
    const auto nearness = [&](std::size_t i, const vec3& ray) {
        const mat4& m = road[i].viewFromPlate;
        return (glm::inverse(mat3(vec3(m[0]), vec3(m[1]), vec3(m[3]))) * ray).z;
    };
    for (const vec3& ray : {vec3(0.1, -0.2, -1), vec3(-0.3, 0.1, -1)}) {
        EXPECT_NEAR(nearness(0, ray) / nearness(2, ray), 1 + s, 1e-12);
        EXPECT_NEAR(nearness(0, ray) / nearness(1, ray), (1 + s) * (1 + s), 1e-12);
    }
    // The panes: `step` apart along the gaze.
    const auto three = panes(translate(0, 0, -5), 0.5);
    for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(three[i].viewFromPlate[3].z, -5 - 0.5 * double(i));
}

TEST(Plates, cells_cover_the_plate_between_the_cuts) {
    const MeshData mesh = plateMesh(std::array{0.0, 0.25, 1.0});
    ASSERT_EQ(mesh.positions.size(), 12U);
    double area = 0;
    for (std::size_t i = 0; i < mesh.positions.size(); i += 3) {
        const vec3 a(mesh.positions[i]), b(mesh.positions[i + 1]), c(mesh.positions[i + 2]);
        const vec3 cross = glm::cross(b - a, c - a);
        EXPECT_GT(cross.z, 0);  // counter-clockwise, seen from +z
        area += cross.z / 2;
        for (const vec3& p : {a, b, c}) EXPECT_TRUE(i < 6 ? p.x <= 0.25 : p.x >= 0.25);
    }
    EXPECT_EQ(area, 1);
}

TEST(Plates, wrong_pixels_are_counted_beside_the_edges) {
    const auto right = colorsByRays(std::array{facing(red, 1, 1), facing(blue, 2, 3)}, view());
    Picture picture = painted(right);
    EXPECT_EQ(wrongPart(picture, right), 0.0);
    picture.rgba[4 * (10 * 20 + 10)] -= 2;  // two levels are roundings
    EXPECT_EQ(wrongPart(picture, right), 0.0);
    picture.rgba[4 * (10 * 20 + 10)] -= 1;
    const auto one = wrongPart(picture, right);
    ASSERT_TRUE(one);
    EXPECT_GT(*one, 0);
    EXPECT_LT(*one, 2.0 / 100);  // one of those that are not beside an edge
    EXPECT_FALSE(wrongPart(Picture(20, 20), std::vector<std::optional<vec3>>(400)));
    EXPECT_THROW(wrongPart(Picture(20, 19), right), Error);
}

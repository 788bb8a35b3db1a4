#include "shared/fresnel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <glm/geometric.hpp>
#include <limits>

#include "mv/error.h"
#include "mv/math/transform.h"

using namespace mv;

namespace {

// The textbook's amplitudes in complex numbers: both polarizations, of any index.
double byComplexNumbers(double cosine, std::complex<double> index) {
    const std::complex<double> behind = std::sqrt(index * index - (1 - cosine * cosine));
    const std::complex<double> across = (cosine - behind) / (cosine + behind);
    const std::complex<double> along = (index * index * cosine - behind) / (index * index * cosine + behind);
    return (std::norm(across) + std::norm(along)) / 2;
}

}  // namespace

TEST(Fresnel, what_is_reflected_and_what_passes_is_all) {
    for (const double index : {1e-6, 0.5, 0.75, 1.0, 1.0 + 1e-15, 1.5, 2.4, 1e6, 1e150}) {
        for (int i = 0; i <= 1000; ++i) {
            const Split split = fresnel(i / 1000.0, index);
            EXPECT_NEAR(split.reflected + split.transmitted, 1, 1e-12) << index << " " << i;
            EXPECT_GE(split.reflected, 0);
            EXPECT_LE(split.reflected, 1);
        }
    }
}

TEST(Fresnel, known_values) {
    // Head on: ((n - 1) / (n + 1))^2.
    EXPECT_NEAR(fresnel(1, 1.5).reflected, 0.04, 1e-16);
    EXPECT_NEAR(fresnel(1, 1 / 1.5).reflected, 0.04, 1e-16);
    // A grazing ray is reflected, a surface that is none reflects nothing, and a huge index all.
    EXPECT_EQ(fresnel(0, 1.5).reflected, 1);
    EXPECT_EQ(fresnel(0, 1).reflected, 0);
    EXPECT_EQ(fresnel(0.3, 1).transmitted, 1);
    EXPECT_NEAR(fresnel(1, 1e6).reflected, 1, 5e-6);
    // Brewster's angle: nothing of one polarization, and the other one is ((n^2 - 1) / (n^2 + 1))^2.
    EXPECT_NEAR(fresnel(std::cos(std::atan(1.5)), 1.5).reflected, 0.5 * std::pow(1.25 / 3.25, 2), 1e-15);
}

TEST(Fresnel, reversed_light_is_reflected_alike) {
    for (const double angle : {0.0, 20.0, 60.0, 85.0}) {
        const double cosine = std::cos(radians(angle));
        const double behind = std::sqrt(1 - (1 - cosine * cosine) / (1.5 * 1.5));
        EXPECT_NEAR(fresnel(cosine, 1.5).reflected, fresnel(behind, 1 / 1.5).reflected, 1e-14) << angle;
    }
}

TEST(Fresnel, total_reflection_begins_where_the_sine_is_the_index) {
    for (const double index : {0.4, 0.75, 0.999}) {
        const double limit = std::asin(index);
        EXPECT_LT(fresnel(std::cos(limit - 1e-6), index).reflected, 1);
        EXPECT_EQ(fresnel(std::cos(limit + 1e-6), index).reflected, 1);
        const vec3 n(0, 1, 0);
        const auto along = [&](double angle) { return vec3(std::sin(angle), -std::cos(angle), 0); };
        EXPECT_TRUE(refracted(along(limit - 1e-6), n, index));
        EXPECT_FALSE(refracted(along(limit + 1e-6), n, index));
    }
}

TEST(Fresnel, refraction_is_snells) {
    const vec3 n(0, 1, 0);
    for (const double index : {0.8, 1.0, 1.33, 2.4}) {
        for (const double angle : {0.0, 10.0, 50.0}) {
            const vec3 way(std::sin(radians(angle)), -std::cos(radians(angle)), 0);
            const auto behind = refracted(way, n, index);
            ASSERT_TRUE(behind);
            EXPECT_NEAR(glm::length(*behind), 1, 1e-15);
            EXPECT_NEAR(behind->x * index, way.x, 1e-15);
            EXPECT_LT(behind->y, 0);
            EXPECT_EQ(behind->z, 0);
        }
    }
    EXPECT_EQ(*refracted(vec3(0.6, -0.8, 0), n, 1), vec3(0.6, -0.8, 0));
}

TEST(Fresnel, metals_are_what_complex_numbers_say) {
    for (int i = 0; i <= 90; ++i) {
        const double cosine = std::max(std::cos(radians(i)), 0.0);
        for (int color = 0; color < 3; ++color) {
            for (const Metal& metal : {gold, copper}) {
                const double n = metal.n[color], k = metal.k[color];
                EXPECT_NEAR(fresnelOfMetal(cosine, n, k), byComplexNumbers(cosine, {n, k}), 1e-14);
            }
        }
        // Without absorption a metal is glass; at and beyond total reflection roots magnify roundings to their own roots.
        EXPECT_NEAR(fresnelOfMetal(cosine, 1.5, 0), fresnel(cosine, 1.5).reflected, 1e-14);
        EXPECT_NEAR(fresnelOfMetal(cosine, 0.75, 0), fresnel(cosine, 0.75).reflected, 1e-7);
    }
    // The reason of their colours: they reflect more of red than of green, and more of green than of blue.
    for (const Metal& metal : {gold, copper}) {
        const vec3 headOn = fresnelOfMetal(1, metal);
        EXPECT_GT(headOn.x, headOn.y);
        EXPECT_GT(headOn.y, headOn.z);
        EXPECT_EQ(fresnelOfMetal(0, metal), vec3(1));
    }
}

TEST(Fresnel, schlicks_curve_has_both_ends_right) {
    EXPECT_EQ(schlick(1, 0.04), 0.04);
    EXPECT_EQ(schlick(0, 0.04), 1);
}

TEST(Fresnel, what_is_no_angle_and_no_index_is_refused) {
    const double nan = std::nan("");
    for (const double cosine : {-0.1, 1.1, nan}) {
        EXPECT_THROW(fresnel(cosine, 1.5), Error);
        EXPECT_THROW(fresnelOfMetal(cosine, 1, 1), Error);
        EXPECT_THROW(schlick(cosine, 0.5), Error);
    }
    for (const double index : {0.0, -1.5, 1e200, nan}) {
        EXPECT_THROW(fresnel(0.5, index), Error);
        EXPECT_THROW(refracted({0, -1, 0}, {0, 1, 0}, index), Error);
        EXPECT_THROW(fresnelOfMetal(0.5, index, 1), Error);
    }
    EXPECT_THROW(fresnelOfMetal(0.5, 1, -1), Error);
}

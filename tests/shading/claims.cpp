// The claims of shading, and a test for each; X46, X47 and X50 in docs/stability.md are its extremes.
//
// - [one-colour-a-face] Flat shading gives each face one colour; a body without shading has one in all.
// - [flat-is-enough] On a diffuse body of small faces flat shading is Phong's to a sixteenth of the range; with a narrow highlight it is not.
// - [misses-the-highlight] Gouraud shading loses a highlight that lies within a face, and Phong shading shows it.
// - [finer-is-alike] The finer the mesh, the nearer are flat and Gouraud shading to Phong's.
// - [no-light-from-behind] A lamp behind the surface gives no light and no highlight, in any model.
// - [blinn-matches-phong] Blinn's highlight is as strong as Phong's with 4 cos(angle) times the exponent.
// - [reciprocity] Lambert's model reflects light that goes the other way alike; Phong's and Blinn's highlight divided by
//   the cosine do not, by the ratio of the two cosines.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <glm/geometric.hpp>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include "shading/reflection.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

// The part of the picture that shows the body alone, without figures and the lamp of the initial settings.
std::vector<Pixel> bodyOf(const Picture& picture) {
    std::vector<Pixel> pixels;
    const Pixel background = picture.at(0, 0);
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width / 2; ++x) {
            if (picture.at(x, y) != background) pixels.push_back(picture.at(x, y));
        }
    }
    return pixels;
}

std::size_t colorsOf(const Picture& picture) {
    std::set<std::tuple<int, int, int>> colors;
    for (const Pixel& pixel : bodyOf(picture)) colors.insert({pixel.red, pixel.green, pixel.blue});
    return colors.size();
}

// Levels of 255, the mean over the left half.
double meanDifference(const Picture& a, const Picture& b) {
    double sum = 0;
    for (int y = 0; y < a.height; ++y) {
        for (int x = 0; x < a.width / 2; ++x) sum += std::abs(a.at(x, y).green - b.at(x, y).green);
    }
    return 2 * sum / (double(a.height) * a.width);
}

}  // namespace

TEST(ShadingFull, one_colour_a_face) {
    DemoRun run("shading");
    EXPECT_EQ(colorsOf(run.set("shading", "own").picture()), 1U);
    for (const int edges : {4, 8, 16}) {
        const auto colors = colorsOf(run.set("shading", "flat").set("edges", edges).picture());
        EXPECT_GT(colors, 1U);
        EXPECT_LE(double(colors), run.readout("triangles")) << edges;
        EXPECT_GT(colorsOf(run.set("shading", "gouraud").picture()), std::size_t(run.readout("triangles"))) << edges;
    }
}

TEST(ShadingFull, flat_is_enough) {
    DemoRun run("shading");
    const auto largest = [&] {
        const Picture flat = run.set("shading", "flat").picture(), phong = run.set("shading", "phong").picture();
        int most = 0;
        for (int y = 0; y < flat.height; ++y) {
            for (int x = 0; x < flat.width / 2; ++x)  // where the body is
                most = std::max(most, std::abs(flat.at(x, y).red - phong.at(x, y).red));
        }
        return most;
    };
    run.preset("flat-enough");
    const int small = largest();
    EXPECT_GT(small, 0);
    EXPECT_LT(small, 16);
    run.set("material", "plastic").set("exponent", 400);
    EXPECT_GT(largest(), 32);
    run.preset("flat-enough");
    run.set("edges", "16");
    EXPECT_GT(largest(), 32);
}

TEST(ShadingFull, misses_the_highlight) {
    DemoRun run("shading");
    run.preset("missed");
    const auto energy = [&](const char* shading) {
        (void)run.set("shading", shading).picture();
        return run.readout("highlight-energy");
    };
    EXPECT_LT(energy("gouraud"), 1);
    EXPECT_LT(energy("flat"), 1);
    // Phong shading has it, though a mesh of 8 edges leads it astray by its own form.
    EXPECT_GT(energy("phong"), 50);
    // The mesh misses it: a fine one does not.
    run.set("edges", 256);
    EXPECT_NEAR(energy("gouraud"), 100, 10);
}

TEST(ShadingFull, finer_is_alike) {
    DemoRun run("shading");
    for (const char* coarse : {"flat", "gouraud"}) {
        double before = HUGE_VAL;
        for (const int edges : {16, 64, 256}) {
            const Picture phong = run.set("edges", edges).set("shading", "phong").picture();
            const double off = meanDifference(run.set("shading", coarse).picture(), phong);
            // Light within a face differs from its corners' by as much as the face is large, so four times less each time;
            // half of that, since pixels round to levels.
            EXPECT_LT(off, before / 2) << coarse << " " << edges;
            before = off;
        }
    }
}

TEST(ShadingFull, no_light_from_behind) {
    DemoRun run("shading");
    run.set("lamp-turn", 150).set("lamp-height", 40);
    for (const char* body : {"sphere", "teapot"}) {
        for (const char* shading : {"flat", "gouraud", "phong"}) {
            for (const char* highlight : {"phong", "blinn"}) {
                for (const auto& one : std::array<std::pair<const char*, double>, 3>{
                         {{"plastic", 0.2}, {"mirror-like", 0.1}, {"brushed", 0.2}}}) {
                    run.set("body", body)
                        .set("shading", shading)
                        .set("highlight", highlight)
                        .set("material", one.first);
                    const Picture picture = run.set("edges", 64).set("exponent", 1).picture();
                    // Before the middle of the body and below it: what is left is what it sends out by itself.
                    const Pixel pixel = picture.at(int(0.28 * picture.width), int(0.55 * picture.height));
                    const auto level = [&](double color) { return int(std::lround(255 * one.second * color)); };
                    EXPECT_EQ((std::array<int, 3>{pixel.red, pixel.green, pixel.blue}),
                              (std::array<int, 3>{level(0.80), level(0.35), level(0.15)}))
                        << body << " " << shading << " " << highlight << " " << one.first;
                }
            }
        }
    }
}

TEST(Shading, blinn_matches_phong) {
    DemoRun run("shading", 96, 56);
    for (const double angle : {0.0, 30.0, 45.0, 60.0}) {
        run.set("exponent", 1000).set("angle", angle);
        (void)run.picture();
        // A highlight as narrow as 1/sqrt(1000) rad changes by less than 3 % over itself at these angles.
        EXPECT_NEAR(run.readout("matching") / (1000 * 4 * std::cos(angle * 3.14159265358979 / 180)), 1, 0.03) << angle;
    }
}

TEST(ShadingFull, reciprocity) {
    DemoRun run("shading", 96, 56);
    const auto cosine = [](double degrees) { return std::cos(degrees * 3.14159265358979323846 / 180); };
    for (const char* highlight : {"phong", "blinn"}) {
        for (const auto& [l, v] : std::array<std::pair<double, double>, 3>{{{45, 20}, {10, 60}, {70, 70}}}) {
            run.set("exponent", 10).set("highlight", highlight).set("angle", l).set("view-angle", v);
            (void)run.picture();
            const double forth = run.readout("forth"), back = run.readout("back");
            EXPECT_GT(forth, 0);
            EXPECT_NEAR(forth / back, cosine(v) / cosine(l), 1e-12);  // some roundings of two quotients
        }
    }
    // Lambert's: what a surface shows, divided by the cosine of the light, is the same wherever the light and the eye are.
    run = DemoRun("shading");
    run.set("material", "diffuse").set("shading", "phong").set("edges", 256).set("spin-x", 0);
    for (const double turn : {-20.0, 0.0, 20.0}) {
        const Picture picture = run.set("lamp-turn", turn).set("lamp-height", 10).picture();
        // The middle of the sphere, seen from the eye: its point is 1.5 n, and the lamp 2.6 from the origin.
        const vec3 n = glm::normalize(vec3(0, 0.5, 7)),
                   lamp = 2.6 *
                          vec3(std::sin(radians(turn)) * cosine(10), std::sin(radians(10)), cosine(turn) * cosine(10));
        const double light = glm::dot(n, glm::normalize(lamp - 1.5 * n));
        const int row = picture.height / 2;
        const double red = picture.at(int(0.3 * picture.width), row).red / 255.0;
        // Half a level, and half a pixel of some 190 that the sphere's radius has: it moves point and normal.
        EXPECT_NEAR((red - 0.2 * 0.8) / light, 0.8 * 0.8, (0.5 / 255 + 1.0 / 190) / light) << turn;
    }
}

// The claims of texture-filter, and a test for each.
//
// - [texel-squares] Under magnification, nearest shows each texel as a flat shape, on the pixels that the geometry says.
// - [nearest-aliases] Far away a checker looked up at one point stays as black and white as it was; with mipmaps it is grey.
// - [trilinear-continuous] The trilinear picture changes continuously with the level; with one level it jumps.
// - [level-as-computed] The driver takes the level that the footprint's longer axis has, to a fifth of a level.
// - [anisotropic-keeps] Stripes along the sight that trilinear has made grey keep most of their contrast.
// - [light-adds] A checker's far mean is 188 of 255 averaged in linear light, and 128 averaged as it is kept.
// - [odd-sizes] Our mipmaps keep the mean of the texture for odd sizes, and a texture of one texel is a flat colour.
// - [eight-bits] With 8 bits a texel llvmpipe filters in 8 bits, too, and is off by a few steps of them.
// - [bounded-footprint] However long a pixel's footprint is, what is read for it is bounded, in a picture of any size.
// - [only-what-is-read] Without a filter between levels a texture has a single one.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "mv/gl/gl.h"
#include "mv/math/color.h"
#include "support/demo_run.h"
#include "support/softpipe.h"
#include "texture-filter/floor_texture.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr int paneWidth = 600, paneHeight = 540;  // of the floor, in the demo's own size

// Row 0 is the lowest, as on the floor.
Pixel atFloor(const Picture& picture, int x, int row) { return picture.at(x, paneHeight - 1 - row); }

// The row of the horizon, which is nowhere whole.
double horizon() {
    const mat3 repeats = repeatsFromPixel(paneWidth, paneHeight, 0);
    return -repeats[2].z / repeats[1].z;
}

double light(std::uint8_t kept) { return linearFromSrgb(kept / 255.0); }

struct Spread {
    double mean = 0, variance = 0, contrast = 0;
};
// Of the light in these rows below the horizon, in the middle 500 pixels, beside which the marked pixel stands.
Spread spreadBelow(const Picture& picture, int from, int to) {
    std::vector<double> lights;
    for (int below = from; below <= to; ++below) {
        for (int x = 50; x < 550; ++x)
            lights.push_back(light(atFloor(picture, x, static_cast<int>(horizon()) - below).red));
    }
    Spread spread;
    for (const double one : lights) spread.mean += one / double(lights.size());
    for (const double one : lights)
        spread.variance += (one - spread.mean) * (one - spread.mean) / double(lights.size());
    const auto [least, most] = std::minmax_element(lights.begin(), lights.end());
    spread.contrast = *most + *least > 0 ? (*most - *least) / (*most + *least) : 0;
    return spread;
}

DemoRun floorRun() {
    DemoRun run("texture-filter");
    run.set("pixel-x", 0).set("pixel-y", 0);
    return run;
}

int largestChange(const Picture& a, const Picture& b) {
    int largest = 0;
    for (int row = 20; row < static_cast<int>(horizon()); ++row) {
        for (int x = 20; x < paneWidth; ++x) {
            const Pixel one = atFloor(a, x, row), other = atFloor(b, x, row);
            largest = std::max({largest, std::abs(one.red - other.red), std::abs(one.green - other.green),
                                std::abs(one.blue - other.blue)});
        }
    }
    return largest;
}

}  // namespace

TEST(TextureFilter, texel_squares) {
    DemoRun run = floorRun();
    constexpr int size = 16;
    run.set("filter", "nearest").set("pattern", "bricks").set("texture-size", size).set("turn", 25);
    const Picture picture = run.picture();
    const FloatPicture texels = floorPattern(FloorPattern::bricks, size);
    const mat3 repeats = repeatsFromPixel(paneWidth, paneHeight, 25);
    long wrong = 0, asked = 0, atBorders = 0;
    // Up to a distance of 10, where a texel is 3 pixels wide; from row 20 on, above the marked pixel
    for (int row = 20; row < static_cast<int>(horizon() - 47); ++row) {
        for (int x = 0; x < paneWidth; ++x) {
            const vec2 at = footprintOf(repeats, {x + 0.5, row + 0.5}).middle * double(size);
            // The floor's corners are 1000 away: as floats they, and what is interpolated between them, keep 3e-5 of a
            // repeat, a thousandth of a texel; ten times that is left to the driver.
            const vec2 within = at - glm::floor(at);
            if (std::min({within.x, within.y, 1 - within.x, 1 - within.y}) < 0.01) {
                ++atBorders;
                continue;
            }
            ++asked;
            const auto whole = [](double texel) { return static_cast<int>(texel - size * std::floor(texel / size)); };
            const float* const texel = &texels.values[4 * pixelIndex(whole(at.x), whole(at.y), size)];
            const Pixel seen = atFloor(picture, x, row);
            for (const auto& [channel, value] : {std::pair{0, seen.red}, {1, seen.green}, {2, seen.blue}})
                wrong += std::abs(255 * srgbFromLinear(double(texel[channel])) - value) > 1;
        }
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_GT(asked, 150'000);
    EXPECT_LT(atBorders, asked / 20);
    // Bilinear shows ramps: the check can fail.
    EXPECT_GT(largestChange(picture, run.set("filter", "bilinear").picture()), 50);
}

TEST(TextureFilterFull, nearest_aliases) {
    DemoRun run = floorRun();
    run.set("turn", 20);
    // A pixel there is longer than the texture: its mean is grey. Half black and half white varies by 1/4.
    for (const char* filter : {"nearest", "bilinear"}) {
        const double variance = spreadBelow(run.set("filter", filter).picture(), 4, 14).variance;
        EXPECT_GT(variance, 0.2) << filter;
    }
    for (const char* filter : {"nearest-mip-nearest", "linear-mip-nearest", "trilinear"}) {
        const double variance = spreadBelow(run.set("filter", filter).picture(), 4, 14).variance;
        EXPECT_LT(variance, 0.25 / 100) << filter;
    }
}

TEST(TextureFilterFull, trilinear_continuous) {
    DemoRun run = floorRun();
    run.set("levels", "on").set("average", "encoded").set("pattern", "bricks");
    constexpr int steps = 32;
    const auto largestStep = [&](const char* filter) {
        Picture before = run.set("filter", filter).set("bias", 0).picture();
        int largest = 0;
        for (int i = 1; i <= steps; ++i) {
            const Picture now = run.set("bias", double(i) / steps).picture();
            largest = std::max(largest, largestChange(before, now));
            before = now;
        }
        return largest;
    };
    // From one level to the next a colour changes by 255 at most; and each of two pictures is rounded.
    EXPECT_LE(largestStep("trilinear"), 255 / steps + 2);
    EXPECT_GT(largestStep("linear-mip-nearest"), 100);
}

TEST(TextureFilter, level_as_computed) {
    DemoRun run("texture-filter");
    run.set("levels", "on").set("filter", "nearest-mip-nearest");
    const std::array<vec3, 6> colors{vec3(0.9, 0.2, 0.2), vec3(0.95, 0.6, 0.1), vec3(0.9, 0.9, 0.2),
                                     vec3(0.2, 0.7, 0.2), vec3(0.1, 0.7, 0.8),  vec3(0.2, 0.3, 0.9)};
    std::array<int, 7> asked{};
    // One picture shows all levels; the marked pixel, which is only asked for its number, is elsewhere in it.
    const Picture picture = run.set("pixel-x", 0).set("pixel-y", 0).picture();
    const mat3 repeats = repeatsFromPixel(paneWidth, paneHeight, 0);
    for (int below = 20; below < 380; below += 4) {
        for (const double across : {0.2, 0.51, 0.9}) {
            const int x = static_cast<int>(across * paneWidth), row = static_cast<int>(horizon()) - below;
            const Footprint print = footprintOf(repeats, {x + 0.5, row + 0.5});
            const double level = std::log2(64 * std::max(glm::length(print.acrossX), glm::length(print.acrossY)));
            // A quad of 2 x 2 pixels shares a level. A row more or less changes it by 2 / (rows below the horizon * ln 2),
            // 0.15 at 20 rows; where the nearest level is no question by that much, it is the driver's, too.
            if (std::abs(level - std::floor(level) - 0.5) < 0.2) continue;
            const int expected = std::clamp(static_cast<int>(std::lround(level)), 0, 6);
            const Pixel seen = atFloor(picture, x, row);
            const vec3 shown(light(seen.red), light(seen.green), light(seen.blue));
            // Level 0 is black, white and grey; the others are 0.3 of a grey and 0.7 of their colours.
            int nearest = 0;
            double least = std::max(glm::length(shown - vec3(shown.x)), 0.01);
            for (std::size_t i = 0; i < colors.size(); ++i) {
                const vec3 rest = shown - 0.7 * colors.at(i);
                const double distance = glm::length(rest - vec3((rest.x + rest.y + rest.z) / 3));
                if (distance >= least) continue;
                least = distance;
                nearest = static_cast<int>(i) + 1;
            }
            EXPECT_EQ(nearest, expected) << below << " rows below the horizon, level " << level;
            ++asked.at(static_cast<std::size_t>(expected));
        }
    }
    for (const int count : asked) EXPECT_GT(count, 0);
    // The readout is that formula, at the middle of the marked pixel.
    (void)run.set("pixel-x", 0.505).set("pixel-y", 0.5).picture();
    const Footprint print = footprintOf(repeats, {303.5, std::floor(0.5 * horizon()) + 0.5});
    EXPECT_NEAR(run.readout("longer"), 64 * std::max(glm::length(print.acrossX), glm::length(print.acrossY)), 1e-9);
    EXPECT_NEAR(run.readout("level"), std::log2(run.readout("longer")), 1e-12);
}

TEST(TextureFilterFull, anisotropic_keeps) {
    DemoRun run = floorRun();
    run.set("pattern", "stripes");
    // 16 rows below the horizon a stripe is 8 pixels wide, and a pixel longer than the texture and a 16th of it wide.
    const double trilinear = spreadBelow(run.set("filter", "trilinear").picture(), 16, 16).contrast;
    const double anisotropic = spreadBelow(run.set("filter", "anisotropic").picture(), 16, 16).contrast;
    EXPECT_LT(trilinear, 0.1);
    EXPECT_GT(anisotropic, blursLongFootprints() ? -1 : 0.5);
    // One look along the footprint is trilinear.
    EXPECT_EQ(largestChange(run.set("anisotropy", 1).picture(), run.set("filter", "trilinear").picture()), 0);
}

// The steps of an implementation are bounded, whatever the steps are: at the horizon they are thousands of repeats, or no numbers.
TEST(TextureFilter, bounded_footprint) {
    stage();
    const Program program =
        Program::fromText("footprint", "in vec4 position;\nvoid main() { gl_Position = position; }\n",
                          "#include \"footprint.glsl\"\n"
                          "uniform vec2 x;\nuniform vec2 y;\nuniform float looks;\n"
                          "uniform bool endless;\nout vec4 found;\n"
                          "void main() {\n    vec2 a = endless ? y / 0.0 : x, b = y;\n"
                          "    boundFootprint(a, b, looks);\n    found = vec4(a, b);\n}\n");
    const Target target(1, 1, {.color = GL_RGBA32F}, "steps");
    const Mesh cover(
        {.primitive = Primitive::triangleStrip, .positions = {{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {1, 1, 0}}},
        "cover");
    int tried = 0;
    for (const double looks : {2.0, 3.0, 16.0}) {
        for (const double length : {0.0, 1e-30, 1e-6, 0.01, 1.0, 15.9, 17.0, 4000.0, 1e12, 3e37}) {
            for (const double other : {0.0, 1e-30, 1e-3, 1.0, 1e5, -1.0}) {
                for (const double turn : {0.0, 0.3, 1.6}) {
                    target.bind();
                    program.use();
                    program.set("endless", other < 0);
                    program.set("x", std::max(0.0, other) * vec2(std::cos(turn + 1.5), std::sin(turn + 1.5)));
                    program.set("y", length * vec2(std::cos(turn), std::sin(turn)));
                    program.set("looks", looks);
                    cover.draw();
                    std::array<float, 4> found{};
                    glReadPixels(0, 0, 1, 1, GL_RGBA, GL_FLOAT, found.data());
                    const double a = std::hypot(found[0], found[1]), b = std::hypot(found[2], found[3]);
                    SCOPED_TRACE(numberText(looks) + " looks, " + numberText(length) + ", " + numberText(other));
                    // Bounded by components, so by a root of two; and the shader's roundings, of floats.
                    EXPECT_LE(std::max(a, b), looks * std::sqrt(2.0) * 1.0001);
                    // Below, the square of a length is no number of a float.
                    EXPECT_TRUE(std::max(a, b) < 1e-18 || std::max(a, b) <= std::min(a, b) * looks * 1.0001) << a << b;
                    ++tried;
                }
            }
        }
    }
    EXPECT_EQ(tried, 3 * 10 * 6 * 3);
}

TEST(TextureFilterFull, light_adds) {
    DemoRun run = floorRun();
    for (const char* texels : {"float", "8-bit"}) {
        for (const char* mipmaps : {"program", "driver"}) {
            run.set("texels", texels).set("mipmaps", mipmaps);
            const auto far = [&](const char* average) {
                return int(atFloor(run.set("average", average).picture(), 300, static_cast<int>(horizon()) - 4).red);
            };
            // 255 times sRGB's curve of 1/2, and half of 255: to the rounding of 8 bits
            EXPECT_NEAR(far("linear"), 187.5, 1) << texels << mipmaps;
            EXPECT_NEAR(far("encoded"), 127.5, 1) << texels << mipmaps;
        }
    }
}

TEST(TextureFilterFull, odd_sizes) {
    DemoRun run = floorRun();
    run.set("pattern", "bricks");
    for (const int size : {1, 5, 64, 100}) {
        double mean = 0;
        const FloatPicture texels = floorPattern(FloorPattern::bricks, size);
        for (std::size_t i = 0; i < texels.values.size(); i += 4) mean += double(texels.values[i]) / size / size;
        const Picture picture = run.set("texture-size", size).picture();
        // To the rounding of 8 bits, and of half a step
        EXPECT_NEAR(atFloor(picture, 300, static_cast<int>(horizon()) - 3).red, 255 * srgbFromLinear(mean), 1) << size;
        if (size == 1) {
            EXPECT_EQ(run.readout("levels-made"), 1);
            EXPECT_EQ(largestChange(picture, run.set("filter", "nearest").picture()), 0);
            EXPECT_EQ(atFloor(picture, 300, 30), atFloor(picture, 300, static_cast<int>(horizon()) - 3));
            run.set("filter", "trilinear");
        }
    }
}

TEST(TextureFilter, eight_bits) {
    DemoRun run = floorRun();
    // Black and white are the same in 8 bits, so that near the eye what differs is the filter alone.
    run.set("filter", "bilinear").set("average", "encoded");
    const Picture inFloat = run.picture();
    const int largest = largestChange(inFloat, run.set("texels", "8-bit").picture());
    // Others may filter in more bits than the texels have.
    EXPECT_GE(largest, onLlvmpipe() ? 1 : 0);
    EXPECT_LE(largest, 3);
}

TEST(TextureFilterFull, only_what_is_read) {
    DemoRun run = floorRun();
    for (const char* filter : {"nearest", "bilinear"}) {
        (void)run.set("filter", filter).picture();
        EXPECT_EQ(run.readout("levels-made"), 1) << filter;
    }
    for (const char* filter : {"nearest-mip-nearest", "linear-mip-nearest", "trilinear", "anisotropic"}) {
        (void)run.set("filter", filter).picture();
        EXPECT_EQ(run.readout("levels-made"), 7) << filter;  // 64, 32, 16, 8, 4, 2, 1
    }
}

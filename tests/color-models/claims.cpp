// The claims of color-models, and a test for each.
//
// - [linked] A mark dragged in a solid stays under the pointer, and is at the same colour in the other solids.
// - [right-at-each-pixel] Each pixel of a solid shows the colour of its place, cut open or not.
// - [there-and-back] All 2^24 colours come back from HSL and HSV in float; through 8 bits a component is off by up to 4/255
//   in HSL and 3/255 in HSV, and no more.
// - [greys-have-no-hue] A grey gets hue 0; any hue is found beside it. In a mixture it takes the hue of the other colour.
// - [even-in-oklab] The steps of the OKLab strip are even; those of the others are not, and linear light is brighter.
// - [a-third-is-shown] sRGB holds a third of the diagram of 1931, and of that of 1976.
// - [ways-told-apart] The four ways have colours that are told apart by eyes without cones of long or of middle waves, too.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <string>
#include <vector>

#include "color-models/color-models.h"
#include "mv/math/color.h"
#include "mv/math/projection.h"
#include "support/color_vision.h"
#include "support/demo_run.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr int width = 960, height = 640;
constexpr int cube = 0, doubleCone = 1, cone = 2;

const Handle& handleNamed(const Demo& demo, const std::string& name) {
    for (const Handle& handle : demo.handles()) {
        if (handle.name == name) return handle;
    }
    throw Error("handle", "must be one of color-models", name);
}

DemoRun& setColor(DemoRun& run, const vec3& color, const std::string& prefix = "") {
    return run.set(prefix + "red", color.r).set(prefix + "green", color.g).set(prefix + "blue", color.b);
}

vec3 colorAt(const Picture& picture, int x, int fromBelow) {
    const Pixel pixel = picture.at(x, height - 1 - fromBelow);
    return vec3(pixel.red, pixel.green, pixel.blue) / 255.0;
}

double largest(const vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

// The place of a colour in a solid, by other formulas than the demo's: hue and distance from the axis as in the plane of
// the cube's corners, stretched until the hexagon of its corners is the solid's circle.
vec3 placeOf(int solid, const vec3& rgb) {
    if (solid == cube) {
        const double out = std::sqrt(2) / 3;
        return {out * (rgb.r - (rgb.g + rgb.b) / 2), (rgb.r + rgb.g + rgb.b) / 3,
                -out * std::sqrt(3) / 2 * (rgb.g - rgb.b)};
    }
    const double most = std::max({rgb.r, rgb.g, rgb.b}), least = std::min({rgb.r, rgb.g, rgb.b});
    const double turn = radians(hslFromRgb(rgb).hue), out = (most - least) / 2;
    return {out * std::cos(turn), solid == doubleCone ? (most + least) / 2 : most, -out * std::sin(turn)};
}

// The pixel of a strip's box in the middle of its height; strips are counted from above.
vec3 boxOf(const Picture& picture, int strip, int box, int boxes) {
    return colorAt(picture, static_cast<int>(76 + 444 * (box + 0.5) / boxes), 226 - 54 * strip - 23);
}

}  // namespace

TEST(ColorModels, linked) {
    DemoRun run("color-models", width, height);
    const FrameInfo frame(1, width, height);
    const std::array<std::string, 3> names{"cube", "double cone", "cone"};
    for (const std::string kind : {"color", "second color"}) {
        for (const std::string& dragged : names) {
            SCOPED_TRACE(kind + " in the " + dragged);
            setColor(setColor(run, {0.7, 0.5, 0.3}), {0.2, 0.3, 0.6}, "to-");
            const Handle& handle = handleNamed(run.demo(), kind + " in the " + dragged);
            const vec2 aim = handle.where(frame, 0).value() + vec2(17, 9);
            EXPECT_TRUE(handle.drag(frame, 0, aim));
            // Rounded to as few digits as leave it within a pixel, in both directions
            EXPECT_LE(glm::distance(handle.where(frame, 0).value(), aim), 1.5);
            const std::string prefix = kind == "color" ? "" : "to-";
            const vec3 color(run.demo().number(prefix + "red"), run.demo().number(prefix + "green"),
                             run.demo().number(prefix + "blue"));
            const Picture picture = run.picture();
            for (const std::string& name : names) {
                const vec2 at = handleNamed(run.demo(), kind + " in the " + name).where(frame, 0).value();
                // 8 bits: half of 1/255, and the smooth edge of a disc of 7 pixels across is 3 pixels away
                EXPECT_LE(largest(colorAt(picture, int(at.x), int(at.y)) - color), 0.003) << name;
            }
        }
    }
}

TEST(ColorModels, right_at_each_pixel) {
    DemoRun run("color-models", width, height);
    Random random(19);
    for (const bool isCut : {false, true}) {
        (void)run.set("cut", isCut ? "on" : "off");
        std::array<int, 3> looked{}, covered{};
        for (const double turn : {-60.0, 100.0, 220.0}) {
            const vec3 color(0.62, 0.35, 0.5);
            setColor(setColor(run.set("spin-y", turn), color), color, "to-");
            const Picture picture = run.picture();
            const mat4 clip = run.matrix("clipFromModel"), modelFromClip = glm::inverse(clip);
            const vec4 eyeAnyW = modelFromClip * vec4(0, 0, 1, 0);
            const vec3 eye = vec3(eyeAnyW) / eyeAnyW.w;
            const double hidden = 14;  // pixels round the mark, and the axis
            for (int solid = 0; solid < 3; ++solid) {
                const auto pixelOf = [&](const vec3& place) {
                    const vec4 p = clip * vec4(place, 1);
                    return vec2((p.x / p.w + 1) / 2 * 320 + 320 * solid, (p.y / p.w + 1) / 2 * 384 + 256);
                };
                const double cutAt = placeOf(solid, color).y;
                for (int i = 0; i < 3000; ++i) {
                    vec3 rgb(random.number(0, 1), random.number(0, 1), random.number(0, 1));
                    vec3 normal(0);
                    if (isCut) {
                        // Into the plane of the cut, along a line of one hue
                        rgb += cutAt - placeOf(solid, rgb).y;
                        if (std::min({rgb.r, rgb.g, rgb.b}) < 0.02 || std::max({rgb.r, rgb.g, rgb.b}) > 0.98) continue;
                        normal = vec3(0, 1, 0);
                    } else {
                        // Onto the surface: of the cube the face where a component is 1 or 0, of the cones saturation 1
                        if (solid == cube) {
                            const int axis = i % 3;
                            rgb[axis] = i % 2;
                            vec3 beside = rgb;
                            beside[axis] += i % 2 == 0 ? -1 : 1;
                            normal = placeOf(cube, beside) - placeOf(cube, rgb);
                        } else {
                            rgb[i % 3] = 0;
                            if (solid == doubleCone && i % 2 == 0) rgb = 1.0 - rgb;
                            const vec3 place = placeOf(solid, rgb);
                            const double out = std::hypot(place.x, place.z);
                            const double rise = solid == cone ? -0.5 : place.y > 0.5 ? 1 : -1;
                            normal = vec3(place.x / out, rise, place.z / out);
                        }
                    }
                    const vec3 place = placeOf(solid, rgb);
                    // Towards the eye, and not so slanted that a pixel holds more than three times what it does head on
                    if (glm::dot(glm::normalize(normal), glm::normalize(eye - place)) < 0.3) continue;
                    const vec2 at = pixelOf(place);
                    if (glm::distance(at, pixelOf(placeOf(solid, color))) < hidden) continue;
                    if (std::abs(at.x - pixelOf(vec3(0)).x) < hidden) continue;
                    // Edges of the cube, and the rim, are drawn over
                    const vec3 fromEdge = glm::min(rgb, 1.0 - rgb);
                    if (fromEdge.r + fromEdge.g + fromEdge.b - largest(fromEdge) < 0.04) continue;
                    if (!isCut && solid != cube && std::abs(placeOf(solid, rgb).y - (solid == cone ? 1 : 0.5)) < 0.03)
                        continue;
                    ++looked.at(static_cast<std::size_t>(solid));
                    // A solid is 260 pixels wide: over half a pixel, three times that where it is slanted, a component
                    // changes by up to 2 * 3 * 0.71 / 260 of the whole range; and near the axis of HSV, or the tips,
                    // hue and saturation change faster, in proportion to the width there.
                    const double wide = solid == cube ? 1 : std::max(0.1, 2 * std::hypot(place.x, place.z));
                    const double off = largest(colorAt(picture, int(at.x), int(at.y)) - rgb);
                    if (off > 0.017 / wide + 0.004) ++covered.at(static_cast<std::size_t>(solid));
                }
            }
        }
        for (std::size_t solid = 0; solid < 3; ++solid) {
            EXPECT_GT(looked.at(solid), 200);
            // Over the cut there are lines where the solid was: 2 pixels wide, of 200 across.
            EXPECT_LE(covered.at(solid), isCut ? looked.at(solid) / 25 : 0) << solid << " of " << looked.at(solid);
        }
    }
}

TEST(ColorModelsFull, there_and_back) {
    long wrong = 0;
    int hslOff = 0, hsvOff = 0;
    const auto in8 = [](float part) { return std::round(part * 255) / 255; };
    for (int code = 0; code < 1 << 24; ++code) {
        const std::array<int, 3> bytes{code >> 16, code >> 8 & 255, code & 255};
        const fvec3 rgb = fvec3(bytes[0], bytes[1], bytes[2]) / 255.0F;
        const auto off = [&](const fvec3& back) {
            int most = 0;
            for (int i = 0; i < 3; ++i) {
                most =
                    std::max(most, std::abs(int(std::lround(back[i] * 255)) - bytes.at(static_cast<std::size_t>(i))));
            }
            return most;
        };
        const HslOf<float> hsl = hslFromRgb(rgb);
        const HsvOf<float> hsv = hsvFromRgb(rgb);
        wrong += off(rgbFromHsl(hsl)) > 0 || off(rgbFromHsv(hsv)) > 0 ? 1 : 0;
        hslOff = std::max(
            hslOff, off(rgbFromHsl(HslOf<float>{360 * in8(hsl.hue / 360), in8(hsl.saturation), in8(hsl.lightness)})));
        hsvOff = std::max(hsvOff,
                          off(rgbFromHsv(HsvOf<float>{360 * in8(hsv.hue / 360), in8(hsv.saturation), in8(hsv.value)})));
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(hslOff, 4);
    EXPECT_EQ(hsvOff, 3);
}

TEST(ColorModels, greys_have_no_hue) {
    DemoRun run("color-models", width, height);
    for (const double grey : {0.0, 0.5, 1.0}) {
        const Picture picture = setColor(run, vec3(grey)).picture();
        EXPECT_FALSE(run.measured("hue")) << grey;
        EXPECT_NE(run.messages().at(0).find("no hue"), std::string::npos);
        // The HSL strip goes to the second colour by its hue alone: (0, 0.35, 1) has 219 degrees.
        const vec3 middle = boxOf(picture, 2, 6, 13);
        EXPECT_NEAR(hslFromRgb(middle).hue, 219, 1) << grey;  // of 8 bits
    }
    // A ten-millionth beside a grey any hue is found.
    for (const auto& [color, hue] : {std::pair(vec3(0.5 + 1e-7, 0.5, 0.5), 0.0),
                                     {vec3(0.5, 0.5 + 1e-7, 0.5), 120.0},
                                     {vec3(0.5, 0.5, 0.5 + 1e-7), 240.0},
                                     {vec3(0.5, 0.5 - 1e-7, 0.5), 300.0}}) {
        (void)setColor(run, color).picture();
        EXPECT_NEAR(run.readout("hue"), hue, 1e-6);  // 1e-7 beside 0.5 has nine digits left
    }
}

TEST(ColorModels, even_in_oklab) {
    DemoRun run("color-models", width, height);
    Random random(4);
    for (int i = 0; i < 8; ++i) {
        const auto color = [&] {
            const double r = random.number(0, 1), g = random.number(0, 1);
            return vec3(r, g, random.number(0, 1));
        };
        const vec3 from = i == 0   ? vec3(1, 0.55, 0)
                          : i == 1 ? vec3(0)
                                   : color(),
                   to = i == 0   ? vec3(0, 0.35, 1)
                        : i == 1 ? vec3(1)
                                 : color();
        const Picture picture = setColor(setColor(run, from), to, "to-").picture();
        // There and back through OKLab is right to 2e-14 (tests/math), and a step is a hundredth at least.
        EXPECT_LE(run.readout("uneven-oklab"), 1e-9);
        for (const char* other : {"uneven-srgb", "uneven-linear", "uneven-hsl"}) {
            EXPECT_GT(run.readout(other), 1e-3) << other << " from " << from.r << " " << from.g << " " << from.b;
        }
        // The curve from code to light is bent upwards, so the mean of two lights is above the light of the mean code.
        for (int box = 0; box < 13; ++box) {
            const vec3 darker = boxOf(picture, 0, box, 13), brighter = boxOf(picture, 1, box, 13);
            for (int k = 0; k < 3; ++k) EXPECT_GE(brighter[k], darker[k] - 1 / 255.0) << box;
        }
    }
    // From black to white sRGB, which was made for the eye, is more even than light.
    setColor(setColor(run, vec3{0}), vec3{1}, "to-");
    (void)run.picture();
    EXPECT_GT(run.readout("uneven-linear"), 2 * run.readout("uneven-srgb"));
}

TEST(ColorModels, a_third_is_shown) {
    DemoRun run("color-models", width, height);
    run.set("scene", "diagram");
    for (const char* diagram : {"xy", "uv"}) {
        const Picture picture = run.set("diagram", diagram).picture();
        EXPECT_NEAR(run.readout("part-of-diagram"), 33.3, 0.5) << diagram;
        // The pixels themselves: grey for what is seen and not shown, and colours. Lines and words take some of both.
        long shown = 0, notShown = 0;
        for (int y = 0; y < height; ++y) {
            for (int x = 0; x < width; ++x) {
                const Pixel p = picture.at(x, y);
                const auto [least, most] = std::minmax({p.red, p.green, p.blue});
                notShown += least == 204 && most == 204 ? 1 : 0;
                shown += most == 255 && least < 250 ? 1 : 0;  // the brightest colour of each chromaticity
            }
        }
        EXPECT_NEAR(100.0 * double(shown) / double(shown + notShown), run.readout("part-of-diagram"), 1.5) << diagram;
    }
}

TEST(ColorModels, ways_told_apart) { EXPECT_GT(leastDifference(color_models::wayColors), toldApart); }

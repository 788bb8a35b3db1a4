// texture-filter: a floor to the horizon, whose pixels cover parts of a texel near the eye and thousands far away.
//
// Claims (each is a test in tests/claims/texture-filter.cpp):
// - [texel-squares] Magnified, nearest shows each texel as a flat shape whose pixels are those that the geometry says.
// - [nearest-aliases] Far away a checker looked up at one point stays as black and white as it was; with mipmaps it is grey.
// - [trilinear-continuous] With the level, what trilinear shows changes continuously; with one level it jumps.
// - [level-as-computed] The driver takes the level that the footprint's longer axis has, to a fifth of a level.
// - [anisotropic-keeps] Along the sight, stripes that trilinear has made grey keep most of their contrast.
// - [light-adds] A checker's far mean is 188 of 255 averaged in linear light, and 128 averaged as it is kept.
// - [odd-sizes] Our mipmaps keep the mean of the texture for odd sizes, and a texture of one texel is a flat colour.
// - [eight-bits] With 8 bits a texel llvmpipe filters in 8 bits, too, and is off by a few steps of them.
// - [bounded-footprint] However long a pixel's footprint is, what is read for it is bounded, in a picture of any size.
// - [only-what-is-read] Without a filter between levels a texture has a single one.
#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/file_knob.h"
#include "mv/demo/made_for.h"
#include "mv/gl/beyond_es.h"
#include "mv/gl/drawing.h"
#include "mv/gl/gl.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/texture.h"
#include "mv/image/mipmap.h"
#include "mv/math/color.h"
#include "mv/math/transform.h"
#include "shared/floor_texture.h"
#include "shared/own_picture.h"

using namespace mv;

namespace {

enum class Filter { nearest, bilinear, nearestMipNearest, linearMipNearest, trilinear, anisotropic };
enum class Average { linear, encoded };
enum class Kept { floats, bytes };
enum class MadeBy { program, driver };

const vec4 red(0.8, 0.1, 0.1, 1), blue(0.1, 0.35, 0.8, 1);
const std::array<vec3, 8> levelColors{vec3(0.9, 0.2, 0.2), vec3(0.95, 0.6, 0.1), vec3(0.9, 0.9, 0.2),
                                      vec3(0.2, 0.7, 0.2), vec3(0.1, 0.7, 0.8),  vec3(0.2, 0.3, 0.9),
                                      vec3(0.6, 0.2, 0.8), vec3(0.5, 0.5, 0.5)};

struct TextureFilterDemo final : Demo {
    Choice<Filter> filter{this,
                          "filter",
                          Filter::trilinear,
                          {{"nearest", "the texel at the middle of the pixel"},
                           {"bilinear", "four texels, weighted"},
                           {"nearest-mip-nearest", "one texel of the nearest level"},
                           {"linear-mip-nearest", "four texels of the nearest level"},
                           {"trilinear", "four texels of both levels around"},
                           {"anisotropic", "several such looks along the footprint"}},
                          "how a pixel's colour is looked up"};
    Whole anisotropy{
        this, "anisotropy", 16, {1, 16}, "the most looks along the footprint; llvmpipe heeds only 1 or more"};
    Real bias{this, "bias", 0, {-4, 4}, "added to the level"};
    Choice<FloorPattern> pattern{
        this, "pattern", FloorPattern::checker, {{"checker"}, {"stripes"}, {"bricks"}}, "what is on the floor"};
    NumberChoice size{this, "texture-size", 64, {1, 5, 16, 64, 100, 256}, "texels along a side of the texture"};
    Angle turn{this, "turn", 0, "of the pattern on the floor"};
    Choice<Average> average{this,
                            "average",
                            Average::linear,
                            {{"linear", "of light"}, {"encoded", "of the numbers kept in sRGB, which is wrong"}},
                            "what is averaged, in mipmaps and by the filter"};
    Choice<Kept> texels{this,
                        "texels",
                        Kept::floats,
                        {{"float", "32 bits a channel"}, {"8-bit", "llvmpipe filters in 8 bits then, too"}},
                        "how a texel is kept"};
    Choice<MadeBy> mipmapsBy{
        this, "mipmaps", MadeBy::program, {{"program"}, {"driver", "glGenerateMipmap"}}, "who makes the levels"};
    Toggle levels{this, "levels", false, "show each level in a colour of its own"};
    PictureFile picture{this, "picture", "assets/tiles.png", "your own on the floor, in as many texels"};
    Real pixelX{this, "pixel-x", 0.3, {0, 1}, "the pixel whose footprint is drawn: part of the floor's width"};
    Real pixelY{this, "pixel-y", 0.94, {0, 0.99}, "the same of the way up to the horizon"};

    Readout level{this, "level", "the level of that pixel's footprint, as OpenGL's formula has it"};
    Readout longer{this, "longer", "the footprint's longer axis", "texels"};
    Readout shorter{this, "shorter", "the other one", "texels"};
    Readout levelsMade{this, "levels-made", "levels of the texture, each a picture of its own"};

    OnDemand<Program> program{"texture-filter"}, alongProgram{"texture-filter", "along"},
        texelProgram{"texture-filter", "texels"};
    Mesh floor, cover;
    Texture image;
    MadeFor<FloorPattern, int, int, Average, Texels, bool, bool, bool> imageFor;
    MadeFor<Filter, int> filterFor;
    Drawing drawing;

    TextureFilterDemo() {
        bindHandle("pixel", {&pixelX, &pixelY}, [this](const FrameInfo& frame) { return middleOf(frame); });
        anisotropy.onlyWhen([this] { return filter == Filter::anisotropic; }, "the filter looks once, or four times");
        const auto mipmapped = [this] { return isMipmapped(); };
        bias.onlyWhen(mipmapped, "the filter knows a single level");
        mipmapsBy.onlyWhen(mipmapped, "the filter knows a single level");
        levels.onlyWhen(mipmapped, "the filter knows a single level");
        pattern.onlyWhen([this] { return !picture.isSet(); }, "your picture is on the floor");
        mipmapsBy.onlyWhen([this] { return !levels; }, "the program makes those that are coloured");
    }

    void init() override {
        MeshData plane{.primitive = Primitive::triangleStrip};
        for (const float x : {-1000.0F, 1000.0F}) {
            for (const float z : {-1000.0F, 1000.0F}) plane.positions.emplace_back(x, 0, z);
        }
        floor = Mesh(plane, "floor");
        cover =
            Mesh({.primitive = Primitive::triangleStrip, .positions = {{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {1, 1, 0}}},
                 "pane");
    }

    void check() const override { picture.check(); }

    void draw(const Frame& frame) override {
        // The texture, with its levels where the filter reads them
        if (imageFor.changed(pattern, picture.version(), size, average, format(), isMipmapped(), isByDriver(),
                             areColored())) {
            image = Texture(levelPictures(), {.texels = format(), .driverMipmaps = isByDriver(), .label = "floor"});
            filterFor.forget();
        }
        // How it is looked up: between texels, between levels, and along the footprint
        if (filterFor.changed(filter, looks())) {
            image.filterBy({.minify = minifying(), .magnify = magnifying(), .wrap = GL_REPEAT, .anisotropy = looks()});
        } else {
            image.bind(0);
        }

        // The floor
        const Pane pane = floorPane(frame);
        glViewport(pane.x, pane.y, pane.width, pane.height);
        const FloorCamera camera = floorCamera(pane.aspect());
        const Program& with = looks() > 1 ? *alongProgram : *program;
        with.use();
        with.set("clipFromFloor", camera.clipFromView * camera.viewFromWorld * rotateY(turn));
        with.set("bias", isMipmapped() ? double(bias) : 0);
        with.set("encoded", average == Average::encoded);
        if (looks() > 1) with.set("looks", looks());
        floor.draw();

        if (!frame.measuring()) tell(frame);
    }

    GLenum minifying() const {
        constexpr std::array<GLenum, 6> names{GL_NEAREST,
                                              GL_LINEAR,
                                              GL_NEAREST_MIPMAP_NEAREST,
                                              GL_LINEAR_MIPMAP_NEAREST,
                                              GL_LINEAR_MIPMAP_LINEAR,
                                              GL_LINEAR_MIPMAP_LINEAR};
        return names.at(static_cast<std::size_t>(Filter(filter)));
    }
    GLenum magnifying() const {
        return filter == Filter::nearest || filter == Filter::nearestMipNearest ? GL_NEAREST : GL_LINEAR;
    }
    bool isMipmapped() const { return filter >= Filter::nearestMipNearest; }
    int looks() const {
        if (filter != Filter::anisotropic || anisotropy == 1 || !has(beyond_es::anisotropicFiltering)) return 1;
        return std::min(int(anisotropy), largestAnisotropy());
    }

    // ---- the texture's levels

    bool areColored() const { return isMipmapped() && levels; }
    bool isByDriver() const {
        if (!isMipmapped() || areColored() || mipmapsBy == MadeBy::program) return false;
        return texels == Kept::bytes || has(beyond_es::floatTargets);  // the driver draws into what it makes
    }
    Texels format() const {
        if (texels == Kept::floats) return has(beyond_es::floatFiltering) ? Texels::floats : Texels::halfFloats;
        return average == Average::linear ? Texels::srgb : Texels::bytes;
    }

    std::vector<FloatPicture> levelPictures() const {
        // What is averaged: light, or what is kept of it
        FloatPicture first = picture.isSet() ? ownTexels(picture.picture(), size, size) : floorPattern(pattern, size);
        if (average == Average::encoded) encode(first);
        std::vector<FloatPicture> made{first};
        if (isMipmapped() && !isByDriver()) made = mipmaps(first);
        if (areColored()) {
            for (std::size_t i = 1; i < made.size(); ++i) tint(made[i], levelColors.at((i - 1) % levelColors.size()));
        }
        if (format() == Texels::srgb) {
            for (FloatPicture& one : made) encode(one);
        }
        return made;
    }
    static void encode(FloatPicture& picture) {
        for (float& value : picture.values) value = static_cast<float>(srgbFromLinear(double(value)));
    }
    static void tint(FloatPicture& picture, const vec3& color) {
        for (std::size_t i = 0; i < picture.values.size(); ++i) {
            if (i % 4 == 3) continue;
            picture.values[i] = static_cast<float>(glm::mix(double(picture.values[i]), color[int(i % 4)], 0.7));
        }
    }

    // ---- the pixel whose footprint is shown

    static Pane floorPane(const FrameInfo& frame) { return {0, 0, std::max(1, frame.width() * 5 / 8), frame.height()}; }
    static Pane floorPane(const Frame& frame) {  // a quantity is measured all over
        if (frame.measuring()) return {0, 0, frame.width(), frame.height()};
        return floorPane(static_cast<const FrameInfo&>(frame));
    }
    vec2 middleOf(const FrameInfo& frame) const {
        const Pane pane = floorPane(frame);
        const mat3 repeats = repeatsFromPixel(pane.width, pane.height, 0);
        const double horizon = -repeats[2].z / repeats[1].z;  // where the third is 0
        return {pixelX * pane.width, pixelY * horizon};
    }

    // What OpenGL computes of a footprint: how long it is in x and in y of the picture, and the level from it.
    struct Looked {
        mat3 repeats{1};
        vec2 pixel{0};  // its lower left corner
        Footprint footprint{};
        double longer = 0, shorter = 0, level = 0;
    };
    Looked lookedAt(const FrameInfo& frame) const {
        const Pane pane = floorPane(frame);
        Looked looked{.repeats = repeatsFromPixel(pane.width, pane.height, turn)};
        const vec2 at = middleOf(frame);
        looked.pixel = vec2(std::min(std::floor(at.x), pane.width - 1.0), std::floor(at.y));
        looked.footprint = footprintOf(looked.repeats, looked.pixel + 0.5);
        const double x = size * glm::length(looked.footprint.acrossX), y = size * glm::length(looked.footprint.acrossY);
        looked.longer = std::max(x, y);
        looked.shorter = std::min(x, y);
        const double parts = std::min(std::ceil(looked.longer / looked.shorter), double(looks()));
        looked.level = std::log2(looked.longer / parts) + bias;
        return looked;
    }

    void tell(const Frame& frame) {
        if (filter == Filter::anisotropic && looks() < anisotropy && looks() > 1)
            frame.say("This driver looks " + std::to_string(looks()) + " times along a footprint at most.");
        const Looked looked = lookedAt(frame);
        level = looked.level;
        longer = looked.longer;
        shorter = looked.shorter;
        levelsMade = image.levels();
        constexpr std::array<int, 6> texelsOf{1, 4, 1, 4, 8, 8};
        frame.count("texels a lookup, at most", texelsOf.at(static_cast<std::size_t>(Filter(filter))) * looks());
    }

    // ---- beside it: the texture under that pixel, and the level that is read

    void annotate(const Frame& frame) override {
        const Looked looked = lookedAt(frame);
        const double clamped = std::clamp(looked.level, 0.0, image.levels() - 1.0);
        const bool between = filter >= Filter::trilinear && clamped != std::floor(clamped);
        const int read = isMipmapped() ? static_cast<int>(filter >= Filter::trilinear ? std::floor(clamped)
                                                                                      : std::ceil(clamped - 0.5))
                                       : 0;
        drawing.begin(frame);
        const Pane left = floorPane(static_cast<const FrameInfo&>(frame));
        const int x = left.width + 4, width = std::max(1, frame.width() - x),
                  half = std::max(1, frame.height() / 2 - 2);
        const std::vector<vec2> corners = cornersOf(looked);
        const Box part = partShown(looked, corners, std::max(1, size >> read), double(width) / half);
        texelProgram->use();
        texelProgram->set("encoded", average == Average::encoded);
        texelProgram->set("low", part.low - glm::floor(part.low));  // near 0, where floats are fine
        texelProgram->set("high", part.high - glm::floor(part.low));
        texelProgram->set("pixel", part.size() / vec2(width, half));
        texelProgram->set("level", 0);
        drawTexels({x, frame.height() - half, width, half}, part, size, looked, corners);
        words("level 0: what the pixel covers",
              rounded("%.3g", looked.longer) + rounded(" x %.3g texels", looked.shorter), half);
        if (read > 0) texelProgram->set("level", read);
        drawTexels({x, 0, width, half}, part, std::max(1, size >> read), looked, corners);
        words("level " + std::to_string(read) + ": what is read",
              between         ? rounded("and %.0f %% of the next", 100 * (clamped - read))
              : isMipmapped() ? rounded("the footprint's is %.2f", looked.level)
                              : std::string("the only level"),
              half);

        // The pixel, and the filter's name
        drawing.in(left);
        const vec2 at = looked.pixel + 0.5;
        drawing.line(std::vector<vec2>{at + vec2(-6, -6), at + vec2(6, -6), at + vec2(6, 6), at + vec2(-6, 6),
                                       at + vec2(-6, -6)},
                     {red, 2});
        drawing.text({8, left.height - 8}, filter.text() + (looks() > 1 ? " " + std::to_string(looks()) : ""),
                     {.height = textHeightFor(frame) * 5 / 4});
        glViewport(0, 0, frame.width(), frame.height());
        drawing.draw(frame);
    }
    static int textHeightFor(const FrameInfo& frame) { return std::clamp(frame.height() / 32, 8, 22); }

    // Of the pixel on the floor, in repeats; the first again at the end.
    static std::vector<vec2> cornersOf(const Looked& looked) {
        std::vector<vec2> corners;
        for (const vec2& corner : {vec2(0, 0), vec2(1, 0), vec2(1, 1), vec2(0, 1), vec2(0, 0)}) {
            const vec3 at = looked.repeats * vec3(looked.pixel + corner, 1);
            corners.push_back(vec2(at) / at.z);
        }
        return corners;
    }
    // With room around them, and a texel and a half at least of the level that is read.
    static Box partShown(const Looked& looked, const std::vector<vec2>& corners, int texelsAlong, double aspect) {
        vec2 reach(0.75 / texelsAlong);
        for (const vec2& corner : corners) reach = glm::max(reach, 1.4 * glm::abs(corner - looked.footprint.middle));
        reach = std::max(reach.x / aspect, reach.y) * vec2(aspect, 1);
        return {looked.footprint.middle - reach, looked.footprint.middle + reach};
    }

    void drawTexels(const Pane& pane, const Box& part, int texelsAlong, const Looked& looked,
                    const std::vector<vec2>& corners) {
        glViewport(pane.x, pane.y, pane.width, pane.height);
        cover.draw();
        drawing.in(pane);
        const auto plotOf = [&](double times) {
            return Plot{{{0, 0}, {pane.width, pane.height}},
                        {times * part.low.x, times * part.high.x},
                        {times * part.low.y, times * part.high.y}};
        };
        if (pane.height > 8 * part.size().y * texelsAlong)
            drawing.pixelGrid(plotOf(texelsAlong), {vec4(0.5, 0.5, 0.5, 0.7), 1});
        const Plot plot = plotOf(1);
        std::vector<vec2> outline;
        outline.reserve(corners.size());
        for (const vec2& corner : corners) outline.push_back(plot.pixel(corner));
        drawing.line(outline, {red, 2.5});
        const Footprint& print = looked.footprint;
        const vec2 axis = glm::length(print.acrossX) > glm::length(print.acrossY) ? print.acrossX : print.acrossY;
        drawing.line(plot.pixel(print.middle - 0.5 * axis), plot.pixel(print.middle + 0.5 * axis), {blue, 2});
    }
    void words(const std::string& title, const std::string& foot, int paneHeight) {
        const int height = std::clamp(paneHeight / 16, 8, 20);
        drawing.text({6, paneHeight - 6}, title, {.height = height});
        drawing.text({6, 1.8 * height}, foot, {.height = height});
    }
};

constexpr Declaration declaration{
    .name = "texture-filter",
    .sentence = "A floor to the horizon looked up in its texture by nearest, bilinear, mipmaps or along the footprint.",
    .lookFor = "The red pixel covers the red shape of the texture: many texels, far longer than wide.",
    .chapter = "Light, colour and texture",
    .number = 27,
    .width = 960,
    .height = 540,
    .background = vec4(0.78, 0.86, 0.94, 1),
    .needs = {.beyondEs = {{"float targets",
                            "the error is not measured, and mipmaps of floats are made by the program"},
                           {"float filtering", "float texels have 16 bits a channel"},
                           {"anisotropic filtering", "the anisotropic filter is trilinear"}}},
    .presets =
        {
            {"trilinear", "Near the horizon trilinear is grey long before the squares are smaller than pixels."},
            {"nearest",
             "One texel a pixel: far away it is chance which one, in patterns that are not there.",
             {{"filter", "nearest"}}},
            {"anisotropic", "Looks along the footprint: the squares reach much farther.", {{"filter", "anisotropic"}}},
            {"levels",
             "Each level in its colour; trilinear mixes neighbours, so that no border is seen.",
             {{"levels", "on"}, {"pattern", "bricks"}}},
            {"texels",
             "The nearest texel, magnified: squares.",
             {{"filter", "nearest"}, {"texture-size", "16"}, {"pattern", "bricks"}, {"pixel-y", "0.2"}}},
            {"too-dark",
             "Averaged as it is kept, a checker of black and white gets too dark: 128 of 255 instead of 188.",
             {{"average", "encoded"}}},
        },
};

const bool added = addDemo<TextureFilterDemo, declaration>();

}  // namespace

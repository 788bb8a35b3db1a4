// The settings of texture-filter: rows, presets, controls and declaration.
#include "mv/demo/lesson.h"
#include "mv/gl/beyond_es.h"
#include "texture-filter.h"

namespace mv::texture_filter {
namespace {

constexpr WordList filterWords{{"nearest", "the texel at the middle of the pixel"},
                               {"bilinear", "four texels, weighted"},
                               {"nearest-mip-nearest", "one texel of the nearest level"},
                               {"linear-mip-nearest", "four texels of the nearest level"},
                               {"trilinear", "four texels of both levels around"},
                               {"anisotropic", "several such looks along the footprint"}};

}  // namespace

const char* nameOf(Filter filter) { return wordOf(filterWords, filter); }

namespace {

bool isAnisotropic(const Settings& s) { return s.filter == Filter::anisotropic; }
bool hasPattern(const Settings& s) { return !s.picture.isSet(); }
bool isPlain(const Settings& s) { return !s.showLevels; }

std::vector<Row<Settings>> panelRows() {
    return {
        word("filter", &Settings::filter, filterWords, "how a pixel's colour is looked up"),
        whole("anisotropy", &Settings::anisotropy, {1, 16},
              "the most looks along the footprint; llvmpipe heeds only 1 or more")
            .when(isAnisotropic, "the filter looks once, or four times"),
        number("bias", &Settings::bias, {-4, 4}, "added to the level")
            .when(isMipmapped, "the filter knows a single level"),
        word("pattern", &Settings::pattern, {{"checker"}, {"stripes"}, {"bricks"}}, "what is on the floor")
            .when(hasPattern, "your picture is on the floor"),
        oneOf("texture-size", &Settings::size, {1, 5, 16, 64, 100, 256}, "texels along a side of the texture"),
        angle("turn", &Settings::turn, "of the pattern on the floor"),
        word("average", &Settings::average,
             {{"linear", "of light"}, {"encoded", "of the numbers kept in sRGB, which is wrong"}},
             "what is averaged, in mipmaps and by the filter"),
        word("texels", &Settings::texels,
             {{"float", "32 bits a channel"}, {"8-bit", "llvmpipe filters in 8 bits then, too"}},
             "how a texel is kept"),
        word("mipmaps", &Settings::mipmapsBy, {{"program"}, {"driver", "glGenerateMipmap"}}, "who makes the levels")
            .when(isMipmapped, "the filter knows a single level")
            .when(isPlain, "the program makes those that are coloured"),
        toggle("levels", &Settings::showLevels, "show each level in a colour of its own")
            .when(isMipmapped, "the filter knows a single level"),
        file("picture", &Settings::picture, "assets/tiles.png", "your own on the floor, in as many texels"),
        number("pixel-x", &Settings::pixelX, {0, 1}, "the pixel whose footprint is drawn: part of the floor's width"),
        number("pixel-y", &Settings::pixelY, {0, 0.99}, "the same of the way up to the horizon")};
}

constexpr Declaration about{
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
};

// Look once a pixel without an anisotropic filter, and make mipmaps of floats here where the driver does not draw into
// floats.
Settings fallback(Settings s) {
    const bool looksAlong = s.filter == Filter::anisotropic && s.anisotropy > 1;
    if (looksAlong && !has(beyond_es::anisotropicFiltering)) s.anisotropy = 1;
    if (isByDriver(s) && s.texels == Kept::floats && !has(beyond_es::floatTargets)) s.mipmapsBy = MadeBy::program;
    return s;
}

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"trilinear", "Near the horizon trilinear is grey long before the squares are smaller than pixels."},
        {"nearest",
         "One texel a pixel: far away it is chance which one, in patterns that are not there.",
         {.filter = Filter::nearest}},
        {"anisotropic", "Looks along the footprint: the squares reach much farther.", {.filter = Filter::anisotropic}},
        {"levels",
         "Each level in its colour; trilinear mixes neighbours, so that no border is seen.",
         {.pattern = FloorPattern::bricks, .showLevels = true}},
        {"texels",
         "The nearest texel, magnified: squares.",
         {.filter = Filter::nearest, .pattern = FloorPattern::bricks, .size = 16, .pixelY = 0.2}},
        {"too-dark",
         "Averaged as it is kept, a checker of black and white gets too dark: 128 of 255 instead of 188.",
         {.average = Average::encoded}},
    };
}

std::optional<vec2> placeOfPixel(const Settings& s, const FrameInfo& frame) { return pixelShown(s, frame); }

const bool added =
    addLesson(about, Lesson<Settings, Gpu>{
                         .rows = panelRows(),
                         .presets = presets(),
                         .handles = {{"pixel", {"pixel-x", "pixel-y"}, placeOfPixel}},
                         .readouts = {{"level", "the level of that pixel's footprint, as OpenGL's formula has it"},
                                      {"longer", "the footprint's longer axis", "texels"},
                                      {"shorter", "the other one", "texels"},
                                      {"levels-made", "levels of the texture, each a picture of its own"}},
                         .draw = draw,
                         .figure = drawFigure,
                         .readOut = readOut,
                         .fallback = fallback,
                     });

}  // namespace
}  // namespace mv::texture_filter

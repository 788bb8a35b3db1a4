// The readouts of texture-filter, and its study: its floor against the mean of each pixel's part of the texture.
#include <functional>
#include <string>
#include <vector>

#include "floor_mean.h"
#include "mv/demo/cached.h"
#include "mv/demo/lesson.h"
#include "shared/seen_pixels.h"
#include "texture-filter.h"

namespace mv::texture_filter {

using namespace claims;

void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers) {
    if (frame.measuring()) return;
    const Lookup lookup = lookupAt(s, frame);
    numbers.set("level", lookup.level);
    numbers.set("longer", lookup.longer);
    numbers.set("shorter", lookup.shorter);
    numbers.set("levels-made", gpu.image->levels());
}

namespace {

constexpr int side = 32;  // points along each side of a pixel

Reference areaMean(const Demo& demo, const ReferenceFrame& frame, const std::function<void(double)>& progress) {
    const FloorMean floor(settingsOf<Settings>(demo), frame);
    Reference reference{.values = floor.picture(side, progress)};
    reference.regions = regionsOfSeen(reference.values);
    if (frame.ownError)
        reference.ownError = rmsBetween(reference.values, floor.picture(2 * side, progress)).value_or(0);
    reference.work = double(side) * side * double(reference.values.size());
    return reference;
}

// The error of the picture that is shown, in fewer pixels.
std::vector<double> errorNow(Probing& probing) {
    constexpr int width = 160, height = 120;
    const std::vector<float> shown = probing.measured(width, height);
    if (shown.empty()) return {};
    const FloorMean floor(settingsOf<Settings>(probing.demo()), {probing.frame().index(), width, height});
    // Kept while the floor rests: how its texture is looked up changes nothing of it.
    static Cached<std::vector<double>, FloorMean> kept;
    return rmsOfShown(shown, kept.of({floor}, [](const FloorMean& one) { return one.picture(16, {}); }));
}

Study study() {
    Study study;
    study.quantity = "luminance of the floor 2 to 100 heights of the eye away, in linear light, 0..1";
    study.reference = "the mean of 1024 points of each pixel's part of the texture, in double precision";
    study.makeReference = areaMean;
    study.reads = {"pattern", "texture-size", "turn", "picture"};
    study.scenes = {{"checker", {{"pattern", "checker"}, {"turn", "20"}}},
                    {"bricks", {{"pattern", "bricks"}, {"turn", "20"}}}};
    study.lines = {{"nearest", {{"filter", "nearest"}}},
                   {"bilinear", {{"filter", "bilinear"}}},
                   {"nearest-mip-nearest", {{"filter", "nearest-mip-nearest"}}},
                   {"linear-mip-nearest", {{"filter", "linear-mip-nearest"}}},
                   {"trilinear", {{"filter", "trilinear"}}, "bias", {"-2", "-1", "-0.5", "0", "0.5", "1"}},
                   {"anisotropic", {{"filter", "anisotropic"}}, "anisotropy", {"2", "16"}},
                   {"trilinear, 8 bits", {{"filter", "trilinear"}, {"texels", "8-bit"}}},
                   {"trilinear, averaged as kept", {{"filter", "trilinear"}, {"average", "encoded"}}},
                   {"trilinear, driver's levels", {{"filter", "trilinear"}, {"mipmaps", "driver"}}}};
    study.wrongBeyond = 0.05;
    study.width = 160;
    study.height = 120;
    const auto trilinear = rows("trilinear").at(0), anisotropic = rows("anisotropic");
    study.says = {
        claim("mipmaps", "Trilinear leaves less than six tenths of the error of the nearest texel.",
              {ratio(of::rms, trilinear, rows("nearest"), 0, 0.6)}),
        claim("along-the-footprint", "Looks along the footprint leave less than seven tenths of what trilinear leaves.",
              {ratio(of::rms, anisotropic, trilinear, 0, 0.7)}),
        claim("half-a-level-sharper",
              "Trilinear is nearer to the mean of the area half a level finer, and farther a level coarser.",
              {ratio(of::rms, rows("trilinear").at(-0.5), trilinear, 0, 0.95),
               ratio(of::rms, rows("trilinear").at(1), trilinear, 1.2, 5)}),
        claim("light", "Averages of what is kept in sRGB instead of light make a checker's error half as large again.",
              {ratio(of::rms, rows("trilinear, averaged as kept").in("checker"), trilinear, 1.5, 10)}),
        claim("eight-bit-floor",
              "That llvmpipe filters 8-bit texels in 8 bits does not show beside the error of trilinear: within 1 %.",
              {ratio(of::rms, rows("trilinear, 8 bits"), trilinear, 0.99, 1.01)}),
        claim("one-limit", "Drawn on a processor (llvmpipe), a limit of 2 looks makes the same as one of 16.",
              {settled(of::rms, anisotropic, 1.0001)}),
        claim("more-looks", "On this GPU 16 looks are wrong by at most half of what 2 are wrong by.",
              {ratio(of::rms, anisotropic.at(16), anisotropic.at(2), 0, 0.5)}),
        claim("looks-are-slow",
              "On a processor looks along the footprint take 20 times as long as trilinear ones at least.",
              {ratio(of::time, anisotropic, rows("trilinear").at(0), 20, HUGE_VAL)}),
        claim("looks-are-fast", "On this GPU they take at most twice as long.",
              {ratio(of::time, anisotropic, rows("trilinear").at(0), 1, 2)}),
        note("Megapixels a second are 0.0192 divided by the seconds of a row: the picture has 160 x 120 pixels.")};
    return study;
}

const bool studied = addStudy("texture-filter", study());
const bool probed = addProbes("texture-filter", {{{{"rms-error",
                                                    "root mean square error of the luminance of the floor 2 to 100 "
                                                    "heights of the eye away, 0..1, in 160 x 120 pixels"}},
                                                  errorNow}});

}  // namespace
}  // namespace mv::texture_filter

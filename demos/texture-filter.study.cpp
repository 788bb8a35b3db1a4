// What measures texture-filter: its floor against the mean of each pixel's part of the texture.
#include <cmath>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "shared/floor_texture.h"

using namespace mv;
using namespace mv::claims;

namespace {

FloorPattern patternOf(const Demo& demo) {
    const std::string word = demo.word("pattern");
    return word == "bricks" ? FloorPattern::bricks : word == "stripes" ? FloorPattern::stripes : FloorPattern::checker;
}

// The texels' luminance, and the mean of them over the part of the floor that each pixel covers: the texture is a picture
// of flat squares, and a pixel the mean of its area.
class FloorMean {
  public:
    FloorMean(const Demo& demo, const FrameInfo& frame)
        : size_(static_cast<int>(demo.number("texture-size"))),
          width_(frame.width()),
          height_(frame.height()),
          repeats_(repeatsFromPixel(frame.width(), frame.height(), demo.number("turn"))) {
        const FloatPicture pattern = floorPattern(patternOf(demo), size_);
        for (std::size_t i = 0; i < pattern.values.size(); i += 4) light_.push_back(luminance(&pattern.values[i]));
    }

    // Pixels that are compared: wholly on the floor and nearer than 200 of its height, and minified: along one axis at
    // least a texel. Magnified ones are a matter of taste, squares or ramps.
    bool counts(int x, int y) const {
        if ((repeats_ * vec3(x + 0.5, y + 2.0, 1)).z <= 0) return false;
        const Footprint print = footprintOf(repeats_, {x + 0.5, y + 0.5});
        return glm::length(print.middle) < 200 &&
               size_ * std::max(glm::length(print.acrossX), glm::length(print.acrossY)) >= 1;
    }

    // `side` x `side` points: a row each in y, moved along x by the golden ratio, so that no two have the same x.
    double mean(int x, int y, int side) const {
        constexpr double golden = 0.6180339887498949;
        const int points = side * side;
        double sum = 0;
        for (int i = 0; i < points; ++i) {
            const double across = i * golden - std::floor(i * golden);
            const vec3 at = repeats_ * vec3(x + across, y + (i + 0.5) / points, 1);
            sum += light_[texelOf(at.y / at.z) * static_cast<std::size_t>(size_) + texelOf(at.x / at.z)];
        }
        return sum / points;
    }

    std::vector<double> picture(int side, const std::function<void(double)>& progress) const {
        std::vector<double> means;
        for (int y = height_ - 1; y >= 0; --y) {
            for (int x = 0; x < width_; ++x) means.push_back(counts(x, y) ? mean(x, y, side) : -1);
            if (progress) progress(1 - double(y) / height_);
        }
        return means;
    }

  private:
    std::size_t texelOf(double repeats) const {
        return static_cast<std::size_t>(std::min(size_ - 1.0, std::floor((repeats - std::floor(repeats)) * size_)));
    }

    int size_, width_, height_;
    mat3 repeats_;
    std::vector<double> light_;
};

constexpr int side = 32;  // points along each side of a pixel

double rmsBetween(const std::vector<double>& a, const std::vector<double>& b) {
    double squares = 0, n = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i] < 0 || b[i] < 0) continue;
        squares += (a[i] - b[i]) * (a[i] - b[i]);
        ++n;
    }
    return n > 0 ? std::sqrt(squares / n) : 0;
}

Reference areaMean(const Demo& demo, const ReferenceFrame& frame, const std::function<void(double)>& progress) {
    const FloorMean floor(demo, frame);
    Reference reference{.values = floor.picture(side, progress)};
    for (const double value : reference.values) reference.regions.push_back(value < 0 ? -1 : 0);
    if (frame.ownError) reference.ownError = rmsBetween(reference.values, floor.picture(2 * side, progress));
    reference.work = double(side) * side * double(reference.values.size());
    return reference;
}

// Of the picture that is shown, in fewer pixels.
std::vector<double> errorNow(Probing& probing) {
    constexpr int width = 160, height = 120;
    const std::vector<float> shown = probing.measured(width, height);
    if (shown.empty()) return {};
    const FloorMean floor(probing.demo(), {probing.frame().index(), width, height});
    return {rmsBetween({shown.begin(), shown.end()}, floor.picture(16, {}))};
}

Study study() {
    Study study;
    study.quantity = "luminance of the pixels that cover a texel or more, in linear light, 0..1";
    study.reference = "the mean of 1024 points of each pixel's part of the texture, in double precision";
    study.makeReference = areaMean;
    study.scenes = {{"checker", {{"pattern", "checker"}, {"turn", "20"}}},
                    {"bricks", {{"pattern", "bricks"}, {"turn", "20"}}}};
    study.lines = {{"nearest", {{"filter", "nearest"}}},
                   {"bilinear", {{"filter", "bilinear"}}},
                   {"nearest-mip-nearest", {{"filter", "nearest-mip-nearest"}}},
                   {"linear-mip-nearest", {{"filter", "linear-mip-nearest"}}},
                   {"trilinear", {{"filter", "trilinear"}}, "bias", {"-2", "-1", "-0.5", "0", "0.5", "1"}},
                   {"anisotropic", {{"filter", "anisotropic"}}, "anisotropy", {"2", "4", "8", "16"}},
                   {"trilinear, 8 bits", {{"filter", "trilinear"}, {"texels", "8-bit"}}},
                   {"anisotropic 16, 8 bits", {{"filter", "anisotropic"}, {"texels", "8-bit"}}},
                   {"trilinear, averaged as kept", {{"filter", "trilinear"}, {"average", "encoded"}}},
                   {"trilinear, driver's levels", {{"filter", "trilinear"}, {"mipmaps", "driver"}}}};
    study.wrongBeyond = 0.05;
    study.width = 320;
    study.height = 240;
    return study;
}

const bool studied = addStudy("texture-filter", study());
const bool probed = addProbes(
    "texture-filter",
    {{{{"rms-error", "root mean square error of the minified floor's luminance in linear light, in 160 x 120 pixels"}},
      errorNow}});

}  // namespace

// The texels' luminance, and the mean of them over the part of the floor that each pixel covers: the texture is a picture of
// flat squares, and a pixel the mean of its area.
#pragma once
#include <cstddef>
#include <functional>
#include <vector>

#include "mv/demo/frame.h"
#include "texture-filter.h"

namespace mv::texture_filter {

class FloorMean {
  public:
    FloorMean(const Settings& s, const FrameInfo& frame);

    // Pixels that are compared, as the shader counts them: from 2 to 100 heights of the eye away. Nearer ones may be
    // magnified, and whether that is to show squares or ramps is a matter of taste.
    bool counts(int x, int y) const;

    // `side` x `side` points: a row each in y, moved along x by the golden ratio, so that no two have the same x.
    double mean(int x, int y, int side) const;

    // Of all pixels, the upper row first; -1 where a pixel does not count.
    std::vector<double> picture(int side, const std::function<void(double)>& progress) const;

    bool operator==(const FloorMean&) const = default;

  private:
    std::size_t texelOf(double repeats) const;

    int size_, width_, height_;
    mat3 repeats_;
    std::vector<double> light_;
};

}  // namespace mv::texture_filter

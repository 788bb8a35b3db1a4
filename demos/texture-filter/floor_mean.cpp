#include "floor_mean.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "shared/own_picture.h"

namespace mv::texture_filter {

FloorMean::FloorMean(const Settings& s, const FrameInfo& frame)
    : size_(s.size),
      width_(frame.width()),
      height_(frame.height()),
      repeats_(repeatsFromPixel(frame.width(), frame.height(), s.turn)) {
    const FloatPicture pattern =
        s.picture.isSet() ? ownTexels(*s.picture.content(), size_, size_) : floorPattern(s.pattern, size_);
    for (std::size_t i = 0; i < pattern.values.size(); i += 4) light_.push_back(luminance(&pattern.values[i]));
}

bool FloorMean::counts(int x, int y) const {
    const vec3 at = repeats_ * vec3(x + 0.5, y + 0.5, 1);
    const double away = glm::length(vec2(at) / at.z);
    return at.z > 0 && away > 2 && away < 100;
}

double FloorMean::mean(int x, int y, int side) const {
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

std::vector<double> FloorMean::picture(int side, const std::function<void(double)>& progress) const {
    std::vector<double> means;
    for (int y = height_ - 1; y >= 0; --y) {
        for (int x = 0; x < width_; ++x) means.push_back(counts(x, y) ? mean(x, y, side) : -1);
        if (progress) progress(1 - double(y) / height_);
    }
    return means;
}

std::size_t FloorMean::texelOf(double repeats) const {
    return static_cast<std::size_t>(std::min(size_ - 1.0, std::floor((repeats - std::floor(repeats)) * size_)));
}

}  // namespace mv::texture_filter

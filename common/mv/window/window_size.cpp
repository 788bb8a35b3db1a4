#include "mv/window/window_size.h"

#include <cmath>
#include <iostream>

#include "mv/error.h"

namespace mv {
namespace {

constexpr double least = 0.5, most = 8;

// How many pixels so many window coordinates have: as many as told, where their ratio is one to believe.
int believedPixels(int units, int pixels, Believed& perUnit) {
    if (units < 1 || pixels < 1) return pixels;  // a window without extent has no ratio; it keeps the one it had
    const double told = double(pixels) / units;
    perUnit.set(told);
    return perUnit.value() == told ? pixels : static_cast<int>(std::lround(units * perUnit.value()));
}

}  // namespace

void Believed::set(double told) {
    if (told >= least && told <= most) {
        value_ = refused_ = told;
    } else if (!(told == refused_)) {
        refused_ = told;
        const Error error(subject_, "must be " + numberText(least) + " .. " + numberText(most), numberText(told));
        std::cerr << "window: " << error.what() << "; " << numberText(value_) << " is taken" << std::endl;
    }
}

void WindowSize::take() {
    taken_ = told_;
    taken_.pixelWidth = believedPixels(taken_.width, taken_.pixelWidth, across_);
    taken_.pixelHeight = believedPixels(taken_.height, taken_.pixelHeight, down_);
}

}  // namespace mv

// The readouts of cube-persp.
#include <algorithm>
#include <cmath>

#include "cube-persp.h"

namespace mv::cube_persp {

static double largestDifference(const mat4& a, const mat4& b) {
    double most = 0;
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) most = std::max(most, std::abs(a[column][row] - b[column][row]));
    }
    return most;
}

void readOut(Gpu&, const Settings& s, const Frame&, Numbers& numbers) {
    const FrustumBounds window = nearWindow(s);
    numbers.set("left", window.left);
    numbers.set("right", window.right);
    numbers.set("bottom", window.bottom);
    numbers.set("top", window.top);
    numbers.set("fovx", degrees(std::atan(window.right / s.near) - std::atan(window.left / s.near)));
    numbers.set("difference", largestDifference(frustum(window), clipFromView(s)));
    // Depth in the buffer is f/(f-n) (1 - n/d) at the distance d, of slope f n/((f-n) d d); a step is 2^-24 of it.
    const double d = 2, slope = s.far * s.near / ((s.far - s.near) * d * d);
    numbers.set("depth-step", std::ldexp(1 / slope, -24));
}

}  // namespace mv::cube_persp

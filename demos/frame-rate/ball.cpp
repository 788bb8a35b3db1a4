// The ball of frame-rate, as a function of the time since it was thrown: the slide's, and one that falls.
#include <cmath>

#include "frame-rate.h"

namespace mv::frame_rate {

double ballHeight(Ball ball, double t) { return ball == Ball::asWritten ? slidesHeight(t) : fallingHeight(t); }

// A sine, mirrored at the floor, that fades: it comes down at even times.
double slidesHeight(double t) { return std::abs(std::sin(4 * t + 0.6)) * std::exp(-0.35 * t); }

// Free fall between bounces. Each flight lasts the part `kept` of the one before, so that the bounces come closer together,
// to an end: the sum of all flights is first / (1 - kept).
double fallingHeight(double t) {
    constexpr double first = 1.2, kept = 0.75;       // seconds
    const double left = 1 - t * (1 - kept) / first;  // kept^n where flight n begins
    if (left <= 0) return 0;
    const double length = std::pow(kept, std::floor(std::log(left) / std::log(kept)));  // the first's is 1
    const double part = (length - left) / (length * (1 - kept));                        // of the flight, 0..1
    return length * length * 4 * part * (1 - part);
}

}  // namespace mv::frame_rate

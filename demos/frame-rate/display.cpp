// The simulated display of frame-rate. The display shows a picture at the first refresh at which the picture is ready.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "frame-rate.h"

namespace mv::frame_rate {
namespace {

// A number from 0 to 1 that looks random, the same for the same n. Source: Steele, Lea, Flood, SplitMix (2014).
double scattered(long n) {
    auto z = static_cast<std::uint64_t>(n) * 0x9E3779B97F4A7C15U;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

// One picture in two seconds has a hiccup.
bool isInNewPair(const Settings& s, const Running& now) {
    return std::floor(now.shownAt / 2) != std::floor((now.shownAt - 1 / hertz(s)) / 2);
}

// The number of refreshes that a picture takes which is made in this many steps.
long refreshesFor(int steps, const Settings& s, const Running& now) {
    double milliseconds = s.load + steps * s.stepLoad + s.jitter * scattered(now.pictures);
    if (isInNewPair(s, now)) milliseconds += s.hiccup;
    return std::max(1L, static_cast<long>(std::ceil(milliseconds / 1000 * hertz(s))));
}

// Some hundred numbers are kept. When there are too many, every second one goes.
void keepOff(Running& now, const Settings& s) {
    constexpr std::size_t most = 512;
    if (!now.offs.empty() && now.shownAt < now.offs.back().at + now.spread) return;
    now.offs.push_back({now.shownAt, times(s, now)[0] - now.shownAt});
    if (now.offs.size() <= most) return;
    for (std::size_t i = 0; 2 * i < now.offs.size(); ++i) now.offs[i] = now.offs[2 * i];
    now.offs.resize((now.offs.size() + 1) / 2);
    now.spread *= 2;
}

void showUntil(Running& now, const Settings& s, double time) {
    while (double(now.refreshes + now.waiting) / hertz(s) <= time) {
        const double before = now.shownAt;
        now.refreshes += now.waiting;
        now.shownAt = double(now.refreshes) / hertz(s);
        ++now.pictures;
        const int steps = move(now.moved, s, now.shownAt - before);
        now.waiting = refreshesFor(steps, s, now);
        keepOff(now, s);
        now.last.push_back({now.shownAt, double(now.waiting) / hertz(s), steps});
        if (now.last.size() > 1000) now.last.erase(now.last.begin(), now.last.begin() + 500);
    }
}

}  // namespace

Running start(const Settings& s) {
    Running now;
    if (s.beside == Beside::displays) now.others.resize(besideEachOther.size());
    step(now, s, 0);
    return now;
}
void step(Running& now, const Settings& s, int index) {
    const double until = s.hours * 3600 + index / 60.0;
    showUntil(now, s, until);
    for (std::size_t i = 0; i < now.others.size(); ++i) showUntil(now.others[i], onDisplay(s, i), until);
}
Settings onDisplay(const Settings& s, std::size_t other) {
    Settings there = s;
    there.display = besideEachOther.at(other);
    return there;
}

double hertz(const Settings& s) {
    constexpr std::array<double, 4> rates{60, 60'000 / 1001.0, 144, 240};
    return rates.at(static_cast<std::size_t>(s.display));
}

}  // namespace mv::frame_rate

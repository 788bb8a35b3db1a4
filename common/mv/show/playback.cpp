#include "mv/show/playback.h"

#include <cmath>
#include <limits>

namespace mv {

Playback::Playback(bool animated, int first, bool paused)
    : animated_(animated), playing_(animated && !paused), frame_(first) {}

bool Playback::advance(double seconds) {
    if (!playing_) return false;
    part_ += seconds * 60 * speed_;
    const double whole = std::floor(part_);
    if (whole < 1) return false;
    part_ -= whole;
    if (whole > double(std::numeric_limits<int>::max() - frame_)) {  // the last number there is
        playing_ = false;
        return false;
    }
    frame_ += static_cast<int>(whole);
    return true;
}

void Playback::step() { goTo(frame_ < std::numeric_limits<int>::max() ? frame_ + 1 : frame_); }

void Playback::goTo(int frame) {
    playing_ = false;
    part_ = 0;
    if (animated_) frame_ = frame;
}

void Playback::restart() {
    frame_ = 1;
    part_ = 0;
}

}  // namespace mv

// Which frame is shown: elapsed time turned into a frame number.
#pragma once

namespace mv {

// Frame numbers advance by 60 a second of real time, times the speed: a fast screen does not run fast, and a slow one
// leaves frames out.
class Playback {
  public:
    // A demo that is not animated, as framesDiffer() has it, stands still for ever.
    Playback(bool animated, int first, bool paused);

    bool animated() const { return animated_; }
    bool playing() const { return playing_; }
    int frame() const { return frame_; }
    double speed() const { return speed_; }

    // Lets so many seconds pass; true when that leads to another frame.
    bool advance(double seconds);
    void toggle() { playing_ = animated_ && !playing_; }
    // One frame further, and paused there.
    void step();
    // Goes to that frame, and pauses there.
    void goTo(int frame);
    // Back to frame 1, the first picture of an original.
    void restart();
    // Slower or faster; 0.1 .. 4.
    void setSpeed(double speed) { speed_ = speed; }

  private:
    bool animated_, playing_;
    int frame_;
    double part_ = 0;  // of a frame that has passed already
    double speed_ = 1;
};

}  // namespace mv

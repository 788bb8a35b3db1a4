// How large the window is: in window coordinates, which the mouse and the widgets count in, and in pixels.
#pragma once
#include <string>

namespace mv {

// A ratio that the window system tells: of a screen's density, or of pixels to window coordinates. No screen is beyond
// 0.5 .. 8 (a wall of 8K panels wants 4); what is, as the 0 of a server that knows no density, would scale every widget to
// nothing. Such a value is not believed: the last good one stays, and a line on standard error says so.
class Believed {
  public:
    // `subject` is what that line is about.
    explicit Believed(std::string subject) : subject_(std::move(subject)) {}
    void set(double told);
    // 1 until something believable was told.
    double value() const { return value_; }

  private:
    std::string subject_;
    double value_ = 1;
    double refused_ = 1;  // what the line was written for last: not for every frame once more
};

// Both sizes are told one after the other, and taken together: a frame never sees the one without the other.
class WindowSize {
  public:
    // The sizes that the window system tells: the inner size in window coordinates, and that of the framebuffer in
    // pixels.
    void setUnits(int width, int height) { told_.width = width, told_.height = height; }
    void setPixels(int width, int height) { told_.pixelWidth = width, told_.pixelHeight = height; }
    // Begins a frame with what was told last.
    void take();

    // The sizes of the frame: window coordinates, and pixels.
    int width() const { return taken_.width; }
    int height() const { return taken_.height; }
    int pixelWidth() const { return taken_.pixelWidth; }
    int pixelHeight() const { return taken_.pixelHeight; }
    // Pixels for each window coordinate: 1, except where the window system scales (Wayland). Across it is the measure of
    // all lengths; downwards a pixel's rounding may make it another.
    double pixelsPerUnit() const { return across_.value(); }
    double pixelsPerUnitDown() const { return down_.value(); }

  private:
    struct Sizes {
        int width = 0, height = 0, pixelWidth = 0, pixelHeight = 0;
    };
    Sizes told_, taken_;
    Believed across_{"pixels for each window coordinate across"}, down_{"pixels for each window coordinate downwards"};
};

}  // namespace mv

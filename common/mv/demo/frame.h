// Facts for a demo about the picture that it draws, and what the demo may tell back.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mv/math/types.h"

namespace mv {

// The notes that draw() left for the panel and the report, beside the picture.
struct FrameNotes {
    std::vector<std::pair<std::string, mat4>> matrices;
    std::vector<std::string> messages;
    std::vector<std::pair<std::string, double>> counts;
    std::vector<std::string> needless;
};

// The camera of a picture.
struct Camera {
    mat4 viewFromWorld{1}, clipFromView{1};
};

// How a frame is drawn, besides its number and size.
struct FrameMode {
    bool readouts = false;
    bool measuring = false;
    std::optional<Camera> camera = {};
    std::function<void()> bindTarget = {};
};

// A part of the picture that shows a view of its own. In pixels from the lower left corner, as glViewport and glScissor
// count.
struct Pane {
    int x, y, width, height;
    double aspect() const { return double(width) / height; }
};

// Which picture it is: its number and its size in pixels. The facts that a scene, a reference or words in a picture
// need.
class FrameInfo {
  public:
    // Of so many pixels; `unit`: how many of them a figure's unit has.
    FrameInfo(int index, int width, int height, double unit = 1)
        : index_(index), width_(width), height_(height), pixelWidth_(width), pixelHeight_(height), unit_(unit) {}

    // Frame n is the original's picture after n of its steps; the first picture of an original is frame 1.
    int index() const { return index_; }
    // Seconds, index/60: never a clock, so frame n is the same picture in a window, headless and in a test.
    double time() const { return index_ / 60.0; }
    int width() const { return width_; }
    int height() const { return height_; }
    double aspect() const { return double(pixelWidth_) / pixelHeight_; }

    // Whether it is higher than wide: what stands beside a scene in a wide picture then stands below it.
    bool isUpright() const { return pixelHeight_ > pixelWidth_; }

    // The same picture measured in a figure's units, in which words, lines and the room between them have one size, however
    // many pixels the picture has: what figure() and a handle's `where` get, and Drawing and drawText take. width() and
    // height() are whole ones, and so one across is not quite one up. In the size that the demo declares, a unit is a pixel.
    FrameInfo inUnits() const;
    // And in pixels again, which OpenGL counts.
    FrameInfo inPixels() const { return {index_, pixelWidth_, pixelHeight_, unit_}; }
    // Pixels for one of what width() and height() count; and for one of the size of words and lines: a unit, or 1.
    vec2 scale() const { return {double(pixelWidth_) / width_, double(pixelHeight_) / height_}; }
    double sizeScale() const { return inUnits_ ? unit_ : 1; }
    // A pane of this frame in pixels, for glViewport and glScissor.
    Pane pixels(const Pane& pane) const;
    // A pane of inUnits() in what this frame counts: where its place depends on the room that words need, draw() and figure()
    // both ask so.
    Pane fromUnits(const Pane& pane) const { return inUnits_ ? pane : inUnits().pixels(pane); }
    // The picture divided into panes of one size, row by row from the upper left, in as many columns as rows or one more.
    // Between them, and where the division leaves a rest, there is a line of single pixels that belongs to none. In a
    // picture too small for that a pane has 1 pixel a side and may lie outside. Refused: a count below 1.
    std::vector<Pane> panes(int count) const;

  private:
    int index_, width_, height_;
    int pixelWidth_, pixelHeight_;
    double unit_;
    bool inUnits_ = false;
};

// How many pixels a figure's unit has in a picture of that size, of a demo that declares the other: as many times more as
// the picture is larger, and no fewer than words need that are to be read on a screen of that density (pixels for each of
// an ordinary screen's, 1 or more).
double figureUnit(int width, int height, int declaredWidth, int declaredHeight, double density = 1);

// A picture while it is drawn; the viewport covers all of it.
class Frame : public FrameInfo {
  public:
    Frame(const FrameInfo& info, FrameNotes& notes, FrameMode mode)
        : FrameInfo(info), mode_(std::move(mode)), notes_(&notes) {}
    Frame inUnits() const { return {FrameInfo::inUnits(), *notes_, mode_}; }

    // Whether anybody reads the readouts of this frame. One that costs draws of its own (a count of triangles, say) is
    // left out where nobody does; the picture is the same either way.
    bool readouts() const { return mode_.readouts; }
    // Whether a study asks for its quantity instead of a picture. The target then has one float a pixel (R32F): clear it
    // to -1, where nothing is compared, and write the quantity (the lit fraction, say) in red where it is.
    bool measuring() const { return mode_.measuring; }
    // The camera that a probe looks through; none: the demo's own. seen() heeds it (mv/demo/seen.h).
    const std::optional<Camera>& camera() const { return mode_.camera; }
    // Draws go into the picture again, all of it, after a demo has drawn into a target of its own.
    void bindTarget() const { mode_.bindTarget(); }

    // Shows a matrix as a live table, under its name in the form aFromB.
    void show(std::string_view name, const mat4& matrix) const;
    // One sentence that the user must see beside this picture (a shadow that cannot be, say).
    void say(std::string message) const;
    // Work done in this frame that the framework does not count itself: taps, rays, lights. Shown by --report, and beside
    // the errors of a study, since it does not depend on the machine.
    void count(std::string_view name, double amount) const;
    // Work in this frame that only the demo knows to be needless, for --audit; in words ("light 5, which is off").
    void needless(std::string what) const;

  private:
    FrameMode mode_;
    FrameNotes* notes_;
};

}  // namespace mv

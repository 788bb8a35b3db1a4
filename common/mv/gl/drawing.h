// Lines, shapes and words over a picture, in its panes: what a textbook's figure has beside the scene itself. Places and
// sizes are in a figure's units, whatever frame it is given: pixels in the size that the demo declares (FrameInfo::inUnits()).
// Edges are smooth over one pixel of the picture.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mv/demo/frame.h"
#include "mv/geometry/mesh_data.h"
#include "mv/geometry/plot.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"
#include "mv/gl/text.h"

namespace mv {

struct Stroke {
    vec4 color{0.1, 0.1, 0.1, 1};
    double width = 1.5;  // px; edges are smooth (mv/geometry/strokes.h)
};

// A member of a lesson's Gpu. Shapes are collected, and drawn together by one call of draw(), words on top of them. What has
// not changed since the last draw() is not uploaded again.
//     drawing.begin(frame);                              // first: what was collected before is forgotten
//     drawing.in(pane);                                  // only where a picture has panes; before the shapes of the pane
//     drawing.arrow({20, 20}, {60, 20}, {.color = red});
//     drawing.draw(frame);                               // last, and in a figure where only people need it
class Drawing {
  public:
    // Nothing is collected yet; the pane is the whole picture.
    void begin(const Frame& frame);
    // What follows is in this pane of frame.inUnits(), x and y in units from its lower left corner; what is beyond its edges
    // is cut off, but for words.
    void in(const Pane& pane);

    void line(std::span<const vec2> points, const Stroke& stroke = {});
    void line(const vec2& from, const vec2& to, const Stroke& stroke = {});
    // The tip is at `to`.
    void arrow(const vec2& from, const vec2& to, const Stroke& stroke = {});
    void fill(const Box& box, const vec4& color);
    // A disc, `size` pixels across.
    void point(const vec2& at, double size, const vec4& color);
    // The same where the pane's projection draws a point in space, whatever is before it; nothing at or behind the eye.
    void point(const mat4& clipFromModel, const vec3& at, double size, const vec4& color);
    // Words whose box has its upper left corner there, smaller, down to leastWords (word_size.h), where they would end beyond
    // the pane's right edge. Or words at a point in space, moved so far in units from where it is drawn, or whose middle is
    // there: these keep their size. Of all words draw() leaves out what the picture's edge would cut off, and what would lie
    // over words of an earlier call: a small picture has its shapes, and the words that fit.
    void text(const vec2& upperLeft, const std::string& words, const TextStyle& style = {});
    void text(const mat4& clipFromModel, const vec3& at, const vec2& moved, const std::string& words,
              const TextStyle& style = {});
    void textAround(const vec2& middle, const std::string& words, const TextStyle& style = {});

    // A straight line in space, through the pane's projection: cut at near and far, and hidden by what was drawn before
    // it and is nearer. It writes no depth.
    void edge(const mat4& clipFromModel, const vec3& from, const vec3& to, const Stroke& stroke = {});

    // The frame of a plot, with a tick for each round number that has room, its number, and the names of its axes:
    // below it and to its left, for which 40 pixels are needed. Those that the pane has no room for are left out, and all of
    // them where the plot is lower or narrower than two lines of words.
    void axes(const Plot& plot, const Stroke& stroke = {});
    // A curve through those values, cut at the box of the plot.
    void curve(const Plot& plot, std::span<const vec2> values, const Stroke& stroke = {});
    // The borders of magnified pixels: a line at each whole number of both axes, and the box.
    void pixelGrid(const Plot& plot, const Stroke& stroke = {});

    // Draws all of it; the picture is the target, and the viewport covers it. The state is afterwards what it was before.
    void draw(const Frame& frame);

  private:
    Box whole() const { return {vec2(0), vec2(pane_.width, pane_.height)}; }
    std::optional<vec2> pixelOf(const mat4& clipFromModel, const vec3& at) const;  // of the pane
    // Moves what was appended from `first` on from the pane into the picture, cut to a box of the pane.
    void place(std::size_t first, const Box& box);
    void write(const vec2& upperLeft, const std::string& words, const TextStyle& style);
    void stroke(std::span<const vec3> points, const Stroke& stroke, const Box& box);

    // Places and sizes in pixels of the picture
    vec2 pixel(const vec2& at) const { return at * scale_; }
    std::vector<vec2> pixels(std::span<const vec2> places) const;

    int height_ = 0;  // of the picture, in units
    vec2 scale_{1};   // pixels a unit
    double sizeScale_ = 1;
    Pane pane_{};
    Painted painted_;  // in pixels
    std::vector<TextLine> words_;
    bool tested_ = false;  // whether any shape is hidden by what is nearer

    Program program_;
    MeshData uploaded_;
    Mesh mesh_;
};

}  // namespace mv

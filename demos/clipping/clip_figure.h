// The figure of lessons on clipping: a plane with a window on the left, the results in words on the right, or below it.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "clip_methods.h"
#include "mv/geometry/strokes.h"
#include "mv/gl/drawing.h"

namespace mv {

namespace clip {
inline const vec4 ink(0.1, 0.1, 0.1, 1), grey(0.55, 0.55, 0.55, 1), pale(0.93, 0.94, 0.96, 1), red(0.8, 0.15, 0.1, 1),
    blue(0.1, 0.35, 0.75, 1), green(0.1, 0.5, 0.2, 1), shade(0.82, 0.88, 0.96, 1);
// The part of the plane that the figure shows.
inline const Box plane{{-3, -2.8}, {3, 2.8}};
}  // namespace clip

class ClipFigure {
  public:
    // The left five eighths of the picture, or the upper ones of an upright picture, and the plane in them.
    static Pane leftPane(const FrameInfo& frame);
    static Plot plotIn(const Pane& pane);

    // `begin` comes first and forgets the last drawing, `draw` comes last and draws.
    void begin(const Frame& frame);
    void draw(const Frame& frame);

    // All places are in the plane.
    vec2 px(const vec2& at) const { return plot_.pixel(at); }
    void stroke(const vec2& a, const vec2& b, const Stroke& style) { drawing.line(px(a), px(b), style); }
    void point(const vec2& at, double size, const vec4& color) { drawing.point(px(at), size, color); }
    void outline(std::vector<vec2> corners, const Stroke& style);
    // Lines through the inside, counted half-open in y.
    void hatch(const std::vector<vec2>& corners, const vec4& color);
    // Words beside a place.
    void name(const vec2& at, const std::string& words, const vec4& color = clip::ink);
    // The window, its half planes' bounds, and the codes of the nine regions.
    void window(const Box& box);
    void codes(const Box& box);

    // One more line there.
    void say(const std::string& line, const vec4& color = clip::ink) { said_.emplace_back(line, color); }

    Drawing drawing;

  private:
    int lineHeight(double of) const;
    Plot plot_;
    std::vector<std::pair<std::string, vec4>> said_;
};

}  // namespace mv

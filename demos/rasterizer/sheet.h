// The sheet on which the parts of rasterizer are shown: two magnified pictures, the shape over them, and words below.
#pragma once
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "pixel_grid.h"
#include "rasterizer.h"

namespace mv::rasterizer {

inline const vec4 ink(0.1, 0.1, 0.1, 1), red(0.8, 0.15, 0.1, 1);
inline const Pixel paper{255, 255, 255}, outlined{90, 95, 105}, first{70, 125, 205}, second{120, 180, 110},
    both{205, 60, 45};

// The pixels.
struct Grid {
    int columns, rows, step;
    double scale;  // pixels a unit of the settings' coordinates
    explicit Grid(const Settings& s);
    // The pixel that a coordinate lies in.
    int whole(double coordinate) const;
    // The same grid with all its pixels set.
    Grid allSet() const;
    // The number of pixels that are set, of all these.
    std::size_t made(std::size_t all) const;
};

// The places of both pictures in the frame, and of the pixels in their panes.
Pane leftPane(const FrameInfo& frame);
Pane rightPane(const FrameInfo& frame);
Plot plotOf(const FrameInfo& frame, const Grid& grid);

Pixel pixelOf(const vec3& color);
vec3 colorOf(const Pixel& pixel);  // 0..1

// A picture of paper, with what was drawn before in grey; and pixels set on it, as many as the step says.
Picture paperOf(const Grid& grid, const PixelMap* before = nullptr);
Picture inked(const Grid& grid, const std::vector<PixelStep>& pixels, const PixelMap* before = nullptr);
// The colour of the order in which pixels are set, from blue, the first, to yellow.
Picture orderOf(const Grid& grid, const std::vector<PixelStep>& pixels, const PixelMap* before = nullptr);

// OpenGL's picture of a mesh whose positions are x, y in pixels and w, each pixel the mean of so many samples where there are
// any. Kept, while the same is drawn.
Picture byOpenGl(Gpu& gpu, MeshData data, const Grid& grid, const Frame& frame, int samples = 0);

struct Shape {
    std::vector<std::vector<vec2>> lines;  // in the settings' coordinates
    std::optional<vec2> dot = {};
};
// Shows both pictures with the shape over them; gpu.drawing is then in the left pane.
void showPictures(Gpu& gpu, const Frame& frame, const Grid& grid, const Picture& left, const Picture& right,
                  Shape shape);
// The error term of each pixel, in figures, where there is room for them.
void showErrors(Gpu& gpu, const std::vector<PixelStep>& pixels, const Grid& grid, const Frame& frame);
// Dots at these places of each of these pixels, where there is room for them.
void showPlaces(Gpu& gpu, const std::vector<vec2>& pixels, const std::vector<vec2>& places, const Grid& grid,
                const Frame& frame);
// A frame round a pixel, in the pane that gpu.drawing is in; and one round each of these, in both panes.
void framePixel(Gpu& gpu, int x, int y, const vec4& color, const Grid& grid, const Frame& frame);
void showDifferent(Gpu& gpu, const std::vector<std::pair<int, int>>& pixels, const Grid& grid, const Frame& frame);
// The pixels in which what is set differs from OpenGL's picture.
std::vector<std::pair<int, int>> differing(const Grid& grid, const std::vector<PixelStep>& pixels,
                                           const Picture& glPicture);
// Below the left picture, under its words: a bar from 0, of a length from -1 to 1, and words.
void showBar(Gpu& gpu, double length, const Grid& grid, const Frame& frame, const std::string& words);
// What decides about a line's next pixel, line_figure.cpp: its error as a bar to the right where it is 0 or more, which is up.
void showDecision(Gpu& gpu, const Line& line, const std::vector<PixelStep>& pixels, const Grid& grid,
                  const Frame& frame);
// "19 pixels", or how many of them are set: "10 of 19 pixels".
std::string countOf(const Grid& grid, std::size_t all);
// Words below them, and a second line below the left one. Draws all of gpu.drawing.
void showWords(Gpu& gpu, const Frame& frame, const Grid& grid, const std::string& left, const std::string& right,
               const std::optional<std::pair<std::string, vec4>>& more = {});

}  // namespace mv::rasterizer

// Filling areas of a picture, and polygons by their outlines.
#pragma once
#include <cstddef>
#include <vector>

#include "line.h"
#include "mv/math/types.h"

namespace mv {

// Colours of pixels as small numbers, row by row from the lowest.
struct PixelMap {
    int width = 0, height = 0;
    std::vector<int> colors;
    PixelMap(int columns, int rows)
        : width(columns), height(rows), colors(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {}
    bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < width && y < height; }
    int& at(int x, int y) { return colors[place(x, y)]; }
    int at(int x, int y) const { return colors[place(x, y)]; }

  private:
    std::size_t place(int x, int y) const {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
    }
};

struct Flooded {
    std::vector<PixelStep> pixels;  // in the order in which they are set
    long calls = 0;                 // pixels that were looked at
    long deepest = 0;               // calls within each other, or spans that waited
};

// Gives the new colour to all pixels of the seed's colour that are joined to the seed by 4 neighbours, or by 8. A fill with the
// same colour does nothing. Fills by recursion, as on the slide: an Error refuses a fill that would go deeper than
// `deepest`, before the stack ends; by spans, whole runs of a row are set at once, and the rest waits in a list.
Flooded floodByRecursion(PixelMap& map, int x, int y, int color, int neighbors, long deepest = 20000);
Flooded floodBySpans(PixelMap& map, int x, int y, int color, int neighbors);

// The pixels whose middles are inside a polygon that may cross itself: where a ray to the right crosses its outline an odd
// number of times, or where it winds round them. Half-open in y, and in x.
enum class Winding { evenOdd, nonZero };
std::vector<PixelStep> polygonPixels(const std::vector<vec2>& corners, int width, int height, Winding winding);

}  // namespace mv

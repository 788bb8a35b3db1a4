// rasterizer: which pixels a line, a triangle and a filled outline set, one by one, beside those that OpenGL sets.
#include "rasterizer.h"

#include "sheet.h"

namespace mv::rasterizer {

// Each subject is a part of the lesson, in the file of its name.
void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Grid grid(s);
    switch (s.subject) {
        case Subject::line:
            return drawLine(gpu, s.line, grid, frame);  // line.cpp
        case Subject::triangle:
            return drawTriangles(gpu, s.triangles, s.corners, grid, frame);  // triangle.cpp
        case Subject::fill:
            return drawFill(gpu, s.fill, s.corners, grid, frame);  // fill.cpp
        case Subject::star:
            return drawStar(gpu, s.star, grid, frame);  // star.cpp
        case Subject::circle:
            return drawCircle(gpu, s.circle, grid, frame);  // circle.cpp
    }
}

}  // namespace mv::rasterizer

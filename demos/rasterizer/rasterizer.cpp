// rasterizer: which pixels a line, a triangle and a filled outline set, one by one, beside those that OpenGL sets.
#include "rasterizer.h"

#include <array>

#include "sheet.h"

namespace mv::rasterizer {

// Each subject is a part of the lesson, in the file of its name: line.cpp, triangle.cpp, fill.cpp, star.cpp, circle.cpp.
void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    constexpr std::array ofSubject{drawLine, drawTriangles, drawFill, drawStar, drawCircle};
    ofSubject.at(std::size_t(s.subject))(gpu, s, Grid(s), frame);
}

}  // namespace mv::rasterizer

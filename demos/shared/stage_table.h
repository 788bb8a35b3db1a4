// The stages of the graphics pipeline by their names in OpenGL and in Direct3D.
#pragma once
#include <array>
#include <cstddef>
#include <string>

#include "mv/gl/drawing.h"

namespace mv {

struct StageName {
    const char* openGl;
    // In Direct3D 9, 10 and 11; "" where that has no such stage.
    std::array<const char*, 3> direct3d;
    bool isProgrammable;
};

// In the order in which a primitive goes through them; the compute shader stands apart from that.
inline constexpr std::array<StageName, 11> stageNames{{
    {"vertex specification", {"Vertex and Primitive Data", "Input Assembler", "Input Assembler"}, false},
    {"vertex shader", {"Vertex Shader", "Vertex Shader", "Vertex Shader"}, true},
    {"tessellation control shader", {"", "", "Hull Shader"}, true},
    {"primitive generator", {"Tessellation", "", "Tessellator"}, false},
    {"tessellation evaluation shader", {"", "", "Domain Shader"}, true},
    {"geometry shader", {"", "Geometry Shader", "Geometry Shader"}, true},
    {"transform feedback", {"", "Stream Output", "Stream Output"}, false},
    {"rasterization", {"Geometry Processing", "Rasterizer", "Rasterizer"}, false},
    {"fragment shader", {"Pixel Shader", "Pixel Shader", "Pixel Shader"}, true},
    {"per-fragment operations", {"Pixel Rendering", "Output Merger", "Output Merger"}, false},
    {"compute shader", {"", "", "Compute Shader"}, true},
}};

// What a draw of 16 control points goes through, and what was counted of it.
struct PatchDraw {
    bool isTessellated, hasGeometry, hasFragments;
    GLenum mode;       // GL_PATCHES, GL_POINTS, or GL_TRIANGLES of the net
    int inner, outer;  // levels
    bool isBent;
    GLenum before, after;      // the primitives that reach the geometry stage's place, and that leave it
    bool isCounted;            // or the numbers below say nothing
    long toGeometry, sent;     // so many of them
    std::size_t cornersFound;  // in the buffer of transform feedback
};

// "128 triangles", "1 line".
std::string primitivesText(long number, GLenum primitive);

// Draws the table of the stages into a box of the picture, with what goes in and what comes out; stages that are off in grey.
// Nothing where there is no room for words of 8 pixels.
void drawStageTable(Drawing& drawing, const Box& box, const PatchDraw& patch);

// The pane below a line of words at its upper edge, for which it gives up 32 pixels; all of it where it has not twice that.
inline Pane belowHeading(const Pane& pane) {
    return {pane.x, pane.y, pane.width, pane.height < 64 ? pane.height : pane.height - 32};
}

}  // namespace mv

// The stages of the graphics pipeline: their names in OpenGL and in Direct3D, and what goes through them.
#pragma once
#include <algorithm>
#include <array>
#include <functional>
#include <string>

#include "mv/gl/drawing.h"
#include "mv/gl/feedback.h"
#include "mv/gl/program.h"

namespace mv {

struct StageName {
    const char* openGl;
    // The names in Direct3D 9, 10 and 11, "" where a version has no such stage.
    std::array<const char*, 3> direct3d;
    bool isProgrammable;
};

// The stages in the order in which a primitive goes through them. The compute shader stands apart from that.
inline constexpr std::array<StageName, 11> stageNames{{
    {"vertex specification", {"Vertex, Primitive Data", "Input Assembler", "Input Assembler"}, false},
    {"vertex shader", {"Vertex Processing", "Vertex Shader", "Vertex Shader"}, true},
    {"tessellation control shader", {"", "", "Hull Shader"}, true},
    {"primitive generator", {"Tessellation", "", "Tessellator"}, false},
    {"tessellation evaluation shader", {"", "", "Domain Shader"}, true},
    {"geometry shader", {"", "Geometry Shader", "Geometry Shader"}, true},
    {"transform feedback", {"", "Stream Output", "Stream Output"}, false},
    {"rasterization", {"Geometry Processing", "Rasterizer", "Rasterizer"}, false},
    {"fragment shader", {"Pixel Processing", "Pixel Shader", "Pixel Shader"}, true},
    {"per-fragment operations", {"Pixel Rendering", "Output Merger", "Output Merger"}, false},
    {"compute shader", {"", "", "Compute Shader"}, true},
}};

// The primitives that leave a stage, counted three times over.
struct CountedPrimitives {
    bool isCounted = false;  // if not, the counts have no meaning
    GLenum primitive = GL_TRIANGLES;
    Captured number = {};
    double found() const;  // primitives of which all corners were in the buffer of transform feedback
};
// The primitives that these draws with that mode send on, by captured(). The program is in use.
CountedPrimitives counted(const Program& program, GLenum mode, const std::function<void()>& draw);

// The stages that a draw of 16 control points goes through, and the counts of it.
struct PatchDraw {
    GLenum mode;       // GL_PATCHES, GL_POINTS, or GL_TRIANGLES of the net
    int inner, outer;  // levels
    bool isBent, hasGeometry, hasFragments;
    CountedPrimitives toGeometry, sent;  // primitives before and after the geometry stage
};

// "128 triangles", "1 line".
std::string primitivesText(long number, GLenum primitive);

// Whether half the picture is too narrow for all columns of the table, which then has two of them and two thirds of the picture.
bool narrowTable(const FrameInfo& frame);

// Draws the table of the stages into the right of the picture, with their names in Direct3D 9, 10 or 11, and with what
// goes in and what comes out; stages that are off in grey. Nothing where there is no room for words that can be read.
void drawStageTable(Drawing& drawing, const FrameInfo& frame, int direct3d, const PatchDraw& patch);

// Which of two panes is drawn by which kind of shader, in words above them; nothing where there is no room. With water, the right
// one has the light that falls through the left one.
void drawHeadings(Drawing& drawing, const FrameInfo& frame, bool isWater, bool computes);

// The pane below a line of words at its upper edge, for which it gives up 32 pixels; all of it where it has not twice that.
inline Pane belowHeading(const FrameInfo& frame, std::size_t side) {
    const std::vector<Pane> panes = frame.inUnits().panes(2);
    const auto below = [&](const Pane& pane) {
        return frame.fromUnits({pane.x, pane.y, pane.width, pane.height < 64 ? pane.height : pane.height - 32});
    };
    // Of one width, whatever becomes of the units' fractions: the two are compared pixel by pixel
    Pane own = below(panes[side]);
    own.width = std::min(below(panes[0]).width, below(panes[1]).width);
    return own;
}

}  // namespace mv

// The picture of a cube, and beside it the volume of view that it was made with, from outside, and the cube from -1 to 1 that the
// projection makes of that volume.
#pragma once
#include "mv/demo/frame.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"

namespace mv {

// What the figure is told of a lesson. The program has the uniforms viewFromModel and clipFromView.
struct ViewFigure {
    mat4 viewFromModel, clipFromView;
    double near, far;  // distances before the eye; negative is behind it
    bool isPerspective;
};

// The panes of a picture with the figure: the picture itself, which keeps the frame's aspect, and below it the two others.
Pane picturePane(const FrameInfo& frame);
Pane volumePane(const FrameInfo& frame);
Pane cubePane(const FrameInfo& frame);

// How the volume is seen from outside, in its pane: all of it, of the cube of side 1 in it, and of the eye.
mat4 outsideFromView(const ViewFigure& figure, const Pane& pane);

// Draws both, and names what they show; the viewport covers the picture before and after.
void drawViewFigure(Drawing& drawing, const Program& program, const Mesh& cube, const ViewFigure& figure,
                    const Frame& frame);

// Says by how much shapes are stretched, where the picture is of another shape than the volume of view.
void tellStretch(const mat4& clipFromView, const Frame& frame);

}  // namespace mv

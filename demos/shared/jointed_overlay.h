// What is drawn and written beside a thing of joints: sticks, angles, and the product of its matrices.
#pragma once
#include <string>
#include <vector>

#include "mv/gl/drawing.h"
#include "mv/motion/inverse_kinematics.h"
#include "shared/jointed.h"

namespace mv {

// Where space is drawn.
struct View {
    Pane pane{0, 0, 1, 1};
    mat4 clipFromWorld{1};
    // Pixels from the pane's lower left corner, for Drawing::in(pane). Refused: a point on the eye's own plane.
    vec2 pixel(const vec3& world) const;
};

// Of words beside a picture of that size, for one that is composed in 960 x 560: 16 there, and 8 at least.
int textHeightIn(const FrameInfo& frame);
// "0.5", "-1", "0.333": three decimals, none where they are 0, and never "-0".
std::string shortNumber(double value);

// Lines from joint to joint to the end.
void drawStick(Drawing& drawing, const View& view, const Jointed& thing, const std::vector<mat4>& worldFromPart,
               const Stroke& stroke);

// Each angle with its name: an arc from 0 to it, or over the joint's limits with a mark where it is; red at a limit.
void drawAngles(Drawing& drawing, const View& view, const Jointed& thing, const std::vector<mat4>& worldFromPart,
                const std::vector<double>& degrees, int textHeight);

// The factors of the joints from the root to the end, and their product, under each other from the picture's top on; shown
// to the frame by the same names: worldFromUpper, upperFromLower, worldFromLower. In a plane, which is z = 0, without
// rows and columns of z. It leaves the drawing in the whole picture.
void drawProduct(Drawing& drawing, const Frame& frame, const Jointed& thing, const std::vector<mat4>& worldFromPart,
                 const std::vector<double>& degrees, int left, bool isInPlane);

// How far the end was from its goal after each iteration of a method.
struct ResidualCurve {
    std::string name;
    std::vector<IkIteration> history;
    bool isChosen;
};
// In the lower right corner of the picture, from `left` on, on a logarithmic axis; what is below 1e-12 is drawn there. A
// line marks the iterations that are allowed. It leaves the drawing in the whole picture.
void drawResiduals(Drawing& drawing, const Frame& frame, const std::vector<ResidualCurve>& curves, int left,
                   int allowed, int most);

}  // namespace mv

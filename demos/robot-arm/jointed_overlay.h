// What is drawn and written about a thing of joints: its reach, its target, sticks, angles, matrices, residuals and words.
#pragma once
#include <string>
#include <vector>

#include "jointed.h"
#include "mv/gl/drawing.h"
#include "mv/motion/inverse_kinematics.h"

namespace mv {

// "0.500", "-1", "0.333": three decimals, none of a whole number, and never "-0".
std::string shortNumber(double value);

// How far the end was from its goal after each iteration of a method.
struct ResidualCurve {
    std::string name;
    std::vector<IkIteration> history;
    bool isChosen;
};

// Sizes are composed for a picture of 960 x 560, and words shrink with it to 8 pixels.
//     overlay.begin(frame);
//     overlay.look(pane, clipFromWorld);   // for each pane; what follows is in it
//     overlay.stick(...); overlay.say(...);
//     overlay.below.draw(frame);           // then the demo's own draws
//     overlay.above.draw(frame);
class JointedOverlay {
  public:
    Drawing below, above;  // what the parts hide, and what hides them

    void begin(const Frame& frame);
    void look(const Pane& pane, const mat4& clipFromWorld);
    const Pane& pane() const { return pane_; }
    const mat4& clipFromWorld() const { return clipFromWorld_; }
    int size() const { return size_; }  // of words
    // Pixels from the pane's lower left corner. Refused: a point on the eye's own plane.
    vec2 pixel(const vec3& world) const;

    // The next line in the pane's upper left corner.
    void say(const std::string& words, const vec4& color = vec4(0.1, 0.1, 0.1, 1));
    // Below: a ring in the plane z = 0 about the origin; a circle of that radius about the y axis.
    void ring(double inner, double outer);
    void circleAt(double height, double radius);
    // Below: lines from joint to joint to the end.
    void stick(const Jointed& thing, const std::vector<mat4>& worldFromPart, const Stroke& stroke);
    // Above: the target, and where the end goes for where that is not the same.
    void target(const vec3& at, const vec3& goal);
    // Above: each angle with its name. An arc from 0 to it, or over the joint's limits with a mark where it is; red at a
    // limit.
    void angles(const Jointed& thing, const std::vector<mat4>& worldFromPart, const std::vector<double>& degrees);

    // Above, in that pane: the factors of the joints from the root to the end and their product, under each other from
    // its top on, and shown to the frame by the same names: worldFromUpper, upperFromLower, worldFromLower. In a
    // plane, z = 0, without rows and columns of z. Each has a line of `told` below it, in the colour of its part, and those
    // that are left stand below all.
    void product(const Frame& frame, const Jointed& thing, const std::vector<mat4>& worldFromPart,
                 const std::vector<double>& degrees, const Pane& beside, bool isInPlane,
                 const std::vector<std::string>& told = {});
    // Above, in the lower right corner: on a logarithmic axis, what is below 1e-12 at its end; a line marks how many
    // iterations are allowed.
    void residuals(const Frame& frame, const std::vector<ResidualCurve>& curves, int left, int allowed, int most);

  private:
    Pane pane_{0, 0, 1, 1};
    mat4 clipFromWorld_{1};
    int size_ = 16, lines_ = 0;
};

}  // namespace mv

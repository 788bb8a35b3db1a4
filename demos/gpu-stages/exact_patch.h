// The bicubic surface of the control net itself, which triangles approximate, and where a line of sight meets it.
#pragma once
#include <array>
#include <optional>

#include "mv/geometry/bezier_patch.h"
#include "mv/math/types.h"

namespace mv {

// The surface of the net in control_net.h, with its points raised by bend (x^2 - z^2), as the vertex shader of gpu-stages raises them. The points are a
// unit apart in x and z, so that these two are linear in u and v: the surface is a height over the net's square.
class ExactPatch {
  public:
    explicit ExactPatch(double bend = 0);
    const BezierPatch& patch() const { return patch_; }

    // The first point of the line on the surface: the part of the way, 0 .. 1. Along a line the height is a polynomial of degree
    // 6, whose first zero is found by halving, to 1e-13 of the way. A line that touches the surface may meet it or not.
    std::optional<double> firstHit(const vec3& from, const vec3& to) const;

  private:
    BezierPatch patch_;
};

}  // namespace mv

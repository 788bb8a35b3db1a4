#include "shared/spin.h"

#include "mv/math/transform.h"

namespace mv {

Spin::Spin(Demo* owner, double initialX, double initialY, const vec2& perPixel)
    : x(owner, "spin-x", initialX, "turn about the x axis"), y(owner, "spin-y", initialY, "turn about the y axis") {
    owner->bindDrag(y, perPixel.x, x, perPixel.y);
}

mat4 Spin::turn() const { return rotateX(x) * rotateY(y); }

}  // namespace mv

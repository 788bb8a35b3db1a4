#include "shared/turntable.h"

#include "mv/math/transform.h"

namespace mv {

Turntable::Turntable(Demo* owner, Real::Range steps)
    : spinX(owner, "spin-x", 0, "turn about the x axis"),
      spinY(owner, "spin-y", 0, "turn about the y axis"),
      distance(owner, "distance", 0, steps, "step back") {
    owner->bindDrag(spinY, 1, spinX, 1);
    owner->bindWheel(distance, -0.25);
}

mat4 Turntable::turn() const { return rotateX(spinX) * rotateY(spinY); }

mat4 Turntable::seenBy(const mat4& viewFromWorld) const { return translate(0, 0, -distance) * viewFromWorld * turn(); }

}  // namespace mv

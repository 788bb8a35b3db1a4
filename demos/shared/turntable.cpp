#include "shared/turntable.h"

#include "mv/math/transform.h"

namespace mv {

Turntable::Turntable(Demo* owner, Real::Range steps) : spin(owner), distance(owner, "distance", 0, steps, "step back") {
    owner->bindWheel(distance, -0.25);
}

mat4 Turntable::turn() const { return spin.turn(); }

mat4 Turntable::seenBy(const mat4& viewFromWorld) const { return translate(0, 0, -distance) * viewFromWorld * turn(); }

}  // namespace mv

#include "shared/orbit.h"

#include "mv/math/transform.h"
#include "shared/orbit_rows.h"

namespace mv {

mat4 turnOf(const Orbit& orbit) { return rotateX(orbit.spinX) * rotateY(orbit.spinY); }

mat4 seenFrom(const Orbit& orbit, const mat4& viewFromWorld) {
    return translate(0, 0, -orbit.distance) * viewFromWorld * turnOf(orbit);
}

std::vector<Row<Orbit>> orbitRows(NumberRange steps) {
    return {angle("spin-x", &Orbit::spinX, "turn about the x axis"),
            angle("spin-y", &Orbit::spinY, "turn about the y axis"),
            number("distance", &Orbit::distance, steps, "step back")};
}

}  // namespace mv

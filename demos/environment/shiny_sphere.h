// The sphere of radius 1 in the middle of a room, and the light that it sends to an eye: by rays in double precision, with
// nothing looked up. The references of the demo environment.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mv/geometry/scene.h"
#include "shared/fresnel.h"
#include "surroundings.h"

namespace mv {

struct ShinySphere {
    Room room;
    Coating coating = {};
    // Times that light is reflected inside the glass, at most. Each share less than 1e-6 of the light is left out.
    int innerReflections = 0;

    // The light along a ray that comes from outside the sphere, in linear light; none where it misses. Refused: what
    // fresnel() refuses.
    std::optional<vec3> seenAlong(const Ray& ray) const;
    // The luminance in the middle of each pixel that shows the sphere to within 0.95 of its radius, else -1; the upper row
    // first.
    std::vector<double> picture(const Scene& camera, int width, int height) const;

  private:
    vec3 through(const vec3& into, const vec3& normal, double reflected) const;
};

}  // namespace mv

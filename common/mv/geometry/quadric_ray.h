// Rays against bodies round the y axis: cylinder, cone and torus; and against a disk.
//
// Templates on the scalar, compiled for float and double, as mv/geometry/ray.h, whose rays these are. The bodies stand at
// the origin; elsewhere, and turned or stretched, they are met by the ray in their own space: transformed() of
// mv/geometry/ray_forms.h. A ray with NaN, infinity or direction 0 meets nothing, and so does a body with a size that is
// not above 0.
#pragma once
#include <optional>

#include "mv/geometry/ray.h"

namespace mv {

// The part of the ray inside the closed cylinder of that radius about the y axis, from y = low to high, its two lids
// with it. The line's distance from the axis is a product's difference without cancellation, as a sphere's: no false
// hits and no missed ones far away; in float, t is as good as the coordinates.
template <typename T>
std::optional<RayInterval<T>> intersectCylinder(const RayOf<T>& ray, T radius, T low, T high);

// The part of the ray inside the closed cone whose base is the disk of that radius at y = 0, its tip at y = height. The
// half behind the tip, which solves the same equation, is left out, and a ray along the side, whose equation is linear,
// is met. Computed by differences of products as above; the textbook's b*b - 4ac loses all digits where the eye is a
// thousand heights away. Trap: a ray exactly along the side, or through the tip, is inside or not by rounding.
template <typename T>
std::optional<RayInterval<T>> intersectCone(const RayOf<T>& ray, T radius, T height);

// The meeting of the ray with the disk about `center` with that normal, of any length, from either side; t >= 0. None
// where it runs parallel to it.
template <typename T>
std::optional<T> intersectDisk(const RayOf<T>& ray, const glm::vec<3, T>& center, const glm::vec<3, T>& normal,
                               T radius);

// The first place, t >= 0, at which the ray meets the surface of the ring about the y axis: a tube of radius `minor` whose middle
// runs at the distance `major`; from inside of the tube, too. Any minor up to major. Four roots of a quartic: it is made at the
// ray's nearest point to the middle, without a cubic term and with the last coefficient as a product, and its roots are
// bracketed between those of its derivatives, so that none is lost; Ferrari's formulas lose digits where two roots are
// near each other. Computed in double for float, too.
// Trap: a ray that only touches the tube, within 1e-7 or so of its radius, meets it or not by rounding.
template <typename T>
std::optional<T> intersectTorus(const RayOf<T>& ray, T major, T minor);

}  // namespace mv

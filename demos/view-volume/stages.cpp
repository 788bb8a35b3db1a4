// The matrices that the right pane of view-volume can show: onto a plane, to sides at 45 degrees, and to the cube.
#include <algorithm>
#include <cmath>

#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "view-volume.h"

namespace mv::view_volume {

mat4 stageFromCamera(const Settings& s) {
    if (s.stage == Stage::plane) return planeFromCamera(s);
    if (s.stage == Stage::sides) return sidesFromCamera(s);
    return clipFromCamera(s);
}

// The first projection. A parallel one leaves z out: diag(1, 1, 0, 1). A perspective draws (x, y, z) at the place where the line
// to the eye meets the plane z = d: by similar triangles at x d/z and y d/z. The matrix puts z/d into w.
mat4 planeFromCamera(const Settings& s) {
    if (s.projection == Projection::orthographic) return scale(1, 1, 0);
    const double d = -s.nearUsed();
    mat4 m(1);
    m[2][3] = 1 / d;
    m[3][3] = 0;
    return m;
}

// The first half of the projection: the sides of the pyramid move to x = -z, x = z, y = -z and y = z, 90 degrees apart. The sides
// of a box move to -1 and 1.
mat4 sidesFromCamera(const Settings& s) {
    const vec2 half = s.projection == Projection::perspective ? std::tan(radians(fovy / 2)) * vec2(aspect, 1)
                                                              : boxHalf() * vec2(aspect, 1);
    return scale(1 / half.x, 1 / half.y, 1);
}

// The other half is depth alone. In a perspective z = -near moves to -1 and z = -far to 1, after the division by -z.
mat4 clipFromSides(const Settings& s) {
    const double n = s.nearUsed(), f = s.far;
    if (s.projection == Projection::orthographic) return scale(1, 1, -2 / (f - n)) * translate(0, 0, (f + n) / 2);
    mat4 m(1);
    m[2] = vec4(0, 0, -(f + n) / (f - n), -1);
    m[3] = vec4(0, 0, -2 * f * n / (f - n), 0);
    return m;
}

// Look at the plane, or at the space from the eye to far, from far enough away.
mat4 paneFromStage(const Settings& s, const Pane& pane) {
    if (s.stage == Stage::cube) return cubeFromClip(s, pane);
    const bool isPlane = s.stage == Stage::plane, isParallel = s.projection == Projection::orthographic;
    const double half = isParallel ? boxHalf() : s.nearUsed() * std::tan(radians(fovy / 2));
    const double planeAt = isParallel ? 0 : s.nearUsed(),
                 volumeAt = isParallel ? (s.nearUsed() + s.far) / 2 : s.far / 2;
    const double away = isPlane ? 4.4 * half : isParallel ? 1.6 * (s.far - s.nearUsed()) : 4 * s.far;
    return perspective(40, pane.aspect(), away / 100, 10 * away) * translate(0, 0, -away) * turned(s) *
           translate(0, 0, isPlane ? planeAt : volumeAt);
}

}  // namespace mv::view_volume

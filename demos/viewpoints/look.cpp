// The computation of lookAt: the axes of a camera, and the matrix whose rows they are.
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "mv/math/transform.h"
#include "viewpoints.h"

namespace mv::viewpoints {

// The camera looks along -w. `up` need not be perpendicular to w, but v is.
Axes axesOf(const Gaze& gaze) {
    const vec3 w = normalize(gaze.eye - gaze.at);
    const vec3 u = normalize(cross(gaze.up, w));
    const vec3 v = cross(w, u);
    return {u, v, w};
}

// A row times a point is the point's coordinate along that axis.
mat4 turnInto(const Axes& axes) {
    return transpose(mat4(vec4(axes.u, 0), vec4(axes.v, 0), vec4(axes.w, 0), vec4(0, 0, 0, 1)));
}

// Move the eye to the origin, then turn the axes into x, y and z.
mat4 viewByAxes(const Gaze& gaze) { return turnInto(axesOf(gaze)) * translate(-gaze.eye); }

// A turn's inverse is its transpose, so the eye is where the view matrix, [R t], gives 0: R eye + t = 0.
vec3 eyeOf(const mat4& view) { return -(transpose(mat3(view)) * vec3(view[3])); }

}  // namespace mv::viewpoints

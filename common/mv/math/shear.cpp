#include "mv/math/shear.h"

#include <string_view>

#include "mv/math/require.h"

namespace mv {
namespace {

mat4 sheared(std::string_view subject, int axis, const vec3& factors) {
    requireFinite(subject, "the factors", factors);
    mat4 m(1);
    m[axis] += vec4(factors, 0);
    return m;
}

}  // namespace

mat4 shearX(double y, double z) { return sheared("shearX", 0, {0, y, z}); }
mat4 shearY(double x, double z) { return sheared("shearY", 1, {x, 0, z}); }
mat4 shearZ(double x, double y) { return sheared("shearZ", 2, {x, y, 0}); }

}  // namespace mv

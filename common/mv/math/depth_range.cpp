#include "mv/math/depth_range.h"

#include <cmath>

#include "mv/error.h"
#include "mv/math/projection.h"
#include "mv/math/require.h"
#include "mv/math/robust.h"

namespace mv {
namespace {

// a b / c, also where the product would vanish or overflow and the quotient does not.
double timesOver(double a, double b, double c) {
    const double product = a * b;
    return isOrdinary(std::abs(product)) ? product / c : a * (b / c);
}

}  // namespace

mat4 perspective(double fovy, double aspect, double near, double far, DepthRange range) {
    const bool isEndless = far == HUGE_VAL;
    mat4 m = isEndless ? infinitePerspective(fovy, aspect, near) : perspective(fovy, aspect, near, far);
    const double d = far - near;
    switch (range) {
        case DepthRange::zeroToOne:
            m[2][2] = isEndless ? -1 : -far / d;
            m[3][2] = isEndless ? -near : -timesOver(far, near, d);
            break;
        case DepthRange::oneToZero:
            m[2][2] = isEndless ? 0 : near / d;
            m[3][2] = isEndless ? near : timesOver(far, near, d);
            break;
        case DepthRange::oneToMinusOne:
            m[2][2] = isEndless ? 1 : (far + near) / d;
            m[3][2] = 2 * (isEndless ? near : timesOver(far, near, d));
            break;
    }
    return m;
}

mat4 ortho(double left, double right, double bottom, double top, double near, double far, DepthRange range) {
    mat4 m = ortho(left, right, bottom, top, near, far);
    const double d = far - near;
    switch (range) {
        case DepthRange::zeroToOne:
            m[2][2] = -1 / d;
            m[3][2] = -near / d;
            break;
        case DepthRange::oneToZero:
            m[2][2] = 1 / d;
            m[3][2] = far / d;
            break;
        case DepthRange::oneToMinusOne:
            m[2][2] = 2 / d;
            m[3][2] = (near + far) / d;
            break;
    }
    return m;
}

mat4 infiniteFrustum(double left, double right, double bottom, double top, double near) {
    const double w = right - left, h = top - bottom;
    const vec4 element(2 * near / w, 2 * near / h, (right + left) / w, (top + bottom) / h);
    if (!(near > 0 && isFinite(element) && isFinite(vec3(w, h, -2 * near)))) {
        requirePositive("infiniteFrustum", "near", near);
        requireFinite("infiniteFrustum", "the window's low corner", vec2(left, bottom));
        requireFinite("infiniteFrustum", "the window's high corner", vec2(right, top));
        if (w == 0) throw Error("infiniteFrustum", "left and right must differ", numberText(left));
        if (h == 0) throw Error("infiniteFrustum", "bottom and top must differ", numberText(bottom));
        throw Error("infiniteFrustum",
                    "the bounds must be neither so close nor so far apart that the matrix overflows");
    }
    // clang-format off
    return {element.x, 0,         0,          0,
            0,         element.y, 0,          0,
            element.z, element.w, -1,        -1,
            0,         0,         -2 * near,  0};
    // clang-format on
}

}  // namespace mv

#include "mv/math/projection.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "mv/error.h"
#include "mv/math/require.h"

namespace mv {
namespace {

void requireDifferent(std::string_view subject, std::string_view firstName, double first, std::string_view secondName,
                      double second) {
    requireFinite(subject, firstName, first);
    requireFinite(subject, secondName, second);
    if (first != second) return;
    throw Error(subject, std::string(firstName).append(" and ").append(secondName).append(" must differ"),
                numberText(first));
}

void requireDepthRange(std::string_view subject, double near, double far) {
    requirePositive(subject, "near", near);
    requireFinite(subject, "far", far);
    if (far > near) return;
    throw Error(subject, "far must be greater than near", "near " + numberText(near) + ", far " + numberText(far));
}

// The height of the window at distance 1 is twice this.
double checkedTangent(std::string_view subject, double fovy, double aspect, double near, double far) {
    if (!(fovy > 0 && fovy < 180)) {
        throw Error(subject, "fovy must be greater than 0 and less than 180 degrees", numberText(fovy));
    }
    requirePositive(subject, "aspect", aspect);
    requireDepthRange(subject, near, far);
    return std::tan(radians(fovy) / 2);
}

mat4 checked(std::string_view subject, const mat4& m) {
    if (isFinite(m)) return m;
    throw Error(subject, "the bounds must be neither so close nor so far apart that the matrix overflows");
}

}  // namespace

// The matrices below are written column by column, so each stands transposed to its picture on paper.
// clang-format off
mat4 ortho(double left, double right, double bottom, double top, double near, double far) {
    requireDifferent("ortho", "left", left, "right", right);
    requireDifferent("ortho", "bottom", bottom, "top", top);
    requireDifferent("ortho", "near", near, "far", far);
    const double w = right - left;
    const double h = top - bottom;
    const double d = far - near;
    return checked("ortho", {2.0 / w,             0,                    0,                  0,
                             0,                   2.0 / h,              0,                  0,
                             0,                   0,                    -2.0 / d,           0,
                             -(left + right) / w, -(top + bottom) / h,  -(near + far) / d,  1});
}

mat4 perspective(double fovy, double aspect, double near, double far) {
    const double f = 1.0 / checkedTangent("perspective", fovy, aspect, near, far);
    const double d = far - near;
    return checked("perspective", {f / aspect, 0, 0,                    0,
                                   0,          f, 0,                    0,
                                   0,          0, -(near + far) / d,   -1,
                                   0,          0, -2 * near * far / d,  0});
}

mat4 frustum(double left, double right, double bottom, double top, double near, double far) {
    requireDifferent("frustum", "left", left, "right", right);
    requireDifferent("frustum", "bottom", bottom, "top", top);
    requireDepthRange("frustum", near, far);
    const double w = right - left;
    const double h = top - bottom;
    const double d = far - near;
    return checked("frustum", {2 * near / w,       0,                  0,                    0,
                               0,                  2 * near / h,       0,                    0,
                               (right + left) / w, (top + bottom) / h, -(far + near) / d,   -1,
                               0,                  0,                  -2 * near * far / d,  0});
}
// clang-format on

FrustumBounds frustumBounds(double fovy, double aspect, double near, double far) {
    const double top = near * checkedTangent("frustumBounds", fovy, aspect, near, far);
    const double right = top * aspect;
    return {-right, right, -top, top, near, far};
}

mat4 frustum(const FrustumBounds& bounds) {
    return frustum(bounds.left, bounds.right, bounds.bottom, bounds.top, bounds.near, bounds.far);
}

std::array<vec4, 6> planesFromClip(const mat4& clipFromWorld) {
    requireFinite("planesFromClip", "the matrix", clipFromWorld);
    static constexpr std::array<const char*, 6> names{"left", "right", "bottom", "top", "near", "far"};

    // A point is inside where -w <= x, y, z <= w, that is where rows w + x, w - x, ... give a positive product.
    const mat4 rows = glm::transpose(clipFromWorld);
    std::array<vec4, 6> planes;
    for (std::size_t i = 0; i < planes.size(); ++i) {
        const vec4 row = rows[static_cast<int>(i / 2)];
        const vec4 plane = i % 2 == 0 ? rows[3] + row : rows[3] - row;
        const double length = glm::length(vec3(plane));
        const double terms = glm::length(vec3(rows[3])) + glm::length(vec3(row));
        if (!(length > 1e-10 * terms)) {
            throw Error("planesFromClip",
                        std::string("the ") + names[i] +
                            " plane's normal must not cancel; for an extreme far/near use perspectivePlanes",
                        numberText(length));
        }
        planes[i] = plane / length;
        if (!isFinite(planes[i])) {
            throw Error("planesFromClip", std::string("the ") + names[i] + " plane must not overflow",
                        vectorText(plane));
        }
    }
    return planes;
}

std::array<vec4, 6> perspectivePlanes(double fovy, double aspect, double near, double far) {
    const double tangent = checkedTangent("perspectivePlanes", fovy, aspect, near, far);

    // Side planes pass through the eye: their normals are (cos, 0, -sin) of half the angle, from its tangent.
    const auto inward = [](double t) {
        const double length = std::hypot(1.0, t);
        return vec2(1 / length, -t / length);
    };
    const vec2 side = inward(tangent * aspect);
    const vec2 level = inward(tangent);
    return {vec4(side.x, 0, side.y, 0),    vec4(-side.x, 0, side.y, 0), vec4(0, level.x, level.y, 0),
            vec4(0, -level.x, level.y, 0), vec4(0, 0, -1, -near),       vec4(0, 0, 1, far)};
}

std::array<vec3, 8> viewVolumeCorners(const mat4& clipFromWorld) {
    requireFinite("viewVolumeCorners", "the matrix", clipFromWorld);
    const mat4 worldFromClip = glm::inverse(clipFromWorld);
    std::array<vec3, 8> corners;
    for (unsigned i = 0; i < corners.size(); ++i) {
        const vec4 clip((i & 1U) ? 1 : -1, (i & 2U) ? 1 : -1, (i & 4U) ? 1 : -1, 1);
        const vec4 world = worldFromClip * clip;
        corners[i] = vec3(world) / world.w;
        if (!isFinite(corners[i])) {
            throw Error("viewVolumeCorners", "the matrix must have an inverse, and the volume an end",
                        vectorText(world));
        }
    }
    return corners;
}

vec3 ndcFromClip(const vec4& clip) {
    requireFinite("ndcFromClip", "the clip position", clip);
    if (!(clip.w > 0)) {
        throw Error("ndcFromClip", "w must be greater than 0 (clip before dividing)", vectorText(clip));
    }
    const vec3 ndc = vec3(clip) / clip.w;
    if (!isFinite(ndc)) {
        throw Error("ndcFromClip", "w must be large enough for the quotient not to overflow", vectorText(clip));
    }
    return ndc;
}

vec2 pixelFromNdc(const vec2& ndc, int width, int height) {
    requireFinite("pixelFromNdc", "the position", ndc);
    requirePositive("pixelFromNdc", "width", width);
    requirePositive("pixelFromNdc", "height", height);
    const vec2 pixel((ndc.x + 1) / 2 * width, (ndc.y + 1) / 2 * height);
    requireFinite("pixelFromNdc", "the pixel", pixel);
    return pixel;
}

vec2 pixelFromNdc(const vec3& ndc, int width, int height) { return pixelFromNdc(vec2(ndc), width, height); }

}  // namespace mv

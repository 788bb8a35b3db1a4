// The objects that ray-cast's rays meet, as formulas; cast_meshes.h has them as triangles.
#pragma once
#include <array>
#include <optional>

#include "mv/geometry/ray_forms.h"

namespace mv {

enum class CastKind {
    plane,
    sphere,
    box,
    triangle,
    polygon,
    transformed,
    surface,
    teapot,
    cylinder,
    cone,
    disk,
    torus
};
inline constexpr std::array<const char*, 12> castKindNames{"plane",    "sphere",      "box",     "triangle",
                                                           "polygon",  "transformed", "surface", "teapot",
                                                           "cylinder", "cone",        "disk",    "torus"};
// The teapot, of triangles, and what follows it stand alone; the others together.
inline constexpr std::size_t castTogether = 7;
// Whether the object has the slides' forms beside the stable one.
inline bool hasTextbookForm(CastKind kind) { return kind < CastKind::teapot; }

inline const std::array<vec3, 12> castColors{vec3(0.78, 0.76, 0.70), vec3(0.82, 0.30, 0.25), vec3(0.25, 0.50, 0.78),
                                             vec3(0.35, 0.65, 0.35), vec3(0.95, 0.75, 0.20), vec3(0.60, 0.40, 0.75),
                                             vec3(0.30, 0.70, 0.70), vec3(0.80, 0.50, 0.25), vec3(0.25, 0.50, 0.78),
                                             vec3(0.95, 0.75, 0.20), vec3(0.35, 0.65, 0.35), vec3(0.82, 0.30, 0.25)};

// The form of an intersection, and the one of the plane's three descriptions. Forms are the slides' as printed, the same with
// their slips mended, and the library's.
enum class CastForm { printed, textbook, stable };
enum class PlaneForm { implicit, normal, parametric };
struct CastWay {
    CastForm form = CastForm::stable;
    PlaneForm plane = PlaneForm::implicit;
    int cells = 12;  // a side of the grid that Newton's method starts from; the textbook's has one start, in the middle
};

// A ray's hit on an object: t in lengths of the ray's direction, the normal in the world, of any length and side.
struct CastHit {
    double t = 0;
    vec3 normal{0, 0, 1};
};

// The first place along the ray, t > 0; computed in T, to which ray and object are rounded before. `scale` makes the object
// larger, about the world's origin. None too where Newton's method finds nothing, or the form answers NaN,
// and for the teapot, which is no formula.
template <typename T>
std::optional<CastHit> castAt(CastKind kind, double scale, const RayOf<T>& ray, const CastWay& way);

// The numbers that define the objects at scale 1. All are floats, but for the matrix and the star's corners.
namespace cast {
inline const vec3 floorCorner(-4, 0, -4), floorAlong(0, 0, 8), floorUp(8, 0, 0);
inline const vec3 sphereCenter(-1.5, 1, 0.5);
inline constexpr double sphereRadius = 1;
inline const vec3 boxLow(0.25, 0, -1.5), boxHigh(1.75, 1.5, 0);
inline const std::array<vec3, 3> triangle{vec3(-3.5, 0, -2), vec3(-0.5, 0, -3), vec3(-2.5, 2.75, -2.5)};
// A star of ten corners, in the plane z = 2.
std::array<vec3, 10> star();
// The unit sphere becomes an ellipsoid, turned.
mat4 worldFromEllipsoid();
inline constexpr double flagWave = 0.75, flagTurn = 6 * pi;
// Bodies round the y axis, at the world's origin but for the disk and the torus, which are 1 above it.
inline constexpr double cylinderRadius = 1, cylinderHeight = 2, coneRadius = 1.25, coneHeight = 2.25;
inline constexpr double diskRadius = 1.25, torusMajor = 1.5, torusMinor = 0.5;
inline const vec3 aboveOrigin(0, 1, 0), diskNormal(3, 4, 12);
// A flag with three waves: u along it, v up.
template <typename T>
SurfaceAt<T> flag(T u, T v, T scale);
}  // namespace cast

}  // namespace mv

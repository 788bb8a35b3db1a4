// Flat plates in front of an eye, as rays see them: all of several translucent plates, in their order.
#pragma once
#include <array>
#include <optional>
#include <span>
#include <vector>

#include "mv/geometry/mesh_data.h"
#include "mv/image/picture.h"
#include "mv/math/types.h"

namespace mv {

// x from 0 to 1 along it, y from -0.5 to 0.5 across it, z = 0; with rims of 0.7 of the colour where |y| > plateRim.
struct Plate {
    vec3 color;  // 0..1, not encoded
    mat4 viewFromPlate;
};
inline constexpr double plateRim = 0.42;

// Red, green and blue plates; +z is towards the eye.
// Bars round a triangle about the origin, each with its right end over the next one: no order sorts them.
std::array<Plate, 3> barsInACycle(const mat4& viewFromBars);
// Squares side by side and one over another, red in front, then green and blue, `step` apart.
std::array<Plate, 3> panes(const mat4& viewFromPanes, double step);
// A mark on a road on the ground, from below the eye to `far`: 1, 1 + separation and (1 + separation)^2 below the eye, so
// that on each ray the distances of mark, road and ground are in that proportion.
std::array<Plate, 3> roadOnGround(double far, double separation);

// A plate as triangles: a cell of six vertices, two triangles, between each two of `cuts`, which rise from 0 to 1.
MeshData plateMesh(std::span<const double> cuts);

struct PlateView {
    vec2 tangents;     // of half the angle of view, across and upwards
    double near, far;  // only between these distances along -z is anything seen; far may be infinite
    double opacity;    // of every plate, 0..1
    vec3 background;
    int width = 0, height = 0;  // pixels
};

// The colour that a ray in double precision through the middle of each pixel finds, the upper row first: each plate laid
// over what is behind it. Nothing where two plates are met within 1e-12 of the same distance. A plate seen edge-on is
// not seen. Judged by each plate's own plane: no depth is stored or compared in less than double.
std::vector<std::optional<vec3>> colorsByRays(std::span<const Plate> plates, const PlateView& view);

// The part, 0..1, of the picture's pixels that differ by more than two levels of 255 from those colours (three blends of
// half a level each). Not asked: pixels beside one of another colour, where an edge is, or without a colour, and the
// outermost. Nothing where no pixel is asked. Error: not as many colours as pixels.
std::optional<double> wrongPart(const Picture& picture, const std::vector<std::optional<vec3>>& colors);

}  // namespace mv

// Reliefs: a brick wall and the peel of an orange, as surfaces that lie below a smooth one. As functions in double
// precision, which are the truth, and as displaced meshes; relief_maps.h has the maps that a GPU is given of them.
//
// The wall's smooth surface is the plane z = 0, facing +z, where y is -1..1 and all is repeated after 2 units of x; a
// brick is 1 long and 1/2 high. The orange's is the unit sphere about the origin, with poles on the y axis.
#pragma once
#include "mv/geometry/mesh_data.h"
#include "mv/image/picture.h"
#include "mv/math/types.h"

namespace mv {

enum class ReliefBody { wall, orange };

struct Relief {
    ReliefBody body = ReliefBody::wall;
    double depth = 0.08;      // from height 1, on the smooth surface, down to height 0, in units
    bool isMirrored = false;  // the wall's part with x < 0 is the other one's mirror image
    // Its heights, where there is one, stand for the bricks or the peel: a map as paintedMap() makes them, which is
    // read between its texels as a GPU reads it. The map is the caller's, and outlives this.
    const FloatPicture* own = nullptr;

    bool operator==(const Relief&) const = default;
};

// The smooth surface at a point of it, or above or below one: there all is as at the nearest one.
struct ReliefPoint {
    vec3 smooth{0};     // the point of the smooth surface
    vec3 out{0, 0, 1};  // its unit normal
    double height = 1;  // 0..1
    vec3 slope{0};      // how the height changes along the smooth surface, in heights a unit
    vec3 color{0};      // linear
};
ReliefPoint reliefAt(const Relief& relief, const vec3& near);
// Its height alone, which costs less.
double reliefHeight(const Relief& relief, const vec3& near);
// The largest length that slope has anywhere, rounded up; a test looks at many points.
double steepest(ReliefBody body);

// The displaced point, and the unit normal of the displaced surface there.
vec3 displacedPoint(const Relief& relief, const ReliefPoint& at);
vec3 displacedNormal(const Relief& relief, const ReliefPoint& at);
// Each vertex moved to where it belongs, with its normal. `smooth` has vertices on the smooth surface.
MeshData displaced(const Relief& relief, const MeshData& smooth);

// A part of the wall's smooth surface, from one x to the other and all its height, in cells. u grows by 1 in 2 units; with
// a mirrored relief it falls up to x = 0, where a row of cells ends.
MeshData wallPiece(const Relief& relief, double fromX, double toX, int cellsX, int cellsY);

// The point of the smooth surface with these texture coordinates.
vec3 smoothPoint(ReliefBody body, const vec2& texCoord);
// How far u and v go round in units where they are as long as anywhere: at the equator, on the orange.
vec2 unitsOfRepeat(ReliefBody body);

// The shift by which parallax mapping finds what a line of sight meets, along the surface, in units: from the point where
// it enters the smooth surface to where it would have come down to this height. `view`, of unit length, points to the
// eye, in the frame of the surface; its z is taken as flattestSight at least, since the shift grows without end with it.
inline constexpr double flattestSight = 0.05;  // 87 degrees from the normal
vec2 parallaxShift(const vec3& view, double depth, double height);

// The light that is sent to the eye: a share of ambient light, Lambert's diffuse light, and a highlight by Blinn's half
// vector. All vectors have unit length. The same in shaders/include/relief.glsl.
vec3 reliefLight(const vec3& color, const vec3& normal, const vec3& light, const vec3& view);

}  // namespace mv

// Closed tracks in space for things that move along a curve, and what they look like. Metres, y up, the ground at y = 0.
#pragma once
#include <span>

#include "mv/geometry/mesh_data.h"
#include "mv/motion/arc_length.h"
#include "mv/motion/curve.h"
#include "mv/motion/path_frame.h"

namespace mv {

// park: a loop, a bend, two hills and an S, 25 keys. eight: a flat figure of eight, 64 keys; it is straight in the middle
// and nowhere else. ring: a flat circle of radius 20, 64 keys. knot: a trefoil, 36 keys. Keys are at equal steps of the
// time, from 0 to 1 for a lap, but not of the way.
enum class Track { park, eight, ring, knot };
// The curve through the keys: the periodic spline, whose acceleration is continuous, or the uniform Catmull-Rom curve,
// whose acceleration jumps at the keys.
enum class Through { spline, catmullRom };

struct TrackPath {
    Curve<vec3> curve;
    ArcLength way;
};
// Made at the first call, and kept.
const TrackPath& trackPath(Track track, Through through);

// Two rails on sleepers, on pillars to the ground, and the ground, 10 m a square. The sleepers, light on top and dark below,
// lie across the frames' up. Triangles with normals and colours. Refused: other numbers of frames than of samples.
MeshData trackMesh(std::span<const PathSample> samples, std::span<const PathFrame> frames);

}  // namespace mv

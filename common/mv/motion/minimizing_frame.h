// Frames along a curve that do not turn about it: rotation minimizing, or "parallel transported".
//
// These frames alone, of all that follow the tangent, have no angular velocity about it. So they never flip, at
// inflections and on straights neither, and what is swept along by them (a tube, a camera) does not twist. The frames
// need positions and velocities only. Source: Wang, Juettler, Zheng and Liu, "Computation of rotation minimizing
// frames", ACM Trans. Graphics 27 (2008).
#pragma once
#include <span>
#include <vector>

#include "mv/math/types.h"
#include "mv/motion/path_frame.h"

namespace mv {

// How up is taken from one sample to the next; the error of the frame's turn about the path falls with this power of
// the step.
enum class Transport {
    reorthogonalize,  // 1: what of up is along the new tangent is dropped (Gram and Schmidt), as is done most often
    project,          // 2: up is projected along the chord onto the new normal plane. Source: Klok, CAGD 3 (1986)
    rotate,  // 2: the least turn that takes the old tangent to the new. Source: Bloomenthal, Graphics Gems (1990)
    doubleReflection  // 4: mirrored in the middle plane of the chord, and again to bring the tangent to the new one
};

// The frames of these samples, the first of them frameByUp(velocity, firstUp). Samples may be at any distances from
// each other; between two at the same position the frame goes by `rotate`. Refused: what frameByUp refuses of the first
// sample, what requireMoving refuses, neighbours whose tangents are 90 degrees apart or more, and, but for
// reorthogonalize and rotate, which read no positions, a chord that is not within 90 degrees of the tangents at both
// its ends. Chords are differences: at a distance D from the origin and h from each other their direction is known to
// 1e-16 D/h rad, and shorter steps make that worse.
// Trap: orders are those of a smooth curve, which the knots of a spline are not.
std::vector<PathFrame> minimizingFrames(std::span<const PathSample> samples, const vec3& firstUp,
                                        Transport transport = Transport::doubleReflection);

// The angle by which the last frame of a closed path is rolled against the first, in degrees, in (-180, 180]; see
// rolled(). A minimizing frame comes back turned by the area that the tangent's path encloses on the unit sphere: by 0
// where the curve lies in a plane or on a sphere. Refused: forward directions more than 1e-6 rad apart, which is no
// closed path.
double closingAngle(const PathFrame& first, const PathFrame& last);

// Frames of a closed path (the last sample is where the first is) turned so that the last is the first: each by its
// part of the closing angle, in proportion to the way covered, measured by chords. So minimizing frames twist evenly.
// Refused: other numbers of frames than of samples, fewer than 2, what closingAngle refuses, ends more than 1e-6 of the
// path's length apart, a path of length 0 or of infinite length.
std::vector<PathFrame> closedFrames(std::span<const PathSample> samples, std::vector<PathFrame> frames);

}  // namespace mv

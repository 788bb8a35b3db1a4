// The things that Mesa's softpipe, the second rasterizer of ./test --long, does otherwise than llvmpipe, zink and GPUs.
#pragma once
#include "support/demo_run.h"

namespace mv::test {

inline bool onSoftpipe() { return stage().driver().renderer.find("softpipe") != std::string::npos; }

// Softpipe adds the polygon offset to a triangle's corners and clamps it there, where OpenGL clamps the depth of each fragment: a floor that
// reaches a shadow map's end is pushed the less the nearer to that end, and shades itself there.
inline bool clampsOffsetAtCorners() { return onSoftpipe(); }

// Softpipe reads a footprint that is longer than the texture from the smallest levels, however narrow it is.
inline bool blursLongFootprints() { return onSoftpipe(); }

// Softpipe sets points up to an eighth of a pixel off, so that some are set in the pixel beside theirs.
inline bool placesPointsCoarsely() { return onSoftpipe(); }

// Softpipe draws what a geometry shader makes, and captures none of it.
inline bool capturesNothingBehindGeometryShaders() { return onSoftpipe(); }

// Softpipe has one sample a pixel.
inline bool hasOneSample() { return onSoftpipe(); }

// Softpipe rounds what is blended when a tile leaves its cache, not after each draw: there a sum of eight bits loses nothing.
inline bool sumsBeforeRounding() { return onSoftpipe(); }

}  // namespace mv::test

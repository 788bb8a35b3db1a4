// The demos of the course's cube whose corners have the colours of their places.
#pragma once
#include "support/demo_run.h"

namespace mv::test {

inline constexpr Pixel red{255, 0, 0}, blue{0, 0, 255}, magenta{255, 0, 255}, yellow{255, 255, 0}, white{255, 255, 255};

// The cube is not turned.
inline DemoRun& straight(DemoRun& run) { return run.set("spin-x", 0).set("spin-y", 0); }

}  // namespace mv::test

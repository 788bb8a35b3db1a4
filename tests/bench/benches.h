// What mvgl measures against others. Each function runs its comparisons and returns a row for each.
#pragma once
#include <vector>

#include "bench/ratio.h"

namespace mv::bench {

// encodePng against stb_image_write: time (at most 0.25 of it) and size (at most 1.15 of it).
[[nodiscard]] std::vector<Row> pngBench(int rounds);

// The matrices of mv/math against GLM's functions of the same purpose, both in doubles: at most 2 times the time.
// What the time goes into are the checks of the arguments, which GLM does not make.
[[nodiscard]] std::vector<Row> mathBench(int rounds);

}  // namespace mv::bench

// Points spread over a square, for lamps, pixels and lenses that are asked at many places instead of one.
#pragma once
#include <cstdint>
#include <vector>

#include "mv/math/types.h"

namespace mv {

// side x side points in the unit square [0, 1) x [0, 1): one in each of side x side equal cells, at a random place of it,
// row by row (stratified, or jittered, sampling). The mean of a function over them is wrong by O(1/n) for a smooth one
// and O(n^-3/4) for one with an edge, where n = side * side points that are merely random have O(n^-1/2).
// The same numbers on every machine: std::mt19937, which the standard defines bit by bit, its 32 bits divided by 2^32.
// Refused: side outside 1..1024. Source: Cook, "Stochastic Sampling in Computer Graphics" (1986).
std::vector<vec2> jitteredSquare(int side, std::uint32_t seed);

}  // namespace mv

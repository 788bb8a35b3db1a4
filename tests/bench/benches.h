// The quantities that mvgl measures against others. Each function runs its comparisons and returns a row for each.
#pragma once
#include <string>
#include <vector>

#include "bench/ratio.h"

namespace mv::bench {

// encodePng against stb_image_write: time (at most 0.25 of it) and size (at most 1.15 of it).
[[nodiscard]] std::vector<Row> pngBench(int rounds);

// The matrices of mv/math against GLM's functions of the same purpose, both in doubles: at most 2 times the time.
// The time goes into the checks of the arguments, which GLM does not make.
[[nodiscard]] std::vector<Row> mathBench(int rounds);

// A frame of cube-cull and one of viewpoints through the framework, against the same GL calls made directly: at most 1.10
// times the time. And one that does not ask for the driver's messages, as in a window, against one that does: no longer (1.02).
[[nodiscard]] std::vector<Row> frameBench(int rounds);

// The time that a shadow map saves when work is left out: kept against drawn again (at most 0.8 of the frame, at 2048 texels),
// without the receiver against with it (0.85, at 4096: below, the picture's own pass outweighs what the floor fills); and
// what a filter costs more: 3 x 3 looks against one (3).
[[nodiscard]] std::vector<Row> shadowsBench(int rounds);

// A picture of cube-cull by a process of its own, against a bare program: at most 1.3 times the time and 1.15 times the
// peak memory.
[[nodiscard]] std::vector<Row> processBench(int rounds);

// Rays: sphere and triangle against the textbook's forms (at most 1.8 and 1.15 times the time), the ray caster on two
// threads against one (at least 1.8 times as fast), and against Embree, where that is installed (at most 10 times the time).
[[nodiscard]] std::vector<Row> raysBench(int rounds);
// The errors of mv/math's functions and their times beside GLM's: prints the page, or with a folder ("docs") writes it
// there as library.md, with its curve library.svg and the numbers library-errors.csv and library-times.csv. Takes
// minutes: 100,000 samples a function.
void accuracyBench(const std::string& folder);

// The errors and times of mv/motion's integrators beside CVODE and Odeint: prints the page, or with a folder ("docs") writes
// it there as work-precision.md, with its curves work-precision.svg and its rows work-precision.csv. Takes under three
// minutes. Without SUNDIALS it prints the rows of the others. Error: with a folder,
// SUNDIALS is missing.
void workPrecisionBench(const std::string& folder);
// Prints the references that it compares with, tests/work_precision/references.csv.
void workPrecisionReferences();

// Shadows of a cube on a floor, 640 x 480: by volumes against by matrix (at most 2.2 times the time), by matrix against
// none (at most 1.15).
[[nodiscard]] std::vector<Row> volumeBench(int rounds);

}  // namespace mv::bench

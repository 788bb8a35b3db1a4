// Lines and triangles for trials of a rasterizer's methods, with the right answers.
#pragma once
#include <vector>

#include "circle.h"
#include "line.h"
#include "mv/image/picture.h"
#include "shared/raster_triangle.h"

namespace mv {

// 64 lines to the right, of slopes from 0 to 1, across a picture so wide: the y of the pixel that the method sets in each
// column (by smooth: of the middle of its two), and the line's own.
std::vector<double> lineTest(LineMethod method, int columns);
std::vector<double> lineTruth(int columns);

// 16 triangles, corners at whole 1/256 of a pixel: for each pixel of the picture and each triangle 1 where it is covered. The
// truth is found row by row from where the edges cross it, in fractions.
std::vector<double> triangleTest(FillMethod method, int columns, int rows);
double triangleTestPixels(FillMethod method, int columns, int rows);
std::vector<double> triangleTruth(int columns, int rows);

// Of the same triangles the share of each pixel that is covered, by so many of its points; and exactly, by cutting the triangle to it.
std::vector<double> shareTest(int places, int columns, int rows);
std::vector<double> shareTruth(int columns, int rows);

// 32 circles with radii up to half the columns: for each column of the eighth beside the top the y of the uppermost pixel, for each
// row of the eighth beside the right the x of the outermost one, 0 where there is none; and the circle's own.
std::vector<double> circleTest(CircleMethod method, int columns);
double circleTestPixels(CircleMethod method, int columns);
std::vector<double> circleTruth(int columns);

// The number of pixels that are white in one picture and not in the other.
long countDifferent(const Picture& a, const Picture& b);

}  // namespace mv

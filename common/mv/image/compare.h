// How far two pictures are apart, in numbers and to look at.
#pragma once
#include "mv/image/picture.h"

namespace mv {

// The result of compare. A value is one channel of one pixel; alpha is a channel like the others.
// maximum, mean and rmse are in the unit of the values: levels 0..255 for a Picture.
struct Difference {
    double maximum = 0;   // largest |a - b| of any value
    double mean = 0;      // mean |a - b| over all values
    double rmse = 0;      // root of the mean of (a - b)^2 over all values
    double psnr = 0;      // peak signal-to-noise ratio, 20 log10(peak / rmse) decibels; infinity for equal pictures
    double fraction = 0;  // beyond / number of pixels
    long beyond = 0;      // pixels with any channel further apart than the threshold

    bool operator==(const Difference&) const = default;
};

// The difference of two pictures of the same size. `threshold`, in levels 0..255, decides only which pixels count as
// `beyond`: those with a channel that differs by MORE than it. The peak of psnr is 255.
// Error if the sizes differ, a picture has no pixels, or the threshold is out of range.
// The trap: fully transparent pixels differ where their hidden colours do.
[[nodiscard]] Difference compare(const Picture& a, const Picture& b, int threshold = 0);

// The same for measured quantities, in their own unit; `peak` is the largest value that the quantity can take.
// Error also if the channels differ, the threshold is not a finite number >= 0, the peak not a finite number > 0, or a
// picture holds a NaN or an infinity: no mean over it would mean anything.
[[nodiscard]] Difference compare(const FloatPicture& a, const FloatPicture& b, double threshold = 0, double peak = 1);

// A picture to see where and how much b differs from a, opaque and of their size.
// Pixels that are equal show a, in grey and darkened to at most 76 of 255, to find one's way. Pixels that differ in any
// channel shine from orange (by 1 level, so that it still shows) to yellow (by 255 levels).
// Error if the sizes differ or a picture has no pixels.
[[nodiscard]] Picture differencePicture(const Picture& a, const Picture& b);

// A frame round the pixels in which b differs from a, to be laid over b: transparent but for a yellow line, `width` pixels wide,
// within their edge, and a black one without. The picture's edge is none of theirs: there the yellow one runs along it.
// Error if the sizes differ, a picture has no pixels, or the width is not 1 .. 16.
[[nodiscard]] Picture differenceOutline(const Picture& a, const Picture& b, int width = 1);

}  // namespace mv

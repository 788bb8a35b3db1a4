// Light by its wavelengths: for glass, which bends each of them by another angle, and for nothing else here.
#pragma once
#include <vector>

#include "mv/math/types.h"

namespace mv {

// A glass' index at a wavelength, by Cauchy's formula a + b / wavelength^2 through its index at the yellow line d (587.56 nm) and
// its Abbe number (n_d - 1) / (n_F - n_C), of the lines F (486.13 nm) and C (656.27 nm); above 0, and the smaller, the more the
// colours part. Source: Born and Wolf, "Principles of optics", for the formula; glass makers list both numbers.
double indexAt(double nanometres, double index, double abbe);

// A wavelength that is traced, and what of its light is seen, as red, green and blue: `share` is a matrix, since the light of a
// scene is given as red, green and blue, too.
struct TracedWavelength {
    double nanometres = 0;
    mat3 share{1};
};

// That many wavelengths, 3 or 4 to 256. The sum of their shares is the unit matrix: what all of them show alike is seen as it was
// given. 3: those of the screen's red, green and blue, each for itself. More: the middles of equal parts of 400 to 700 nm.
// Red, green and blue of the scene are three spectra, flat over their part of the range, which blend into one another and are 1
// together; the eye's three sensors are those of colorMatching(). Refused: another count.
std::vector<TracedWavelength> tracedWavelengths(int count);

}  // namespace mv

// Red and cyan glasses as measured, and the colours of an anaglyph: of full colour, half colour, grey, or least squares.
#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "mv/math/color.h"
#include "stereocube.h"

namespace mv::stereocube {
namespace {

mat3 ofRows(const vec3& x, const vec3& y, const vec3& z) { return glm::transpose(mat3(x, y, z)); }

// CIE XYZ of a tube's red, green and blue at their brightest, bare and through the glasses 7003 of Reel 3-D.
// Source: Sanders and McAllister, "Producing anaglyphs from synthetic images" (2003), from the spectra of Dubois (2001).
const mat3 bare = ofRows({11.6638, 8.3959, 4.65843}, {7.10807, 16.6845, 2.45008}, {0.527874, 3.79124, 24.0604});
const mat3 throughRed =
    ofRows({5.42327, 0.807004, 0.047325}, {2.70972, 0.50201, 0.0250529}, {5.50941e-5, 4.11221e-4, 2.40686e-3});
const mat3 throughCyan = ofRows({0.180431, 1.6395, 2.00309}, {0.448214, 6.31551, 1.35757}, {0.289201, 2.3925, 11.062});

const mat3& glassOf(Eyes eyes) {
    if (eyes == Eyes::left) return throughRed;
    return eyes == Eyes::right ? throughCyan : bare;
}

}  // namespace

// Red, green and blue of the anaglyph, from those of the left eye's picture and of the right eye's.
Mixing mixingOf(Mix mix) {
    if (mix == Mix::leastSquares) return leastSquares();
    const vec3 none(0), brightness = brightnessThrough(Eyes::both);
    const bool isLeftGrey = mix != Mix::full, isRightGrey = mix == Mix::grey;
    return {
        .fromLeft = ofRows(isLeftGrey ? brightness : vec3(1, 0, 0), none, none),
        .fromRight = ofRows(none, isRightGrey ? brightness : vec3(0, 1, 0), isRightGrey ? brightness : vec3(0, 0, 1))};
}

// Of all colours a, that for which both eyes together see least else than they ought to: |L a - B left|^2 + |R a - B right|^2
// is least, where L, R and B say what is seen through the left glass, the right one, and bare. Then each channel is scaled so
// that white stays white. Source: Dubois, "A projection method to generate anaglyph stereo images" (2001).
Mixing leastSquares() {
    const mat3 left = glm::transpose(throughRed), right = glm::transpose(throughCyan);
    const mat3 solve = glm::inverse(left * throughRed + right * throughCyan);
    Mixing mixing{solve * left * bare, solve * right * bare};
    const vec3 white = mixing.fromLeft * vec3(1) + mixing.fromRight * vec3(1);
    for (int column = 0; column < 3; ++column) {
        mixing.fromLeft[column] /= white;
        mixing.fromRight[column] /= white;
    }
    return mixing;
}

vec3 mixed(const Mixing& mixing, const vec3& left, const vec3& right) {
    return glm::clamp(mixing.fromLeft * left + mixing.fromRight * right, 0.0, 1.0);
}

// What a screen shows of the light that a glass lets through, as bright as it can be; with both eyes open, no glass.
mat3 seenThrough(Eyes eyes) {
    if (eyes != Eyes::left && eyes != Eyes::right) return mat3(1);
    const mat3 seen = linearFromXyz() * glassOf(eyes);
    const vec3 white = seen * vec3(1);
    return seen / std::max({white.r, white.g, white.b});
}

// How bright red, green and blue are through it, by the brightness of white: an eye gets used to a dark glass.
vec3 brightnessThrough(Eyes eyes) {
    const vec3 brightness = glm::transpose(glassOf(eyes))[1];
    return brightness / (brightness.r + brightness.g + brightness.b);
}

// How bright the channels of the other eye are for this one, by its own, in percent: what the glass ought to stop.
double crosstalk(Eyes eye) {
    const vec3 brightness = brightnessThrough(eye);
    const double cyan = brightness.g + brightness.b;
    return 100 * (eye == Eyes::left ? cyan / brightness.r : brightness.r / cyan);
}

}  // namespace mv::stereocube

// Which part of the light a smooth surface reflects, by Fresnel's equations: what shaders/include/fresnel.glsl computes in
// float, here in double. Light is unpolarized: the mean of both polarizations. Its directions are mv/math/reflect.h's
// to say.
//
// `cosine` is that of the angle between the light and the normal, 0..1; what is outside is refused, and NaN.
#pragma once
#include "mv/math/reflect.h"
#include "mv/math/types.h"

namespace mv {

// Parts of the energy that arrives, each computed from its own amplitudes; together 1.
struct Split {
    double reflected, transmitted;
};

// A surface of glass, water, air: `index` is that of what lies behind the surface over that of what lies before it. Below
// 1 there is total reflection, from sin(angle) = index on. The traps of the usual form: the cosine behind is the root of
// a negative number there, and with index 1 a grazing angle is 0/0; no surface reflects nothing.
// Refused: an index that is not above 0 and at most 1e150.
Split fresnel(double cosine, double index);

// A metal: its index n and its absorption k, which comes from the conductivity, at one wavelength; the complex index
// n + i k. Refused: n not above 0, k below 0.
double fresnelOfMetal(double cosine, double n, double k);

// The same at three wavelengths that stand for red, green and blue.
struct Metal {
    vec3 n, k;
};
// Measured at 617, 549 and 471 nm. Source: Johnson and Christy, "Optical constants of the noble metals", Physical Review B 6
// (1972), at 2.01, 2.26 and 2.63 eV.
inline const Metal gold{{0.21, 0.43, 1.31}, {3.272, 2.455, 1.849}};
inline const Metal copper{{0.30, 1.02, 1.25}, {3.205, 2.577, 2.483}};
vec3 fresnelOfMetal(double cosine, const Metal& metal);

// Schlick's curve from the part that is reflected head on: a fifth power in place of Fresnel's equations. Source: Schlick,
// "An inexpensive BRDF model for physically-based rendering" (1994).
double schlick(double cosine, double headOn);

// The material of a body's surface.
struct Coating {
    enum class Kind { mirror, metal, glass };
    Kind kind = Kind::mirror;
    Metal metal = gold;
    double index = 1.5;  // of the glass
    // The part of red, green and blue that is reflected: a mirror's is 1. Schlick's curve knows of no total reflection; where
    // there is no light behind, all is reflected by either. Refused: as fresnel().
    vec3 reflected(double cosine, bool bySchlick = false) const;
};

}  // namespace mv

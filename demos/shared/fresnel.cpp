#include "shared/fresnel.h"

#include <algorithm>
#include <cmath>

#include "mv/error.h"

namespace mv {
namespace {

void requireCosine(double cosine) {
    if (!(cosine >= 0 && cosine <= 1)) throw Error("fresnel", "the cosine must be 0 .. 1", numberText(cosine));
}
void requireIndex(double index) {
    if (!(index > 0 && index <= 1e150))
        throw Error("fresnel", "the index must be above 0, up to 1e150", numberText(index));
}

// index^2 cos^2 of the angle behind; not above 0 where there is no light behind. As a product, so that it is exactly the
// cosine's square for index 1.
double squareBehind(double cosine, double index) { return (index - 1) * (index + 1) + cosine * cosine; }

}  // namespace

Split fresnel(double cosine, double index) {
    requireCosine(cosine);
    requireIndex(index);
    if (index == 1) return {0, 1};
    const double square = squareBehind(cosine, index);
    if (square <= 0) return {1, 0};
    // Amplitudes a and b of both polarizations are (a - b) / (a + b) reflected; what passes is 4ab / (a + b)^2.
    const double behind = std::sqrt(square), dense = index * index * cosine;
    const auto split = [&](double a) {
        const double sum = a + behind, back = (a - behind) / sum;
        return Split{back * back, 4 * (a / sum) * (behind / sum)};
    };
    const Split across = split(cosine), along = split(dense);
    return {(across.reflected + along.reflected) / 2, (across.transmitted + along.transmitted) / 2};
}

double fresnelOfMetal(double cosine, double n, double k) {
    requireCosine(cosine);
    if (!(n > 0 && n < 1e6 && k >= 0 && k < 1e6))
        throw Error("fresnelOfMetal", "n must be above 0 and k 0 or more, both below 1e6");
    const double c2 = cosine * cosine, s2 = 1 - c2;
    const double real = n * n - k * k - s2;
    const double both = std::hypot(real, 2 * n * k);                 // a^2 + b^2, of a + ib = sqrt(index^2 - sin^2)
    const double a = std::sqrt(std::max(0.5 * (both + real), 0.0));  // rounding may leave -1e-17
    const double across = (both - 2 * a * cosine + c2) / (both + 2 * a * cosine + c2);
    const double along =
        across * (c2 * both - 2 * a * cosine * s2 + s2 * s2) / (c2 * both + 2 * a * cosine * s2 + s2 * s2);
    return (across + along) / 2;
}

vec3 fresnelOfMetal(double cosine, const Metal& metal) {
    return {fresnelOfMetal(cosine, metal.n.x, metal.k.x), fresnelOfMetal(cosine, metal.n.y, metal.k.y),
            fresnelOfMetal(cosine, metal.n.z, metal.k.z)};
}

double schlick(double cosine, double headOn) {
    requireCosine(cosine);
    return headOn + (1 - headOn) * std::pow(1 - cosine, 5);
}

vec3 Coating::reflected(double cosine, bool bySchlick) const {
    switch (kind) {
        case Kind::mirror:
            break;
        case Kind::metal: {
            if (!bySchlick) return fresnelOfMetal(cosine, metal);
            const vec3 headOn = fresnelOfMetal(1, metal);
            return {schlick(cosine, headOn.x), schlick(cosine, headOn.y), schlick(cosine, headOn.z)};
        }
        case Kind::glass: {
            const double exact = fresnel(cosine, index).reflected;
            return vec3(bySchlick && exact < 1 ? schlick(cosine, fresnel(1, index).reflected) : exact);
        }
    }
    return vec3(1);
}

}  // namespace mv

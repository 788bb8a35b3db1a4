#include "mv/math/color_difference.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "mv/error.h"
#include "mv/math/color.h"
#include "mv/math/require.h"
#include "mv/math/robust.h"

namespace mv {
namespace {

// X, Y and Z by those of white. As green and what red and blue differ from it, so that a grey's are the same number.
vec3 partsOfWhite(const vec3& linear) {
    static const std::array<vec2, 3> weights = [] {
        const mat3 m = xyzFromLinear();
        std::array<vec2, 3> rows;
        for (int i = 0; i < 3; ++i) rows.at(std::size_t(i)) = vec2(m[0][i], m[2][i]) / (m[0][i] + m[1][i] + m[2][i]);
        return rows;
    }();
    const vec2 apart(linear.r - linear.g, linear.b - linear.g);
    return {linear.g + glm::dot(weights[0], apart), linear.g + glm::dot(weights[1], apart),
            linear.g + glm::dot(weights[2], apart)};
}

constexpr double straightUpTo = 216.0 / 24389, steepness = 24389.0 / 27;

double power7(double x) {
    const double square = x * x;
    return square * square * square * x;
}
// sqrt(C^7 / (C^7 + 25^7)), how far a colour is from grey.
double vividness(double chroma) {
    const double seventh = power7(chroma / 25);
    return std::sqrt(seventh / (seventh + 1));
}

double hueOf(double a, double b) {
    if (a == 0 && b == 0) return 0;
    const double hue = degrees(std::atan2(b, a));
    return hue < 0 ? hue + 360 : hue;
}

// Half way between two hues, by the shorter way.
double middleHue(double one, double other) {
    const double sum = one + other;
    if (std::abs(one - other) <= 180) return sum / 2;
    return sum < 360 ? (sum + 360) / 2 : (sum - 360) / 2;
}

// A colour whose a* is stretched, which greys need.
struct Stretched {
    double a, b, chroma, hue;
};
Stretched stretched(const vec3& lab, double factor) {
    const double a = factor * lab.y;
    return {a, lab.z, std::hypot(a, lab.z), hueOf(a, lab.z)};
}

double square(double x) { return x * x; }

int hexDigit(char letter) {
    if (letter >= '0' && letter <= '9') return letter - '0';
    if (letter >= 'a' && letter <= 'f') return letter - 'a' + 10;
    if (letter >= 'A' && letter <= 'F') return letter - 'A' + 10;
    return -1;
}

double luminanceOf(const vec3& linear) {
    const double y = luminance(linear);
    if (y < -1e-9 || y > 1 + 1e-9) throw Error("contrast", "a luminance must be 0 to 1", numberText(y));
    return y;
}

}  // namespace

vec3 labFromLinear(const vec3& linear) {
    requireFinite("labFromLinear", "the light", linear);
    const vec3 part = partsOfWhite(linear);
    vec3 root;
    for (int i = 0; i < 3; ++i) {
        root[i] = part[i] > straightUpTo ? std::cbrt(part[i]) : (steepness * part[i] + 16) / 116;
    }
    const double lightness = part.y > straightUpTo ? 116 * root.y - 16 : steepness * part.y;
    return {lightness, 500 * (root.x - root.y), 200 * (root.y - root.z)};
}

double colorDifference(const vec3& lab, const vec3& other) {
    for (const vec3& one : {lab, other}) {
        requireFinite("colorDifference", "a colour", one);
        if (largestComponent(one) > 1e6) throw Error("colorDifference", "a colour must be within 1e6", vectorText(one));
    }
    const double meanChroma = (std::hypot(lab.y, lab.z) + std::hypot(other.y, other.z)) / 2;
    const double stretch = 1 + 0.5 * (1 - vividness(meanChroma));
    const Stretched one = stretched(lab, stretch), two = stretched(other, stretch);

    // Lightness, chroma and hue. C2 - C1 as a quotient of squares' difference; the turn from one hue to the other from their
    // cross and dot products, with the sign of h2 - h1 where it is half a turn.
    const double byLightness = other.x - lab.x, sum = one.chroma + two.chroma;
    const double squaresApart =
        stretch * stretch * (other.y - lab.y) * (other.y + lab.y) + (other.z - lab.z) * (other.z + lab.z);
    const double byChroma = sum == 0 ? 0 : squaresApart / sum;
    const double across = stretch * differenceOfProducts(lab.y, other.z, other.y, lab.z);
    const double along = one.a * two.a + one.b * two.b;
    double turn = across == 0 && along == 0 ? 0 : std::atan2(across, along);
    if (across == 0 && along < 0) turn = std::copysign(pi, two.hue - one.hue);
    const double byHue = 2 * std::sqrt(one.chroma * two.chroma) * std::sin(turn / 2);

    // The weight of each of them there
    const double lightness = (lab.x + other.x) / 2, chroma = sum / 2;
    const bool hasGrey = one.chroma == 0 || two.chroma == 0;
    const double hue = hasGrey ? one.hue + two.hue : middleHue(one.hue, two.hue);
    const auto cosine = [](double degrees) { return std::cos(radians(degrees)); };
    const double t =
        1 - 0.17 * cosine(hue - 30) + 0.24 * cosine(2 * hue) + 0.32 * cosine(3 * hue + 6) - 0.20 * cosine(4 * hue - 63);
    const double fromMiddle = square(lightness - 50);
    const double l = byLightness / (1 + 0.015 * fromMiddle / std::sqrt(20 + fromMiddle));
    const double c = byChroma / (1 + 0.045 * chroma);
    const double h = byHue / (1 + 0.015 * chroma * t);
    const double blue = 30 * std::exp(-square((hue - 275) / 25));
    const double rotation = -2 * vividness(chroma) * std::sin(radians(2 * blue));
    return std::sqrt(std::max(0.0, l * l + c * c + h * h + rotation * c * h));
}

double contrast(const vec3& linear, const vec3& other) {
    const auto [dark, bright] = std::minmax({luminanceOf(linear), luminanceOf(other)});
    return (bright + 0.05) / (dark + 0.05);
}

vec3 srgbFromHex(std::string_view text) {
    const bool isShort = text.size() == 4;
    const auto refuse = [&] { return Error("srgbFromHex", "a colour must be #rgb or #rrggbb", std::string(text)); };
    if ((!isShort && text.size() != 7) || text[0] != '#') throw refuse();
    vec3 srgb;
    for (int i = 0; i < 3; ++i) {
        const auto at = static_cast<std::size_t>(isShort ? 1 + i : 1 + 2 * i);
        const int high = hexDigit(text[at]), low = isShort ? high : hexDigit(text[at + 1]);
        if (high < 0 || low < 0) throw refuse();
        srgb[i] = (16 * high + low) / 255.0;
    }
    return srgb;
}

std::string hexFromSrgb(const vec3& srgb) {
    std::string text = "#";
    for (int i = 0; i < 3; ++i) {
        if (!(srgb[i] >= 0 && srgb[i] <= 1)) throw Error("hexFromSrgb", "components must be 0 to 1", vectorText(srgb));
        const auto byte = static_cast<unsigned>(std::lround(255 * srgb[i]));
        text += "0123456789abcdef"[byte / 16];
        text += "0123456789abcdef"[byte % 16];
    }
    return text;
}

}  // namespace mv

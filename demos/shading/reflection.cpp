#include "reflection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "mv/error.h"

namespace mv {
namespace {

double lobePower(double cosine, double exponent) { return cosine > 0 ? std::pow(cosine, exponent) : 0; }

double phong(const vec3& n, const vec3& l, const vec3& v, double exponent) {
    return lobePower(glm::dot(2 * glm::dot(n, l) * n - l, v), exponent);
}

double blinn(const vec3& n, const vec3& l, const vec3& v, double exponent) {
    const vec3 both = l + v;
    return glm::dot(both, both) > 0 ? lobePower(glm::dot(n, glm::normalize(both)), exponent) : 0;
}

double brushed(const vec3& n, const vec3& l, const vec3& v, double exponent) {
    const vec3 round(n.z, 0, -n.x);
    const vec3 t = glm::dot(round, round) > 0 ? glm::normalize(round) : vec3(1, 0, 0);
    const double alongL = glm::dot(l, t), alongV = glm::dot(v, t);
    const auto across = [](double along) { return std::sqrt(std::max(1 - along * along, 0.0)); };
    return lobePower(across(alongL) * across(alongV) - alongL * alongV, exponent) * std::max(glm::dot(n, l), 0.0);
}

// The sum of a highlight over the directions above the surface. The sum takes rings about the mirrored direction, whose
// radii grow as the square of their number, so that the rings of a narrow highlight are narrow. Half of each ring is enough: the other
// half is its mirror image.
double sumOf(Lobe lobe, double exponent, double angle) {
    constexpr int rings = 128, parts = 16;
    const vec3 n(0, 0, 1), l(-std::sin(radians(angle)), 0, std::cos(radians(angle)));
    const vec3 mirrored(-l.x, 0, l.z), side(0, 1, 0), third = glm::cross(side, mirrored);
    std::array<vec3, parts> ways;
    for (int j = 0; j < parts; ++j) {
        const double turn = pi * (j + 0.5) / parts;
        ways[std::size_t(j)] = std::cos(turn) * third + std::sin(turn) * side;
    }
    double sum = 0;
    for (int i = 0; i < rings; ++i) {
        const double part = (i + 0.5) / rings, away = pi * part * part, width = 2 * pi * part / rings;
        const vec3 middle = std::cos(away) * mirrored;
        const double radius = std::sin(away), area = radius * width * 2 * pi / parts;
        for (const vec3& way : ways) {
            const vec3 v = middle + radius * way;
            if (v.z > 0) sum += highlight(lobe, n, l, v, exponent) * area;
        }
    }
    return sum;
}

}  // namespace

double highlight(Lobe lobe, const vec3& n, const vec3& l, const vec3& v, double exponent) {
    if (glm::dot(n, l) <= 0) return 0;
    switch (lobe) {
        case Lobe::phong:
            return phong(n, l, v, exponent);
        case Lobe::blinn:
            return blinn(n, l, v, exponent);
        case Lobe::brushed:
            return brushed(n, l, v, exponent);
    }
    throw Error("highlight", "must be of a known lobe");
}

double reflectance(Lobe lobe, const vec3& n, const vec3& l, const vec3& v, double exponent) {
    const double cosine = glm::dot(n, l);
    return cosine > 0 ? highlight(lobe, n, l, v, exponent) / cosine : HUGE_VAL;
}

double matchingExponent(double exponent, double angle) {
    if (!(exponent >= 1 && exponent <= 1000))
        throw Error("matchingExponent", "the exponent must be 1 to 1000", numberText(exponent));
    if (!(angle >= 0 && angle <= 80)) throw Error("matchingExponent", "the angle must be 0 to 80", numberText(angle));
    const double wanted = sumOf(Lobe::phong, exponent, angle);
    // Blinn's sum falls as its exponent grows: halve the bracket, in factors.
    double low = exponent / 4, high = 16 * exponent;
    for (int i = 0; i < 20; ++i) {
        const double middle = std::sqrt(low * high);
        (sumOf(Lobe::blinn, middle, angle) > wanted ? low : high) = middle;
    }
    return std::sqrt(low * high);
}

}  // namespace mv

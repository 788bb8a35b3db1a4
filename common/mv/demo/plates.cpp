#include "mv/demo/plates.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include "mv/error.h"

namespace mv {
namespace {

struct Met {
    double nearness;  // 1 / distance along -z
    vec3 color;
};

std::optional<vec3> laidOver(const vec3& background, std::vector<Met> met, double opacity) {
    std::sort(met.begin(), met.end(), [](const Met& a, const Met& b) { return a.nearness < b.nearness; });
    vec3 color = background;
    for (std::size_t i = 0; i < met.size(); ++i) {
        if (i > 0 && met[i].nearness - met[i - 1].nearness <= 1e-12 * met[i].nearness) return {};
        color = glm::mix(color, met[i].color, opacity);
    }
    return color;
}

}  // namespace

std::vector<std::optional<vec3>> colorsByRays(std::span<const Plate> plates, const PlateView& view) {
    // The ray d (x, y, -1) meets the plate where M (x', y', 0, 1) is; with M's third column left out, the inverse takes
    // (x, y, -1) to (x', y', 1) / d.
    std::vector<mat3> plateFromRay;
    for (const Plate& plate : plates) {
        const mat4& m = plate.viewFromPlate;
        plateFromRay.push_back(glm::inverse(mat3(vec3(m[0]), vec3(m[1]), vec3(m[3]))));
    }
    std::vector<std::optional<vec3>> colors;
    colors.reserve(static_cast<std::size_t>(view.width) * static_cast<std::size_t>(view.height));
    std::vector<Met> met;
    for (int row = 0; row < view.height; ++row) {
        for (int column = 0; column < view.width; ++column) {
            const vec2 ndc((2 * column + 1.0) / view.width - 1, 1 - (2 * row + 1.0) / view.height);
            const vec3 ray(view.tangents * ndc, -1);
            met.clear();
            for (std::size_t i = 0; i < plates.size(); ++i) {
                const vec3 hit = plateFromRay[i] * ray;
                const double along = hit.x / hit.z, across = std::abs(hit.y / hit.z);
                // Said so that it also fails where the plate is edge-on and nothing is a number
                const bool seen = hit.z > 1 / view.far && hit.z < 1 / view.near && along > 0 && along < 1;
                if (seen && across < 0.5) met.push_back({hit.z, (across > plateRim ? 0.7 : 1.0) * plates[i].color});
            }
            colors.push_back(laidOver(view.background, met, view.opacity));
        }
    }
    return colors;
}

std::optional<double> wrongPart(const Picture& picture, const std::vector<std::optional<vec3>>& colors) {
    const auto width = static_cast<std::size_t>(picture.width), height = static_cast<std::size_t>(picture.height);
    if (colors.size() != width * height) {
        throw Error("colors", "must be one for each pixel of the picture, " + std::to_string(width * height),
                    std::to_string(colors.size()));
    }
    long asked = 0, wrong = 0;
    for (int y = 1; y + 1 < picture.height; ++y) {
        for (int x = 1; x + 1 < picture.width; ++x) {
            const auto at = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x);
            const std::optional<vec3>& color = colors[at];
            if (!color || colors[at - 1] != color || colors[at + 1] != color || colors[at - width] != color ||
                colors[at + width] != color) {
                continue;
            }
            const Pixel seen = picture.at(x, y);
            const vec3 off = glm::abs(vec3(seen.red, seen.green, seen.blue) - 255.0 * *color);
            ++asked;
            wrong += std::max({off.r, off.g, off.b}) > 2 ? 1 : 0;
        }
    }
    if (asked == 0) return {};
    return double(wrong) / double(asked);
}

}  // namespace mv

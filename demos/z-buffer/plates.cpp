#include "plates.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include "mv/error.h"
#include "mv/math/transform.h"

namespace mv {
namespace {

const vec3 red(0.9, 0.33, 0.24), green(0.36, 0.68, 0.36), blue(0.28, 0.47, 0.85);

struct Met {
    double nearness;  // 1 / distance along -z
    vec3 color;
};

std::optional<vec3> laidOver(const vec3& background, std::vector<Met> met, double opacity) {
    std::ranges::sort(met, [](const Met& a, const Met& b) { return a.nearness < b.nearness; });
    vec3 color = background;
    for (std::size_t i = 0; i < met.size(); ++i) {
        if (i > 0 && met[i].nearness - met[i - 1].nearness <= 1e-12 * met[i].nearness) return {};
        color = glm::mix(color, met[i].color, opacity);
    }
    return color;
}

}  // namespace

std::array<Plate, 3> barsInACycle(const mat4& viewFromBars) {
    // Along a side of a triangle, its right end tilted towards the eye
    const mat4 side = translate(0, -0.75, 0) * rotateY(-18) * scale(3.5, 0.62, 1) * translate(-0.5, 0, 0);
    return {{{red, viewFromBars * side},
             {green, viewFromBars * rotateZ(120) * side},
             {blue, viewFromBars * rotateZ(240) * side}}};
}

std::array<Plate, 3> panes(const mat4& viewFromPanes, double step) {
    const mat4 square = scale(2.2, 2.2, 1) * translate(-0.5, 0, 0);
    return {{{red, viewFromPanes * translate(-0.55, 0.4, 0) * square},
             {green, viewFromPanes * translate(0, 0, -step) * square},
             {blue, viewFromPanes * translate(0.55, -0.4, -2 * step) * square}}};
}

std::array<Plate, 3> roadOnGround(double far, double separation) {
    const mat4 down = rotateZ(-12) * rotateX(18);  // the eye looks down on it, the head a little on one side
    const auto below = [&](double height, double width) {
        return down * translate(0, -height, 0) * rotateX(-90) * rotateZ(90) * scale(far, width, 1);
    };
    const double next = 1 + separation;
    return {{{red, below(1, 0.12)}, {green, below(next * next, 100)}, {blue, below(next, 1.6)}}};
}

MeshData plateMesh(std::span<const double> cuts) {
    MeshData cells;
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        const auto a = float(cuts[i]), b = float(cuts[i + 1]);
        for (const fvec2& corner : {fvec2(a, -0.5), {b, -0.5}, {b, 0.5}, {a, -0.5}, {b, 0.5}, {a, 0.5}})
            cells.positions.emplace_back(corner, 0);
    }
    return cells;
}

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
                // Written so that the test also fails where the plate is edge-on and the values are NaN
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
            const std::size_t at = pixelIndex(x, y, picture.width);
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

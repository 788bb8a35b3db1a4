#include "street.h"

#include <string>
#include <utility>
#include <vector>

#include "mv/geometry/shapes.h"
#include "mv/math/transform.h"

namespace mv {

Scene figureInStreet() {
    Scene street;
    const auto add = [&](const std::string& name, MeshData mesh, const vec3& color) {
        street.objects.push_back({.name = name, .mesh = std::move(mesh), .color = color});
    };
    add("ground", grid(1, 1, 400, 400), {0.76, 0.80, 0.68});
    for (int row = 0; row < 6; ++row) {
        const double z = -38 + 6 * row;
        for (const double x : {-11.0, 11.0, -5.5, 5.5}) {
            add("column", box({x - 0.5, 0, z - 0.5}, {x + 0.5, 4, z + 0.5}),
                {0.35 + 0.08 * row, 0.55, 0.75 - 0.08 * row});
        }
        if (row != 2) continue;  // the house stands between two rows
        const double front = -doorBehindFigure;
        add("house", box({-4, 0, front - 5.4}, {4, 5, front - 0.1}), {0.93, 0.87, 0.70});
        add("door", box({-1, 0, front - 0.1}, {1, doorHeight, front}), {0.45, 0.32, 0.22});
        for (const double x : {-2.6, 2.6}) {
            add("window", box({x - 0.8, 1.5, front - 0.1}, {x + 0.8, 3.5, front}), {0.45, 0.60, 0.75});
        }
    }
    // The camera looks from below the plane between them
    add("head", sphere(0.35, 32, 16), {0.95, 0.75, 0.6});
    street.objects.back().worldFromObject = translate(0, figureHeight - 0.35, 0);
    add("body", lathe(std::vector<vec2>{{0, 0}, {0.45, 0}, {0.15, 1.25}, {0, 1.3}}, 32), {0.85, 0.3, 0.2});
    return street;
}

}  // namespace mv

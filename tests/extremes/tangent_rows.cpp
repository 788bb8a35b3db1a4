// X48, X49, X51: normals that cancel, tangents of texture coordinates without area, and coordinates of 1e6 and 1e7.
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/geometry/tangent_frame.h"

using namespace mv;
using namespace mv::test;

namespace {

using Corners = std::array<vec3, 3>;
using Coords = std::array<vec2, 3>;

const Corners points{vec3(0.2, 0.1, 0), vec3(1.3, 0.4, 0.3), vec3(0, 1.1, 0.5)};

// The usual form: divided by the area in the texture, and the bitangent made from it without a sign.
TangentFrame plainFrame(const Corners& p, const Coords& t) {
    const vec3 first = p[1] - p[0], second = p[2] - p[0], normal = glm::normalize(glm::cross(first, second));
    const vec2 a = t[1] - t[0], b = t[2] - t[0];
    const vec3 tangent = glm::normalize((b.y * first - a.y * second) / (a.x * b.y - b.x * a.y));
    return {tangent, glm::cross(normal, tangent), normal, 1};
}

// The largest element of F^T F - I.
double offOrthogonal(const TangentFrame& frame) {
    const std::array<vec3, 3> axes{frame.tangent, frame.bitangent, frame.normal};
    double worst = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t k = 0; k < 3; ++k)
            worst = worse(worst, std::abs(glm::dot(axes.at(i), axes.at(k)) - (i == k ? 1 : 0)));
    }
    return worst;
}

[[maybe_unused]] const bool x48 = addRow([] {
    // Two faces of a thin plate share a smooth edge; in its middle their normals cancel.
    const vec3 up(0, 1, 0), right(1, 0, 0), weights(0.5, 0.5, 0);
    const std::array<vec3, 3> normals{right, -right, up};
    const vec3 sum = 0.5 * normals[0] + 0.5 * normals[1];
    return Row{.id = "X48",
               .input = "the middle between two corners whose normals are opposite",
               .measured = "how far the normal's length is from 1",
               .naive = "normalize(sum)",
               .naiveError = worse(0, std::abs(glm::length(glm::normalize(sum)) - 1)),
               .ours = "shadingNormal: the face's where they cancel",
               .ourError = worse(0, std::abs(glm::length(shadingNormal(normals, weights, up)) - 1)),
               .tolerance = 1e-15,
               .reason = "some roundings of a unit vector"};
});

[[maybe_unused]] const bool x49equal = addRow([] {
    const Coords equal{vec2(0.5), vec2(0.5), vec2(0.5)};
    return Row{.id = "X49 equal",
               .input = "a triangle whose texture coordinates are all equal",
               .measured = "largest element of F^T F - I of its tangent frame F",
               .naive = "edges weighed by texture coordinates, by the area in the texture",
               .naiveError = offOrthogonal(plainFrame(points, equal)),
               .ours = "tangentFrame: any tangent across the normal",
               .ourError = offOrthogonal(tangentFrame(points, equal)),
               .tolerance = 2e-15,
               .reason = "some roundings of unit vectors"};
});

[[maybe_unused]] const bool x49mirrored = addRow([] {
    const Coords mirrored{vec2(1, 0), vec2(0, 0), vec2(1, 1)};
    // The direction in which v grows: by the affine map, the part of it across the tangent.
    const vec3 alongV = points[2] - points[0];
    const auto turnedAway = [&](const TangentFrame& frame) {
        return glm::dot(frame.bitangent, alongV - glm::dot(alongV, frame.tangent) * frame.tangent) > 0 ? 0.0 : 1.0;
    };
    return Row{.id = "X49 mirrored",
               .input = "a triangle whose texture is mirrored",
               .measured = "1 where the bitangent runs against v",
               .naive = "bitangent = cross(normal, tangent)",
               .naiveError = turnedAway(plainFrame(points, mirrored)),
               .ours = "tangentFrame: with the sign of the area in the texture",
               .ourError = turnedAway(tangentFrame(points, mirrored)),
               .tolerance = 0,
               .reason = "a direction, or the opposite one"};
});

Row farRow(const char* id, const char* input, double whole) {
    double naive = 0, ours = 0;
    constexpr double texels = 256;
    for (int i = 0; i < 1000; ++i) {
        const double rest = (i + 0.5) / 1000;
        const auto rounded = static_cast<float>(whole + rest);
        naive = worse(naive, texels * std::abs(double(rounded) - std::floor(double(rounded)) - rest));
        ours = worse(ours, texels * std::abs(double(repeatedCoordinate(whole + rest)) - rest));
    }
    return Row{.id = id,
               .input = input,
               .measured = "how far the texel is from the true one (texels of 256)",
               .naive = "float, then fract",
               .naiveError = naive,
               .ours = "repeatedCoordinate: fract in double, then float",
               .ourError = ours,
               .tolerance = 1e-5,
               .reason = "of 256 texels, half a step of floats below 1 is 7.6e-6"};
}

[[maybe_unused]] const bool x51million =
    addRow([] { return farRow("X51 1e6", "texture coordinates beyond 1e6 in a texture that repeats", 1e6); });
[[maybe_unused]] const bool x51tenMillion =
    addRow([] { return farRow("X51 1e7", "texture coordinates beyond 1e7 in a texture that repeats", 1e7); });

}  // namespace

#include "shared/own_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "mv/error.h"
#include "mv/math/color.h"

namespace mv {
namespace {

// Which of `from` pixels along a side a texel of `to` covers, and how much of each: parts of the texel, together 1.
struct Cover {
    int first;
    std::vector<double> parts;
};
std::vector<Cover> covers(int from, int to) {
    std::vector<Cover> all;
    const double width = double(from) / to;
    for (int i = 0; i < to; ++i) {
        const double low = i * width, high = (i + 1) * width;
        Cover cover{std::min(static_cast<int>(low), from - 1), {}};
        for (int pixel = cover.first; pixel < from && (pixel < high || cover.parts.empty()); ++pixel) {
            const double part = (std::min(high, pixel + 1.0) - std::max(low, double(pixel))) / width;
            cover.parts.push_back(std::max(part, 0.0));
        }
        all.push_back(std::move(cover));
    }
    return all;
}

// The value of a byte that is averaged.
using Meaning = std::array<double, 256>;

// Means over the texels' areas, lower row first, alpha 1.
FloatPicture resampled(const Picture& picture, int width, int height, const Meaning& meaning) {
    checkPicture(picture, "own picture");
    FloatPicture made(width, height, 4);
    const std::vector<Cover> across = covers(picture.width, width), down = covers(picture.height, height);
    std::vector<vec3> row(static_cast<std::size_t>(width));
    for (int y = 0; y < height; ++y) {
        std::fill(row.begin(), row.end(), vec3(0));
        const Cover& rows = down[static_cast<std::size_t>(y)];
        for (std::size_t j = 0; j < rows.parts.size(); ++j) {
            const std::uint8_t* const pixels =
                &picture.rgba[4 * pixelIndex(0, rows.first + static_cast<int>(j), picture.width)];
            for (std::size_t x = 0; x < row.size(); ++x) {
                const Cover& columns = across[x];
                const std::uint8_t* pixel = pixels + std::ptrdiff_t{4} * columns.first;
                vec3 sum(0);
                for (const double part : columns.parts) {
                    sum += part * vec3(meaning[pixel[0]], meaning[pixel[1]], meaning[pixel[2]]);
                    pixel += 4;
                }
                row[x] += rows.parts[j] * sum;
            }
        }
        for (int x = 0; x < width; ++x) {
            float* const texel = &made.values[4 * pixelIndex(x, height - 1 - y, width)];
            for (int c = 0; c < 3; ++c) texel[c] = static_cast<float>(row[static_cast<std::size_t>(x)][c]);
            texel[3] = 1;
        }
    }
    return made;
}

Meaning meaningOf(double (*of)(double)) {
    Meaning meaning{};
    for (std::size_t i = 0; i < meaning.size(); ++i) meaning[i] = of(double(i) / 255);
    return meaning;
}

vec3 pixelAt(const Picture& picture, int x, int y) {
    const Pixel pixel = picture.at(x, y);
    return vec3(pixel.red, pixel.green, pixel.blue) / 255.0;
}

// Between the four pixels around a place, of a part of the picture that begins at (left, top). Beyond its edges is what is at
// them, or from left to right what is at the other edge.
vec3 between(const Picture& picture, int left, int top, int width, int height, const vec2& place, bool goesRound) {
    const double x = place.x - 0.5, y = std::clamp(place.y - 0.5, 0.0, height - 1.0);
    const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(y);
    const auto at = [&](int i, int j) {
        i = goesRound ? (i % width + width) % width : std::clamp(i, 0, width - 1);
        return pixelAt(picture, left + i, top + std::min(j, height - 1));
    };
    const double across = x - column, down = y - row;
    return glm::mix(glm::mix(at(column, row), at(column + 1, row), across),
                    glm::mix(at(column, row + 1), at(column + 1, row + 1), across), down);
}

vec3 inPanorama(const Picture& picture, const vec3& direction) {
    const vec3 way = glm::normalize(direction);
    const double around = 0.5 + std::atan2(way.x, -way.z) / (2 * pi),
                 down = std::acos(std::clamp(way.y, -1.0, 1.0)) / pi;
    return between(picture, 0, 0, picture.width, picture.height, {around * picture.width, down * picture.height}, true);
}

vec3 inFaces(const Picture& picture, const vec3& direction) {
    const vec3 size = glm::abs(direction);
    const vec3 way = direction / std::max({size.x, size.y, size.z});
    // The cell of the cross, and the place in it from its middle, to the right and up: -1..1
    int column = 1, row = 1;
    vec2 place(0);
    if (size.y >= size.x && size.y >= size.z) {
        row = way.y > 0 ? 0 : 2;
        place = vec2(way.x, way.y > 0 ? way.z : -way.z);
    } else if (size.x >= size.z) {
        column = way.x < 0 ? 0 : 2;
        place = vec2(way.x < 0 ? -way.z : way.z, way.y);
    } else {
        column = way.z < 0 ? 1 : 3;
        place = vec2(way.z < 0 ? way.x : -way.x, way.y);
    }
    const int side = picture.width / 4;
    return between(picture, column * side, row * side, side, side, 0.5 * side * vec2(1 + place.x, 1 - place.y), false);
}

// Whether the six squares of a cut cube that are no faces have one colour, to a twentieth of their pixels and what JPEG makes of it.
// Any photograph of 4 : 3 would do else.
bool isEmptyBesideFaces(const Picture& picture) {
    const int side = picture.width / 4;
    const Pixel first = picture.at(0, 0);
    long others = 0;
    for (int y = 0; y < picture.height; ++y) {
        if (y / side == 1) continue;
        for (int x = 0; x < picture.width; ++x) {
            const Pixel pixel = picture.at(x, y);
            const int most = std::max({std::abs(pixel.red - first.red), std::abs(pixel.green - first.green),
                                       std::abs(pixel.blue - first.blue)});
            if (x / side != 1 && most > 24) ++others;
        }
    }
    return others * 20 < 6L * side * side;
}

}  // namespace

FloatPicture ownTexels(const Picture& picture, int width, int height) {
    static const Meaning light = meaningOf(linearFromSrgb);
    return resampled(picture, width, height, light);
}

FloatPicture ownHeights(const Picture& picture, int width, int height) {
    static const Meaning stored = meaningOf([](double value) { return value; });
    FloatPicture heights = resampled(picture, width, height, stored);
    for (std::size_t i = 0; i < heights.values.size(); i += 4) {
        float* const texel = &heights.values[i];
        texel[3] = static_cast<float>(luminance(vec3(texel[0], texel[1], texel[2])));
        for (int c = 0; c < 3; ++c) texel[c] = 0.5F;
    }
    return heights;
}

Surrounding surroundingOf(const Picture& picture, const char* subject) {
    if (picture.width == 2 * picture.height) return Surrounding::panorama;
    const bool hasSquares = picture.width % 4 == 0 && 3 * picture.width == 4 * picture.height;
    if (hasSquares && isEmptyBesideFaces(picture)) return Surrounding::faces;
    throw Error(
        subject,
        "must be a panorama, twice as wide as high, or a cube cut open into 4 x 3 squares, as assets/evening.png "
        "and assets/evening-faces.png are",
        std::to_string(picture.width) + " x " + std::to_string(picture.height) +
            (hasSquares ? " with something in squares that no face has" : ""));
}

std::array<FloatPicture, cubeFaces> ownCube(const Picture& picture, int size) {
    const bool isPanorama = surroundingOf(picture, "own picture") == Surrounding::panorama;
    // As many pixels all round as the cube has texels; of faces by whole parts, so that none gets pixels of its neighbour
    const int side = picture.width / 4;
    int parts = std::max(1, side / size);
    while (!isPanorama && side % parts != 0) --parts;
    const Picture shown = shrink(picture, picture.width / parts, std::max(1, picture.height / parts));
    std::array<FloatPicture, cubeFaces> faces;
    for (int face = 0; face < cubeFaces; ++face) {
        FloatPicture made(size, size, 4);
        for (int row = 0; row < size; ++row) {
            for (int column = 0; column < size; ++column) {
                const vec3 way = cubeDirection({face, (vec2(column, row) + 0.5) / double(size)});
                const vec3 color = isPanorama ? inPanorama(shown, way) : inFaces(shown, way);
                float* const texel = &made.values[4 * pixelIndex(column, row, size)];
                for (int c = 0; c < 3; ++c) texel[c] = static_cast<float>(color[c]);
                texel[3] = 1;
            }
        }
        faces.at(static_cast<std::size_t>(face)) = std::move(made);
    }
    return faces;
}

}  // namespace mv

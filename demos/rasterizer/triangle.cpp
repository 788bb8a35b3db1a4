// Triangles: the pixels whose middles lie on the inner side of all three edges (shared/raster_triangle.h), or the mean of more
// points of each pixel.
#include <algorithm>
#include <cmath>

#include "mv/formatted.h"
#include "samples.h"
#include "sheet.h"
#include "trials.h"

namespace mv::rasterizer {
namespace {

const std::array<vec3, 4> cornerColors{vec3(0.9, 0.25, 0.15), vec3(0.2, 0.7, 0.25), vec3(0.15, 0.35, 0.85),
                                       vec3(0.95, 0.8, 0.2)};
const std::array<double, 4> cornerW{1, 1, 4, 4};

int trianglesOf(const Triangles& s) { return s.neighbour ? 2 : 1; }
// Which of the corners triangle 0 and triangle 1 have.
std::array<std::size_t, 3> cornersOf(int which) { return {0, which == 0 ? 1U : 2U, which == 0 ? 2U : 3U}; }
std::array<vec2, 3> triangle(int which, const Corners& corners, const Grid& grid) {
    const auto at = cornersOf(which);
    return {grid.scale * corners.at(at[0]), grid.scale * corners.at(at[1]), grid.scale * corners.at(at[2])};
}

std::vector<Covered> covered(const Triangles& s, const Corners& corners, const Grid& grid,
                             const vec2& place = vec2(0.5)) {
    std::vector<Covered> all;
    for (int which = 0; which < trianglesOf(s); ++which)
        all.push_back(coveredPixels(movedToMiddle(triangle(which, corners, grid), place), grid.columns, grid.rows,
                                    s.method, s.rule));
    return all;
}

int placesOf(const Triangles& s) { return s.edges == Edges::hard ? 1 : s.places; }

// The colour of a triangle's pixel: a mean of its corners', weighted by where the pixel's middle is.
Pixel colorAt(const PixelStep& pixel, int which, const Triangles& s, const Corners& corners, const Grid& grid) {
    if (s.shade == Shade::flat) return which == 0 ? first : second;
    const auto at = cornersOf(which);
    vec3 weights = cornerWeights(triangle(which, corners, grid), {pixel.x + 0.5, pixel.y + 0.5});
    if (s.shade == Shade::surface)
        weights = perspectiveWeights(weights, {cornerW.at(at[0]), cornerW.at(at[1]), cornerW.at(at[2])});
    return pixelOf(weights.x * cornerColors.at(at[0]) + weights.y * cornerColors.at(at[1]) +
                   weights.z * cornerColors.at(at[2]));
}

Picture pictureOf(const std::vector<Covered>& all, const Triangles& s, const Corners& corners, const Grid& grid) {
    Picture shown = paperOf(grid);
    PixelMap times(grid.columns, grid.rows);
    std::size_t count = 0;
    for (const Covered& one : all) count += one.pixels.size();
    std::size_t left = grid.made(count);
    for (std::size_t which = 0; which < all.size(); ++which) {
        for (const PixelStep& pixel : all[which].pixels) {
            if (left == 0) return shown;
            --left;
            if (!times.holds(pixel.x, pixel.y)) continue;
            const bool twice = times.at(pixel.x, pixel.y)++ > 0;
            shown.set(pixel.x, grid.rows - 1 - pixel.y,
                      twice ? both : colorAt(pixel, static_cast<int>(which), s, corners, grid));
        }
    }
    return shown;
}

// The mean of the pictures for each place of a pixel that is asked. A triangle's colour is asked for once a pixel, at its middle.
Picture sampledPicture(const Triangles& s, const Corners& corners, const Grid& grid) {
    Picture mean(grid.columns, grid.rows);
    std::vector<int> sums(mean.rgba.size(), 0);
    const std::vector<vec2> places = samplePlaces(placesOf(s));
    for (const vec2& place : places) {
        const Picture one = pictureOf(covered(s, corners, grid, place), s, corners, grid);
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += one.rgba[i];
    }
    const auto count = static_cast<int>(places.size());
    for (std::size_t i = 0; i < sums.size(); ++i)
        mean.rgba[i] = static_cast<std::uint8_t>((sums[i] + count / 2) / count);
    return mean;
}

// The pixels that an edge of a triangle crosses, and how far the share that the places tell is from the exact one, there.
struct EdgePixels {
    std::vector<vec2> pixels;
    double rms = 0;
};
EdgePixels edgePixels(const Triangles& s, const Corners& corners, const Grid& grid) {
    EdgePixels found;
    const auto columns = static_cast<std::size_t>(grid.columns);
    for (int which = 0; which < trianglesOf(s); ++which) {
        const std::array<vec2, 3> one = triangle(which, corners, grid);
        const std::vector<double> exact = exactShares(one, grid.columns, grid.rows),
                                  told = sharesByPlaces(one, placesOf(s), grid.columns, grid.rows);
        for (std::size_t i = 0; i < exact.size(); ++i) {
            if (exact[i] <= 0 || exact[i] >= 1 - 1e-12) continue;  // but for the area's own rounding
            found.pixels.emplace_back(i % columns, i / columns);
            found.rms += (told[i] - exact[i]) * (told[i] - exact[i]);
        }
    }
    found.rms = std::sqrt(found.rms / double(std::max<std::size_t>(1, found.pixels.size())));
    return found;
}

MeshData meshOf(const Triangles& s, const Corners& corners, const Grid& grid) {
    MeshData data{.primitive = Primitive::triangles};
    for (int which = 0; which < trianglesOf(s); ++which) {
        const auto points = triangle(which, corners, grid);
        const auto at = cornersOf(which);
        for (std::size_t i = 0; i < 3; ++i) {
            const double w = s.shade == Shade::surface ? cornerW.at(at.at(i)) : 1;
            data.positions.emplace_back(points.at(i).x, points.at(i).y, w);
            data.colors.emplace_back(
                fvec3(s.shade == Shade::flat ? colorOf(which == 0 ? first : second) : cornerColors.at(at.at(i))), 1);
        }
    }
    return data;
}

// The pixels that both of two triangles set, and those that neither sets though the right rule gives them to one.
struct Shared {
    int doubles = 0, holes = 0;
};
Shared shared(const std::vector<Covered>& all, const Corners& corners, const Grid& grid) {
    PixelMap map(grid.columns, grid.rows);
    for (const Covered& one : all) {
        for (const PixelStep& pixel : one.pixels) ++map.at(pixel.x, pixel.y);
    }
    Shared shared{.doubles = static_cast<int>(std::count(map.colors.begin(), map.colors.end(), 2))};
    for (int which : {0, 1}) {
        for (const PixelStep& pixel :
             coveredPixels(triangle(which, corners, grid), grid.columns, grid.rows, FillMethod::box).pixels)
            shared.holes += map.at(pixel.x, pixel.y) == 0;
    }
    return shared;
}

}  // namespace

std::size_t countTriangles(const Triangles& s, const Corners& corners, const Grid& grid) {
    std::size_t count = 0;
    for (const Covered& one : covered(s, corners, grid)) count += one.pixels.size();
    return count;
}

static void showSampled(Gpu& gpu, const Settings& s, const Grid& grid, const Frame& frame) {
    const EdgePixels edges = edgePixels(s.triangles, s.corners, grid);
    const std::vector<vec2> places = samplePlaces(placesOf(s.triangles));
    showPlaces(gpu, edges.pixels, places, grid, frame);
    showWords(
        gpu, frame, grid,
        "places a pixel: " + std::to_string(places.size()) + formatted("; shares at edges off by %.2f", edges.rms),
        "OpenGL, samples a pixel: " + std::to_string(places.size()));
}

void drawTriangles(Gpu& gpu, const Settings& s, const Grid& grid, const Frame& frame) {
    const Triangles& triangles = s.triangles;
    const Corners& corners = s.corners;
    const std::vector<Covered> all = covered(triangles, corners, grid);
    const int places = placesOf(triangles), samples = places == 1 ? 0 : places;
    const Picture mine = sampledPicture(triangles, corners, grid),
                  glPicture = byOpenGl(gpu, meshOf(triangles, corners, grid), grid, frame, samples);
    Shape shape{{{corners[0], corners[2]}, {corners.begin(), corners.end()}}};
    shape.lines.back().push_back(corners.front());
    showPictures(gpu, frame, grid, mine, glPicture, shape);
    if (triangles.edges == Edges::sampled) return showSampled(gpu, s, grid, frame);

    std::size_t count = 0;
    for (const Covered& one : all) count += one.pixels.size();
    std::optional<std::pair<std::string, vec4>> more;
    if (triangles.neighbour) {
        const Shared found = shared(all, corners, grid);
        more = {std::to_string(found.doubles) + " pixels twice, " + std::to_string(found.holes) + " holes",
                found.doubles + found.holes > 0 ? red : ink};
    }
    showWords(gpu, frame, grid,
              std::string(nameOf(triangles.method)) + ", " + nameOf(triangles.rule) + ": " + countOf(grid, count),
              formatted("OpenGL: pixels set otherwise: %.0f",
                        double(countDifferent(pictureOf(all, triangles, corners, grid.allSet()), glPicture))),
              more);
}

void readTriangles(const Gpu& gpu, const Triangles& s, const Corners& corners, const Grid& grid, Numbers& numbers) {
    const std::vector<Covered> all = covered(s, corners, grid);
    double count = 0, asked = 0;
    for (const Covered& one : all) {
        count += double(one.pixels.size());
        asked += double(one.asked);
    }
    numbers.set("set", count);
    numbers.set("asked", asked);
    numbers.set("differs", double(countDifferent(sampledPicture(s, corners, grid.allSet()), gpu.glPicture)));
    numbers.set("edge-error", edgePixels(s, corners, grid).rms);
    if (!s.neighbour) return;
    const Shared found = shared(all, corners, grid);
    numbers.set("doubles", found.doubles);
    numbers.set("holes", found.holes);
}

}  // namespace mv::rasterizer

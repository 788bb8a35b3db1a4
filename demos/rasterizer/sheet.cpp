#include "sheet.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>

#include "mv/formatted.h"
#include "mv/gl/functions.h"
#include "mv/gl/text.h"
#include "mv/gl/word_size.h"

namespace mv::rasterizer {

Grid::Grid(const Settings& s) : columns(s.cells), rows(s.cells * 3 / 4), step(s.step), scale(s.cells / 24.0) {}
int Grid::whole(double coordinate) const { return static_cast<int>(std::floor(coordinate * scale)); }
Grid Grid::allSet() const {
    Grid all = *this;
    all.step = allSteps;
    return all;
}
std::size_t Grid::made(std::size_t all) const {
    return step == allSteps ? all : std::min(all, static_cast<std::size_t>(step));
}

// In a picture that is higher than wide the left pane is the upper one.
Pane leftPane(const FrameInfo& frame) {
    const int half = std::max(1, frame.height() / 2);
    if (frame.isUpright()) return {0, frame.height() - half, frame.width(), half};
    return {0, 0, std::max(1, frame.width() / 2), frame.height()};
}
Pane rightPane(const FrameInfo& frame) {
    if (frame.isUpright()) return {0, 0, frame.width(), leftPane(frame).height};
    return {leftPane(frame).width, 0, std::max(1, frame.width() - leftPane(frame).width), frame.height()};
}
Plot plotOf(const FrameInfo& frame, const Grid& grid) {
    const Pane pane = leftPane(frame);
    if (!frame.isUpright()) return gridPlot(pane, grid.columns, grid.rows);
    // Leave room below for the words
    const int room = std::min(72, pane.height / 3);
    Plot plot = gridPlot({0, 0, pane.width, pane.height - room}, grid.columns, grid.rows);
    plot.box = {plot.box.low + vec2(0, room), plot.box.high + vec2(0, room)};
    return plot;
}

Pixel pixelOf(const vec3& color) {
    const auto byte = [](double part) {
        return static_cast<std::uint8_t>(std::lround(255 * std::clamp(part, 0.0, 1.0)));
    };
    return {byte(color.x), byte(color.y), byte(color.z)};
}
vec3 colorOf(const Pixel& pixel) { return vec3(pixel.red, pixel.green, pixel.blue) / 255.0; }

Picture paperOf(const Grid& grid, const PixelMap* before) {
    Picture shown(grid.columns, grid.rows);
    for (int y = 0; y < grid.rows; ++y) {
        for (int x = 0; x < grid.columns; ++x)
            shown.set(x, grid.rows - 1 - y, before && before->at(x, y) == 1 ? outlined : paper);
    }
    return shown;
}

Picture inked(const Grid& grid, const std::vector<PixelStep>& pixels, const PixelMap* before) {
    Picture shown = paperOf(grid, before);
    for (std::size_t i = 0; i < grid.made(pixels.size()); ++i) {
        const PixelStep& pixel = pixels[i];
        if (pixel.x < 0 || pixel.y < 0 || pixel.x >= grid.columns || pixel.y >= grid.rows) continue;
        shown.set(pixel.x, grid.rows - 1 - pixel.y, pixelOf(vec3(1) - pixel.coverage * (vec3(1) - colorOf(first))));
    }
    return shown;
}

Picture orderOf(const Grid& grid, const std::vector<PixelStep>& pixels, const PixelMap* before) {
    Picture shown = paperOf(grid, before);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const double part = double(i) / double(pixels.size());
        shown.set(pixels[i].x, grid.rows - 1 - pixels[i].y,
                  pixelOf(glm::mix(vec3(0.12, 0.2, 0.55), vec3(1, 0.85, 0.25), part)));
    }
    return shown;
}

Picture byOpenGl(Gpu& gpu, MeshData data, const Grid& grid, const Frame& frame, int samples) {
    const bool isNew = gpu.small.fit(grid.columns, grid.rows, {.samples = samples}, "small picture");
    if (!isNew && data == gpu.drawn && gpu.program->id() == gpu.drawnBy) return gpu.glPicture;
    if (!isNew) gpu.small.bind();
    glClearColor(1, 1, 1, 1);
    glClear(GL_COLOR_BUFFER_BIT);
    if (data != gpu.drawn) gpu.mesh = Mesh(data, "figure");
    gpu.drawn = std::move(data);
    gpu.drawnBy = gpu.program->id();  // another one once somebody edits the shader
    gpu.program->use();
    gpu.program->set("pixels", vec2(grid.columns, grid.rows));
    gpu.mesh.draw();
    gpu.glPicture = samples == 0 ? gpu.small.readBound() : gpu.small.read();
    frame.bindTarget();
    return gpu.glPicture;
}

void showPictures(Gpu& gpu, const Frame& frame, const Grid& grid, const Picture& left, const Picture& right,
                  Shape shape) {
    Picture sheet(frame.width(), frame.height());
    std::fill(sheet.rgba.begin(), sheet.rgba.end(), std::uint8_t(255));
    const FrameInfo units = frame.inUnits();
    const Plot plot = plotOf(units, grid);
    magnify(left, plot, leftPane(units), units.scale(), sheet);
    magnify(right, plot, rightPane(units), units.scale(), sheet);
    showImage(frame, 0, 0, sheet);

    gpu.drawing.begin(frame);
    for (std::vector<vec2>& line : shape.lines) {
        for (vec2& point : line) point = plot.pixel(grid.scale * point);
    }
    for (const Pane& pane : {leftPane(units), rightPane(units)}) {
        gpu.drawing.in(pane);
        drawGrid(gpu.drawing, plot);
        for (const std::vector<vec2>& line : shape.lines) gpu.drawing.line(line, {ink, 1});
        if (shape.dot) gpu.drawing.point(plot.pixel(grid.scale * *shape.dot), 8, red);
    }
    gpu.drawing.in(leftPane(units));
}

std::string countOf(const Grid& grid, std::size_t all) {
    const std::size_t made = grid.made(all);
    return (made == all ? "" : std::to_string(made) + " of ") + std::to_string(all) + " pixels";
}

void showErrors(Gpu& gpu, const std::vector<PixelStep>& pixels, const Grid& grid, const Frame& frame) {
    const Plot plot = plotOf(frame.inUnits(), grid);
    if (plot.box.size().x / grid.columns < 15) return;
    for (std::size_t i = 0; i < grid.made(pixels.size()); ++i) {
        const PixelStep& pixel = pixels[i];
        gpu.drawing.textAround(plot.pixel({pixel.x + 0.5, pixel.y + 0.5}),
                               formatted(std::abs(pixel.error) < 10 ? "%.2g" : "%.0f", pixel.error),
                               {9, pixel.coverage > 0.6 ? vec4(1) : ink, vec4(0)});
    }
}

void showPlaces(Gpu& gpu, const std::vector<vec2>& pixels, const std::vector<vec2>& places, const Grid& grid,
                const Frame& frame) {
    const Plot plot = plotOf(frame.inUnits(), grid);
    if (plot.box.size().x / grid.columns < 15) return;
    for (const vec2& pixel : pixels) {
        for (const vec2& place : places) gpu.drawing.point(plot.pixel(pixel + place), 3, ink);
    }
}

void framePixel(Gpu& gpu, int x, int y, const vec4& color, const Grid& grid, const Frame& frame) {
    const Plot plot = plotOf(frame.inUnits(), grid);
    const vec2 low = plot.pixel({x, y}), high = plot.pixel({x + 1, y + 1});
    const std::array corners{low, vec2(high.x, low.y), high, vec2(low.x, high.y), low, vec2(high.x, low.y)};
    gpu.drawing.line(corners, {color, 3});
}

void showDifferent(Gpu& gpu, const std::vector<std::pair<int, int>>& pixels, const Grid& grid, const Frame& frame) {
    const FrameInfo units = frame.inUnits();
    const Plot plot = plotOf(units, grid);
    const double radius = 0.75 * plot.box.size().x / grid.columns;
    if (radius < 4) return;
    for (const Pane& pane : {rightPane(units), leftPane(units)}) {
        gpu.drawing.in(pane);
        for (const auto& [x, y] : pixels) {
            std::vector<vec2> ring;
            for (int i = 0; i <= 24; ++i)
                ring.push_back(plot.pixel({x + 0.5, y + 0.5}) +
                               radius * vec2(std::cos(i * pi / 12), std::sin(i * pi / 12)));
            gpu.drawing.line(ring, {red, 2});
        }
    }
}

std::vector<std::pair<int, int>> differing(const Grid& grid, const std::vector<PixelStep>& pixels,
                                           const Picture& glPicture) {
    const Picture mine = inked(grid, pixels);
    std::vector<std::pair<int, int>> result;
    for (int y = 0; y < grid.rows; ++y) {
        for (int x = 0; x < grid.columns; ++x)
            if (mine.at(x, grid.rows - 1 - y) != glPicture.at(x, grid.rows - 1 - y)) result.emplace_back(x, y);
    }
    return result;
}

void showBar(Gpu& gpu, double length, const Grid& grid, const Frame& frame, const std::string& words) {
    const FrameInfo units = frame.inUnits();
    const Plot plot = plotOf(units, grid);
    const int height = std::clamp(units.height() / 30, 8, 18);
    const double half = 0.25 * plot.box.size().x, y = plot.box.low.y - 6 - 2.1 * height;
    const vec2 zero(plot.box.low.x + half, y);
    if (y < 1.5 * height) return;
    const double end = zero.x + half * std::clamp(length, -1.0, 1.0);
    gpu.drawing.line({zero.x, y}, {end, y}, {length < 0 ? vec4(colorOf(first), 1) : red, 0.8 * height});
    gpu.drawing.line(zero - vec2(0, 0.7 * height), zero + vec2(0, 0.7 * height), {ink, 1.5});
    gpu.drawing.line(zero - vec2(half, 0), zero + vec2(half, 0), {ink, 1});
    gpu.drawing.text(zero + vec2(half + 8, 0.6 * height), "the error against 0", {height, ink, vec4(0)});
    gpu.drawing.text({8, y - 0.9 * height}, words, {height, ink, vec4(0)});
}

void showWords(Gpu& gpu, const Frame& frame, const Grid& grid, const std::string& left, const std::string& right,
               const std::optional<std::pair<std::string, vec4>>& more) {
    const FrameInfo units = frame.inUnits();
    const int height = std::clamp(units.height() / 30, leastWords, 18);
    const double below = plotOf(units, grid).box.low.y - 6;
    gpu.drawing.text({8, below}, left, {height, ink, vec4(0)});
    if (more) gpu.drawing.text({8, below - 1.5 * height}, more->first, {height, more->second, vec4(0)});
    gpu.drawing.in(rightPane(units));
    gpu.drawing.text({8, below}, right, {height, ink, vec4(0)});
    gpu.drawing.draw(frame);
}

}  // namespace mv::rasterizer

// rasterizer: which pixels a line, a triangle and a filled outline set, one by one, beside those that OpenGL sets.
//
// Claims (each is a test in tests/claims/rasterizer.cpp; X23 and X24 in docs/stability.md are its extremes):
// - [within-half-a-pixel] Bresenham's method sets in each column, or row, the pixel nearest to the line, in all octants.
// - [four-steps-to-it] From line to line of the lecture's improvements only the unit of the error changes, not a pixel, as long as
//   floats are exact.
// - [same-coverage] Brute force, box, adding up and tiles cover the same pixels, and asked are ever fewer.
// - [no-hole-no-double] Of two triangles with a common edge no pixel is in both, and none between them in neither.
// - [as-opengl] OpenGL's driver covers the same pixels where no clipping cuts the triangle.
// - [divided-by-w] Colours weighted by the corners' parts of the picture are not those of the surface; over w they are.
// - [eight-leaks] Through the outline that Bresenham's method draws, a fill with 8 neighbours leaks, one with 4 does not.
// - [ends-and-refuses] A fill into its own colour ends, and recursion that would end the stack is refused.
// - [two-insides] A star's middle is outside by even and odd, and inside by how often the outline winds round it.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/gl/drawing.h"
#include "mv/gl/gl.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/target.h"
#include "shared/pixel_grid.h"
#include "shared/raster_fill.h"
#include "shared/raster_line.h"
#include "shared/raster_tests.h"
#include "shared/raster_triangle.h"

using namespace mv;

namespace {

enum class Subject { line, triangle, fill, star };
enum class Shade { flat, picture, surface };
enum class Flood { recursive, spans };

const vec4 ink(0.1, 0.1, 0.1, 1), red(0.8, 0.15, 0.1, 1);
const Pixel paper{255, 255, 255}, outlined{90, 95, 105}, first{70, 125, 205}, second{120, 180, 110}, both{205, 60, 45};
const std::array<vec3, 4> cornerColors{vec3(0.9, 0.25, 0.15), vec3(0.2, 0.7, 0.25), vec3(0.15, 0.35, 0.85),
                                       vec3(0.95, 0.8, 0.2)};
const std::array<double, 4> cornerW{1, 1, 4, 4};
constexpr int allSteps = 999;

struct Rasterizer final : Demo {
    Choice<Subject> subject{
        this,
        "subject",
        Subject::line,
        {{"line"}, {"triangle"}, {"fill", "an outline drawn with lines"}, {"star", "a polygon that crosses itself"}},
        "what is drawn"};
    Choice<LineMethod> line{this,
                            "line",
                            LineMethod::octants,
                            {{"naive", "y += m, rounded"},
                             {"error", "1: the error since the last step up"},
                             {"shifted", "2: the error less 1/2, compared with 0"},
                             {"scaled", "3: times x2 - x1"},
                             {"bresenham", "4: times 2, whole numbers only"},
                             {"octants", "the whole of Bresenham's method"},
                             {"smooth", "two pixels a column, by nearness"}},
                            "how a line is drawn"};
    Choice<FillMethod> method{this,
                              "method",
                              FillMethod::box,
                              {{"brute", "every pixel is asked"},
                               {"box", "those of its box"},
                               {"incremental", "A is added to the right, B upwards"},
                               {"tiles", "of 8 x 8 pixels"},
                               {"floats", "A x + B y + C in floats"}},
                              "how a triangle's pixels are found"};
    Choice<EdgeRule> rule{this,
                          "rule",
                          EdgeRule::bottomLeft,
                          {{"bottom-left", "left and bottom edges keep their pixels"}, {"inside"}, {"outside"}},
                          "a pixel whose middle is on an edge"};
    Toggle neighbor{this, "neighbour", true, "a second triangle, with a common edge"};
    Choice<Shade> shade{
        this,
        "shade",
        Shade::flat,
        {{"flat"}, {"picture", "by the corners' weights in the picture (Gouraud)"}, {"surface", "the same over w"}},
        "colour of a triangle's pixels"};
    Choice<Flood> flood{this,
                        "flood",
                        Flood::spans,
                        {{"recursive", "as on the slide"}, {"spans", "whole runs of a row"}},
                        "how an outline is filled"};
    NumberChoice neighbors{this, "neighbours", 4, {4, 8}, "pixels that a fill goes on to"};
    Choice<Winding> winding{this, "winding", Winding::evenOdd, {{"even-odd"}, {"nonzero"}}, "what is inside of a star"};
    NumberChoice cells{this, "cells", 24, {24, 48, 96, 384}, "pixels across"};
    Whole step{this, "step", allSteps, {0, allSteps}, "how many pixels are set; 999: all"};
    Points ends{this, "ends", {{2, 3}, {20, 12}}, {{0, 0}, {23, 17}, 2, 2, 1}, "x,y of the pixels at a line's ends"};
    Points corners{this,
                   "corners",
                   {{2.25, 3.5}, {20.5, 1.5}, {21.5, 14.25}, {6.5, 16.5}},
                   {{0, 0}, {24, 18}, 4, 4, 0.0625},
                   "x,y of the corners: two triangles, or an outline"};
    Points star{this,
                "star",
                {{12, 17}, {17.25, 1.5}, {3.5, 11.25}, {20.5, 11.25}, {6.75, 1.5}},
                {{0, 0}, {24, 18}, 3, 9, 0.0625},
                "x,y of the star's corners"};
    Points seed{this, "seed", {{11, 9}}, {{0, 0}, {23, 17}, 1, 1, 1}, "x,y of the pixel where a fill begins"};

    Readout pixelsSet{this, "set", "pixels that are set"};
    Readout asked{this, "asked", "edge functions evaluated"};
    Readout doubles{this, "doubles", "pixels that both triangles set"};
    Readout holes{this, "holes", "pixels between the triangles that neither sets"};
    Readout differs{this, "differs", "pixels that OpenGL sets otherwise"};
    Readout deepest{this, "deepest", "calls within each other, or runs that wait"};

    OnDemand<Program> program{"rasterizer"};
    Target small;
    MeshData drawn;
    GLuint drawnBy = 0;
    Mesh mesh;
    Picture glPicture;
    Drawing drawing;

    Rasterizer() {
        bindKeys(Key::left, Key::right, step, 1);
        const auto is = [this](auto... ones) { return [this, ones...] { return ((subject == ones) || ...); }; };
        line.onlyWhen(is(Subject::line), "only a line has it");
        for (Knob* knob : std::vector<Knob*>{&method, &rule, &neighbor, &shade})
            knob->onlyWhen(is(Subject::triangle), "only a triangle has it");
        flood.onlyWhen(is(Subject::fill), "only a fill has it");
        neighbors.onlyWhen(is(Subject::fill), "only a fill has it");
        seed.onlyWhen(is(Subject::fill), "only a fill has it");
        winding.onlyWhen(is(Subject::star), "only the star has it");
        star.onlyWhen(is(Subject::star), "there is none");
        ends.onlyWhen(is(Subject::line), "there is none");
        corners.onlyWhen(is(Subject::triangle, Subject::fill), "there are none");
        handle("end", ends, 0.5, is(Subject::line));
        handle("corner", corners, 0, is(Subject::triangle, Subject::fill));
        handle("star's corner", star, 0, is(Subject::star));
        handle("seed", seed, 0.5, is(Subject::fill));
    }
    void handle(const char* name, Points& points, double inPixel, const std::function<bool()>& shown) {
        bindHandle(name, points, [this, inPixel, shown](const FrameInfo& frame, const vec2& at) -> std::optional<vec2> {
            if (!shown()) return {};
            return pictureFromPane(left(frame), gridOf(frame).pixel(scale() * (at + inPixel)));
        });
    }

    void init() override {}

    int columns() const { return cells; }
    int rows() const { return cells * 3 / 4; }
    double scale() const { return cells / 24.0; }
    int whole(double coordinate) const { return static_cast<int>(std::floor(coordinate * scale())); }

    // ---- our pixels, in the order in which they are set

    struct Ours {
        std::vector<PixelStep> pixels;
        std::size_t ofFirst = 0;  // how many are the first triangle's
        PixelMap before;          // what was there already: an outline
    };

    Ours rasterized() {
        Ours ours{{}, 0, PixelMap(columns(), rows())};
        if (subject == Subject::line) {
            ours.pixels = linePixels(line, whole(ends[0].x), whole(ends[0].y), whole(ends[1].x), whole(ends[1].y));
        } else if (subject == Subject::triangle) {
            const Covered one = coveredPixels(triangle(0), columns(), rows(), method, rule);
            ours.pixels = one.pixels;
            ours.ofFirst = one.pixels.size();
            std::int64_t evaluated = one.asked;
            if (neighbor) {
                const Covered other = coveredPixels(triangle(1), columns(), rows(), method, rule);
                ours.pixels.insert(ours.pixels.end(), other.pixels.begin(), other.pixels.end());
                evaluated += other.asked;
                countShared(one.pixels, other.pixels);
            }
            asked = double(evaluated);
        } else if (subject == Subject::star) {
            std::vector<vec2> scaled = star.points();
            for (vec2& corner : scaled) corner *= scale();
            ours.pixels = polygonPixels(scaled, columns(), rows(), winding);
        } else {
            drawOutline(ours.before);
            PixelMap map = ours.before;
            const Flooded flooded = flood == Flood::spans
                                        ? floodBySpans(map, whole(seed[0].x), whole(seed[0].y), 2, neighbors)
                                        : floodByRecursion(map, whole(seed[0].x), whole(seed[0].y), 2, neighbors);
            ours.pixels = flooded.pixels;
            deepest = double(flooded.deepest);
        }
        return ours;
    }
    std::array<vec2, 3> triangle(int which) const {
        return {scale() * corners[0], scale() * corners[which == 0 ? 1U : 2U], scale() * corners[which == 0 ? 2U : 3U]};
    }
    void drawOutline(PixelMap& map) const {
        for (std::size_t i = 0; i < 4; ++i) {
            const vec2 a = corners[i], b = corners[(i + 1) % 4];
            for (const PixelStep& pixel :
                 linePixels(LineMethod::octants, whole(a.x), whole(a.y), whole(b.x), whole(b.y))) {
                if (map.holds(pixel.x, pixel.y)) map.at(pixel.x, pixel.y) = 1;
            }
        }
    }
    // Against what the right rule gives the two triangles together.
    void countShared(const std::vector<PixelStep>& one, const std::vector<PixelStep>& other) {
        PixelMap map(columns(), rows());
        for (const PixelStep& pixel : one) ++map.at(pixel.x, pixel.y);
        for (const PixelStep& pixel : other) ++map.at(pixel.x, pixel.y);
        doubles = double(std::count(map.colors.begin(), map.colors.end(), 2));
        int missing = 0;
        for (int which : {0, 1}) {
            for (const PixelStep& pixel : coveredPixels(triangle(which), columns(), rows(), FillMethod::box).pixels)
                missing += map.at(pixel.x, pixel.y) == 0;
        }
        holes = missing;
    }

    // The colour of a triangle's pixel: a mean of its corners', weighted by where the pixel's middle is.
    Pixel colorAt(const PixelStep& pixel, int which) const {
        if (shade == Shade::flat) return which == 0 ? first : second;
        const std::array<std::size_t, 3> at{0, which == 0 ? 1U : 2U, which == 0 ? 2U : 3U};
        vec3 weights = cornerWeights(triangle(which), {pixel.x + 0.5, pixel.y + 0.5});
        if (shade == Shade::surface)
            weights = perspectiveWeights(weights, {cornerW.at(at[0]), cornerW.at(at[1]), cornerW.at(at[2])});
        return pixelOf(weights.x * cornerColors.at(at[0]) + weights.y * cornerColors.at(at[1]) +
                       weights.z * cornerColors.at(at[2]));
    }
    static Pixel pixelOf(const vec3& color) {
        const auto byte = [](double part) {
            return static_cast<std::uint8_t>(std::lround(255 * std::clamp(part, 0.0, 1.0)));
        };
        return {byte(color.x), byte(color.y), byte(color.z)};
    }

    Picture picture(const Ours& ours) const {
        Picture shown(columns(), rows());
        const auto put = [&](int x, int y, const Pixel& color) { shown.set(x, rows() - 1 - y, color); };
        PixelMap times(columns(), rows());
        for (int y = 0; y < rows(); ++y) {
            for (int x = 0; x < columns(); ++x) put(x, y, ours.before.at(x, y) == 1 ? outlined : paper);
        }
        const std::size_t made =
            step == allSteps ? ours.pixels.size() : std::min(ours.pixels.size(), static_cast<std::size_t>(int(step)));
        for (std::size_t i = 0; i < made; ++i) {
            const PixelStep& pixel = ours.pixels[i];
            if (!times.holds(pixel.x, pixel.y)) continue;
            const bool twice = times.at(pixel.x, pixel.y)++ > 0 && subject == Subject::triangle;
            if (subject == Subject::triangle) {
                put(pixel.x, pixel.y, twice ? both : colorAt(pixel, i < ours.ofFirst ? 0 : 1));
            } else {
                put(pixel.x, pixel.y,
                    pixelOf(vec3(1) - pixel.coverage * (vec3(1) - vec3(first.red, first.green, first.blue) / 255.0)));
            }
        }
        return shown;
    }

    // ---- OpenGL's pixels, or in which order ours were set

    Picture byOpenGl(const Frame& frame) {
        MeshData data{.primitive = subject == Subject::line ? Primitive::lines : Primitive::triangles};
        const auto add = [&](const vec2& at, double w, const vec3& color) {
            data.positions.emplace_back(at.x, at.y, w);
            data.colors.emplace_back(fvec3(color), 1);
        };
        const auto plain = [](const Pixel& color) { return vec3(color.red, color.green, color.blue) / 255.0; };
        if (subject == Subject::line) {
            for (std::size_t i = 0; i < 2; ++i) add(vec2(whole(ends[i].x), whole(ends[i].y)) + 0.5, 1, plain(first));
        } else {
            for (int which = 0; which < (neighbor ? 2 : 1); ++which) {
                const auto points = triangle(which);
                const std::array<std::size_t, 3> at{0, which == 0 ? 1U : 2U, which == 0 ? 2U : 3U};
                for (std::size_t i = 0; i < 3; ++i) {
                    add(points.at(i), shade == Shade::surface ? cornerW.at(at.at(i)) : 1,
                        shade == Shade::flat ? plain(which == 0 ? first : second) : cornerColors.at(at.at(i)));
                }
            }
        }
        // Kept, while the same is drawn
        const bool isNew = small.fit(columns(), rows(), {}, "small picture");
        if (!isNew && data == drawn && program->id() == drawnBy) return glPicture;
        if (!isNew) small.bind();
        glClearColor(1, 1, 1, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        if (data != drawn) mesh = Mesh(data, "figure");
        drawn = std::move(data);
        drawnBy = program->id();  // another one once somebody edits the shader
        program->use();
        program->set("pixels", vec2(columns(), rows()));
        mesh.draw();
        glPicture = small.readBound();
        frame.bindTarget();
        return glPicture;
    }
    // From blue, the first, to yellow.
    Picture order(const Ours& ours) const {
        Picture shown = picture({{}, 0, ours.before});
        for (std::size_t i = 0; i < ours.pixels.size(); ++i) {
            const double part = double(i) / double(ours.pixels.size());
            shown.set(ours.pixels[i].x, rows() - 1 - ours.pixels[i].y,
                      pixelOf(glm::mix(vec3(0.12, 0.2, 0.55), vec3(1, 0.85, 0.25), part)));
        }
        return shown;
    }

    // ---- the picture

    static Pane left(const FrameInfo& frame) { return {0, 0, std::max(1, frame.width() / 2), frame.height()}; }
    static Pane right(const FrameInfo& frame) {
        return {left(frame).width, 0, std::max(1, frame.width() - left(frame).width), frame.height()};
    }
    Plot gridOf(const FrameInfo& frame) const { return gridPlot(left(frame), columns(), rows()); }

    void draw(const Frame& frame) override {
        const Ours ours = rasterized();
        const bool isGl = subject == Subject::line || subject == Subject::triangle;
        const Picture mine = picture(ours), other = isGl ? byOpenGl(frame) : order(ours);
        pixelsSet = double(ours.pixels.size());
        if (isGl) differs = double(countDifferent(picture({ours.pixels, ours.ofFirst, ours.before}), other));

        Picture sheet(frame.width(), frame.height());
        std::fill(sheet.rgba.begin(), sheet.rgba.end(), std::uint8_t(255));
        const Plot plot = gridOf(frame);
        magnify(mine, plot, left(frame), sheet);
        magnify(other, plot, right(frame), sheet);
        showImage(frame, 0, 0, sheet);

        drawing.begin(frame);
        for (const Pane& pane : {left(frame), right(frame)}) {
            drawing.in(pane);
            drawGrid(drawing, plot);
            drawShape(plot);
        }
        drawing.in(left(frame));
        drawErrors(ours, plot);
        const int height = std::clamp(frame.height() / 30, 8, 18);
        const double below = plot.box.low.y - 6;
        drawing.text({8, below}, wordsOf(ours), {height, ink, vec4(0)});
        if (subject == Subject::triangle && neighbor && doubles.value() && holes.value())
            drawing.text({8, below - 1.5 * height},
                         rounded("%.0f pixels twice, ", *doubles.value()) + rounded("%.0f holes", *holes.value()),
                         {height, *doubles.value() + *holes.value() > 0 ? red : ink, vec4(0)});
        drawing.in(right(frame));
        drawing.text({8, below},
                     isGl ? rounded("OpenGL: pixels set otherwise: %.0f", differs.value().value_or(0))
                          : "the order: from blue to yellow",
                     {height, ink, vec4(0)});
        drawing.draw(frame);
    }
    std::string wordsOf(const Ours& ours) const {
        const std::string what = subject == Subject::line       ? line.text()
                                 : subject == Subject::triangle ? method.text() + ", " + rule.text()
                                 : subject == Subject::fill     ? flood.text() + ", " + neighbors.text() + " neighbours"
                                                                : winding.text();
        return what + ": " + std::to_string(ours.pixels.size()) + " pixels";
    }

    // The shape itself, over its pixels.
    void drawShape(const Plot& plot) {
        std::vector<vec2> points = subject == Subject::line   ? ends.points()
                                   : subject == Subject::star ? star.points()
                                                              : corners.points();
        if (subject == Subject::line) points = {points[0] + 0.5, points[1] + 0.5};
        for (vec2& point : points) point = plot.pixel(scale() * point);
        if (subject == Subject::triangle) drawing.line(points[0], points[2], {ink, 1});
        if (subject != Subject::line) points.push_back(points.front());
        drawing.line(points, {ink, 1});
        if (subject == Subject::fill) drawing.point(plot.pixel(scale() * (seed[0] + 0.5)), 8, red);
    }

    // The error term, in figures, where there is room for them.
    void drawErrors(const Ours& ours, const Plot& plot) {
        const double side = plot.box.size().x / columns();
        if (subject != Subject::line || side < 15) return;
        const std::size_t made = std::min(ours.pixels.size(), static_cast<std::size_t>(int(step)));
        for (std::size_t i = 0; i < made; ++i) {
            const PixelStep& pixel = ours.pixels[i];
            drawing.textAround(plot.pixel({pixel.x + 0.5, pixel.y + 0.5}),
                               rounded(std::abs(pixel.error) < 10 ? "%.2g" : "%.0f", pixel.error),
                               {9, pixel.coverage > 0.6 ? vec4(1) : ink, vec4(0)});
        }
    }

    // For the study: what is right or wrong of the method's pixels, for lines or triangles of its own.
    std::vector<double> values() const override {
        if (subject == Subject::line) return lineTest(line, columns());
        return triangleTest(method, columns(), rows());
    }
    std::vector<std::pair<std::string, double>> valueCounts() const override {
        return {{"pixels set", subject == Subject::line ? double(lineTest(line, columns()).size())
                                                        : triangleTestPixels(method, columns(), rows())}};
    }
};

constexpr Declaration declaration{
    .name = "rasterizer",
    .sentence = "Lines, triangles and fills, pixel by pixel, beside the pixels that OpenGL sets.",
    .lookFor =
        "In each column the pixel nearest to the line is set, and the figure in it says how far the line is "
        "from where it steps up.",
    .chapter = "Rays, clipping and pixels",
    .number = 26,
    .width = 960,
    .height = 440,
    .background = vec4(1, 1, 1, 1),
    .presets =
        {
            {"bresenham", "One pixel a column, the nearest; the error term in figures."},
            {"naive", "Made for slopes up to 1: a steep line has gaps.", {{"line", "naive"}, {"ends", "8,1/13,16"}}},
            {"smooth",
             "Two pixels a column share the colour by how near the line passes.",
             {{"line", "smooth"}, {"ends", "2,15/21,5"}}},
            {"shared-edge",
             "Two triangles with a common edge: every pixel is one's, and none is both's.",
             {{"subject", "triangle"}, {"corners", "4,3/20,3/20,15/4,15"}}},
            {"surface",
             "Colours over w, as OpenGL interpolates them.",
             {{"subject", "triangle"}, {"shade", "surface"}}},
            {"leak",
             "Eight neighbours: the fill leaks through the outline.",
             {{"subject", "fill"}, {"neighbours", "8"}}},
        },
};

const bool added = addDemo<Rasterizer, declaration>();

}  // namespace

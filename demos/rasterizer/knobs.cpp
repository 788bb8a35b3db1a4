// The settings of rasterizer: rows, presets, controls and declaration.
#include <algorithm>
#include <cstddef>

#include "mv/demo/lesson.h"
#include "mv/error.h"
#include "sheet.h"

namespace mv::rasterizer {
namespace {

constexpr WordList lineWords{{"naive", "y += m, rounded"},
                             {"error", "1: the error since the last step up"},
                             {"shifted", "2: the error less 1/2, compared with 0"},
                             {"scaled", "3: times x2 - x1"},
                             {"bresenham", "4: times 2, whole numbers only"},
                             {"octants", "the whole of Bresenham's method"},
                             {"smooth", "two pixels a column, by nearness"}};
constexpr WordList thickenWords{{"columns", "each pixel becomes a column of them, or a row where the line is steep"},
                                {"across", "those whose middles are within half the thickness of the line"}};
constexpr WordList methodWords{{"brute", "every pixel is asked"},
                               {"box", "those of its box"},
                               {"incremental", "A is added to the right, B upwards"},
                               {"tiles", "of 8 x 8 pixels"},
                               {"floats", "A x + B y + C in floats"}};
constexpr WordList ruleWords{{"bottom-left", "left and bottom edges keep their pixels"}, {"inside"}, {"outside"}};
constexpr WordList floodWords{{"recursive", "as on the slide"}, {"spans", "whole runs of a row"}};
constexpr WordList windingWords{{"even-odd"}, {"nonzero"}};
constexpr WordList circleWords{{"columns", "in each column the square root, rounded"},
                               {"mirrored", "the same in one eighth, and its mirror images"},
                               {"turned", "a point turned by 1/r radian at a time"},
                               {"midpoint", "one eighth in whole numbers, and its mirror images"}};

}  // namespace

const char* nameOf(LineMethod method) { return wordOf(lineWords, method); }
const char* nameOf(FillMethod method) { return wordOf(methodWords, method); }
const char* nameOf(EdgeRule rule) { return wordOf(ruleWords, rule); }
const char* nameOf(Flood flood) { return wordOf(floodWords, flood); }
const char* nameOf(Winding winding) { return wordOf(windingWords, winding); }
const char* nameOf(CircleMethod method) { return wordOf(circleWords, method); }

// The same pixels, whatever a recursion would say of its depth.
Fill bySpans(Fill fill) {
    fill.flood = Flood::spans;
    return fill;
}

void check(const Settings& s) {
    if (s.subject != Subject::fill || s.fill.flood == Flood::spans) return;
    try {
        (void)countFill(s.fill, s.corners, Grid(s));
    } catch (const Error& error) {
        throw Error("--flood", error.what());  // too deep for the stack
    }
}

int mostSteps(const Settings& s) {
    const Grid grid(s);
    const auto count = [&]() -> std::size_t {
        switch (s.subject) {
            case Subject::line:
                return countLine(s.line, grid);
            case Subject::triangle:
                return countTriangles(s.triangles, s.corners, grid);
            case Subject::fill:
                return countFill(bySpans(s.fill), s.corners, grid);
            case Subject::star:
                return countStar(s.star, grid);
            case Subject::circle:
                return countCircle(s.circle, grid);
        }
        return allSteps;
    };
    try {
        return static_cast<int>(std::min<std::size_t>(count(), allSteps));
    } catch (const Error&) {
        return allSteps;  // a fill that would end the stack makes no picture
    }
}

namespace {

template <Subject... subjects>
bool is(const Settings& s) {
    return ((s.subject == subjects) || ...);
}

std::vector<Row<Settings>> panelRows() {
    return together(
        word("subject", &Settings::subject,
             {{"line"},
              {"triangle"},
              {"fill", "an outline drawn with lines"},
              {"star", "a polygon that crosses itself"},
              {"circle"}},
             "what is drawn"),
        part(&Settings::line,
             {word("line", &Line::method, lineWords, "how a line is drawn"),
              whole("thickness", &Line::thickness, {1, 9}, "how thick the line is", "pixels")
                  .when([](const Line& line) { return line.method != LineMethod::smooth; }, "a smooth line is thin"),
              word("thicken", &Line::thicken, thickenWords, "how a line is made thick")
                  .when([](const Line& line) { return line.thickness > 1 && line.method != LineMethod::smooth; },
                        "the line is one pixel thick")},
             is<Subject::line>, "only a line has it"),
        part(&Settings::triangles,
             {word("method", &Triangles::method, methodWords, "how a triangle's pixels are found"),
              word("rule", &Triangles::rule, ruleWords, "a pixel whose middle is on an edge"),
              toggle("neighbour", &Triangles::neighbour, "a second triangle, with a common edge"),
              word("shade", &Triangles::shade,
                   {{"flat"},
                    {"picture", "by the corners' weights in the picture (Gouraud)"},
                    {"surface", "the same over w"}},
                   "colour of a triangle's pixels"),
              word("edges", &Triangles::edges,
                   {{"hard", "a pixel is a triangle's if its middle is"},
                    {"sampled", "a pixel has so much of the colour as points of it are covered"}},
                   "what a pixel at an edge gets"),
              oneOf("places", &Triangles::places, {1, 4}, "points of a pixel that are asked")
                  .when([](const Triangles& s) { return s.edges == Edges::sampled; }, "edges are hard")},
             is<Subject::triangle>, "only a triangle has it"),
        part(&Settings::fill,
             {word("flood", &Fill::flood, floodWords, "how an outline is filled"),
              oneOf("neighbours", &Fill::neighbours, {4, 8}, "pixels that a fill goes on to")},
             is<Subject::fill>, "only a fill has it"),
        part(&Settings::star, {word("winding", &Star::winding, windingWords, "what is inside of a star")},
             is<Subject::star>, "only the star has it"),
        part(&Settings::circle,
             {word("circle", &Circle::method, circleWords, "how a circle is drawn"),
              number("radius", &Circle::radius, {0, 24}, "of the circle, where the grid is 24 wide")},
             is<Subject::circle>, "only a circle has it"),
        oneOf("cells", &Settings::cells, {24, 48, 96, 384}, "pixels across"),
        whole("step", &Settings::step, {0, allSteps}, "how many pixels are set; 999: all").upTo(mostSteps),
        part(&Settings::line,
             {points("ends", &Line::ends, {{0, 0}, {23, 17}, 2, 2, 1}, "x,y of the pixels at a line's ends")},
             is<Subject::line>, "there is none"),
        points("corners", &Settings::corners, {{0, 0}, {24, 18}, 4, 4, 0.0625},
               "x,y of the corners: two triangles, or an outline")
            .when(is<Subject::triangle, Subject::fill>, "there are none"),
        part(&Settings::star,
             {points("star", &Star::corners, {{0, 0}, {24, 18}, 3, 9, 0.0625}, "x,y of the star's corners")},
             is<Subject::star>, "there is none"),
        part(&Settings::fill,
             {points("seed", &Fill::seed, {{0, 0}, {23, 17}, 1, 1, 1}, "x,y of the pixel where a fill begins")},
             is<Subject::fill>, "only a fill has it"),
        part(&Settings::circle,
             {points("middle", &Circle::middle, {{-24, -18}, {47, 35}, 1, 1, 1}, "x,y of the circle's middle pixel")},
             is<Subject::circle>, "only a circle has it"));
}

constexpr Declaration about{
    .name = "rasterizer",
    .sentence = "Lines, triangles and fills, pixel by pixel, beside the pixels that OpenGL sets.",
    .lookFor =
        "In each column the pixel nearest to the line is set, and the figure in it says how far the line is from where "
        "it steps up.",
    .chapter = "Rays, clipping and pixels",
    .number = 26,
    .width = 960,
    .height = 440,
    .background = vec4(1, 1, 1, 1),
};

std::vector<SettingsPreset<Settings>> presets() {
    return {
        {"bresenham",
         "Half-way: the framed pixel was set last, and its error, with the slope added, decides about the next one."},
        {"thick",
         "A column of five pixels for each: the line is as thin as four where it rises by 45 degrees.",
         {.line = {.thickness = 5, .ends = {vec2(4, 2), vec2(16, 14)}}, .step = allSteps}},
        {"naive",
         "Made for slopes up to 1: a steep line has gaps.",
         {.line = {.method = LineMethod::naive, .ends = {vec2(8, 1), vec2(13, 16)}}, .step = allSteps}},
        {"smooth",
         "Two pixels a column share the colour by how near the line passes.",
         {.line = {.method = LineMethod::smooth, .ends = {vec2(2, 15), vec2(21, 5)}}, .step = allSteps}},
        {"shared-edge",
         "Two triangles with a common edge: every pixel is one's, and none is both's.",
         {.subject = Subject::triangle,
          .corners = {vec2(4, 3), vec2(20, 3), vec2(20, 15), vec2(4, 15)},
          .step = allSteps}},
        {"surface",
         "Colours over w, as OpenGL interpolates them.",
         {.subject = Subject::triangle, .triangles = {.shade = Shade::surface}, .step = allSteps}},
        {"leak",
         "Eight neighbours: the fill leaks through the outline.",
         {.subject = Subject::fill, .fill = {.neighbours = 8}, .step = allSteps}},
        {"circle",
         "One eighth in whole numbers, and its seven mirror images; below 0 the next pixel goes on, else one down.",
         {.subject = Subject::circle, .step = allSteps}},
    };
}

// The place of a point of the settings in the left picture.
std::optional<vec2> placeOf(const Settings& s, const FrameInfo& frame, const vec2& at) {
    const Grid grid(s);
    return pictureFromPane(leftPane(frame), plotOf(frame, grid).pixel(grid.scale * at));
}
// The same of a pixel: of its middle. Nothing where the subject is another.
template <Subject... subjects>
std::optional<vec2> placeOfPoint(const Settings& s, const FrameInfo& frame, const vec2& at) {
    if (!is<subjects...>(s)) return {};
    return placeOf(s, frame, at);
}
template <Subject subject>
std::optional<vec2> placeOfPixel(const Settings& s, const FrameInfo& frame, const vec2& at) {
    if (!is<subject>(s)) return {};
    return placeOf(s, frame, at + 0.5);
}
std::optional<vec2> placeOfRim(const Settings& s, const FrameInfo& frame) {
    if (!is<Subject::circle>(s)) return {};
    return placeOf(s, frame, s.circle.middle + vec2(s.circle.radius + 0.5, 0.5));
}

const bool added = addLesson(
    about,
    Lesson<Settings, Gpu>{
        .rows = panelRows(),
        .presets = presets(),
        .controls = {keys(Key::left, Key::right, "step", 1)},
        .handles = {{"end", {"ends"}, {}, placeOfPixel<Subject::line>},
                    {"corner", {"corners"}, {}, placeOfPoint<Subject::triangle, Subject::fill>},
                    {"star's corner", {"star"}, {}, placeOfPoint<Subject::star>},
                    {"seed", {"seed"}, {}, placeOfPixel<Subject::fill>},
                    {"middle", {"middle"}, {}, placeOfPixel<Subject::circle>},
                    {"rim", {"radius"}, placeOfRim}},
        .readouts = {{"set", "pixels that are set"},
                     {"asked", "edge functions evaluated"},
                     {"doubles", "pixels that both triangles set"},
                     {"holes", "pixels between the triangles that neither sets"},
                     {"differs", "pixels that OpenGL sets otherwise"},
                     {"edge-error", "root mean square error of a pixel's share of a triangle, at its edges", "pixels"},
                     {"as-thick", "pixels of the line over its length", "pixels"},
                     {"deepest", "calls within each other, or runs that wait"}},
        .draw = draw,
        .readOut = readOut,
        .check = check,
        .values = values,
        .valueCounts = valueCounts,
    });

}  // namespace
}  // namespace mv::rasterizer

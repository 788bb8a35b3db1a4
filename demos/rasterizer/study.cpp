// The readouts of rasterizer, and its study: pixels that a method sets wrongly, and what each method takes.
#include <cmath>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "sheet.h"
#include "trials.h"

namespace mv::rasterizer {

void readOut(Gpu& gpu, const Settings& s, const Frame&, Numbers& numbers) {
    const Grid grid(s);
    if (s.subject == Subject::line) readLine(gpu, s.line, grid, numbers);
    if (s.subject == Subject::triangle) readTriangles(gpu, s.triangles, s.corners, grid, numbers);
    if (s.subject == Subject::fill) readFill(s.fill, s.corners, grid, numbers);
    if (s.subject == Subject::star) readStar(s.star, grid, numbers);
    if (s.subject == Subject::circle) readCircle(gpu, s.circle, grid, numbers);
}

// Counts right and wrong pixels of the method, for lines, triangles or circles of its own.
std::vector<double> values(const Settings& s) {
    const Grid grid(s);
    if (s.subject == Subject::line) return lineTest(s.line.method, grid.columns);
    if (s.subject == Subject::circle) return circleTest(s.circle.method, grid.columns);
    if (s.triangles.edges == Edges::sampled) return shareTest(s.triangles.places, grid.columns, grid.rows);
    return triangleTest(s.triangles.method, grid.columns, grid.rows);
}
std::vector<std::pair<std::string, double>> valueCounts(const Settings& s) {
    const Grid grid(s);
    const auto count = [&] {
        if (s.subject == Subject::line) return double(lineTest(s.line.method, grid.columns).size());
        if (s.subject == Subject::circle) return circleTestPixels(s.circle.method, grid.columns);
        return triangleTestPixels(s.triangles.method, grid.columns, grid.rows);
    };
    return {{"pixels set", count()}};
}

namespace {

using namespace mv::claims;

Reference truth(const Demo& demo) {
    const int columns = static_cast<int>(demo.number("cells"));
    if (demo.word("subject") == "line") return {.values = lineTruth(columns)};
    if (demo.word("subject") == "circle") return {.values = circleTruth(columns)};
    if (demo.word("edges") == "sampled") return {.values = shareTruth(columns, columns * 3 / 4)};
    return {.values = triangleTruth(columns, columns * 3 / 4)};
}

Study study() {
    Study study;
    study.quantity =
        "of 64 lines to the right, the height of the pixel set in each column; of 16 triangles, whether a pixel is "
        "covered, or of sampled edges what share of it is; of 32 circles, how far up or out the pixel of each column "
        "or row of an eighth is";
    study.reference =
        "of lines and circles their own height; of triangles the rows' crossings in fractions of whole numbers, and of "
        "shares "
        "the area of what is left of a triangle that is cut to the pixel";
    study.reads = {"subject", "edges", "cells"};
    study.makeReference = [](const Demo& demo, const ReferenceFrame&, const auto&) { return truth(demo); };
    study.axis = ErrorAxis::fraction;
    study.ofValues = true;
    study.wrongBeyond = 0.5;
    study.problem = "cells";
    study.scenes = {{"lines", {{"subject", "line"}}},
                    {"triangles", {{"subject", "triangle"}}},
                    {"circles", {{"subject", "circle"}}}};
    study.scenes.push_back({"sampled edges", {{"subject", "triangle"}, {"edges", "sampled"}}});
    const std::vector<std::string> cells{"24", "48", "96", "384"};
    for (const std::string method : {"naive", "error", "shifted", "scaled", "bresenham", "octants", "smooth"})
        study.lines.push_back(
            {.method = method, .settings = {{"line", method}}, .knob = "cells", .values = cells, .scenes = {"lines"}});
    for (const std::string method : {"brute", "box", "incremental", "tiles", "floats"})
        study.lines.push_back({.method = method,
                               .settings = {{"method", method}},
                               .knob = "cells",
                               .values = cells,
                               .scenes = {"triangles"}});
    for (const std::string method : {"columns", "mirrored", "turned", "midpoint"})
        study.lines.push_back({.method = method,
                               .settings = {{"circle", method}},
                               .knob = "cells",
                               .values = cells,
                               .scenes = {"circles"}});
    for (const std::string places : {"1", "4"})
        study.lines.push_back({.method = places + (places == "1" ? " place" : " places"),
                               .settings = {{"places", places}},
                               .knob = "cells",
                               .values = cells,
                               .scenes = {"sampled edges"}});
    study.says = {
        claim("whole-numbers", "What computes in whole numbers, or in halves of them, sets no pixel wrongly.",
              {zero(of::wrong, rows("scaled", "bresenham", "octants", "brute", "box", "incremental", "tiles"))}),
        claim("naive-drifts",
              "The naive method's y has drifted at 384 across: some pixels, fewer than one in a thousand, are wrong.",
              {value(of::wrong, rows("naive").at(384), 1e-9, 0.1)}),
        claim("floats-near-the-origin", "Triangles in floats have no wrong pixel up to 384 across.",
              {zero(of::wrong, rows("floats"))}),
        claim("smooth-is-nearest", "Two pixels a column have their middle on the line itself.",
              {atMost(of::max, rows("smooth"), 1e-9), atLeast(of::max, rows("bresenham"), 0.3)}),
        claim("circles-nearest",
              "Of a circle, an eighth and its mirror images are the nearest pixels, by a root or by whole numbers.",
              {zero(of::wrong, rows("mirrored", "midpoint"))}),
        claim("columns-leave-gaps",
              "One pixel a column leaves gaps where a circle is steep: more than a tenth of the pixels are missing.",
              {atLeast(of::wrong, rows("columns"), 10)}),
        claim("four-places",
              "Four places of a pixel leave at most two fifths of the error that one leaves, at any number of cells.",
              {ratio(of::rms, rows("4 places"), rows("1 place"), 0, 0.4)}),
        claim("turned-is-beside", "A point that is turned round sets pixels beside the nearest ones, too: 5 % or more.",
              {atLeast(of::wrong, rows("turned"), 5)}),
        claim("turning-costs", "At 384 across, a point that is turned takes more than twice as long as whole numbers.",
              {ratio(of::time, rows("turned").at(384), rows("midpoint").at(384), 2, HUGE_VAL)}),
        claim("adding-up", "At 384 across, adding up takes less time than asking every pixel.",
              {ratio(of::time, rows("incremental").at(384), rows("brute").at(384), 0, 1)}),
        note("A millisecond of the lines' time divided by the pixels set, under \"Work of a frame\", is the time of "
             "one: the "
             "study's lists of pixels are in it."),
    };
    return study;
}

[[maybe_unused]] const bool studied = addStudy("rasterizer", study());

}  // namespace
}  // namespace mv::rasterizer

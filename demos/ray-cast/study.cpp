// The readouts of ray-cast, and its study: the t of each pixel against the same rays in long double (reference.cpp).
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "exact_rays.h"
#include "mv/demo/lesson.h"
#include "ray-cast.h"

namespace mv::ray_cast {

static bool isUnlike(const std::optional<CastCandidate>& a, const std::optional<CastCandidate>& b, double size) {
    if (!a || !b) return a.has_value() != b.has_value();
    return a->kind != b->kind || std::abs(a->hit.t - b->hit.t) > 0.05 * size;
}

// Pixels that see another object than by the stable form in double.
static int countUnlike(const Seen& seen, Settings s) {
    s.form = CastForm::stable;
    s.precision = Precision::twice;
    s.plane = PlaneForm::implicit;
    s.starts = 16;
    const Seen right = castRays(s);
    int count = 0;
    for (std::size_t i = 0; i < right.size(); ++i) count += isUnlike(seen[i], right[i], s.size) ? 1 : 0;
    return count;
}

void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers) {
    const std::vector<CastCandidate> met = chosen(s);
    numbers.set("candidates", double(met.size()));
    if (!met.empty()) numbers.set("t", met.front().hit.t);
    if (s.by == Maker::gl) return;
    const int unlike = gpu.unlike.of({withoutPixel(s)}, [&] { return countUnlike(keptSeen(gpu, s), s); });
    numbers.set("unlike", unlike);
    if (unlike > 0)
        frame.say(std::to_string(unlike) + " pixels have another object or t than by the stable form in double.");
}

// For the study: each pixel's t without the distance, in units of the scale; 10 for the sky.
std::vector<double> values(const Settings& s) {
    Settings alone = s;
    alone.threads = 1;
    std::vector<double> ts;
    for (const auto& first : seenBy(alone)) ts.push_back(first ? first->hit.t / s.size - s.distance : 10);
    return ts;
}

namespace {

using namespace mv::claims;

Study study() {
    Study study;
    study.quantity = "t of each pixel's ray without the eye's distance, in units of the scene; 64 x 64 rays";
    study.reference = "the same rays, as rounded, in long double: perpendiculars, volumes and halving";
    study.reads = {"precision", "objects", "triangles", "distance", "scale", "rows"};
    study.makeReference = [](const Demo& demo, const ReferenceFrame&, const auto&) {
        const auto s = settingsOf<Settings>(demo);
        return s.objects == only(CastKind::teapot) ? teapotReference(s) : longDouble(s);
    };
    study.axis = ErrorAxis::fraction;
    study.width = 64;
    study.height = 64;
    study.wrongBeyond = 0.5;
    study.problem = "distance";
    study.ofValues = true;
    std::vector<std::string> formulas;
    for (const std::string kind : {"all", "plane", "sphere", "box", "triangle", "polygon", "transformed", "surface"}) {
        study.scenes.push_back({kind, {{"objects", kind}, {"rows", "64"}}});
        formulas.push_back(kind);
    }
    for (const std::string form : {"textbook", "stable"}) {
        for (const std::string precision : {"float", "double"}) {
            study.lines.push_back({.method = std::string(form).append(", ").append(precision),
                                   .settings = {{"form", form}, {"precision", precision}},
                                   .knob = "distance",
                                   .values = {"9", "100", "1000", "10000", "100000"},
                                   .scenes = formulas});
        }
    }
    // Rays against a raster, both on one thread: triangles times pixels
    const std::vector<std::string> sides{"32", "128", "512"};
    std::vector<std::string> teapots;
    for (const std::string& side : sides) {
        study.scenes.push_back(
            {std::string(side).append(" x ").append(side).append(" pixels"), {{"objects", "teapot"}, {"rows", side}}});
        teapots.push_back(study.scenes.back().name);
    }
    for (const std::string maker : {"rays", "raster"})
        study.lines.push_back({.method = maker,
                               .settings = {{"picture-by", maker}},
                               .knob = "triangles",
                               .values = {"1024", "4096", "16384", "65536", "262144", "1048576"},
                               .scenes = teapots});
    study.says = {
        claim("stable",
              "The stable forms have no more than one pixel in a thousand wrong, in float too, and up to 1e5 away.",
              {atMost(of::wrong, rows("stable, float", "stable, double"), 0.1)}),
        claim("textbook-in-float",
              "In float the textbook's sphere has more than 5 % of the pixels wrong from 1e4 away, and more than 90 % "
              "from 1e5.",
              {atLeast(of::wrong, rows("textbook, float").in("sphere").at(10000), 5),
               atLeast(of::wrong, rows("textbook, float").in("sphere").at(100000), 90)}),
        claim(
            "digits-in-double",
            "In double it is right there, with 1e-5 of the radius or more lost at its outline; the stable one has lost "
            "less than 1e-9.",
            {zero(of::wrong, rows("textbook, double").in("sphere")),
             atLeast(of::max, rows("textbook, double").in("sphere").at(100000), 1e-5),
             atMost(of::max, rows("stable, double").in("sphere"), 1e-9)}),
        claim("one-start",
              "Newton's method from one start misses more than ten times as many pixels of the flag as from a grid, "
              "and takes less time, four fifths of it at most.",
              {ratio(of::wrong, rows("stable, double").in("surface"), rows("textbook, double").in("surface"), 0, 0.1),
               ratio(of::time, rows("textbook, double").in("surface"), rows("stable, double").in("surface"), 0, 0.8)}),
        claim(
            "no-price", "For a sphere in double the stable form takes the textbook's time, within a third.",
            {ratio(of::time, rows("stable, double").in("sphere"), rows("textbook, double").in("sphere"), 0.67, 1.33)}),
        claim("triangles-times-pixels",
              "A raster's time grows with the triangles, in proportion where pixels are few; that of rays hardly does, "
              "and grows with the pixels.",
              {slope(of::time, rows("raster").in("32 x 32 pixels"), 0.85, 1.05),
               slope(of::time, rows("rays").in("32 x 32 pixels"), -0.05, 0.15),
               slope(of::time, rows("rays").in("512 x 512 pixels"), 0, 0.15),
               ratio(of::time, rows("rays").in("512 x 512 pixels"), rows("rays").in("32 x 32 pixels"), 150, 600)}),
        claim(
            "where-they-cross",
            "Rays are faster with 1024 pixels and 4096 triangles or more, with 16384 pixels from 16384 triangles on, "
            "and with 262144 pixels at a million; a raster is faster with 16384 pixels up to 4096 triangles, and with "
            "262144 pixels up to 65536.",
            {ratio(of::time, rows("rays").in("32 x 32 pixels").from(4096), rows("raster").in("32 x 32 pixels"), 0, 1),
             ratio(of::time, rows("rays").in("128 x 128 pixels").from(16384), rows("raster").in("128 x 128 pixels"), 0,
                   1),
             ratio(of::time, rows("rays").in("512 x 512 pixels").at(1048576), rows("raster").in("512 x 512 pixels"), 0,
                   1),
             ratio(of::time, rows("raster").in("128 x 128 pixels").upTo(4096), rows("rays").in("128 x 128 pixels"), 0,
                   1),
             ratio(of::time, rows("raster").in("512 x 512 pixels").upTo(65536), rows("rays").in("512 x 512 pixels"), 0,
                   1)}),
        note("Rays ask a tree that is there already; a raster needs none. Both run on one thread of the processor: a "
             "graphics card does the same by thousands."),
    };
    return study;
}

const bool studied = addStudy("ray-cast", study());

}  // namespace
}  // namespace mv::ray_cast

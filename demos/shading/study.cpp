// The readouts of shading, and its study: its highlights against those of the exact sphere.
#include <algorithm>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <vector>

#include "exact_sphere.h"
#include "mv/demo/cached.h"
#include "mv/demo/lesson.h"
#include "shading.h"
#include "shared/seen_pixels.h"

namespace mv::shading {

using namespace claims;

void readOut(Gpu& gpu, const Settings& s, const Frame&, Numbers& numbers) {
    const vec3 light = direction(-s.angle), view = direction(s.viewAngle);
    numbers.set("triangles", gpu.body->count() / 3.0);
    numbers.set("matching", matchingAt(gpu, s));
    numbers.set("forth", reflectance(s.lobe, direction(0), light, view, s.exponent));
    numbers.set("back", reflectance(s.lobe, direction(0), view, light, s.exponent));
}

namespace {

Reference exactHighlight(const Demo& demo, const ReferenceFrame& frame) {
    const ExactSphere sphere(settingsOf<Settings>(demo), frame);
    Reference reference{.values = sphere.picture(frame.width(), frame.height(), 8)};
    reference.regions = regionsOfSeen(reference.values);
    if (frame.ownError) {
        reference.ownError =
            rmsBetween(reference.values, sphere.picture(frame.width(), frame.height(), 16)).value_or(0);
    }
    return reference;
}

// The place of the highlight, in pixels from the left and from above, how many pixels have half of the largest exact
// value or more, and its sum.
struct Spot {
    vec2 place{0};
    double size = 0, energy = 0;
};
Spot spotOf(const std::vector<double>& values, const std::vector<double>& exact, int width) {
    double largest = 0;
    for (const double value : exact) largest = std::max(largest, value);
    Spot spot;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        if (exact[i] < 0 || values[i] <= 0) continue;
        spot.energy += values[i];
        spot.place += values[i] * vec2(i % std::size_t(width), i / std::size_t(width));
        if (values[i] >= largest / 2) ++spot.size;
    }
    if (spot.energy > 0) spot.place /= spot.energy;
    return spot;
}

// Nothing where there is no exact highlight, or no shading.
struct Spots {
    Spot shown, exact;
};
std::optional<Spots> spots(Probing& probing) {
    const Settings s = settingsOf<Settings>(probing.demo());
    if (s.body != Body::sphere || s.shading == Shading::own) return {};
    constexpr int width = 480, height = 280;
    const auto measured = probing.measured(width, height);
    if (measured.empty()) return {};
    const FrameInfo frame(probing.frame().index(), width, height);
    // A quarter of the study's rays, and kept while the sphere rests: a window asks in each frame.
    static Cached<std::vector<double>, ExactSphere> kept;
    const ExactSphere sphere(s, frame);
    const std::vector<double>& exact =
        kept.of({sphere}, [](const ExactSphere& one) { return one.picture(width, height, 4); });
    const Spots both{spotOf({measured.begin(), measured.end()}, exact, width), spotOf(exact, exact, width)};
    if (both.exact.energy == 0) return {};
    return both;
}

std::vector<double> placeOfSpot(Probing& probing) {
    const auto both = spots(probing);
    if (!both || both->shown.energy == 0) return {};
    return {glm::distance(both->shown.place, both->exact.place)};
}

std::vector<double> amountOfSpot(Probing& probing) {
    const auto both = spots(probing);
    if (!both) return {};
    return {100 * both->shown.size / both->exact.size, 100 * both->shown.energy / both->exact.energy};
}

Study study() {
    Study study;
    study.quantity = "light of the highlight, more than a seventh of the radius inside the sphere's outline";
    study.reference = "the mean of 64 rays a pixel to the exact sphere, in double precision";
    study.makeReference = [](const Demo& demo, const ReferenceFrame& frame, const auto&) {
        return exactHighlight(demo, frame);
    };
    study.width = 480;
    study.height = 280;
    study.scenes = {{"exponent 10", {{"exponent", "10"}}}, {"exponent 200", {{"exponent", "200"}}}};
    for (const std::string shading : {"flat", "gouraud", "phong"}) {
        study.lines.push_back({.method = shading,
                               .settings = {{"shading", shading}},
                               .knob = "edges",
                               .values = {"8", "16", "32", "64", "128", "256"}});
    }
    study.reads = {"highlight", "material", "exponent", "lamp-turn", "lamp-height"};
    study.wrongBeyond = 1.0 / 255;
    const char* const wide = "exponent 10";
    const char* const narrow = "exponent 200";
    study.says = {
        claim("phong-as-the-square",
              "With the normals interpolated, the error falls nearly as the square of the edges: what is left is the "
              "mesh beside the sphere.",
              {slope(of::rms, rows("phong").in(wide), -2.1, -1.8)}),
        claim("coarse-is-nothing",
              "With 32 edges and fewer, flat and Gouraud shading show a narrow highlight as wrongly as if there were "
              "none: no corner lies in it.",
              {settled(of::rms, rows("flat", "gouraud").in(narrow).upTo(32), 1.01)}),
        claim("flat-falls-slowly",
              "Flat shading is off by a step from face to face, which halves at best when the edges double.",
              {slope(of::rms, rows("flat").in(wide).from(64), -1.1, -0.9)}),
        claim("fewer-edges", "Phong shading with 64 edges is at least twice as near as Gouraud shading with 128.",
              {ratio(of::rms, rows("phong").at(64), rows("gouraud").at(128), 0, 0.5)}),
        claim("pays", "From 64 edges on, nothing that is as fast is as near as Phong shading.",
              {unbeaten(rows("phong").from(64), rows("flat", "gouraud"))}),
        note("The outline is left out, since there all three show the mesh: a polygon.")};
    return study;
}

const bool studied = addStudy("shading", study());
const bool probed = addProbes(
    "shading",
    {{{{"highlight-off", "how far the highlight's middle is from where it belongs, of 480 pixels across", "px"}},
      placeOfSpot},
     {{{"highlight-size", "pixels with half of the exact highlight's most light or more, of as many as there should be",
        "%"},
       {"highlight-energy", "light of the whole highlight, of what it should be", "%"}},
      amountOfSpot}});

}  // namespace
}  // namespace mv::shading

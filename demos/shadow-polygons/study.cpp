// What measures shadow-polygons: points of the polygons, lit or dark by the computed shadows, against a ray from each to the light.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <string>

#include "mv/demo/lesson.h"
#include "mv/geometry/ray.h"
#include "shadow-polygons.h"
#include "shared/false_shadows.h"

namespace mv::shadow_polygons {
namespace {

struct Sample {
    std::size_t polygon;
    vec3 at;
};

// As many points on each polygon, about 4000 on all together, placed by chance: none lies on a shadow's edge but by a chance
// of roundings.
std::vector<Sample> samplesOf(const std::vector<FlatPolygon>& polygons) {
    std::mt19937 engine(2);
    const auto chance = [&engine] { return double(engine()) / 4294967296.0; };
    const std::size_t each = std::max<std::size_t>(1, 4096 / polygons.size());
    std::vector<Sample> samples;
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        const std::vector<vec3>& corners = polygons[i].corners;
        for (std::size_t k = 0; k < each; ++k) {
            const std::size_t fan = 2 + k % (corners.size() - 2);
            const double p = chance(), q = chance(), along = std::max(p, q), across = std::min(p, q);
            samples.push_back({i, corners[0] + (along - across) * (corners[fan - 1] - corners[0]) +
                                      across * (corners[fan] - corners[0])});
        }
    }
    return samples;
}

// Whether a point of the shadow's plane is inside.
bool holds(const std::vector<vec3>& corners, const vec3& point) {
    const vec3 normal = glm::cross(corners[1] - corners[0], corners[2] - corners[0]);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const vec3 along = corners[(i + 1) % corners.size()] - corners[i];
        if (glm::dot(normal, glm::cross(along, point - corners[i])) < 0) return false;
    }
    return true;
}

// Whether another polygon stands between the point and the light.
bool isHidden(const std::vector<FlatPolygon>& polygons, const Sample& sample, const vec3& light) {
    const TriangleTest<double> ray({sample.at, light - sample.at});
    for (std::size_t i = 0; i < polygons.size(); ++i) {
        if (i == sample.polygon) continue;
        const std::vector<vec3>& corners = polygons[i].corners;
        for (std::size_t k = 2; k < corners.size(); ++k) {
            const auto hit = ray(corners[0], corners[k - 1], corners[k]);
            if (hit && hit->t < 1) return true;
        }
    }
    return false;
}

}  // namespace

std::vector<double> values(const Settings& s) {
    const std::vector<FlatPolygon> polygons = polygonsOf(s);
    const Shadows shadows = shadowsOf(s.method, polygons, s.light);
    std::vector<std::vector<const std::vector<vec3>*>> darkOf(polygons.size());
    for (const Shadow& shadow : shadows.dark) darkOf[shadow.of.receiver].push_back(&shadow.corners);
    std::vector<double> lit;
    for (const Sample& sample : samplesOf(polygons)) {
        const auto& dark = darkOf[sample.polygon];
        lit.push_back(std::ranges::any_of(dark, [&](const auto* corners) { return holds(*corners, sample.at); }) ? 0
                                                                                                                 : 1);
    }
    return lit;
}

std::vector<std::pair<std::string, double>> valueCounts(const Settings& s) {
    const Shadows shadows = shadowsOf(s.method, polygonsOf(s), s.light);
    return {{"pairs compared", double(shadows.pairs.tested)},
            {"projections", double(shadows.pairs.kept.size())},
            {"shadows", double(shadows.dark.size())}};
}

namespace {

using namespace mv::claims;

Reference byRays(const Settings& s) {
    const std::vector<FlatPolygon> polygons = polygonsOf(s);
    Reference reference;
    for (const Sample& sample : samplesOf(polygons)) {
        reference.values.push_back(isHidden(polygons, sample, s.light) ? 0 : 1);
        ++reference.work;
    }
    return reference;
}

Study study() {
    Study study;
    study.quantity = "1 for a point that the light reaches, 0 for one in shadow; about 4000 points on the polygons";
    study.reference = "a ray in double precision from each point to the light, against all other polygons";
    study.makeReference = [](const Demo& demo, const ReferenceFrame&, const auto&) {
        return byRays(settingsOf<Settings>(demo));
    };
    study.reads = {"scene", "polygons", "paper-size", "light-x", "light-y", "light-z"};
    study.axis = ErrorAxis::fraction;
    study.ofValues = true;
    study.problem = "polygons";
    study.scenes = {{"papers", {{"scene", "papers"}}}};
    for (const std::string method : {"none", "all-pairs", "sphere"}) {
        study.lines.push_back({.method = method == "none"     ? "no shadow"
                                         : method == "sphere" ? "sphere"
                                                              : "all pairs",
                               .settings = {{"method", method}},
                               .knob = "polygons",
                               .values = {"4", "10", "30", "100", "250"}});
    }
    const auto none = rows("no shadow"), all = rows("all pairs"), sphere = rows("sphere");
    study.says = {
        claim("both-exact",
              "By both methods each point is lit or dark as its ray to the light shows; without shadows more than 1 % "
              "are not.",
              {zero(of::wrong, rows("all pairs", "sphere")), atLeast(of::wrong, none, 1)}),
        claim("n-squared", "All pairs are n (n - 1) projections: they grow with the exponent 2.",
              {slope(of::count("projections"), all, 1.95, 2.1)}),
        claim("nearly-n",
              "Those that the sphere leaves grow with the exponent 1, as long as all papers together have one area.",
              {slope(of::count("projections"), sphere, 0.9, 1.1)}),
        claim("comparing",
              "The pairs of caps that are compared grow with an exponent between 1 and 2, since only caps that overlap "
              "in x are.",
              {slope(of::count("pairs compared"), sphere, 1.4, 1.9)}),
        claim("in-time",
              "Of 250 polygons the sphere finds the shadows in less than a tenth of the time that all pairs take.",
              {ratio(of::time, sphere.at(250), all.at(250), 0, 0.1)}),
        note("Timed are the making of the polygons, the choice of pairs, the projections, and the question at some "
             "4000 points, which is all that "
             "no shadow does."),
    };
    return study;
}

[[maybe_unused]] const bool studied = addStudy("shadow-polygons", study());
[[maybe_unused]] const bool probed =
    addProbes("shadow-polygons", {wrongShadows("pixels of a coarse grid whose shadow is not what rays show")});

}  // namespace
}  // namespace mv::shadow_polygons

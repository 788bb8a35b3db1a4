// The readouts of ray-trace, and its study: the noise of a few samples, and the time to find a triangle among
// many.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "mv/demo/lesson.h"
#include "mv/math/transform.h"
#include "ray-trace.h"

namespace mv::ray_trace {

void readOut(Gpu&, const Settings& s, const Made& made, const Frame&, Numbers& numbers) {
    const TracePicture& picture = made.picture;
    const double pixels = double(picture.light().size());
    double all = 0, most = 0, off = 0;
    for (std::size_t i = 0; i < picture.light().size(); ++i) {
        all += picture.cut()[i];
        most = std::max(most, picture.cut()[i]);
        const vec3 sum = picture.light()[i] + picture.cut()[i] - 1.0;
        off = std::max({off, std::abs(sum.x), std::abs(sum.y), std::abs(sum.z)});
    }
    numbers.set("rays", double(picture.rays()) / pixels);
    numbers.set("cut", 100 * all / pixels);
    numbers.set("cut-most", 100 * most);
    if (s.room == TracedRoom::white) numbers.set("missing", off);
}

namespace {

constexpr int width = 24, height = 16, seeds = 8;  // of values()
constexpr int manySamples = 4096;

// All passes that count, one after the other.
TracePicture whole(const TracePicture::Plan& plan) {
    TracePicture picture;
    picture.pass(plan, 0);
    for (int pass = TracePicture::passesOf(0); pass < TracePicture::passesOf(plan.samples); ++pass)
        picture.pass(plan, pass);
    return picture;
}
double grey(const vec3& light) { return (light.x + light.y + light.z) / 3; }

// Kept, so that the time of finding triangles is not that of preparing to.
std::shared_ptr<const TriangleFinder> keptFinder(const Settings& s) {
    static MadeFor<TracedRoom, RayStructure, int> keptFor;
    static std::shared_ptr<const TriangleFinder> kept;
    if (keptFor.changed(s.room, s.structure, s.triangles)) kept = finderOf(s);
    return kept;
}

}  // namespace

// The colours of a picture of 48 x 32 pixels, one ray for each.
static std::vector<double> colorsOf(TracePicture::Plan plan) {
    plan.pattern = SamplePattern::regular;
    plan.samples = 1;
    std::vector<double> all;
    const TracePicture picture = whole(plan);
    for (const vec3& light : picture.light()) all.insert(all.end(), {light.x, light.y, light.z});
    return all;
}

// The middle of a picture of 48 x 32 pixels for each of eight seeds, as grey; of triangles the t of a thousand rays, 0 for none;
// of strips, which rays meet again what they leave; of the glass ball colours.
std::vector<double> values(const Settings& s) {
    if (s.room == TracedRoom::strips) return againOffStrips(s.triangles, s.leave);
    std::vector<double> all;
    if (s.room == TracedRoom::teapot) {
        const TracePicture::Plan plan = planOf(s, 40, 25, keptFinder(s));
        for (const Ray& ray : raysThrough(plan)) {
            const auto hit = plan.scene.mesh->nearest(ray);
            all.push_back(hit ? hit->hit.t : 0);
        }
        return all;
    }
    if (s.room == TracedRoom::glassBall) return colorsOf(planOf(s, 48, 32, {}));
    for (int one = 1; one <= seeds; ++one) {
        TracePicture::Plan plan = planOf(s, width, height, {});
        plan.view.fovy = halved(plan.view.fovy);
        plan.seed = static_cast<std::uint32_t>(100 * s.seed + one);
        const TracePicture picture = whole(plan);
        for (const vec3& light : picture.light()) all.push_back(grey(light));
    }
    return all;
}

// The spread of the seeds' mean squares, each taken from the mean of all seeds' pictures.
std::vector<std::pair<std::string, double>> valueCounts(const Settings& s) {
    if (s.room == TracedRoom::teapot || s.room == TracedRoom::strips || s.room == TracedRoom::glassBall) return {};
    const std::vector<double> greys = values(s);
    constexpr std::size_t pixels = std::size_t{width} * height;
    std::vector<double> mean(pixels, 0), squares(seeds, 0);
    for (std::size_t i = 0; i < greys.size(); ++i) mean[i % pixels] += greys[i] / seeds;
    for (std::size_t i = 0; i < greys.size(); ++i)
        squares[i / pixels] += (greys[i] - mean[i % pixels]) * (greys[i] - mean[i % pixels]);
    double sum = 0, deviation = 0;
    for (const double one : squares) sum += one / seeds;
    for (const double one : squares) deviation += (one - sum) * (one - sum) / (seeds - 1);
    return {{"deviation of the seeds (%)", sum > 0 ? 100 * std::sqrt(deviation) / sum : 0}};
}

namespace {

using namespace mv::claims;

// The subject of the picture, without its sampling; Fresnel's parts exact, the squares asked and not averaged.
TracePicture::Plan referencePlan(const Demo& demo, int columns, int rows) {
    Settings s = settingsOf<Settings>(demo);
    s.fresnel = Fresnel::exact;
    s.filtered = false;
    return planOf(s, columns, rows, {});  // of a teapot the reference asks the triangles itself
}

// A sequence of its own seed, of many samples; for each of the demo's seeds the same picture. References are kept:
// whoever tries one knob after the other asks for the same picture again and again.
Reference ofManySamples(const Demo& demo) {
    static std::map<std::string, Reference> made;
    std::string of;
    for (const char* knob : {"room", "depth", "shadows", "lamp-size", "index", "eye-turn", "eye-height", "globe-turn"})
        of += demo.word(knob) + " ";
    Reference& reference = made[of];
    if (!reference.values.empty()) return reference;
    TracePicture::Plan plan = referencePlan(demo, width, height);
    plan.view.fovy = halved(plan.view.fovy);
    plan.pattern = SamplePattern::sequence;
    plan.samples = manySamples;
    plan.seed = 12345;
    const TracePicture picture = whole(plan);
    for (int seed = 0; seed < seeds; ++seed) {
        for (const vec3& light : picture.light()) reference.values.push_back(grey(light));
    }
    reference.work = double(picture.rays());
    return reference;
}

// Every triangle asked, by the textbook's form: what is beside it in the same place has the same t.
Reference everyTriangle(const Demo& demo) {
    const int cells = static_cast<int>(std::lround(std::sqrt(demo.number("triangles") / 64)));
    const std::vector<SceneTriangle> triangles = teapotTriangles(cells);
    Reference reference;
    for (const Ray& ray : raysThrough(referencePlan(demo, 40, 25))) {
        double first = 0;
        for (const SceneTriangle& in : triangles) {
            const vec3 ab = in.b - in.a, ac = in.c - in.a, across = glm::cross(ray.direction, ac);
            const double determinant = glm::dot(ab, across);
            if (determinant == 0) continue;
            const vec3 from = ray.origin - in.a, around = glm::cross(from, ab);
            const double u = glm::dot(from, across) / determinant, v = glm::dot(ray.direction, around) / determinant,
                         t = glm::dot(ac, around) / determinant;
            if (u >= 0 && v >= 0 && u + v <= 1 && t > 0 && (first == 0 || t < first)) first = t;
        }
        reference.values.push_back(first);
    }
    reference.work = double(triangles.size());
    return reference;
}

// No ray that leaves a floor upwards meets it again.
Reference noneAgain(const Demo&) {
    constexpr std::size_t rays = 100'000;
    return {.values = std::vector<double>(rays, 0), .work = double(rays)};
}

// The same rays, each traced for 256 wavelengths.
Reference ofManyWavelengths(const Demo& demo) {
    Settings s = settingsOf<Settings>(demo);
    s.fresnel = Fresnel::exact;
    TracePicture::Plan plan = planOf(s, 48, 32, {});
    plan.colors = ray_trace::colorsOf(s, 256);
    Reference reference;
    reference.values = colorsOf(plan);
    return reference;
}

Study study() {
    Study study;
    study.quantity =
        "the grey of 24 x 16 pixels, the middle of 48 x 32, by each of 8 seeds; of triangles t of 1000 rays to the "
        "teapot's; of leaving 1 for each of 100 000 rays that meets again what it leaves; of glass the colours of 48 x "
        "32 "
        "pixels";
    study.reference =
        "4096 samples a pixel of a sequence with a seed of its own; every triangle by the textbook's form; 0; the same "
        "rays for 256 wavelengths";
    study.makeReference = [](const Demo& demo, const ReferenceFrame&, const auto&) {
        if (demo.word("room") == "strips") return noneAgain(demo);
        if (demo.word("room") == "glass-ball") return ofManyWavelengths(demo);
        return demo.word("room") == "teapot" ? everyTriangle(demo) : ofManySamples(demo);
    };
    study.ofValues = true;
    study.reads = {"room",      "depth",     "shadows", "lamp-size",  "index", "eye-turn", "eye-height",
                   "triangles", "highlight", "falloff", "globe-turn", "abbe",  "filtered"};
    study.wrongBeyond = 0.02;
    study.problem = "triangles";
    study.scenes = {{"outlines", {{"room", "soft-shadow"}, {"eye-height", "5"}, {"lamp-size", "0"}}},
                    {"soft shadow", {{"room", "soft-shadow"}, {"eye-height", "5"}, {"lamp-size", "2"}}},
                    {"smooth", {{"room", "lamp"}, {"eye-height", "5"}, {"lamp-size", "2"}}},
                    {"globes", {{"room", "globes"}, {"lamp-size", "0"}}},
                    {"triangles", {{"room", "teapot"}}},
                    {"leaving", {{"room", "strips"}}},
                    {"glass", {{"room", "glass-ball"}, {"index", "1.7847"}, {"abbe", "25.68"}}}};
    for (const std::string pattern : {"random", "regular", "jittered", "sequence"})
        study.lines.push_back({.method = pattern,
                               .settings = {{"pattern", pattern}},
                               .knob = "samples",
                               .values = {"1", "4", "16", "64", "256"},
                               .scenes = {"outlines", "soft shadow", "smooth"}});
    for (const bool isFiltered : {false, true})
        study.lines.push_back({.method = isFiltered ? "averaged" : "one texel",
                               .settings = {{"filtered", isFiltered ? "on" : "off"}},
                               .knob = "samples",
                               .values = {"1", "4", "16", "64", "256"},
                               .scenes = {"globes"}});
    const std::vector<std::string> triangles{"1024", "4096", "16384", "65536", "262144", "1048576"};
    for (const std::string structure : {"none", "boxes", "grid", "tree"}) {
        const std::ptrdiff_t sizes = structure == "none" ? 4 : 6;
        study.lines.push_back({.method = structure,
                               .settings = {{"structure", structure}},
                               .knob = "triangles",
                               .values = {triangles.begin(), triangles.begin() + sizes},
                               .scenes = {"triangles"}});
    }
    for (const std::string leave : {"point", "components", "largest", "bounded"})
        study.lines.push_back({.method = leave,
                               .settings = {{"leave", leave}},
                               .knob = "triangles",
                               .values = {"1024", "16384", "262144", "1048576"},
                               .scenes = {"leaving"}});
    study.lines.push_back({.method = "wavelengths",
                           .settings = {},
                           .knob = "wavelengths",
                           .values = {"1", "3", "4", "8", "16", "32"},
                           .scenes = {"glass"}});
    const auto falls = [](const char* method, const char* scene, double power) {
        // The slope is of the mean square's power p / 2, within 0.15 of the former
        return slope(of::rms, rows(method).in(scene), power / 2 - 0.075, power / 2 + 0.075);
    };
    study.says = {
        claim("random", "At random the mean square falls as 1 by the samples, everywhere.",
              {falls("random", "outlines", -1), falls("random", "soft shadow", -1), falls("random", "smooth", -1)}),
        claim("outlines", "At outlines it falls as the power -1.5 in cells or in a sequence.",
              {falls("regular", "outlines", -1.5), falls("jittered", "outlines", -1.5),
               falls("sequence", "outlines", -1.5)}),
        claim("smooth", "Where all is smooth, as the power -2; in regular cells up to 64 samples.",
              {slope(of::rms, rows("regular").in("smooth").upTo(64), -1.075, -0.925), falls("jittered", "smooth", -2),
               falls("sequence", "smooth", -2)}),
        note(
            "A pixel's places and the lamp's are paired at random: what depends on both falls as 1 by the samples, and "
            "is the last that is left of the regular cells' error, and a part of a soft shadow's."),
        claim("soft-shadow", "In a soft shadow it falls faster than at random, too.",
              {slope(of::rms, rows("regular", "jittered", "sequence").in("soft shadow"), -0.825, -0.55)}),
        claim(
            "texture",
            "A globe's picture averaged over each ray's cone leaves at most 85 % of the error that one texel for each "
            "ray has, at any number of samples; the rest is the globes' outlines.",
            {ratio(of::rms, rows("averaged"), rows("one texel"), 0.5, 0.85)}),
        claim("texture-by-samples", "With more samples both come to the same picture, as outlines do.",
              {falls("averaged", "globes", -1.5), falls("one texel", "globes", -1.5)}),
        claim("same-triangle", "Each way to find a triangle finds the same.",
              {zero(of::wrong, rows("none", "boxes", "grid", "tree"))}),
        claim("every-triangle",
              "To ask every triangle takes time in proportion to their number, or a little more where they leave the "
              "cache.",
              {slope(of::time, rows("none"), 0.9, 1.25)}),
        claim("boxes", "With a box for each patch it is a part of that.",
              {ratio(of::time, rows("boxes").upTo(65536), rows("none"), 0, 0.4)}),
        claim("grid", "A grid takes about the cube root of their number.", {slope(of::time, rows("grid"), 0.1, 0.5)}),
        claim("tree", "A thousandfold the triangles takes the tree less than 3 times the time: about the logarithm, 2.",
              {ratio(of::time, rows("tree").at(1048576), rows("tree").at(1024), 1, 3)}),
        claim("one-index",
              "With one index for all wavelengths the glass ball's colours are wrong by more than four times what "
              "three wavelengths leave.",
              {ratio(of::rms, rows("wavelengths").at(1), rows("wavelengths").at(3), 4, HUGE_VAL)}),
        claim("three-for-glass",
              "Three wavelengths, one for each primary, leave more than ten times the error of 32, and 1 % of the "
              "colours wrong.",
              {ratio(of::rms, rows("wavelengths").at(3), rows("wavelengths").at(32), 10, HUGE_VAL),
               value(of::wrong, rows("wavelengths").at(3), 0.5, 1.5)}),
        claim("more-wavelengths", "From four on the error falls by the number of wavelengths, or faster.",
              {slope(of::rms, rows("wavelengths").from(4), -1.6, -1)}),
        claim("glass-alone", "They are traced where glass is met: 32 take less than 16 times the time of one.",
              {ratio(of::time, rows("wavelengths").at(32), rows("wavelengths").at(1), 1, 16)}),
        note("None stops at 65536 triangles: a million times a thousand rays would take the study minutes. The picture "
             "is made of the same rays; its knob stops earlier."),
        claim("leaves-the-floor",
              "Of the rays that leave a floor y = 0 from the point itself a quarter or more meet it again, and as many "
              "from off it by each coordinate's roundings, which are 0 along y.",
              {atLeast(of::wrong, rows("point", "components").in("leaving"), 25)}),
        claim("leaves-strips",
              "Off it by roundings of the largest coordinate 2 % or more do where triangles are 512 times as long as "
              "wide, and more where they are longer; with a bound none.",
              {atLeast(of::wrong, rows("largest").in("leaving"), 2), zero(of::wrong, rows("bounded").in("leaving"))}),
    };
    return study;
}

[[maybe_unused]] const bool added = addStudy("ray-trace", study());

}  // namespace
}  // namespace mv::ray_trace

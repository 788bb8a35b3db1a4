// What measures ray-trace: the noise of a few samples, and the time to find a triangle among many.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/math/transform.h"
#include "shared/trace_picture.h"

using namespace mv;
using namespace mv::claims;

namespace {

constexpr int width = 24, height = 16, seeds = 8;  // of the demo's values()
constexpr int manySamples = 4096;

// What the picture is of, without how it is sampled; Fresnel's parts exact, the squares asked and not averaged.
TracePicture::Plan planOf(const Demo& demo, int columns, int rows) {
    constexpr std::array words{"still-life", "teapot", "soft-shadow", "lamp", "white"};
    const auto room = static_cast<TracedRoom>(std::ranges::find(words, demo.word("room")) - words.begin());
    TracePicture::Plan plan;
    plan.options.shadows = demo.word("shadows") == "on";
    plan.options.depth = static_cast<int>(demo.number("depth"));
    plan.options.filtered = false;
    // Of a teapot the reference asks the triangles itself
    if (room != TracedRoom::teapot)
        plan.scene = tracedRoom(room, plan.options.shadows ? demo.number("lamp-size") : 0, demo.number("index"));
    plan.view.eye = vec3(rotateY(demo.number("eye-turn")) * vec4(0.3, demo.number("eye-height"), 6.2, 1));
    plan.width = columns;
    plan.height = rows;
    return plan;
}

// A sequence of its own seed, of many samples; for each of the demo's seeds the same picture. What was made is kept: who
// tries one knob after the other asks for the same picture again and again.
Reference ofManySamples(const Demo& demo) {
    static std::map<std::string, Reference> made;
    std::string of;
    for (const char* knob : {"room", "depth", "shadows", "lamp-size", "index", "eye-turn", "eye-height"})
        of += demo.word(knob) + " ";
    Reference& reference = made[of];
    if (!reference.values.empty()) return reference;
    TracePicture::Plan plan = planOf(demo, width, height);
    plan.view.fovy = halved(plan.view.fovy);
    plan.pattern = SamplePattern::sequence;
    plan.samples = manySamples;
    plan.seed = 12345;
    TracePicture picture;
    picture.pass(plan, 0);
    for (int pass = TracePicture::passesOf(0); pass < TracePicture::passesOf(plan.samples); ++pass)
        picture.pass(plan, pass);
    for (int seed = 0; seed < seeds; ++seed) {
        for (const vec3& light : picture.light()) reference.values.push_back((light.x + light.y + light.z) / 3);
    }
    reference.work = double(picture.rays());
    return reference;
}

// Every triangle asked, by the textbook's form: what is beside it in the same place has the same t.
Reference everyTriangle(const Demo& demo) {
    const int cells = static_cast<int>(std::lround(std::sqrt(demo.number("triangles") / 64)));
    const std::vector<SceneTriangle> triangles = teapotTriangles(cells);
    Reference reference;
    for (const Ray& ray : raysThrough(planOf(demo, 40, 25))) {
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

Study study() {
    Study study;
    study.quantity =
        "the grey of 24 x 16 pixels, the middle of 48 x 32, by each of 8 seeds; in the last scene t of 1000 rays to "
        "the teapot's triangles";
    study.reference =
        "4096 samples a pixel of a sequence with a seed of its own; in the last scene every triangle by the "
        "textbook's form";
    study.makeReference = [](const Demo& demo, const ReferenceFrame&, const auto&) {
        return demo.word("room") == "teapot" ? everyTriangle(demo) : ofManySamples(demo);
    };
    study.ofValues = true;
    study.wrongBeyond = 0.02;
    study.problem = "triangles";
    study.scenes = {{"outlines", {{"room", "soft-shadow"}, {"eye-height", "5"}, {"lamp-size", "0"}}},
                    {"soft shadow", {{"room", "soft-shadow"}, {"eye-height", "5"}, {"lamp-size", "2"}}},
                    {"smooth", {{"room", "lamp"}, {"eye-height", "5"}, {"lamp-size", "2"}}},
                    {"triangles", {{"room", "teapot"}}}};
    for (const std::string pattern : {"random", "regular", "jittered", "sequence"})
        study.lines.push_back({.method = pattern,
                               .settings = {{"pattern", pattern}},
                               .knob = "samples",
                               .values = {"1", "4", "16", "64", "256"},
                               .scenes = {"outlines", "soft shadow", "smooth"}});
    const std::vector<std::string> triangles{"1024", "4096", "16384", "65536", "262144", "1048576"};
    for (const std::string structure : {"none", "boxes", "grid", "tree"}) {
        const std::ptrdiff_t sizes = structure == "none" ? 4 : 6;
        study.lines.push_back({.method = structure,
                               .settings = {{"structure", structure}},
                               .knob = "triangles",
                               .values = {triangles.begin(), triangles.begin() + sizes},
                               .scenes = {"triangles"}});
    }
    const auto falls = [](const char* method, const char* scene, double power) {
        // Of the mean square's power p / 2, within 0.15 of the former
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
        note("None stops at 65536 triangles: a million times a thousand rays would take the study minutes. The picture "
             "is made of the same rays; its knob stops earlier."),
    };
    return study;
}

[[maybe_unused]] const bool added = addStudy("ray-trace", study());

}  // namespace

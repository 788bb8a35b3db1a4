// What measures environment: its sphere against rays in double precision.
#include <cmath>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "shared/shiny_sphere.h"

using namespace mv;
using namespace mv::claims;

namespace {

ShinySphere sphereOf(const Demo& demo, const FrameInfo& frame) {
    const std::string material = demo.word("material");
    return {.room = {demo.number("room"), demo.number("ball") + (demo.word("moving") == "on" ? frame.index() : 0)},
            .material = material == "mirror"  ? ShinySphere::Material::mirror
                        : material == "glass" ? ShinySphere::Material::glass
                                              : ShinySphere::Material::metal,
            .metal = material == "copper" ? copper : gold,
            .index = demo.number("index"),
            .innerReflections = 100};
}

Reference byRays(const Demo& demo, const FrameInfo& frame) {
    const bool isThere = demo.word("body") == "sphere" && demo.word("around") == "room";
    if (!isThere) throw Error("--body", "must be the sphere, in the room, to be measured", demo.word("body"));
    Reference reference{.values = sphereOf(demo, frame).picture(demo.scene(frame), frame.width(), frame.height())};
    reference.regions.reserve(reference.values.size());
    for (const double value : reference.values) {
        reference.regions.push_back(value < 0 ? -1 : 0);
        reference.work += value < 0 ? 0 : 1;
    }
    return reference;
}

std::vector<double> errorNow(Probing& probing) {
    const Demo& demo = probing.demo();
    if (demo.word("body") != "sphere" || demo.word("around") != "room") return {};
    constexpr int side = 120;
    const std::vector<float> shown = probing.measured(side, side);
    if (shown.empty()) return {};
    const FrameInfo frame(probing.frame().index(), side, side);
    const std::vector<double> exact = sphereOf(demo, frame).picture(demo.scene(frame), side, side);
    double squares = 0, count = 0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
        if (exact[i] < 0 || shown[i] < 0) continue;
        squares += std::pow(exact[i] - double(shown[i]), 2);
        ++count;
    }
    if (count == 0) return {};
    return {std::sqrt(squares / count)};
}

Study study() {
    Study study;
    study.quantity = "luminance of the sphere, 0..1, up to 0.95 of its radius from its middle";
    study.reference = "a ray a pixel to the exact sphere and from there on, in double precision";
    study.makeReference = [](const Demo& demo, const ReferenceFrame& frame, const auto&) {
        return byRays(demo, frame);
    };
    study.width = 320;
    study.height = 320;
    study.problem = "room";
    study.wrongBeyond = 0.05;
    study.scenes = {
        {"mirror", {{"material", "mirror"}}}, {"gold", {{"material", "gold"}}}, {"glass", {{"material", "glass"}}}};
    const auto add = [&](const std::string& method, std::vector<KnobSetting> settings,
                         std::vector<std::string> scenes) {
        study.lines.push_back({.method = method,
                               .settings = std::move(settings),
                               .knob = "room",
                               .values = {"2", "4", "8", "16", "32", "64"},
                               .scenes = std::move(scenes)});
    };
    add("direction", {{"lookup", "direction"}, {"refract", "inside"}}, {"mirror", "glass"});
    add("direction, faces drawn anew", {{"lookup", "direction"}, {"keep", "off"}}, {"mirror"});
    add("direction, 64 texels", {{"lookup", "direction"}, {"cube-size", "64"}}, {"mirror"});
    add("walls", {{"lookup", "walls"}, {"refract", "inside"}}, {"mirror", "glass"});
    add("walls, 64 texels", {{"lookup", "walls"}, {"cube-size", "64"}}, {"mirror"});
    add("rays", {{"lookup", "rays"}, {"refract", "inside"}}, {});
    add("rays, Schlick", {{"lookup", "rays"}, {"refract", "inside"}, {"fresnel", "schlick"}}, {"gold", "glass"});
    add("rays, both surfaces", {{"lookup", "rays"}, {"refract", "both"}}, {"glass"});
    add("rays, first surface", {{"lookup", "rays"}, {"refract", "first"}}, {"glass"});
    return study;
}

const bool studied = addStudy("environment", study());
const bool probed = addProbes(
    "environment",
    {{{{"error", "root mean square of the sphere's luminance, against rays in double precision"}}, errorNow}});

}  // namespace

// The readouts of environment, and its study: its sphere against rays in double precision.
#include <string>
#include <vector>

#include "environment.h"
#include "mv/demo/lesson.h"
#include "mv/demo/seen.h"
#include "mv/gl/functions.h"
#include "mv/math/color.h"
#include "shared/seen_pixels.h"
#include "shiny_sphere.h"

namespace mv::environment {

using namespace claims;

// The body alone, without the surroundings behind it.
void drawMeasured(Gpu& gpu, const Settings& s, const Frame& frame) {
    glEnable(GL_DEPTH_TEST);
    drawMirroring(gpu, s, seen(sceneOf(s, frame), frame), frame);
}

void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers) {
    if (!frame.measuring()) numbers.set("faces-drawn", gpu.facesDrawn);
    numbers.set("head-on", luminance(coatingOf(s).reflected(1)));
    if (s.material == Material::glass && s.index < 1) numbers.set("limit", degrees(std::asin(s.index)));
}

namespace {

ShinySphere sphereOf(const Settings& s, const FrameInfo& frame) {
    return {.room = roomOf(s, frame), .coating = coatingOf(s), .innerReflections = 100};
}

// The sphere, in the room.
bool isMeasured(const Settings& s) { return isSphere(s) && inRoom(s); }

Reference byRays(const Settings& s, const FrameInfo& frame) {
    if (!isMeasured(s))
        throw Error("--body", "must be the sphere, in the room, to be measured",
                    s.model.isSet() ? s.model.name : nameOf(s.body));
    Reference reference{.values = sphereOf(s, frame).picture(sceneOf(s, frame), frame.width(), frame.height())};
    reference.regions.reserve(reference.values.size());
    for (const double value : reference.values) {
        reference.regions.push_back(value < 0 ? -1 : 0);
        reference.work += value < 0 ? 0 : 1;
    }
    return reference;
}

std::vector<double> errorNow(Probing& probing) {
    const auto s = settingsOf<Settings>(probing.demo());
    if (!isMeasured(s)) return {};
    constexpr int side = 120;
    const std::vector<float> shown = probing.measured(side, side);
    if (shown.empty()) return {};
    const FrameInfo frame(probing.frame().index(), side, side);
    return rmsOfShown(shown, sphereOf(s, frame).picture(sceneOf(s, frame), side, side));
}

Study study() {
    Study study;
    study.quantity = "luminance of the sphere, 0..1, up to 0.95 of its radius from its middle";
    study.reference = "a ray a pixel to the exact sphere and from there on, in double precision";
    study.makeReference = [](const Demo& demo, const ReferenceFrame& frame, const auto&) {
        return byRays(settingsOf<Settings>(demo), frame);
    };
    study.reads = {"around", "body",    "material", "index",  "room",   "ball",
                   "moving", "picture", "model",    "spin-x", "spin-y", "distance"};
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
    const auto direction = rows("direction").in("mirror"), walls = rows("walls").in("mirror");
    study.says = {
        claim("half-the-angle",
              "By direction alone, each doubling of a room from 8 on leaves 0.5 to 0.71 of a mirror's error: smooth "
              "tiles "
              "are moved by half as much, and at edges half as many pixels are wrong.",
              {ratio(of::rms, direction.at(16), direction.at(8), 0.5, 0.71),
               ratio(of::rms, direction.at(32), direction.at(16), 0.5, 0.71),
               ratio(of::rms, direction.at(64), direction.at(32), 0.5, 0.71)}),
        claim("walls-known", "Knowing where the walls are leaves at most a third of it, up to a room of 64.",
              {ratio(of::rms, walls, direction, 0, 1.0 / 3)}),
        claim("texels", "What is then left in large rooms are the texels: with a quarter of them a side it is larger.",
              {ratio(of::rms, rows("walls, 64 texels").from(16), walls, 1.5, 20)}),
        claim("kept", "Of a still frame none of the six faces is drawn, and all where they are not kept.",
              {zero(of::count("faces of the cube drawn"), direction),
               value(of::count("faces of the cube drawn"), rows("direction, faces drawn anew"), 6, 6)}),
        claim("light-inside", "Glass without what is reflected inside it is off by more than three times as much.",
              {ratio(of::rms, rows("rays, both surfaces"), rows("rays").in("glass"), 3, HUGE_VAL)}),
        claim("way-out", "Glass that is looked up where light enters it is off by more than one that lets it out.",
              {ratio(of::rms, rows("rays, first surface"), rows("rays, both surfaces"), 1.5, 100)}),
        claim("rays-here",
              "In this room, of a box and four balls, rays take about as long as a lookup with the walls known.",
              {ratio(of::time, rows("rays").in("mirror"), walls, 0.4, 1.6)}),
        note("Times are those of a still frame, with the room around the sphere drawn too.")};
    return study;
}

const bool studied = addStudy("environment", study());
const bool probed = addProbes(
    "environment",
    {{{{"error", "root mean square of the sphere's luminance, against rays in double precision"}}, errorNow}});

}  // namespace
}  // namespace mv::environment

// procedural: patterns that are functions of the surface point, looked at from nearer and nearer, and from far away.
//
// Claims (each is a test in tests/claims/procedural.cpp; X52 in docs/stability.md is a pattern 2^24 from the origin):
// - [no-texels] Zoomed in a million times, with the origin near, each pixel is what double precision computes.
// - [float-breaks] With the origin far, neighbouring pixels round to the same point, and the picture falls into blocks.
// - [near-is-far] Moved 2^24 from the origin, the pattern is computed as exactly as before where the origin is near.
// - [finer-by-name] In a small picture the audit names each octave that is finer than every pixel; leave-out computes none.
// - [goes-through] A body is cut out of its pattern: the same point has the same number on the sphere and on the wall.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/gl.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/procedural.h"

using namespace mv;

namespace {

enum class View { wall, floor, sphere };
enum class Filter { none, samples, leaveOut };
enum class Origin { near, far };

// The colours of 0 and 1, in linear light.
struct Ramp {
    vec3 dark, light;
};
const std::array<Ramp, 4> ramps{{{{0.45, 0.42, 0.38}, {0.52, 0.10, 0.05}},
                                 {{0.10, 0.035, 0.012}, {0.50, 0.24, 0.09}},
                                 {{0.06, 0.07, 0.10}, {0.85, 0.84, 0.80}},
                                 {{0.01, 0.03, 0.12}, {0.95, 0.93, 0.85}}}};

// Depths from the eye: of the sphere's nearest point, and of the floor in the middle and at the lower edge.
constexpr double frontOfSphere = 4.2 - 1.3, middleOfFloor = 5.1, frontOfFloor = 1.81;

struct Procedural final : Demo {
    Choice<Pattern> pattern{this, "pattern", Pattern::marble, {{"brick"}, {"wood"}, {"marble"}, {"noise"}}, "which"};
    Choice<View> view{this,
                      "view",
                      View::sphere,
                      {{"wall", "straight on, to be zoomed"}, {"floor", "to the horizon"}, {"sphere", "cut out of it"}},
                      "what has the pattern"};
    Whole octaves{this, "octaves", 5, {1, 8}, "of noise, each half as large and half as strong as the one before"};
    Real zoom{this, "zoom", 1, {1, 1e9, Scale::logarithmic}, "how much of the wall one sees: 3 units high, by this"};
    Toggle endless{this, "endless", true, "octaves go on with the zoom: finer ones come for those that grow too large"};
    Real distance{this, "distance", 0, {0, 16'777'216}, "how far along x all of it is from the origin"};
    Choice<Origin> origin{this,
                          "origin",
                          Origin::near,
                          {{"near", "of the floats, in the middle of the picture"},
                           {"far", "of the floats, in the world's: each point is rounded to floats"}},
                          "where the shader computes from"};
    Choice<Filter> filter{this,
                          "filter",
                          Filter::none,
                          {{"none", "the middle of each pixel"},
                           {"samples", "the mean of several points of a pixel"},
                           {"leave-out", "without what is smaller than a pixel"}},
                          "what a pixel shows of a pattern that is finer than it"};
    Whole samples{this, "samples", 4, {2, 8}, "a side of a pixel, with filter samples"};
    Angle turn{this, "turn", 25, "of the sphere"};

    Readout pixel{this, "pixel", "how far apart neighbouring pixels' points are, in the middle", "units"};
    Readout grain{this, "float-step", "how far apart floats are there, with the origin far", "units"};

    Program program;
    OnDemand<Mesh> flat{withoutTexCoords(square()), "square"}, ball{withoutTexCoords(sphere(1.3, 128, 64)), "sphere"};

    Procedural() {
        bindWheel(zoom, 0.1);
        bindKeys(Key::down, Key::up, zoom, 0.25);
        bindKeys(Key::left, Key::right, turn, 5);
        zoom.onlyWhen([this] { return view == View::wall; }, "only the wall is zoomed");
        endless.onlyWhen([this] { return view == View::wall && pattern != Pattern::brick; },
                         "only a wall is zoomed, and bricks have no octaves");
        octaves.onlyWhen([this] { return pattern != Pattern::brick; }, "bricks have no octaves");
        samples.onlyWhen([this] { return filter == Filter::samples; }, "each pixel is asked once");
        turn.onlyWhen([this] { return view == View::sphere; }, "only the sphere turns");
    }

    void init() override { program = Program("procedural"); }

    void draw(const Frame& frame) override {
        const PatternPlace at = where();
        const Ramp& ramp = ramps.at(static_cast<std::size_t>(Pattern(pattern)));
        glEnable(GL_DEPTH_TEST);
        program.use();
        program.set("clipFromBody", clipFromBody(frame));
        program.set("viewFromBody", rotateX(20) * rotateY(turn));
        program.set("offsetFromBody", offsetFromBody(frame));
        program.set("pattern", static_cast<int>(at.pattern));
        program.set("dark", ramp.dark);
        program.set("light", ramp.light);
        program.set("samples", filter == Filter::samples ? int(samples) : 1);
        program.set("leavesOut", filter == Filter::leaveOut);
        program.set("isRound", view == View::sphere);
        program.set("isFloor", view == View::floor);
        setCentre(at);
        (view == View::sphere ? *ball : *flat).draw();

        pixel = pixelAt(frame, view == View::floor ? middleOfFloor : frontOfSphere);
        nameFinerOctaves(frame, at);
        const auto far = static_cast<float>(std::max(std::abs(at.centre.x), 1e-30));
        grain = double(std::nextafter(far, HUGE_VALF)) - double(far);
    }

    // How far apart the points of neighbouring pixels are across a surface at this depth; the wall is seen without perspective.
    double pixelAt(const FrameInfo& frame, double depth) const {
        if (view == View::wall) return 3 / (zoom * frame.height());
        return 2 * depth * std::tan(radians(20)) / frame.height();
    }

    // An octave of which no pixel keeps anything costs as much as another; only leave-out does not compute it.
    void nameFinerOctaves(const Frame& frame, const PatternPlace& at) const {
        if (filter == Filter::leaveOut || pattern == Pattern::brick) return;
        const double finest = pixelAt(frame, view == View::floor ? frontOfFloor : frontOfSphere) /
                              (filter == Filter::samples ? int(samples) : 1);
        for (const auto& octave : at.octaveList()) {
            // A wave is two cells long, as in shaders/include/procedural.glsl.
            if (octave.weight == 0 || 0.5 * octave.frequency * finest < 1) continue;
            frame.needless("octave of frequency " + numberText(octave.frequency) + ", finer than every pixel");
        }
    }

    // The middle of what is seen.
    PatternPlace where() const {
        const bool zooms = view == View::wall && endless;
        return {pattern, octaves, zooms ? std::log2(double(zoom)) : 0.0, patternCentre(distance)};
    }

    // With the origin near, the shader gets of the centre what double precision knows: for each octave the cell and the place
    // in it. With the origin far it gets the centre as floats, adds, and knows of no cell but the first.
    void setCentre(const PatternPlace& at) {
        const bool isFar = origin == Origin::far;
        PatternPlace place = at;
        if (isFar) place.centre = vec3(0);
        std::vector<PatternPlace::Octave> list = place.octaveList();
        list.resize(PatternPlace::most, {1, 0, {}, vec3(0)});
        std::vector<vec3> low, high, in, known;
        for (const auto& octave : list) {
            low.push_back(lowOf(octave));
            high.push_back(highOf(octave));
            in.push_back(octave.inCell);
            known.emplace_back(octave.frequency, octave.weight, octave.weight > 0);
        }
        program.set("cellLow", low);
        program.set("cellHigh", high);
        program.set("inCell", in);
        program.set("octaves", known);
        const auto base = place.base();
        program.set("baseLow", lowOf(base));
        program.set("baseHigh", highOf(base));
        program.set("inBase", base.inCell);
        // Wood: how far from its axis the centre is, without the whole rings.
        const double away = glm::length(vec2(place.centre)), rings = 4 * away;
        program.set("ringsAt", away > 4 ? vec3(vec2(place.centre) / away, 1 / away) : vec3(0));
        program.set("ringBase", rings - std::floor(rings));
        program.set("ringCentre", away > 4 ? vec3(0) : place.centre);
        program.set("fromFar", isFar);
        program.set("far", isFar ? at.centre : vec3(0));
    }
    // Halves of 16 bits, which floats hold.
    static vec3 lowOf(const PatternPlace::Octave& octave) {
        const auto& c = octave.cell;
        return {double(c[0] & 0xffff), double(c[1] & 0xffff), double(c[2] & 0xffff)};
    }
    static vec3 highOf(const PatternPlace::Octave& octave) {
        const auto half = [](std::int64_t cell) { return double(static_cast<std::int16_t>((cell >> 16) & 0xffff)); };
        return {half(octave.cell[0]), half(octave.cell[1]), half(octave.cell[2])};
    }

    // Square and sphere, and which points of the pattern they are, measured from the centre.
    mat4 clipFromBody(const FrameInfo& frame) const {
        if (view == View::wall) return scale(2) * rotateX(90);
        const mat4 clipFromView = perspective(40, frame.aspect(), 0.1, 1000);
        if (view == View::sphere)
            return clipFromView * lookAt(vec3(0, 0, 4.2), vec3(0), vec3(0, 1, 0)) * rotateX(20) * rotateY(turn);
        return clipFromView * lookAt(vec3(0, 1, 0), vec3(0, 0.6, -2), vec3(0, 1, 0)) * translate(0, 0, -200) *
               scale(400);
    }
    mat4 offsetFromBody(const FrameInfo& frame) const {
        if (view == View::sphere) return mat4(1);
        if (view == View::floor) return rotateX(90) * scale(400) * translate(0, 0, -0.5);
        return scale(3 * frame.aspect() / zoom, 3 / zoom, 1) * rotateX(90);
    }

    Scene scene(const FrameInfo& frame) const override {
        Scene scene;
        scene.objects = {{.name = "body", .mesh = view == View::sphere ? sphere(1.3, 128, 64) : square()}};
        scene.viewFromWorld = clipFromBody(frame);
        return scene;
    }
};

constexpr Declaration declaration{
    .name = "procedural",
    .sentence = "Brick, wood, marble and noise as functions of the surface point.",
    .lookFor = "A pattern in space has no seams and no texels: zoom in, and only the floats' precision ends it.",
    .chapter = "Light, colour and texture",
    .number = 29,
    .width = 800,
    .height = 600,
    .background = vec4(0.75, 0.82, 0.90, 1),
    .needs = {.depth = true},
    .presets =
        {
            {"marble", "A sphere cut out of marble: the layers go through it."},
            {"wood", "Rings about an axis, bent by noise.", {{"pattern", "wood"}, {"turn", "60"}}},
            {"bricks", "A wall of bricks, each with a shade of its own.", {{"pattern", "brick"}, {"view", "wall"}}},
            {"a-million",
             "Zoomed in a million times, with finer octaves in the place of those that grew too large.",
             {{"pattern", "noise"}, {"view", "wall"}, {"zoom", "1e+06"}}},
            {"broken",
             "As far in, with points rounded to floats first: their grid.",
             {{"pattern", "noise"}, {"view", "wall"}, {"zoom", "1e+06"}, {"origin", "far"}}},
            {"horizon",
             "Bricks to the horizon, one point a pixel: what is finer than a pixel becomes another pattern.",
             {{"pattern", "brick"}, {"view", "floor"}}},
        },
};

const bool added = addDemo<Procedural, declaration>();

}  // namespace

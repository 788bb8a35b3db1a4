// procedural: patterns that are functions of the surface point, seen from nearer and nearer, and from far away.
#include "procedural.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <vector>

#include "mv/gl/functions.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/narrow_view.h"

namespace mv::procedural {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    if (isFromTexture(s)) return drawFromTexture(gpu, s, frame);  // solid.cpp

    // Place the body, and map each of its points to a point of the pattern
    const Program& program = *gpu.byFormula;
    program.use();
    const BodyMatrices matrices = bodyMatrices(s, frame);
    program.set("clipFromBody", matrices.clipFromBody);
    program.set("viewFromBody", matrices.viewFromBody);
    program.set("offsetFromBody", matrices.offsetFromBody);
    program.set("isRound", s.view == View::sphere);
    program.set("isFloor", s.view == View::floor);
    setCentre(program, s);

    // Choose the pattern, its colours, and how a pixel filters it
    program.set("pattern", static_cast<int>(s.pattern));
    program.set("dark", rampOf(s.pattern).dark);
    program.set("light", rampOf(s.pattern).light);
    program.set("samples", s.filter == Filter::samples ? s.samples : 1);
    program.set("leavesOut", s.filter == Filter::leaveOut);

    drawBody(gpu, s);
    nameFinerOctaves(s, frame);
}

// Draw a square for wall and floor, or a sphere.
void drawBody(Gpu& gpu, const Settings& s) {
    const std::array ofView{&gpu.flat, &gpu.flat, &gpu.ball};  // in the order of View
    glEnable(GL_DEPTH_TEST);
    (*ofView.at(std::size_t(s.view)))->draw();
}

// Set the centre of the pattern. With the origin near, the shader gets the cell of each octave and the place in it, from
// double precision. With the origin far, it gets the centre as floats and adds to it, and its cells count from the world's origin.
void setCentre(const Program& program, const Settings& s) {
    PatternPlace place = placeOf(s);
    program.set("fromFar", s.origin == Origin::far);
    program.set("far", place.centre);
    if (s.origin == Origin::far) place.centre = vec3(0);

    // Split the cell of each octave into halves that floats hold
    std::vector<PatternPlace::Octave> octaves = place.octaveList();
    octaves.resize(PatternPlace::most, {1, 0, {}, vec3(0)});
    std::vector<vec3> low, high, in, known;
    for (const auto& octave : octaves) {
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

    // For wood, count rings from the centre on: its direction from the axis and 1 / distance, and the part of a ring that it is in
    const double away = glm::length(vec2(place.centre)), rings = 4 * away;
    program.set("ringsAt", away > 4 ? vec3(vec2(place.centre) / away, 1 / away) : vec3(0));
    program.set("ringBase", rings - std::floor(rings));
    program.set("ringCentre", place.centre);
}

// The lower and the upper 16 bits of a cell.
vec3 lowOf(const PatternPlace::Octave& octave) {
    const auto& c = octave.cell;
    return {double(c[0] & 0xffff), double(c[1] & 0xffff), double(c[2] & 0xffff)};
}
vec3 highOf(const PatternPlace::Octave& octave) {
    const auto half = [](std::int64_t cell) { return double(static_cast<std::int16_t>((cell >> 16) & 0xffff)); };
    return {half(octave.cell[0]), half(octave.cell[1]), half(octave.cell[2])};
}

// The pattern's place in the middle of the view. With `endless`, octaves go on with the zoom; a texture has those that it was
// made with.
PatternPlace placeOf(const Settings& s) {
    const bool zooms = s.view == View::wall && s.endless && s.source == Source::formula;
    return {s.pattern, s.octaves, zooms ? std::log2(s.zoom) : 0.0, patternCentre(s.distance)};
}

static mat4 turnOf(const Settings& s) { return rotateX(20) * rotateY(s.turn); }
static mat4 clipFromWorld(const FrameInfo& frame, const vec3& eye, const vec3& at) {
    return perspective(fovyAcross(40, frame.aspect()), frame.aspect(), 0.1, 1000) * lookAt(eye, at, vec3(0, 1, 0));
}

// Place each body before the eye. `offsetFromBody` maps its points to the pattern, relative to the pattern's centre.
static BodyMatrices wallMatrices(const Settings& s, const FrameInfo& frame) {
    return {scale(2) * rotateX(90), turnOf(s), scale(3 * frame.aspect() / s.zoom, 3 / s.zoom, 1) * rotateX(90)};
}
static BodyMatrices floorMatrices(const Settings& s, const FrameInfo& frame) {
    return {clipFromWorld(frame, {0, 1, 0}, {0, 0.6, -2}) * translate(0, 0, -200) * scale(400), turnOf(s),
            rotateX(90) * scale(400) * translate(0, 0, -0.5)};
}
static BodyMatrices sphereMatrices(const Settings& s, const FrameInfo& frame) {
    return {clipFromWorld(frame, {0, 0, 4.2}, {0, 0, 0}) * rotateX(20) * rotateY(s.turn), turnOf(s), mat4(1)};
}
BodyMatrices bodyMatrices(const Settings& s, const FrameInfo& frame) {
    constexpr std::array ofView{wallMatrices, floorMatrices, sphereMatrices};  // in the order of View
    return ofView.at(std::size_t(s.view))(s, frame);
}

const Ramp& rampOf(Pattern pattern) {
    static const std::array<Ramp, 4> ramps{{{{0.45, 0.42, 0.38}, {0.52, 0.10, 0.05}},
                                            {{0.10, 0.035, 0.012}, {0.50, 0.24, 0.09}},
                                            {{0.06, 0.07, 0.10}, {0.85, 0.84, 0.80}},
                                            {{0.01, 0.03, 0.12}, {0.95, 0.93, 0.85}}}};
    return ramps.at(static_cast<std::size_t>(pattern));
}

}  // namespace mv::procedural

// A patch on its way through the stages. What is off is in no program.
#include <array>
#include <tuple>
#include <utility>

#include "gpu-stages.h"
#include "mv/demo/seen.h"
#include "mv/gl/gl.h"
#include "shared/wide_lines.h"

namespace mv::gpu_stages {

void drawStages(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Geometry stage = geometryStage(s.stages);
    frame.show("clipFromWorld", seen(sceneOf(s, frame), frame).clipFromWorld());
    gpu.passed = 0;

    // Send the patch's 16 points through the stages. Normals stand on the patch, so draw the patch before them
    if (s.stages.tessellation) glPatchParameteri(GL_PATCH_VERTICES, 16);
    if (stage == Geometry::normals) {
        prepare(gpu, s, Geometry::off, frame);
        drawCounted(gpu, s, Geometry::off, frame);
    }
    const Program& program = prepare(gpu, s, stage, frame);
    drawCounted(gpu, s, stage, frame);
    if (stage == Geometry::wireframe && s.stages.hidden && s.stages.fragments && !frame.measuring())
        drawHiddenLines(gpu, s, program, frame);

    // Count the primitives of each stage, for the table beside the patch (figure.cpp)
    countPrimitives(gpu, s, frame);
}

// Use the program of these stages, and set all uniforms that it has.
const Program& prepare(Gpu& gpu, const Settings& s, Geometry stage, const Frame& frame) {
    const Program& program = gpu.programs.of(filesOf(s.stages, stage));
    program.use();
    program.set("clipFromWorld", seen(sceneOf(s, frame), frame).clipFromWorld());
    program.set("bend", s.stages.bend);
    program.set("color", colorOf(s.stages, stage));
    const std::array<std::tuple<const char*, double, bool>, 3> ofStages{
        {{"inner", s.stages.inner, s.stages.tessellation},
         {"outer", outerLevel(s.stages), s.stages.tessellation},
         {"amount", s.stages.amount, hasAmount(stage)}}};
    for (const auto& [name, value, isThere] : ofStages) {
        if (isThere) program.set(name, value);
    }
    if (stage == Geometry::wireframe) setWireframe(program, frame);
    return program;
}

// A program has a file for each of its stages. Without the file, the pipeline has no such stage.
std::vector<std::string> filesOf(const Stages& s, Geometry stage) {
    const std::array<std::pair<std::string, bool>, 5> stages{
        {{"gpu-stages.vert", true},
         {"patch.tesc", s.tessellation},
         {evaluationOf(s), s.tessellation},
         {std::string(nameOf(stage)) + ".geom", stage != Geometry::off},
         {fragmentOf(stage), true}}};
    std::vector<std::string> files;
    for (const auto& [file, isOn] : stages) {
        if (isOn) files.push_back(file);
    }
    return files;
}

// The evaluation shader of a domain: for triangles or lines, or for points, of which the geometry shader makes hexagons.
const char* evaluationOf(const Stages& s) {
    constexpr std::array<std::array<const char*, 2>, 3> ofDomain{
        {{"patch.tese", "points.tese"}, {"triangles.tese", "triangle-points.tese"}, {"isolines.tese", ""}}};
    return ofDomain.at(static_cast<std::size_t>(domainOf(s))).at(geometryStage(s) == Geometry::shapes);
}

// Only the wireframe has a fragment shader of its own.
const char* fragmentOf(Geometry stage) {
    constexpr std::array files{"gpu-stages.frag", "wireframe.frag"};
    return files.at(stage == Geometry::wireframe);
}

// Lines are blue, faces orange.
vec3 colorOf(const Stages& s, Geometry stage) {
    const std::array colors{vec3(0.85, 0.55, 0.25), vec3(0.1, 0.3, 0.6)};
    return colors.at(stage == Geometry::normals || stage == Geometry::wireframe || domainOf(s) == Domain::isolines);
}

// Let the geometry shader measure in pixels, and draw the lines in front of the faces.
void setWireframe(const Program& program, const Frame& frame) {
    program.set("halfPicture", 0.5 * vec2(frame.width(), frame.height()) / double(lineWidth(frame)));
    program.set("isHidden", false);
}

// Draw again, and keep only the lines behind the faces. GL_MIN leaves the lines in front of them as dark as they are.
void drawHiddenLines(Gpu& gpu, const Settings& s, const Program& program, const Frame& frame) {
    program.set("isHidden", true);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendEquation(GL_MIN);
    drawCounted(gpu, s, Geometry::wireframe, frame);
}

// Without tessellation the cells of the control net are drawn, which are quads.
Domain domainOf(const Stages& s) { return s.tessellation ? s.domain : Domain::quads; }
// The geometry shaders of this demo take triangles or points, but no lines.
Geometry geometryStage(const Stages& s) { return domainOf(s) == Domain::isolines ? Geometry::off : s.geometry; }
bool hasAmount(Geometry stage) { return stage > Geometry::wireframe; }
int outerLevel(const Stages& s) { return s.ownEdges ? s.outer : s.inner; }
GLenum mode(const Stages& s) {
    constexpr std::array<GLenum, 2> withoutPatches{GL_TRIANGLES, GL_POINTS};
    return s.tessellation ? GL_PATCHES : withoutPatches.at(geometryStage(s) == Geometry::shapes);
}

}  // namespace mv::gpu_stages

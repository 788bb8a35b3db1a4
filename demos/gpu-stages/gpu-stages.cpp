// gpu-stages: one patch through all stages of the pipeline, each on or off, with what goes into it and what comes out.
#include "gpu-stages.h"

#include <array>

#include "mv/demo/seen.h"
#include "mv/gl/gl.h"
#include "mv/math/transform.h"
#include "shared/wide_lines.h"

namespace mv::gpu_stages {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    constexpr std::array ofShow{drawStages, drawPrimitives, drawMeshes, drawCompute};  // the last: compute.cpp
    glEnable(GL_DEPTH_TEST);
    ofShow.at(static_cast<std::size_t>(s.show))(gpu, s, frame);
}

static const vec3 sheetColor(0.85, 0.55, 0.25), lineColor(0.1, 0.3, 0.6);

// The evaluation shaders by domain: for triangles or lines, and for points.
constexpr std::array primitivesOf{"patch.tese", "triangles.tese", "isolines.tese"};
constexpr std::array pointsOf{"points.tese", "triangle-points.tese", ""};

// A program has a file for each of its stages. Without the file, the pipeline has no such stage.
std::vector<std::string> filesOf(const Stages& s, Geometry stage) {
    std::vector<std::string> files{"gpu-stages.vert"};
    if (s.tessellation) {
        files.emplace_back("patch.tesc");
        const auto& evaluations = geometryStage(s) == Geometry::shapes ? pointsOf : primitivesOf;
        files.emplace_back(evaluations.at(static_cast<std::size_t>(domainOf(s))));
    }
    if (stage != Geometry::off) files.push_back(std::string(nameOf(stage)) + ".geom");
    files.emplace_back(stage == Geometry::wireframe ? "wireframe.frag" : "gpu-stages.frag");
    return files;
}

static bool isOfLines(const Stages& s, Geometry stage) {
    return stage == Geometry::normals || stage == Geometry::wireframe || domainOf(s) == Domain::isolines;
}

// Let the geometry shader measure in pixels, and draw the lines in front of the faces.
static void setWireframe(const Program& program, const Frame& frame) {
    program.set("halfPicture", 0.5 * vec2(frame.width(), frame.height()) / double(lineWidth(frame)));
    program.set("isHidden", false);
}

// Use the program of these stages, and set all uniforms that it has.
const Program& prepare(Gpu& gpu, const Settings& s, Geometry stage, const Frame& frame) {
    const Program& program = programOf(gpu, filesOf(s.stages, stage));
    program.use();
    program.set("clipFromWorld", seen(sceneOf(s, frame), frame).clipFromWorld());
    program.set("bend", s.stages.bend);
    program.set("color", isOfLines(s.stages, stage) ? lineColor : sheetColor);
    if (s.stages.tessellation) {
        program.set("inner", double(s.stages.inner));
        program.set("outer", double(outerLevel(s.stages)));
    }
    if (hasAmount(stage)) program.set("amount", s.stages.amount);
    if (stage == Geometry::wireframe) setWireframe(program, frame);
    return program;
}

// Draw again, and keep only the lines behind the faces. GL_MIN leaves the lines in front of them as dark as they are.
static void drawHiddenLines(Gpu& gpu, const Settings& s, const Program& program, const Frame& frame) {
    program.set("isHidden", true);
    glDepthFunc(GL_GREATER);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendEquation(GL_MIN);
    drawCounted(gpu, s, frame);
}

void drawStages(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Geometry stage = geometryStage(s.stages);
    frame.show("clipFromWorld", seen(sceneOf(s, frame), frame).clipFromWorld());
    gpu.passed = 0;

    // Send the patch's 16 points through the stages. Normals stand on the patch, so draw the patch before them
    if (s.stages.tessellation) glPatchParameteri(GL_PATCH_VERTICES, 16);
    if (stage == Geometry::normals) {
        prepare(gpu, s, Geometry::off, frame);
        drawCounted(gpu, s, frame);
    }
    const Program& program = prepare(gpu, s, stage, frame);
    drawCounted(gpu, s, frame);
    if (stage == Geometry::wireframe && s.stages.hidden && s.stages.fragments && !frame.measuring())
        drawHiddenLines(gpu, s, program, frame);

    // Count the primitives of each stage, for the table beside the patch (figure.cpp)
    countPrimitives(gpu, s, frame);
}

// Without tessellation the cells of the control net are drawn, which are quads.
Domain domainOf(const Stages& s) { return s.tessellation ? s.domain : Domain::quads; }
// The geometry shaders of this demo take triangles or points, but no lines.
Geometry geometryStage(const Stages& s) { return domainOf(s) == Domain::isolines ? Geometry::off : s.geometry; }
bool hasAmount(Geometry stage) { return stage > Geometry::wireframe; }
int outerLevel(const Stages& s) { return s.ownEdges ? s.outer : s.inner; }
GLenum mode(const Stages& s) {
    if (s.tessellation) return GL_PATCHES;
    return geometryStage(s) == Geometry::shapes ? GL_POINTS : GL_TRIANGLES;
}
mat4 turnOf(const Settings& s) { return rotateX(s.spinX) * rotateY(s.spinY); }

const Program& programOf(Gpu& gpu, const std::vector<std::string>& files) {
    const auto known = gpu.programs.find(files);
    if (known != gpu.programs.end()) return known->second;
    std::string name;
    std::vector<std::string> paths;
    for (const std::string& file : files) {
        name += (name.empty() ? "" : " ") + file;
        paths.push_back("gpu-stages/" + file);
    }
    return gpu.programs.emplace(files, Program::fromFiles(name, paths)).first->second;
}

// Draw the ten primitive types, a pane each.
void drawPrimitives(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Program& flat = programOf(gpu, {"flat.vert", "flat.frag"});
    flat.use();
    glEnable(GL_PROGRAM_POINT_SIZE);
    gpu.types.draw(frame, flat, s.vertices, s.counts);
}

// Draw bodies that can be cut regularly, and one that cannot.
void drawMeshes(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Stages untouched{.tessellation = false};
    const Program& program = programOf(gpu, filesOf(untouched, s.hasWires ? Geometry::wireframe : Geometry::off));
    program.use();
    program.set("bend", 0.0);
    program.set("color", s.hasWires ? lineColor : sheetColor);
    if (s.hasWires) setWireframe(program, frame);
    gpu.bodies.draw(frame, turnOf(s), program, s.cells);
}

}  // namespace mv::gpu_stages

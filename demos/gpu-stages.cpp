// gpu-stages: one patch through all stages of the pipeline, each on or off, with what goes into it and what comes out.
//
// Claims (each is a test in tests/claims/gpu-stages.cpp; X53 in docs/stability.md is its extreme):
// - [counts-agree] Two queries and what transform feedback leaves in its buffer count the same primitives.
// - [counts-follow-the-rule] The tessellator makes as many triangles as its levels say; a geometry shader, of each triangle
//   one or a line, of each point four triangles.
// - [stages-pass-on] A stage that is on and changes nothing changes no pixel by more than its colours' last place; without
//   fragments there is no picture, and all is counted as before.
// - [hidden-lines] What shows them draws lines behind faces and nothing else, and covers no line before them.
// - [ten-primitive-types] So many vertices make so many primitives, in each of the seven types of the core; it refuses the
//   other three.
// - [regular-only-with-euler-0] Of the closed bodies the torus is regular and the sphere is not; what its vertices lack of
//   six edges is 6 times Euler's number.
// - [compute-is-the-same-picture] The compute shader stores the picture that the fragment shader draws.
// - [says-what-is-lacking] Without a stage the demo draws what it can, and says what it lacks.
#include <map>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/made_for.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/beyond_es.h"
#include "mv/gl/gl.h"
#include "mv/gl/on_demand.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/control_net.h"
#include "shared/exact_patch.h"
#include "shared/primitive_figure.h"
#include "shared/regular_meshes.h"
#include "shared/spin.h"
#include "shared/stage_table.h"

using namespace mv;

namespace {

enum class Show { stages, primitives, meshes, compute };
enum class Geometry { off, pass, wireframe, shapes, normals, explode };

const vec3 sheetColor(0.85, 0.55, 0.25), lineColor(0.1, 0.3, 0.6);
const vec4 pointColor(0.45, 0.45, 0.5, 1);

struct GpuStages final : Demo {
    Choice<Show> show{this,
                      "show",
                      Show::stages,
                      {{"stages", "a patch on its way through them"},
                       {"primitives", "the ten types that vertices are joined by"},
                       {"meshes", "which bodies can be cut regularly"},
                       {"compute", "one picture by two kinds of shader"}},
                      "what is shown"};
    Toggle tessellation{this, "tessellation", true, "its two shaders, and the primitive generator between them"};
    Whole inner{this, "inner", 8, {1, 64}, "the level of the patch's inside"};
    Toggle ownEdges{this, "own-edges", false, "its four edges have a level of their own, and not that of the inside"};
    Whole outer{this, "outer", 4, {1, 64}, "the edges' own level"};
    Choice<Geometry> geometry{this,
                              "geometry",
                              Geometry::wireframe,
                              {{"off", "there is no such stage"},
                               {"pass", "each triangle as it came"},
                               {"wireframe", "each triangle, with the distances from its edges"},
                               {"shapes", "of each point a hexagon"},
                               {"normals", "of each triangle a line, beside the patch"},
                               {"explode", "each triangle moved along its normal"}},
                              "what the geometry shader makes"};
    Toggle hidden{this, "hidden", true, "lines of the wireframe that are behind faces are drawn, too, but paler"};
    Real amount{this, "amount", 0.25, {0.05, 1}, "how far it moves, how long the lines are, how large the hexagons"};
    Real bend{this, "bend", 0.1, {-0.3, 0.3}, "by how much the vertex shader bends the sheet; 0 leaves it as it is"};
    Toggle fragments{this, "fragments", true, "rasterization, and the stages after it"};
    NumberChoice direct3d{this, "direct3d", 11, {9, 10, 11}, "whose names stand beside those of OpenGL"};
    Whole vertices{this, "vertices", 8, {4, 8}, "vertices of each primitive type"};
    Whole cells{this, "cells", 12, {3, 32}, "cells along and around each body"};
    Spin spin{this, 20, -30};

    Readout into{this, "into-geometry", "primitives that reach the geometry stage's place, by a query"};
    Readout out{this, "out-of-geometry", "primitives that leave it, by a query"};
    Readout written{this, "written", "of these, those that transform feedback wrote, by a query"};
    Readout found{this, "found", "of these, those whose corners are in its buffer"};
    Readout covered{this, "fragments-passed", "fragments that reached the picture"};
    Readout made{this, "primitives", "primitives of the seven types of the core, by queries"};
    Readout irregular{this, "irregular", "inner vertices of the four bodies where not six edges meet"};

    std::map<std::vector<std::string>, Program> programs;  // by their files
    OnDemand<Mesh> patch{positionsOnly(controlPoints()), "patch"}, points{controlPoints(), "control points"};
    OnDemand<Mesh> net{controlNet(), "control net"}, square{positionsOnly(mv::square()), "square"};
    CountedPrimitives toGeometry, sent;
    MadeFor<bool, int, int, Geometry> countedFor;
    PrimitiveFigure types;
    RegularFigure bodies;
    Target image;
    Drawing drawing;

    GpuStages() {
        bindWheel(inner, 1);
        bindKeys(Key::down, Key::up, bend, 0.05);
        const auto only = [](const auto& where, Literal reason, const std::vector<Knob*>& knobs) {
            for (Knob* knob : knobs) knob->onlyWhen(where, reason);
        };
        const auto shows = [this](Show what) { return [=, this] { return show == what; }; };
        only(shows(Show::stages), "no patch is shown",
             {&tessellation, &inner, &ownEdges, &outer, &geometry, &hidden, &amount, &bend, &fragments, &direct3d});
        only([this] { return tessellation; }, "nothing is tessellated", {&inner, &ownEdges, &outer});
        only([this] { return ownEdges; }, "the edges have the level of the inside", {&outer});
        only([this] { return geometry == Geometry::wireframe; }, "no wireframe is shown", {&hidden});
        only([this] { return hasAmount(geometry); }, "the geometry stage moves nothing", {&amount});
        only([this] { return show != Show::stages || fragments; }, "nothing is drawn",
             {&hidden, &amount, &bend, &spin.x, &spin.y});
        only(shows(Show::primitives), "no primitive types are shown", {&vertices});
        only(shows(Show::meshes), "no bodies are shown", {&cells});
        only([this] { return show == Show::stages || show == Show::meshes; }, "the picture is flat",
             {&spin.x, &spin.y});
    }

    void init() override {}

    void draw(const Frame& frame) override {
        glEnable(GL_DEPTH_TEST);
        if (show == Show::stages) drawStages(frame);
        if (show == Show::primitives) drawPrimitives(frame);
        if (show == Show::meshes) drawMeshes(frame);
        if (show == Show::compute) drawCompute(frame);
    }

    // ---- a patch through the stages

    bool isTessellated() const { return tessellation && has(beyond_es::tessellation); }
    Geometry geometryStage() const {
        return geometry != Geometry::off && has(beyond_es::geometryShaders) ? Geometry(geometry) : Geometry::off;
    }
    bool ofPoints() const { return geometryStage() == Geometry::shapes; }
    static bool hasAmount(Geometry stage) { return stage > Geometry::wireframe; }
    int outerLevel() const { return ownEdges ? outer : inner; }
    GLenum mode() const { return isTessellated() ? GL_PATCHES : ofPoints() ? GL_POINTS : GL_TRIANGLES; }

    std::string wordOf(Geometry stage) const { return geometry.options().at(static_cast<std::size_t>(stage)).word; }

    // The program of just these stages: a file each.
    const Program& program(bool tessellated, Geometry stage) {
        std::vector<std::string> files{"gpu-stages.vert"};
        if (tessellated) {
            files.emplace_back("gpu-stages.patch.tesc");
            files.emplace_back(ofPoints() ? "gpu-stages.points.tese" : "gpu-stages.patch.tese");
        }
        if (stage != Geometry::off) files.push_back("gpu-stages." + wordOf(stage) + ".geom");
        files.emplace_back(stage == Geometry::wireframe ? "gpu-stages.wireframe.frag" : "gpu-stages.frag");
        return programOf(files);
    }
    const Program& programOf(const std::vector<std::string>& files) {
        auto known = programs.find(files);
        if (known == programs.end()) {
            std::string name;
            for (const std::string& file : files) name += (name.empty() ? "" : " ") + file;
            known = programs.emplace(files, Program::fromFiles(name, files)).first;
        }
        return known->second;
    }

    // Uses it, and tells it all that it asks for.
    const Program& prepare(const Frame& frame, Geometry stage) {
        const Program& used = program(isTessellated(), stage);
        used.use();
        used.set("clipFromWorld", seen(frame).clipFromWorld());
        used.set("bend", bend);
        used.set("color", stage == Geometry::normals || stage == Geometry::wireframe ? lineColor : sheetColor);
        if (isTessellated()) {
            used.set("inner", double(inner));
            used.set("outer", double(outerLevel()));
        }
        if (hasAmount(stage)) used.set("amount", amount);
        if (stage == Geometry::wireframe) {
            used.set("halfPicture", 0.5 * vec2(frame.width(), frame.height()));
            used.set("isHidden", false);
        }
        return used;
    }
    void submit() { (isTessellated() ? patch : ofPoints() ? points : net)->drawAs(mode()); }

    void drawStages(const Frame& frame) {
        const Geometry stage = geometryStage();
        const bool counts = has(beyond_es::countingQueries);
        const bool anew = counts && countedFor.changed(isTessellated(), inner, outerLevel(), stage);
        if (isTessellated()) glPatchParameteri(GL_PATCH_VERTICES, 16);
        frame.show("clipFromWorld", seen(frame).clipFromWorld());

        long passed = 0;
        const auto drawCounted = [&] {
            if (!fragments) glEnable(GL_RASTERIZER_DISCARD);
            if (counts && frame.readouts()) {
                passed += countedBy(GL_SAMPLES_PASSED, [this] { submit(); });
            } else {
                submit();
            }
            if (!fragments) glDisable(GL_RASTERIZER_DISCARD);
        };
        // What would go to the rasterizer without a geometry stage; beside the normals it does.
        if (stage != Geometry::off && (anew || stage == Geometry::normals)) {
            const Program& without = prepare(frame, Geometry::off);
            if (anew) toGeometry = counted(without, mode(), [this] { submit(); });
            if (stage == Geometry::normals) drawCounted();
        }
        const Program& all = prepare(frame, stage);
        if (anew) sent = counted(all, mode(), [this] { submit(); });
        if (anew && stage == Geometry::off) toGeometry = sent;
        drawCounted();
        if (stage == Geometry::wireframe && hidden && fragments && !frame.measuring()) {
            all.set("isHidden", true);  // once more, and only what lies behind what was drawn
            glDepthFunc(GL_GREATER);
            glDepthMask(GL_FALSE);
            glEnable(GL_BLEND);
            glBlendEquation(GL_MIN);  // the lines before it stay as dark as they are
            drawCounted();
        }

        if (!counts) return;
        frame.count("primitives for the rasterizer", double(sent.number.generated));
        if (!frame.readouts()) return;
        into = double(toGeometry.number.generated);
        out = double(sent.number.generated);
        written = double(sent.number.written);
        found = sent.found();
        covered = double(passed);
    }

    // The eye, for the left half of the picture; the table is beside it.
    Scene scene(const FrameInfo& frame) const override {
        Scene scene;
        scene.clipFromView = translate(-0.55, 0, 0) * scale(0.47, 1, 1) * perspective(35, 0.47 * frame.aspect(), 1, 20);
        scene.viewFromWorld = lookAt(vec3(0, 0, 10.5), vec3(0), vec3(0, 1, 0)) * spin.turn() * translate(0, -0.4, 0);
        return scene;
    }

    void annotateStages(const Frame& frame) {
        if (fragments) {
            const ExactPatch exact(bend);
            for (const vec3& point : exact.patch().points)
                drawing.point(seen(frame).clipFromWorld(), point, frame.height() / 90.0, pointColor);
        }
        drawStageTable(drawing, frame, direct3d,
                       {.mode = mode(),
                        .inner = inner,
                        .outer = outerLevel(),
                        .isBent = bend != 0.0,
                        .hasGeometry = geometryStage() != Geometry::off,
                        .hasFragments = fragments,
                        .toGeometry = toGeometry,
                        .sent = sent});
    }

    // ---- the ten primitive types

    void drawPrimitives(const Frame& frame) {
        const bool counts = has(beyond_es::countingQueries);
        const Program& flat = programOf({"gpu-stages.flat.vert", "gpu-stages.flat.frag"});
        flat.use();
        if (!isEs()) glEnable(GL_PROGRAM_POINT_SIZE);  // which has it always on
        types.draw(frame, flat, vertices, counts);
        if (counts && frame.readouts()) made = double(types.counted());
    }

    // ---- regular meshes, and one that cannot be

    void drawMeshes(const Frame& frame) {
        const bool wires = has(beyond_es::geometryShaders);
        const Program& used = program(false, wires ? Geometry::wireframe : Geometry::off);
        used.use();
        used.set("bend", 0.0);
        used.set("color", wires ? lineColor : sheetColor);
        if (wires) {
            used.set("halfPicture", vec2(frame.width(), frame.height()) / 2.0);
            used.set("isHidden", false);
        }
        bodies.draw(frame, spin.turn(), used, cells);
        if (frame.readouts()) irregular = double(bodies.irregular());
    }

    // ---- the same picture by a fragment shader and by a compute shader

    void drawCompute(const Frame& frame) {
        const std::vector<Pane> panes = frame.panes(2);
        const Pane left = belowHeading(panes[0]), right = belowHeading(panes[1]);
        const bool computes = has(beyond_es::computeShaders);
        if (computes && image.fit(right.width, right.height, {.texture = true}, "image")) {
            programOf({"gpu-stages.compute.comp"}).use();
            image.bindImage(0);
            glDispatchCompute(GLuint(right.width + 7) / 8, GLuint(right.height + 7) / 8, 1);  // groups of 8 x 8
            glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT);
            glBindImageTexture(0, 0, 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_RGBA8);
            frame.bindTarget();
        }
        const Program& byFragment = programOf({"gpu-stages.ripples.vert", "gpu-stages.ripples.frag"});
        byFragment.use();
        byFragment.set("size", vec2(left.width, left.height));
        fill(left, byFragment);
        if (computes) {
            const Program& texels = programOf({"gpu-stages.ripples.vert", "gpu-stages.texels.frag"});
            texels.use();
            texels.set("image", 0);
            image.bindColor(0);
            fill(right, texels);
        }
        glViewport(0, 0, frame.width(), frame.height());
    }
    void fill(const Pane& pane, const Program& used) {
        used.set("corner", vec2(pane.x, pane.y));
        glViewport(pane.x, pane.y, pane.width, pane.height);
        square->draw();
    }

    void annotate(const Frame& frame) override {
        drawing.begin(frame);
        if (show == Show::stages) annotateStages(frame);
        if (show == Show::primitives) types.label(frame, drawing);
        if (show == Show::meshes) bodies.label(frame, spin.turn(), drawing);
        if (show == Show::compute) drawHeadings(drawing, frame);
        drawing.draw(frame);
    }
};

constexpr Declaration declaration{
    .name = "gpu-stages",
    .sentence = "One patch through all stages of the pipeline, each on or off, with what goes in and what comes out.",
    .lookFor = "Sixteen vertices become a hundred and twenty-eight triangles, and no vertex buffer ever held them.",
    .chapter = "Surfaces, mirrors and stages",
    .number = 32,
    .width = 960,
    .height = 560,
    .background = vec4(0.95, 0.95, 0.96, 1),
    .needs = {.depth = true,
              .beyondEs = {{"geometry shaders", "that stage is off"},
                           {"tessellation", "the net of the control points is drawn"},
                           {"compute shaders", "only the fragment shader draws"},
                           {"counting queries", "nothing is counted"},
                           {"indexed feedback", "nothing is counted"},
                           {"expanded feedback", "nothing is counted"},
                           {"float targets", "the error is not measured"}}},
    .presets = {{"wireframe",
                 "All stages: 16 control points go in, 128 triangles come out; pale lines are behind faces.",
                 {},
                 {{"out-of-geometry", 128, 128}}},
                {"hexagons", "Of each point of the tessellator a hexagon.", {{"geometry", "shapes"}, {"spin-x", "45"}}},
                {"exploded", "Geometry shaders know a triangle's normal.", {{"geometry", "explode"}, {"spin-x", "45"}}},
                {"primitives", "Ten ways to join vertices; the red three left the core.", {{"show", "primitives"}}},
                {"meshes", "A torus is regular everywhere; no sphere is.", {{"show", "meshes"}, {"spin-x", "40"}}},
                {"compute", "The same rings by a fragment and by a compute shader.", {{"show", "compute"}}}},
};

const bool added = addDemo<GpuStages, declaration>();

}  // namespace

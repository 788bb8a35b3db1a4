// gpu-stages: one patch through all stages of the pipeline, each on or off, with what goes into it and what comes out.
//
// Claims (each is a test in tests/claims/gpu-stages.cpp; X53 in docs/stability.md is its extreme):
// - [counts-agree] Two queries and what transform feedback leaves in its buffer count the same primitives.
// - [counts-follow-the-rule] The tessellator makes as many triangles as its levels say; a geometry shader, of each triangle
//   one or a line, of each point four triangles.
// - [stages-pass-on] A stage that is on and changes nothing changes no pixel; without fragments there is no picture, and all
//   is counted as before.
// - [ten-primitive-types] So many vertices make so many primitives, in each of the seven types of the core; it refuses the
//   other three.
// - [regular-only-with-euler-0] Of the closed bodies the torus is regular and the sphere is not; what its vertices lack of
//   six edges is 6 times Euler's number.
// - [compute-is-the-same-picture] The compute shader stores the picture that the fragment shader draws.
// - [says-what-is-lacking] Without a stage the demo draws what it can, and says what it lacks.
#include <array>
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
#include "shared/primitive_figure.h"
#include "shared/regular_meshes.h"
#include "shared/spin.h"
#include "shared/stage_table.h"

using namespace mv;

namespace {

enum class Show { stages, primitives, meshes, compute };
enum class Geometry { off, shapes, normals, explode, wireframe };

const vec3 sheetColor(0.85, 0.55, 0.25), lineColor(0.1, 0.3, 0.6), oddColor(0.8, 0.15, 0.1);

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
    Whole outer{this, "outer", 8, {1, 64}, "the level of its four edges"};
    Choice<Geometry> geometry{this,
                              "geometry",
                              Geometry::wireframe,
                              {{"off", "there is no such stage"},
                               {"shapes", "of each point a hexagon"},
                               {"normals", "of each triangle a line, beside the patch"},
                               {"explode", "each triangle moved along its normal"},
                               {"wireframe", "each triangle, with the distances from its edges"}},
                              "what the geometry shader makes"};
    Real amount{this, "amount", 0.25, {0.05, 1}, "how far it moves, how long the lines are, how large the hexagons"};
    Real bend{this, "bend", 0.1, {-0.3, 0.3}, "by how much the vertex shader bends the sheet; 0 leaves it as it is"};
    Toggle fragments{this, "fragments", true, "rasterization, and the stages after it"};
    Whole vertices{this, "vertices", 8, {4, 8}, "vertices of each primitive type"};
    Whole cells{this, "cells", 12, {3, 32}, "cells along and around each body"};
    Spin spin{this, 40, -25};

    Readout into{this, "into-geometry", "primitives that reach the geometry stage's place, by a query"};
    Readout out{this, "out-of-geometry", "primitives that leave it, by a query"};
    Readout written{this, "written", "of these, those that transform feedback wrote, by a query"};
    Readout found{this, "found", "of these, those whose corners are in its buffer"};
    Readout covered{this, "fragments-passed", "fragments that reached the picture"};
    Readout made{this, "primitives", "primitives of the seven types of the core, by queries"};
    Readout irregular{this, "irregular", "inner vertices of the four bodies where not six edges meet"};

    std::map<std::string, Program> programs;
    OnDemand<Mesh> points{controlPoints(), "control points"}, net{controlNet(), "control net"};
    OnDemand<Mesh> square{mv::square(), "square"};  // all of a pane
    Captured toGeometry, sent;
    MadeFor<bool, int, int, Geometry> countedFor;
    PrimitiveFigure figure;
    std::vector<RegularMesh> bodies;
    std::vector<Mesh> wholeMeshes, oddMeshes;
    MadeFor<int> bodiesFor;
    Target image;
    Drawing drawing;

    GpuStages() {
        bindWheel(inner, 1);
        bindKeys(Key::down, Key::up, outer, 1);
        const auto shows = [this](Show what) { return [=, this] { return show == what; }; };
        for (Knob* knob : std::vector<Knob*>{&tessellation, &inner, &outer, &geometry, &amount, &bend, &fragments})
            knob->onlyWhen(shows(Show::stages), "no patch is shown");
        for (Knob* knob : std::vector<Knob*>{&inner, &outer})
            knob->onlyWhen([this] { return tessellation; }, "nothing is tessellated");
        amount.onlyWhen([this] { return geometry != Geometry::off && geometry != Geometry::wireframe; },
                        "the geometry stage moves nothing");
        for (Knob* knob : std::vector<Knob*>{&amount, &bend, &spin.x, &spin.y})
            knob->onlyWhen([this] { return show != Show::stages || fragments; }, "nothing is drawn");
        vertices.onlyWhen(shows(Show::primitives), "no primitive types are shown");
        cells.onlyWhen(shows(Show::meshes), "no bodies are shown");
        for (Knob* knob : std::vector<Knob*>{&spin.x, &spin.y})
            knob->onlyWhen([this] { return show == Show::stages || show == Show::meshes; }, "the picture is flat");
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
    GLenum mode() const { return isTessellated() ? GL_PATCHES : ofPoints() ? GL_POINTS : GL_TRIANGLES; }

    // The program of just these stages: a file each.
    const Program& program(bool tessellated, bool pointwise, Geometry stage) {
        static constexpr std::array<const char*, 5> words{"", "shapes", "normals", "explode", "wireframe"};
        const std::string word = words.at(static_cast<std::size_t>(stage));
        std::vector<std::string> files{"gpu-stages.vert"};
        if (tessellated) {
            files.emplace_back("gpu-stages.patch.tesc");
            files.emplace_back(pointwise ? "gpu-stages.points.tese" : "gpu-stages.patch.tese");
        }
        if (stage != Geometry::off) files.push_back("gpu-stages." + word + ".geom");
        files.emplace_back(stage == Geometry::wireframe ? "gpu-stages.wireframe.frag" : "gpu-stages.frag");
        return programOf(files);
    }
    const Program& programOf(const std::vector<std::string>& files) {
        std::string name;
        for (const std::string& file : files) name += (name.empty() ? "" : " ") + file;
        const auto known = programs.find(name);
        return known != programs.end() ? known->second
                                       : programs.emplace(name, Program::fromFiles(name, files)).first->second;
    }

    // Uses it, and tells it all that it asks for.
    const Program& prepare(const Frame& frame, Geometry stage) {
        const Program& used = program(isTessellated(), ofPoints(), stage);
        used.use();
        used.set("clipFromWorld", clipFromWorld(frame));
        used.set("bend", bend);
        used.set("color", stage == Geometry::normals || stage == Geometry::wireframe ? lineColor : sheetColor);
        if (isTessellated()) {
            used.set("inner", double(inner));
            used.set("outer", double(outer));
        }
        if (stage == Geometry::wireframe) {
            used.set("halfPicture", 0.5 * vec2(frame.width(), frame.height()));
        } else if (stage != Geometry::off) {
            used.set("amount", amount);
        }
        return used;
    }
    void submit() {
        if (mode() == GL_TRIANGLES) {
            net->draw();
        } else {
            points->drawAs(mode());
        }
    }

    void drawStages(const Frame& frame) {
        const Geometry stage = geometryStage();
        const bool counts = has(beyond_es::countingQueries);
        const bool anew = counts && countedFor.changed(isTessellated(), inner, outer, stage);
        if (isTessellated()) glPatchParameteri(GL_PATCH_VERTICES, 16);
        frame.show("clipFromWorld", clipFromWorld(frame));

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
            if (anew) toGeometry = captured(without.primitiveOut(mode()), [this] { submit(); });
            if (stage == Geometry::normals) drawCounted();
        }
        const Program& all = prepare(frame, stage);
        if (anew) sent = captured(all.primitiveOut(mode()), [this] { submit(); });
        if (anew && stage == Geometry::off) toGeometry = sent;
        drawCounted();

        if (!counts || !frame.readouts()) return;
        into = double(toGeometry.generated);
        out = double(sent.generated);
        written = double(sent.written);
        found = double(sent.positions.size()) / cornersOf(all.primitiveOut(mode()));
        covered = double(passed);
    }
    static int cornersOf(GLenum primitive) { return primitive == GL_POINTS ? 1 : primitive == GL_LINES ? 2 : 3; }

    mat4 clipFromWorld(const FrameInfo& frame) const {
        const mat4 left = translate(-0.53, 0, 0) * scale(0.47, 1, 1);  // the table is beside it
        return left * perspective(35, 0.47 * frame.aspect(), 1, 20) * lookAt(vec3(0, 0, 9), vec3(0), vec3(0, 1, 0)) *
               spin.turn() * translate(0, -0.4, 0);
    }

    void annotateStages(const Frame& frame) {
        const Geometry stage = geometryStage();
        const auto primitive = [&](Geometry of) {
            return program(isTessellated(), ofPoints(), of).primitiveOut(mode());
        };
        const Box right{vec2(0.48 * frame.width(), 0.08 * frame.height()),
                        vec2(0.99 * frame.width(), 0.94 * frame.height())};
        drawStageTable(drawing, right,
                       {.isTessellated = isTessellated(),
                        .hasGeometry = stage != Geometry::off,
                        .hasFragments = fragments,
                        .mode = mode(),
                        .inner = inner,
                        .outer = outer,
                        .isBent = bend != 0.0,
                        .before = primitive(Geometry::off),
                        .after = primitive(stage),
                        .isCounted = has(beyond_es::countingQueries),
                        .toGeometry = toGeometry.generated,
                        .sent = sent.generated,
                        .cornersFound = sent.positions.size()});
    }

    // ---- the ten primitive types

    void drawPrimitives(const Frame& frame) {
        const bool counts = has(beyond_es::countingQueries);
        const Program& flat = programOf({"gpu-stages.flat.vert", "gpu-stages.flat.frag"});
        flat.use();
        if (!isEs()) glEnable(GL_PROGRAM_POINT_SIZE);  // which has it always on
        figure.draw(frame, flat, vertices, counts);
        if (counts && frame.readouts()) made = double(figure.counted());
    }

    // ---- regular meshes, and one that cannot be

    void drawMeshes(const Frame& frame) {
        if (bodiesFor.changed(cells)) {
            bodies = regularMeshes(cells);
            wholeMeshes.clear();
            oddMeshes.clear();
            for (const RegularMesh& body : bodies) {
                wholeMeshes.emplace_back(body.mesh, body.name);
                oddMeshes.push_back(body.irregular.positions.empty() ? Mesh() : Mesh(body.irregular, "irregular"));
            }
        }
        if (has(beyond_es::geometryShaders)) {
            const Program& wires = program(false, false, Geometry::wireframe);
            wires.use();
            wires.set("halfPicture", 0.5 * vec2(frame.width(), frame.height()));
            drawBodies(frame, wires, lineColor, wholeMeshes);
            const Program& hexagons = program(false, true, Geometry::shapes);
            hexagons.use();
            hexagons.set("amount", 0.2);
            drawBodies(frame, hexagons, oddColor, oddMeshes);
        } else {
            const Program& plain = program(false, false, Geometry::off);
            plain.use();
            drawBodies(frame, plain, sheetColor, wholeMeshes);
        }
        if (!frame.readouts()) return;
        long sum = 0;
        for (const RegularMesh& body : bodies) sum += body.topology.irregular();
        irregular = double(sum);
    }
    void drawBodies(const Frame& frame, const Program& used, const vec3& color, const std::vector<Mesh>& meshes) const {
        used.set("bend", 0.0);
        used.set("color", color);
        const std::vector<Pane> panes = frame.panes(4);
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            if (meshes[i].count() == 0) continue;
            used.set("clipFromWorld", clipFromBody(frame, panes[i]));
            meshes[i].draw();
        }
    }
    mat4 clipFromBody(const FrameInfo& frame, const Pane& pane) const {
        const vec2 size(frame.width(), frame.height());
        const vec2 middle(pane.x + 0.36 * pane.width, pane.y + 0.5 * pane.height);
        return translate(2 * middle.x / size.x - 1, 2 * middle.y / size.y - 1, 0) *
               scale(pane.width / size.x, pane.height / size.y, 1) * perspective(40, pane.aspect(), 1, 20) *
               lookAt(vec3(0, 0, 5), vec3(0), vec3(0, 1, 0)) * spin.turn();
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
    void annotateCompute(const Frame& frame) {
        const std::vector<Pane> panes = frame.panes(2);
        if (panes[0].width < 200 || panes[0].height < 64) return;
        const std::string right = has(beyond_es::computeShaders) ? "by a compute shader" : "no compute shader here";
        drawing.text({8, frame.height() - 6.0}, "by a fragment shader", {.background = vec4(0)});
        drawing.text({panes[1].x + 8.0, frame.height() - 6.0}, right, {.background = vec4(0)});
    }

    void annotate(const Frame& frame) override {
        drawing.begin(frame);
        if (show == Show::stages) annotateStages(frame);
        if (show == Show::primitives) figure.label(frame, drawing);
        if (show == Show::meshes) {
            const std::vector<Pane> panes = frame.panes(4);
            for (std::size_t i = 0; i < bodies.size(); ++i) labelBody(drawing, panes[i], bodies[i]);
        }
        if (show == Show::compute) annotateCompute(frame);
        drawing.draw(frame);
    }
};

const bool added = addDemo<GpuStages>({
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
                           {"expanded feedback", "nothing is counted"}}},
    .presets =
        {
            {"wireframe",
             "All stages: 16 control points go in, 128 triangles come out, with their edges.",
             {},
             {{"out-of-geometry", 128, 128}}},
            {"hexagons",
             "The tessellator gives points, and the geometry shader makes a hexagon of each.",
             {{"geometry", "shapes"}}},
            {"exploded", "A triangle is moved by who knows all of it: the geometry shader.", {{"geometry", "explode"}}},
            {"primitives",
             "Ten ways to join the same vertices; the red three have left the core.",
             {{"show", "primitives"}}},
            {"meshes", "A torus is regular everywhere; a sphere cannot be.", {{"show", "meshes"}}},
            {"compute", "The same rings by a fragment shader and by a compute shader.", {{"show", "compute"}}},
        },
});

}  // namespace

// displacement: a wall of bricks and an orange whose vertices are really moved, by tessellation stages or by the processor.
//
// Claims (each is a test in tests/claims/displacement.cpp; X53 in docs/stability.md has the levels that are none):
// - [outline-is-real] Moved vertices change the outline; with the same normals and no move it is that of the smooth body.
// - [prepared-is-the-same] At a fixed level the tessellator draws what the processor's mesh of as many cells draws.
// - [no-cracks] Where neighbours agree on the levels of their edges, no pixel of the background is seen through the surface.
// - [cracks-without-agreement] Where each patch has a level of its own, some are.
// - [triangles-by-the-rule] The tessellator makes as many triangles as the levels say; patches out of view give none.
// - [left-out-changes-nothing] What is left out is not seen: the picture stays byte for byte, with fewer triangles.
// - [far-needs-less] On the long wall levels by distance make a better outline of fewer triangles than a fixed level.
// - [levels-in-range] Levels beyond 64 are drawn as 64; a knob refuses 0, 65 and what is no number.
// - [says-what-is-lacking] Without tessellation the prepared mesh is drawn, and said to be.
#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/made_for.h"
#include "mv/gl/beyond_es.h"
#include "mv/gl/drawing.h"
#include "mv/gl/feedback.h"
#include "mv/gl/gl.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"
#include "mv/gl/texture.h"
#include "mv/image/mipmap.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/relief.h"
#include "shared/relief_figures.h"
#include "shared/relief_patches.h"
#include "shared/spin.h"

using namespace mv;

namespace {

enum class Method { tessellated, prepared, bumped };
enum class Levels { fixed, distance };
enum class Paint { surface, levels };

const vec4 ink(0.1, 0.1, 0.1, 1), paper(1, 1, 1, 0.8);

struct Displacement final : Demo {
    Choice<ReliefBody> body{this,
                            "body",
                            ReliefBody::wall,
                            {{"wall", "bricks, along a street"}, {"orange", "a sphere with pores"}},
                            "what"};
    Choice<Method> method{this,
                          "method",
                          Method::tessellated,
                          {{"tessellated", "the tessellator makes vertices, its shader moves them by the height map"},
                           {"prepared", "a mesh that the processor has cut and moved"},
                           {"bumped", "tessellated and lit as if moved, but not moved"}},
                          "who moves the vertices"};
    Choice<Levels> levels{this,
                          "levels",
                          Levels::distance,
                          {{"fixed", "one for all"}, {"distance", "each edge its own, by its distance from the eye"}},
                          "how finely patches are cut"};
    Whole level{this, "level", 16, {1, 64}, "pieces of each edge, where that is fixed"};
    Real fineness{this, "fineness", 100, {2, 512, Scale::logarithmic}, "pieces of an edge as long as it is far away"};
    Toggle agree{this, "agree", true, "an edge's level comes from the edge, so that both its patches have the same"};
    Toggle cull{this, "cull", true, "patches out of view get level 0, which leaves them out"};
    Real depth{this, "depth", 0.08, {0, 0.25}, "of the relief; a brick is 1 long, the orange's radius is 1", "units"};
    NumberChoice mapSize{this, "map-size", 256, {32, 64, 128, 256, 512}, "rows of texels of the height map"};
    Real distance{this, "distance", 1.5, {0.3, 10, Scale::logarithmic}, "of the eye from the smooth surface", "units"};
    Real angle{this, "angle", 65, {0, 85}, "between the line of sight and the wall's normal", "deg"};
    Toggle wireframe{this, "wireframe", false, "edges of the triangles"};
    Choice<Paint> paint{this, "paint", Paint::surface, {{"surface"}, {"levels", "of patches"}}, "what colours show"};
    Real lampTurn{this, "lamp-turn", -50, {-89, 89}, "the lamp's direction, to the right of the surface's normal",
                  "deg"};
    Real lampHeight{this, "lamp-height", 40, {-89, 89}, "and above it", "deg"};
    Spin spin{this, 20, 0, vec2(0.5)};

    Readout triangles{this, "triangles", "that reach the rasterizer, by a query"};
    Readout patches{this, "patches", "that are cut"};
    Readout leftOut{this, "left-out", "patches that are not, since nothing is seen of them"};

    std::map<std::pair<bool, bool>, Program> programs;  // with tessellation, with lines
    std::vector<ReliefPatch> cut;
    std::vector<Mesh> corners, prepared;  // some patches each; one with all of them
    MadeFor<ReliefBody> cutFor;
    MadeFor<ReliefBody, int> cornersFor;
    MadeFor<ReliefBody, double, int, bool> preparedFor;
    Texture painted;
    MadeFor<ReliefBody, int> paintedFor;
    Drawing drawing;

    Displacement() {
        bindWheel(distance, -0.1);
        bindKeys(Key::left, Key::right, angle, 5);
        bindKeys(Key::down, Key::up, fineness, 0.25);
        bindHandle("lamp", {&lampTurn, &lampHeight}, [this](const FrameInfo& frame) { return dial(frame).at(lamp()); });
        levels.onlyWhen([this] { return method != Method::prepared; }, "the prepared mesh has one level");
        fineness.onlyWhen([this] { return byDistance(); }, "the level is fixed");
        agree.onlyWhen([this] { return byDistance(); }, "all patches have one level");
        level.onlyWhen([this] { return !byDistance(); }, "the level comes from the distance");
        cull.onlyWhen([this] { return method != Method::prepared; }, "the prepared mesh is drawn as a whole");
        angle.onlyWhen([this] { return body == ReliefBody::wall; }, "only the wall is seen at one angle");
        for (Knob* knob : {&spin.x, &spin.y})
            knob->onlyWhen([this] { return body == ReliefBody::orange; }, "only the orange turns");
    }

    void init() override {}

    // ---- the picture: one draw, of patches or of triangles

    void draw(const Frame& frame) override {
        if (frame.measuring()) {  // which pixels are covered: those beside the surface count, too
            glClearColor(0, 0, 0, 0);
            glClear(GL_COLOR_BUFFER_BIT);
        }
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_CULL_FACE);  // the wall's back and the orange's inside are seen through cracks only
        makeMap();
        const Program& used = program(frame);
        used.use();
        used.set("clipFromBody", scene(frame).clipFromWorld());
        used.set("light", vec3(scene(frame).lights.front().position));
        used.set("view", towardsEye());
        if (hasLines(frame)) used.set("halfPicture", 0.5 * vec2(frame.width(), frame.height()));
        used.set("showsLevels", paint == Paint::levels);
        if (paint == Paint::levels) used.set("levelColors", levelColors());
        if (isTessellated()) {
            count(frame);
            tellTessellator(used, frame);
            glPatchParameteri(GL_PATCH_VERTICES, 4);
            drawCounted(frame, corners, GL_PATCHES);
        } else {
            prepare(frame);
            used.set("cells", double(level));
            drawCounted(frame, prepared, GL_TRIANGLES);
        }
    }

    // What the control shader asks for the levels, and the evaluation shader for the places.
    void tellTessellator(const Program& used, const Frame& frame) const {
        used.set("eye", eye(frame));
        used.set("fixedLevel", double(level));
        used.set("fineness", fineness);
        used.set("byDistance", byDistance());
        used.set("agrees", agree);
        used.set("leavesOut", cull);
        used.set("depth", depth);
        used.set("moved", method == Method::bumped ? 0.0 : depth);
        used.set("texel", unitsOfRepeat(body).y / mapSize);
        used.set("isRound", body == ReliefBody::orange);
    }
    void drawCounted(const Frame& frame, const std::vector<Mesh>& meshes, GLenum mode) {
        const auto draw = [&] {
            for (const Mesh& mesh : meshes) mesh.drawAs(mode);
        };
        if (!frame.readouts() || !has(beyond_es::countingQueries)) return draw();
        triangles = double(countedBy(GL_PRIMITIVES_GENERATED, draw));
    }

    // ---- what is drawn

    bool isTessellated() const { return method != Method::prepared && has(beyond_es::tessellation); }
    bool byDistance() const { return method != Method::prepared && levels == Levels::distance; }
    bool hasLines(const Frame& frame) const {
        return wireframe && !frame.measuring() && has(beyond_es::geometryShaders);
    }
    const Program& program(const Frame& frame) {
        const std::pair<bool, bool> kind(isTessellated(), hasLines(frame));
        const auto known = programs.find(kind);
        if (known != programs.end()) return known->second;
        std::vector<std::string> files{"vert"};
        if (kind.first) files = {"patch.vert", "patch.tesc", "patch.tese"};
        if (kind.second) files.emplace_back("lines.geom");
        files.emplace_back(kind.second ? "lines.frag" : "frag");
        for (std::string& file : files) file.insert(0, "displacement.");
        return programs.emplace(kind, Program::fromFiles(files.front() + "...", files)).first->second;
    }

    // By the rule that the control shader follows, too: what it does is not told to anybody.
    void count(const Frame& frame) {
        if (cutFor.changed(body)) cut = reliefPatches(body);
        const LevelRule rule{.fixedLevel = byDistance() ? 0.0 : double(level),
                             .fineness = fineness,
                             .agrees = agree,
                             .eye = eye(frame),
                             .leavesOut = cull};
        const PatchCount counted = countPatches(cut, relief(), rule, scene(frame).clipFromWorld());
        if (const int parts = counted.partsToDraw(); cornersFor.changed(body, parts)) {
            corners.clear();
            for (const MeshData& part : patchCorners(cut, parts)) corners.emplace_back(part, "patches");
        }
        patches = double(counted.patches - counted.leftOut);
        leftOut = double(counted.leftOut);
        frame.count("triangles made", double(counted.triangles));
        if (!cull && counted.outside > 0)
            frame.needless(std::to_string(counted.outside) + " patches out of view, cut all the same");
    }

    void prepare(const Frame& frame) {
        const bool isMoved = method != Method::bumped;
        if (preparedFor.changed(body, depth, level, isMoved)) {
            const MeshData smooth = cutPatches(body, level);
            MeshData made = displaced(relief(), smooth);
            if (!isMoved) made.positions = smooth.positions;
            prepared.clear();
            prepared.emplace_back(made, "prepared mesh");
        }
        frame.count("triangles made", prepared.front().count() / 3.0);
    }

    void makeMap() {
        if (!paintedFor.changed(body, mapSize)) return painted.bind(0);
        const Texels texels = has(beyond_es::floatFiltering) ? Texels::floats : Texels::halfFloats;
        painted = Texture(mipmaps(paintedMap(body, mapSize)), {.texels = texels, .label = "painted"});
        painted.filterBy({.minify = GL_LINEAR_MIPMAP_LINEAR, .magnify = GL_LINEAR, .wrap = GL_REPEAT});
        if (body == ReliefBody::orange) glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    }

    // ---- where things are: the world of the scene is the body's space

    Relief relief() const { return {body, depth}; }
    mat4 worldFromBody() const { return body == ReliefBody::orange ? spin.turn() : mat4(1); }
    vec3 lamp() const { return {rotateY(lampTurn) * rotateX(-lampHeight) * vec4(0, 0, 1, 0)}; }
    // Of highlights, which have the eye at infinity, as the lamp.
    vec3 towardsEye() const {
        if (body == ReliefBody::wall) return {-std::sin(radians(angle)), 0, std::cos(radians(angle))};
        return {glm::transpose(worldFromBody()) * vec4(0, 0, 1, 0)};
    }
    vec3 eye(const FrameInfo& frame) const { return {glm::inverse(scene(frame).viewFromWorld)[3]}; }
    Scene scene(const FrameInfo& frame) const override {
        Scene scene;
        scene.clipFromView = perspective(50, frame.aspect(), 0.05, 100);
        scene.viewFromWorld = body == ReliefBody::wall ? rotateY(angle) * translate(0, 0, -distance)
                                                       : translate(0, 0, -1 - distance) * worldFromBody();
        scene.lights = {{.position = vec4(glm::transpose(mat3(worldFromBody())) * lamp(), 0)}};
        return scene;
    }

    // ---- over it: what is drawn, the lamp, the colours of the levels

    static double reach(const FrameInfo& frame) { return 0.07 * std::min(frame.height(), frame.width()); }
    static LampDial dial(const FrameInfo& frame) { return {vec2(1.5 * reach(frame)), reach(frame)}; }

    void annotate(const Frame& frame) override {
        drawing.begin(frame);
        const int size = std::clamp(std::min(frame.height() / 36, frame.width() / 50), 8, 16);
        const bool hasRoom = reach(frame) > 12;
        const vec2 box(2.75 * reach(frame) + (hasRoom ? 4 * size : 0), 2.75 * reach(frame));
        drawing.fill({vec2(0.25 * reach(frame)), box}, paper);
        dial(frame).draw(drawing, lamp(), hasRoom ? size : 0);
        if (hasRoom)
            drawing.text(vec2(0.5, -0.5) * double(size) + vec2(0, frame.height()), title(), {size, ink, paper});
        if (paint == Paint::levels && hasRoom) drawLevelColors(drawing, frame, size);
        drawing.draw(frame);
    }
    std::string title() const {
        const std::string how = byDistance() ? "levels by distance" : "level " + std::to_string(level);
        if (!isTessellated()) return "prepared mesh, " + std::to_string(level) + " cells a patch";
        return (method == Method::bumped ? "not moved, only lit so: " : "moved by the height map: ") + how;
    }
};

constexpr Declaration declaration{
    .name = "displacement",
    .sentence = "A brick wall and an orange whose vertices are really moved, cut as finely as they are near.",
    .lookFor = "The upper edge of the wall has notches: bricks that pretend leave it straight.",
    .chapter = "Surfaces, mirrors and stages",
    .number = 21,
    .width = 960,
    .height = 600,
    .background = vec4(0.93, 0.94, 0.96, 1),
    .needs = {.depth = true,
              .beyondEs = {{"tessellation", "the prepared mesh is drawn"},
                           {"geometry shaders", "no edges of triangles are drawn"},
                           {"counting queries", "triangles are not counted"},
                           {"float targets", "holes are not counted"},
                           {"float filtering", "the height map has 16 bits a texel"}}},
    .presets =
        {
            {"street", "Bricks hide mortar, and the upper edge is notched: the vertices are really moved."},
            {"by-distance", "Near triangles are small, far ones large.", {{"wireframe", "on"}, {"fineness", "24"}}},
            {"level-colours",
             "An edge between two patches has one level, and each patch that of its finest edge.",
             {{"paint", "levels"}, {"wireframe", "on"}, {"fineness", "24"}}},
            {"orange", "The outline has pores, which no normal map can give it.", {{"body", "orange"}}},
            {"pretends",
             "Lit as before, but not moved: the outline is a circle.",
             {{"body", "orange"}, {"method", "bumped"}}},
            {"cracks",
             "Each patch has a level of its own, and the background is seen between them.",
             {{"agree", "off"}, {"angle", "50"}, {"distance", "0.6"}, {"fineness", "16"}, {"depth", "0.15"}}},
        },
};

const bool added = addDemo<Displacement, declaration>();

}  // namespace

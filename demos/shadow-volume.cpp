// shadow-volume: shadows counted in the stencil buffer, by the surface of the space that each solid keeps from the light.
//
// Claims (each is a test in tests/claims/shadow-volume.cpp):
// - [exact] By z-fail no pixel of any scene differs from what rays show, except in the band of one pixel at edges.
// - [eye-in-volume] With the eye in a volume z-pass is wrong nearly everywhere, z-fail and a counted start are right.
// - [silhouette-is-enough] Drawing out every triangle gives the same shadow, with many times the triangles.
// - [counts-are-rays] The stencil buffer holds how many surfaces stand between each pixel and the light.
// - [three-hundred-shells] 255, 256 and 300 nested shells are exact in groups; in one count 256 of them read as lit,
//   and a sentence says so.
// - [light-anywhere] A light at infinity, exactly in the plane of a face, or below the casters: still no pixel wrong (llvmpipe; with
//   other drivers at most one in a thousand, where a side meets the floor at a flat angle).
#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/gl.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/scene_meshes.h"
#include "mv/gl/text.h"
#include "mv/math/transform.h"
#include "shared/caster_volumes.h"
#include "shared/scenes.h"
#include "shared/turntable.h"

using namespace mv;

namespace {

enum class Which { cube, stillLife, nested };
enum class Method { zPass, zPassStarted, zFail };
enum class Show { shadow, volumes, count };
enum class Place { outside, inVolume };
using Caster = CasterVolumes::Caster;

constexpr double near = 0.1;  // distance from the eye where the view begins

struct ShadowVolumes final : Demo {
    Choice<Which> which{this, "scene", Which::stillLife, {{"cube"}, {"still-life"}, {"nested"}}, "what is shown"};
    Whole shells{this, "shells", 12, {1, 300}, "boxes in boxes, of the nested scene"};
    Choice<Method> method{this,
                          "method",
                          Method::zFail,
                          {{"z-pass", "count what is before each pixel"},
                           {"z-pass-started", "the same, starting with the volumes round the eye"},
                           {"z-fail", "count what is behind each pixel"}},
                          "how volumes are counted"};
    Choice<Show> show{this,
                      "show",
                      Show::volumes,
                      {{"shadow"}, {"volumes", "and their surfaces, as glass"}, {"count", "and the stencil buffer"}},
                      "what is drawn"};
    Toggle silhouetteOnly{this, "silhouette", true,
                          "on: only the silhouette's edges are drawn out; off: the edges of every triangle"};
    Toggle groups{this, "groups", true, "count 127 casters at a time where more than 255 would wrap round"};
    Choice<Place> eye{this, "eye", Place::outside, {{"outside"}, {"in-volume"}}, "where the eye is"};
    Real far{this,
             "far",
             0,
             {5, 100, Scale::logarithmic, true},
             "end the view this far away, and the volumes with it; 0: nowhere"};
    Angle lightTurn{this, "light-turn", 0, "turn the light about the vertical"};
    Real lightHeight{this, "light-height", 1, {0.1, 3}, "height of the light, in its first height"};
    Toggle atInfinity{this, "at-infinity", false, "a light at infinity, in the direction of this one"};
    Turntable turntable{this, {-3, 10}};

    Readout edges{this, "extruded-edges", "edges drawn out to infinity; of the silhouette, or of every triangle"};
    Readout triangles{this, "volume-triangles", "triangles of the volumes that are counted"};

    Program program, volumeProgram;
    OnDemand<Mesh> wholePicture{positionsOnly(square()), "whole picture"};
    Scene now;
    SceneMeshes meshes;
    CasterVolumes volumes;
    std::vector<Mesh> silhouettes;  // one a caster, as lines; made to be shown

    ShadowVolumes() {
        bindKeys(Key::left, Key::right, lightTurn, 5);
        bindKeys(Key::down, Key::up, lightHeight, 0.1);
        shells.onlyWhen([this] { return which == Which::nested; }, "only the nested scene has shells");
        groups.onlyWhen([this] { return which == Which::nested && shells > 255; },
                        "there are no more casters than eight bits count");
        groups.onlyWhen([this] { return show != Show::count; }, "what is shown is the stencil buffer, in one count");
    }

    void init() override {
        program = Program("shadow-volume");
        volumeProgram = Program("shadow-volume", "volume");
    }

    void draw(const Frame& frame) override {
        now = seen(frame);
        meshes.follow(now);
        if (volumes.follow(now, light(), silhouetteOnly ? Extrude::silhouette : Extrude::everyTriangle))
            silhouettes.clear();
        tell(frame);

        // 1. The scene in full light: its colours, and in the depth buffer what is seen
        glEnable(GL_DEPTH_TEST);
        program.use();
        program.set("light", light());
        drawObjects(1);

        // 2. Count in each pixel the volumes round what is seen; colours and depths stay as they are
        glEnable(GL_STENCIL_TEST);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        glDepthMask(GL_FALSE);
        if (inGroups()) {
            countInGroups();
        } else {
            countVolumes(0, casterCount());
        }

        // 3. What is in shadow again, without the light
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glStencilFunc(GL_NOTEQUAL, 0, inGroups() ? inSomeGroup : 0xFF);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
        glDepthFunc(GL_EQUAL);
        program.use();
        drawObjects(0);
    }

    // Adds the volumes of some casters to the stencil buffer, by whether a side of theirs is before or behind what is seen.
    void countVolumes(std::size_t first, std::size_t last) {
        startCount(first, last);
        if (method == Method::zFail) {
            // From the far end of the view towards what is seen: in through a back face, out through a front face
            glStencilOpSeparate(GL_BACK, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
            glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
        } else {
            // From the eye towards what is seen: in through a front face, out through a back face
            glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_KEEP, GL_INCR_WRAP);
            glStencilOpSeparate(GL_BACK, GL_KEEP, GL_KEEP, GL_DECR_WRAP);
        }
        volumeProgram.use();
        for (std::size_t i = first; i < last; ++i) drawVolume(volumes.casters()[i], counted(volumes.casters()[i]));
    }

    // The count starts at 0, as cleared, or at the number of volumes that the eye is in.
    void startCount(std::size_t first, std::size_t last) {
        const int start = method == Method::zPassStarted ? volumesRoundEye(first, last) & 0xFF : 0;
        if (start == 0 && first == 0) return;
        glStencilFunc(GL_ALWAYS, start, ~0U);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        drawEverywhere(vec4(0));
        glStencilFunc(GL_ALWAYS, 0, ~0U);
    }

    // Seven bits count one group after the other, the eighth keeps whether a count was not 0.
    static constexpr GLuint inOneGroup = 0x7F, inSomeGroup = 0x80;

    void countInGroups() {
        constexpr std::size_t most = inOneGroup;
        for (std::size_t first = 0; first < casterCount(); first += most) {
            glStencilMask(inOneGroup);
            countVolumes(first, std::min(first + most, casterCount()));
            glStencilMask(inSomeGroup);
            glStencilFunc(GL_NOTEQUAL, inSomeGroup, inOneGroup);
            glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
            drawEverywhere(vec4(0));
        }
    }

    void drawVolume(const Caster& caster, std::size_t indices) {
        volumeProgram.set("clipFromObject", clipFromObject(now.objects[caster.object]));
        caster.mesh.draw(0, indices);
    }

    void drawObjects(double lit) {
        program.set("lit", lit);
        for (const auto& [object, mesh] : meshes.of(now)) {
            program.set("clipFromObject", clipFromObject(object));
            program.set("worldFromObject", object.worldFromObject);
            program.set("worldFromNormal", normalMatrix(object.worldFromObject));
            program.set("color", object.color);
            mesh.draw();
        }
    }

    // Each pixel that the stencil lets through, whatever its depth.
    void drawEverywhere(const vec4& color) {
        glDisable(GL_DEPTH_TEST);
        volumeProgram.use();
        volumeProgram.set("clipFromObject", rotateX(90) * scale(2));
        volumeProgram.set("color", color);
        wholePicture->draw();
        glEnable(GL_DEPTH_TEST);
    }

    vec4 light() const { return now.lights[0].position; }
    mat4 clipFromObject(const SceneObject& object) const { return now.clipFromWorld() * object.worldFromObject; }
    std::size_t casterCount() const { return volumes.casters().size(); }

    // The caps of a volume lie behind what is seen, always: z-pass does without them.
    std::size_t counted(const Caster& caster) const {
        return method == Method::zFail ? caster.volume.indices.size() : caster.volume.sides;
    }

    // How many of some casters' volumes the eye is in.
    int volumesRoundEye(std::size_t first, std::size_t last) const {
        return volumes.around(now, vec3(glm::inverse(now.viewFromWorld)[3]), first, last);
    }

    // A convex caster counts once at most, the pawn and the ring a few times.
    bool mayWrap() const { return casterCount() > 255; }
    bool inGroups() const { return mayWrap() && groups && show != Show::count; }

    // ---- What is shown

    // Without a far plane, unless one is to cut the volumes off.
    Scene scene(const FrameInfo& frame) const override {
        const double aspect = frame.aspect();
        Scene scene = which == Which::cube        ? cubeOnPlane(aspect)
                      : which == Which::stillLife ? stillLife(aspect)
                                                  : nestedShells(aspect, shells);
        vec4& light = scene.lights[0].position;
        light = rotateY(lightTurn) * scale(1, lightHeight, 1) * light;
        if (atInfinity) light.w = 0;
        scene.clipFromView = withDepths(scene.clipFromView, near, far == 0 ? HUGE_VAL : double(far));
        if (eye == Place::outside) {
            scene.viewFromWorld = turntable.seenBy(scene.viewFromWorld);
        } else {
            const bool life = which == Which::stillLife;
            const vec3 at = life ? vec3(2.6, 0.3, -1.2) : vec3(0.8, 0.15, -0.5);
            scene.viewFromWorld =
                turntable.turn() * lookAt(at, life ? vec3(1.2, 0.3, 1.0) : vec3(0.6, 0.2, 1.5), {0, 1, 0});
        }
        return scene;
    }

    void annotate(const Frame& frame) override {
        if (show == Show::volumes) drawGlass();
        if (show == Show::count) drawCount(frame);
    }

    // The sides of the volumes as glass: those that a way from the eye enters by in yellow, those it leaves by in blue.
    void drawGlass() {
        glDisable(GL_STENCIL_TEST);
        glDepthFunc(GL_LESS);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
        glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
        glEnable(GL_CULL_FACE);
        volumeProgram.use();
        for (const bool front : {false, true}) {
            glCullFace(front ? GL_BACK : GL_FRONT);
            volumeProgram.set("color", front ? vec4(1, 0.72, 0.1, 0.2) : vec4(0.2, 0.4, 1, 0.2));
            for (const Caster& caster : volumes.casters()) drawVolume(caster, caster.volume.sides);
        }
        volumeProgram.set("color", vec4(0.8, 0.05, 0.05, 1));
        if (silhouettes.empty()) makeSilhouettes();
        for (std::size_t i = 0; i < silhouettes.size(); ++i) {
            // The silhouette lies in the solid's faces: a little nearer it is seen
            const mat4 clip = clipFromObject(now.objects[volumes.casters()[i].object]);
            volumeProgram.set("clipFromObject", translate(0, 0, -5e-5) * clip);
            silhouettes[i].draw();
        }
    }

    void makeSilhouettes() {
        for (const Caster& caster : volumes.casters()) {
            const SceneObject& object = now.objects[caster.object];
            MeshData lines;
            lines.primitive = Primitive::lines;
            for (const auto& edge : silhouette(caster.closed, glm::inverse(object.worldFromObject) * light())) {
                for (const auto vertex : edge.vertex) lines.positions.push_back(caster.closed.positions()[vertex]);
            }
            silhouettes.emplace_back(lines, object.name + " silhouette");
        }
    }

    // The count's binary digits as colours on the darkened picture: 1 is blue, 2 green, 4 red; 8, 16, 32 the same, darker.
    static vec3 colorOf(int count) {
        vec3 color(0);
        for (int bit = 0; bit < 8; ++bit) {
            if (count >> bit & 1) color[2 - bit % 3] += 0.4 / (1 << (bit / 3));
        }
        return color;
    }

    void drawCount(const Frame& frame) {
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
        glEnable(GL_BLEND);
        glStencilFunc(GL_ALWAYS, 0, ~0U);
        glBlendFunc(GL_ZERO, GL_SRC_COLOR);
        drawEverywhere(vec4(0.3));
        glBlendFunc(GL_ONE, GL_ONE);
        for (int bit = 0; bit < 8; ++bit) {
            glStencilFunc(GL_EQUAL, 1 << bit, 1U << bit);
            drawEverywhere(vec4(colorOf(1 << bit), 1));
        }
        glDisable(GL_STENCIL_TEST);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        std::vector<TextLine> legend;
        for (int count = 1; count < 8; ++count) {
            const vec4 color(0.15 + 1.5 * colorOf(count), 1);
            legend.push_back({20 * count - 12, 8, std::to_string(count), {.color = vec4(1), .background = color}});
        }
        drawText(frame, legend);
    }

    void tell(const Frame& frame) {
        frame.show("viewFromWorld", now.viewFromWorld);
        frame.show("clipFromView", now.clipFromView);
        std::size_t drawn = 0, extruded = 0;
        for (const Caster& caster : volumes.casters()) {
            drawn += counted(caster) / 3;
            extruded += caster.volume.edges;
        }
        frame.count("volume triangles", double(drawn));
        triangles = double(drawn);
        edges = double(extruded);
        const int around = volumesRoundEye(0, casterCount());
        if (method == Method::zPass && around > 0) {
            frame.say("The eye is in " + std::to_string(around) + (around == 1 ? " volume" : " volumes") +
                      ", and z-pass counts from 0: the shadows are wrong.");
        }
        if (mayWrap() && !inGroups()) {
            frame.say(std::to_string(casterCount()) +
                      " volumes may lie over one another; eight bits count 256 of them as 0, which reads as lit.");
        }
    }
};

constexpr Declaration declaration{
    .name = "shadow-volume",
    .sentence = "Shadow volumes counted in the stencil buffer, by z-pass and z-fail.",
    .lookFor =
        "From the eye into a volume through a yellow side, out through a blue one: what lies between is in shadow.",
    .chapter = "Shadows",
    .number = 13,
    .width = 640,
    .height = 480,
    .background = vec4(0.70, 0.77, 0.85, 1),
    .needs = {.depth = true,
              .stencil = true,
              .beyondEs = {{"depth read-back", "shadow-pixels and stencil-max are not measured"},
                           {"stencil read-back", "shadow-pixels and stencil-max are not measured"},
                           {"float targets", "wrong is not measured"}}},
    .presets =
        {
            {"volumes",
             "A way from the eye goes into a volume through yellow and out through blue; more often in than out is "
             "shadow."},
            {"counts",
             "Boxes in boxes: each colour is how many volumes the point is in.",
             {{"scene", "nested"}, {"show", "count"}}},
            {"eye-in-volume",
             "The eye is in the shadow itself, and counting from the far end is right all the same.",
             {{"scene", "cube"}, {"show", "shadow"}, {"eye", "in-volume"}}},
            {"z-pass",
             "Counted from the eye, which is in a volume: light and shadow have changed places.",
             {{"scene", "cube"}, {"method", "z-pass"}, {"show", "shadow"}, {"eye", "in-volume"}}},
            {"wrapped",
             "256 boxes in boxes count as 0 in eight bits: a lit hole in the shadow.",
             {{"scene", "nested"}, {"shells", "256"}, {"show", "shadow"}, {"groups", "off"}}},
            {"every-triangle",
             "Each triangle drawn out, instead of the silhouette: far more to fill, and no better.",
             {{"silhouette", "off"}}},
        },
    .waste = {{"no-sample", "draw of 'shell #'", "what a volume counts is known when it is drawn"},
              {"no-sample", "draw of 'whole picture'", "what no volume covers is known when it is drawn"},
              {"no-sample", "draw of 'cube'", "what is wholly hidden is known when it is drawn"}},
};

const bool added = addDemo<ShadowVolumes, declaration>();

}  // namespace

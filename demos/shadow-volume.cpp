// shadow-volume: shadows counted in the stencil buffer, by the surface of the space that each solid keeps from the light.
//
// Claims (each is a test in tests/claims/shadow-volume.cpp):
// - [exact] By z-fail no pixel of any scene differs from what rays show, except in the band of one pixel at edges.
// - [eye-in-volume] With the eye in a volume z-pass is wrong nearly everywhere, z-fail and a counted start are right.
// - [silhouette-is-enough] Drawing out every triangle gives the same shadow, with many times the triangles.
// - [counts-are-rays] The stencil buffer holds how many surfaces stand between each pixel and the light.
// - [three-hundred-shells] 255, 256 and 300 nested shells are exact in groups; in one count 256 of them read as lit,
//   and a sentence says so.
// - [light-anywhere] A light at infinity, exactly in the plane of a face, or below the casters: still no pixel wrong.
#include <algorithm>
#include <cmath>
#include <functional>
#include <glm/matrix.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/lit_reference.h"
#include "mv/demo/turntable.h"
#include "mv/geometry/scenes.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/caster_volumes.h"
#include "mv/gl/gl.h"
#include "mv/gl/scene_meshes.h"
#include "mv/gl/shadow_check.h"
#include "mv/gl/text.h"
#include "mv/math/transform.h"

using namespace mv;

namespace {

enum class Which { cube, stillLife, nested };
enum class Method { zPass, zPassStarted, zFail };
enum class Show { shadow, volumes, count };
enum class Place { outside, inVolume };

constexpr double near = 0.1;  // distance from the eye where the view begins

// Boxes in boxes over the cube's floor: as many volumes over one another as there are boxes.
Scene nestedShells(double aspect, int shells) {
    Scene scene = cubeOnPlane(aspect);
    scene.objects.pop_back();
    for (int i = 0; i < shells; ++i) {
        const double half = 0.2 + 0.35 * (i + 1) / shells;
        scene.objects.push_back({"shell " + std::to_string(i + 1),
                                 box(vec3(-half), vec3(half)),
                                 translate(0, 0.8, 0) * rotateY(30),
                                 {0.30, 0.52, 0.78},
                                 true,
                                 true});
    }
    return scene;
}

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
    Readout inShadow{this, "shadow-pixels", "pixels of the scene whose count is not 0"};
    Readout stencilMost{this, "stencil-max", "largest count of a pixel, where all is one count"};
    Readout wrong{this, "wrong", "part of the pixels of a coarse grid whose shadow is not what rays show", "%"};

    Program program, volumeProgram;
    ShadowCheck shadowCheck;
    Mesh wholePicture;
    Scene scene;
    std::vector<Mesh> meshes;
    CasterVolumes volumes;
    std::vector<Mesh> silhouettes;  // one a caster, as lines
    std::optional<std::pair<Which, int>> built;
    std::size_t trianglesCounted = 0;

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
        built.reset();
    }

    // The scene as the knobs have it: without a far plane, unless one is to cut the volumes off.
    Scene sceneNow(double aspect) const {
        Scene now = which == Which::cube        ? cubeOnPlane(aspect)
                    : which == Which::stillLife ? stillLife(aspect)
                                                : nestedShells(aspect, shells);
        vec4 light = rotateY(lightTurn) * scale(1, lightHeight, 1) * now.lights[0].position;
        if (atInfinity) light.w = 0;
        now.lights[0].position = light;
        now.clipFromView = withDepths(now.clipFromView, near, far == 0 ? HUGE_VAL : double(far));
        if (eye == Place::outside) {
            now.viewFromWorld = turntable.seenBy(now.viewFromWorld);
        } else {
            const bool life = which == Which::stillLife;
            const vec3 at = life ? vec3(2.6, 0.3, -1.2) : vec3(0.8, 0.15, -0.5);
            now.viewFromWorld =
                turntable.turn() * lookAt(at, life ? vec3(1.2, 0.3, 1.0) : vec3(0.6, 0.2, 1.5), {0, 1, 0});
        }
        return now;
    }

    void draw(const Frame& frame) override {
        scene = sceneNow(frame.aspect());
        makeVolumes();
        if (frame.readouts()) {
            if (const auto found = shadowCheck.compare(scene, frame, [&] { drawShadows(true); }))
                wrong = found->dark + found->lit;
        }
        frame.show("viewFromWorld", scene.viewFromWorld);
        frame.show("clipFromView", scene.clipFromView);
        trianglesCounted = 0;
        drawShadows(frame.measuring());
        frame.count("volume triangles", double(trianglesCounted));
        if (frame.measuring()) return;
        tell(frame);
        if (frame.readouts() && !isEs()) readStencil(frame);
        if (show == Show::volumes) drawGlass();
        if (show == Show::count) drawCount(frame);
        if (!frame.readouts()) return;
        triangles = double(trianglesCounted);
        std::size_t extruded = 0;
        for (const CasterVolumes::Caster& caster : volumes.casters()) extruded += caster.volume.edges;
        edges = double(extruded);
    }

    void makeVolumes() {
        const std::pair wanted(Which(which), which == Which::nested ? int(shells) : 0);
        if (built != wanted) {
            meshes = uploadMeshes(scene);
            volumes = CasterVolumes(scene);
            built = wanted;
        }
        const vec4 light = scene.lights[0].position;
        if (!volumes.follow(scene, light, silhouetteOnly ? Extrude::silhouette : Extrude::everyTriangle)) return;
        silhouettes.clear();
        for (const CasterVolumes::Caster& caster : volumes.casters()) {
            const SceneObject& object = scene.objects[caster.object];
            MeshData lines;
            lines.primitive = Primitive::lines;
            for (const auto& edge : silhouette(caster.closed, glm::inverse(object.worldFromObject) * light)) {
                for (const auto vertex : edge.vertex) lines.positions.push_back(caster.closed.positions()[vertex]);
            }
            silhouettes.emplace_back(lines, object.name + " silhouette");
        }
    }

    std::size_t casterCount() const { return volumes.casters().size(); }

    mat4 clipFromObject(std::size_t object) const {
        return scene.clipFromWorld() * scene.objects[object].worldFromObject;
    }

    // How many of some casters' volumes the eye is in.
    int volumesRoundEye(std::size_t first, std::size_t last) const {
        return volumes.around(scene, vec3(glm::inverse(scene.viewFromWorld)[3]), first, last);
    }

    // A convex caster counts once at most, the pawn and the ring a few times.
    bool mayWrap() const { return casterCount() > 255; }
    bool inGroups() const { return mayWrap() && groups && show != Show::count; }

    void drawShadows(bool measuring) {
        // Draw the scene in full light, which also fills the depth buffer
        glEnable(GL_DEPTH_TEST);
        program.use();
        program.set("light", scene.lights[0].position);
        program.set("measuring", measuring);
        drawScene(1);

        // Count the volumes round what is seen in each pixel
        glEnable(GL_STENCIL_TEST);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        glDepthMask(GL_FALSE);
        if (inGroups()) {
            // Seven bits for the count of one group after the other, the eighth for whether one was not 0
            constexpr std::size_t most = 127;
            for (std::size_t first = 0; first < casterCount(); first += most) {
                const std::size_t last = std::min(first + most, casterCount());
                glStencilMask(0x7F);
                countVolumes(first, last);
                glStencilMask(0x80);
                glStencilFunc(GL_NOTEQUAL, 0x80, 0x7F);
                glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
                drawEverywhere(vec4(0));
            }
        } else {
            countVolumes(0, casterCount());
        }

        // Draw what is in shadow again, without the light
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glStencilFunc(GL_NOTEQUAL, 0, inGroups() ? 0x80 : 0xFF);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
        glDepthFunc(GL_EQUAL);
        program.use();
        drawScene(0);
    }

    void countVolumes(std::size_t first, std::size_t last) {
        // Start at 0, as cleared, or with the volumes that the way from the eye begins in
        const int start = method == Method::zPassStarted ? volumesRoundEye(first, last) & 0xFF : 0;
        if (start > 0 || first > 0) {
            glStencilFunc(GL_ALWAYS, start, ~0U);
            glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
            drawEverywhere(vec4(0));
            glStencilFunc(GL_ALWAYS, 0, ~0U);
        }
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
        for (std::size_t i = first; i < last; ++i) {
            // The caps lie behind what is seen, always: z-pass does without them
            const ShadowVolume& volume = volumes.casters()[i].volume;
            const std::size_t indices = method == Method::zFail ? volume.indices.size() : volume.sides;
            drawVolume(volumes.casters()[i], indices);
            trianglesCounted += indices / 3;
        }
    }

    void drawVolume(const CasterVolumes::Caster& caster, std::size_t indices) {
        volumeProgram.set("clipFromObject", clipFromObject(caster.object));
        caster.mesh.draw(0, indices);
    }

    void drawScene(double lit) {
        program.set("lit", lit);
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            const mat4& worldFromObject = scene.objects[i].worldFromObject;
            program.set("clipFromObject", clipFromObject(i));
            program.set("worldFromObject", worldFromObject);
            program.set("worldFromNormal", normalMatrix(worldFromObject));
            program.set("color", scene.objects[i].color);
            meshes[i].draw();
        }
    }

    // Each pixel that the stencil lets through, whatever its depth.
    void drawEverywhere(const vec4& color) {
        glDisable(GL_DEPTH_TEST);
        volumeProgram.use();
        volumeProgram.set("clipFromObject", rotateX(90) * scale(2));
        volumeProgram.set("color", color);
        if (wholePicture.count() == 0) wholePicture = Mesh(square(), "whole picture");
        wholePicture.draw();
        glEnable(GL_DEPTH_TEST);
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
            for (const CasterVolumes::Caster& caster : volumes.casters()) drawVolume(caster, caster.volume.sides);
        }
        volumeProgram.set("color", vec4(0.8, 0.05, 0.05, 1));
        for (std::size_t i = 0; i < silhouettes.size(); ++i) {
            // The silhouette lies in the solid's faces: a little nearer it is seen
            const mat4 clip = clipFromObject(volumes.casters()[i].object);
            volumeProgram.set("clipFromObject", translate(0, 0, -5e-5) * clip);
            silhouettes[i].draw();
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

    void tell(const Frame& frame) const {
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

    void readStencil(const Frame& frame) {
        const auto pixels = static_cast<std::size_t>(frame.width()) * static_cast<std::size_t>(frame.height());
        std::vector<unsigned char> counts(pixels);
        std::vector<float> depths(pixels);
        glPixelStorei(GL_PACK_ALIGNMENT, 1);
        glReadPixels(0, 0, frame.width(), frame.height(), GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, counts.data());
        glReadPixels(0, 0, frame.width(), frame.height(), GL_DEPTH_COMPONENT, GL_FLOAT, depths.data());
        int most = 0;
        long dark = 0;
        for (std::size_t i = 0; i < pixels; ++i) {
            if (depths[i] == 1) continue;  // nothing is seen there
            most = std::max(most, int(counts[i]));
            dark += counts[i] > 0 ? 1 : 0;
        }
        if (!inGroups()) stencilMost = most;
        inShadow = double(dark);
    }

    Reference reference(const Frame& frame, const std::function<void(double)>& progress) const override {
        return litReference(sceneNow(frame.aspect()), frame, {}, progress);
    }
};

const bool added = addDemo<ShadowVolumes>({
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
    .study =
        Study{
            .quantity = "lit or in shadow, of the pixels that face the light",
            .reference = "one ray through each pixel and one to the light, in double precision",
            .scenes = {{"cube", {{"scene", "cube"}}},
                       {"still-life", {{"scene", "still-life"}}},
                       {"40 shells", {{"scene", "nested"}, {"shells", "40"}}},
                       {"eye in a volume", {{"scene", "cube"}, {"eye", "in-volume"}}}},
            .lines = {{"z-fail", {}},
                      {"z-fail, every triangle", {{"silhouette", "off"}}},
                      {"z-pass", {{"method", "z-pass"}}},
                      {"z-pass, started", {{"method", "z-pass-started"}}}},
            .axis = ErrorAxis::fraction,
            .says =
                "Volumes drawn out from silhouettes are exact: no pixel is wrong but in the band of one pixel at "
                "edges, by z-fail and, with the eye outside, by z-pass. Drawing out every triangle costs some twenty "
                "times as much on curved solids and is less exact, since the inner sides cancel only up to rounding; "
                "with the eye in a volume z-pass is wrong everywhere.",
        },
});

}  // namespace

// shadow-methods: one scene, and its shadows by every method: side by side, or subtracted.
//
// Claims (each is a test in tests/claims/shadow-methods.cpp):
// - [exact-on-a-plane] On the cube's plane neither the matrix nor the volumes have a wrong pixel.
// - [least-work] Of all methods that draw a shadow the matrix draws the fewest fragments, in one pass.
// - [bodies-need-more] In the still life the matrix is wrong where a body shades a body; volumes stay exact there.
// - [texels-are-the-error] Doubling the map's resolution halves the part of the pixels that is wrong.
// - [map-is-kept] A kept map makes the same picture in one pass less.
// - [receiver-left-out] Without floor and wall the map needs no bias, and draws less for the same shadow.
// - [split] Left of the split is one method, right of it the other.
// - [difference] The false colours stand where the two differ, and the readouts count them.
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/made_for.h"
#include "mv/geometry/light_view.h"
#include "mv/gl/depth_map.h"
#include "mv/gl/gl.h"
#include "mv/gl/scene_meshes.h"
#include "mv/gl/text.h"
#include "mv/math/shadow.h"
#include "mv/math/transform.h"
#include "shared/caster_volumes.h"
#include "shared/lit_difference.h"
#include "shared/scenes.h"
#include "shared/turntable.h"
#include "shared/z_fail.h"

using namespace mv;

namespace {

enum class Which { cube, stillLife };
enum class Method { none, matrix, volume, map, mapHardware, pcf3, pcf5 };
enum class Show { picture, difference };

bool usesMap(Method method) { return method >= Method::map; }
int looksAlong(Method method) { return method == Method::pcf5 ? 5 : method == Method::pcf3 ? 3 : 1; }

struct ShadowMethods final : Demo {
    Choice<Which> which{this, "scene", Which::stillLife, {{"cube-on-plane"}, {"still-life"}}, "what is shown"};
    Choice<Method> method{this,
                          "method",
                          Method::map,
                          {{"none", "no shadow"},
                           {"matrix", "what casts, flattened onto floor and wall"},
                           {"volume", "shadow volumes, counted by z-fail"},
                           {"map", "shadow map, one texel"},
                           {"map-hardware", "four texels, weighted"},
                           {"pcf3", "3 x 3 such looks"},
                           {"pcf5", "5 x 5"}},
                          "how shadows are found"};
    Choice<int> against{
        this,
        "against",
        3,
        {{"off"}, {"none"}, {"matrix"}, {"volume"}, {"map"}, {"map-hardware"}, {"pcf3"}, {"pcf5"}},
        "a second method, right of the split or subtracted; off: none, and subtracted is what rays show"};
    Real split{this, "split", 0.5, {0, 1}, "where the second method begins, in widths of the picture"};
    Choice<Show> show{this,
                      "show",
                      Show::picture,
                      {{"picture"}, {"difference", "red: too dark; blue: too light"}},
                      "the picture, or what the lit fractions differ by"};
    NumberChoice resolution{this, "resolution", 256, {256, 512, 1024, 2048, 4096}, "texels along a side of the map"};
    Toggle receiver{this, "receiver", false,
                    "fronts and floor in the map, which need a bias; off: the backs of what casts"};
    Real slopeBias{this, "slope-bias", 0, {0, 16}, "push the map back by its slope over this many texels"};
    Toggle keep{this, "keep", true, "keep map and volumes while light and casters rest"};
    Turntable turntable{this, {-3, 10}};

    Readout different{this, "different", "pixels whose lit fractions differ by more than half", "%"};
    Readout differenceRms{this, "difference-rms", "root mean square of the difference"};

    Scene now;
    SceneMeshes meshes;
    std::map<std::string, Program> programs;  // each made when a method first uses it
    CasterVolumes volumes;
    DepthMap map;
    LightView lightView;
    MadeFor<Which> lightViewFor;
    MadeFor<Which, int, bool, double> mapFor;
    LitDifference litDifference;

    ShadowMethods() {
        bindKeys(Key::left, Key::right, split, 0.02);
        split.onlyWhen([this] { return second() && show == Show::picture; }, "there is no line between two methods");
        for (Knob* knob : std::initializer_list<Knob*>{&resolution, &receiver, &slopeBias}) {
            knob->onlyWhen([this] { return usesMap(method) || usesMap(second().value_or(method)); }, "no map is used");
        }
    }

    void init() override {}

    void draw(const Frame& frame) override {
        now = seen(frame);
        frame.show("viewFromWorld", now.viewFromWorld);
        frame.show("clipFromView", now.clipFromView);
        meshes.follow(now);
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_CULL_FACE);

        // What is measured is the first method alone
        const std::optional<Method> other = frame.measuring() ? std::nullopt : second();
        const Method beside = other.value_or(method);
        if (usesMap(method) || usesMap(beside)) makeMap(frame);
        if (method == Method::volume || beside == Method::volume) makeVolumes();
        if (show == Show::difference && !frame.measuring()) return drawDifference(other, frame);
        if (!other) return drawScene(method);

        // Left of the split by one method, right of it by the other
        const int middle = int(std::lround(split * frame.width()));
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, middle, frame.height());
        if (middle > 0) drawScene(method);
        if (middle == frame.width()) return;
        glScissor(middle, 0, frame.width() - middle, frame.height());
        drawScene(*other);
        glScissor(middle, 0, 1, frame.height());
        glClearColor(1, 1, 1, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }

    // ---- What some methods prepare, and keep while the light and what casts rest

    void makeVolumes() {
        if (!keep) volumes.forget();
        volumes.follow(now, now.lights[0].position);
    }

    void makeMap(const Frame& frame) {
        const int size = resolution;
        if (!mapFor.changed(which, size, receiver, slopeBias) && keep) return;
        if (map.size() != size) map = DepthMap(size, "shadow map");
        if (lightViewFor.changed(which)) lightView = fitLightView(now.lights[0].position, casterPoints(now));
        map.bindForDrawing();
        glClear(GL_DEPTH_BUFFER_BIT);
        // Backs are as good an end of the shadow as fronts, and what is lit is not there to shade itself
        if (!receiver) glCullFace(GL_FRONT);
        glEnable(GL_POLYGON_OFFSET_FILL);
        if (slopeBias > 0) glPolygonOffset(float(slopeBias), float(2 * slopeBias));
        const Program& program = use("flat");
        for (const auto& [object, mesh] : meshes.of(now)) {
            if (!receiver && !object.casts) continue;
            program.set("clipFromObject", lightView.clipFromWorld() * object.worldFromObject);
            mesh.draw();
        }
        glDisable(GL_POLYGON_OFFSET_FILL);
        if (!receiver) glCullFace(GL_BACK);
        frame.bindTarget();
    }

    // ---- The scene with its shadows by one method: a picture, or the lit fraction of each pixel

    void drawScene(Method by) {
        const Program& program = use(usesMap(by) ? "map" : "");
        program.set("light", now.lights[0].position);
        if (usesMap(by)) {
            map.bind(1, by == Method::map ? DepthLookup::compareNearest : DepthLookup::compareLinear);
            program.set("map", 1);
            program.set("side", looksAlong(by));
        } else {
            program.set("lit", 1.0);
        }
        if (by == Method::matrix) {
            // Note in the stencil buffer which plane is seen, 0 for a body
            glEnable(GL_STENCIL_TEST);
            glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        }
        int place = 0;
        for (const auto& [object, mesh] : meshes.of(now)) {
            ++place;
            if (by == Method::matrix) glStencilFunc(GL_ALWAYS, object.casts ? 0 : place, ~0U);
            drawObject(program, by, object, mesh);
        }
        if (by == Method::matrix) drawFlattened();
        if (by == Method::volume) drawInVolumes(program);
        if (by == Method::matrix || by == Method::volume) glDisable(GL_STENCIL_TEST);
    }

    void drawObject(const Program& program, Method by, const SceneObject& object, const Mesh& mesh) const {
        program.set("clipFromObject", now.clipFromWorld() * object.worldFromObject);
        program.set("worldFromObject", object.worldFromObject);
        if (usesMap(by)) program.set("mapFromObject", lightView.mapFromWorld() * object.worldFromObject);
        program.set("color", object.color);
        mesh.draw();
    }

    // What casts, flattened onto each plane that is seen: no depth test, and nothing to blend, so nothing can show twice.
    void drawFlattened() {
        glDisable(GL_DEPTH_TEST);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
        const Program& program = use("flat");
        int place = 0;
        for (const SceneObject& plane : now.objects) {
            ++place;
            if (plane.casts) continue;
            const vec3 normal(plane.worldFromObject[1]), origin(plane.worldFromObject[3]);
            const mat4 flat = shadowProjection(now.lights[0].position, {normal, -glm::dot(normal, origin)}, origin);
            const mat4 clipFromFlat = now.clipFromWorld() * translate(origin) * flat;
            glStencilFunc(GL_EQUAL, place, ~0U);
            program.set("color", plane.color);
            for (const auto& [object, mesh] : meshes.of(now)) {
                if (!object.casts) continue;
                program.set("clipFromObject", clipFromFlat * translate(-origin) * object.worldFromObject);
                mesh.draw();
            }
        }
        glEnable(GL_DEPTH_TEST);
    }

    // Count the volumes behind what is seen, by z-fail, and draw again, without the light, where some are left.
    void drawInVolumes(const Program& program) {
        glEnable(GL_STENCIL_TEST);
        glStencilFunc(GL_ALWAYS, 0, ~0U);
        glDisable(GL_CULL_FACE);
        glDepthMask(GL_FALSE);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        countByZFail(volumes, now, use("flat"));
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glEnable(GL_CULL_FACE);
        glStencilFunc(GL_NOTEQUAL, 0, ~0U);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
        glDepthFunc(GL_EQUAL);
        program.use();
        program.set("lit", 0.0);
        for (const auto& [object, mesh] : meshes.of(now)) drawObject(program, Method::volume, object, mesh);
        glDepthFunc(GL_LESS);
        glDepthMask(GL_TRUE);
    }

    // Where the lit fractions by the two methods differ, or by one and rays.
    void drawDifference(std::optional<Method> other, const Frame& frame) {
        const auto lit = [this](Method by) { return [this, by] { drawScene(by); }; };
        const auto found = litDifference.show(now, frame, lit(method), other ? lit(*other) : std::function<void()>());
        different = found.beyondHalf;
        differenceRms = found.rms;
    }

    const Program& use(const std::string& variant) {
        const Program& program = programs.try_emplace(variant, "shadow-methods", variant).first->second;
        program.use();
        return program;
    }

    std::optional<Method> second() const { return against == 0 ? std::nullopt : std::optional(Method(against - 1)); }

    // Without a far plane, which would cut the volumes off.
    Scene scene(const FrameInfo& frame) const override {
        Scene scene = which == Which::cube ? cubeOnPlane(frame.aspect()) : stillLife(frame.aspect());
        scene.viewFromWorld = turntable.seenBy(scene.viewFromWorld);
        scene.clipFromView = withDepths(scene.clipFromView, 0.1, HUGE_VAL);
        return scene;
    }

    void annotate(const Frame& frame) override {
        if (second()) glDisable(GL_SCISSOR_TEST);
        const Method beside = second().value_or(method);
        if (usesMap(method))
            frame.count("texels a lookup", (method == Method::map ? 1 : 4) * looksAlong(method) * looksAlong(method));
        if (which == Which::stillLife && (method == Method::matrix || beside == Method::matrix))
            frame.say("The matrix flattens onto floor and wall; no body has a shadow of its own or of another.");
        if (show == Show::difference) {
            const std::string less = second() ? against.text() : "rays";
            drawText(frame, 8, 8, method.text() + " less " + less + ": red too dark, blue too light");
        } else if (second()) {
            const int middle = int(std::lround(split * frame.width()));
            std::vector<TextLine> names;
            if (middle > 0) names.push_back({middle - 8 - textWidth(method.text()), 8, method.text()});
            if (middle < frame.width()) names.push_back({middle + 8, 8, against.text()});
            drawText(frame, names);
        }
    }
};

constexpr Literal otherHalf = "each side of the line draws the whole scene, and some of it is on the other side";

constexpr Declaration declaration{
    .name = "shadow-methods",
    .sentence = "All methods on one scene: matrix, volumes and maps, side by side and against time.",
    .lookFor =
        "On one flat floor the matrix is exact; between bodies it has no shadow, and a map's are as coarse as "
        "its texels.",
    .chapter = "Shadows",
    .number = 16,
    .width = 640,
    .height = 480,
    .background = vec4(0.70, 0.77, 0.85, 1),
    .needs = {.depth = true,
              .stencil = true,
              .beyondEs = {{"float targets", "--show difference is refused, and wrong is not measured"}}},
    .presets =
        {
            {"map-and-volumes", "Left of the line a coarse map, right of it volumes: follow a shadow's edge across."},
            {"matrix",
             "One flat floor and one matrix: for this scene there is nothing better.",
             {{"scene", "cube-on-plane"}, {"method", "matrix"}, {"against", "off"}, {"resolution", "1024"}}},
            {"matrix-is-wrong",
             "What the matrix lacks, in blue: the shadows of bodies on bodies.",
             {{"method", "matrix"}, {"against", "off"}, {"show", "difference"}, {"resolution", "1024"}}},
            {"map-is-wrong",
             "What a coarse map gets wrong, along every edge.",
             {{"against", "off"}, {"show", "difference"}}},
            {"acne",
             "The floor in the map, without a bias: it shades itself in stripes, and a filter does not help.",
             {{"scene", "cube-on-plane"}, {"against", "pcf3"}, {"resolution", "1024"}, {"receiver", "on"}}},
        },
    .waste = {{"no-sample", "draw of 'box'", otherHalf},
              {"no-sample", "draw of 'pawn'", otherHalf},
              {"no-sample", "draw of 'sphere'", otherHalf},
              {"repeated-pass", "pass into 'lit fraction'", "what each method costs in every frame is the lesson"},
              {"unused-buffer", "stencil of 'lit fraction'", "maps do without what volumes need"},
              {"unused-buffer", "stencil of 'shadow-methods'", "maps do without what volumes need"}},
};

const bool added = addDemo<ShadowMethods, declaration>();

}  // namespace

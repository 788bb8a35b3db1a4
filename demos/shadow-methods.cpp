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
#include <tuple>
#include <utility>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/lit_reference.h"
#include "mv/demo/turntable.h"
#include "mv/geometry/light_view.h"
#include "mv/geometry/scenes.h"
#include "mv/gl/caster_volumes.h"
#include "mv/gl/depth_map.h"
#include "mv/gl/gl.h"
#include "mv/gl/lit_difference.h"
#include "mv/gl/scene_meshes.h"
#include "mv/gl/shadow_check.h"
#include "mv/gl/text.h"
#include "mv/gl/z_fail.h"
#include "mv/math/shadow.h"
#include "mv/math/transform.h"

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

    Readout wrong{this, "wrong", "pixels of a coarse grid whose shadow is not what rays show", "%"};
    Readout different{this, "different", "pixels whose lit fractions differ by more than half", "%"};
    Readout differenceRms{this, "difference-rms", "root mean square of the difference"};

    Scene scene;
    mat4 viewAsBuilt{1};
    std::vector<Mesh> meshes;
    LightView lightView;
    std::optional<std::pair<Which, double>> built;  // the scene, and its aspect

    // What only some methods need is made when one of them is first chosen.
    std::map<std::string, Program> programs;
    CasterVolumes volumes;
    DepthMap map;
    std::optional<std::tuple<Which, int, bool, double>> mapped;  // what the map was drawn for
    ShadowCheck shadowCheck;
    LitDifference litDifference;

    ShadowMethods() {
        bindKeys(Key::left, Key::right, split, 0.02);
        split.onlyWhen([this] { return second() && show == Show::picture; }, "there is no line between two methods");
        for (Knob* knob : std::initializer_list<Knob*>{&resolution, &receiver, &slopeBias}) {
            knob->onlyWhen([this] { return usesMap(method) || usesMap(second().value_or(method)); }, "no map is used");
        }
    }

    void init() override {}

    const Program& use(const std::string& variant) {
        const Program& program = programs.try_emplace(variant, "shadow-methods", variant).first->second;
        program.use();
        return program;
    }

    std::optional<Method> second() const { return against == 0 ? std::nullopt : std::optional(Method(against - 1)); }

    Scene build(double aspect) const {
        Scene made = which == Which::cube ? cubeOnPlane(aspect) : stillLife(aspect);
        // No far plane, which would cut the volumes off
        made.clipFromView = withDepths(made.clipFromView, 0.1, HUGE_VAL);
        return made;
    }

    void draw(const Frame& frame) override {
        if (built != std::pair(Which(which), frame.aspect())) {
            scene = build(frame.aspect());
            viewAsBuilt = scene.viewFromWorld;
            if (!built || built->first != which) {
                meshes = uploadMeshes(scene);
                volumes = {};
                litDifference = {};
                lightView = fitLightView(scene.lights[0].position, casterPoints(scene));
            }
            built = {which, frame.aspect()};
        }
        scene.viewFromWorld = turntable.seenBy(viewAsBuilt);
        frame.show("viewFromWorld", scene.viewFromWorld);
        frame.show("clipFromView", scene.clipFromView);

        glEnable(GL_DEPTH_TEST);
        glEnable(GL_CULL_FACE);
        const std::optional<Method> other = frame.measuring() ? std::nullopt : second();
        const Method beside = other.value_or(method);
        if (usesMap(method) || usesMap(beside)) makeMap(frame);
        if (method == Method::volume || beside == Method::volume) makeVolumes();
        if (usesMap(method))
            frame.count("texels a lookup", (method == Method::map ? 1 : 4) * looksAlong(method) * looksAlong(method));
        if (frame.measuring()) return drawScene(method, true);
        if (which == Which::stillLife && (method == Method::matrix || beside == Method::matrix)) {
            frame.say("The matrix flattens onto floor and wall; no body has a shadow of its own or of another.");
        }
        if (show == Show::difference) {
            const auto lit = [this](Method by) { return [this, by] { drawScene(by, true); }; };
            const auto found = other ? litDifference.show(scene, frame, lit(method), lit(*other))
                                     : litDifference.show(scene, frame, lit(method));
            different = found.beyondHalf;
            differenceRms = found.rms;
            drawText(frame, 8, 8,
                     method.text() + " less " + (other ? against.text() : "rays") + ": red too dark, blue too light");
            return;
        }
        const int middle = other ? int(std::lround(split * frame.width())) : frame.width();
        if (other) glEnable(GL_SCISSOR_TEST);
        if (other) glScissor(0, 0, middle, frame.height());
        if (middle > 0) drawScene(method, false);
        if (other && middle < frame.width()) {
            glScissor(middle, 0, frame.width() - middle, frame.height());
            drawScene(*other, false);
            glScissor(middle, 0, 1, frame.height());
            glClearColor(1, 1, 1, 1);
            glClear(GL_COLOR_BUFFER_BIT);
        }
        if (other) glDisable(GL_SCISSOR_TEST);
        std::vector<TextLine> names;
        if (other && middle > 0) names.push_back({middle - 8 - textWidth(method.text()), 8, method.text()});
        if (other && middle < frame.width()) names.push_back({middle + 8, 8, against.text()});
        if (other) drawText(frame, names);
        if (!frame.readouts()) return;
        if (const auto found = shadowCheck.compare(scene, frame, [&] { drawScene(method, true); }))
            wrong = found->dark + found->lit;
    }

    // ---- What some methods prepare, and keep while the light and what casts rest

    void makeMap(const Frame& frame) {
        const int size = resolution;
        const std::tuple wanted(Which(which), size, bool(receiver), double(slopeBias));
        if (keep && mapped == wanted) return;
        if (map.size() != size) map = DepthMap(size, "shadow map");
        map.bindForDrawing();
        glClear(GL_DEPTH_BUFFER_BIT);
        // Backs are as good an end of the shadow as fronts, and what is lit is not there to shade itself
        if (!receiver) glCullFace(GL_FRONT);
        glEnable(GL_POLYGON_OFFSET_FILL);
        if (slopeBias > 0) glPolygonOffset(float(slopeBias), float(2 * slopeBias));
        const Program& program = use("flat");
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            if (!receiver && !scene.objects[i].casts) continue;
            program.set("clipFromObject", lightView.clipFromWorld() * scene.objects[i].worldFromObject);
            meshes[i].draw();
        }
        glDisable(GL_POLYGON_OFFSET_FILL);
        if (!receiver) glCullFace(GL_BACK);
        mapped = wanted;
        frame.bindTarget();
    }

    void makeVolumes() {
        if (volumes.casters().empty()) volumes = CasterVolumes(scene);
        if (!keep) volumes.forget();
        volumes.follow(scene, scene.lights[0].position);
    }

    // ---- The scene with its shadows by one method: a picture, or the lit fraction of each pixel

    void drawScene(Method by, bool measuring) {
        const Program& program = use(usesMap(by) ? "map" : "");
        program.set("light", scene.lights[0].position);
        program.set("measuring", measuring);
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
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            if (by == Method::matrix) glStencilFunc(GL_ALWAYS, scene.objects[i].casts ? 0 : int(i) + 1, ~0U);
            drawObject(program, by, i);
        }
        if (by == Method::matrix) drawFlattened(measuring);
        if (by == Method::volume) drawInVolumes(program);
        if (by == Method::matrix || by == Method::volume) glDisable(GL_STENCIL_TEST);
    }

    void drawObject(const Program& program, Method by, std::size_t i) const {
        const mat4& worldFromObject = scene.objects[i].worldFromObject;
        program.set("clipFromObject", scene.clipFromWorld() * worldFromObject);
        program.set("worldFromObject", worldFromObject);
        if (usesMap(by)) program.set("mapFromObject", lightView.mapFromWorld() * worldFromObject);
        program.set("color", scene.objects[i].color);
        meshes[i].draw();
    }

    // What casts, flattened onto each plane that is seen: no depth test, and nothing to blend, so nothing can show twice.
    void drawFlattened(bool measuring) {
        glDisable(GL_DEPTH_TEST);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
        const Program& program = use("flat");
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            const SceneObject& plane = scene.objects[i];
            if (plane.casts) continue;
            const vec3 normal(plane.worldFromObject[1]), origin(plane.worldFromObject[3]);
            const mat4 flat = shadowProjection(scene.lights[0].position, {normal, -glm::dot(normal, origin)}, origin);
            const mat4 clipFromFlat = scene.clipFromWorld() * translate(origin) * flat;
            glStencilFunc(GL_EQUAL, int(i) + 1, ~0U);
            program.set("color", measuring ? vec3(0) : plane.color);
            for (std::size_t k = 0; k < meshes.size(); ++k) {
                if (!scene.objects[k].casts) continue;
                program.set("clipFromObject", clipFromFlat * translate(-origin) * scene.objects[k].worldFromObject);
                meshes[k].draw();
            }
        }
        glEnable(GL_DEPTH_TEST);
    }

    // Count the volumes behind what is seen, by z-fail, and draw again, without the light, where some are left.
    void drawInVolumes(const Program& program) {
        countByZFail(volumes, scene, use("flat"));
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glEnable(GL_CULL_FACE);
        glStencilFunc(GL_NOTEQUAL, 0, ~0U);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
        glDepthFunc(GL_EQUAL);
        program.use();
        program.set("lit", 0.0);
        for (std::size_t i = 0; i < meshes.size(); ++i) drawObject(program, Method::volume, i);
        glDepthFunc(GL_LESS);
        glDepthMask(GL_TRUE);
    }

    Reference reference(const Frame& frame, const std::function<void(double)>& progress) const override {
        Scene posed = build(frame.aspect());
        posed.viewFromWorld = turntable.seenBy(posed.viewFromWorld);
        return litReference(posed, frame, {.pixelSide = 8}, progress);
    }
};

// A line of the study along the map's resolution, the map drawn again in each frame.
StudyLine mapLine(const std::string& name, const std::string& method, const std::string& slopeBias,
                  const std::string& receiver = "on", const std::string& keep = "off") {
    return {name,
            {{"method", method}, {"slope-bias", slopeBias}, {"receiver", receiver}, {"keep", keep}},
            "resolution",
            {"256", "512", "1024", "2048", "4096"}};
}

const char* const otherHalf = "each side of the line draws the whole scene, and some of it is on the other side";

const bool added = addDemo<ShadowMethods>({
    .name = "shadow-methods",
    .sentence = "All methods on one scene: matrix, volumes and maps, side by side and against time.",
    .lookFor = "On one flat floor the matrix is exact; between bodies it has no shadow, and a map's are as coarse as "
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
              {"state-again", "glStencilFunc", "counting volumes sets all that it needs, whatever was there before"}},
    .study =
        Study{
            .quantity = "lit fraction of the pixels whose surface faces the light",
            .reference = "a ray in double precision from each pixel to the light; 64 for the root mean square",
            .scenes = {{"cube on plane", {{"scene", "cube-on-plane"}, {"against", "off"}}},
                       {"still life", {{"scene", "still-life"}, {"against", "off"}}}},
            .lines = {{"no shadow", {{"method", "none"}}},
                      {"matrix", {{"method", "matrix"}}},
                      {"volumes", {{"method", "volume"}}},
                      {"volumes, made anew", {{"method", "volume"}, {"keep", "off"}}},
                      mapLine("map, 1 tap", "map", "2"),
                      mapLine("map, hardware 2x2", "map-hardware", "2"),
                      mapLine("map, PCF 3x3", "pcf3", "4"),
                      mapLine("map, PCF 5x5", "pcf5", "6"),
                      mapLine("map, 1 tap, kept", "map", "2", "on", "on"),
                      mapLine("map, 1 tap, receiver left out, no bias", "map", "0", "off")},
            .axis = ErrorAxis::fraction,
            .says = "On one plane the matrix is exact for hardly more time than no shadow takes, and no map, however "
                    "fine, has fewer wrong pixels or takes less time. Where bodies shade bodies the matrix is wrong in "
                    "2 % of the pixels and volumes are exact; a kept map nearly halves its error with each doubling of "
                    "its side at little more time, while one that is drawn anew pays for every texel.",
        },
});

}  // namespace

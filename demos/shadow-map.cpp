// shadow-map: depths as the light sees them, and what is farther than those is in shadow.
//
// Claims (each is a test in tests/claims/shadow-map.cpp):
// - [cast-by-rays] With a fine map the shadows are those that rays find, to a pixel at their edges.
// - [error-is-one-over-resolution] Without a filter the misjudged part of the picture falls as 1/resolution.
// - [acne-without-bias] With no bias what is in the map shades itself, in stripes; slope-bias 1 ends that on what is flat.
// - [light-leaks-with-bias] With back faces in the map a bias lets light in at the foot of what casts.
// - [floor-left-out-needs-no-bias] Where the floor is not in the map, nothing can shade it falsely: no bias is needed.
// - [back-faces-need-no-bias] With back faces in the map nothing that faces the light shades itself.
// - [map-is-kept] While the light and what casts rest, the map is not drawn again, and the picture is the same.
// - [frustum-holds-the-map] The white lines are the edges of what the map holds; fitted, they are tight round what casts.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
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
#include "mv/geometry/shapes.h"
#include "mv/gl/depth_map.h"
#include "mv/gl/gl.h"
#include "mv/gl/light_overlay.h"
#include "mv/gl/light_rays.h"
#include "mv/gl/scene_meshes.h"
#include "mv/gl/shadow_check.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

using namespace mv;

namespace {

enum class Which { spot, cubeOnPlane, stillLife };
enum class Filter { none, hardware, pcf3, pcf5, pcf7 };
enum class Faces { front, back, both };
enum class Rays { spot, orthographic };
enum class Fit { set, fitted };

Scene build(Which which, double aspect) {
    if (which == Which::cubeOnPlane) return cubeOnPlane(aspect);
    return which == Which::stillLife ? stillLife(aspect) : sphereAndCube(aspect);
}

struct ShadowMap final : Demo {
    Choice<Which> which{
        this, "scene", Which::spot, {{"sphere-and-cube"}, {"cube-on-plane"}, {"still-life"}}, "what is shown"};
    Choice<int> resolution{this,
                           "resolution",
                           3,
                           {{"64"}, {"128"}, {"256"}, {"512"}, {"1024"}, {"2048"}, {"4096"}},
                           "texels along a side of the map"};
    Choice<Filter> filter{this,
                          "filter",
                          Filter::none,
                          {{"none", "one texel"},
                           {"hardware", "four, weighted"},
                           {"pcf3", "3 x 3 such looks"},
                           {"pcf5", "5 x 5"},
                           {"pcf7", "7 x 7"}},
                          "how the map is looked up"};
    Real bias{this, "bias", 0.006, {0, 0.2}, "how much deeper than the map (0..1) is not yet shadow"};
    Real slopeBias{this, "slope-bias", 0, {0, 16}, "push the map back by its slope over this many texels"};
    Choice<Faces> faces{
        this, "map-faces", Faces::front, {{"front"}, {"back"}, {"both"}}, "faces in the map, as the light sees them"};
    Toggle receiver{this, "receiver", true, "floor and wall in the map, though they shade nothing"};
    Toggle keep{this, "keep", true, "keep the map while light and casters rest"};
    Choice<Rays> rays{this,
                      "projection",
                      Rays::spot,
                      {{"spot", "from a point, in a cone"}, {"orthographic", "parallel, as from infinity"}},
                      "how the light shines"};
    Choice<Fit> fit{this,
                    "frustum",
                    Fit::set,
                    {{"set", "by fov and window"}, {"fitted", "round what casts; no cone"}},
                    "what the map holds"};
    Real lightX{this, "light-x", 2.5, {-10, 10}, "x of the light"};
    Real lightY{this, "light-y", 4.8, {1, 20}, "y of the light"};
    Real lightZ{this, "light-z", 4.3, {-10, 20}, "z of the light"};
    Real targetX{this, "target-x", 2.5, {-10, 10}, "x of the point that the light looks at"};
    Real targetY{this, "target-y", 1, {0, 20}, "y of the point that the light looks at"};
    Real targetZ{this, "target-z", 3.5, {-10, 20}, "z of the point that the light looks at"};
    Real fov{this, "fov", 120, {1, 179}, "height of the spot's cone", "deg"};
    Real windowWidth{this, "window-width", 3, {0.1, 30}, "of parallel light; by the height, the spot's aspect"};
    Real windowHeight{this, "window-height", 2.4, {0.1, 30}, "of parallel light"};
    Toggle showMap{this, "show-map", true, "show the map in a corner, near is dark"};
    Toggle showRays{this, "rays", false, "show the light's rays through the corners of cube or box"};
    Toggle showFrustum{this, "show-frustum", true, "show the edges of what the map holds"};
    Turntable turntable{this, {-4, 40}};

    Readout falselyDark{this, "falsely-dark", "pixels that are dark though the light reaches them", "%"};
    Readout falselyLit{this, "falsely-lit", "pixels that are lit though they are in shadow", "%"};
    Readout asked{this, "pixels-asked", "how many pixels were compared with rays for these two"};

    Program program, depthProgram;
    DepthMap map;
    LightOverlay overlay;
    Drawing drawing;
    ShadowCheck shadowCheck;
    Scene scene;
    mat4 viewAsBuilt{1};
    std::vector<Mesh> meshes;
    std::optional<std::pair<Which, double>> built;  // the scene, and its aspect

    // What the map depends on; it is drawn again when one of these has changed.
    using Content = std::tuple<mat4, Which, int, Faces, bool, double>;
    std::optional<Content> drawn;

    ShadowMap() {
        bindKeys(Key::left, Key::right, lightX, 0.1);
        bindKeys(Key::up, Key::down, lightZ, 0.1);
        bindHandle("light", {&lightX, &lightY, &lightZ},
                   [this](const Frame& frame) { return placeOf(lightAt(), frame); });
        bindHandle("light's target", {&targetX, &targetY, &targetZ},
                   [this](const Frame& frame) { return placeOf(targetAt(), frame); });
    }

    void init() override {
        program = Program("shadow-map");
        depthProgram = Program("shadow-map", "depth");
        overlay.init();
    }

    void check() const override {
        if (lightAt() == targetAt()) throw Error("--light-x", "the light must not be at its target", lightX.text());
        if (fit == Fit::fitted) (void)lightView();
    }

    vec3 lightAt() const { return {lightX, lightY, lightZ}; }
    vec3 targetAt() const { return {targetX, targetY, targetZ}; }
    vec4 light() const { return rays == Rays::spot ? vec4(lightAt(), 1) : vec4(lightAt() - targetAt(), 0); }

    std::optional<vec2> placeOf(const vec3& point, const Frame& frame) const {
        if (built != std::pair(Which(which), frame.aspect())) return std::nullopt;  // not drawn yet
        const Pane picture{0, 0, frame.width(), frame.height()};
        return pictureFromPane(picture, scene.clipFromView * turntable.seenBy(viewAsBuilt), point);
    }

    // Puts the scene, as built, under this light, and turns it.
    void pose(Scene& asBuilt, const mat4& view) const {
        asBuilt.lights = {{.position = light()}};
        asBuilt.viewFromWorld = turntable.seenBy(view);
    }

    // The points of what casts, which no knob moves.
    const std::vector<vec3>& casters() const {
        static const std::array points{casterPoints(build(Which::spot, 1)), casterPoints(build(Which::cubeOnPlane, 1)),
                                       casterPoints(build(Which::stillLife, 1))};
        return points[static_cast<std::size_t>(Which(which))];
    }

    LightView lightView() const {
        if (fit == Fit::fitted) {
            try {
                return fitLightView(light(), casters());
            } catch (const Error&) {
                throw Error("--light-y", "must keep the light clear of what casts, for a fitted frustum",
                            lightY.text());
            }
        }
        constexpr double near = 0.5, far = 10;
        const vec3 gaze = targetAt() - lightAt();
        const bool vertical = std::hypot(gaze.x, gaze.z) < 1e-9 * std::abs(gaze.y);
        LightView view{.viewFromWorld = lookAt(lightAt(), targetAt(), vertical ? vec3(0, 0, -1) : vec3(0, 1, 0))};
        if (rays == Rays::spot) {
            view.bounds = frustumBounds(fov, windowWidth / windowHeight, near, far);
            view.clipFromView = frustum(view.bounds);
        } else {
            const double x = windowWidth / 2, y = windowHeight / 2;
            view.bounds = {-x, x, -y, y, near, far};
            view.atInfinity = true;
            view.clipFromView = ortho(-x, x, -y, y, near, far);
        }
        return view;
    }

    void draw(const Frame& frame) override {
        if (built != std::pair(Which(which), frame.aspect())) {
            scene = build(which, frame.aspect());
            if (!built || built->first != which) meshes = uploadMeshes(scene);
            built = {which, frame.aspect()};
            viewAsBuilt = scene.viewFromWorld;
        }
        pose(scene, viewAsBuilt);
        const LightView view = lightView();
        frame.show("viewFromWorld", scene.viewFromWorld);
        frame.show("clipFromView", scene.clipFromView);
        frame.show("lightFromWorld", view.viewFromWorld);
        frame.show("mapFromWorld", view.mapFromWorld());

        glEnable(GL_DEPTH_TEST);
        glEnable(GL_CULL_FACE);

        // First pass: the map. It shows the scene from the light, and does not change while that rests.
        const int size = 64 << resolution;
        const Content content(view.clipFromWorld(), which, size, faces, receiver, slopeBias);
        if (!keep || drawn != content) {
            if (map.size() != size) map = DepthMap(size, "shadow map");
            drawMap(view.clipFromWorld());
            drawn = content;
            frame.bindTarget();
        }

        // Second pass: the picture, or what a study measures of it.
        drawScene(view, frame.measuring());
        frame.count("texels a lookup", looksAlong() * looksAlong() * (filter == Filter::none ? 1 : 4));
        if (frame.measuring()) return;
        if (frame.readouts()) {
            if (const auto wrong = shadowCheck.compare(scene, frame, [&] { drawScene(view, true); })) {
                falselyDark = wrong->dark;
                falselyLit = wrong->lit;
                asked = double(wrong->pixels);
            }
        }
        if (showFrustum) overlay.drawFrustum(scene.clipFromWorld(), view);
        if (showRays) drawRays(frame);
        if (showMap) overlay.drawMap(frame, map, view);
    }

    // Floors and walls lie across the y axis of their own space.
    void drawRays(const Frame& frame) {
        std::vector<vec4> planes;
        for (const SceneObject& object : scene.objects) {
            const vec3 normal(object.worldFromObject[1]), point(object.worldFromObject[3]);
            if (!object.casts) planes.emplace_back(normal, -glm::dot(normal, point));
        }
        drawing.begin(frame);
        for (const SceneObject& object : scene.objects) {
            if (object.casts)
                drawLightRays(drawing, scene.clipFromWorld(), light(), cornersOf(object.mesh, object.worldFromObject),
                              planes);
        }
        drawing.draw(frame);
    }

    void drawMap(const mat4& mapClipFromWorld) {
        map.bindForDrawing();
        glClear(GL_DEPTH_BUFFER_BIT);
        // Half of the faces would do: those towards the light, or those away from it
        if (faces == Faces::back) glCullFace(GL_FRONT);
        if (faces == Faces::both) glDisable(GL_CULL_FACE);
        // Push each triangle back by slopeBias times the depth it gains over a texel, and twice that in depth steps
        glEnable(GL_POLYGON_OFFSET_FILL);
        if (slopeBias > 0) glPolygonOffset(float(slopeBias), float(2 * slopeBias));
        depthProgram.use();
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            if (!receiver && !scene.objects[i].casts) continue;
            depthProgram.set("mapClipFromObject", mapClipFromWorld * scene.objects[i].worldFromObject);
            meshes[i].draw();
        }
        glDisable(GL_POLYGON_OFFSET_FILL);
        if (faces == Faces::back) glCullFace(GL_BACK);
        if (faces == Faces::both) glEnable(GL_CULL_FACE);
    }

    void drawScene(const LightView& view, bool measuring) {
        program.use();
        map.bind(1, filter == Filter::none ? DepthLookup::compareNearest : DepthLookup::compareLinear);
        program.set("map", 1);
        program.set("taps", looksAlong());
        program.set("bias", bias);
        program.set("light", light());
        program.set("measuring", measuring);
        program.set("eye", vec3(glm::inverse(scene.viewFromWorld)[3]));
        program.set("spotAxis", glm::normalize(targetAt() - lightAt()));
        // The cone's inner limit is 10 degrees within its outer one; without a cone all is beyond both
        const bool cone = rays == Rays::spot && fit == Fit::set;
        const double outer = fov / 2, inner = std::max(0.0, fov / 2 - 10);
        program.set("spotCosines", cone ? vec2(std::cos(radians(outer)), std::cos(radians(inner))) : vec2(-3, -2));
        program.set("checkered", which == Which::spot);
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            const SceneObject& object = scene.objects[i];
            program.set("clipFromObject", scene.clipFromWorld() * object.worldFromObject);
            program.set("mapFromObject", view.mapFromWorld() * object.worldFromObject);
            program.set("worldFromObject", object.worldFromObject);
            program.set("color", object.color);
            meshes[i].draw();
        }
    }

    Reference reference(const Frame& frame, const std::function<void(double)>& progress) const override {
        Scene posed = build(which, frame.aspect());
        pose(posed, posed.viewFromWorld);
        return litReference(posed, frame, {.pixelSide = 8}, progress);
    }

    int looksAlong() const { return filter <= Filter::hardware ? 1 : 2 * int(Filter(filter)) - 1; }
};

using Place = std::array<std::string, 3>;

// The settings of a study's scene: where its light is and looks to, with a map of 60 by 60 degrees.
std::vector<KnobSetting> lit(const std::string& scene, const Place& from, const Place& to) {
    return {{"scene", scene},      {"light-x", from[0]},  {"light-y", from[1]}, {"light-z", from[2]},
            {"target-x", to[0]},   {"target-y", to[1]},   {"target-z", to[2]},  {"fov", "60"},
            {"window-width", "1"}, {"window-height", "1"}};
}

// A line of the study: a map drawn again in every frame and pushed back by its slope alone, unless it says otherwise.
StudyLine line(const std::string& method, const std::string& filter, const std::string& slopeBias,
               const std::vector<KnobSetting>& settings = {}) {
    StudyLine line{method, {{"bias", "0"}, {"keep", "off"}, {"filter", filter}, {"slope-bias", slopeBias}}};
    line.settings.insert(line.settings.end(), settings.begin(), settings.end());
    line.knob = "resolution";
    line.values = {"256", "512", "1024", "2048", "4096"};
    return line;
}

const bool added = addDemo<ShadowMap>({
    .name = "shadow-map",
    .sentence = "Shadows by a second depth buffer, drawn as the light sees the scene.",
    .lookFor =
        "The steps at the shadow's edge are the texels of the map in the corner, as large as they fall on the floor.",
    .chapter = "Shadows",
    .number = 12,
    .width = 600,
    .height = 600,
    .background = vec4(0, 0, 0, 1),
    .needs = {.depth = true,
              .beyondEs = {{"float targets", "falsely-dark, falsely-lit and pixels-asked are not measured"}}},
    .study =
        Study{
            .quantity = "lit fraction of the pixels whose surface faces the light",
            .reference = "a ray in double precision from each pixel to the light; 64 for the root mean square",
            .scenes = {{"cube on plane", lit("cube-on-plane", {"-2.2", "3.6", "1.4"}, {"0", "0", "0"})},
                       {"still life", lit("still-life", {"-3.4", "4.2", "2.6"}, {"0.4", "0.5", "-0.8"})}},
            .lines = {line("1 tap", "none", "2"), line("hardware 2x2", "hardware", "2"), line("PCF 3x3", "pcf3", "4"),
                      line("PCF 5x5", "pcf5", "6"), line("1 tap, map kept", "none", "2", {{"keep", "on"}}),
                      line("1 tap, receiver left out", "none", "2", {{"receiver", "off"}}),
                      line("1 tap, back faces, receiver left out, no bias", "none", "0",
                           {{"receiver", "off"}, {"map-faces", "back"}}),
                      line("1 tap, frustum fitted", "none", "2", {{"frustum", "fitted"}})},
            .axis = ErrorAxis::fraction,
            .says = "What is misjudged lies within a texel of a shadow's edge, so it halves when the resolution "
                    "doubles, while beyond 1024 the time grows with the texels: fitting the frustum buys more than "
                    "refining the map, and keeping the map makes its resolution nearly free. Leaving the receiver out "
                    "costs no accuracy, and back faces without any bias are about as right as front faces with one.",
        },
});

}  // namespace

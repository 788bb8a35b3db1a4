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
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "mv/demo/demo.h"
#include "mv/demo/made_for.h"
#include "mv/geometry/light_view.h"
#include "mv/gl/depth_map.h"
#include "mv/gl/gl.h"
#include "mv/gl/scene_meshes.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/light_overlay.h"
#include "shared/light_rays.h"
#include "shared/scenes.h"
#include "shared/turntable.h"

using namespace mv;

namespace {

enum class Which { spot, cubeOnPlane, stillLife };
enum class Filter { none, hardware, pcf3, pcf5, pcf7 };
enum class Faces { front, back, both };
enum class Rays { spot, orthographic };
enum class Fit { set, fitted };

struct ShadowMap final : Demo {
    Choice<Which> which{
        this, "scene", Which::spot, {{"sphere-and-cube"}, {"cube-on-plane"}, {"still-life"}}, "what is shown"};
    NumberChoice resolution{
        this, "resolution", 512, {64, 128, 256, 512, 1024, 2048, 4096}, "texels along a side of the map"};
    Choice<Filter> filter{this,
                          "filter",
                          Filter::none,
                          {{"none", "one texel"},
                           {"hardware", "four, weighted"},
                           {"pcf3", "3 x 3 such looks"},
                           {"pcf5", "5 x 5"},
                           {"pcf7", "7 x 7"}},
                          "how the map is looked up"};
    Real bias{this,
              "bias",
              0.006,
              {1e-4, 0.2, Scale::logarithmic, true},
              "how much deeper than the map (0..1) is not yet shadow"};
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
    Real windowWidth{
        this, "window-width", 3, {0.1, 30, Scale::logarithmic}, "of parallel light; by the height, the spot's aspect"};
    Real windowHeight{this, "window-height", 2.4, {0.1, 30, Scale::logarithmic}, "of parallel light"};
    Toggle showMap{this, "show-map", true, "show the map in a corner, near is dark"};
    Toggle showRays{this, "rays", false, "show the light's rays through the corners of cube or box"};
    Toggle showFrustum{this, "show-frustum", true, "show the edges of what the map holds"};
    Turntable turntable{this, {-4, 40}};

    Program program, depthProgram;
    DepthMap map;
    MadeFor<mat4, Which, int, Faces, bool, double> mapFor;
    Scene now;
    LightView view;                                      // the light's own camera
    SceneMeshes meshes{SceneMeshes::Surface::textured};  // the floor has squares
    LightOverlay overlay;
    Drawing drawing;

    ShadowMap() {
        bindKeys(Key::left, Key::right, lightX, 0.1);
        bindKeys(Key::up, Key::down, lightZ, 0.1);
        bindHandle("light", {&lightX, &lightY, &lightZ},
                   [this](const FrameInfo& frame) { return placeOf(lightAt(), frame); });
        bindHandle("light's target", {&targetX, &targetY, &targetZ},
                   [this](const FrameInfo& frame) { return placeOf(targetAt(), frame); });
        const auto cone = [this] { return rays == Rays::spot && fit == Fit::set; };
        fov.onlyWhen(cone, "only a spot's cone that is set has an angle");
        windowWidth.onlyWhen([this] { return fit == Fit::set; }, "a fitted frustum has its own window");
        windowHeight.onlyWhen([this] { return fit == Fit::set; }, "a fitted frustum has its own window");
        for (Knob* knob : {&targetX, &targetY, &targetZ}) {
            knob->onlyWhen([this] { return rays != Rays::spot || fit == Fit::set; },
                           "a fitted frustum looks at what casts");
        }
    }

    void init() override {
        program = Program("shadow-map");
        depthProgram = Program("shadow-map", "depth");
        overlay.init();
    }

    void draw(const Frame& frame) override {
        now = seen(frame);
        view = lightView(now);
        meshes.follow(now);
        tell(frame);
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_CULL_FACE);

        // 1. The map: the depths of what the light sees first. It stays as it is while the light and what casts rest.
        const mat4 mapClipFromWorld = view.clipFromWorld();
        const int size = resolution;
        if (map.size() != size) map = DepthMap(size, "shadow map");
        if (mapFor.changed(mapClipFromWorld, which, size, faces, receiver, slopeBias) || !keep) {
            map.bindForDrawing();
            glClear(GL_DEPTH_BUFFER_BIT);
            // Half of the faces would do: those towards the light, or those away from it
            if (faces == Faces::back) glCullFace(GL_FRONT);
            if (faces == Faces::both) glDisable(GL_CULL_FACE);
            // Push each triangle back by slopeBias times the depth it gains over a texel, and twice that in depth steps
            glEnable(GL_POLYGON_OFFSET_FILL);
            if (slopeBias > 0) glPolygonOffset(float(slopeBias), float(2 * slopeBias));
            depthProgram.use();
            for (const auto& [object, mesh] : meshes.of(now)) {
                if (!receiver && !object.casts) continue;
                depthProgram.set("mapClipFromObject", mapClipFromWorld * object.worldFromObject);
                mesh.draw();
            }
            glDisable(GL_POLYGON_OFFSET_FILL);
            if (faces == Faces::back) glCullFace(GL_BACK);
            if (faces == Faces::both) glEnable(GL_CULL_FACE);
            frame.bindTarget();
        }

        // 2. The picture: what is deeper than the map says is in shadow
        program.use();
        map.bind(1, filter == Filter::none ? DepthLookup::compareNearest : DepthLookup::compareLinear);
        program.set("map", 1);
        program.set("taps", looksAlong());
        program.set("bias", bias);
        program.set("light", light());
        program.set("eye", vec3(glm::inverse(now.viewFromWorld)[3]));
        program.set("spotAxis", glm::normalize(targetAt() - lightAt()));
        program.set("spotCosines", spotCosines());
        program.set("checkered", which == Which::spot);
        for (const auto& [object, mesh] : meshes.of(now)) {
            program.set("clipFromObject", now.clipFromWorld() * object.worldFromObject);
            program.set("mapFromObject", view.mapFromWorld() * object.worldFromObject);
            program.set("worldFromObject", object.worldFromObject);
            program.set("color", object.color);
            mesh.draw();
        }
    }

    int looksAlong() const { return filter <= Filter::hardware ? 1 : 2 * int(Filter(filter)) - 1; }

    // The cone's outer limit, and its inner one 10 degrees within. Without a cone everything is inside both.
    vec2 spotCosines() const {
        if (rays != Rays::spot || fit != Fit::set) return {-3, -2};
        return {std::cos(radians(fov / 2)), std::cos(radians(std::max(0.0, fov / 2 - 10)))};
    }

    // ---- The light's own view

    vec3 lightAt() const { return {lightX, lightY, lightZ}; }
    vec3 targetAt() const { return {targetX, targetY, targetZ}; }
    vec4 light() const { return rays == Rays::spot ? vec4(lightAt(), 1) : vec4(lightAt() - targetAt(), 0); }

    LightView lightView(const Scene& scene) const { return fit == Fit::fitted ? fittedView(scene) : setView(); }

    LightView setView() const {
        constexpr double near = 0.5, far = 10;
        const vec3 gaze = targetAt() - lightAt();
        const bool vertical = std::hypot(gaze.x, gaze.z) < 1e-9 * std::abs(gaze.y);
        LightView set{.viewFromWorld = lookAt(lightAt(), targetAt(), vertical ? vec3(0, 0, -1) : vec3(0, 1, 0))};
        if (rays == Rays::spot) {
            set.bounds = frustumBounds(fov, windowWidth / windowHeight, near, far);
            set.clipFromView = frustum(set.bounds);
        } else {
            const double x = windowWidth / 2, y = windowHeight / 2;
            set.bounds = {-x, x, -y, y, near, far};
            set.atInfinity = true;
            set.clipFromView = ortho(-x, x, -y, y, near, far);
        }
        return set;
    }

    LightView fittedView(const Scene& scene) const {
        try {
            return fitLightView(light(), casterPoints(scene));
        } catch (const Error&) {
            throw Error("--light-y", "must keep the light clear of what casts, for a fitted frustum", lightY.text());
        }
    }

    // ---- What is shown

    void check() const override {
        if (lightAt() == targetAt()) throw Error("--light-x", "the light must not be at its target", lightX.text());
        if (fit == Fit::fitted) (void)fittedView(sceneIn(1));
    }

    Scene scene(const FrameInfo& frame) const override { return sceneIn(frame.aspect()); }

    // In a picture of this aspect, on which only the camera depends.
    Scene sceneIn(double aspect) const {
        Scene scene = which == Which::cubeOnPlane ? cubeOnPlane(aspect)
                      : which == Which::stillLife ? stillLife(aspect)
                                                  : sphereAndCube(aspect);
        scene.lights = {{.position = light()}};
        scene.viewFromWorld = turntable.seenBy(scene.viewFromWorld);
        return scene;
    }

    std::optional<vec2> placeOf(const vec3& point, const FrameInfo& frame) const {
        return pictureFromPane({0, 0, frame.width(), frame.height()}, scene(frame).clipFromWorld(), point);
    }

    void annotate(const Frame& frame) override {
        if (showFrustum) overlay.drawFrustum(now.clipFromWorld(), view);
        if (showRays) drawSceneRays(drawing, now, frame);
        if (showMap) overlay.drawMap(frame, map, view);
    }

    void tell(const Frame& frame) const {
        frame.show("viewFromWorld", now.viewFromWorld);
        frame.show("clipFromView", now.clipFromView);
        frame.show("lightFromWorld", view.viewFromWorld);
        frame.show("mapFromWorld", view.mapFromWorld());
        frame.count("texels a lookup", looksAlong() * looksAlong() * (filter == Filter::none ? 1 : 4));
    }
};

constexpr Declaration declaration{
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
    .presets =
        {
            {"original",
             "The steps at the shadow's edge are the texels of the map in the corner, as large as they fall on the "
             "floor."},
            {"acne",
             "Without a bias what is lit shades itself, in stripes.",
             {{"scene", "cube-on-plane"},
              {"resolution", "1024"},
              {"light-x", "-2.2"},
              {"light-y", "3.6"},
              {"light-z", "1.4"},
              {"target-x", "0"},
              {"target-y", "0"},
              {"target-z", "0"},
              {"fov", "90"},
              {"spin-y", "300"},
              {"bias", "0"}}},
            {"peter-panning",
             "Back faces in the map and too large a bias: the shadow begins a step away from the cube.",
             {{"scene", "cube-on-plane"},
              {"resolution", "1024"},
              {"light-x", "-2.2"},
              {"light-y", "3.6"},
              {"light-z", "1.4"},
              {"target-x", "0"},
              {"target-y", "0"},
              {"target-z", "0"},
              {"fov", "90"},
              {"spin-y", "300"},
              {"bias", "0.01"},
              {"map-faces", "back"}}},
            {"fitted",
             "The map holds just what casts, so that its texels are small; 3 x 3 looks make the edge a ramp.",
             {{"scene", "still-life"},
              {"resolution", "1024"},
              {"filter", "pcf3"},
              {"bias", "0"},
              {"slope-bias", "4"},
              {"frustum", "fitted"}}},
            {"sun",
             "Parallel light: the map holds a box, and only the backs of what casts.",
             {{"bias", "0"},
              {"map-faces", "back"},
              {"receiver", "off"},
              {"projection", "orthographic"},
              {"window-width", "9"},
              {"window-height", "9"}}},
        },
    .waste = {{"outside-view", "draw of 'light'", "the light's ball is drawn sooner than asked for"},
              {"no-sample", "draw of 'floor'",
               "the map's pass draws the whole scene, and culling leaves the floor out"},
              {"unused-object", "mesh 'light'", "made once, for the lights that have a place"}},
};

const bool added = addDemo<ShadowMap, declaration>();

}  // namespace

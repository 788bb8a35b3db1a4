// shadow-lights: one to eight lights that move, each with its own shadows, by maps or by volumes.
//
// Claims (each is a test in tests/claims/shadow-lights.cpp):
// - [right-by-rays] The mean over the lights of what they light is what rays show: by volumes away from edges in all pixels
//   but single ones that a light grazes, and by maps the better the larger they are.
// - [linear] Each further light costs the same passes and draws as the one before.
// - [out-of-reach] A light that cannot reach the picture costs nothing, and the picture is the same.
// - [sum-of-lights] Light is added and never taken away: each light adds to the picture without any.
// - [kept] Maps and volumes are kept while light and casters rest; where one moves, they are made anew.
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/made_for.h"
#include "mv/geometry/light_view.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/depth_map.h"
#include "mv/gl/gl.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/scene_meshes.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/caster_volumes.h"
#include "shared/lamp_reach.h"
#include "shared/light_scenes.h"
#include "shared/scenes.h"
#include "shared/turntable.h"
#include "shared/z_fail.h"

using namespace mv;

namespace {

enum class Which { lamps, circle, placed };
enum class Method { maps, volumes };

struct ShadowLights final : Demo {
    Choice<Which> which{this,
                        "scene",
                        Which::lamps,
                        {{"lamps"}, {"circle"}, {"placed", "as the circle, with the lights where --places says"}},
                        "what is shown"};
    Whole lights{this, "lights", 3, {1, 8}, "lights on the circle; the lamps always have three"};
    Points places{this,
                  "places",
                  {{-1.5, 0.8}, {0.6, -0.9}, {1.8, 0.9}},
                  {.low = vec2(-2, -1.2), .high = vec2(2.5, 1.5), .least = 1, .most = 8, .grid = 0.05},
                  "x and z of the lights of scene placed, dragged there"};
    Choice<Method> method{this, "method", Method::volumes, {{"maps"}, {"volumes"}}, "how shadows are found"};
    NumberChoice resolution{this, "resolution", 1024, {256, 512, 1024, 2048}, "texels along a side of each map"};
    Real reach{this, "reach", 20, {0.5, 20}, "distance at which a light ends"};
    Toggle keep{this, "keep", true, "keep maps and volumes while light and casters rest"};
    Turntable turntable{this, {-3, 10}};

    Readout drawn{this, "lights-drawn", "lights that can reach the picture"};
    Readout remade{this, "shadows-remade", "lights whose map or volumes were made anew for this frame"};

    Program program, plain;
    OnDemand<Mesh> bulb{positionsOnly(sphere(0.05, 16, 8)), "bulb"};
    Scene now;
    SceneMeshes meshes;
    struct Shadow {
        CasterVolumes volumes = {};
        DepthMap map = {};
        LightView view = {};
        MadeFor<int, mat4, std::vector<mat4>> mapFor = {};  // its size, the light's view, and where the casters stand
    };
    std::vector<Shadow> shadows;  // one a light
    DepthMap noMap;               // for the draws that ask none

    ShadowLights() {
        bindKeys(Key::left, Key::right, lights, 1);
        bindHandle("light", places, [this](const FrameInfo& frame, const vec2& place) -> std::optional<vec2> {
            if (which != Which::placed) return std::nullopt;
            return pictureFromPane({0, 0, frame.width(), frame.height()}, scene(frame).clipFromWorld(), over(place));
        });
        lights.onlyWhen([this] { return which == Which::circle; }, "only the circle has as many as one likes");
        places.onlyWhen([this] { return which == Which::placed; }, "only the lights of scene placed stand there");
        resolution.onlyWhen([this] { return method == Method::maps; }, "volumes have no texels");
    }

    void init() override {
        program = Program("shadow-lights");
        plain = Program("shadow-lights", "plain");
        noMap = DepthMap::empty();
    }

    void draw(const Frame& frame) override {
        now = seen(frame);
        frame.show("viewFromWorld", now.viewFromWorld);
        meshes.follow(now);
        shadows.resize(now.lights.size());
        const std::vector<std::size_t> reaching = lightsThatReach();
        int made = 0;

        // 1. The maps, each in a framebuffer of its own
        glEnable(GL_DEPTH_TEST);
        for (const std::size_t i : reaching) {
            if (method == Method::maps && drawMap(i)) ++made;
        }
        if (made > 0) frame.bindTarget();

        // 2. The picture without a light, which fills the depth buffer
        program.use();
        program.set("share", 1.0 / double(now.lights.size()));
        program.set("firstLight", now.lights[0].position);
        program.set("reach", reach);
        program.set("byMap", method == Method::maps);
        program.set("map", 0);
        program.set("ambientPass", true);
        noMap.bind(0, DepthLookup::compareNearest);
        drawObjects(mat4(1));

        // 3. What each light adds to it, where the map or the stencil buffer lets it through
        program.set("ambientPass", false);
        glDepthMask(GL_FALSE);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
        if (method == Method::volumes) glEnable(GL_STENCIL_TEST);
        for (const std::size_t i : reaching) {
            const SceneLight& light = now.lights[i];
            if (method == Method::volumes && countVolumes(i)) ++made;
            program.use();
            program.set("light", light.position);
            program.set("lightColor", light.color);
            if (method == Method::maps) program.set("shaded", light.aim.has_value());
            if (method == Method::maps) shadows[i].map.bind(0, DepthLookup::compareNearest);
            glDepthFunc(GL_EQUAL);
            drawObjects(method == Method::maps ? shadows[i].view.mapFromWorld() : mat4(1));
            glDepthFunc(GL_LESS);
            if (method == Method::volumes) glStencilFunc(GL_ALWAYS, 0, ~0U);
        }
        drawn = double(reaching.size());
        remade = made;
        frame.count("lights drawn", double(reaching.size()));
    }

    void drawObjects(const mat4& mapFromWorld) {
        for (const auto& [object, mesh] : meshes.of(now)) {
            program.set("clipFromObject", now.clipFromWorld() * object.worldFromObject);
            program.set("worldFromObject", object.worldFromObject);
            program.set("worldFromNormal", normalMatrix(object.worldFromObject));
            program.set("mapFromObject", mapFromWorld * object.worldFromObject);
            program.set("color", object.color);
            mesh.draw();
        }
    }

    // By z-fail, as in shadow-volume; the count begins anew with each light. True when volumes were made.
    bool countVolumes(std::size_t i) {
        CasterVolumes& volumes = shadows[i].volumes;
        if (!keep) volumes.forget();
        const bool made = volumes.follow(now, now.lights[i].position);
        glClear(GL_STENCIL_BUFFER_BIT);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        plain.use();
        countByZFail(volumes, now, plain);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glStencilFunc(GL_EQUAL, 0, ~0U);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
        return made;
    }

    // True when it was drawn, and not kept.
    bool drawMap(std::size_t i) {
        Shadow& shadow = shadows[i];
        shadow.view = viewOf(now.lights[i]);
        const int size = resolution;
        if (!shadow.mapFor.changed(size, shadow.view.clipFromWorld(), casterPlaces(now)) && keep) return false;
        if (shadow.map.size() != size) shadow.map = DepthMap(size, "map of light " + std::to_string(i));
        shadow.map.bindForDrawing();
        glClear(GL_DEPTH_BUFFER_BIT);
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(2, 4);
        plain.use();
        for (const auto& [object, mesh] : meshes.of(now)) {
            if (!object.casts) continue;
            plain.set("clipFromObject", shadow.view.clipFromWorld() * object.worldFromObject);
            mesh.draw();
        }
        glDisable(GL_POLYGON_OFFSET_FILL);
        return true;
    }

    // A lamp's map covers its shade's opening, that of another light what casts.
    LightView viewOf(const SceneLight& light) const {
        if (!light.aim) return fitLightView(light.position, casterPoints(now));
        const vec3 at(light.position);
        LightView view{.viewFromWorld = lookAtAnyRoll(at, at + *light.aim)};
        view.bounds = frustumBounds(116, 1, 0.02, 20);
        view.clipFromView = frustum(view.bounds);
        return view;
    }

    std::vector<std::size_t> lightsThatReach() const {
        std::vector<std::size_t> reaching;
        const mat4 clipFromWorld = withDepths(now.clipFromView, 0.5, 20) * now.viewFromWorld;
        for (std::size_t i = 0; i < now.lights.size(); ++i) {
            if (canReach(now, clipFromWorld, vec3(now.lights[i].position), reach)) reaching.push_back(i);
        }
        return reaching;
    }

    // A map holds what casts only where that is in front of its light.
    void check() const override {
        if (which != Which::placed || method != Method::maps) return;
        static const std::vector<vec3> casters = casterPoints(stillLife(1));
        for (const vec2& place : places.points()) {
            try {
                (void)fitLightView(vec4(over(place), 1), casters);
            } catch (const Error&) {
                throw Error("--places", "must keep each light beside what casts, for --method maps", places.text());
            }
        }
    }

    static vec3 over(const vec2& place) { return {place.x, 2, place.y}; }

    Scene shown(const FrameInfo& frame) const {
        if (which == Which::lamps) return lampsAndBall(frame.aspect(), frame.index());
        if (which == Which::circle) return circleOfLights(frame.aspect(), frame.index(), lights);
        std::vector<vec3> at;
        for (const vec2& place : places.points()) at.push_back(over(place));
        return lightsOverStillLife(frame.aspect(), at);
    }

    // Without a far plane, which would cut volumes off. Where a light grazes a surface, the side of a volume is hardly apart
    // from it, and the depth buffer tells them apart by steps that grow with 1/near: from where the camera stands, and from
    // farther back, nothing is nearer than 2.
    Scene scene(const FrameInfo& frame) const override {
        Scene scene = shown(frame);
        scene.viewFromWorld = turntable.seenBy(scene.viewFromWorld);
        const double near = turntable.distance < 0 ? 0.1 : 0.5;
        scene.clipFromView = withDepths(scene.clipFromView, near, HUGE_VAL);
        return scene;
    }

    // Where the lights are: no solids, so they cast nothing.
    void annotate(const Frame&) override {
        glDisable(GL_BLEND);
        glDepthMask(GL_TRUE);
        if (method == Method::volumes) glDisable(GL_STENCIL_TEST);
        plain.use();
        for (const SceneLight& light : now.lights) {
            const double most = std::max({light.color.x, light.color.y, light.color.z});
            plain.set("color", vec4(light.color / most, 1));
            plain.set("clipFromObject", now.clipFromWorld() * translate(vec3(light.position)));
            bulb->draw();
        }
    }
};

constexpr Literal inShadow = "what is wholly in one light's shadow is known when it is drawn";

constexpr Declaration declaration{
    .name = "shadow-lights",
    .sentence = "Several moving lights, each with its own shadows, by maps or by volumes.",
    .lookFor = "Where two shadows overlap it is darker than in either: a shadow is the lack of one light, not of all.",
    .chapter = "Shadows",
    .number = 14,
    .width = 640,
    .height = 480,
    .animated = true,
    .background = vec4(0.10, 0.11, 0.13, 1),
    .needs = {.depth = true, .stencil = true},
    .presets =
        {
            {"lamps", "The ball has three shadows, and none is black: in each the other lights shine."},
            {"circle",
             "Where all three hues shine it is white; each shadow has the colour that is left.",
             {{"scene", "circle"}}},
            {"eight",
             "Eight lights, eight shadows, at eight times the share of one.",
             {{"scene", "circle"}, {"lights", "8"}}},
            {"coarse-maps",
             "The eight by maps, coarse enough to see their texels.",
             {{"scene", "circle"}, {"lights", "8"}, {"method", "maps"}, {"resolution", "256"}}},
            {"short-reach",
             "Each light ends at 3: what none of them reaches costs no pass.",
             {{"scene", "circle"}, {"lights", "8"}, {"reach", "3"}}},
            {"placed",
             "Drag the lights: where two colours are both kept away, the third is left.",
             {{"scene", "placed"}}},
        },
    .waste = {{"no-sample", "draw of 'foot'", inShadow},
              {"no-sample", "draw of 'lower arm'", inShadow},
              {"no-sample", "draw of 'upper arm'", inShadow},
              {"no-sample", "draw of 'bulb'", "whether a shade hides it is known when it is drawn"},
              {"outside-view", "draw of 'bulb'", "a bulb of 224 triangles is drawn sooner than asked for"},
              {"unused-buffer", "stencil of 'shadow-lights'", "maps do without what volumes need"}},
};

const bool added = addDemo<ShadowLights, declaration>();

}  // namespace

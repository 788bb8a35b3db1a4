// soft-shadows: the shadow of a lamp that has a size: by many points, by a blur, and by a blur that asks how wide.
//
// Claims (each is a test in tests/claims/soft-shadows.cpp):
// - [penumbra-width] Dark to lit takes the lamp's size times the caster's height over the lamp's height above it.
// - [sharp-where-they-touch] The shadow of an upright edge is sharp at its foot and grows softer on the way out.
// - [points-converge] Summed in float, the error of N points falls with a slope of -0.5 to -1 in N.
// - [eight-bit-floor] Summed in 8 bits up to 256 points are as right as in float, and it ends there, at about 1e-3: a
//   share of 1/1024 is less than half a step, and is refused.
// - [pcf-does-not-converge] No kernel and no map brings a blur of fixed size below the error of 16 points.
// - [pcss-adapts] Lifting the caster widens the penumbra of pcss as it should, and hardly that of pcf.
// - [dark-once] Where the shadows of two casters overlap, a point of the lamp is taken away once.
#include <cmath>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/made_for.h"
#include "mv/geometry/lamp.h"
#include "mv/geometry/light_view.h"
#include "mv/gl/beyond_es.h"
#include "mv/gl/gl.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/scene_meshes.h"
#include "mv/math/shadow.h"
#include "mv/math/transform.h"
#include "shared/scenes.h"
#include "shared/spin.h"

using namespace mv;

namespace {

enum class Place { cube, table };
enum class Method { matrix, maps, pcf, pcss };
enum class Sum { floats, bytes };

constexpr vec4 floorPlane(0, 1, 0, 0);
constexpr vec3 down(0, -1, 0);  // where the lamp looks

struct SoftShadows final : Demo {
    Choice<Place> place{this, "scene", Place::cube, {{"cube"}, {"table"}}, "what stands under the lamp"};
    Choice<Method> method{this,
                          "method",
                          Method::matrix,
                          {{"matrix", "points of the lamp, each with a shadow matrix: shadows on the floor alone"},
                           {"maps", "points of the lamp, each with a shadow map"},
                           {"pcf", "one map, its answers averaged over a square of fixed size"},
                           {"pcss", "one map, averaged over a square as large as the casters found there ask for"}},
                          "how the shadow is made soft"};
    NumberChoice lights{this, "lights", 256, {1, 4, 16, 64, 256, 1024}, "points of the lamp"};
    Choice<Sum> sum{
        this, "accumulate", Sum::floats, {{"float"}, {"8-bit"}}, "what the points' shadows are added up in"};
    Whole taps{this, "taps", 9, {1, 31}, "pcf and pcss look at taps x taps places of the map"};
    NumberChoice resolution{this, "resolution", 1024, {256, 512, 1024, 2048}, "texels a side of a map"};
    Real lampSize{this, "lamp-size", 1, {0.05, 2}, "side of the square lamp"};
    Angle lampTurn{this, "lamp-turn", 0, "turn of the lamp about the vertical, from along the caster's sides"};
    Real casterHeight{this, "caster-height", 0.2, {0, 1}, "how far what casts is lifted from the floor"};
    Spin spin{this};

    Program shading, plain;
    OnDemand<Program> byMap{"soft-shadows", "map"}, byPcss{"soft-shadows", "pcss"};
    Scene now;
    SceneMeshes meshes;
    // How dark each pixel is: 0 sees the whole lamp, 1 none of it. A measured picture has another size.
    Target darknessShown, darknessMeasured;
    DepthMap map;
    LightView lightOfMap;
    MadeFor<Place, int, mat4, std::vector<mat4>> mapFor;

    SoftShadows() {
        bindWheel(casterHeight, 0.05);
        bindKeys(Key::left, Key::right, lampSize, 0.05);
        lights.onlyWhen([this] { return byPoints(); }, "this method has one map, from the lamp's middle");
        taps.onlyWhen([this] { return !byPoints(); }, "only pcf and pcss average looks at a map");
        resolution.onlyWhen([this] { return method != Method::matrix; }, "a shadow matrix has no texels");
    }

    void init() override {
        shading = Program("soft-shadows");
        plain = Program("soft-shadows", "plain");
    }

    void draw(const Frame& frame) override {
        now = seen(frame);
        frame.show("clipFromWorld", now.clipFromWorld());
        meshes.follow(now);
        const SceneLight& lamp = now.lights.front();
        const vec3 middle(lamp.position);
        const std::vector<vec3> points =
            byPoints() ? lampPoints(lamp, int(std::lround(std::sqrt(double(lights)))), 15) : std::vector{middle};
        const double share = 1.0 / double(points.size());
        frame.count("points", double(points.size()));

        // 1. Add up how dark each pixel is
        glEnable(GL_CULL_FACE);
        glEnable(GL_DEPTH_TEST);
        glBlendFunc(GL_ONE, GL_ONE);
        if (!byPoints()) keepMap(middle);
        const Target& darkness = begin(frame);
        switch (method) {
            case Method::matrix:
                addByMatrix(points);
                break;
            case Method::maps:
                for (const vec3& point : points) {
                    lightOfMap = viewFrom(point);
                    drawMap();
                    darkness.bind();
                    addByMap(point, share, 1);
                }
                mapFor.forget();
                break;
            case Method::pcf:
                addByMap(middle, 1, taps);
                break;
            case Method::pcss:
                addByPcss(lamp);
                break;
        }

        // 2. Shade what is seen by the part of the lamp that reaches it
        frame.bindTarget();
        darkness.bindColor(0);
        shading.use();
        shading.set("darkness", 0);
        shading.set("lamp", middle);
        for (const auto& [object, mesh] : meshes.of(now)) {
            shading.set("clipFromObject", now.clipFromWorld() * object.worldFromObject);
            shading.set("worldFromObject", object.worldFromObject);
            shading.set("worldFromNormal", normalMatrix(object.worldFromObject));
            shading.set("color", object.color);
            mesh.draw();
        }
    }

    // Nothing is dark yet; and what is seen has its depth, so that only that is darkened.
    const Target& begin(const Frame& frame) {
        Target& darkness = frame.measuring() ? darknessMeasured : darknessShown;
        const bool made = darkness.fit(frame.width(), frame.height(),
                                       {.depth = true,
                                        .stencil = method == Method::matrix,
                                        .color = inFloats() ? GLenum(GL_R32F) : GLenum(GL_R8),
                                        .texture = true},
                                       "darkness");
        if (!made) darkness.bind();
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        plain.use();
        for (const auto& [object, mesh] : meshes.of(now)) drawPlain(now.clipFromWorld(), object, mesh);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        return darkness;
    }

    void drawPlain(const mat4& clipFromWorld, const SceneObject& object, const Mesh& mesh) {
        plain.set("clipFromObject", clipFromWorld * object.worldFromObject);
        mesh.draw();
    }

    // A point's shadow is what casts, flattened onto the floor. Where two casters' shadows overlap it is dark once: the
    // floor's stencil counts down from 255, by one a point, and takes its darkness only where it is still higher.
    void addByMatrix(const std::vector<vec3>& points) {
        glEnable(GL_BLEND);
        glEnable(GL_STENCIL_TEST);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        glDepthMask(GL_FALSE);
        const auto objects = meshes.of(now);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto turn = static_cast<GLint>(i % 254);
            if (turn == 0) {  // the floor, where it is seen, begins at 255 again
                glDepthFunc(GL_EQUAL);
                glStencilFunc(GL_ALWAYS, 255, 255);
                plain.set("color", vec4(0));
                drawPlain(now.clipFromWorld(), objects.front().first, objects.front().second);
                glDepthFunc(GL_ALWAYS);
                plain.set("color", vec4(1.0 / double(points.size())));
            }
            glStencilFunc(GL_LESS, 254 - turn, 255);
            const mat4 clipFromShadow = now.clipFromWorld() * shadowProjection(vec4(points[i], 1), floorPlane);
            for (const auto& [object, mesh] : objects) {
                if (object.casts) drawPlain(clipFromShadow, object, mesh);
            }
        }
        glDepthMask(GL_TRUE);
        glDepthFunc(GL_LESS);
        glDisable(GL_STENCIL_TEST);
        glDisable(GL_BLEND);
    }

    LightView viewFrom(const vec3& point) const {
        return fitLightView(point, down, now.lights.front().halfV, casterPoints(now), 0.1);
    }

    // The map of what casts, as lightOfMap sees it.
    void drawMap() {
        if (map.size() != resolution) map = DepthMap(resolution, "map");
        map.bindForDrawing();
        glClear(GL_DEPTH_BUFFER_BIT);
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(2, 4);  // farther than it is by two texels of its slope, so that no surface shades itself
        plain.use();
        for (const auto& [object, mesh] : meshes.of(now)) {
            if (object.casts) drawPlain(lightOfMap.clipFromWorld(), object, mesh);
        }
        glDisable(GL_POLYGON_OFFSET_FILL);
    }

    // The same, unless the map that the last frame left is this one.
    void keepMap(const vec3& from) {
        lightOfMap = viewFrom(from);
        if (mapFor.changed(place, resolution, lightOfMap.clipFromWorld(), casterPlaces(now))) drawMap();
    }

    // Adds what the map drawn from `point` keeps dark: of the lamp's light this share, asking side x side texels.
    void addByMap(const vec3& point, double share, int side) {
        glEnable(GL_BLEND);
        glDepthFunc(GL_EQUAL);
        map.bind(0, DepthLookup::compareNearest);
        byMap->use();
        byMap->set("map", 0);
        byMap->set("share", share);
        byMap->set("side", side);
        byMap->set("light", point);
        for (const auto& [object, mesh] : meshes.of(now)) {
            byMap->set("worldFromObject", object.worldFromObject);
            drawOnMap(*byMap, object, mesh);
        }
        glDepthFunc(GL_LESS);
        glDisable(GL_BLEND);
    }

    void addByPcss(const SceneLight& lamp) {
        const mat4 mapFromWorld = lightOfMap.mapFromWorld();
        glDepthFunc(GL_EQUAL);
        map.bind(0, DepthLookup::depth);
        byPcss->use();
        byPcss->set("map", 0);
        byPcss->set("mapLamp", mapFromWorld * lamp.position);
        byPcss->set("mapHalfU", mapFromWorld * vec4(lamp.halfU, 0));
        byPcss->set("mapHalfV", mapFromWorld * vec4(lamp.halfV, 0));
        byPcss->set("near", lightOfMap.bounds.near);
        byPcss->set("far", lightOfMap.bounds.far);
        byPcss->set("side", int(taps));
        for (const auto& [object, mesh] : meshes.of(now)) drawOnMap(*byPcss, object, mesh);
        glDepthFunc(GL_LESS);
    }

    void drawOnMap(const Program& program, const SceneObject& object, const Mesh& mesh) {
        program.set("clipFromObject", now.clipFromWorld() * object.worldFromObject);
        program.set("mapFromObject", lightOfMap.mapFromWorld() * object.worldFromObject);
        mesh.draw();
    }

    bool byPoints() const { return method == Method::matrix || method == Method::maps; }

    bool inFloats() const {
        return sum == Sum::floats && has(beyond_es::floatTargets) && has(beyond_es::floatBlending);
    }

    void check() const override {
        // A light's view and a shadow's matrix need the whole lamp, at its largest, well above all that casts.
        if (place == Place::table && casterHeight > 0.65)
            throw Error("--caster-height", "must be at most 0.65 in scene table, to stay below the lamp",
                        casterHeight.text());
        if (byPoints() && lights > 256 && !inFloats())
            throw Error(
                "--lights",
                "must be at most 256 where shadows are added up in 8 bits, whose step is 1/255: a share of less "
                "than half a step rounds to nothing (--accumulate float has finer ones)",
                lights.text());
    }

    Scene scene(const FrameInfo& frame) const override {
        Scene scene = place == Place::cube ? cubeOnPlane(frame.aspect()) : table(frame.aspect());
        for (SceneObject& object : scene.objects) {
            if (object.casts) object.worldFromObject = translate(0, casterHeight, 0) * object.worldFromObject;
        }
        const SceneObject& caster = scene[place == Place::cube ? cubeOnThePlane : topOfTheTable];
        const mat4 worldFromLamp = caster.worldFromObject * rotateY(lampTurn) * scale(lampSize / 2);
        scene.lights.front().halfU = worldFromLamp * vec4(1, 0, 0, 0);
        scene.lights.front().halfV = worldFromLamp * vec4(0, 0, 1, 0);
        scene.viewFromWorld = scene.viewFromWorld * spin.turn();
        return scene;
    }
};

constexpr Declaration declaration{
    .name = "soft-shadows",
    .sentence =
        "The soft shadow of a lamp that has a size: by many points, by a blur, and by a blur that asks how wide.",
    .lookFor = "Where caster and floor touch the shadow is sharp, and it grows softer with the distance between them.",
    .chapter = "Shadows",
    .number = 15,
    .width = 640,
    .height = 480,
    .background = vec4(0.9, 0.9, 0.9, 1),
    .needs = {.depth = true,
              .beyondEs = {{"float targets", "--accumulate float is refused; 8-bit does, up to 256 points"},
                           {"float blending", "--accumulate float is refused; 8-bit does, up to 256 points"}}},
    .presets =
        {
            {"lifted",
             "The shadow is sharpest where the cube is nearest to the floor, and grows softer with the distance."},
            {"touching",
             "Where cube and floor touch the edge is sharp; 64 points of the lamp are nearly enough.",
             {{"lights", "64"}, {"caster-height", "0"}}},
            {"few-points",
             "Four points of the lamp: four hard shadows, one over the other.",
             {{"lights", "4"}, {"caster-height", "0.5"}}},
            {"blurred",
             "A blur of fixed size is as soft at the foot of a leg as at the far edge of the shadow.",
             {{"scene", "table"}, {"method", "pcf"}, {"lamp-size", "0.5"}, {"caster-height", "0"}}},
            {"blurred-as-wide-as-needed",
             "A blur that asks how wide: sharp at the feet of the legs, soft at the far edge.",
             {{"scene", "table"}, {"method", "pcss"}, {"taps", "15"}, {"lamp-size", "0.5"}, {"caster-height", "0"}}},
        },
    .waste = {{"repeated-pass", "pass into 'darkness'", "what a soft shadow costs in every frame is the lesson"},
              {"no-sample", "draw of 'leg 4'", "a leg that others hide from the lamp is known when it is drawn"}},
};

const bool added = addDemo<SoftShadows, declaration>();

}  // namespace

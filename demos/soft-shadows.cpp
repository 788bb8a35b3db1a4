// soft-shadows: the shadow of a lamp that has a size: by many points, by a blur, and by a blur that asks how wide.
//
// Claims (each is a test in tests/claims/soft-shadows.cpp):
// - [penumbra-width] Dark to lit takes the lamp's size times the caster's height over the lamp's height above it.
// - [sharp-where-they-touch] The shadow of an upright edge is sharp at its foot and grows softer on the way out.
// - [points-converge] Summed in float, the error of N points falls with a slope of -0.5 to -1 in N.
// - [eight-bit-floor] Summed in 8 bits it stays about 1e-3, and of 1024 points, each less than a step, nothing is left.
// - [pcf-does-not-converge] No kernel and no map brings a blur of fixed size below the error of 16 points.
// - [pcss-adapts] Lifting the caster widens the penumbra of pcss as it should, and hardly that of pcf.
// - [dark-once] Where the shadows of two casters overlap, a point of the lamp is taken away once.
#include <algorithm>
#include <array>
#include <functional>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "mv/demo/demo.h"
#include "mv/demo/lit_reference.h"
#include "mv/geometry/lamp.h"
#include "mv/geometry/light_view.h"
#include "mv/geometry/scenes.h"
#include "mv/gl/beyond_es.h"
#include "mv/gl/gl.h"
#include "mv/math/projection.h"
#include "mv/math/shadow.h"
#include "mv/math/transform.h"

using namespace mv;

namespace {

enum class Place { cube, table };
enum class Method { matrix, maps, pcf, pcss };
enum class Sum { floats, bytes };

constexpr vec4 floorPlane(0, 1, 0, 0);
constexpr vec3 down(0, -1, 0);  // where the lamp looks

// A picture to be filled with darkness: 0 sees the whole lamp, 1 none of it.
struct View {
    const Target& target;
    mat4 clipFromWorld;
    std::size_t objects;  // so many of the scene's are drawn; the first is the floor
};

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
    Choice<int> lights{this, "lights", 3, {{"1"}, {"4"}, {"16"}, {"64"}, {"256"}, {"1024"}}, "points of the lamp"};
    Choice<Sum> sum{
        this, "accumulate", Sum::floats, {{"float"}, {"8-bit"}}, "what the points' shadows are added up in"};
    Whole taps{this, "taps", 9, {1, 31}, "pcf and pcss look at taps x taps places of the map"};
    Choice<int> resolution{this, "resolution", 2, {{"256"}, {"512"}, {"1024"}, {"2048"}}, "texels a side of a map"};
    Real lampSize{this, "lamp-size", 1, {0.05, 2}, "side of the square lamp"};
    Angle lampTurn{this, "lamp-turn", 0, "turn of the lamp about the vertical, from along the caster's sides"};
    Real casterHeight{this, "caster-height", 0, {0, 1}, "how far what casts is lifted from the floor"};
    Angle spinX{this, "spin-x", 0, "turn about the x axis"};
    Angle spinY{this, "spin-y", 0, "turn about the y axis"};

    Readout width{this, "penumbra", "width of the penumbra of the caster's far upper edge on the floor, as drawn"};
    Readout theory{this, "penumbra-theory", "lamp-size * edge's height / (lamp's height - edge's height), unturned"};

    Program shading, plain, byMap, byPcss;  // the last two are made when first asked for
    Scene stock;
    std::pair<Place, double> stockedFor{};  // scene and aspect
    std::vector<Mesh> meshes;
    Target picture, line;
    DepthMap map;
    std::optional<std::array<double, 3>> mapKeptFor;
    LightView lightOfMap;

    SoftShadows() {
        bindDrag(spinY, 1, spinX, 1);
        bindWheel(casterHeight, 0.05);
        bindKeys(Key::left, Key::right, lampSize, 0.05);
    }

    void init() override {
        shading = Program("soft-shadows");
        plain = Program("soft-shadows", "plain");
    }

    void check() const override {
        // A light's view and a shadow's matrix need the whole lamp, at its largest, well above all that casts.
        if (place == Place::table && casterHeight > 0.65)
            throw Error("--caster-height", "must be at most 0.65 in scene table, to stay below the lamp",
                        casterHeight.text());
    }

    bool inFloats() const {
        return sum == Sum::floats && has(beyond_es::floatTargets) && has(beyond_es::floatBlending);
    }

    Scene sceneOf(double aspect) const { return place == Place::cube ? cubeOnPlane(aspect) : mv::table(aspect); }

    // The scene with lamp, casters and camera where the knobs have them.
    Scene arranged(Scene scene) const {
        for (SceneObject& object : scene.objects) {
            if (object.casts) object.worldFromObject = translate(0, casterHeight, 0) * object.worldFromObject;
        }
        const mat4 worldFromLamp = scene.objects[1].worldFromObject * rotateY(lampTurn) * scale(lampSize / 2);
        scene.lights.front().halfU = worldFromLamp * vec4(1, 0, 0, 0);
        scene.lights.front().halfV = worldFromLamp * vec4(0, 0, 1, 0);
        scene.viewFromWorld = scene.viewFromWorld * rotateX(spinX) * rotateY(spinY);
        return scene;
    }

    Reference reference(const Frame& frame, const std::function<void(double)>& progress) const override {
        return litReference(arranged(sceneOf(frame.aspect())), frame, {.lightSide = 32, .doubled = true}, progress);
    }

    void draw(const Frame& frame) override {
        prepare(frame);
        const Scene scene = arranged(stock);
        const Penumbra penumbra = farEdge(scene);
        std::vector<View> views{{picture, scene.clipFromWorld(), meshes.size()}};
        frame.show("clipFromWorld", scene.clipFromWorld());
        if (frame.readouts()) views.push_back({line, clipFromLine(penumbra), 1});

        const SceneLight& lamp = scene.lights.front();
        const vec3 middle(lamp.position);
        const std::vector<vec3> points = lampPoints(lamp, 1 << lights, 15);
        const double share = 1.0 / double(points.size());
        glEnable(GL_CULL_FACE);
        glEnable(GL_DEPTH_TEST);
        glBlendFunc(GL_ONE, GL_ONE);
        switch (method) {
            case Method::matrix:
                for (const View& view : views) {
                    begin(view, scene);
                    addByMatrix(view, scene, points);
                }
                break;
            case Method::maps:
                for (const View& view : views) begin(view, scene);
                setMap(share, 1);
                for (const vec3& point : points) {
                    drawMap(scene, point);
                    for (const View& view : views) {
                        view.target.bind();
                        addByMap(view, scene, point);
                    }
                }
                break;
            case Method::pcf:
                keepMap(scene, middle);
                setMap(1, taps);
                for (const View& view : views) {
                    begin(view, scene);
                    addByMap(view, scene, middle);
                }
                break;
            case Method::pcss:
                keepMap(scene, middle);
                for (const View& view : views) {
                    begin(view, scene);
                    addByPcss(view, scene);
                }
                break;
        }
        const bool byPoints = method == Method::matrix || method == Method::maps;
        frame.count("points", byPoints ? double(points.size()) : 1);
        if (byPoints && !inFloats() && share * 255 < 0.5) {
            frame.say("In 8 bits a point's share of the lamp rounds to 0: no shadow is left.");
        }
        if (frame.readouts()) measure(penumbra);
        shade(frame, scene);
    }

    // What the last frame made for another scene, size or kind of number is made anew.
    void prepare(const Frame& frame) {
        if (const std::pair now(Place(place), frame.aspect()); meshes.empty() || stockedFor != now) {
            stock = sceneOf(frame.aspect());
            meshes = uploadMeshes(stock);
            stockedFor = now;
            mapKeptFor.reset();
        }
        const Target::Buffers buffers{.depth = true,
                                      .stencil = method == Method::matrix,
                                      .color = inFloats() ? GLenum(GL_R32F) : GLenum(GL_R8),
                                      .texture = true};
        if (picture.fit(frame.width(), frame.height(), buffers, "darkness")) frame.bindTarget();
        if (frame.readouts() && line.fit(1024, 1, buffers, "darkness along a line")) frame.bindTarget();
        if (method != Method::matrix && map.size() != 256 << resolution) map = DepthMap(256 << resolution, "map");
    }

    // Nothing is dark yet; and what is seen has its depth, so that only that is darkened.
    void begin(const View& view, const Scene& scene) {
        view.target.bind();
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        plain.use();
        for (std::size_t i = 0; i < view.objects; ++i) drawPlain(view.clipFromWorld, scene, i);
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    }

    void drawPlain(const mat4& clipFromWorld, const Scene& scene, std::size_t i) {
        plain.set("clipFromObject", clipFromWorld * scene.objects[i].worldFromObject);
        meshes[i].draw();
    }

    // A point's shadow is what casts, flattened onto the floor. Where two casters' shadows overlap it is dark once: the
    // floor's stencil counts down from 255, by one a point, and takes its darkness only where it is still higher.
    void addByMatrix(const View& view, const Scene& scene, const std::vector<vec3>& points) {
        glEnable(GL_BLEND);
        glEnable(GL_STENCIL_TEST);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        glDepthMask(GL_FALSE);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto turn = static_cast<GLint>(i % 254);
            if (turn == 0) {  // the floor, where it is seen, begins at 255 again
                glDepthFunc(GL_EQUAL);
                glStencilFunc(GL_ALWAYS, 255, 255);
                plain.set("color", vec4(0));
                drawPlain(view.clipFromWorld, scene, 0);
                glDepthFunc(GL_ALWAYS);
                plain.set("color", vec4(1.0 / double(points.size())));
            }
            glStencilFunc(GL_LESS, 254 - turn, 255);
            const mat4 clipFromShadow = view.clipFromWorld * shadowProjection(vec4(points[i], 1), floorPlane);
            for (std::size_t k = 0; k < scene.objects.size(); ++k) {
                if (scene.objects[k].casts) drawPlain(clipFromShadow, scene, k);
            }
        }
        glDepthMask(GL_TRUE);
        glDepthFunc(GL_LESS);
        glDisable(GL_STENCIL_TEST);
        glDisable(GL_BLEND);
    }

    // Draws the map of what casts, as seen from a point of the lamp.
    void drawMap(const Scene& scene, const vec3& from) {
        mapKeptFor.reset();
        lightOfMap = fitLightView(from, down, scene.lights.front().halfV, casterPoints(scene), 0.1);
        map.bindForDrawing();
        glClear(GL_DEPTH_BUFFER_BIT);
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(2, 4);  // farther than it is by two texels of its slope, so that no surface shades itself
        plain.use();
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            if (scene.objects[i].casts) drawPlain(lightOfMap.clipFromWorld(), scene, i);
        }
        glDisable(GL_POLYGON_OFFSET_FILL);
    }

    // The same, unless the map that the last frame left is this one.
    void keepMap(const Scene& scene, const vec3& from) {
        const std::array<double, 3> now{double(resolution), lampTurn, casterHeight};
        if (mapKeptFor == now) return;
        drawMap(scene, from);
        mapKeptFor = now;
    }

    // The share of the lamp that each map stands for, and how many of its texels are asked: side x side.
    void setMap(double share, int side) {
        if (byMap.id() == 0) byMap = Program("soft-shadows", "map");
        byMap.use();
        byMap.set("map", 0);
        byMap.set("share", share);
        byMap.set("side", side);
    }

    // Adds what the map drawn from `point` keeps dark.
    void addByMap(const View& view, const Scene& scene, const vec3& point) {
        glEnable(GL_BLEND);
        glDepthFunc(GL_EQUAL);
        map.bind(0, DepthLookup::compareNearest);
        byMap.use();
        byMap.set("light", point);
        for (std::size_t i = 0; i < view.objects; ++i) {
            byMap.set("worldFromObject", scene.objects[i].worldFromObject);
            drawOnMap(byMap, view, scene, i);
        }
        glDepthFunc(GL_LESS);
        glDisable(GL_BLEND);
    }

    void addByPcss(const View& view, const Scene& scene) {
        const SceneLight& lamp = scene.lights.front();
        const mat4 mapFromWorld = lightOfMap.mapFromWorld();
        if (byPcss.id() == 0) byPcss = Program("soft-shadows", "pcss");
        glDepthFunc(GL_EQUAL);
        map.bind(0, DepthLookup::depth);
        byPcss.use();
        byPcss.set("map", 0);
        byPcss.set("mapLamp", mapFromWorld * lamp.position);
        byPcss.set("mapHalfU", mapFromWorld * vec4(lamp.halfU, 0));
        byPcss.set("mapHalfV", mapFromWorld * vec4(lamp.halfV, 0));
        byPcss.set("near", lightOfMap.bounds.near);
        byPcss.set("far", lightOfMap.bounds.far);
        byPcss.set("side", int(taps));
        for (std::size_t i = 0; i < view.objects; ++i) drawOnMap(byPcss, view, scene, i);
        glDepthFunc(GL_LESS);
    }

    void drawOnMap(const Program& program, const View& view, const Scene& scene, std::size_t i) {
        program.set("clipFromObject", view.clipFromWorld * scene.objects[i].worldFromObject);
        program.set("mapFromObject", lightOfMap.mapFromWorld() * scene.objects[i].worldFromObject);
        meshes[i].draw();
    }

    // Shades what is seen by the part of the lamp that reaches it.
    void shade(const Frame& frame, const Scene& scene) {
        frame.bindTarget();
        picture.bindColor(0);
        shading.use();
        shading.set("darkness", 0);
        shading.set("measuring", frame.measuring());
        shading.set("lamp", vec3(scene.lights.front().position));
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            const SceneObject& object = scene.objects[i];
            shading.set("clipFromObject", scene.clipFromWorld() * object.worldFromObject);
            shading.set("worldFromObject", object.worldFromObject);
            shading.set("worldFromNormal", normalMatrix(object.worldFromObject));
            shading.set("color", object.color);
            meshes[i].draw();
        }
    }

    // The penumbra of the caster's upper edge that is farthest from the lamp.
    Penumbra farEdge(const Scene& scene) const {
        const mat4& worldFromCaster = scene.objects[1].worldFromObject;
        const vec3 edge = place == Place::cube ? vec3(0.5, 1, 0) : vec3(0.75, 0.72, 0);
        return penumbraOf(scene.lights.front(), worldFromCaster * vec4(edge, 1), worldFromCaster * vec4(1, 0, 0, 0));
    }

    static double reach(const Penumbra& penumbra) { return penumbra.width + 0.25; }

    // Looks straight down at a line across it, dark end at the left.
    static mat4 clipFromLine(const Penumbra& penumbra) {
        const double half = reach(penumbra);
        return ortho(-half, half, -half / 1024, half / 1024, 0.5, 1.5) *
               lookAt(penumbra.middle - down, penumbra.middle, cross(penumbra.outwards, down));
    }

    void measure(const Penumbra& penumbra) {
        theory = penumbra.width;
        const std::vector<float> darkness = line.readRed();
        constexpr float wholly = 0.999F, hardly = 0.001F;
        if (darkness.front() < wholly || darkness.back() > hardly) return;  // another shadow, or none
        const auto lit = std::find_if(darkness.begin(), darkness.end(), [](float d) { return d <= hardly; });
        const auto soft = std::find_if(darkness.begin(), lit, [](float d) { return d < wholly; });
        width = double(lit - soft) * 2 * reach(penumbra) / double(darkness.size());
    }
};

const bool added = addDemo<SoftShadows>({
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
              .beyondEs = {{"float targets", "the points' shadows are added up in 8 bits, as with --accumulate 8-bit"},
                           {"float blending",
                            "the points' shadows are added up in 8 bits, as with --accumulate 8-bit"}}},
    .pose = {{"lights", "256"}, {"caster-height", "0.2"}},
    .waste = {{"repeated-pass", "pass into 'darkness'", "what a soft shadow costs in every frame is the lesson"},
              {"state-again", "glViewport", "the darkness is as large as the picture, and a target sets its own"}},
    .study =
        Study{
            .quantity = "part of the lamp that is seen from each pixel's surface, 0..1",
            .reference = "1024 rays a pixel, in double precision",
            // Turned, so that no row of the reference's points runs along an edge of the caster.
            .scenes = {{"cube", {{"lamp-turn", "30"}}},
                       {"table", {{"scene", "table"}, {"lamp-size", "0.5"}, {"lamp-turn", "30"}}}},
            .lines = {{"matrix, float", {{"method", "matrix"}}, "lights", {"1", "4", "16", "64", "256", "1024"}},
                      {"matrix, 8-bit",
                       {{"method", "matrix"}, {"accumulate", "8-bit"}},
                       "lights",
                       {"1", "4", "16", "64", "256", "1024"}},
                      {"maps", {{"method", "maps"}}, "lights", {"1", "4", "16", "64", "256"}},
                      {"pcf", {{"method", "pcf"}}, "taps", {"1", "3", "5", "7", "9", "15", "31"}},
                      {"pcss", {{"method", "pcss"}}, "taps", {"3", "5", "9", "15", "31"}}},
            .wrongBeyond = 0.05,  // a step that is seen, of shadow beside light
            .width = 320,
            .height = 240,
            .says = "On one plane nothing comes near points with a shadow matrix: 64 of them are wrong by 0.003, 1024 "
                    "by "
                    "0.0004, and each costs a caster's triangles; in 8 bits the sum ends at 0.001. A blur of fixed "
                    "size "
                    "is wrong by 0.05 with every kernel; pcss by 0.005 under a cube, but by 0.026 under a table, where "
                    "casters at several heights share a pyramid, and there only a map for each point goes further.",
        },
});

}  // namespace

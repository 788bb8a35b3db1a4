// soft-shadows: the shadow of a lamp that has a size: by many points, by a blur, and by a blur that knows how wide.
//
// Claims (each is a test in tests/claims/soft-shadows.cpp):
// - [penumbra-width] From dark to lit it is as wide as the lamp, times the caster's height over what is above it.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <utility>

#include "mv/demo/demo.h"
#include "mv/demo/lit_reference.h"
#include "mv/geometry/light_view.h"
#include "mv/geometry/scenes.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/gl.h"
#include "mv/math/projection.h"
#include "mv/math/sampling.h"
#include "mv/math/shadow.h"
#include "mv/math/transform.h"

using namespace mv;

namespace {

enum class Place { cube, table };
enum class Method { matrix, maps, pcf, pcss };
enum class Sum { floats, bytes };

const vec4 floorPlane(0, 1, 0, 0);
const vec3 down(0, -1, 0);  // where the lamp looks

// A picture to be filled with darkness, from 0 (sees the whole lamp) to 1.
struct View {
    const Target& target;
    mat4 clipFromWorld;
    std::size_t objects;  // the first so many of the scene's are drawn; the first is the floor
};

// A line across the floor where the edge of a shadow runs, from dark to lit.
struct Crossing {
    vec3 middle, outwards;
    double penumbra;  // how wide it should be
    double reach;     // the line's half length
};

struct SoftShadows final : Demo {
    Choice<Place> place{this, "scene", Place::cube, {{"cube"}, {"table"}}, "what stands under the lamp"};
    Choice<Method> method{this,
                          "method",
                          Method::matrix,
                          {{"matrix", "points of the lamp, each with a shadow matrix: shadows on the floor alone"},
                           {"maps", "points of the lamp, each with a shadow map"},
                           {"pcf", "one map, its answers averaged over a square of fixed size"},
                           {"pcss", "one map, averaged over as much of it as the casters found there ask for"}},
                          "how the shadow is made soft"};
    Choice<int> lights{this, "lights", 3, {{"1"}, {"4"}, {"16"}, {"64"}, {"256"}, {"1024"}}, "points of the lamp"};
    Choice<Sum> sum{
        this, "accumulate", Sum::floats, {{"float"}, {"8-bit"}}, "what the points' shadows are added up in"};
    Whole taps{this, "taps", 9, {1, 31}, "pcf and pcss look at taps x taps places of the map"};
    Choice<int> resolution{this, "resolution", 2, {{"256"}, {"512"}, {"1024"}, {"2048"}}, "texels a side of a map"};
    Real lampSize{this, "lamp-size", 1, {0.05, 2}, "side of the square lamp"};
    Angle lampTurn{this, "lamp-turn", 0, "turn of the lamp about the vertical, from the caster's own sides"};
    Real casterHeight{this, "caster-height", 0, {0, 1}, "how far what casts is lifted from the floor"};
    Angle spinX{this, "spin-x", 0, "turn about the x axis"};
    Angle spinY{this, "spin-y", 0, "turn about the y axis"};

    Readout width{this, "penumbra", "its width where an edge's shadow crosses the floor, in the picture"};
    Readout theory{this, "penumbra-theory", "lamp's extent * caster's height / (lamp's height - caster's height)"};

    Program shading, plain, byMap, byPcss;
    Scene stock;
    std::pair<Place, double> stockedFor{};  // scene and aspect
    std::vector<Mesh> meshes;
    Mesh lampMesh;
    Target picture, line;
    DepthMap map;
    std::array<double, 3> mapDrawnFor{};

    SoftShadows() {
        bindDrag(spinY, 1, spinX, 1);
        bindWheel(casterHeight, 0.05);
        bindKeys(Key::left, Key::right, lampSize, 0.05);
    }

    void init() override {
        shading = Program("soft-shadows");
        plain = Program("soft-shadows", "plain");
        byMap = Program("soft-shadows", "map");
        byPcss = Program("soft-shadows", "pcss");
        lampMesh = Mesh(square(), "lamp");
    }

    static Scene sceneOf(Place place, double aspect) {
        return place == Place::cube ? cubeOnPlane(aspect) : mv::table(aspect);
    }

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
        return litReference(arranged(sceneOf(place, frame.aspect())), frame, {.lightSide = 32, .doubled = true},
                            progress);
    }

    void draw(const Frame& frame) override {
        if (const std::pair now(Place(place), frame.aspect()); meshes.empty() || stockedFor != now) {
            stock = sceneOf(place, frame.aspect());
            meshes = uploadMeshes(stock);
            stockedFor = now;
        }
        makeTargets(frame);
        if (map.size() != 256 << resolution) map = DepthMap(256 << resolution, "map");
        const Scene scene = arranged(stock);
        const Crossing crossing = crossingOf(scene);
        std::vector<View> views{{picture, scene.clipFromWorld(), meshes.size()}};
        if (frame.readouts()) views.push_back({line, clipFromLine(crossing), 1});

        // Find what is seen; then only that is darkened, once for each point of the lamp
        glEnable(GL_CULL_FACE);
        for (const View& view : views) clearToDepths(view, scene);
        glBlendFunc(GL_ONE, GL_ONE);
        const std::vector<vec3> points = pointsOf(scene.lights.front()), casters = casterPoints(scene);
        const vec3 middle(scene.lights.front().position);
        switch (method) {
            case Method::matrix:
                for (const View& view : views) addByMatrix(view, scene, points);
                break;
            case Method::maps:
                for (const vec3& point : points) {
                    const LightView light = drawMap(point, scene, casters);
                    for (const View& view : views) addByMap(view, scene, light, point, 1.0 / double(points.size()));
                }
                break;
            case Method::pcf:
            case Method::pcss: {
                const LightView light = drawMap(middle, scene, casters);
                for (const View& view : views) {
                    if (method == Method::pcf) addByMap(view, scene, light, middle, 1);
                    if (method == Method::pcss) addByPcss(view, scene, light);
                }
                break;
            }
        }
        glDisable(GL_BLEND);
        glDepthMask(GL_TRUE);

        if (frame.readouts()) measure(crossing);
        shade(frame, scene);
    }

    // Targets of this size, with the numbers to add up in; made anew where the last frame's were others.
    void makeTargets(const Frame& frame) {
        const GLenum format = sum == Sum::floats ? GL_R32F : GL_R8;
        const Target::Buffers buffers{.depth = true, .stencil = true, .color = format, .texture = true};
        if (picture.buffers().color == format && picture.width() == frame.width() && picture.height() == frame.height())
            return;
        picture = Target(frame.width(), frame.height(), buffers, "darkness");
        line = Target(1024, 1, buffers, "darkness along a line");
    }

    void clearToDepths(const View& view, const Scene& scene) {
        view.target.bind();
        glClearColor(0, 0, 0, 0);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LESS);
        plain.use();
        plain.set("color", vec4(0));
        for (std::size_t i = 0; i < view.objects; ++i) drawPlain(view.clipFromWorld, scene, i);
    }

    void drawPlain(const mat4& clipFromWorld, const Scene& scene, std::size_t i) {
        plain.set("clipFromObject", clipFromWorld * scene.objects[i].worldFromObject);
        meshes[i].draw();
    }

    // The points of the lamp that stand for all of it: one in each of equal squares, the same in every picture.
    std::vector<vec3> pointsOf(const SceneLight& lamp) const {
        std::vector<vec3> points;
        for (const vec2& at : jitteredSquare(1 << lights, 15))
            points.push_back(vec3(lamp.position) + (2 * at.x - 1) * lamp.halfU + (2 * at.y - 1) * lamp.halfV);
        return points;
    }

    // Each point's shadow is what casts, flattened onto the floor. Where two casters' shadows overlap it is dark once:
    // the floor's stencil counts down from 255, one a point, and takes a point's darkness only while it is higher.
    void addByMatrix(const View& view, const Scene& scene, const std::vector<vec3>& points) {
        view.target.bind();
        plain.use();
        glEnable(GL_BLEND);
        glEnable(GL_STENCIL_TEST);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto turn = static_cast<GLint>(i % 254);
            if (turn == 0) {  // the floor, where it is seen, begins at 255 again
                glEnable(GL_DEPTH_TEST);
                glDepthFunc(GL_EQUAL);
                glStencilFunc(GL_ALWAYS, 255, 255);
                plain.set("color", vec4(0));
                drawPlain(view.clipFromWorld, scene, 0);
                glDisable(GL_DEPTH_TEST);
                plain.set("color", vec4(1.0 / double(points.size())));
            }
            glStencilFunc(GL_LESS, 254 - turn, 255);
            const mat4 flat = view.clipFromWorld * shadowProjection(vec4(points[i], 1), floorPlane);
            for (std::size_t k = 0; k < scene.objects.size(); ++k) {
                if (scene.objects[k].casts) drawPlain(flat, scene, k);
            }
        }
        glDisable(GL_STENCIL_TEST);
    }

    // Draws the map of what casts, as seen from a point of the lamp.
    LightView drawMap(const vec3& from, const Scene& scene, const std::vector<vec3>& casters) {
        const LightView light = fitLightView(from, down, scene.lights.front().halfV, casters, 0.1);
        map.bindForDrawing();
        glDisable(GL_BLEND);
        glDepthMask(GL_TRUE);
        glDepthFunc(GL_LESS);
        glClear(GL_DEPTH_BUFFER_BIT);
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(2, 4);  // farther than what is drawn, by two texels of its slope: no surface shades itself
        plain.use();
        plain.set("color", vec4(0));
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            if (scene.objects[i].casts) drawPlain(light.clipFromWorld(), scene, i);
        }
        glDisable(GL_POLYGON_OFFSET_FILL);
        return light;
    }

    // Adds what the map keeps dark, `share` of all there is.
    void addByMap(const View& view, const Scene& scene, const LightView& light, const vec3& from, double share) {
        view.target.bind();
        glEnable(GL_BLEND);
        glDepthMask(GL_FALSE);
        glDepthFunc(GL_EQUAL);
        map.bind(0, DepthLookup::compareNearest);
        byMap.use();
        byMap.set("map", 0);
        byMap.set("light", from);
        byMap.set("share", share);
        byMap.set("side", method == Method::pcf ? int(taps) : 1);
        for (std::size_t i = 0; i < view.objects; ++i) {
            byMap.set("worldFromObject", scene.objects[i].worldFromObject);
            drawOnMap(byMap, view, scene, light, i);
        }
    }

    void addByPcss(const View& view, const Scene& scene, const LightView& light) {
        const SceneLight& lamp = scene.lights.front();
        view.target.bind();
        glDepthMask(GL_FALSE);
        glDepthFunc(GL_EQUAL);
        map.bind(0, DepthLookup::depth);
        byPcss.use();
        byPcss.set("map", 0);
        byPcss.set("mapLamp", light.mapFromWorld() * lamp.position);
        byPcss.set("mapHalfU", light.mapFromWorld() * vec4(lamp.halfU, 0));
        byPcss.set("mapHalfV", light.mapFromWorld() * vec4(lamp.halfV, 0));
        byPcss.set("near", light.bounds.near);
        byPcss.set("far", light.bounds.far);
        byPcss.set("side", int(taps));
        for (std::size_t i = 0; i < view.objects; ++i) drawOnMap(byPcss, view, scene, light, i);
    }

    void drawOnMap(const Program& program, const View& view, const Scene& scene, const LightView& light,
                   std::size_t i) {
        program.set("clipFromObject", view.clipFromWorld * scene.objects[i].worldFromObject);
        program.set("mapFromObject", light.mapFromWorld() * scene.objects[i].worldFromObject);
        meshes[i].draw();
    }

    // Where the shadow of an upper edge, opposite the lamp, crosses the floor; by similar triangles on both sides of it.
    Crossing crossingOf(const Scene& scene) const {
        const mat4& worldFromCaster = scene.objects[1].worldFromObject;
        const vec3 edge(worldFromCaster * (place == Place::cube ? vec4(0.5, 1, 0, 1) : vec4(0.75, 0.72, 0, 1)));
        const vec3 outwards(worldFromCaster * vec4(1, 0, 0, 0));
        const SceneLight& lamp = scene.lights.front();
        const double ratio = edge.y / (lamp.position.y - edge.y);
        const double extent = 2 * (std::abs(dot(outwards, lamp.halfU)) + std::abs(dot(outwards, lamp.halfV)));
        return {edge + ratio * (edge - vec3(lamp.position)), outwards, extent * ratio, extent * ratio + 0.25};
    }

    // From above, along the crossing: its dark end at the left.
    static mat4 clipFromLine(const Crossing& crossing) {
        const double half = crossing.reach;
        return ortho(-half, half, -half / 1024, half / 1024, 0.5, 1.5) *
               lookAt(crossing.middle - down, crossing.middle, cross(crossing.outwards, down));
    }

    void measure(const Crossing& crossing) {
        theory = crossing.penumbra;
        const std::vector<float> darkness = line.readRed();
        const auto at = [&](float d) {
            return std::lower_bound(darkness.begin(), darkness.end(), d, std::greater<>());
        };
        const auto dark = at(0.999F), lit = at(0.001F);
        if (darkness.front() > 0.999F && darkness.back() < 0.001F)
            width = double(lit - dark) * 2 * crossing.reach / double(darkness.size());
    }

    // Shades what is seen by the part of the lamp that reaches it.
    void shade(const Frame& frame, const Scene& scene) {
        const float empty = frame.measuring() ? -1.0F : 0.9F;
        frame.bindTarget();
        glClearColor(empty, empty, empty, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glDepthFunc(GL_LESS);
        glEnable(GL_DEPTH_TEST);
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
    .needs = {.depth = true, .beyondEs = "float"},
    .study = Study{.quantity = "q",
                   .reference = "r",
                   .scenes = {{"cube", {{"lamp-turn","30"}}}, {"table", {{"scene", "table"}, {"lamp-size", "0.5"}, {"lamp-turn", "30"}}}},
                   .lines = {{"matrix, float", {{"method", "matrix"}}, "lights", {"1", "4", "16", "64", "256", "1024"}},
                             {"matrix, 8-bit",
                              {{"method", "matrix"}, {"accumulate", "8-bit"}},
                              "lights",
                              {"1", "4", "16", "64", "256", "1024"}},
                             {"maps", {{"method", "maps"}}, "lights", {"1", "4", "16", "64", "256"}},
                             {"pcf", {{"method", "pcf"}}, "taps", {"1", "3", "5", "7", "9", "15", "25", "31"}},
                             {"pcss", {{"method", "pcss"}}, "taps", {"2", "4", "8", "16", "31"}}},
                   .wrongBeyond = 0.05,
                   .width = 320,
                   .height = 240},
});

}  // namespace

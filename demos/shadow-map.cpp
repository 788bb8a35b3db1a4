// shadow-map: depths as the light sees them, and what is farther than those is in shadow.
//
// Claims (each is a test in tests/claims/shadow-map.cpp):
// - [cast-by-rays] The shadows are those that rays find, up to a few texels of the map at their edges.
// - [error-is-one-over-resolution] Without a filter the misjudged part of the picture falls as 1/resolution.
// - [acne-without-bias] With no bias at all a lit floor in the map shades itself in stripes; slope-bias 1 ends that.
// - [light-leaks-with-bias] A large bias moves the shadow away from the foot of what casts it.
// - [floor-left-out-needs-no-bias] Where the floor is not in the map, nothing can shade it falsely: no bias is needed.
// - [back-faces-need-no-bias-in-the-light] With back faces in the map, what faces the light has no acne.
// - [map-is-kept] While the light and what casts rest, the map is not drawn again, and the picture is the same.
// - [frustum-holds-the-map] The white lines are the edges of what the map holds; fitted, they are tight round what casts.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <utility>

#include "mv/demo/demo.h"
#include "mv/demo/lit_reference.h"
#include "mv/geometry/light_view.h"
#include "mv/geometry/scenes.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/depth_map.h"
#include "mv/gl/gl.h"
#include "mv/gl/light_overlay.h"
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

// The original's sphere, cube and floor.
Scene sphereAndCube(double aspect) {
    Scene scene;
    mat4 untouchedView{1};
    scene.objects = {{"floor", grid(1, 1, 20, 20), mat4(1), {0.5, 0.5, 1}, false, true},
                     {"sphere", sphere(1, 32, 24), translate(2, 3, 4), {1, 0.5, 0.5}, true, true},
                     {"cube", box({-1, -1, -1}, {1, 1, 1}), translate(3, 1, 0), {0.5, 1, 0.5}, true, true}};
    scene.viewFromWorld = lookAt({6, 5, 7}, {0, 0, 0}, {0, 1, 0});
    scene.clipFromView = perspective(60, aspect, 1, 2000);
    return scene;
}

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
                           {"hardware", "four texels, weighted"},
                           {"pcf3", "3 x 3 looks of hardware"},
                           {"pcf5", "5 x 5"},
                           {"pcf7", "7 x 7"}},
                          "how the map is looked up"};
    Real bias{
        this, "bias", 0.006, {0, 0.2}, "how much farther than the map's depth is not yet in shadow, in depths 0..1"};
    Real slopeBias{
        this, "slope-bias", 0, {0, 16}, "how far the map is pushed back where it is steep, in texels of its slope"};
    Choice<Faces> faces{this,
                        "map-faces",
                        Faces::front,
                        {{"front"}, {"back"}, {"both"}},
                        "faces drawn into the map, as seen from the light"};
    Toggle receiver{this, "receiver", true, "draw floor and walls into the map, too, though they shade nothing"};
    Toggle keep{this, "keep", true, "keep the map while light and casters rest"};
    Choice<Rays> rays{this,
                      "projection",
                      Rays::spot,
                      {{"spot", "from a point, in a cone"}, {"orthographic", "parallel, along the light's gaze"}},
                      "how the light shines"};
    Choice<Fit> fit{this,
                    "frustum",
                    Fit::set,
                    {{"set", "by fov and window"}, {"fitted", "tight round what casts; a spot light then has no cone"}},
                    "what the map holds"};
    Real lightX{this, "light-x", 2.5, {-10, 10}, "x of the light"};
    Real lightY{this, "light-y", 4.8, {1, 20}, "y of the light"};
    Real lightZ{this, "light-z", 4.3, {-10, 20}, "z of the light"};
    Real targetX{this, "target-x", 2.5, {-10, 10}, "x of the point that the light looks at"};
    Real targetY{this, "target-y", 1, {0, 20}, "y of it"};
    Real targetZ{this, "target-z", 3.5, {-10, 20}, "z of it"};
    Real fov{this, "fov", 120, {1, 179}, "height of a spot light's cone", "deg"};
    Real windowWidth{
        this, "window-width", 3, {0.1, 30}, "width of a parallel light's map; over the height, the aspect of a spot's"};
    Real windowHeight{this, "window-height", 2.4, {0.1, 30}, "height of it"};
    Toggle showMap{this, "show-map", true, "show the map in a corner: near is dark"};
    Toggle showFrustum{this, "show-frustum", true, "show what the map holds as white lines"};
    Angle spinX{this, "spin-x", 0, "turn about the x axis"};
    Angle spinY{this, "spin-y", 0, "turn about the y axis"};
    Real distance{this, "distance", 0, {-4, 40}, "step back"};

    Readout falselyDark{this, "falsely-dark", "part of the pixels that are dark though the light reaches them (acne)",
                        "%"};
    Readout falselyLit{this, "falsely-lit", "part of the pixels that are lit though they are in shadow", "%"};
    Readout pixelsAsked{this, "pixels-asked", "how many pixels were compared with rays for these two"};

    Program program, depthProgram;
    DepthMap map;
    LightOverlay overlay;
    ShadowCheck shadowCheck;
    Scene scene;
    mat4 untouchedView{1};
    std::vector<Mesh> meshes;
    std::optional<std::pair<Which, double>> built;  // the scene, and its aspect

    // What the map depends on: it is drawn again when one of these has changed.
    struct Content {
        mat4 clipFromWorld{1};
        Which which = Which::spot;
        int size = 0;
        Faces faces = Faces::front;
        bool receiver = true;
        double slopeBias = 0;
        bool operator==(const Content&) const = default;
    };
    std::optional<Content> drawn;

    ShadowMap() {
        bindDrag(spinY, 1, spinX, 1);
        bindWheel(distance, -0.25);
        bindKeys(Key::left, Key::right, lightX, 0.1);
        bindKeys(Key::up, Key::down, lightZ, 0.1);
    }

    void init() override {
        program = Program("shadow-map");
        depthProgram = Program("shadow-map", "depth");
        overlay.init();
        built.reset();
        drawn.reset();
    }

    void check() const override {
        if (lightAt() == targetAt()) throw Error("--light-x", "the light must not be at its target", lightX.text());
    }

    vec3 lightAt() const { return {lightX, lightY, lightZ}; }
    vec3 targetAt() const { return {targetX, targetY, targetZ}; }
    vec4 light() const { return rays == Rays::spot ? vec4(lightAt(), 1) : vec4(lightAt() - targetAt(), 0); }

    mat4 turned(const mat4& viewFromWorld) const {
        return translate(0, 0, -distance) * viewFromWorld * rotateX(spinX) * rotateY(spinY);
    }

    LightView lightView() const {
        if (fit == Fit::fitted) {
            try {
                return fitLightView(light(), casterPoints(scene));
            } catch (const Error&) {
                throw Error("--light-y", "a fitted frustum needs the light clear of what casts", lightY.text());
            }
        }
        constexpr double near = 0.5, far = 10;
        const bool vertical = lightX == targetX && lightZ == targetZ;
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
            untouchedView = scene.viewFromWorld;
        }
        scene.viewFromWorld = turned(untouchedView);
        scene.lights = {{.position = light()}};
        const LightView view = lightView();
        frame.show("viewFromWorld", scene.viewFromWorld);
        frame.show("lightFromWorld", view.viewFromWorld);
        frame.show("mapFromWorld", view.mapFromWorld());

        // First pass: the map. It shows the scene from the light, and does not change while that rests.
        const Content wanted{view.clipFromWorld(), which, 64 << resolution, faces, receiver, slopeBias};
        if (!keep || drawn != wanted) {
            drawMap(wanted);
            drawn = wanted;
            frame.bindTarget();
        }

        // Second pass: the picture, or what a study measures of it.
        drawScene(view, frame.measuring());
        frame.count("texels a lookup", looksAlong() * looksAlong() * (filter == Filter::none ? 1 : 4));
        if (frame.measuring()) return;
        if (showFrustum) overlay.drawFrustum(scene.clipFromWorld(), view);
        if (showMap) overlay.drawMap(frame, map, view);
        if (!frame.readouts()) return;
        const FalseShadows wrong = shadowCheck.compare(scene, frame, [&] { drawScene(view, true); });
        falselyDark = wrong.dark;
        falselyLit = wrong.lit;
        pixelsAsked = double(wrong.pixels);
    }

    void drawMap(const Content& content) {
        if (map.size() != content.size) map = DepthMap(content.size, "shadow map");
        map.bindForDrawing();
        glClear(GL_DEPTH_BUFFER_BIT);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LESS);
        // Half of the faces would do: those towards the light, or those away from it
        if (faces != Faces::both) glEnable(GL_CULL_FACE);
        glCullFace(faces == Faces::front ? GL_BACK : GL_FRONT);
        // Push each triangle back by slopeBias times the depth it gains over a texel, and twice that in depth steps
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(float(slopeBias), float(2 * slopeBias));
        depthProgram.use();
        for (std::size_t i = 0; i < meshes.size(); ++i) {
            if (!receiver && !scene.objects[i].casts) continue;
            depthProgram.set("mapClipFromObject", content.clipFromWorld * scene.objects[i].worldFromObject);
            meshes[i].draw();
        }
        glDisable(GL_POLYGON_OFFSET_FILL);
        glDisable(GL_CULL_FACE);
    }

    void drawScene(const LightView& view, bool measuring) {
        if (measuring)
            glClearColor(-1, -1, -1, -1);
        else
            glClearColor(0, 0, 0, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LESS);
        program.use();
        map.bind(0, filter == Filter::none ? DepthLookup::compareNearest : DepthLookup::compareLinear);
        program.set("map", 0);
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
            program.set("worldFromNormal", normalMatrix(object.worldFromObject));
            program.set("color", object.color);
            meshes[i].draw();
        }
    }

    Reference reference(const Frame& frame, const std::function<void(double)>& progress) const override {
        Scene asked = build(which, frame.aspect());
        asked.viewFromWorld = turned(asked.viewFromWorld);
        asked.lights = {{.position = light()}};
        return litReference(asked, frame, {.pixelSide = 8}, progress);
    }

    int looksAlong() const { return filter <= Filter::hardware ? 1 : 2 * int(Filter(filter)) - 1; }
};

const bool added = addDemo<ShadowMap>({
    .name = "shadow-map",
    .sentence = "Shadows by a second depth buffer, drawn as the light sees the scene.",
    .lookFor =
        "The steps at the shadow's edge are the texels of the map in the corner, as large as they fall on the floor.",
    .chapter = "Shadows",
    .number = 12,
    .width = 600,
    .height = 600,
    .needs = {.depth = true},
});

}  // namespace

// shadow-lights: one to eight lights that move, each with its own shadows, by maps or by volumes.
//
// Claims (each is a test in tests/claims/shadow-lights.cpp):
// - [right-by-rays] The mean over the lights of what they light is what rays show: exactly by volumes, and by maps the
//   better the larger they are.
// - [linear] Each further light costs the same passes and draws as the one before.
// - [out-of-reach] A light that cannot reach the picture costs nothing, and the picture is the same.
// - [sum-of-lights] Light is added and never taken away: each light adds to the picture without any.
// - [kept] Maps and volumes are kept while light and casters rest; where one moves, they are made anew.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/lit_reference.h"
#include "mv/demo/turntable.h"
#include "mv/geometry/bounds.h"
#include "mv/geometry/light_view.h"
#include "mv/geometry/scenes.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/caster_volumes.h"
#include "mv/gl/depth_map.h"
#include "mv/gl/gl.h"
#include "mv/gl/scene_meshes.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

using namespace mv;

namespace {

enum class Which { lamps, circle, placed };
enum class Method { maps, volumes };

// A light beyond its homogeneous position, which is in Scene::lights.
struct Lamp {
    std::optional<vec3> aim = {};  // the way a lamp with a shade looks, unit length
};

struct LitScene {
    Scene scene;
    std::vector<Lamp> lamps;  // one for each of the scene's lights
};

// The matrix that lays the box -0.5..0.5 between two points, `thickness` across.
mat4 between(const vec3& from, const vec3& to, double thickness) {
    const vec3 y = to - from, x = glm::normalize(glm::cross(y, vec3(0.1, 0.2, 1))),
               z = glm::normalize(glm::cross(x, y));
    return {vec4(thickness * x, 0), vec4(y, 0), vec4(thickness * z, 0), vec4((from + to) / 2.0, 1)};
}

// A reading lamp: a foot, two arms of equal length, and a shade with a light in it, at `head`, that looks at `target`.
void addLamp(LitScene& lit, const vec3& foot, const vec3& head, const vec3& target, double size, const vec3& color,
             const vec3& lightColor) {
    const std::vector<vec2> shade{{0, 0}, {0.09, 0}, {0.12, 0.08}, {0.27, 0.34}, {0.25, 0.34}, {0.10, 0.09}, {0, 0.05}};
    const std::vector<vec2> disc{{0, 0}, {0.3, 0}, {0.3, 0.03}, {0.05, 0.06}, {0, 0.06}};
    const vec3 aim = glm::normalize(target - head), shoulder = foot + vec3(0, 0.06 * size, 0);
    const vec3 along = head - shoulder, middle = (shoulder + head) / 2.0;
    const vec3 sideways = glm::normalize(glm::cross(glm::cross(along, vec3(0, 1, 0)), along));
    const double arm = 0.85 * size;
    const vec3 elbow = middle + std::sqrt(std::max(arm * arm - glm::dot(along, along) / 4, 0.0)) * sideways;
    const vec3 x = glm::normalize(glm::cross(aim, vec3(0.1, 0.2, 1)));
    const mat4 worldFromShade(vec4(size * x, 0), vec4(size * aim, 0), vec4(size * glm::cross(x, aim), 0),
                              vec4(head, 1));
    auto& objects = lit.scene.objects;
    objects.push_back({"foot", lathe(disc, 48), translate(foot) * rotateY(20) * scale(size), 0.7 * color});
    objects.push_back({"lower arm", box(vec3(-0.5), vec3(0.5)), between(shoulder, elbow, 0.05 * size), 0.8 * color});
    objects.push_back({"upper arm", box(vec3(-0.5), vec3(0.5)), between(elbow, head, 0.05 * size), 0.9 * color});
    objects.push_back({"shade", lathe(shade, 48), worldFromShade, color});
    lit.scene.lights.push_back({.position = vec4(head + 0.13 * size * aim, 1), .color = lightColor});
    lit.lamps.push_back({.aim = aim});
}

// Two lamps and a ball under a third light, which rests. The lamps look about after `index` frames.
LitScene lampsScene(double aspect, int index) {
    LitScene lit;
    Scene& scene = lit.scene;
    scene = cubeOnPlane(aspect);
    scene.objects.pop_back();
    scene.viewFromWorld = lookAt({0.3, 2.6, 4.3}, {0.25, 0.5, 0}, {0, 1, 0});
    scene.objects[0].color = vec3(0.75, 0.62, 0.48);
    scene.lights = {{.position = vec4(0.5, 6, 3, 1), .color = vec3(0.35, 0.38, 0.45)}};
    lit.lamps = {{}};
    const double t = radians(2.0 * index);
    const vec3 ball(0.35 + 0.35 * std::sin(t), 0.22, 0.7);
    addLamp(lit, {-1.1, 0, -0.4}, {-0.55, 1.35 + 0.06 * std::cos(t), 0.1}, ball, 1, {0.80, 0.82, 0.85},
            {0.55, 0.50, 0.40});
    addLamp(lit, {1.6, 0, 0.3}, {1.15, 0.75 + 0.05 * std::sin(2 * t), 0.5}, ball, 0.55, {0.85, 0.70, 0.66},
            {0.52, 0.50, 0.45});
    scene.objects.push_back(
        {"ball", sphere(0.22, 64, 32), translate(ball) * rotateZ(-degrees(ball.x / 0.22)), {0.90, 0.75, 0.20}});
    return lit;
}

constexpr double circleY = 3.8, placedY = 2;  // of the lights over the still life

// Where light i of the circle is after `index` frames: x and z.
vec2 onCircle(int i, int count, int index) {
    const double turn = double(i) / count, angle = 2 * pi * turn + radians(1.0 * index) + 2.4;
    return {0.3 + 3.4 * std::cos(angle), 2.6 + 2.6 * std::sin(angle)};
}

// Lights of all hues over the still life, at these x and z and that y. The colours of two or more add up to white.
LitScene lightsScene(double aspect, const std::vector<vec2>& places, double y) {
    LitScene lit{stillLife(aspect), {}};
    lit.scene.lights.clear();
    const int count = int(places.size());
    for (int i = 0; i < count; ++i) {
        const double turn = double(i) / count;
        const vec2& place = places[std::size_t(i)];
        vec3 color(0.9);
        for (int k = 0; k < 3 && count > 1; ++k) {
            color[k] = 2.2 / count *
                       std::clamp(1.5 - 6 * std::abs(turn - k / 3.0 - std::round(turn - k / 3.0)) + 0.5, 0.0, 1.0);
        }
        lit.scene.lights.push_back({.position = vec4(place.x, y, place.y, 1), .color = color});
        lit.lamps.push_back({});
    }
    return lit;
}

// Whether a light's reach comes to what is seen: the sphere is in the view, and a thing is in the sphere.
bool reaches(const Scene& scene, const vec3& light, double reach) {
    for (const vec4& plane : planesFromClip(scene.clipFromWorld())) {
        if (glm::dot(vec3(plane), light) + plane.w < -reach) return false;
    }
    return std::any_of(scene.objects.begin(), scene.objects.end(), [&](const SceneObject& object) {
        const Bounds bounds = boundsOf(object.mesh, object.worldFromObject);
        return glm::distance(glm::clamp(light, bounds.low, bounds.high), light) < reach;
    });
}

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
    Choice<int> resolution{
        this, "resolution", 2, {{"256"}, {"512"}, {"1024"}, {"2048"}}, "texels along a side of each map"};
    Real reach{this, "reach", 20, {0.5, 20}, "distance at which a light ends"};
    Toggle keep{this, "keep", true, "keep maps and volumes while light and casters rest"};
    Turntable turntable{this, {-3, 10}};

    Readout drawn{this, "lights-drawn", "lights that can reach the picture"};
    Readout remade{this, "shadows-remade", "lights whose map or volumes were made anew for this frame"};

    Program program, plain;
    Mesh bulb;
    LitScene lit;
    mat4 clipFromWorld{1};  // with the far plane at infinity
    std::vector<Mesh> meshes;
    std::optional<Which> built;
    struct Shadow {
        CasterVolumes volumes;
        DepthMap map;
        LightView view = {};
        // What the map was drawn for: the view of the light, and where the casters stood.
        std::vector<mat4> mapOf = {};
    };
    std::vector<Shadow> shadows;  // one a light
    int made = 0;

    ShadowLights() {
        bindKeys(Key::left, Key::right, lights, 1);
        // The still life is made for its view alone: once for each shape of picture
        bindHandle("light", places,
                   [this, seen = Scene(), aspect = 0.0](const Frame& frame, const vec2& place) mutable {
                       std::optional<vec2> at;
                       if (which != Which::placed) return at;
                       if (aspect != frame.aspect()) seen = stillLife(aspect = frame.aspect());
                       const mat4 clip = seen.clipFromView * turntable.seenBy(seen.viewFromWorld);
                       at = pictureFromPane({0, 0, frame.width(), frame.height()}, clip, {place.x, placedY, place.y});
                       return at;
                   });
    }

    void init() override {
        program = Program("shadow-lights");
        plain = Program("shadow-lights", "plain");
        bulb = Mesh(sphere(0.05, 16, 8), "bulb");
        built.reset();
    }

    // A map holds what casts only where that is in front of its light.
    void check() const override {
        if (which != Which::placed || method != Method::maps) return;
        static const std::vector<vec3> casters = casterPoints(stillLife(1));
        for (const vec2& place : places.points()) {
            try {
                fitLightView(vec4(place.x, placedY, place.y, 1), casters);
            } catch (const Error&) {
                throw Error("--places", "must keep each light beside what casts, for --method maps", places.text());
            }
        }
    }

    LitScene builtAt(double aspect, int index) const {
        if (which == Which::lamps) return lampsScene(aspect, index);
        if (which == Which::placed) return lightsScene(aspect, places.points(), placedY);
        std::vector<vec2> circle;
        for (int i = 0; i < lights; ++i) circle.push_back(onCircle(i, lights, index));
        return lightsScene(aspect, circle, circleY);
    }

    LitScene sceneAt(double aspect, int index) const {
        LitScene now = builtAt(aspect, index);
        now.scene.viewFromWorld = turntable.seenBy(now.scene.viewFromWorld);
        return now;
    }

    void draw(const Frame& frame) override {
        lit = sceneAt(frame.aspect(), frame.index());
        const Scene& scene = lit.scene;
        if (built != which) {
            meshes = uploadMeshes(scene);
            shadows.clear();
            built = which;
        }
        while (shadows.size() < scene.lights.size()) shadows.push_back({CasterVolumes(scene), {}});
        clipFromWorld = withDepths(scene.clipFromView, 0.1, HUGE_VAL) * scene.viewFromWorld;
        frame.show("viewFromWorld", scene.viewFromWorld);

        // First the maps, which need the framebuffer's place
        glEnable(GL_DEPTH_TEST);
        std::vector<std::size_t> reaching;
        made = 0;
        for (std::size_t i = 0; i < scene.lights.size(); ++i) {
            if (!reaches(scene, vec3(scene.lights[i].position), reach)) continue;
            reaching.push_back(i);
            if (method == Method::maps && drawMap(i)) ++made;
        }
        if (made > 0) frame.bindTarget();
        drawn = double(reaching.size());
        frame.count("lights drawn", double(reaching.size()));

        // The picture without a light, which fills the depth buffer
        program.use();
        program.set("measuring", frame.measuring());
        program.set("share", 1.0 / double(scene.lights.size()));
        program.set("firstLight", scene.lights[0].position);
        program.set("reach", reach);
        program.set("byMap", method == Method::maps);
        program.set("map", 0);
        program.set("ambientPass", true);
        drawScene(mat4(1));

        // Then what each light adds to it
        program.set("ambientPass", false);
        glDepthMask(GL_FALSE);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
        if (method == Method::volumes) glEnable(GL_STENCIL_TEST);
        std::optional<bool> shaded;
        for (const std::size_t i : reaching) {
            if (method == Method::volumes) countVolumes(i);
            program.use();
            program.set("light", scene.lights[i].position);
            program.set("lightColor", scene.lights[i].color);
            if (shaded != lit.lamps[i].aim.has_value()) program.set("shaded", lit.lamps[i].aim.has_value());
            shaded = lit.lamps[i].aim.has_value();
            if (method == Method::maps) shadows[i].map.bind(0, DepthLookup::compareNearest);
            glDepthFunc(GL_EQUAL);
            drawScene(method == Method::maps ? shadows[i].view.mapFromWorld() : mat4(1));
            glDepthFunc(GL_LESS);
            if (method == Method::volumes) glStencilFunc(GL_ALWAYS, 0, ~0U);
        }
        glDepthMask(GL_TRUE);
        if (method == Method::volumes) glDisable(GL_STENCIL_TEST);
        remade = made;
        if (!frame.measuring()) drawBulbs();
    }

    // A lamp's map covers its shade's opening, that of another light what casts.
    LightView viewOf(std::size_t i) const {
        const vec3 light(lit.scene.lights[i].position);
        if (!lit.lamps[i].aim) return fitLightView(vec4(light, 1), casterPoints(lit.scene));
        LightView view{.viewFromWorld = lookAtAnyRoll(light, light + *lit.lamps[i].aim)};
        view.bounds = frustumBounds(116, 1, 0.02, 20);
        view.clipFromView = frustum(view.bounds);
        return view;
    }

    bool drawMap(std::size_t i) {
        Shadow& shadow = shadows[i];
        shadow.view = viewOf(i);
        const mat4 mapClipFromWorld = shadow.view.clipFromWorld();
        std::vector<mat4> wanted{mapClipFromWorld};
        for (const auto& caster : shadow.volumes.casters()) {
            wanted.push_back(lit.scene.objects[caster.object].worldFromObject);
        }
        const int size = 256 << resolution;
        if (keep && shadow.map.size() == size && shadow.mapOf == wanted) return false;
        if (shadow.map.size() != size) shadow.map = DepthMap(size, "map of light " + std::to_string(i));
        shadow.mapOf = wanted;
        shadow.map.bindForDrawing();
        glClear(GL_DEPTH_BUFFER_BIT);
        glEnable(GL_POLYGON_OFFSET_FILL);
        glPolygonOffset(2, 4);
        plain.use();
        for (const auto& caster : shadow.volumes.casters()) {
            plain.set("clipFromObject", mapClipFromWorld * lit.scene.objects[caster.object].worldFromObject);
            meshes[caster.object].draw();
        }
        glDisable(GL_POLYGON_OFFSET_FILL);
        return true;
    }

    // By z-fail, as in shadow-volume; the count begins anew with each light.
    void countVolumes(std::size_t i) {
        CasterVolumes& volumes = shadows[i].volumes;
        if (!keep) volumes.forget();
        if (volumes.follow(lit.scene, lit.scene.lights[i].position)) ++made;
        glClear(GL_STENCIL_BUFFER_BIT);
        glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
        glStencilOpSeparate(GL_BACK, GL_KEEP, GL_INCR_WRAP, GL_KEEP);
        glStencilOpSeparate(GL_FRONT, GL_KEEP, GL_DECR_WRAP, GL_KEEP);
        plain.use();
        for (const auto& caster : volumes.casters()) {
            plain.set("clipFromObject", clipFromWorld * lit.scene.objects[caster.object].worldFromObject);
            caster.mesh.draw();
        }
        glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
        glStencilFunc(GL_EQUAL, 0, ~0U);
        glStencilOp(GL_KEEP, GL_KEEP, GL_KEEP);
    }

    void drawScene(const mat4& mapFromWorld) {
        for (std::size_t k = 0; k < meshes.size(); ++k) {
            const mat4& worldFromObject = lit.scene.objects[k].worldFromObject;
            program.set("clipFromObject", clipFromWorld * worldFromObject);
            program.set("worldFromObject", worldFromObject);
            program.set("worldFromNormal", normalMatrix(worldFromObject));
            program.set("mapFromObject", mapFromWorld * worldFromObject);
            program.set("color", lit.scene.objects[k].color);
            meshes[k].draw();
        }
    }

    // Where the lights are: no solids, so they cast nothing.
    void drawBulbs() {
        glDisable(GL_BLEND);
        plain.use();
        for (const SceneLight& light : lit.scene.lights) {
            const double most = std::max({light.color.x, light.color.y, light.color.z});
            plain.set("color", vec4(light.color / most, 1));
            plain.set("clipFromObject", clipFromWorld * translate(vec3(light.position)));
            bulb.draw();
        }
    }

    Reference reference(const Frame& frame, const std::function<void(double)>& progress) const override {
        const Scene scene = sceneAt(frame.aspect(), frame.index()).scene;
        std::vector<int> all(scene.lights.size());
        std::iota(all.begin(), all.end(), 0);
        return litReference(scene, frame, {.lights = all}, progress);
    }
};

Study lightsStudy() {
    Study study;
    study.quantity = "mean over the lights of lit or not, of the pixels that face the first";
    study.reference = "one ray through each pixel and one to each light, in double precision";
    study.scenes = {{"circle", {{"scene", "circle"}}}, {"lamps", {{"scene", "lamps"}}}};
    const std::vector<std::string> counts{"1", "2", "4", "8"}, sizes{"256", "512", "1024", "2048"};
    study.lines = {{"volumes, by lights", {{"method", "volumes"}, {"keep", "off"}}, "lights", counts, {"circle"}},
                   {"maps, by lights", {{"method", "maps"}, {"keep", "off"}}, "lights", counts, {"circle"}},
                   {"maps, by resolution", {{"method", "maps"}, {"keep", "off"}}, "resolution", sizes}};
    study.axis = ErrorAxis::fraction;
    study.wrongBeyond = 0.05;  // less than one light of eight
    study.says =
        "Beside the frame's own cost each light costs about the same, by maps and by volumes: eight take four to five "
        "times as long as one. Volumes are right but in the band of one pixel at edges; of maps about half as many "
        "pixels are wrong when they are twice as large, and with every light there are more edges to be wrong at.";
    return study;
}

const char* const inShadow = "what is wholly in one light's shadow is known when it is drawn";

const bool added = addDemo<ShadowLights>({
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
    .waste = {{"no-sample", "draw of 'foot'", inShadow},
              {"no-sample", "draw of 'lower arm'", inShadow},
              {"no-sample", "draw of 'upper arm'", inShadow},
              {"no-sample", "draw of 'bulb'", "whether a shade hides it is known when it is drawn"},
              {"outside-view", "draw of 'bulb'", "a bulb of 224 triangles is drawn sooner than asked for"}},
    .study = lightsStudy(),
});

}  // namespace

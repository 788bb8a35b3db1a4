// cube-shadows: what stands before a floor and a wall, and its shadows on them: one matrix for any plane and any light.
//
// Claims (each is a test in tests/claims/cube-shadows.cpp; the extreme ones are X11 to X16 in docs/stability.md):
// - [cast-by-rays] The picture is what rays show, on floor, wall and leaning wall, from lamps and lights at infinity.
// - [no-shadow-seen-from-the-light] An eye at the light, as in the first picture, sees no shadow.
// - [special-case] On planes across an axis the slide's special case and the general matrix give the same picture.
// - [transposed-is-wrong] The matrix as the slide prints it, for columns transposed, draws another picture.
// - [darkened-once] However many triangles and casters overlap in a shadow, each of its pixels is darkened once.
// - [between-plane-and-light] What is above the light, at its height or behind the plane casts nothing.
// - [clip-or-discard] Clip distances and discard cut the same false shadows off.
// - [light-in-the-plane] A light in the plane or behind it throws no shadow there, and a sentence says so.
// - [grazing-light] Under a light 1e-7 above the plane no pixel beside floor and wall is darkened.
// - [far-from-the-origin] With the plane 1e6 from the origin a shadow's place is right to 1e-5 of the cube.
// - [moved-by-hand] The arrow keys turn the light by 5 degrees.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>

#include "mv/demo/demo.h"
#include "mv/geometry/in_view.h"
#include "mv/geometry/ray.h"
#include "mv/geometry/scenes.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/beyond_es.h"
#include "mv/gl/gl.h"
#include "mv/gl/light_rays.h"
#include "mv/math/projection.h"
#include "mv/math/shadow.h"
#include "mv/math/shadow_caster.h"
#include "mv/math/shadow_textbook.h"
#include "mv/math/transform.h"

using namespace mv;

namespace {

enum class Place { plane, room, stillLife };
enum class Formula { general, axisAligned, transposed };
enum class Space { planeLocal, world, worldFloat };
enum class Cut { clip, discard, none };

constexpr double floorBelow = 1.0125;  // the middle of the scene

vec3 onSphere(double radius, double theta, double phi) {
    const double t = radians(theta), p = radians(phi);
    return radius * vec3(std::sin(p) * std::cos(t), std::sin(p) * std::sin(t), std::cos(p));
}

// A plane that shows shadows, by its unit normal and a point on it.
struct Plane {
    vec3 normal, origin;
    vec4 inWorld() const { return {normal, -glm::dot(normal, origin)}; }
    vec4 local() const { return {normal, 0}; }
    vec4 localOf(const vec4& light) const { return {vec3(light) - light.w * origin, light.w}; }
};

struct CubeShadows final : Demo {
    Choice<Place> place{this,
                        "scene",
                        Place::plane,
                        {{"plane", "a cube over the original's plane, which is not drawn"},
                         {"room", "the cube before a floor and a wall"},
                         {"still-life", "a pawn, a ring, a sphere and a box before a floor and a wall"}},
                        "what casts, and on what"};
    Angle lightTheta{this, "light-theta", 20, "where the light stands: its turn about the upright axis, 0 along x"};
    Real lightPhi{this, "light-phi", 80, {0, 180}, "where the light stands: its angle from straight above", "deg"};
    Real lightDistance{this, "light-distance", 8.5, {1.75, 20}, "distance of the light from the middle of the scene"};
    Toggle atInfinity{this, "at-infinity", false, "a light in that direction, infinitely far away: w = 0"};
    Real lift{this, "lift", 0, {-3, 12}, "how far what casts is lifted"};
    Real tilt{this, "tilt", 0, {-30, 60}, "how far the wall leans back; in scene plane, how far the plane rises",
              "deg"};
    Real darkness{this, "darkness", 0.25, {0, 1}, "how much of the light a shadow takes away; 0: no shadow"};
    Toggle once{this, "once", true, "darken each pixel once, by the stencil buffer"};
    Choice<Cut> cut{this,
                    "cut",
                    Cut::clip,
                    {{"clip", "clip distances: GL cuts the triangles (ES has none: as discard)"},
                     {"discard", "the fragment shader discards"},
                     {"none", "not at all: false shadows are seen"}},
                    "how the shadows of what is not between plane and light are cut off"};
    Choice<Formula> formula{this,
                            "formula",
                            Formula::general,
                            {{"general", "for any plane"},
                             {"axis-aligned", "the slide's special case, for a plane across an axis"},
                             {"transposed", "the general one as the slide prints it: wrong for columns"}},
                            "which matrix flattens"};
    Real planeDistance{this, "plane-distance", floorBelow, {0, 1e8}, "distance of the floor below the world's origin"};
    Choice<Space> space{this,
                        "space",
                        Space::planeLocal,
                        {{"plane-local", "relative to a point on the plane, in double"},
                         {"world", "world coordinates in double"},
                         {"world-float", "world coordinates in float"}},
                        "where the matrix is computed; each is rounded to float when it is uploaded"};
    Angle theta{this, "theta", 20, "where the eye stands: its turn about the upright axis"};
    Real phi{this, "phi", 80, {1, 179}, "where the eye stands: its angle from straight above", "deg"};
    Real distance{this, "distance", 8.5, {2, 30}, "distance of the eye from the middle of the scene"};
    Real fov{this, "fov", 40, {10, 120}, "the view's angle, upwards", "deg"};
    Toggle rays{this, "rays", false, "show the light's rays through the corners of cube or box"};

    Readout lightHeight{this, "light-height", "height of the light above the floor; at infinity the sine of its angle"};
    Readout placeError{this, "place-error",
                       "farthest that a corner's shadow on the floor is off, for a cube of side 2"};

    Program surfaces, shadows;
    std::optional<Place> made;  // the scene of these two
    Scene room;
    std::vector<Mesh> meshes;
    MeshData lampShape = painted(sphere(0.12, 32, 16), {1, 0.6, 0});
    Mesh edges, lamp;
    Drawing drawing;

    CubeShadows() {
        bindDrag(theta, -360.0 / 700, phi, -360.0 / 700);
        bindWheel(distance, -0.5);
        bindKeys(Key::left, Key::right, lightTheta, 5);
        bindKeys(Key::up, Key::down, lightPhi, 5);
        bindHandle("light", {&lightTheta, &lightPhi}, [this](const Frame& frame) -> std::optional<vec2> {
            if (atInfinity) return std::nullopt;
            const Pane picture{0, 0, frame.width(), frame.height()};
            return pictureFromPane(picture, clipFromView(frame.aspect()) * viewFromWorld(), vec3(light()));
        });
    }

    void init() override {
        surfaces = Program("cube-shadows");
        shadows = Program("cube-shadows", "shadow");
        edges = Mesh(painted(wireCube(), {0, 0, 0}), "edges");
    }

    // Vertices with a colour and without a normal are shown in that colour, unlit.
    static MeshData painted(MeshData mesh, const vec3& color) {
        mesh.colors.assign(mesh.positions.size(), fvec4(color, 1));
        mesh.normals.clear();
        return mesh;
    }

    void makeScene() {
        if (made == place) return;
        room = place == Place::stillLife ? stillLifeInRoom() : cubeInRoom();
        if (place == Place::plane) room.objects.pop_back();  // the wall
        for (SceneObject& object : room.objects) {
            if (object.name == "cube") {
                object.mesh.normals.clear();
            } else {
                object.mesh.colors.assign(object.mesh.positions.size(), fvec4(object.color, 1));
            }
        }
        meshes = uploadMeshes(room);
        made = place;
    }

    void check() const override {
        if (formula == Formula::axisAligned && tilt != 0)
            throw Error("--tilt", "must be 0 for --formula axis-aligned, which knows no other planes", tilt.text());
        if (space != Space::world || formula != Formula::general) return;
        for (const Plane& plane : grounds()) {
            if (lightSide(plane.localOf(light()), plane.local()) != 0 && lightSide(light(), plane.inWorld()) == 0)
                throw Error("--plane-distance",
                            "must be less for --space world: so far out the light cannot be told from the plane",
                            planeDistance.text());
        }
    }

    // ---- The scene: everything goes with its middle, wherever in the world the floor is

    vec3 middle() const { return {0, 0, floorBelow - planeDistance}; }

    // The eye relative to it, which looks at it; its distance from the world's origin drops out of the product in double.
    vec3 eye() const { return onSphere(distance, theta, phi); }
    mat4 viewFromWorld() const { return lookAt(eye(), vec3(0), vec3(0, 0, 1)) * translate(-middle()); }
    mat4 clipFromView(double aspect) const { return perspective(fov, aspect, 1, 100); }

    vec4 light() const {
        if (atInfinity) return {onSphere(1, lightTheta, lightPhi), 0};
        return {middle() + onSphere(lightDistance, lightTheta, lightPhi), 1};
    }

    mat4 worldFromObject(const SceneObject& object) const {
        if (object.casts) return translate(middle() + vec3(0, 0, lift)) * object.worldFromObject;
        const mat4 worldFromLevel = translate(middle()) * object.worldFromObject;
        if (object.name == "wall") return worldFromLevel * rotateX(-tilt);
        if (place != Place::plane) return worldFromLevel;
        return worldFromLevel * rotateX(-tilt) * translate(0, 0, -500) * scale(100, 1, 100);  // without an end in sight
    }

    // The point on it is the one nearest to the middle of the scene: what is relative to it stays small.
    Plane planeOf(const mat4& worldFromGround) const {
        const vec3 normal(worldFromGround[1]), point(worldFromGround[3]);
        return {normal, middle() - glm::dot(normal, middle() - point) * normal};
    }

    // The floor's and the wall's, where there is one.
    std::vector<Plane> grounds() const {
        static const Scene cubeScene = cubeInRoom();
        std::vector<Plane> grounds{planeOf(worldFromObject(cubeScene.objects[1]))};
        if (place != Place::plane) grounds.push_back(planeOf(worldFromObject(cubeScene.objects[2])));
        return grounds;
    }

    // ---- The shadow's matrix

    template <class T>
    glm::mat<4, 4, T> textbook(const glm::vec<4, T>& light, const glm::vec<4, T>& plane) const {
        if (formula == Formula::axisAligned) return textbookShadowAcrossAxis(light, plane);
        return textbookShadow(light, plane, formula == Formula::transposed);
    }

    // What model space is flattened by, seen from `target`: one matrix, multiplied from both ends before it is uploaded.
    mat4 flattened(const mat4& targetFromWorld, const Plane& plane, const mat4& worldFromModel) const {
        if (space == Space::worldFloat)
            return mat4(fmat4(targetFromWorld) * textbook(fvec4(light()), fvec4(plane.inWorld())) *
                        fmat4(worldFromModel));
        if (space == Space::world && formula == Formula::general)
            return targetFromWorld * shadowProjection(light(), plane.inWorld()) * worldFromModel;
        if (space == Space::world) return targetFromWorld * textbook(light(), plane.inWorld()) * worldFromModel;
        // Nothing that is large meets the shadow's matrix: it stands between coordinates relative to the origin
        const mat4 flat = formula == Formula::general ? shadowProjection(light(), plane.inWorld(), plane.origin)
                                                      : textbook(plane.localOf(light()), plane.local());
        return (targetFromWorld * translate(plane.origin)) * flat * (translate(-plane.origin) * worldFromModel);
    }

    void draw(const Frame& frame) override {
        makeScene();

        const mat4 viewFromWorld = this->viewFromWorld(), clipFromView = this->clipFromView(frame.aspect());
        frame.show("viewFromWorld", viewFromWorld);
        frame.show("clipFromView", clipFromView);

        // Draw what is seen. The stencil buffer keeps for each pixel whether it shows a plane's front, and which: its tag
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_STENCIL_TEST);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        surfaces.use();
        surfaces.set("clipFromView", clipFromView);
        surfaces.set("viewLight", viewFromWorld * light());
        std::vector<std::size_t> planes;
        for (std::size_t i = 0; i < room.objects.size(); ++i) {
            const mat4 worldFromModel = worldFromObject(room.objects[i]);
            GLint tag = 0;
            if (!room.objects[i].casts) {
                const Plane plane = planeOf(worldFromModel);
                const bool fromTheFront = glm::dot(plane.normal, middle() + eye() - plane.origin) > 0;
                if (fromTheFront || place == Place::plane) tag = static_cast<GLint>(i);
                planes.push_back(i);
            }
            glStencilFunc(GL_ALWAYS, tag, 0xFF);
            if (tag != 0 && place == Place::plane) setSeen(false);
            drawSurface(meshes[i], viewFromWorld * worldFromModel);
        }
        if (place == Place::plane) setSeen(true);
        glStencilFunc(GL_ALWAYS, 0, 0xFF);
        // Draw the edges a little outside the faces: on the faces themselves, the faces would cover parts of them
        if (place != Place::stillLife)
            drawSurface(edges, viewFromWorld * worldFromObject(room.objects[0]) * scale(2.004));
        const mat4 viewFromLamp = viewFromWorld * translate(vec3(light()));
        if (!atInfinity && isInView(lampShape, clipFromView * viewFromLamp)) {
            if (lamp.count() == 0) lamp = Mesh(lampShape, "light");
            drawSurface(lamp, viewFromLamp);
        }

        // Draw what casts once more, flattened onto each plane, where the tag says that this plane is seen. So the depth
        // test is not needed and nothing fights; and with the tag set to 0 by the first shadow, there is no second.
        glDisable(GL_DEPTH_TEST);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ZERO, GL_SRC_COLOR);  // what is there times what is drawn
        glStencilOp(GL_KEEP, GL_KEEP, once ? GL_ZERO : GL_KEEP);
        const bool clips = cut == Cut::clip && has(beyond_es::clipDistances);
        if (clips) glEnable(GL_CLIP_DISTANCE0);
        if (clips) glEnable(GL_CLIP_DISTANCE1);
        shadows.use();
        shadows.set("clipFromView", clipFromView);
        shadows.set("darkness", darkness);
        if (!isEs()) shadows.set("clips", clips);
        shadows.set("discardOutside", cut != Cut::none && !clips);
        std::vector<std::string> sentences;
        for (const std::size_t i : planes) {
            const SceneObject& ground = room.objects[i];
            const Plane plane = planeOf(worldFromObject(ground));
            const PlaneKind kind = ground.name == "wall" ? PlaneKind::wall : PlaneKind::floor;
            glStencilFunc(GL_EQUAL, static_cast<GLint>(i), 0xFF);
            for (std::size_t k = 0; k < planes[0]; ++k) {
                const std::string sentence = castShadow(plane, kind, room.objects[k], meshes[k], viewFromWorld);
                if (std::find(sentences.begin(), sentences.end(), sentence) == sentences.end())
                    sentences.push_back(sentence);
            }
        }
        for (const std::string& sentence : sentences) {
            if (!sentence.empty()) frame.say(sentence);
        }
        const Plane floor = planeOf(worldFromObject(room.objects[planes[0]]));
        if (lightSide(floor.localOf(light()), floor.local()) > 0)
            frame.show("shadowFromWorld", flattened(mat4(1), floor, mat4(1)));
        if (rays) drawRays(frame, clipFromView * viewFromWorld);
        if (frame.readouts()) measure(frame, floor);
    }

    void drawRays(const Frame& frame, const mat4& clipFromWorld) {
        std::vector<vec4> planes;
        for (const Plane& plane : grounds()) planes.push_back(plane.inWorld());
        drawing.begin(frame);
        for (const SceneObject& object : room.objects) {
            if (object.casts)
                drawLightRays(drawing, clipFromWorld, light(), cornersOf(object.mesh, worldFromObject(object)), planes);
        }
        drawing.draw(frame);
    }

    // The original's plane is not drawn: it is only tagged.
    static void setSeen(bool seen) {
        glColorMask(seen, seen, seen, seen);
        glDepthMask(seen);
    }

    void drawSurface(const Mesh& mesh, const mat4& viewFromModel) const {
        surfaces.set("viewFromModel", viewFromModel);
        mesh.draw();
    }

    // Returns what is to be said about it.
    std::string castShadow(const Plane& plane, PlaneKind kind, const SceneObject& caster, const Mesh& mesh,
                           const mat4& viewFromWorld) const {
        const mat4 worldFromModel = worldFromObject(caster), localFromModel = translate(-plane.origin) * worldFromModel;
        const vec4 localLight = plane.localOf(light());
        std::vector<vec3> corners;
        corners.reserve(caster.mesh.positions.size());
        for (const fvec3& corner : caster.mesh.positions) corners.emplace_back(localFromModel * vec4(corner, 1));
        const CasterVerdict verdict = judgeCaster(caster.name, corners, localLight, plane.local(), kind);
        const bool possible = cut == Cut::none && lightSide(localLight, plane.local()) > 0;
        if (!verdict.casts && !possible) return verdict.sentence;

        const auto [beforePlane, beforeLight] = shadowCasterBounds(localLight, plane.local());
        shadows.set("beforePlane", beforePlane * localFromModel);  // a half space moves by the transpose
        shadows.set("beforeLight", beforeLight * localFromModel);
        shadows.set("viewFromModel", flattened(viewFromWorld, plane, worldFromModel));
        mesh.draw();
        return verdict.sentence;
    }

    // ---- The study: where the shadows of the cube's corners lie on the floor, relative to a point on it

    static std::array<vec3, 8> corners() {
        std::array<vec3, 8> corners;
        for (int i = 0; i < 8; ++i) corners[static_cast<std::size_t>(i)] = vec3(i & 1, i >> 1 & 1, i >> 2) * 2.0 - 1.0;
        return corners;
    }
    Plane studied() const { return grounds().front(); }
    vec3 cubeMiddle() const { return middle() + vec3(0, 0, lift); }

    // As the GPU computes it: the matrix rounded to float, multiplied and divided in float.
    std::vector<double> values() const override {
        const Plane plane = studied();
        const fmat4 localFromModel(flattened(translate(-plane.origin), plane, translate(cubeMiddle())));
        std::vector<double> places;
        for (const vec3& corner : corners()) {
            const fvec4 shadow = localFromModel * fvec4(corner, 1);
            for (int axis = 0; axis < 3; ++axis) places.push_back(shadow[axis] / shadow.w);
        }
        return places;
    }

    // By another way: where the ray from the light through the corner meets the plane. No matrix, and nothing large.
    Reference reference(const Frame&, const std::function<void(double)>&) const override {
        const Plane plane = studied();
        const vec4 source = plane.localOf(light());
        Reference result;
        for (const vec3& corner : corners()) {
            const vec3 from = (cubeMiddle() - plane.origin) + corner;
            const auto t = intersectPlane(Ray{from, source.w * from - vec3(source)}, plane.local());
            if (!t) throw Error("reference", "must have every corner between plane and light");
            const vec3 met = from + *t * (source.w * from - vec3(source));
            result.values.insert(result.values.end(), {met.x, met.y, met.z});
        }
        return result;
    }

    void measure(const Frame& frame, const Plane& floor) {
        const vec4 localLight = floor.localOf(light());
        lightHeight = glm::dot(floor.local(), localLight);
        if (lightSide(localLight, floor.local()) <= 0) return;
        for (const vec4& bound : shadowCasterBounds(localLight, floor.local())) {
            for (const vec3& corner : corners())
                if (glm::dot(bound, vec4(cubeMiddle() + corner - floor.origin, 1)) <= 0) return;  // not all of it casts
        }
        const std::vector<double> drawn = values(), right = reference(frame, {}).values;
        double most = 0;
        for (std::size_t i = 0; i < drawn.size(); ++i) most = std::fmax(most, std::abs(drawn[i] - right[i]));
        if (std::isfinite(most)) placeError = most;
    }
};

const char* const distances[] = {"1", "10", "100", "1e3", "1e4", "1e5", "1e6", "1e7", "1e8"};

StudyLine lineOf(const std::string& method, const std::string& space) {
    return {.method = method,
            .settings = {{"space", space}},
            .knob = "plane-distance",
            .values = {std::begin(distances), std::end(distances)}};
}

const bool added = addDemo<CubeShadows>({
    .name = "cube-shadows",
    .sentence = "Planar shadows on any plane, from a lamp or a light at infinity, by one matrix.",
    .lookFor = "Move the light: the shadow runs over the floor and up the wall, and is never darkened twice.",
    .chapter = "Shadows",
    .number = 11,
    .width = 700,
    .height = 700,
    .background = vec4(1),
    .needs = {.depth = true,
              .stencil = true,
              .beyondEs = {{"clip distances", "the fragment shader discards by the same two distances"}}},
    .pose = {{"scene", "room"},
             {"light-theta", "50"},
             {"light-phi", "64"},
             {"light-distance", "9"},
             {"darkness", "0.6"},
             {"theta", "15"},
             {"phi", "70"},
             {"distance", "13"}},
    .waste = {{"no-sample", "draw of 'cube'",
               "in the first picture the eye is at the light: the cube hides its shadow"}},
    .study =
        Study{.quantity = "place of the shadows of a cube's eight corners, relative to a point on the plane",
              .reference = "the ray from the light through the corner meets the plane, in double, without a matrix",
              .scenes = {{"level plane", {{"light-phi", "40"}}},
                         {"rising plane", {{"light-phi", "40"}, {"tilt", "-20"}}}},
              .lines = {lineOf("world space, float", "world-float"), lineOf("world space, double", "world"),
                        lineOf("plane-local, double", "plane-local")},
              .wrongBeyond = 2e-5,
              .says = "In world space the error grows with the distance of the plane, in float from the start and in "
                      "double from 1e5 on; relative to a point on the plane it is what rounding the matrix to float "
                      "costs, wherever the plane is. That costs 0.15 microseconds a matrix more than float does.",
              .ofValues = true},
});

}  // namespace

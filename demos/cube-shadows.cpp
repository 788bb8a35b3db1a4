// cube-shadows: what stands before a floor and a wall, and its shadows on them: one matrix for any plane and any light.
//
// Claims (each is a test in tests/claims/cube-shadows.cpp; the extreme ones are the rows X11 to X16 of docs/stability.md):
// - [cast-by-rays] The picture is what rays show, on floor, wall and leaning wall, from lamps and lights at infinity.
// - [no-shadow-seen-from-the-light] An eye at the light, as in the original's first picture, sees no shadow.
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
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/geometry/in_view.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/beyond_es.h"
#include "mv/gl/gl.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/scene_meshes.h"
#include "mv/math/projection.h"
#include "mv/math/shadow.h"
#include "mv/math/shadow_caster.h"
#include "mv/math/shadow_textbook.h"
#include "mv/math/transform.h"
#include "shared/light_rays.h"
#include "shared/scenes.h"

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

// Which object of the scene that plane is, and the number that the stencil buffer has where it is seen.
struct Ground {
    ObjectId object;
    PlaneKind kind;
    Plane plane;
    GLint tag;
};

// A mesh that is shown in one colour, unlit: its vertices have that colour and no normals.
MeshData painted(MeshData mesh, const vec3& color) {
    mesh.colors.assign(mesh.positions.size(), fvec4(color, 1));
    mesh.normals.clear();
    return mesh;
}

struct CubeShadows final : Demo {
    Choice<Place> place{this,
                        "scene",
                        Place::room,
                        {{"plane", "a cube over the original's plane, which is not drawn"},
                         {"room", "the cube before a floor and a wall"},
                         {"still-life", "a pawn, a ring, a sphere and a box before a floor and a wall"}},
                        "what casts, and on what"};
    Angle lightTheta{this, "light-theta", 50, "where the light stands: its turn about the upright axis, 0 along x"};
    Real lightPhi{this, "light-phi", 64, {0, 180}, "where the light stands: its angle from straight above", "deg"};
    Real lightDistance{this, "light-distance", 9, {1.75, 20}, "distance of the light from the middle of the scene"};
    Toggle atInfinity{this, "at-infinity", false, "a light in that direction, infinitely far away: w = 0"};
    Real lift{this, "lift", 0, {-3, 12}, "how far what casts is lifted"};
    Real tilt{this, "tilt", 0, {-30, 60}, "how far the wall leans back; in scene plane, how far the plane rises",
              "deg"};
    Real darkness{this, "darkness", 0.6, {0, 1}, "how much of the light a shadow takes away; 0: no shadow"};
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
    Real planeDistance{this,
                       "plane-distance",
                       floorBelow,
                       {0.01, 1e8, Scale::logarithmic, true},
                       "distance of the floor below the world's origin"};
    Choice<Space> space{this,
                        "space",
                        Space::planeLocal,
                        {{"plane-local", "relative to a point on the plane, in double"},
                         {"world", "world coordinates in double"},
                         {"world-float", "world coordinates in float"}},
                        "where the matrix is computed; each is rounded to float when it is uploaded"};
    Angle theta{this, "theta", 15, "where the eye stands: its turn about the upright axis"};
    Real phi{this, "phi", 70, {1, 179}, "where the eye stands: its angle from straight above", "deg"};
    Real distance{this, "distance", 13, {2, 30}, "distance of the eye from the middle of the scene"};
    Real fov{this, "fov", 40, {10, 120}, "the view's angle, upwards", "deg"};
    Toggle rays{this, "rays", false, "show the light's rays through the corners of cube or box"};

    Readout lightHeight{this, "light-height", "height of the light above the floor; at infinity the sine of its angle"};

    Program surfaces, shadows;
    Scene now;
    Drawing drawing;
    SceneMeshes meshes;
    const MeshData lampShape = painted(sphere(0.12, 32, 16), {1, 0.6, 0});
    OnDemand<Mesh> lamp{lampShape, "light"}, edges{painted(wireCube(), {0, 0, 0}), "edges"};

    CubeShadows() {
        bindDrag(theta, -360.0 / 700, phi, -360.0 / 700);
        bindWheel(distance, -0.5);
        bindKeys(Key::left, Key::right, lightTheta, 5);
        bindKeys(Key::up, Key::down, lightPhi, 5);
        bindHandle("light", {&lightTheta, &lightPhi}, [this](const FrameInfo& frame) -> std::optional<vec2> {
            if (atInfinity) return std::nullopt;
            const Pane picture{0, 0, frame.width(), frame.height()};
            return pictureFromPane(picture, scene(frame).clipFromWorld(), vec3(light()));
        });
        lightDistance.onlyWhen([this] { return !atInfinity; }, "a light at infinity has no distance");
        for (Knob* knob : std::initializer_list<Knob*>{&once, &cut, &formula, &space}) {
            knob->onlyWhen([this] { return darkness > 0; }, "at darkness 0 there is no shadow");
        }
    }

    void init() override {
        surfaces = Program("cube-shadows");
        shadows = Program("cube-shadows", "shadow");
    }

    void draw(const Frame& frame) override {
        now = seen(frame);
        meshes.follow(now);
        const auto drawn = meshes.of(now);
        const std::vector<Ground> planes = grounds();
        tell(frame, planes);

        // 1. What is seen. The stencil buffer keeps for each pixel which plane's front it shows: the plane's tag, else 0.
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_STENCIL_TEST);
        glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
        surfaces.use();
        surfaces.set("clipFromView", now.clipFromView);
        surfaces.set("viewLight", now.viewFromWorld * light());
        for (const auto& [object, mesh] : drawn) {
            if (object.casts) drawSurface(mesh, object.worldFromObject);
        }
        if (place == Place::plane) setSeen(false);  // the original's plane is tagged only
        for (const Ground& ground : planes) {
            const auto& [object, mesh] = drawn[ground.object.index];
            glStencilFunc(GL_ALWAYS, showsFront(ground.plane) ? ground.tag : 0, 0xFF);
            drawSurface(mesh, object.worldFromObject);
        }
        if (place == Place::plane) setSeen(true);
        glStencilFunc(GL_ALWAYS, 0, 0xFF);
        drawEdgesAndLamp();

        // 2. What casts once more, flattened onto each plane, where the tag says that this plane is seen. So no depth test
        //    is needed and nothing fights; and the first shadow sets the tag to 0, so that there is no second.
        glDisable(GL_DEPTH_TEST);
        glEnable(GL_BLEND);
        glBlendFunc(GL_ZERO, GL_SRC_COLOR);  // what is there times what is drawn
        glStencilOp(GL_KEEP, GL_KEEP, once ? GL_ZERO : GL_KEEP);
        const bool clips = cut == Cut::clip && has(beyond_es::clipDistances);
        if (clips) glEnable(GL_CLIP_DISTANCE0);
        if (clips) glEnable(GL_CLIP_DISTANCE1);
        shadows.use();
        shadows.set("clipFromView", now.clipFromView);
        shadows.set("darkness", darkness);
        if (!isEs()) shadows.set("clips", clips);
        shadows.set("discardOutside", cut != Cut::none && !clips);
        std::vector<std::string> sentences;
        for (const Ground& ground : planes) {
            const Plane& plane = ground.plane;
            glStencilFunc(GL_EQUAL, ground.tag, 0xFF);
            for (const auto& [object, mesh] : drawn) {
                if (!object.casts) continue;
                const CasterVerdict verdict = judged(object, ground);
                sentences.push_back(verdict.sentence);
                if (!verdict.casts && (cut != Cut::none || !isLit(plane))) continue;
                setHalfSpaces(plane, object.worldFromObject);
                shadows.set("viewFromModel", flattened(now.viewFromWorld, plane, object.worldFromObject));
                mesh.draw();
            }
        }
        sayEachOnce(frame, sentences);
    }

    void drawSurface(const Mesh& mesh, const mat4& worldFromModel) const {
        surfaces.set("viewFromModel", now.viewFromWorld * worldFromModel);
        mesh.draw();
    }

    static void setSeen(bool seen) {
        glColorMask(seen, seen, seen, seen);
        glDepthMask(seen);
    }

    // Whether the eye is before the plane, where shadows are seen. On the original's plane they are seen from both sides.
    bool showsFront(const Plane& plane) const {
        return place == Place::plane || glm::dot(plane.normal, middle() + eye() - plane.origin) > 0;
    }

    void drawEdgesAndLamp() {
        // The edges lie a little outside the faces, which would cover parts of them
        if (place != Place::stillLife) drawSurface(*edges, now[cubeInRoomScene::cube].worldFromObject * scale(2.004));
        const mat4 worldFromLamp = translate(vec3(light()));
        if (!atInfinity && isInView(lampShape, now.clipFromWorld() * worldFromLamp)) drawSurface(*lamp, worldFromLamp);
    }

    CasterVerdict judged(const SceneObject& caster, const Ground& ground) const {
        const mat4 localFromModel = translate(-ground.plane.origin) * caster.worldFromObject;
        std::vector<vec3> corners;
        corners.reserve(caster.mesh.positions.size());
        for (const fvec3& corner : caster.mesh.positions) corners.emplace_back(localFromModel * vec4(corner, 1));
        return judgeCaster(caster.name, corners, ground.plane.localOf(light()), ground.plane.local(), ground.kind);
    }

    // Of what casts, only the part between plane and light throws a true shadow.
    void setHalfSpaces(const Plane& plane, const mat4& worldFromModel) const {
        const auto [beforePlane, beforeLight] = shadowCasterBounds(plane.localOf(light()), plane.local());
        const mat4 localFromModel = translate(-plane.origin) * worldFromModel;
        shadows.set("beforePlane", beforePlane * localFromModel);  // a half space moves by the transpose
        shadows.set("beforeLight", beforeLight * localFromModel);
    }

    bool isLit(const Plane& plane) const { return lightSide(plane.localOf(light()), plane.local()) > 0; }

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

    template <class T>
    glm::mat<4, 4, T> textbook(const glm::vec<4, T>& light, const glm::vec<4, T>& plane) const {
        if (formula == Formula::axisAligned) return textbookShadowAcrossAxis(light, plane);
        return textbookShadow(light, plane, formula == Formula::transposed);
    }

    // For the study: where the shadows of a cube's corners lie on the floor, relative to the plane's point. As the GPU
    // computes it: the matrix is rounded to float, and multiplied and divided in float.
    std::vector<double> values() const override {
        const Plane plane = planeOf(worldFromFloor());
        const mat4 worldFromCube = translate(middle() + vec3(0, 0, lift));
        const fmat4 localFromModel(flattened(translate(-plane.origin), plane, worldFromCube));
        std::vector<double> places;
        for (int i = 0; i < 8; ++i) {
            const fvec3 corner = fvec3(i & 1, i >> 1 & 1, i >> 2) * 2.0F - 1.0F;
            const fvec4 shadow = localFromModel * fvec4(corner, 1);
            for (int axis = 0; axis < 3; ++axis) places.push_back(shadow[axis] / shadow.w);
        }
        return places;
    }

    // ---- What is shown: everything goes with its middle, wherever in the world the floor is

    void check() const override {
        if (formula == Formula::axisAligned && tilt != 0)
            throw Error("--tilt", "must be 0 for --formula axis-aligned, which knows no other planes", tilt.text());
        if (space != Space::world || formula != Formula::general) return;
        for (const Ground& ground : grounds()) {
            if (lightSide(ground.plane.localOf(light()), ground.plane.local()) != 0 &&
                lightSide(light(), ground.plane.inWorld()) == 0)
                throw Error("--plane-distance",
                            "must be less for --space world: so far out the light cannot be told from the plane",
                            planeDistance.text());
        }
    }

    Scene scene(const FrameInfo& frame) const override {
        const bool life = place == Place::stillLife;
        Scene scene = life ? stillLifeInRoom() : cubeInRoom();
        for (SceneObject& object : scene.objects) {
            if (object.casts) object.worldFromObject = translate(middle() + vec3(0, 0, lift)) * object.worldFromObject;
            object.receives = !object.casts;
            std::vector<fvec4>& colors = object.mesh.colors;
            if (colors.empty()) colors.assign(object.mesh.positions.size(), fvec4(object.color, 1));
        }
        if (!life) scene[cubeInRoomScene::cube].mesh.normals.clear();  // it is shown in its own colours, unlit
        scene[floorId()].worldFromObject = worldFromFloor();
        scene[wallId()].worldFromObject = worldFromWall();
        if (place == Place::plane) scene.objects.resize(wallId().index);  // without the wall, the last of them
        scene.lights = {{.position = light()}};
        // The eye looks at the middle, whose distance from the world's origin drops out of the product in double
        scene.viewFromWorld = lookAt(eye(), vec3(0), vec3(0, 0, 1)) * translate(-middle());
        scene.clipFromView = perspective(fov, frame.aspect(), 1, 100);
        return scene;
    }

    vec3 middle() const { return {0, 0, floorBelow - planeDistance}; }
    vec3 eye() const { return onSphere(distance, theta, phi); }  // from the middle

    vec4 light() const {
        if (atInfinity) return {onSphere(1, lightTheta, lightPhi), 0};
        return {middle() + onSphere(lightDistance, lightTheta, lightPhi), 1};
    }

    ObjectId floorId() const {
        return place == Place::stillLife ? stillLifeInRoomScene::floor : cubeInRoomScene::floor;
    }
    ObjectId wallId() const { return place == Place::stillLife ? stillLifeInRoomScene::wall : cubeInRoomScene::wall; }

    // Floor and wall are the same round the cube and round the still life.
    static const Scene& room() {
        static const Scene room = cubeInRoom();
        return room;
    }
    mat4 worldFromFloor() const {
        const mat4 level = translate(middle()) * room()[cubeInRoomScene::floor].worldFromObject;
        if (place != Place::plane) return level;
        return level * rotateX(-tilt) * translate(0, 0, -500) * scale(100, 1, 100);  // without an end in sight
    }
    mat4 worldFromWall() const {
        return translate(middle()) * room()[cubeInRoomScene::wall].worldFromObject * rotateX(-tilt);
    }

    // Its point is the one nearest to the middle of the scene: what is relative to it stays small.
    Plane planeOf(const mat4& worldFromGround) const {
        const vec3 normal(worldFromGround[1]), point(worldFromGround[3]);
        return {normal, middle() - glm::dot(normal, middle() - point) * normal};
    }

    // The floor, and the wall where there is one.
    std::vector<Ground> grounds() const {
        std::vector<Ground> grounds{{floorId(), PlaneKind::floor, planeOf(worldFromFloor()), 1}};
        if (place != Place::plane) grounds.push_back({wallId(), PlaneKind::wall, planeOf(worldFromWall()), 2});
        return grounds;
    }

    void annotate(const Frame& frame) override {
        if (rays) drawSceneRays(drawing, now, frame);
    }

    void tell(const Frame& frame, const std::vector<Ground>& planes) {
        const Plane& floor = planes.front().plane;
        frame.show("viewFromWorld", now.viewFromWorld);
        frame.show("clipFromView", now.clipFromView);
        if (isLit(floor)) frame.show("shadowFromWorld", flattened(mat4(1), floor, mat4(1)));
        lightHeight = glm::dot(floor.local(), floor.localOf(light()));
    }

    static void sayEachOnce(const Frame& frame, std::vector<std::string> sentences) {
        for (auto next = sentences.begin(); next != sentences.end(); ++next) {
            if (!next->empty() && std::find(sentences.begin(), next, *next) == next) frame.say(*next);
        }
    }
};

constexpr Declaration declaration{
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
    .presets =
        {
            {"room", "The shadow runs over the floor and bends up the wall, by a matrix for each."},
            {"original",
             "The page's first picture: the eye stands where the light is, and sees no shadow.",
             {{"scene", "plane"},
              {"light-theta", "20"},
              {"light-phi", "80"},
              {"light-distance", "8.5"},
              {"darkness", "0.25"},
              {"theta", "20"},
              {"phi", "80"},
              {"distance", "8.5"}}},
            {"sun",
             "A light at infinity and a wall that leans back: the shadow's edges stay parallel.",
             {{"light-phi", "70"}, {"at-infinity", "on"}, {"tilt", "40"}}},
            {"twice",
             "Without the stencil buffer a pixel is darkened as often as something flattened falls on it.",
             {{"scene", "still-life"},
              {"light-theta", "48"},
              {"light-phi", "66"},
              {"light-distance", "14"},
              {"once", "off"},
              {"theta", "12"}}},
            {"uncut",
             "A cube half under the floor: what is below it casts a false shadow, towards the light.",
             {{"lift", "-1"}, {"cut", "none"}}},
            {"transposed",
             "The matrix as a slide prints it, for row vectors: two patches that belong to nothing.",
             {{"formula", "transposed"}}},
        },
    .waste = {{"no-sample", "draw of 'cube'", "what is wholly hidden, or cut off, is known when it is drawn"},
              {"no-sample", "draw of 'sphere'", "what is wholly hidden, or cut off, is known when it is drawn"}},
};

const bool added = addDemo<CubeShadows, declaration>();

}  // namespace

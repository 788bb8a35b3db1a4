// view-volume: a camera seen from outside, with what it sees and what it does not; and the same after its projection.
//
// Claims (each is a test in tests/claims/view-volume.cpp; the extreme one is X07 in docs/stability.md):
// - [planes-are-the-clip-volume] A point is inside the six planes exactly when its clip coordinates are within -w to w.
// - [orange-is-clipped] Orange is what the clip volume cuts off, and none of it is left after the projection.
// - [culled-is-not-drawn] An object whole outside one plane is not drawn, and nothing is missing in the cube.
// - [cube-is-the-picture] Seen from the front the canonical cube is what the camera sees.
// - [near-takes-the-cube] The nearer near is, the thinner the slice of the cube that is left for what is far away.
// - [parameters-never-cancel] Planes from near and far are exact at any far/near; from the matrix they are not.
// - [near-below-far] Near not below far is refused with both.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/geometry/bounds.h"
#include "mv/geometry/in_volume.h"
#include "mv/gl/gl.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/scenes.h"

using namespace mv;

namespace {

enum class Projection { perspective, orthographic };
enum class Planes { parameters, matrix, floatMatrix };
enum class Round { box, ball };
using SixPlanes = std::array<vec4, 6>;

constexpr double fovy = 50, aspect = 1;
const vec4 nearColor(0.10, 0.25, 0.90, 1), farColor(0.80, 0.10, 0.10, 1);
const vec3 eye(0, 3, 0);  // of the camera, which looks along -z when pan is 0

// Lines on the ground, 4 m apart, from below the camera to the last trees.
MeshData groundLines() {
    MeshData mesh;
    mesh.primitive = Primitive::lines;
    const auto add = [&](const vec3& from, const vec3& to) {
        mesh.positions.insert(mesh.positions.end(), {fvec3(from), fvec3(to)});
    };
    for (int z = 0; z <= 40; z += 4) add({-16, 0, -z}, {16, 0, -z});
    for (int x = -16; x <= 16; x += 4) add({x, 0, 0}, {x, 0, -40});
    mesh.normals.assign(mesh.positions.size(), fvec3(0, 1, 0));
    mesh.colors.assign(mesh.positions.size(), fvec4(0.60F, 0.66F, 0.56F, 1));
    return mesh;
}

// The planes of Gribb and Hartmann as they are mostly copied: sums of the matrix's rows, all in float. A normal that has
// cancelled to 0 stays 0; such a plane holds everything.
SixPlanes planesInFloat(const mat4& clipFromWorld) {
    const fmat4 rows = glm::transpose(fmat4(clipFromWorld));
    SixPlanes planes;
    for (int i = 0; i < 6; ++i) {
        const fvec4 plane = i % 2 == 0 ? rows[3] + rows[i / 2] : rows[3] - rows[i / 2];
        const float length = glm::length(fvec3(plane));
        planes[std::size_t(i)] = length == 0 ? vec4(0) : vec4(plane / length);
    }
    return planes;
}

struct ViewVolume final : Demo {
    Choice<Projection> projection{
        this, "projection", Projection::perspective, {{"perspective"}, {"orthographic"}}, "of the camera"};
    Real near{this, "near", 8, {0.5, 25, Scale::logarithmic}, "where it begins, in front of the camera", "m"};
    Real far{this, "far", 30, {2, 60}, "where it ends", "m"};
    NumberChoice closer{this,
                        "closer",
                        1,
                        {1, 10, 100, 1000, 10'000, 100'000, 1'000'000, 10'000'000, 100'000'000},
                        "by what near is divided"};
    Real pan{this, "pan", 0, {-90, 90}, "how far the camera looks to the left", "deg"};
    Toggle cull{this, "cull", true, "leave out each object that is whole outside one plane"};
    Choice<Planes> planes{this,
                          "planes",
                          Planes::parameters,
                          {{"parameters", "from the field of view, near and far"},
                           {"matrix", "sums of rows of the matrix, in double"},
                           {"float-matrix", "the same in float"}},
                          "where the six planes come from"};
    Choice<Round> round{this,
                        "round",
                        Round::box,
                        {{"box", "the smallest along the object's axes"}, {"ball", "about the box's middle"}},
                        "what is put round each object and compared with the planes"};
    Angle turn{this, "turn", 65, "how far we go round, to the right"};
    Real tilt{this, "tilt", 32, {-90, 90}, "how far we go up from there", "deg"};

    Readout drawn{this, "drawn", "objects drawn"};
    Readout culled{this, "culled", "objects left out"};
    Readout clipped{this, "clipped", "objects drawn of whose boxes or balls a part is outside"};
    Readout ratio{this, "far-over-near", "far/near, by which the planes of a matrix lose digits"};

    Program faces;
    const std::vector<SceneObject> things = garden().objects;  // the house first, then trees
    struct Ball {
        vec3 center;
        double radius;
    };
    std::vector<std::array<vec3, 8>> boxes;  // the corners of one around each object, in world space
    std::vector<Ball> balls;
    Mesh house, tree, ground;
    Drawing drawing;

    ViewVolume() {
        bindDrag(turn, -0.5, tilt, 0.5);
        bindWheel(far, 1);
        bindKeys(Key::down, Key::up, near, 0.1);
        bindKeys(Key::right, Key::left, pan, 5);
        bindHandle("near plane", {&near}, [this](const FrameInfo& frame) { return middleAt(frame, nearUsed()); });
        bindHandle("far plane", {&far}, [this](const FrameInfo& frame) { return middleAt(frame, far); });
        planes.onlyWhen([this] { return cull; }, "nothing is culled by them");
        round.onlyWhen([this] { return cull; }, "nothing is culled by it");
    }

    void init() override {
        faces = Program("view-volume");
        house = Mesh(things[0].mesh, "house");
        tree = Mesh(things[1].mesh, "tree");
        ground = Mesh(groundLines(), "ground");
        for (const SceneObject& object : things) {
            boxes.push_back(boundsOf(object.mesh).corners());
            for (vec3& corner : boxes.back()) corner = vec3(object.worldFromObject * vec4(corner, 1));
            Ball ball{boundsOf(object.mesh, object.worldFromObject).middle(), 0};
            for (const fvec3& position : object.mesh.positions) {
                const vec3 place(object.worldFromObject * vec4(vec3(position), 1));
                ball.radius = std::max(ball.radius, glm::distance(place, ball.center));
            }
            balls.push_back(ball);
        }
    }

    void draw(const Frame& frame) override {
        glClearColor(1, 1, 1, 1);
        glEnable(GL_DEPTH_TEST);
        glEnable(GL_SCISSOR_TEST);

        // Leave out what is whole outside of one plane. A matrix takes points from the right, and planes back from the left
        const SixPlanes six = cameraPlanes();
        SixPlanes worldPlanes = six;
        for (vec4& plane : worldPlanes) plane = plane * cameraFromWorld();
        std::vector<std::size_t> kept;
        int cut = 0;
        for (std::size_t i = 0; i < boxes.size(); ++i) {
            const InVolume place = round == Round::box ? hullInVolume(boxes[i], worldPlanes)
                                                       : ballInVolume(balls[i].center, balls[i].radius, worldPlanes);
            if (cull && place == InVolume::outside) continue;
            kept.push_back(i);
            cut += place == InVolume::inside ? 0 : 1;
        }
        if (std::count(six.begin(), six.end(), vec4(0)) > 0)
            frame.say("A plane's normal has cancelled to 0 in float: that plane culls nothing.");

        // The camera's matrix, and on the right one more that looks at what it makes. Clip space counts depth away from
        // the camera, so it is mirrored before it is turned.
        const std::vector<Pane> panes = frame.panes(2);
        const mat4 clipFromWorld = clipFromCamera() * cameraFromWorld();
        const mat4 outside = outsideFromWorld(panes[0]);
        const mat4 cubeFromClip = this->cubeFromClip(panes[1]);
        frame.show("clipFromWorld", clipFromWorld);
        frame.show("outsideFromWorld", outside);
        frame.show("cubeFromClip", cubeFromClip);
        faces.use();
        faces.set("clipFromWorld", clipFromWorld);
        drawPane(panes[0], kept, outside, false);
        drawPane(panes[1], kept, cubeFromClip * clipFromWorld, true);

        drawn = double(kept.size());
        culled = double(boxes.size() - kept.size());
        clipped = cut;
        ratio = far / nearUsed();
    }

    void check() const override {
        if (nearUsed() >= far) throw Error("--near", "must be less than --far " + far.text(), near.text());
        try {
            cameraPlanes();
        } catch (const Error& error) {
            throw Error("--closer", std::string("must leave the matrix its planes; ") + error.what(), closer.text());
        }
    }

    double nearUsed() const { return near / closer; }
    // The box of the parallel projection is as wide as the pyramid at 16 m
    double boxHalf() const { return 16 * std::tan(radians(fovy / 2)); }
    mat4 clipFromCamera() const {
        if (projection == Projection::perspective) return perspective(fovy, aspect, nearUsed(), far);
        return ortho(-boxHalf() * aspect, boxHalf() * aspect, -boxHalf(), boxHalf(), nearUsed(), far);
    }
    mat4 cameraFromWorld() const { return rotateY(-pan) * translate(-eye); }

    // Who looks at the camera, from outside.
    mat4 turned() const { return rotateX(tilt) * rotateY(-turn); }
    mat4 outsideFromWorld(const Pane& pane) const {
        return perspective(40, pane.aspect(), 1, 200) * translate(0, 0, -68) * turned() * translate(0, -2, 19);
    }
    // Who looks at the cube, from as far round and up.
    mat4 cubeFromClip(const Pane& pane) const {
        const double half = 1.9 / std::min(1.0, pane.aspect());
        return ortho(-half * pane.aspect(), half * pane.aspect(), -half, half, -4, 4) * turned() * scale(1, 1, -1);
    }
    // Where the left pane shows the middle of a plane across the view.
    std::optional<vec2> middleAt(const FrameInfo& frame, double distance) const {
        const Pane pane = frame.panes(2)[0];
        return pictureFromPane(pane, outsideFromWorld(pane) * glm::inverse(cameraFromWorld()), {0, 0, -distance});
    }

    // In camera space, each as (unit normal inwards, distance).
    SixPlanes cameraPlanes() const {
        if (planes == Planes::matrix) return planesFromClip(clipFromCamera());
        if (planes == Planes::floatMatrix) return planesInFloat(clipFromCamera());
        if (projection == Projection::perspective) return perspectivePlanes(fovy, aspect, nearUsed(), far);
        const double h = boxHalf();
        return {vec4(1, 0, 0, h * aspect), vec4(-1, 0, 0, h * aspect),  vec4(0, 1, 0, h),
                vec4(0, -1, 0, h),         vec4(0, 0, -1, -nearUsed()), vec4(0, 0, 1, far)};
    }

    void drawPane(const Pane& pane, const std::vector<std::size_t>& kept, const mat4& paneFromWorld, bool cutOpen) {
        glViewport(pane.x, pane.y, pane.width, pane.height);
        glScissor(pane.x, pane.y, pane.width, pane.height);
        glClear(GL_COLOR_BUFFER_BIT);
        faces.set("paneFromWorld", paneFromWorld);
        faces.set("cutOpen", cutOpen);
        for (const std::size_t i : kept) {
            faces.set("worldFromObject", things[i].worldFromObject);
            (i == 0 ? house : tree).draw();
        }
        faces.set("worldFromObject", mat4(1));
        ground.draw();
    }

    // The edges of the view volume and of the cube, and what they are.
    void annotate(const Frame& frame) override {
        const std::vector<Pane> panes = frame.panes(2);
        const mat4 outside = outsideFromWorld(panes[0]);
        glDisable(GL_SCISSOR_TEST);
        glViewport(0, 0, frame.width(), frame.height());
        drawing.begin(frame);
        drawing.in(panes[0]);
        drawFrame(outside * glm::inverse(clipFromCamera() * cameraFromWorld()));
        drawSight(outside * glm::inverse(cameraFromWorld()));
        drawing.text({6, panes[0].height - 6}, "world", {.height = 18});
        drawing.text({6, 30}, numberText(*drawn.value()) + " drawn, " + numberText(*culled.value()) + " culled");
        drawing.in(panes[1]);
        drawFrame(cubeFromClip(panes[1]));
        drawing.text({6, panes[1].height - 6}, "after projection and division", {.height = 18});
        drawing.text({6, 30}, "near: z = -1", {.color = nearColor});
        drawing.text({110, 30}, "far: z = 1", {.color = farColor});
        drawing.draw(frame);
    }

    // The canonical cube's own edges, or where they come from. Corner i is at 1 where bits 0, 1, 2 of i say so of x, y, z.
    void drawFrame(const mat4& paneFromClip) {
        for (const unsigned bit : {4U, 1U, 2U}) {
            for (unsigned i = 0; i < 8; ++i) {
                if ((i & bit) != 0) continue;
                const vec4 color = bit == 4 ? vec4(0.2, 0.2, 0.2, 1) : (i & 4U) != 0 ? farColor : nearColor;
                drawing.edge(paneFromClip, cubeCorner(i), cubeCorner(i | bit), {.color = color});
            }
        }
    }
    static vec3 cubeCorner(unsigned i) { return 2.0 * vec3(i & 1U, i >> 1 & 1U, i >> 2 & 1U) - 1.0; }

    // The middles of near and far plane, which are dragged; and the lines from the eye to the corners of the near plane.
    void drawSight(const mat4& outsideFromCamera) {
        drawing.point(outsideFromCamera, {0, 0, -nearUsed()}, 7, nearColor);
        drawing.point(outsideFromCamera, {0, 0, -far}, 7, farColor);
        if (projection == Projection::orthographic) return;
        const double top = nearUsed() * std::tan(radians(fovy / 2));
        for (unsigned i = 0; i < 4; ++i)
            drawing.edge(outsideFromCamera, vec3(0), vec3(vec2(cubeCorner(i)) * vec2(top * aspect, top), -nearUsed()),
                         {.color = vec4(0.6, 0.6, 0.6, 1), .width = 1});
        drawing.point(outsideFromCamera, vec3(0), 7, vec4(0.3, 0.3, 0.3, 1));
        drawing.text(outsideFromCamera, vec3(0), {-6, -4}, "eye", {.background = vec4(0)});
    }

    // Of each plane its normal, and its distance as a part of far.
    std::vector<double> values() const override {
        std::vector<double> numbers;
        for (const vec4& plane : cameraPlanes()) {
            if (plane == vec4(0)) throw Error("plane", "must have a normal: it has cancelled to 0 in float");
            numbers.insert(numbers.end(), {plane.x, plane.y, plane.z, plane.w / far});
        }
        return numbers;
    }
};

constexpr Declaration declaration{
    .name = "view-volume",
    .sentence = "A camera seen from outside, with its view volume, and the cube that its projection makes of it.",
    .lookFor = "What is between near and far fills the cube, large before and small behind; orange is cut off.",
    .chapter = "Viewing and projection",
    .number = 5,
    .width = 960,
    .height = 480,
    .background = vec4(0.5, 0.5, 0.5, 1),
    .needs = {.depth = true},
    .presets =
        {
            {"garden", "What lies between the blue and the red plane becomes the cube on the right, bent with it."},
            {"near-plane",
             "With near at 0.5 the house is a thin slice at the far side of the cube: near is where depth is lost.",
             {{"near", "0.5"}}},
            {"pan",
             "The camera looks past the house: what is cut off is orange, and what is whole outside was not drawn.",
             {{"pan", "25"}}},
            {"box",
             "The box of a parallel projection becomes the cube without bending.",
             {{"projection", "orthographic"}}},
            {"float-planes",
             "Planes from a float matrix with near a million times closer: plane-error is 0.12, and trees beyond far "
             "come back.",
             {{"closer", "1e6"}, {"planes", "float-matrix"}},
             {{"plane-error", 0.115, 0.125}}},
            {"from-the-front", "Seen from the front the cube is the camera's picture.", {{"turn", "0"}, {"tilt", "0"}}},
        },
    .waste = {{"no-sample", "draw of 'tree', up to 6 times",
               "a tree that is in view may be hidden, or smaller than a pixel"}},
};

const bool added = addDemo<ViewVolume, declaration>();

}  // namespace

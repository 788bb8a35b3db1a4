// cube-cull: a cube whose back faces, front faces or both are discarded before they are drawn.
//
// Claims (each is a test in tests/claims/cube-cull.cpp):
// - [convex-needs-no-depth] The cube is closed and convex: with back faces culled its pixels need no depth test.
// - [front-is-inside] Culling front faces shows the inside, and so does culling back faces of the other winding.
// - [half-to-five-sixths] From outside 1, 2 or 3 faces are seen, so culling discards 1/2 to 5/6 of all triangles.
// - [eye-inside] From inside no face turns to the eye: culling back faces leaves the axes alone.
// - [lines-stay] Lines have no faces: culling both leaves the axes.
#include "mv/demo/demo.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/gl.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/spin.h"

using namespace mv;

namespace {

enum class Cull { none, back, front, both };
enum class Winding { ccw, cw };

struct CubeCull final : Demo {
    Choice<Cull> cull{this, "cull", Cull::back, {{"none"}, {"back"}, {"front"}, {"both"}}, "which faces to discard"};
    Choice<Winding> winding{this,
                            "winding",
                            Winding::ccw,
                            {{"ccw", "counter-clockwise on the screen"}, {"cw", "clockwise"}},
                            "which way round the corners of a front face run"};
    Toggle depth{this, "depth", true, "let near faces hide far ones (depth test)"};
    Real zDist{this, "z-dist", -4, {-10, 10}, "where the eye stands on the z axis, looking at the middle"};
    Spin spin{this, 20, 30, {-1, 1}};

    Readout facing{this, "facing", "faces of the cube turned towards the eye, of 6"};
    Readout culled{this, "culled", "triangles discarded by culling, of 12"};
    Readout outside{this, "outside", "triangles wholly outside the view"};
    Readout surviving{this, "surviving", "triangles that go on to the rasterizer"};

    Program program;
    Mesh cube, crossOfAxes;

    CubeCull() {
        bindKeys(Key::down, Key::up, zDist, 0.2);
        bindWheel(zDist, -0.2);
        winding.onlyWhen([this] { return cull == Cull::back || cull == Cull::front; },
                         "front and back faces are treated alike");
    }

    void init() override {
        program = Program("cube-cull");
        cube = Mesh(colorCube(), "cube");
        crossOfAxes = Mesh(axes(1.5), "axes");
    }

    void check() const override {
        if (zDist == 0) throw Error("--z-dist", "must not be 0: the eye would stand on the point it looks at");
    }

    void draw(const Frame& frame) override {
        // Discard the faces not wanted. OpenGL begins with GL_CCW for front faces, and with GL_BACK to be discarded
        if (cull != Cull::none) glEnable(GL_CULL_FACE);
        if (cull == Cull::front) glCullFace(GL_FRONT);
        if (cull == Cull::both) glCullFace(GL_FRONT_AND_BACK);
        if (winding == Winding::cw) glFrontFace(GL_CW);
        if (depth) glEnable(GL_DEPTH_TEST);

        // Look at the middle from the z axis
        const mat4 viewFromModel =
            lookAt(vec3(0, 0, zDist), vec3(0, 0, 0), vec3(0, 1, 0)) * rotateX(-spin.x) * rotateY(-spin.y);
        const mat4 clipFromView = perspective(50, frame.aspect(), 0.2, 100);
        frame.show("viewFromModel", viewFromModel);
        frame.show("clipFromView", clipFromView);

        // Draw
        program.use();
        program.set("viewFromModel", viewFromModel);
        program.set("clipFromView", clipFromView);
        cube.draw();
        crossOfAxes.draw();

        if (frame.readouts()) count(viewFromModel);
    }

    void count(const mat4& viewFromModel) {
        const vec3 eye = vec3(inverse(viewFromModel) * vec4(0, 0, 0, 1));  // in the cube's own coordinates
        int faces = 0;
        for (int axis = 0; axis < 3; ++axis) faces += (eye[axis] > 0.5) + (eye[axis] < -0.5);
        facing = faces;
        const TriangleCount triangles = countTriangles(cube);
        culled = double(triangles.culled);
        outside = double(triangles.outside);
        surviving = double(triangles.surviving);
    }
};

constexpr Declaration declaration{
    .name = "cube-cull",
    .sentence = "Back-face culling: on a closed solid, what faces away is never seen.",
    .lookFor = "Turn the cube with back and with none: the same picture. Then front: you look into the far half.",
    .chapter = "Stereo and hidden surfaces",
    .number = 7,
    .width = 600,
    .height = 600,
    .background = vec4(0.9, 1.0, 1.0, 1.0),
    .needs = {.depth = true},
    .presets =
        {
            {"turned", "Back faces are gone, and nothing is missing."},
            {"original",
             "The page's first picture: straight on one sees the blue face alone.",
             {{"spin-x", "0"}, {"spin-y", "0"}}},
            {"front-culled", "Without front faces one looks into the far half of the box.", {{"cull", "front"}}},
            {"no-depth-test",
             "Nothing culled and no depth test: the order in which the faces were written decides, and here hides the "
             "near ones.",
             {{"cull", "none"}, {"depth", "off"}, {"spin-y", "210"}}},
            {"eye-inside",
             "From inside no face shows its front: of twelve triangles 2 are culled, 10 are outside of the view, and 0 "
             "survive.",
             {{"z-dist", "0.3"}, {"spin-x", "0"}, {"spin-y", "0"}},
             {{"culled", 2, 2}, {"outside", 10, 10}, {"surviving", 0, 0}}},
        },
    .waste = {{"unused-buffer", "depth of 'cube-cull'", "the buffer stays when --depth-test switches the test off"},
              {"no-sample", "draw of 'cube'", "that faces are left out, or all of them, is the lesson"}},
};

const bool added = addDemo<CubeCull, declaration>();

}  // namespace

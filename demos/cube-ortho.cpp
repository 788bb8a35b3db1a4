// cube-ortho: a cube in a parallel projection, whose box of view is set by its depth, width and height.
//
// Claims (each is a test in tests/claims/cube-ortho.cpp):
// - [identity-and-mirror] The box from -1 to 1 mirrors depth; with near and far exchanged the matrix is the identity.
// - [far-hides-near] With near and far exchanged what is far hides what is near.
// - [distance-changes-nothing] Moved away with its box, the cube looks exactly the same.
// - [box-fills-window] Whatever the size of the box it fills the window, so the cube is drawn in inverse proportion.
// - [slab-is-a-hexagon] A thin slab across a diagonal leaves a ring of six sides, one of each face.
// - [minus-in-row-three] With near 1 and far 3 the matrix has -2 at the end of row 3; the slide's +2 misses the cube.
// - [nothing-is-refused] A box of no size, and one that misses every face of the cube, are refused.
#include <algorithm>
#include <cmath>

#include "mv/demo/demo.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/gl.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/spin.h"

using namespace mv;

namespace {

struct CubeOrtho final : Demo {
    Real depth{
        this, "depth", 2, {0.05, 3, Scale::logarithmic}, "how deep the box of view is, with the cube in its middle"};
    Real width{this, "width", 2, {0.05, 10, Scale::logarithmic}, "how wide the box of view is"};
    Real height{this, "height", 2, {0.05, 10, Scale::logarithmic}, "how high the box of view is"};
    Real distance{this, "distance", 0, {0, 5}, "how far in front of the eye the cube and the box are"};
    Toggle mirrorDepth{this, "mirror-depth", false, "exchange near and far"};
    Spin spin{this, 30, 40};

    Readout nearPlane{this, "near", "near, as ortho is told; negative is behind the eye"};
    Readout farPlane{this, "far", "far, as ortho is told"};
    Readout pixelsPerUnit{this, "pixels-per-unit", "how many pixels a length of 1 across gets"};

    Program program;
    Mesh cube;

    void init() override {
        program = Program("cube-ortho");
        cube = Mesh(colorCube(), "cube");
    }

    void check() const override {
        if (seesNoFace())
            throw Error("--depth", "must reach a face of the cube that is not seen edge on", depth.text());
    }

    void draw(const Frame& frame) override {
        glEnable(GL_DEPTH_TEST);
        frame.show("viewFromModel", viewFromModel());
        frame.show("clipFromView", clipFromView());
        program.use();
        program.set("viewFromModel", viewFromModel());
        program.set("clipFromView", clipFromView());
        cube.draw();

        nearPlane = near();
        farPlane = far();
        pixelsPerUnit = frame.width() / width;
    }

    // near and far are distances in front of the eye; the cube in their middle is at -distance
    double near() const { return mirrorDepth ? distance + depth / 2 : distance - depth / 2; }
    double far() const { return mirrorDepth ? distance - depth / 2 : distance + depth / 2; }
    mat4 clipFromView() const { return ortho(-width / 2, width / 2, -height / 2, height / 2, near(), far()); }
    mat4 viewFromModel() const { return translate(0, 0, -distance) * spin.turn(); }

    // A box with all its corners inside the cube shows none of its faces. A face seen edge on has no area and does not
    // count: the cube might as well go on without end there.
    bool seesNoFace() const {
        const mat4 m = viewFromModel();
        const auto corners = viewVolumeCorners(clipFromView() * m);
        return std::all_of(corners.begin(), corners.end(), [&](const vec3& corner) {
            bool inside = true;
            for (int axis = 0; axis < 3; ++axis) {
                const bool edgeOn = std::abs(m[axis][2]) < 1e-9;  // its image is perpendicular to the line of sight
                inside &= edgeOn || std::abs(corner[axis]) < 0.5;
            }
            return inside;
        });
    }
};

constexpr Declaration declaration{
    .name = "cube-ortho",
    .sentence = "A parallel projection: a box of view, and the matrix that makes it the cube from -1 to 1.",
    .lookFor = "Edges that are parallel stay parallel, and no distance makes the cube smaller; only the box does.",
    .chapter = "Viewing and projection",
    .number = 2,
    .width = 512,
    .height = 512,
    .background = vec4(1),
    .needs = {.depth = true},
    .presets =
        {
            {"turned",
             "Edges that are parallel on the cube are parallel in the picture, and none is shorter for being farther "
             "away."},
            {"original",
             "The page's first picture: straight on one sees the red face alone.",
             {{"spin-x", "0"}, {"spin-y", "0"}}},
            {"hexagon",
             "A thin box cuts the cube open along its diagonal: a regular hexagon, one side from each face.",
             {{"depth", "0.05"}, {"spin-x", "35.264"}, {"spin-y", "45"}}},
            {"wide-box", "A box twice as wide fills the same window, so the cube is half as wide.", {{"width", "4"}}},
            {"mirrored",
             "Near and far exchanged make the identity of the canonical box, and the far faces hide the near ones.",
             {{"mirror-depth", "on"}}},
        },
};

const bool added = addDemo<CubeOrtho, declaration>();

}  // namespace

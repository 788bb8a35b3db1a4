// cube-persp: a cube in perspective, whose pyramid of view is set by near, far, the field of view and the aspect.
//
// Claims (each is a test in tests/claims/cube-persp.cpp):
// - [same-as-frustum] perspective is frustum with the bounds shown, to the last bits.
// - [fovx-follows] The angle across follows from fov and aspect: tan(fovx/2) = aspect tan(fov/2).
// - [farther-is-smaller] A face is drawn in inverse proportion to its distance from the eye, at any field of view.
// - [near-opens-the-cube] Near beyond the front face opens the cube: the inside of the others is seen.
// - [near-costs-depth] The nearer near is, the coarser is depth at the cube; far hardly matters.
// - [near-below-far] Near not below far is refused with both, and so is a pyramid that shows no face.
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

struct CubePersp final : Demo {
    Real near{
        this, "near", 0.3, {0.01, 2.4, Scale::logarithmic}, "where the pyramid of view begins, in front of the eye"};
    Real far{this, "far", 3, {1.6, 5}, "where it ends"};
    Real fov{this, "fov", 65, {10, 120}, "the field of view upwards, fovy: the whole angle", "deg"};
    Real aspect{this, "aspect", 1, {0.5, 2}, "how many times as wide as high the pyramid is"};
    Spin spin{this, 30, 40};

    Readout left{this, "left", "the window on the near plane, as frustum is told"};
    Readout right{this, "right", "the window on the near plane"};
    Readout bottom{this, "bottom", "the window on the near plane"};
    Readout top{this, "top", "the window on the near plane"};
    Readout fovx{this, "fovx", "the field of view across: it follows from fov and aspect", "deg"};
    Readout difference{this, "difference", "largest difference between perspective's matrix and frustum's"};
    Readout depthStep{this, "depth-step", "the smallest step in depth at the cube's middle that 24 bits tell apart"};

    Program program;
    Mesh cube;

    void init() override {
        program = Program("cube-persp");
        cube = Mesh(colorCube(), "cube");
    }

    void check() const override {
        if (near >= far) throw Error("--near", "must be less than --far " + far.text(), near.text());
        // With all its corners inside the cube a pyramid shows none of the faces.
        const auto corners = viewVolumeCorners(clipFromView() * viewFromModel());
        if (std::all_of(corners.begin(), corners.end(), [](const vec3& corner) {
                return std::max({std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)}) < 0.5;
            }))
            throw Error("--near", "must leave a face of the cube in view, between it and --far " + far.text(),
                        near.text());
    }

    void draw(const Frame& frame) override {
        glEnable(GL_DEPTH_TEST);
        frame.show("viewFromModel", viewFromModel());
        frame.show("clipFromView", clipFromView());
        program.use();
        program.set("viewFromModel", viewFromModel());
        program.set("clipFromView", clipFromView());
        cube.draw();
        measure(frame);
    }

    mat4 clipFromView() const { return perspective(fov, aspect, near, far); }
    mat4 viewFromModel() const { return translate(0, 0, -2) * spin.turn(); }

    // The same pyramid said by frustum: the window that the field of view opens on the plane z = -near.
    void measure(const Frame& frame) {
        const FrustumBounds window = frustumBounds(fov, aspect, near, far);
        left = window.left;
        right = window.right;
        bottom = window.bottom;
        top = window.top;
        fovx = degrees(2 * std::atan(window.right / near));
        const mat4 fromBounds = frustum(window);
        frame.show("clipFromViewByFrustum", fromBounds);
        double most = 0;
        for (int column = 0; column < 4; ++column) {
            for (int row = 0; row < 4; ++row)
                most = std::max(most, std::abs(fromBounds[column][row] - clipFromView()[column][row]));
        }
        difference = most;
        // Depth in the buffer is f/(f-n) (1 - n/d) at the distance d, of slope f n/((f-n) d d); a step is 2^-24 of it.
        const double d = 2, slope = far * near / ((far - near) * d * d);
        depthStep = std::ldexp(1 / slope, -24);
    }
};

constexpr Declaration declaration{
    .name = "cube-persp",
    .sentence = "A perspective: a pyramid of view cut off at near and far, and the matrix that makes it a cube.",
    .lookFor =
        "Far edges are shorter than near ones. The field of view makes both smaller alike; near and far cut the "
        "cube open.",
    .chapter = "Viewing and projection",
    .number = 3,
    .width = 512,
    .height = 512,
    .background = vec4(1),
    .needs = {.depth = true},
    .presets =
        {
            {"turned", "Far edges are shorter than near ones, and the upright ones draw together."},
            {"original",
             "The page's first picture: straight on one sees the red face alone.",
             {{"spin-x", "0"}, {"spin-y", "0"}}},
            {"cut-open",
             "The near plane cuts off a corner of the cube; through the hole one sees its far faces from within.",
             {{"near", "1.5"}}},
            {"inside",
             "Without its front face: the back face is drawn smaller than the opening, by the ratio of their "
             "distances.",
             {{"near", "1.6"}, {"spin-x", "0"}, {"spin-y", "0"}}},
            {"wide-angle",
             "A wide field of view makes all of it smaller and bends nothing: the shape is as before.",
             {{"fov", "120"}}},
            {"aspect-2",
             "A pyramid twice as wide in a square window: the cube is half as wide, and fovx is 103.7 degrees, not "
             "130.",
             {{"aspect", "2"}},
             {{"fovx", 103.65, 103.75}}},
        },
};

const bool added = addDemo<CubePersp, declaration>();

}  // namespace

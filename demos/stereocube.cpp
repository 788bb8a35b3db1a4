// stereocube: a wire cube seen by two eyes, one picture in red and one in cyan for coloured glasses.
//
// Claims (each is a test in tests/claims/stereocube.cpp; the extreme one is X39 in docs/stability.md):
// - [left-is-red-channel] On white and on black, lines and masks alike, the left eye's picture is what changes red.
// - [left-is-left] The eye behind the red filter is the one on the left: near things move right in its picture.
// - [masks-lose-nothing] With masks each eye's picture is whole; with lines the nearer colour cuts gaps at crossings.
// - [toe-in-is-crooked] Toe-in moves corners up in one eye and down in the other; the less, the further the eyes meet.
// - [off-axis-is-level] Off-axis leaves no vertical parallax at all, whatever the convergence.
// - [zero-at-convergence] Off-axis, what is at the convergence distance has no parallax: the screen is there.
// - [cube-out-of-view] With nothing of the cube before the eyes the setting is refused.
#include "mv/demo/demo.h"
#include "mv/geometry/in_view.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/gl.h"
#include "mv/math/projection.h"
#include "mv/math/stereo.h"
#include "mv/math/transform.h"
#include "shared/spin.h"

using namespace mv;

namespace {

enum class Stereo { toeIn, offAxis };
enum class Colors { lines, masks };
enum class Paper { white, black };
enum class Eyes { both, left, right };

constexpr double fovy = 50, near = 0.2, far = 100;

// What one eye sees with: its place and direction, and its window.
struct Eye {
    mat4 eyeFromWorld, clipFromEye;
};

struct StereoCube final : Demo {
    Real eyeSep{this, "eye-sep", 0.2, {0, 1}, "distance between the eyes"};
    Real zDist{this, "z-dist", -3, {-10, 2}, "z of the eyes, which look along +z"};
    Real convergence{this, "convergence", 2, {0.25, 10}, "how far ahead of the eyes the screen is"};
    Spin spin{this, 20, 30, {1, -1}};
    Choice<Stereo> stereo{this,
                          "stereo",
                          Stereo::toeIn,
                          {{"toe-in", "both eyes look at one point"}, {"off-axis", "parallel, through one window"}},
                          "how the two eyes are aimed"};
    Choice<Colors> colors{this,
                          "colors",
                          Colors::lines,
                          {{"lines", "lines in red and in cyan"}, {"masks", "the red channel, then green and blue"}},
                          "how the two pictures become one"};
    Choice<Paper> background{this, "background", Paper::white, {{"white"}, {"black"}}, "what the lines are drawn on"};
    Choice<Eyes> eyes{this, "eyes", Eyes::both, {{"both"}, {"left"}, {"right"}}, "whose picture is drawn"};

    Readout vertical{this, "vertical-parallax", "largest difference in height between the two pictures of a corner",
                     "px"};
    Readout least{this, "parallax-min", "the right eye's picture of a corner is this much to the right, least", "px"};
    Readout most{this, "parallax-max", "the same, most; positive is behind the screen, negative before it", "px"};

    Program program;
    Mesh cube;

    StereoCube() {
        bindKeys(Key::down, Key::up, zDist, 0.1);
        bindWheel(zDist, 0.1);
    }

    void init() override {
        program = Program("stereocube");
        cube = Mesh(wireCube(), "cube");
    }

    void draw(const Frame& frame) override {
        const Eye left = eye(true, frame.aspect()), right = eye(false, frame.aspect());
        frame.show("leftFromWorld", left.eyeFromWorld);
        frame.show("clipFromLeft", left.clipFromEye);
        frame.show("rightFromWorld", right.eyeFromWorld);
        frame.show("clipFromRight", right.clipFromEye);
        frame.show("worldFromModel", worldFromModel());

        // Clear the picture before there is a mask: glClear, too, writes only what it lets through
        const bool white = background == Paper::white;
        const float paper = white ? 1.0F : 0.0F;
        glClearColor(paper, paper, paper, 1);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glEnable(GL_DEPTH_TEST);

        // The red filter is before the left eye and shows it the red channel. So the left picture is the one that
        // changes red: on white the cyan lines do, which take red away; on black the red ones.
        program.use();
        if (colors == Colors::lines) {
            const vec4 red(1, 0, 0, 1), cyan(0, 1, 1, 1);
            drawCube(white ? right : left, white ? Eyes::right : Eyes::left, red);
            drawCube(white ? left : right, white ? Eyes::left : Eyes::right, cyan);
        } else {
            const vec4 ink = white ? vec4(0, 0, 0, 1) : vec4(1);
            glColorMask(GL_TRUE, GL_FALSE, GL_FALSE, GL_TRUE);
            drawCube(left, Eyes::left, ink);
            glClear(GL_DEPTH_BUFFER_BIT);  // the eyes do not hide things from each other
            glColorMask(GL_FALSE, GL_TRUE, GL_TRUE, GL_TRUE);
            drawCube(right, Eyes::right, ink);
        }
        if (frame.readouts()) measure(frame, left, right);
    }

    void check() const override {
        for (const bool left : {true, false}) {
            if (eyes == (left ? Eyes::right : Eyes::left)) continue;  // closed
            const Eye seen = eye(left, 1);
            if (isInView(wireCube(), seen.clipFromEye * seen.eyeFromWorld * worldFromModel())) return;
        }
        throw Error("--z-dist", "must leave some of the cube in view of an eye", zDist.text());
    }

    void drawCube(const Eye& eye, Eyes which, const vec4& color) {
        if (eyes != Eyes::both && eyes != which) return;
        program.set("clipFromModel", eye.clipFromEye * eye.eyeFromWorld * worldFromModel());
        program.set("color", color);
        cube.draw();
    }

    mat4 worldFromModel() const { return spin.turn(); }

    // The eyes look along +z with y upwards, so their right is -x: the left eye is the one at positive x.
    Eye eye(bool left, double aspect) const {
        const double x = (left ? 0.5 : -0.5) * eyeSep;
        const vec3 place(x, 0, zDist), ahead(0, 0, zDist + convergence);
        if (stereo == Stereo::toeIn) {
            return {lookAt(place, ahead, vec3(0, 1, 0)), perspective(fovy, aspect, near, far)};
        }
        // Look straight ahead, and shift the window so that both eyes' windows are one at the convergence distance.
        FrustumBounds window = frustumBounds(fovy, aspect, near, far);
        const double shift = x * near / convergence;
        window.left += shift;
        window.right += shift;
        return {lookAt(place, ahead + vec3(x, 0, 0), vec3(0, 1, 0)), frustum(window)};
    }

    // Of the corners that are before both eyes' near planes
    void measure(const Frame& frame, const Eye& left, const Eye& right) {
        std::vector<vec3> corners;
        for (const fvec3& corner : wireCube().positions) corners.emplace_back(worldFromModel() * vec4(vec3(corner), 1));
        const auto parallax = parallaxOf(corners, left.clipFromEye * left.eyeFromWorld,
                                         right.clipFromEye * right.eyeFromWorld, frame.width(), frame.height(), near);
        if (!parallax) return;
        vertical = parallax->vertical;
        least = parallax->leastAcross;
        most = parallax->mostAcross;
    }
};

constexpr Declaration declaration{
    .name = "stereocube",
    .sentence = "Stereo with coloured glasses: two eyes, two pictures, one in red and one in cyan.",
    .lookFor = "With red glass left and cyan glass right the cube stands in the depth; without, a red and a cyan cube.",
    .chapter = "Stereo and hidden surfaces",
    .number = 6,
    .width = 600,
    .height = 600,
    .needs = {.depth = true},
    .presets =
        {
            {"turned",
             "With red glass left and cyan glass right it stands behind the screen; its horizontal edges are not "
             "level."},
            {"original",
             "The page's first picture: the cube straight on, a small square in a large one, each twice.",
             {{"spin-x", "0"}, {"spin-y", "0"}}},
            {"off-axis",
             "Both eyes look straight ahead, so that no corner moves up or down: vertical-parallax is 0. Each channel "
             "is one picture.",
             {{"stereo", "off-axis"}, {"colors", "masks"}},
             {{"vertical-parallax", 0, 1e-9}}},
            {"on-black",
             "On black each glass passes its own colour, so the two have changed places.",
             {{"stereo", "off-axis"}, {"background", "black"}}},
            {"before-the-screen",
             "The screen is behind the cube, which comes out of it.",
             {{"z-dist", "-2"}, {"convergence", "6"}, {"stereo", "off-axis"}}},
            {"squint",
             "Eyes far apart that meet near: the heights of the two pictures differ by many pixels.",
             {{"eye-sep", "0.5"}, {"convergence", "1"}}},
        },
};

const bool added = addDemo<StereoCube, declaration>();

}  // namespace

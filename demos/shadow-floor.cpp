// shadow-floor: a square, its shadow on a floor, and the light that throws it, to be walked round and moved about.
//
// Claims (each is a test in tests/claims/shadow-floor.cpp):
// - [cast-by-rays] The picture is what rays show: dark where the way from the floor to the light meets the square.
// - [marker-at-the-light] The yellow ball is where the light of this frame's shadow is, not where the last one's was.
// - [on-one-line] Each ray goes from the light through a corner of the square to the same corner of its shadow.
// - [no-fighting] From every distance no pixel of the floor comes through the shadow, which lies 0.0001 above it.
// - [floor-hides-from-below] From below the floor hides the shadow; it does not shine through.
// - [ends-with-the-floor] With crop on, no shadow lies where there is no floor; without it hangs in the air.
// - [moved-by-keys] The arrow keys move the light by 0.05, and the shadow by a third of that the other way.
// - [no-false-shadow] Light at the square's height, below it, in or below the floor: no shadow, and a sentence says so.
#include <array>
#include <cmath>

#include "mv/demo/demo.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/gl.h"
#include "mv/math/clip.h"
#include "mv/math/projection.h"
#include "mv/math/shadow.h"
#include "mv/math/shadow_caster.h"
#include "mv/math/transform.h"
#include "shared/light_rays.h"
#include "shared/spin.h"

using namespace mv;

namespace {

const vec4 planeOfShadow(0, 1, 0, 0);  // y = 0
constexpr double floorSide = 3;
const std::array<vec3, 4> corners{vec3(-0.5, 0.5, 0.5), vec3(0.5, 0.5, 0.5), vec3(0.5, 0.5, -0.5),
                                  vec3(-0.5, 0.5, -0.5)};  // of the square

struct ShadowFloor final : Demo {
    Real zDist{this, "z-dist", -4, {-10, 10}, "z of the eye at (1, 1, z), which looks at the origin"};
    Spin spin{this, 0, 0, {1, -1}};
    Real lightX{this, "light-x", 0, {-2, 2}, "x of the light, or of the middle of its circle"};
    Real lightZ{this, "light-z", 0, {-2, 2}, "z of the light, or of the middle of its circle"};
    Real lightHeight{this, "light-height", 2, {-1, 4}, "height of the light above the floor"};
    Toggle circle{this, "circle", true, "let the light go round on a circle of radius 1"};
    Toggle crop{this, "crop", true, "let the shadow end where the floor ends"};
    Toggle rays{this, "rays", true, "show the light's rays through the corners of the square"};

    Readout area{this, "shadow-area", "area of the whole shadow; the square's is 1"};
    Readout onFloor{this, "on-floor", "area of the part of it that falls on the floor, which is 9"};

    Program program;
    Mesh plate, ball;
    Drawing drawing;

    ShadowFloor() {
        bindWheel(zDist, 0.1);
        bindKeys(Key::left, Key::right, lightX, 0.05);
        bindKeys(Key::up, Key::down, lightZ, 0.05);
        bindHandle("light", {&lightX, &lightHeight, &lightZ}, [this](const FrameInfo& frame) {
            const Pane picture{0, 0, frame.width(), frame.height()};
            return pictureFromPane(picture, clipFromView(frame.aspect()) * viewFromWorld(), lightIn(frame));
        });
    }

    void init() override {
        program = Program("shadow-floor");
        plate = Mesh(positionsOnly(square()), "square");
        ball = Mesh(positionsOnly(sphere(0.04, 16, 8)), "light");
    }

    void draw(const Frame& frame) override {
        glEnable(GL_DEPTH_TEST);

        // The light first, so that all of this picture knows the same one
        const vec3 light = lightIn(frame);
        const mat4 viewFromWorld = this->viewFromWorld();
        const mat4 clipFromView = this->clipFromView(frame.aspect());
        frame.show("viewFromWorld", viewFromWorld);
        frame.show("clipFromView", clipFromView);
        program.use();
        program.set("clipFromView", clipFromView);
        program.set("crop", false);
        program.set("shadowFromModel", mat4(1));
        program.set("floorHalf", floorSide / 2);

        // Draw floor, square and light. The floor is the one that gives way to the shadow, by 0.0001 downwards: so the
        // shadow lies on its upper side and, seen from below, behind it. (glPolygonOffset moves towards the eye, and
        // would pull the shadow through the floor there.)
        const mat4 worldFromSquare = translate(0, 0.5, 0);
        drawMesh(plate, vec4(1, 0, 0, 1), viewFromWorld * worldFromSquare);
        drawMesh(plate, vec4(0.5, 0.5, 0.5, 1), viewFromWorld * translate(0, -0.0001, 0) * scale(floorSide));
        drawMesh(ball, vec4(1, 0.6, 0, 1), viewFromWorld * translate(light));

        // Draw the square flattened onto the floor. It is level, so either all of it casts a shadow or nothing does.
        const CasterVerdict verdict = judgeCaster("square", corners, vec4(light, 1), planeOfShadow);
        if (!verdict.sentence.empty()) frame.say(verdict.sentence);
        if (verdict.casts) drawShadow(frame, light, worldFromSquare);
    }

    vec3 lightIn(const FrameInfo& frame) const {
        const double theta = 0.02 * frame.index();
        const vec3 around = circle ? vec3(std::sin(theta), 0, std::cos(theta)) : vec3(0);
        return vec3(lightX, lightHeight, lightZ) + around;
    }
    // Looks at the origin, past which the world is turned.
    mat4 viewFromWorld() const { return lookAt(vec3(1, 1, zDist), vec3(0, 0, 0), vec3(0, 1, 0)) * spin.turn(); }
    static mat4 clipFromView(double aspect) { return perspective(60, aspect, 0.2, 100); }

    void drawShadow(const Frame& frame, const vec3& light, const mat4& worldFromSquare) {
        const mat4 shadowFromWorld = shadowProjection(vec4(light, 1), planeOfShadow);
        frame.show("shadowFromWorld", shadowFromWorld);
        program.set("shadowFromModel", shadowFromWorld * worldFromSquare);
        program.set("crop", crop);
        drawMesh(plate, vec4(0.2, 0, 0, 1), viewFromWorld() * shadowFromWorld * worldFromSquare);
        measure(shadowFromWorld);
        if (crop && *onFloor.value() == 0)
            frame.say("The shadow falls beside the floor: with crop off it is seen there.");
    }

    void drawMesh(const Mesh& mesh, const vec4& color, const mat4& viewFromModel) {
        program.set("viewFromModel", viewFromModel);
        program.set("color", color);
        mesh.draw();
    }

    void measure(const mat4& shadowFromWorld) {
        std::vector<vec4> shadow;
        shadow.reserve(corners.size());
        for (const vec3& corner : corners) shadow.push_back(shadowFromWorld * vec4(corner, 1));
        area = areaOf(shadow);
        // |x| <= half w and |z| <= half w, before the division
        constexpr double half = floorSide / 2;
        const std::array<vec4, 4> edges{vec4(1, 0, 0, half), vec4(-1, 0, 0, half), vec4(0, 0, 1, half),
                                        vec4(0, 0, -1, half)};
        onFloor = areaOf(clipPolygon(shadow, edges));
    }

    static double areaOf(const std::vector<vec4>& homogeneous) {
        std::vector<vec3> outline;
        outline.reserve(homogeneous.size());
        for (const vec4& corner : homogeneous) outline.push_back(vec3(corner) / corner.w);
        return polygonArea(outline);
    }

    // The light's rays through the corners.
    void annotate(const Frame& frame) override {
        if (!rays) return;
        drawing.begin(frame);
        drawLightRays(drawing, clipFromView(frame.aspect()) * viewFromWorld(), vec4(lightIn(frame), 1), corners,
                      {&planeOfShadow, 1});
        drawing.draw(frame);
    }
};

constexpr Declaration declaration{
    .name = "shadow-floor",
    .sentence = "A planar shadow on a floor, with the light that throws it in the picture.",
    .lookFor = "Light, corner of the square and corner of the shadow are on one line, from wherever you look.",
    .chapter = "Shadows",
    .number = 10,
    .width = 600,
    .height = 600,
    .animated = true,
    .background = vec4(0.95, 1, 1, 1),
    .needs = {.depth = true},
    .presets =
        {
            {"on-one-line", "Light, corner and the corner's shadow stay on one line while the light goes round."},
            {"original",
             "The page's first picture: the square, its shadow, and nothing between them.",
             {{"rays", "off"}}},
            {"over-the-edge",
             "The shadow ends where the floor ends.",
             {{"spin-y", "60"}, {"light-x", "-1"}, {"light-height", "1"}, {"circle", "off"}}},
            {"hanging",
             "The matrix knows a plane, which has no end: the shadow goes on in the air.",
             {{"spin-y", "60"}, {"light-x", "-1"}, {"light-height", "1"}, {"circle", "off"}, {"crop", "off"}}},
            {"from-above", "From above the whole shadow is seen.", {{"spin-x", "-40"}}},
            {"from-below", "From below there is none: the floor hides it.", {{"spin-x", "40"}}},
        },
    .waste = {{"outside-view", "draw of 'light'", "the light's ball is drawn sooner than asked for"},
              {"no-sample", "draw of 'square'", "that the floor hides it from below is the lesson"}},
};

const bool added = addDemo<ShadowFloor, declaration>();

}  // namespace

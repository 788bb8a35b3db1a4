// shadow: a square and its shadow on the plane y = 0, flattened by one matrix along the rays of a circling light.
//
// Claims (each is a test in tests/claims/shadow.cpp; the extreme ones are X11 to X14 in docs/stability.md):
// - [cast-by-rays] The picture is what rays show: dark where the way from the plane to the light meets the square.
// - [textbook-matrix] The matrix is the course's T(light) M T(-light) but for a factor; +1/y_l is on the wrong side.
// - [on-the-ray] Each corner's shadow lies on the plane y = 0, on the line through light and corner.
// - [above-the-light] What is above the light casts no shadow; unchecked, one appears opposite.
// - [at-the-lights-height] A square as high as the light casts none, and no number becomes NaN.
// - [below-the-floor] What is below the plane casts none; unchecked, its false shadow has w > 0 and is drawn.
// - [light-not-above] With the light in or below the plane there is no shadow, and a sentence says so.
// - [circles-by-index] In frame n the light is at angle 0.1 n, computed and not summed up.
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

using namespace mv;

namespace {

const vec4 planeOfShadow(0, 1, 0, 0);  // y = 0
const vec4 everywhere(0, 0, 0, 1);     // a half space that cuts nothing off
const mat4 viewFromWorld = lookAt(vec3(1, 1, 1), vec3(0, 0, 0), vec3(0, 1, 0));

struct Shadow final : Demo {
    Real lightHeight{this, "light-height", 2, {-1, 4}, "height of the light above the plane y = 0"};
    Real squareHeight{this, "square-height", 0.5, {-0.5, 1.5}, "height of the middle of the square"};
    Angle tilt{this, "tilt", 0, "turn of the square about its middle, so that one side rises"};
    Toggle rays{this, "rays", true, "show the light, and its rays through the corners of the square"};

    Readout leastW{this, "least-w",
                   "smallest w of the shadow's corners: how far the highest corner is below the light"};
    Readout area{this, "shadow-area", "area of the shadow; the square's is 1"};

    Program program;
    Mesh caster;
    Drawing drawing;

    Shadow() {
        bindKeys(Key::down, Key::up, lightHeight, 0.05);
        bindHandle("light", {&lightHeight}, [this](const FrameInfo& frame) {
            const Pane picture{0, 0, frame.width(), frame.height()};
            return pictureFromPane(picture, clipFromView(frame.aspect()) * viewFromWorld, vec3(lightIn(frame)));
        });
    }

    void init() override {
        program = Program("shadow");
        caster = Mesh(positionsOnly(square()), "square");
    }

    void draw(const Frame& frame) override {
        glEnable(GL_DEPTH_TEST);
        const vec4 light = lightIn(frame);

        // Draw the square
        const mat4 worldFromModel = this->worldFromModel();
        frame.show("worldFromModel", worldFromModel);
        frame.show("viewFromWorld", viewFromWorld);
        frame.show("clipFromView", clipFromView(frame.aspect()));
        program.use();
        program.set("worldFromModel", worldFromModel);
        program.set("viewFromModel", viewFromWorld * worldFromModel);
        program.set("clipFromView", clipFromView(frame.aspect()));
        program.set("abovePlane", everywhere);
        program.set("belowLight", everywhere);
        program.set("color", vec4(1, 0, 0, 1));
        caster.draw();

        // Draw it once more, flattened onto the plane: the shadow
        const auto corners = cornersOf(worldFromModel);
        const CasterVerdict verdict = judgeCaster("square", corners, light, planeOfShadow);
        if (!verdict.sentence.empty()) frame.say(verdict.sentence);
        if (verdict.casts) drawShadow(frame, light, worldFromModel);
        if (frame.readouts()) measure(corners, light, verdict.casts);
    }

    mat4 worldFromModel() const { return translate(0, squareHeight, 0) * rotateZ(tilt); }
    // It goes round.
    vec4 lightIn(const FrameInfo& frame) const {
        const double theta = 0.1 * frame.index();
        return {std::sin(theta), lightHeight, std::cos(theta), 1};
    }
    static mat4 clipFromView(double aspect) { return ortho(-2 * aspect, 2 * aspect, -2, 2, -4, 4); }

    void drawShadow(const Frame& frame, const vec4& light, const mat4& worldFromModel) {
        const mat4 shadowFromWorld = shadowProjection(light, planeOfShadow);
        frame.show("shadowFromWorld", shadowFromWorld);
        program.set("viewFromModel", viewFromWorld * shadowFromWorld * worldFromModel);

        // A false shadow must not be seen. GL itself drops what has w <= 0, but only in a parallel view is that the w
        // of the shadow: in perspective it is multiplied by the depth, and a false shadow behind the eye has w > 0
        // again. And w says nothing of what lies below the plane. So each pixel of the shadow carries the distances of
        // the point that casts it, and is discarded when that point is not between plane and light. They are linear on
        // the caster, and the interpolation undoes the division by w: it stays exact where GL cuts at w = 0.
        const auto [abovePlane, belowLight] = shadowCasterBounds(light, planeOfShadow);
        program.set("abovePlane", abovePlane);
        program.set("belowLight", belowLight);
        program.set("color", vec4(0, 0, 0, 1));
        caster.draw();
    }

    static std::array<vec3, 4> cornersOf(const mat4& worldFromModel) {
        std::array<vec3, 4> corners{vec3(-0.5, 0, 0.5), vec3(0.5, 0, 0.5), vec3(0.5, 0, -0.5), vec3(-0.5, 0, -0.5)};
        for (vec3& corner : corners) corner = vec3(worldFromModel * vec4(corner, 1));
        return corners;
    }

    void measure(const std::array<vec3, 4>& corners, const vec4& light, bool casts) {
        std::vector<vec4> outline;
        double highest = -HUGE_VAL;
        for (const vec3& corner : corners) {
            outline.emplace_back(corner, 1);
            highest = std::fmax(highest, corner.y);
        }
        leastW = lightHeight - highest;                 // row 4 of the matrix is (0, -1, 0, light-height)
        if (!casts || leastW.value() <= 1e-12) return;  // no shadow, or one that reaches to infinity
        const mat4 shadowFromWorld = shadowProjection(light, planeOfShadow);
        std::vector<vec3> shadow;
        for (const vec4& corner : clipPolygon(outline, shadowCasterBounds(light, planeOfShadow))) {
            const vec4 cast = shadowFromWorld * corner;
            shadow.push_back(vec3(cast) / cast.w);
        }
        area = polygonArea(shadow);
    }

    // The light's rays through the corners.
    void annotate(const Frame& frame) override {
        if (!rays) return;
        drawing.begin(frame);
        drawLightRays(drawing, clipFromView(frame.aspect()) * viewFromWorld, lightIn(frame),
                      cornersOf(worldFromModel()), {&planeOfShadow, 1});
        drawing.draw(frame);
    }
};

constexpr Declaration declaration{
    .name = "shadow",
    .sentence = "A planar shadow: the square drawn twice, the second time flattened by a matrix and in black.",
    .lookFor = "The shadow moves against the light, and grows as the light comes down towards the square.",
    .chapter = "Shadows",
    .number = 9,
    .width = 512,
    .height = 512,
    .animated = true,
    .background = vec4(1),
    .needs = {.depth = true},
    .presets =
        {
            {"on-one-line", "Each ray goes from the light through a corner to that corner of the shadow."},
            {"original", "The square once in red, and once more, flattened onto y = 0 and black.", {{"rays", "off"}}},
            {"low-light",
             "The light comes down, and the shadow grows to 5.06 times the square.",
             {{"light-height", "0.9"}},
             {{"shadow-area", 5.055, 5.065}}},
            {"through-the-plane", "Only the part above the plane casts.", {{"square-height", "0.2"}, {"tilt", "60"}}},
            {"light-between",
             "The light stands between lower and upper side: what is below it casts a shadow without end.",
             {{"light-height", "0.6"}, {"tilt", "50"}}},
        },
};

const bool added = addDemo<Shadow, declaration>();

}  // namespace

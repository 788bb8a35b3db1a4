// color-models: one colour in the RGB cube, HSL's double cone and HSV's cone, and two colours mixed in four ways.
#include "color-models.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "mv/gl/functions.h"
#include "mv/math/color.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

namespace mv::color_models {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    constexpr std::array ofShown{drawSolids, drawDiagram};  // in the order of Shows
    gpu.drawing.begin(frame);
    ofShown.at(std::size_t(s.shows))(gpu, s, frame);
    drawMarks(gpu.drawing, s, frame.inUnits());
    gpu.drawing.draw(frame);
    tell(s, frame);
}

// Draw the three solids side by side. The fragment shader computes the colour of a place.
void drawSolids(Gpu& gpu, const Settings& s, const Frame& frame) {
    const mat4 clip = clipFromModel(s, frame);
    frame.show("clipFromModel", clip);

    // Cut each solid at the colour's height. A cut at 2 is above every solid
    vec3 cuts(2);
    for (const Space solid : {cube, doubleCone, cone}) {
        if (s.solids.cut) cuts[solid] = placeOf(solid, s.from).y;
    }
    glEnable(GL_DEPTH_TEST);
    if (cuts != vec3(0)) {  // a cut at black leaves nothing of the solids
        gpu.program->use();
        gpu.program->set("clipFromModel", clip);
        gpu.program->set("rgbFromModel", glm::inverse(modelFromRgb()));
        gpu.program->set("cuts", cuts);
        for (const Space solid : {cube, doubleCone, cone}) {
            const Pane pane = paneOf(frame, solid);
            glViewport(pane.x, pane.y, pane.width, pane.height);
            gpu.program->set("model", static_cast<int>(solid));
            gpu.solids[static_cast<std::size_t>(solid)]->draw();
        }
        glViewport(0, 0, frame.width(), frame.height());
    }
    drawOverSolids(gpu.drawing, s, frame.inUnits());
    drawStrips(gpu.drawing, s, frame.inUnits());
}

// The place of a colour in each solid. The cube's diagonal, HSL's lightness and HSV's value are heights.
static vec3 placeInCube(const vec3& rgb) { return modelFromRgb() * rgb; }
static vec3 placeInDoubleCone(const vec3& rgb) {
    const Hsl hsl = hslFromRgb(rgb);
    return aroundAxis(hsl.hue, hsl.saturation * (1 - std::abs(2 * hsl.lightness - 1)), hsl.lightness);
}
static vec3 placeInCone(const vec3& rgb) {
    const Hsv hsv = hsvFromRgb(rgb);
    return aroundAxis(hsv.hue, hsv.saturation * hsv.value, hsv.value);
}
vec3 placeOf(Space solid, const vec3& rgb) {
    constexpr std::array ofSolid{placeInCube, placeInDoubleCone, placeInCone};  // in the order of Space
    return ofSolid.at(solid)(rgb);
}

// The place of a hue at a height, at the distance out / 2 from the axis.
vec3 aroundAxis(double hue, double out, double height) {
    return {out / 2 * std::cos(radians(hue)), height, -out / 2 * std::sin(radians(hue))};
}

// The cube stands on its black corner, with white above it. Red, green and blue rise by a third each, a third of a turn
// apart.
mat3 modelFromRgb() {
    mat3 m;
    for (int i = 0; i < 3; ++i) {
        const double turn = radians(120 * i), out = std::sqrt(2) / 3;
        m[i] = vec3(out * std::cos(turn), 1 / 3.0, -out * std::sin(turn));
    }
    return m;
}

mat4 clipFromModel(const Settings& s, const FrameInfo& frame) {
    const double aspect = paneOf(frame, cube).aspect(), narrow = std::min(aspect / 0.83, 1.0);
    return perspective(degrees(2 * std::atan(std::tan(radians(14)) / narrow)), aspect, 1, 6) *
           lookAt(vec3(0, 1.65, 2.8), vec3(0, 0.56, 0), vec3(0, 1, 0)) * translate(0, 0.5, 0) *
           (rotateX(s.solids.spinX) * rotateY(s.solids.spinY)) * translate(0, -0.5, 0);
}

// Mix the codes, or the light.
static vec3 mixedInSrgb(const vec3& a, const vec3& b, double t) { return glm::mix(a, b, t); }
static vec3 mixedInLinear(const vec3& a, const vec3& b, double t) {
    return srgbFromLinear(glm::mix(linearFromSrgb(a), linearFromSrgb(b), t));
}

// Mix in HSL. A grey has no hue and takes that of the other colour. The hue goes the shorter way round.
static vec3 mixedInHsl(const vec3& a, const vec3& b, double t) {
    Hsl from = hslFromRgb(a), to = hslFromRgb(b);
    if (from.saturation == 0) from.hue = to.hue;
    if (to.saturation == 0) to.hue = from.hue;
    const double turn = std::remainder(to.hue - from.hue, 360);
    return rgbFromHsl(Hsl{from.hue + t * turn, glm::mix(from.saturation, to.saturation, t),
                          glm::mix(from.lightness, to.lightness, t)});
}

// Mix in OKLab. The mixture may lie beyond the colours of a screen.
static vec3 mixedInOklab(const vec3& a, const vec3& b, double t) {
    const vec3 from = oklabFromLinear(linearFromSrgb(a)), to = oklabFromLinear(linearFromSrgb(b));
    return srgbFromLinear(linearFromOklab(glm::mix(from, to, t)));
}

// The colour at part t of the way from a to b.
vec3 mixed(Way way, const vec3& a, const vec3& b, double t) {
    constexpr std::array ofWay{mixedInSrgb, mixedInLinear, mixedInHsl, mixedInOklab};  // in the order of Way
    return ofWay.at(std::size_t(way))(a, b, t);
}

// The colours of a strip: the mixtures from one end to the other.
std::vector<vec3> strip(const Settings& s, Way way) {
    std::vector<vec3> colors;
    for (int i = 0; i <= s.solids.steps; ++i) colors.push_back(mixed(way, s.from, s.to, double(i) / s.solids.steps));
    return colors;
}

// Draw the colours within the curve of the spectrum. The fragment shader computes the brightest colour of a chromaticity.
void drawDiagram(Gpu& gpu, const Settings& s, const Frame& frame) {
    const ChromaticityDiagram diagram{s.diagram};
    const FrameInfo units = frame.inUnits();
    gpu.ofDiagram->use();
    gpu.ofDiagram->set("clipFromXy",
                       ChromaticityDiagram::clipFromPlace(diagram.plotIn(units), units) * diagram.placeFromXy());
    gpu.ofDiagram->set("linearFromXyz", linearFromXyz());
    gpu.spectrum->draw();
    diagram.draw(gpu.drawing, units);
    drawMixture(gpu.drawing, s, units);
}

}  // namespace mv::color_models

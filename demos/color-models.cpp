// color-models: one colour in the RGB cube, HSL's double cone and HSV's cone; two colours mixed in four ways; and the
// colours that sRGB holds, of those that are seen.
//
// Claims (each is a test in tests/claims/color-models.cpp):
// - [linked] Where a solid is dragged, the mark is under the pointer in it, and at the same colour in the others.
// - [right-at-each-pixel] What a pixel of a solid shows is the colour of its place, cut open or not.
// - [there-and-back] All 2^24 colours come back from HSL and HSV in float; through 8 bits a component is off by up to 4/255
//   in HSL and 3/255 in HSV, and no more.
// - [greys-have-no-hue] A grey gets hue 0; beside it any hue is found. To mix, it takes the hue of the other colour.
// - [even-in-oklab] The steps of the OKLab strip are even; those of the others are not, and linear light is brighter.
// - [a-third-is-shown] sRGB holds a third of the diagram of 1931, and of that of 1976.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/geometry/plot.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/drawing.h"
#include "mv/gl/gl.h"
#include "mv/gl/on_demand.h"
#include "mv/math/color.h"
#include "mv/math/color_difference.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/chromaticity_diagram.h"
#include "shared/spin.h"

using namespace mv;

namespace {

enum class Shows { solids, diagram };
enum class Way { srgb, linear, hsl, oklab };
enum class Written { numbers, hex };
enum Solid { cube, doubleCone, cone };

const vec4 ink(0.1, 0.1, 0.1, 1), faint(0.35, 0.35, 0.35, 1), white(1, 1, 1, 1);
const std::array<std::string, 4> wayNames{"sRGB", "linear", "HSL", "OKLab"};
const std::array<vec4, 4> wayColors{vec4(0.75, 0.2, 0.15, 1), vec4(0.1, 0.5, 0.2, 1), vec4(0.55, 0.25, 0.7, 1),
                                    vec4(0.1, 0.35, 0.75, 1)};

// The cube stands on black, and white is over it: red, green and blue rise by a third each, a third of a turn apart.
const mat3 modelFromRgb = [] {
    mat3 m;
    for (int i = 0; i < 3; ++i) {
        const double turn = radians(120 * i), out = std::sqrt(2) / 3;
        m[i] = vec3(out * std::cos(turn), 1 / 3.0, -out * std::sin(turn));
    }
    return m;
}();

// The place of hue and height, so far from the axis; the rim is at 1/2.
vec3 aroundAxis(double hue, double out, double height) {
    return {out / 2 * std::cos(radians(hue)), height, -out / 2 * std::sin(radians(hue))};
}

vec3 placeOf(int solid, const vec3& rgb) {
    if (solid == cube) return modelFromRgb * rgb;
    if (solid == doubleCone) {
        const Hsl hsl = hslFromRgb(rgb);
        return aroundAxis(hsl.hue, hsl.saturation * (1 - std::abs(2 * hsl.lightness - 1)), hsl.lightness);
    }
    const Hsv hsv = hsvFromRgb(rgb);
    return aroundAxis(hsv.hue, hsv.saturation * hsv.value, hsv.value);
}

// A grey takes the hue of the other colour, since it has none; then by the shorter way round.
Hsl mixedHsl(Hsl a, Hsl b, double t) {
    if (a.saturation == 0) a.hue = b.hue;
    if (b.saturation == 0) b.hue = a.hue;
    const double turn = std::remainder(b.hue - a.hue, 360);
    return {a.hue + t * turn, glm::mix(a.saturation, b.saturation, t), glm::mix(a.lightness, b.lightness, t)};
}

// Part t of the way from a to b, all of them srgb. By OKLab it may lie beyond what a screen shows.
vec3 mixed(Way way, const vec3& a, const vec3& b, double t) {
    if (way == Way::srgb) return glm::mix(a, b, t);
    if (way == Way::hsl) return rgbFromHsl(mixedHsl(hslFromRgb(a), hslFromRgb(b), t));
    const vec3 first = linearFromSrgb(a), second = linearFromSrgb(b);
    if (way == Way::linear) return srgbFromLinear(glm::mix(first, second, t));
    return srgbFromLinear(linearFromOklab(glm::mix(oklabFromLinear(first), oklabFromLinear(second), t)));
}

vec3 asSeen(const vec3& srgb) { return oklabFromLinear(linearFromSrgb(srgb)); }
vec3 labOf(const vec3& srgb) { return labFromLinear(linearFromSrgb(srgb)); }
vec3 shownAs(const vec3& srgb) { return glm::clamp(srgb, 0.0, 1.0); }
// By more than OKLab's there and back rounds.
bool isBeyond(const vec3& srgb) { return glm::distance(srgb, shownAs(srgb)) > 1e-9; }

struct ColorModels final : Demo {
    Choice<Shows> shows{this,
                        "scene",
                        Shows::solids,
                        {{"solids", "the three solids, and strips below"}, {"diagram", "the chromaticity diagram"}},
                        "what is shown"};
    Real red{this, "red", 1, {0, 1}, "of the colour, as sRGB"};
    Real green{this, "green", 0.55, {0, 1}, "of the colour"};
    Real blue{this, "blue", 0, {0, 1}, "of the colour"};
    Real toRed{this, "to-red", 0, {0, 1}, "of the second colour, which it is mixed with"};
    Real toGreen{this, "to-green", 0.35, {0, 1}, "of the second colour"};
    Real toBlue{this, "to-blue", 1, {0, 1}, "of the second colour"};
    Choice<Way> way{this,
                    "mix",
                    Way::srgb,
                    {{"srgb", "the components as the screen is given them"},
                     {"linear", "light itself"},
                     {"hsl", "hue, saturation and lightness, the shorter way round"},
                     {"oklab", "evenly as seen"}},
                    "whose way from colour to colour is drawn"};
    Whole steps{this, "steps", 12, {1, 1024}, "from one end of a strip to the other"};
    Toggle cut{this, "cut", false, "cut the solids open at the colour's height"};
    Choice<Diagram> diagram{this,
                            "diagram",
                            Diagram::xy,
                            {{"xy", "of 1931"}, {"uv", "u'v' of 1976, nearer to distances as seen"}},
                            "which chromaticity diagram"};
    Spin spin{this, 0, -60};
    Choice<Written> written{this,
                            "written",
                            Written::numbers,
                            {{"numbers", "from 0 to 1"}, {"hex", "as style sheets do, the second colour too"}},
                            "how the colour is written above the cube"};

    Readout hue{this, "hue", "of the colour; greys have none", "deg"};
    Readout lightness{this, "lightness", "of the colour, as seen: L of OKLab"};
    std::array<Readout, 4> uneven{Readout{this, "uneven-srgb", "steps' deviation from their mean (rms), of it", "%"},
                                  Readout{this, "uneven-linear", "the same, mixed as light", "%"},
                                  Readout{this, "uneven-hsl", "the same, mixed in HSL", "%"},
                                  Readout{this, "uneven-oklab", "the same, mixed in OKLab", "%"}};
    Readout beyond{this, "beyond", "colours of the OKLab strip that no sRGB screen shows"};
    Readout partOfDiagram{this, "part-of-diagram", "of the diagram that sRGB holds", "%"};
    Readout uneven2000{this, "uneven-ciede2000", "steps' deviation by CIEDE2000, mixed as drawn", "%"};
    Readout difference{this, "ciede2000", "how different the two colours are seen; 1 is the least that is noticed"};
    Readout contrastOf{this, "contrast", "of letters of one colour on the other, 1 to 21; 4.5 is asked for"};
    Readout labLightness{this, "lab-l", "of the colour: lightness L* of CIELAB, 0 to 100"};
    Readout labA{this, "lab-a", "the same: a*, from green to red"};
    Readout labB{this, "lab-b", "the same: b*, from blue to yellow"};

    OnDemand<Program> program{"color-models"}, ofDiagram{"color-models", "diagram"};
    std::array<OnDemand<Mesh>, 3> solids{OnDemand<Mesh>(solidMesh(cube), "cube"),
                                         OnDemand<Mesh>(solidMesh(doubleCone), "double cone"),
                                         OnDemand<Mesh>(solidMesh(cone), "cone")};
    OnDemand<Mesh> spectrum{spectrumMesh(), "spectrum"};
    Drawing drawing;

    ColorModels() {
        bindKeys(Key::left, Key::right, steps, 1);
        static const std::array<std::string, 4> names{"cube", "double cone", "cone", "diagram"};
        for (std::size_t i = 0; i < 4; ++i) {
            bindHandle("color in the " + names.at(i), {&red, &green, &blue},
                       [this, i](const FrameInfo& frame) { return markIn(frame, static_cast<int>(i), from()); });
            bindHandle("second color in the " + names.at(i), {&toRed, &toGreen, &toBlue},
                       [this, i](const FrameInfo& frame) { return markIn(frame, static_cast<int>(i), to()); });
        }
        const auto isSolids = [this] { return shows == Shows::solids; };
        for (Knob* knob : std::vector<Knob*>{&steps, &cut, &spin.x, &spin.y, &written}) {
            knob->onlyWhen(isSolids, "the diagram has neither solids nor strips");
        }
        diagram.onlyWhen([this] { return shows == Shows::diagram; }, "no diagram is shown");
    }

    void init() override {}

    vec3 from() const { return {red, green, blue}; }
    vec3 to() const { return {toRed, toGreen, toBlue}; }

    // Where the colour is in the picture: in a solid, or in the diagram, which is the fourth.
    std::optional<vec2> markIn(const FrameInfo& frame, int where, const vec3& color) const {
        if ((shows == Shows::diagram) != (where == 3)) return std::nullopt;
        if (where < 3) return pictureFromPane(paneOf(frame, where), clipFromModel(frame), placeOf(where, color));
        const auto at = figure().placeOf(color);
        return at ? std::optional(figure().plotIn(frame).pixel(*at)) : std::nullopt;
    }

    void draw(const Frame& frame) override {
        drawing.begin(frame);
        if (shows == Shows::solids) {
            drawSolids(frame);
            drawStrips(frame);
        } else {
            drawDiagram(frame);
        }
        drawMarks(frame);
        drawing.draw(frame);
        report(frame);
    }

    void drawMarks(const Frame& frame) {
        drawing.in({0, 0, frame.width(), frame.height()});
        for (int where = 0; where < 4; ++where) {
            for (const auto& [color, size] : {std::pair(to(), 13), {from(), 19}}) {
                const auto at = markIn(frame, where, color);
                if (!at) continue;
                drawing.point(*at, size, ink);
                drawing.point(*at, size - 2, white);
                drawing.point(*at, size - 6, vec4(color, 1));
            }
        }
    }

    // ---- the solids

    static Pane paneOf(const FrameInfo& frame, int solid) {
        const int low = frame.height() * 2 / 5, width = std::max(frame.width() / 3, 1);
        return {solid * width, low, width, frame.height() - low};
    }
    static double unit(const FrameInfo& frame) { return std::min(frame.width() / 960.0, frame.height() / 640.0); }

    // And in the same mesh the square that covers its cut.
    static MeshData solidMesh(int solid) {
        MeshData shape = solid == cube ? box(vec3(0), vec3(1))
                                       : lathe(std::vector<vec2>{{0, 0}, {0.5, solid == cone ? 1 : 0.5}, {0, 1}}, 96);
        shape.normals.clear();
        shape.texCoords.assign(shape.positions.size(), fvec2(0));
        if (solid == cube) {
            for (fvec3& position : shape.positions) position = fvec3(modelFromRgb * vec3(position));
            for (std::uint32_t i = 0; i < shape.positions.size(); ++i) shape.indices.push_back(i);
        }
        for (const fvec3& corner : square().positions) {
            shape.indices.push_back(static_cast<std::uint32_t>(shape.positions.size()));
            shape.positions.push_back(corner);
            shape.texCoords.emplace_back(1, 0);
        }
        return shape;
    }

    mat4 clipFromModel(const FrameInfo& frame) const {
        const double aspect = paneOf(frame, 0).aspect(), narrow = std::min(aspect / 0.83, 1.0);
        return perspective(degrees(2 * std::atan(std::tan(radians(14)) / narrow)), aspect, 1, 6) *
               lookAt(vec3(0, 1.65, 2.8), vec3(0, 0.56, 0), vec3(0, 1, 0)) * translate(0, 0.5, 0) * spin.turn() *
               translate(0, -0.5, 0);
    }

    void drawSolids(const Frame& frame) {
        const mat4 clip = clipFromModel(frame);
        frame.show("clipFromModel", clip);
        vec3 cuts(2);  // above all
        for (int solid = 0; solid < 3 && cut; ++solid) cuts[solid] = placeOf(solid, from()).y;
        glEnable(GL_DEPTH_TEST);
        if (cuts != vec3(0)) {  // cut at black, nothing is left of any
            program->use();
            program->set("clipFromModel", clip);
            program->set("rgbFromModel", inverse(modelFromRgb));
            program->set("cuts", cuts);
            for (int solid = 0; solid < 3; ++solid) {
                const Pane pane = paneOf(frame, solid);
                glViewport(pane.x, pane.y, pane.width, pane.height);
                program->set("model", solid);
                solids[static_cast<std::size_t>(solid)]->draw();
            }
            glViewport(0, 0, frame.width(), frame.height());
        }
        for (int solid = 0; solid < 3; ++solid) {
            const Pane pane = paneOf(frame, solid);
            drawing.in(pane);
            drawOutline(solid, clip);
            drawWay(solid, pane, clip);
            label(frame, solid, pane);
        }
    }

    // The edges of the whole solid, and the greys.
    void drawOutline(int solid, const mat4& clip) {
        const Stroke stroke{vec4(0.3, 0.3, 0.3, 0.6), 1};
        drawing.edge(clip, vec3(0), vec3(0, 1, 0), stroke);
        if (solid == cube) {
            const MeshData edges = wireCube();
            for (std::size_t i = 0; i < edges.positions.size(); i += 2) {
                drawing.edge(clip, modelFromRgb * (vec3(edges.positions[i]) + 0.5),
                             modelFromRgb * (vec3(edges.positions[i + 1]) + 0.5), stroke);
            }
            return;
        }
        const double height = solid == doubleCone ? 0.5 : 1;
        for (int i = 0; i < 96; ++i) {
            drawing.edge(clip, aroundAxis(i * 3.75, 1, height), aroundAxis((i + 1) * 3.75, 1, height), stroke);
        }
    }

    // The way of the mix, whatever is before it.
    void drawWay(int solid, const Pane& pane, const mat4& clip) {
        const Pane whole{0, 0, pane.width, pane.height};
        std::vector<vec2> line;
        for (int i = 0; i <= 64; ++i) {
            const vec3 color = shownAs(mixed(way, from(), to(), i / 64.0));
            if (const auto pixel = pictureFromPane(whole, clip, placeOf(solid, color))) line.push_back(*pixel);
        }
        drawing.line(line, {ink, 4});
        drawing.line(line, {white, 2});
    }

    void label(const Frame& frame, int solid, const Pane& pane) {
        const Hsl hsl = hslFromRgb(from());
        const Hsv hsv = hsvFromRgb(from());
        const std::string turn = hsl.saturation == 0 ? "no hue" : rounded("%.0f°", hsl.hue);
        const auto numbers = [](const std::string& first, double second, double third) {
            return first + rounded("  %.2f", second) + rounded("  %.2f", third);
        };
        const bool isCube = solid == cube, isDouble = solid == doubleCone;
        const double top = pane.height / unit(frame);
        words(frame, {12, top - 8}, isCube ? "RGB: cube" : isDouble ? "HSL: double cone" : "HSV: cone", ink, 18);
        words(frame, {12, top - 32},
              isCube && written == Written::hex ? hexFromSrgb(from()) + "  to  " + hexFromSrgb(to())
              : isCube                          ? numbers(rounded("%.2f", red), green, blue)
              : isDouble                        ? numbers(turn, hsl.saturation, hsl.lightness)
                                                : numbers(turn, hsv.saturation, hsv.value),
              faint, 15);
    }

    // In units of 1/640 of the picture's height, or 1/960 of its width, from the lower left corner.
    void words(const Frame& frame, const vec2& at, const std::string& text, const vec4& color, double size) {
        const int pixels = std::max(6, static_cast<int>(size * unit(frame)));
        drawing.text(at * unit(frame), text, {pixels, color, vec4(0)});
    }

    // ---- the strips

    std::vector<vec3> strip(Way by) const {
        std::vector<vec3> colors;
        for (int i = 0; i <= steps; ++i) colors.push_back(mixed(by, from(), to(), double(i) / steps));
        return colors;
    }
    // The lengths of a strip's steps by their mean, in the space and by the distance given; none where all are 0.
    template <class Space, class Distance>
    static std::vector<double> stepsBy(const std::vector<vec3>& colors, const Space& inSpace,
                                       const Distance& distance) {
        std::vector<double> lengths;
        double sum = 0;
        vec3 last = inSpace(colors.front());
        for (std::size_t i = 1; i < colors.size(); ++i) {
            const vec3 next = inSpace(colors[i]);
            lengths.push_back(distance(last, next));
            sum += lengths.back();
            last = next;
        }
        if (sum == 0) return {};
        for (double& length : lengths) length *= double(lengths.size()) / sum;
        return lengths;
    }
    // As seen.
    static std::vector<double> stepsOf(const std::vector<vec3>& colors) {
        return stepsBy(colors, asSeen, [](const vec3& a, const vec3& b) { return glm::distance(a, b); });
    }
    static std::optional<double> unevenness(const std::vector<double>& lengths) {
        if (lengths.empty()) return std::nullopt;
        double squares = 0;
        for (const double length : lengths) squares += (length - 1) * (length - 1);
        return 100 * std::sqrt(squares / double(lengths.size()));
    }

    void drawStrips(const Frame& frame) {
        const double u = unit(frame);
        drawing.in({0, 0, frame.width(), std::max(frame.height() * 2 / 5, 1)});
        const double left = 76, right = 520, height = 46;
        const Box box{vec2(660, 52) * u, vec2(940, 236) * u};
        const Plot plot{box, {0, 1, "part of the way"}, {0, 1, "lightness as seen"}};
        words(frame, {left, 246}, "mixed in", faint, 14);
        words(frame, {right + 8, 246}, "uneven by", faint, 14);
        for (std::size_t i = 0; i < 4; ++i) {
            const std::vector<vec3> colors = strip(static_cast<Way>(i));
            const double top = 226 - 54 * double(i), wide = (right - left) / double(colors.size());
            std::vector<vec2> curve;
            for (std::size_t k = 0; k < colors.size(); ++k) {
                // From whole pixel to whole pixel, so that nothing shines through between two
                const vec2 low = glm::round(vec2(left + wide * double(k), top - height) * u);
                const vec2 high = glm::round(vec2(left + wide * double(k + 1), top) * u);
                drawing.fill({low, high}, vec4(shownAs(colors[k]), 1));
                if (isBeyond(colors[k])) drawing.fill({low, {high.x, low.y + 4 * u}}, ink);
                curve.emplace_back(double(k) / steps, asSeen(colors[k]).x);
            }
            words(frame, {12, top - 12}, wayNames.at(i), wayColors.at(i), 16);
            if (const auto percent = unevenness(stepsOf(colors))) {
                words(frame, {right + 10, top - 12}, rounded("%.0f %%", *percent), wayColors.at(i), 16);
            }
            drawing.curve(plot, curve, {wayColors.at(i), 2});
        }
        drawing.axes(plot);
    }

    // For the study: the lengths of the steps, by their mean.
    std::vector<double> values() const override { return stepsOf(strip(way)); }

    // ---- the diagram

    static MeshData spectrumMesh() {
        MeshData mesh{.primitive = Primitive::triangleFan};
        for (const vec2& xy : spectralLocus()) mesh.positions.emplace_back(xy, 0);
        return mesh;
    }
    ChromaticityDiagram figure() const { return {diagram}; }

    void drawDiagram(const Frame& frame) {
        const Plot plot = figure().plotIn(frame);
        ofDiagram->use();
        ofDiagram->set("clipFromXy", ChromaticityDiagram::clipFromPlace(plot, frame) * figure().placeFromXy());
        ofDiagram->set("linearFromXyz", linearFromXyz());
        spectrum->draw();

        std::vector<vec2> line;
        for (int i = 0; i <= 64; ++i) {
            if (const auto at = figure().placeOf(mixed(way, from(), to(), i / 64.0))) line.push_back(*at);
        }
        figure().draw(drawing, frame);
        drawing.curve(plot, line, {ink, 4});
        drawing.curve(plot, line, {white, 2});
    }

    // ---- readouts

    void report(const Frame& frame) {
        const Hsl hsl = hslFromRgb(from());
        if (hsl.saturation == 0) {
            frame.say("The colour is a grey: it has no hue.");
        } else {
            hue = hsl.hue;
        }
        lightness = asSeen(from()).x;
        for (std::size_t i = 0; i < 4; ++i) {
            if (const auto percent = unevenness(stepsOf(strip(static_cast<Way>(i))))) uneven.at(i) = *percent;
        }
        if (const auto percent = unevenness(stepsBy(strip(way), labOf, colorDifference))) uneven2000 = *percent;
        const vec3 lab = labOf(from());
        labLightness = lab.x;
        labA = lab.y;
        labB = lab.z;
        difference = colorDifference(lab, labOf(to()));
        contrastOf = contrast(linearFromSrgb(from()), linearFromSrgb(to()));
        const std::vector<vec3> even = strip(Way::oklab);
        beyond = double(std::count_if(even.begin(), even.end(), isBeyond));
        if (*beyond.value() > 0 && shows == Shows::solids) {
            frame.say("OKLab mixes colours that no sRGB screen shows: underlined, they are cut off.");
        }
        partOfDiagram = figure().heldBySrgb();
    }
};

constexpr Declaration declaration{
    .name = "color-models",
    .sentence = "RGB's cube, HSL's and HSV's cones, four ways to mix two colours, and the part of all colours in sRGB.",
    .lookFor =
        "Drag the mark in one solid: it moves in all. The strip that looks even is the one that is mixed in OKLab.",
    .chapter = "Light, colour and texture",
    .number = 19,
    .width = 960,
    .height = 640,
    .background = vec4(1, 1, 1, 1),
    .needs = {.depth = true},
    .presets =
        {
            {"orange-to-blue",
             "In sRGB the middle is a dull grey, HSL goes round through red; the steps of the OKLab strip look even."},
            {"cut-open",
             "All three cut at the colour's height: of one intensity, one lightness and one value.",
             {{"cut", "on"}, {"red", "0.8"}, {"green", "0.3"}, {"blue", "0.4"}}},
            {"grey",
             "A grey has no hue: in HSL it takes that of the other colour, and is on the axis of all three solids.",
             {{"red", "0.5"}, {"green", "0.5"}, {"blue", "0.5"}, {"mix", "hsl"}}},
            {"yellow-to-blue",
             "The OKLab strip is even, but no sRGB screen shows those of its colours that are underlined.",
             {{"red", "1"}, {"green", "1"}, {"to-green", "0"}, {"mix", "oklab"}},
             {{"uneven-oklab", 0, 1e-9}, {"beyond", 1, 12}}},
            {"diagram",
             "Nearly all colours that are seen? A third of the diagram; mixed light goes straight through it.",
             {{"scene", "diagram"}, {"mix", "linear"}},
             {{"part-of-diagram", 33, 34}}},
            {"diagram-of-1976",
             "Here green has less room and blue more, and the triangle's part is a third again.",
             {{"scene", "diagram"}, {"diagram", "uv"}, {"mix", "linear"}},
             {{"part-of-diagram", 33, 34}}},
        },
    .waste = {{"unused-buffer", "depth of 'color-models'", "the diagram is flat, the solids are not"}},
};

const bool added = addDemo<ColorModels, declaration>();

}  // namespace

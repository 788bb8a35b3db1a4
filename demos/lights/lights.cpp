// lights: ambient, directional, point and spot, up to eight of them, on surfaces that only scatter.
//
// Claims (each is a test in tests/claims/lights.cpp; X44 and X45 are in docs/stability.md):
// - [adds] Linear light adds: several lights give the sum of what each gives alone. Numbers that are not encoded do not add
//   on the screen, where encoded ones are expected.
// - [falloff-exponents] A constant, linear or quadratic term alone falls as d^0, d^-1 or d^-2, read from the picture.
// - [ambient-is-everywhere] Ambient light is the same on every surface, whichever way it faces.
// - [directional-is-far] Directional light does not depend on the place, only on the way a surface faces.
// - [behind-lights-nothing] A light behind a surface lights nothing of it.
// - [cone] A spot lights nothing outside of its outer cone, as much as a point within the inner one, and its edge has no
//   step where the inner one is smaller.
// - [finite] A lamp on a surface, and a spot with one cone, give finite light.
// - [off-costs-nothing] A light that is off, or cannot reach what is seen, is not sent, and the picture is the same.
// - [as-in-double] The shader gives what the same formulas give in double.
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/gl/drawing.h"
#include "mv/gl/gl.h"
#include "mv/gl/scene_meshes.h"
#include "mv/math/color.h"
#include "mv/math/transform.h"
#include "shared/lamp_light.h"
#include "shared/lamp_reach.h"
#include "shared/scenes.h"

using namespace mv;

namespace {

enum class Kind { off, ambient, directional, point, spot };
enum class Ask { reaching, all };
using Kinds = std::vector<std::unique_ptr<Choice<Kind>>>;

const std::array<vec3, 8> hues{{{1, 1, 1},
                                {1, 0.92, 0.75},
                                {1, 0.75, 0.5},
                                {0.55, 0.75, 1},
                                {1, 0.45, 0.4},
                                {0.5, 1, 0.5},
                                {0.5, 0.6, 1},
                                {1, 0.55, 0.9}}};
constexpr double ambientShare = 0.06, sunShare = 0.25;
const vec3 belowTheMiddle(0.35, -1, -0.4);  // where directional lights shine to
const vec4 ink(0.1, 0.1, 0.1, 1), grey(0.62, 0.62, 0.62, 1), blue(0.1, 0.35, 0.75, 1), red(0.75, 0.15, 0.1, 1);

struct Lights final : Demo {
    Kinds kinds = kindKnobs(this);
    Points places{this,
                  "places",
                  {{0, 0}, {-0.75, 0.9}, {-0.35, 0.6}, {1.7, 0.6}, {-1.6, -0.9}, {2.2, -0.9}, {-1.6, 1.2}, {1.2, 1.5}},
                  {.low = vec2(-2, -1.5), .high = vec2(2.5, 2), .least = 8, .most = 8, .grid = 0.05},
                  "x and z of the lights; an ambient one has none"};
    Real height{this, "height", 1.3, {0, 3}, "y of the lights", "m"};
    Real power{this, "power", 1.5, {0.01, 100, Scale::logarithmic}, "light of a lamp at 1 m, by 1/d^2"};
    Real constant{this, "constant", 0, {0, 4}, "term of the falloff that is the same at any distance"};
    Real linear{this, "linear", 0, {0, 4}, "term that grows with the distance"};
    Real quadratic{this, "quadratic", 1, {0, 4}, "term that grows with its square"};
    Real size{this, "lamp-size", 0.05, {0.01, 0.5}, "radius of a lamp", "m"};
    Real cutOff{this,
                "cut-off",
                0,
                {1e-4, 0.1, Scale::logarithmic, true},
                "a lamp ends where it gives less than this; 0: nowhere"};
    Real inner{this, "inner", 18, {0, 80}, "angle from a spot's axis up to which it shines fully", "deg"};
    Real outer{this, "outer", 26, {1, 80}, "angle from which on it does not shine", "deg"};
    Real aimX{this, "aim-x", 1.1, {-2, 2.5}, "x of the place on the floor that spots aim at", "m"};
    Real aimZ{this, "aim-z", -0.2, {-1.5, 2}, "z of that place", "m"};
    Real markX{this, "mark-x", -0.2, {-2, 2.5}, "x of a place on the floor whose light is told", "m"};
    Real markZ{this, "mark-z", 1.1, {-1.5, 2}, "z of that place", "m"};
    Choice<Ask> ask{this,
                    "ask",
                    Ask::reaching,
                    {{"reaching", "those that are on, and whose light comes to something that is seen"},
                     {"all", "all but ambient ones, whatever they give"}},
                    "which lights the shader asks for each pixel"};
    Toggle encode{this, "encode", true, "add linear light and encode the sum; off: take stored numbers for light"};
    Toggle logLog{this, "log-log", false, "both axes of the graph logarithmic"};

    Readout sent{this, "lights-sent", "lights that the shader asks for each pixel"};
    Readout mark{this, "mark", "light that arrives at the mark, mean of red, green and blue"};
    Readout stored{this, "mark-stored", "the number that sRGB has for that on a white surface, at most 255"};

    Program program;
    Scene now;
    SceneMeshes meshes;
    Drawing drawing;

    Lights() {
        bindHandle("light", places, [this](const FrameInfo& frame, const vec2& place) -> std::optional<vec2> {
            for (std::size_t i = 0; i < places.size(); ++i) {
                if (places[i] == place && hasPlace(i)) return inPicture(frame, placeOf(i));
            }
            return std::nullopt;
        });
        bindHandle("aim", {&aimX, &aimZ}, [this](const FrameInfo& frame) -> std::optional<vec2> {
            if (!isOn(Kind::spot)) return std::nullopt;
            return inPicture(frame, aim());
        });
        bindHandle("mark", {&markX, &markZ}, [this](const FrameInfo& frame) { return inPicture(frame, marked()); });
        for (Knob* knob : std::vector<Knob*>{&inner, &outer, &aimX, &aimZ}) {
            knob->onlyWhen([this] { return isOn(Kind::spot); }, "no spot is on");
        }
        for (Knob* knob : std::vector<Knob*>{&places, &height}) {
            knob->onlyWhen([this] { return isOn(Kind::directional) || isOn(Kind::point) || isOn(Kind::spot); },
                           "no light that has a place is on");
        }
    }

    void init() override { program = Program("lights"); }

    void draw(const Frame& frame) override {
        now = scene(frame);
        meshes.follow(now);
        const Pane pane = frame.measuring() ? Pane{0, 0, frame.width(), frame.height()} : paneOf(frame);
        glViewport(pane.x, pane.y, pane.width, pane.height);
        glEnable(GL_DEPTH_TEST);
        program.use();

        // What all lights have in common
        program.set("ambient", ambient());
        program.set("falloff", vec3(constant, linear, quadratic));
        program.set("size", size);
        program.set("reach", std::isfinite(reach()) ? reach() : 0.0);
        program.set("encode", encode);
        if (isOn(Kind::spot)) {
            program.set("innerCosine", std::cos(radians(inner)));
            program.set("outerCosine", std::cos(radians(outer)));
        }

        // The lights that are on and that reach, one behind the other; ambient ones are in the sum above
        int count = 0;
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            if (kind(i) == Kind::ambient || (ask == Ask::reaching && !reaches(i))) continue;
            if (!reaches(i)) {
                frame.needless("light " + std::to_string(i + 1) +
                               (hasPlace(i) ? ", which reaches nothing" : ", which is off"));
            }
            const auto element = [at = "[" + std::to_string(count++) + "]"](const char* name) { return name + at; };
            program.set(element("power").c_str(), strength(i));
            const Kind model = kind(i) == Kind::off ? Kind::point : kind(i);
            program.set(element("kind").c_str(), static_cast<int>(model) - static_cast<int>(Kind::directional));
            program.set(element("place").c_str(), kind(i) == Kind::directional ? towardsSun(i) : placeOf(i));
            if (kind(i) == Kind::spot) program.set(element("axis").c_str(), axisOf(i));
        }
        program.set("count", count);

        for (const auto& [object, mesh] : meshes.of(now)) {
            program.set("clipFromObject", now.clipFromWorld() * object.worldFromObject);
            program.set("worldFromObject", object.worldFromObject);
            program.set("worldFromNormal", normalMatrix(object.worldFromObject));
            program.set("color", encode ? linearFromSrgb(object.color) : object.color);
            mesh.draw();
        }
        glViewport(0, 0, frame.width(), frame.height());

        sent = count;
        const vec3 light = lightAtMark();
        mark = (light.x + light.y + light.z) / 3;
        stored = 255 * std::min(1.0, srgbFromLinear(*mark.value()));
        frame.count("lights asked for each pixel", count);
    }

    // ---- the lights

    Kind kind(std::size_t i) const { return *kinds[i]; }
    bool isLamp(std::size_t i) const { return kind(i) == Kind::point || kind(i) == Kind::spot; }
    bool hasPlace(std::size_t i) const { return isLamp(i) || kind(i) == Kind::directional; }
    bool isOn(Kind asked) const {
        for (const auto& one : kinds) {
            if (Kind(*one) == asked) return true;
        }
        return false;
    }

    vec3 placeOf(std::size_t i) const { return {places[i].x, height, places[i].y}; }
    vec3 towardsSun(std::size_t i) const { return glm::normalize(placeOf(i) - belowTheMiddle); }
    vec3 aim() const { return {aimX, 0, aimZ}; }
    vec3 axisOf(std::size_t i) const { return glm::normalize(aim() - placeOf(i)); }
    vec3 marked() const { return {markX, 0, markZ}; }

    vec3 strength(std::size_t i) const {
        if (kind(i) == Kind::off) return vec3(0);
        if (kind(i) == Kind::directional) return sunShare * hues.at(i);
        return (kind(i) == Kind::ambient ? ambientShare : double(power)) * hues.at(i);
    }
    vec3 ambient() const {
        vec3 sum(0);
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            if (kind(i) == Kind::ambient) sum += strength(i);
        }
        return sum;
    }
    Falloff falloff() const { return {constant, linear, quadratic, size}; }
    double reach() const { return falloff().reach(power, cutOff); }
    bool reaches(std::size_t i) const {
        if (!hasPlace(i)) return false;
        return !isLamp(i) || std::isinf(reach()) || canReach(now, now.clipFromWorld(), placeOf(i), reach());
    }

    // As the shader has it, in double.
    vec3 arriving(std::size_t i, const vec3& point, const vec3& normal) const {
        if (kind(i) == Kind::off) return vec3(0);
        if (kind(i) == Kind::ambient) return strength(i);
        if (kind(i) == Kind::directional) return strength(i) * std::max(glm::dot(normal, towardsSun(i)), 0.0);
        const vec3 toLamp = placeOf(i) - point;
        const double d = glm::length(toLamp);
        if (d > reach()) return vec3(0);
        const vec3 towards = toLamp / std::max(d, double(size));
        const double edge = kind(i) == Kind::point ? 1
                                                   : spotEdge(glm::dot(-towards, axisOf(i)), std::cos(radians(inner)),
                                                              std::cos(radians(outer)));
        return strength(i) * std::max(glm::dot(normal, towards), 0.0) * falloff().at(d) * edge;
    }
    vec3 lightAtMark() const {
        vec3 sum(0);
        for (std::size_t i = 0; i < kinds.size(); ++i) sum += arriving(i, marked(), {0, 1, 0});
        return sum;
    }

    void check() const override {
        if (constant + linear + quadratic == 0) {
            throw Error("--quadratic", "must be above 0, or --constant or --linear: all light would be divided by 0",
                        "0");
        }
        if (!isOn(Kind::spot)) return;
        if (inner > outer) throw Error("--inner", "must not be above --outer", inner.text());
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            if (kind(i) == Kind::spot && placeOf(i) == aim()) {
                throw Error("--height", "must not be 0 for a spot that stands where it aims", height.text());
            }
        }
    }

    // The still life, and the lamps for who looks at the scene: what is a spot has an aim.
    Scene scene(const FrameInfo& frame) const override {
        Scene scene = stillLife(paneOf(frame).aspect());
        scene.lights.clear();
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            if (!hasPlace(i)) continue;
            SceneLight light{.position = vec4(placeOf(i), 1), .color = strength(i)};
            if (kind(i) == Kind::directional) light.position = vec4(towardsSun(i), 0);
            if (kind(i) == Kind::spot) light.aim = axisOf(i);
            scene.lights.push_back(light);
        }
        return scene;
    }

    // The scene on the left; words and the graph on the right.
    static Pane paneOf(const FrameInfo& frame) { return {0, 0, std::max(1, frame.width() * 13 / 20), frame.height()}; }
    std::optional<vec2> inPicture(const FrameInfo& frame, const vec3& point) const {
        return pictureFromPane(paneOf(frame), scene(frame).clipFromWorld(), point);
    }

    // ---- what only people need

    void annotate(const Frame& frame) override {
        drawing.begin(frame);
        const double unit = std::min(frame.width() / 960.0, frame.height() / 540.0);
        drawing.in(paneOf(frame));
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            if (hasPlace(i)) drawLight(frame, i, unit);
        }
        drawCross(marked(), red);
        if (isOn(Kind::spot)) drawCross(aim(), vec4(1, 1, 1, 1));

        const Pane left = paneOf(frame);
        const Pane right{left.width, 0, std::max(1, frame.width() - left.width), frame.height()};
        drawing.in(right);
        drawing.fill({vec2(0), vec2(right.width, right.height)}, vec4(1, 1, 1, 1));
        drawTable(right, unit);
        drawGraph(right, unit);
        drawing.draw(frame);
    }

    void drawLight(const Frame& frame, std::size_t i, double unit) {
        const vec4 color(hues.at(i), 1);
        const mat4 clipFromWorld = now.clipFromWorld();
        const vec3 at = placeOf(i);
        if (kind(i) == Kind::directional) {
            const auto from = inPicture(frame, at), to = inPicture(frame, at - 0.5 * towardsSun(i));
            if (from && to) drawing.arrow(*from, *to, {color, 4 * unit});
        }
        if (kind(i) == Kind::spot) {
            // The outer cone, 0.4 long
            const mat4 lampFromWorld = lookAtAnyRoll(at, aim());
            const mat4 worldFromLamp = inverse(lampFromWorld);
            constexpr int corners = 16;
            std::vector<vec3> rim;
            for (int k = 0; k <= corners; ++k) {
                const double turn = 2 * std::acos(-1.0) * k / corners, wide = 0.4 * std::sin(radians(outer));
                rim.emplace_back(worldFromLamp * vec4(wide * std::cos(turn), wide * std::sin(turn),
                                                      -0.4 * std::cos(radians(outer)), 1));
                if (k > 0) drawing.edge(clipFromWorld, rim[rim.size() - 2], rim.back(), {color, 1.5});
                if (k % 4 == 0) drawing.edge(clipFromWorld, at, rim.back(), {color, 1.5});
            }
        }
        drawing.point(clipFromWorld, at, 17 * unit, vec4(0.1, 0.1, 0.1, 1));
        drawing.point(clipFromWorld, at, 13 * unit, color);
        drawing.text(clipFromWorld, at, vec2(9, 9) * unit, std::to_string(i + 1),
                     style(unit, vec4(1), vec4(0, 0, 0, 0.4)));
    }

    void drawCross(const vec3& at, const vec4& color) {
        const mat4 clipFromWorld = now.clipFromWorld();
        drawing.edge(clipFromWorld, at - vec3(0.1, -0.003, 0), at + vec3(0.1, 0.003, 0), {color, 3});
        drawing.edge(clipFromWorld, at - vec3(0, -0.003, 0.1), at + vec3(0, 0.003, 0.1), {color, 3});
    }

    static TextStyle style(double unit, const vec4& color, const vec4& background = vec4(0)) {
        return {std::max(8, static_cast<int>(15 * unit)), color, background};
    }

    // What each light gives to the mark.
    void drawTable(const Pane& pane, double unit) {
        double y = pane.height - 8 * unit;
        const auto say = [&](const std::string& words, const vec4& color) {
            drawing.text({12 * unit, y}, words, style(unit, color));
            y -= 20 * unit;
        };
        say("Light at the red mark", red);
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            const vec3 light = arriving(i, marked(), {0, 1, 0});
            std::string words = std::to_string(i + 1) + " " + kinds[i]->text();
            if (isLamp(i)) words += rounded(", %.2f m", glm::distance(placeOf(i), marked()));
            if (kind(i) != Kind::off) words += rounded(": %.3f", (light.x + light.y + light.z) / 3);
            say(words, kind(i) == Kind::off ? grey : ink);
        }
        say(rounded("sum %.3f", *mark.value()) + rounded(", stored as %.0f", *stored.value()), ink);
    }

    void drawGraph(const Pane& pane, double unit) {
        const double left = std::min(58.0, pane.width / 5.0), low = std::min(52.0, pane.height / 8.0);
        const Box box{{left, low}, {pane.width - 14 * unit - 0.5, 0.5 * pane.height}};
        const Plot plot{box,
                        {logLog ? 0.01 : 0, logLog ? 10.0 : 4.0, "distance, m", logLog},
                        {logLog ? 1e-3 * power : 0, (logLog ? 1e4 : 3) * power, "light", logLog}};
        const Falloff chosen = falloff(), physical{.size = 1e-9};
        std::vector<vec2> chosenCurve, physicalCurve;
        for (int i = 0; i <= 400; ++i) {
            const double d = plot.value(box.low + vec2(box.size().x * i / 400, 0)).x;
            chosenCurve.emplace_back(d, power * chosen.at(d));
            if (d > 1e-6) physicalCurve.emplace_back(d, power * physical.at(d));
        }
        drawing.curve(plot, physicalCurve, {grey, 5});
        drawing.curve(plot, chosenCurve, {blue, 2});
        if (reach() > plot.x.low && reach() < plot.x.high) {
            const double x = plot.pixel({reach(), plot.y.high}).x;
            drawing.line({x, box.low.y}, {x, box.high.y}, {red, 1.5});
        }
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            if (!isLamp(i)) continue;
            const vec2 value(glm::distance(placeOf(i), marked()),
                             power * chosen.at(glm::distance(placeOf(i), marked())));
            if (value.x < plot.x.low || value.x > plot.x.high || value.y < plot.y.low || value.y > plot.y.high)
                continue;
            drawing.point(plot.pixel(value), 11 * unit, ink);
            drawing.point(plot.pixel(value), 8 * unit, vec4(hues.at(i), 1));
        }
        drawing.axes(plot);
        const double words = left + 0.5 * box.size().x;
        drawing.text({words, box.high.y}, "falloff chosen", style(unit, blue));
        drawing.text({words, box.high.y - 20 * unit}, "1/d^2", style(unit, grey));
        if (std::isfinite(reach())) drawing.text({words, box.high.y - 40 * unit}, "cut off", style(unit, red));
    }

    static Kinds kindKnobs(Demo* owner) {
        Kinds kinds;
        const auto add = [&](Literal name, Kind initial, Literal help) {
            const std::initializer_list<DeclaredOption> options{
                {"off"}, {"ambient"}, {"directional"}, {"point"}, {"spot"}};
            kinds.push_back(std::make_unique<Choice<Kind>>(owner, name, initial, options, help));
        };
        add("light-1", Kind::ambient, "what light 1 is");
        add("light-2", Kind::directional, "what light 2 is");
        add("light-3", Kind::point, "what light 3 is");
        add("light-4", Kind::spot, "what light 4 is");
        add("light-5", Kind::off, "what light 5 is");
        add("light-6", Kind::off, "what light 6 is");
        add("light-7", Kind::off, "what light 7 is");
        add("light-8", Kind::off, "what light 8 is");
        return kinds;
    }
};

constexpr Declaration declaration{
    .name = "lights",
    .sentence = "Ambient, directional, point and spot lights, up to eight, and how their light falls off.",
    .lookFor =
        "Drag lamp 3 towards a surface and away: its light falls as 1/d^2. Then light 2: only its direction matters.",
    .chapter = "Light, colour and texture",
    .number = 17,
    .width = 960,
    .height = 540,
    .background = vec4(0, 0, 0, 1),
    .needs = {.depth = true},
    .presets =
        {
            {"four", "One light of each model: everywhere, from far away, from a lamp, from a lamp with a cone."},
            {"point",
             "One lamp alone: bright below it, dark behind, by 1/d^2 and by the angle at which light arrives.",
             {{"light-1", "off"}, {"light-2", "off"}, {"light-4", "off"}}},
            {"constant",
             "The same lamp without falloff: distance does not matter, only the angle does.",
             {{"light-1", "off"}, {"light-2", "off"}, {"light-4", "off"}, {"constant", "1"}, {"quadratic", "0"}}},
            {"hard-spot",
             "A spot whose inner cone is its outer one: an edge with a step.",
             {{"light-1", "ambient"}, {"light-2", "off"}, {"light-3", "off"}, {"inner", "22"}, {"outer", "22"}}},
            {"not-encoded",
             "The lamp with numbers that are not encoded: dark too soon, and a hard edge of the shade on the ball.",
             {{"light-1", "off"}, {"light-2", "off"}, {"light-4", "off"}, {"encode", "off"}}},
            {"cut-off",
             "Seven lamps that end where they give less than a tenth: circles with an edge on floor and wall.",
             {{"light-2", "point"},
              {"light-5", "point"},
              {"light-6", "point"},
              {"light-7", "point"},
              {"light-8", "point"},
              {"height", "0.5"},
              {"power", "0.2"},
              {"cut-off", "0.1"}}},
        },
};

const bool added = addDemo<Lights, declaration>();

}  // namespace

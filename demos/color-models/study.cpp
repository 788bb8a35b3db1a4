// The readouts of color-models, and its study: how uneven the steps of its strips are, against the time they
// take; and what 8 bits do.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "color-models.h"
#include "mv/demo/demo.h"
#include "mv/math/color.h"
#include "mv/math/color_difference.h"

namespace mv::color_models {

vec3 asSeen(const vec3& srgb) { return oklabFromLinear(linearFromSrgb(srgb)); }
static vec3 labOf(const vec3& srgb) { return labFromLinear(linearFromSrgb(srgb)); }
vec3 shownAs(const vec3& srgb) { return glm::clamp(srgb, 0.0, 1.0); }
// The tolerance is above what OKLab's there and back rounds.
bool isBeyond(const vec3& srgb) { return glm::distance(srgb, shownAs(srgb)) > 1e-9; }
static auto countBeyond(const Settings& s) {
    const std::vector<vec3> even = strip(s, Way::oklab);
    return std::count_if(even.begin(), even.end(), isBeyond);
}

// The lengths of a strip's steps by their mean, in the space and by the distance given. None where all are 0.
template <class InSpace, class Distance>
static std::vector<double> stepsBy(const std::vector<vec3>& colors, const InSpace& inSpace, const Distance& distance) {
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
// The steps as they are seen, in OKLab.
std::vector<double> stepsOf(const std::vector<vec3>& colors) {
    return stepsBy(colors, asSeen, [](const vec3& a, const vec3& b) { return glm::distance(a, b); });
}
std::optional<double> unevenness(const std::vector<double>& lengths) {
    if (lengths.empty()) return {};
    double squares = 0;
    for (const double length : lengths) squares += (length - 1) * (length - 1);
    return 100 * std::sqrt(squares / double(lengths.size()));
}

// For the study: the lengths of the steps, by their mean.
std::vector<double> values(const Settings& s) { return stepsOf(strip(s, s.way)); }

void tell(const Settings& s, const Frame& frame) {
    if (hslFromRgb(s.from).saturation == 0) frame.say("The colour is a grey: it has no hue.");
    if (s.shows == Shows::solids && countBeyond(s) > 0)
        frame.say("OKLab mixes colours that no sRGB screen shows: underlined, they are cut off.");
}

void readOut(Gpu&, const Settings& s, const Frame&, Numbers& numbers) {
    const Hsl hsl = hslFromRgb(s.from);
    if (hsl.saturation != 0) numbers.set("hue", hsl.hue);
    numbers.set("lightness", asSeen(s.from).x);
    for (const auto& [name, way] : {std::pair("uneven-srgb", Way::srgb),
                                    {"uneven-linear", Way::linear},
                                    {"uneven-hsl", Way::hsl},
                                    {"uneven-oklab", Way::oklab}}) {
        if (const auto percent = unevenness(stepsOf(strip(s, way)))) numbers.set(name, *percent);
    }
    numbers.set("beyond", double(countBeyond(s)));
    numbers.set("part-of-diagram", ChromaticityDiagram{s.diagram}.heldBySrgb());
    if (const auto percent = unevenness(stepsBy(strip(s, s.way), labOf, colorDifference)))
        numbers.set("uneven-ciede2000", *percent);
    const vec3 lab = labOf(s.from);
    numbers.set("ciede2000", colorDifference(lab, labOf(s.to)));
    numbers.set("contrast", contrast(linearFromSrgb(s.from), linearFromSrgb(s.to)));
    numbers.set("lab-l", lab.x);
    numbers.set("lab-a", lab.y);
    numbers.set("lab-b", lab.z);
}

namespace {

using namespace mv::claims;

// The colour in 8 bits, through HSL and HSV in 8 bits a number: how far a component is off, in 255ths.
std::vector<double> offIn8Bits(Probing& probing) {
    const auto in8 = [](double part) { return std::round(part * 255) / 255; };
    const Demo& demo = probing.demo();
    const vec3 rgb(in8(demo.number("red")), in8(demo.number("green")), in8(demo.number("blue")));
    const auto off = [&](const vec3& back) {
        double most = 0;
        for (int i = 0; i < 3; ++i) most = std::max(most, std::abs(std::round(back[i] * 255) - rgb[i] * 255));
        return std::round(most);
    };
    const Hsl hsl = hslFromRgb(rgb);
    const Hsv hsv = hsvFromRgb(rgb);
    return {off(rgbFromHsl(Hsl{360 * in8(hsl.hue / 360), in8(hsl.saturation), in8(hsl.lightness)})),
            off(rgbFromHsv(Hsv{360 * in8(hsv.hue / 360), in8(hsv.saturation), in8(hsv.value)}))};
}

// The parts of the diagram beyond the line through two of sRGB's primaries, in percent.
std::vector<double> beyondSides(Probing& probing) {
    const ChromaticityDiagram diagram{probing.demo().word("diagram") == "uv" ? Diagram::uv : Diagram::xy};
    const auto& [red, green, blue] = srgbPrimaries;
    return {diagram.beyondSide(green, blue), diagram.beyondSide(blue, red)};
}

const bool probed = addProbes(
    "color-models", {{.numbers = {{"hsl-in-8-bits", "how far HSL in 8 bits a number takes the colour", "/255"},
                                  {"hsv-in-8-bits", "the same for HSV", "/255"}},
                      .measure = offIn8Bits},
                     {.numbers = {{"beyond-cyan", "of the diagram, beyond the line through sRGB's green and blue", "%"},
                                  {"beyond-purple", "of the diagram, beyond that through blue and red", "%"}},
                      .measure = beyondSides}});

std::vector<KnobSetting> between(const std::vector<std::string>& from, const std::vector<std::string>& to) {
    return {{"red", from[0]},  {"green", from[1]},  {"blue", from[2]},
            {"to-red", to[0]}, {"to-green", to[1]}, {"to-blue", to[2]}};
}

Study study() {
    Study study;
    study.quantity = "the length of each step of a strip as seen (OKLab), by the mean of its steps";
    study.reference = "steps of one length";
    study.reads = {"steps"};
    study.makeReference = [](const Demo& demo, const ReferenceFrame&, const auto&) {
        return Reference{.values = std::vector<double>(static_cast<std::size_t>(demo.number("steps")), 1.0)};
    };
    study.problem = "steps";
    study.scenes = {{"orange to blue", between({"1", "0.55", "0"}, {"0", "0.35", "1"})},
                    {"yellow to blue", between({"1", "1", "0"}, {"0", "0", "1"})},
                    {"black to white", between({"0", "0", "0"}, {"1", "1", "1"})},
                    {"grey to red", between({"0.5", "0.5", "0.5"}, {"1", "0", "0"})}};
    for (const std::string way : {"srgb", "linear", "hsl", "oklab"}) {
        study.lines.push_back(
            {.method = way, .settings = {{"mix", way}}, .knob = "steps", .values = {"12", "48", "192", "768"}});
    }
    study.wrongBeyond = 0.1;
    study.says = {
        claim("oklab-is-even", "Mixed in OKLab the steps are even, to roundings, however many there are.",
              {atMost(of::rms, rows("oklab"), 1e-10)}),
        claim("others-are-not", "Mixed in any other way they are uneven by 5 % of a step at least, in all four pairs.",
              {atLeast(of::rms, rows("srgb", "linear", "hsl"), 0.05)}),
        claim("light-is-worst-for-greys",
              "From black to white, light as it adds up is more than twice as uneven as sRGB, which was made for the "
              "eye.",
              {ratio(of::rms, rows("linear").in("black to white"), rows("srgb").in("black to white"), 2, HUGE_VAL)}),
        claim("more-steps-do-not-help",
              "More steps make no strip more even: between colours that are not black it is as uneven with 768 as with "
              "12, "
              "to a tenth.",
              {settled(of::rms, rows("srgb", "linear", "hsl").in("orange to blue"), 1.1),
               settled(of::rms, rows("srgb", "linear", "hsl").in("yellow to blue"), 1.1),
               settled(of::rms, rows("srgb", "linear", "hsl").in("grey to red"), 1.1)}),
        claim("black-is-infinitely-steep",
              "From black it grows with the number of steps, since OKLab's cube roots rise infinitely steeply there.",
              {slope(of::rms, rows("srgb", "linear", "hsl").in("black to white"), 0.1, 0.4)}),
        claim("four-times-as-long", "A colour mixed in OKLab takes longer than one mixed in sRGB, up to four times.",
              {ratio(of::time, rows("oklab"), rows("srgb"), 1, 4)}),
        note("The time is that of a whole strip and of the lengths of its steps, which take a colour to OKLab each; "
             "divided by the steps it is the time of a colour."),
        note("The colours are those mixed, before a screen cuts off what it cannot show.")};
    study.ofValues = true;
    return study;
}

const bool studied = addStudy("color-models", study());

}  // namespace
}  // namespace mv::color_models

// The readouts and the plan of mirror, and its study: each pixel against a ray that the mirrors turn round.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "mirror.h"
#include "mv/demo/cached.h"
#include "mv/demo/demo.h"
#include "mv/formatted.h"
#include "mv/image/picture.h"
#include "mv/math/shadow.h"
#include "traced_mirrors.h"

namespace mv::mirror {

static bool showsFirst(const Sight& sight) { return !sight.chains.empty() && sight.chains.front().front().which == 0; }

// Steps of a depth buffer of 24 bits from the ball's front to its back, as the eye sees them in the first mirror.
static double depthSteps(const Settings& s, const Sight& sight) {
    const View view = viewAfter(s, sight, 0, 1);
    const vec3 imagedEye(reflection(view.before) * vec4(s.eye, 1)), ball = roomOf(s).ball;
    const vec3 along = MirrorRoom::ballRadius * glm::normalize(ball - imagedEye);
    const vec4 front = view.clipFromWorld * vec4(ball - along, 1), back = view.clipFromWorld * vec4(ball + along, 1);
    return 0.5 * (back.z / back.w - front.z / front.w) * (std::exp2(24) - 1);
}

void tell(const Settings& s, const Sight& sight, const Frame& frame) {
    for (const auto& chain : sight.chains)
        frame.show("worldFromImage" + std::to_string(chain[0].which + 1), chain[0].worldFromShown);
    if (lightSide(vec4(s.eye, 1), sight.mirrors.front().plane()) <= 0)
        frame.say("The eye is not in front of the first mirror: nothing is seen in it.");
    if (!showsFirst(sight) || s.near != Near::oblique) return;
    const double steps = depthSteps(s, sight);
    if (steps < 256)
        frame.say(formatted("So near the mirror's plane the oblique near plane leaves %.0f steps of depth ", steps) +
                  "from the ball's front to its back; --near clip-distance leaves as many as ever.");
}

void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers) {
    const Sight sight = sightOf(s, frame);
    const Gpu::Work work = sight.chains.empty() ? Gpu::Work() : gpu.work;
    numbers.set("passes", work.passes);
    numbers.set("drawn", work.drawn);
    numbers.set("left-out", work.leftOut);
    numbers.set("eye-distance", glm::dot(sight.mirrors.front().plane(), vec4(s.eye, 1)));
    if (showsFirst(sight)) numbers.set("depth-steps", depthSteps(s, sight));
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Sight sight = sightOf(s, frame);
    gpu.drawing.begin(frame);
    drawPlan(gpu.drawing, frame, roomOf(s), sight.scene, sight.chains);
    gpu.drawing.draw(frame);
}

namespace {

using namespace mv::claims;

constexpr double wrongBeyond = 0.02;  // of an object's brightness; another object is off by 0.1 at least

// Whether one of the eight neighbours shows something else, as a study has it.
bool isAtEdge(const Reference& reference, int column, int row, int width, int height) {
    const std::size_t here = pixelIndex(column, row, width);
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, height - 1); ++y) {
        for (int x = std::max(column - 1, 0); x <= std::min(column + 1, width - 1); ++x) {
            const std::size_t there = pixelIndex(x, y, width);
            if (reference.regions[here] != reference.regions[there] ||
                std::abs(reference.values[here] - reference.values[there]) > wrongBeyond) {
                return true;
            }
        }
    }
    return false;
}

// The readouts of a smaller picture, off edges: the pixels that are wrong, and those that show what is behind the first mirror where no
// ray meets it.
std::vector<double> wrongPixels(Probing& probing) {
    constexpr int width = 480, height = 280;
    const std::vector<float> shown = probing.measured(width, height);
    if (shown.empty()) return {};
    const Demo& demo = probing.demo();
    const FrameInfo frame(probing.frame().index(), width, height);
    // Kept while all that the rays meet rests: how it is drawn changes nothing of it.
    static Cached<Reference, TracedScene> kept;
    const TracedScene scene = tracedScene(demo, frame);
    const Reference& right = kept.of({scene}, [](const TracedScene& rested) { return traced(rested, width, height); });
    const auto isBehind = behindFirst(scene);
    double wrong = 0, behind = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        const auto object = static_cast<std::size_t>(std::max(shown[i], 0.0F));
        const auto rightOne = static_cast<std::size_t>(std::max(right.values[i], 0.0));
        const bool fromBehind = isBehind.at(object) && object != rightOne;
        const bool off = right.regions[i] >= 0 && std::abs(double(shown[i]) - right.values[i]) > wrongBeyond;
        if (!fromBehind && !off) continue;
        if (isAtEdge(right, static_cast<int>(i) % width, static_cast<int>(i) / width, width, height)) continue;
        behind += fromBehind ? 1 : 0;
        wrong += off ? 1 : 0;
    }
    return {100 * wrong / double(shown.size()), behind};
}

Study study() {
    Study study;
    study.quantity = "the number of the object that is seen, and 0.9 times its brightness, 0..1";
    study.reference = "a ray a pixel, turned round at each mirror, in double precision";
    study.makeReference = [](const Demo& demo, const ReferenceFrame& frame, const auto&) {
        return traced(tracedScene(demo, frame), frame.width(), frame.height());
    };
    study.reads = {"mirrors", "bounces",    "reflectance", "mirror-turn", "eye-x",
                   "eye-z",   "eye-height", "ball-x",      "ball-z"};
    study.scenes = {{"one mirror", {}}, {"two mirrors", {{"mirrors", "two"}}}};
    study.lines = {{.method = "stencil, oblique", .settings = {{"method", "stencil"}}},
                   {.method = "stencil, clip distance", .settings = {{"method", "stencil"}, {"near", "clip-distance"}}},
                   {.method = "stencil, no near plane", .settings = {{"method", "stencil"}, {"near", "none"}}},
                   {.method = "texture",
                    .settings = {{"method", "texture"}, {"keep", "off"}},
                    .knob = "coarser",
                    .values = {"1", "2", "4", "8", "16"}},
                   {.method = "texture, kept",
                    .settings = {{"method", "texture"}},
                    .knob = "coarser",
                    .values = {"1", "2", "4", "8", "16"}}};
    study.axis = ErrorAxis::fraction;
    study.wrongBeyond = wrongBeyond;
    study.width = 960;
    study.height = 560;
    const auto textures = rows("texture", "texture, kept");
    study.says = {
        claim("right-by-rays",
              "Away from edges both methods are right in every pixel, with one mirror and with two that show each "
              "other eight "
              "times, by either near plane. At edges less than 0.01 % of the pixels are another one.",
              {zero(of::wrongAwayFromEdges, rows("stencil, oblique", "stencil, clip distance")),
               zero(of::wrongAwayFromEdges, textures.at(1)),
               atMost(of::wrong, rows("stencil, oblique", "stencil, clip distance"), 0.01),
               atMost(of::wrong, textures.at(1), 0.01)}),
        claim("from-behind",
              "Without a near plane more than 2 % of the pixels off edges show what is behind the mirror.",
              {atLeast(of::wrongAwayFromEdges, rows("stencil, no near plane"), 2)}),
        claim("texels",
              "Coarser texels are wrong at the edges in the mirror: in about twice as many pixels when they are twice "
              "as wide.",
              {slope(of::wrong, textures.from(2), 0.85, 1.15)}),
        claim("stencil-first", "The stencil takes less time than a texture as fine as the picture that is made anew.",
              {ratio(of::time, rows("stencil, oblique", "stencil, clip distance"), rows("texture").at(1), 0, 1)}),
        claim("kept", "With two mirrors a texture that is kept takes less time than one that is made anew.",
              {ratio(of::time, rows("texture, kept").in("two mirrors").at(1), rows("texture").at(1), 0, 0.9)}),
        claim(
            "same-triangles",
            "The stencil draws each mirror once more than the texture does, to reset its depths: two triangles a pass.",
            {ratio(of::count("triangles"), rows("stencil, oblique"), rows("texture").at(1), 1, 1.001)}),
        claim("two-mirrors-cost",
              "Eight bounces draw the world eight times more: at least four times the triangles of one.",
              {ratio(of::count("triangles"), rows("stencil, oblique").in("two mirrors"),
                     rows("stencil, oblique").in("one mirror"), 4, 9)}),
        note("A kept texture costs a lookup while neither the eye nor anything in the world moves. When the eye moves, "
             "it is "
             "made anew: a shadow map would not have to be.")};
    return study;
}

const bool studied = addStudy("mirror", study());
const bool probed =
    addProbes("mirror", {{{{"wrong", "pixels off edges that are not as rays show, of a picture of 480 x 280", "%"},
                           {"from-behind", "those that show what stands behind the first mirror, where rays do not"}},
                          wrongPixels}});

}  // namespace
}  // namespace mv::mirror

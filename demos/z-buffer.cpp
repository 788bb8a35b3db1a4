// z-buffer: who hides whom: by the order of drawing, by a sort, or by a depth for each pixel, in several formats.
//
// Claims (each is a test in tests/claims/z-buffer.cpp):
// - [any-order-with-depth] With the depth test all orders of drawing opaque things give one picture: what rays show.
// - [no-order-without] Without it the bars, which overlap in a cycle, are wrong in every order, sorted ones too.
// - [cut-and-sorted] With each bar cut in two, drawing from far to near by the middles of the parts is right.
// - [first-of-equals] At equal depths the order decides, depth test or not: GL_LESS keeps the first.
// - [blending-needs-order] Translucent panes are right from far to near alone; the depth test makes other orders worse.
// - [fights-by-format] The road fights with the ground in 16 bits, and in 24 from some distance on; in reversed float
//   nowhere where it is 1e-4 of the distance above the ground, and in a few pixels at the vanishing point at 1e-5 (llvmpipe;
//   a GPU that rounds while it interpolates has the errors of 24 bits on triangles this long).
// - [depth-as-grey] The grey shown is the depth that each mapping's formula gives for the distance.
// - [misordered-as-known] The study's numbers are the known ones: none for reversed float with glClipControl.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <limits>
#include <numeric>
#include <optional>
#include <string_view>

#include "mv/demo/demo.h"
#include "mv/gl/beyond_es.h"
#include "mv/gl/gl.h"
#include "mv/gl/on_demand.h"
#include "mv/math/depth_range.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/depth_order.h"
#include "shared/plates.h"
#include "shared/spin.h"

using namespace mv;

namespace {

enum class Place { cycle, road, panes };
enum class Mapping { standard, infinite, reversed, flipped, logarithmic, zeroToOne };
enum class Shown { colors, depth, curve };

const vec3 background(0.95, 1, 1);

// A run of cells of a plate, drawn by one call.
struct Part {
    std::size_t plate, first, count;
};

struct ZBuffer final : Demo {
    Choice<Place> place{this,
                        "scene",
                        Place::cycle,
                        {{"cycle", "three bars, each over the next one"},
                         {"road", "a road on the ground, to the horizon, with a mark on it"},
                         {"panes", "three panes, one close behind the other"}},
                        "what is drawn: a red, a green and a blue thing"};
    WordChoice order{this,
                     "order",
                     0,
                     {{"rgb"}, {"rbg"}, {"grb"}, {"gbr"}, {"brg"}, {"bgr"}, {"sorted", "from far to near by middles"}},
                     "the order of drawing, by the letters of the colours"};
    Whole pieces{this, "pieces", 1, {1, 8}, "parts that a bar or pane is cut into (the road has its own cells)"};
    Toggle depthTest{this, "depth-test", true, "let each pixel keep what is nearest"};
    Choice<Shown> shown{
        this,
        "show",
        Shown::colors,
        {{"colors"}, {"depth", "0 black, 1 white"}, {"curve", "what depth each distance is given, over the colors"}},
        "which buffer"};
    Choice<DepthFormat> format{this,
                               "format",
                               DepthFormat::d24,
                               {{"d16", "16 bits"}, {"d24", "24 bits"}, {"d32f", "32 bits, floating point"}},
                               "of the depth buffer"};
    Choice<Mapping> mapping{
        this,
        "mapping",
        Mapping::standard,
        {{"standard", "0 at near, 1 at far"},
         {"infinite", "far at infinity"},
         {"reversed", "1 at near, 0 at far, with glClipControl"},
         {"flipped", "1 at near, 0 at far, as OpenGL has it without glClipControl"},
         {"logarithmic", "written by the fragment shader"},
         {"zero-to-one", "0 at near, 1 at far, with glClipControl, as Direct3D and Vulkan have it"}},
        "from distance to depth"};
    Real near{this, "near", 0.1, {0.01, 2.5, Scale::logarithmic}, "where the view begins"};
    Real far{this, "far", 10000, {10, 1e6, Scale::logarithmic}, "where it ends"};
    Real separation{this,
                    "separation",
                    1e-5,
                    {1e-7, 0.1, Scale::logarithmic, true},
                    "from a road or pane to the next, as a part of the distance"};
    Real opacity{this, "opacity", 1, {0.2, 1}, "below 1 colours are blended"};
    Spin spin{this};

    Readout wrongPixels{this, "wrong-pixels", "pixels of another colour than rays find there, edges left out", "%"};
    Readout misordered{this, "misordered", "pairs of points, separation apart, whose depths do not tell the nearer",
                       "%"};

    Program byMatrix, show;
    OnDemand<Program> byLogarithm{"z-buffer", "logarithmic"};
    Target drawn;
    Mesh plate, cover;
    Drawing drawing;
    std::vector<double> cuts;  // of the plate that is uploaded

    ZBuffer() {
        bindKeys(Key::left, Key::right, order, 1);
        bindKeys(Key::down, Key::up, depthTest, 1);
        const auto turns = [this] { return place != Place::road; };
        pieces.onlyWhen(turns, "the road has its own cells");
        spin.x.onlyWhen(turns, "only bars and panes are turned");
        spin.y.onlyWhen(turns, "only bars and panes are turned");
        separation.onlyWhen([this] { return place != Place::cycle; }, "the bars have their own places");
        format.onlyWhen([this] { return depthTest; }, "without depth test no depth is kept");
    }

    void init() override {
        byMatrix = Program("z-buffer");
        show = Program("z-buffer", "show");
        MeshData triangle;
        triangle.positions = {{-1, -1, 0}, {3, -1, 0}, {-1, 3, 0}};
        cover = Mesh(triangle, "picture");
    }

    void draw(const Frame& frame) override {
        if (!depthTest) frame.say("Without depth test nothing is written into the depth buffer, either.");
        const std::array<Plate, 3> plates = platesOf();
        const mat4 clip = clipFromView(frame.aspect(), zeroToOne());
        frame.show("clipFromView", clip);

        // A depth buffer of the format to be tried, and colours beside it. The picture's own target needs none.
        constexpr GLenum formats[] = {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32F};
        const Target::Buffers buffers{.depth = true,
                                      .texture = true,
                                      .depthFormat = formats[static_cast<std::size_t>(DepthFormat(format))],
                                      .depthTexture = shown == Shown::depth};
        if (!drawn.fit(frame.width(), frame.height(), buffers, "scene")) drawn.bind();
        drawPlates(plates, clip);
        if (frame.readouts()) measure(frame, plates, clip);

        // The picture is one of the two
        frame.bindTarget();
        show.use();
        show.set("drawn", 0);
        show.set("grey", shown == Shown::depth);
        if (shown == Shown::depth)
            drawn.bindDepth(0);
        else
            drawn.bindColor(0);
        cover.draw();
    }

    void drawPlates(const std::array<Plate, 3>& plates, const mat4& clip) {
        // Near is 0 and the smaller depth wins, or near is 1 and the larger one does
        const float farthest = nearIsOne() ? 0 : 1;
        glClearColor(float(background.r), float(background.g), float(background.b), 1);
        glClear(GL_COLOR_BUFFER_BIT);
        glClearBufferfv(GL_DEPTH, 0, &farthest);
        if (depthTest) glEnable(GL_DEPTH_TEST);
        if (nearIsOne()) glDepthFunc(GL_GREATER);
        if (zeroToOne()) glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
        if (opacity < 1) glEnable(GL_BLEND);
        glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);

        const Program& program = mapping == Mapping::logarithmic ? *byLogarithm : byMatrix;
        program.use();
        program.set("clipFromView", clip);
        if (mapping == Mapping::logarithmic) program.set("far", far);
        if (cuts != cutsOf()) {
            cuts = cutsOf();
            plate = Mesh(plateMesh(cuts), "plate");
        }
        std::optional<std::size_t> current;
        for (const Part& part : partsInOrder(plates)) {
            if (part.plate != current) {
                program.set("viewFromPlate", plates[part.plate].viewFromPlate);
                program.set("color", vec4(plates[part.plate].color, opacity));
            }
            current = part.plate;
            plate.draw(6 * part.first, 6 * part.count);
        }

        // What follows is not of this scene
        if (depthTest) glDisable(GL_DEPTH_TEST);
        if (opacity < 1) glDisable(GL_BLEND);
        if (zeroToOne()) glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    }

    bool asksForZeroToOne() const { return mapping == Mapping::reversed || mapping == Mapping::zeroToOne; }
    bool zeroToOne() const { return asksForZeroToOne() && has(beyond_es::clipControl); }
    bool nearIsOne() const { return mapping == Mapping::reversed || mapping == Mapping::flipped; }

    // Only the third row of the matrix has to do with depth.
    mat4 clipFromView(double aspect, bool zeroToOne) const {
        const double n = near, f = far;
        if (mapping == Mapping::infinite) return infinitePerspective(50, aspect, n);
        if (nearIsOne())
            return perspective(50, aspect, n, f, zeroToOne ? DepthRange::oneToZero : DepthRange::oneToMinusOne);
        if (zeroToOne) return perspective(50, aspect, n, f, DepthRange::zeroToOne);
        return perspective(50, aspect, n, f);
    }

    std::array<Plate, 3> platesOf() const {
        const mat4 viewFromThings = translate(0, 0, -5) * spin.turn();
        if (place == Place::cycle) return barsInACycle(viewFromThings * translate(-0.1, -0.35, 0));
        if (place == Place::panes) return panes(viewFromThings, 5 * separation);
        return roadOnGround(far, separation);
    }

    // Where a plate is cut. The road in cells of a quarter of their distance: over a cell depth is interpolated in float,
    // whose error is a part of the largest depth there, the near end's.
    std::vector<double> cutsOf() const {
        std::vector<double> ends{0};
        if (place == Place::road) {
            double along = 1 / far;
            while (along < 1) {
                ends.push_back(along);
                along *= 1.25;
            }
        } else {
            for (int i = 1; i < pieces; ++i) ends.push_back(double(i) / pieces);
        }
        ends.push_back(1);
        return ends;
    }

    std::vector<Part> partsInOrder(const std::array<Plate, 3>& plates) const {
        std::vector<Part> parts;
        const std::size_t cells = cuts.size() - 1;
        if (order.text() != "sorted") {
            for (const char letter : order.text()) parts.push_back({std::string_view("rgb").find(letter), 0, cells});
            return parts;
        }
        // The painter's algorithm: what is far first, then what is near over it
        for (std::size_t i = 0; i < 3; ++i)
            for (std::size_t cell = 0; cell < cells; ++cell) parts.push_back({i, cell, 1});
        const auto distance = [&](const Part& part) {
            const double middle = (cuts[part.first] + cuts[part.first + 1]) / 2;
            return -(plates[part.plate].viewFromPlate * vec4(middle, 0, 0, 1)).z;
        };
        std::ranges::stable_sort(parts, [&](const Part& a, const Part& b) { return distance(a) > distance(b); });
        return parts;
    }

    void measure(const Frame& frame, const std::array<Plate, 3>& plates, const mat4& clip) {
        const double end = mapping == Mapping::infinite ? std::numeric_limits<double>::infinity() : far;
        const auto wrong = wrongPart(drawn.read(), colorsByRays(plates, {.tangents = {1 / clip[0][0], 1 / clip[1][1]},
                                                                         .near = near,
                                                                         .far = end,
                                                                         .opacity = opacity,
                                                                         .background = background,
                                                                         .width = frame.width(),
                                                                         .height = frame.height()}));
        if (wrong) wrongPixels = 100 * *wrong;
        const std::vector<double> pairs = misorderedAmong(zeroToOne());
        misordered = 100 * std::accumulate(pairs.begin(), pairs.end(), 0.0) / pairCount;
    }

    // Of pairs of points, one the part `separation` farther away, those whose depths are equal or the wrong
    // way round.
    static constexpr int pairCount = 100000;
    std::vector<double> values() const override { return misorderedAmong(asksForZeroToOne()); }
    std::vector<double> misorderedAmong(bool clipsToOne) const {
        const fmat4 clip(clipFromView(1, clipsToOne));
        return misorderedPairs(near, far, separation, pairCount, [&](float distance) {
            return (nearIsOne() ? -1 : 1) * keptDepth(format, depthOf(clip, distance, clipsToOne));
        });
    }
    // As the buffer is given it.
    float depthOf(const fmat4& clip, float distance, bool clipsToOne) const {
        if (mapping == Mapping::logarithmic) return std::log2(1 + distance) / std::log2(1 + float(far));
        return windowDepth(clip, distance, clipsToOne);
    }

    // The depth of each distance between near and far, and of the three things where the eye looks.
    void annotate(const Frame& frame) override {
        if (shown != Shown::curve) return;
        const fmat4 clip(clipFromView(frame.aspect(), zeroToOne()));
        const vec2 size(frame.width(), frame.height());
        const Plot plot{{size * vec2(0.12, 0.14), size * 0.9}, {near, far, "distance", true}, {0, 1, "depth"}};
        std::vector<vec2> values;
        for (int i = 0; i <= 300; ++i) {
            const double distance = plot.value(glm::mix(plot.box.low, plot.box.high, i / 300.0)).x;
            values.emplace_back(distance, keptDepth(format, depthOf(clip, float(distance), zeroToOne())));
        }
        drawing.begin(frame);
        drawing.fill({vec2(0), size}, vec4(1, 1, 1, 0.85));
        drawing.axes(plot);
        drawing.curve(plot, values, {.width = 2});
        for (const Plate& thing : platesOf()) {
            const double distance = -(thing.viewFromPlate * vec4(0.5, 0, 0, 1)).z;
            if (!(distance >= near && distance <= far)) continue;
            const float depth = depthOf(clip, float(distance), zeroToOne());
            drawing.point(plot.pixel({distance, keptDepth(format, depth)}), 9, vec4(thing.color, 1));
        }
        drawing.draw(frame);
    }
};

constexpr Declaration declaration{
    .name = "z-buffer",
    .sentence = "What hides what: the painter's order, and a depth for each pixel in several formats.",
    .lookFor = "Switch the depth test off: no order of the three bars is right, until each of them is cut in two.",
    .chapter = "Stereo and hidden surfaces",
    .number = 8,
    .width = 600,
    .height = 600,
    .needs = {.beyondEs = {{"clip control", "clip space has depths within -1..1, reversed as with --mapping flipped"}}},
    .presets =
        {
            {"cycle", "Each bar lies over one neighbour and under the other, in whatever order they are drawn."},
            {"painter",
             "Without the depth test what is drawn later covers what was drawn before: all orders are wrong somewhere.",
             {{"depth-test", "off"}}},
            {"greys",
             "The depth buffer itself, darker where it is nearer.",
             {{"show", "depth"}, {"near", "2.5"}, {"far", "10"}}},
            {"road",
             "The mark lies on the road and the road on the ground; far away 24 bits cannot tell them apart.",
             {{"scene", "road"}, {"separation", "4e-06"}}},
            {"road-reversed",
             "The same road in a float buffer with reversed depth: its steps are as fine as the distances.",
             {{"scene", "road"}, {"format", "d32f"}, {"mapping", "reversed"}, {"separation", "4e-06"}}},
            {"glass",
             "Panes that let light through, drawn from far to near; in another order the one behind is cut off.",
             {{"scene", "panes"}, {"order", "bgr"}, {"separation", "0.01"}, {"opacity", "0.6"}}},
        },
    .waste = {{"repeated-pass", "pass into 'scene'", "what the depth test costs in every frame is the lesson"},
              {"unused-buffer", "depth of 'scene'", "the painter's way does without what the others need"},
              {"unused-object", "texture 'scene'", "made once, for the settings that show it"}},
};

const bool added = addDemo<ZBuffer, declaration>();

}  // namespace

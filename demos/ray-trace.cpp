// ray-trace: rays that are followed through mirrors and glass, as Whitted did in 1980, with a lamp that has an area.
//
// Claims (each is a test in tests/claims/ray-trace.cpp; X22 in docs/stability.md is its extreme):
// - [energy] In a white room, with mirror and glass alone, what is seen and what the depth cuts off are 1 together.
// - [never-itself] A ray meets the surface that it leaves nowhere but on its other side.
// - [as-one-thread] However many threads share the rows, the picture has the same bits.
// - [soft-contact] A lamp without an area makes shadows that are on or off; one with an area makes them soft, and the softer,
//   the farther the body is from the floor.
// - [through-glass] Behind glass there is a shadow, and some light.
// - [squares-averaged] The floor's squares are averaged over the ray's cone as the mean of many places is.
// - [total-reflection] Where the slide's root is negative nothing is refracted, and all is reflected.
// - [both-ways] Lambert's, the mirror's and Fresnel's parts are the same with light and eye exchanged; the radiance in the glass, and
//   Phong's lobe as it is printed, are not.
// - [schlick-from-within] Schlick's curve by the angle within the glass is off by up to 0.96 near total reflection.
// - [more-samples] More samples come nearer; in cells, or in a sequence, faster than at random.
// - [same-answers] None, boxes, grid and tree find the same triangle at the same t, bit for bit.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/made_for.h"
#include "mv/error.h"
#include "mv/gl/text.h"
#include "mv/math/transform.h"
#include "shared/trace_picture.h"

using namespace mv;

namespace {

enum class FresnelForm { exact, schlick };
enum class Show { light, cut, rays };

struct RayTrace final : Demo {
    Choice<TracedRoom> room{this,
                            "room",
                            TracedRoom::stillLife,
                            {{"still-life", "mirror, glass, a floor of squares"},
                             {"teapot", "triangles beside a mirror"},
                             {"soft-shadow", "a ball over a grey floor"},
                             {"lamp", "that floor and the lamp alone"},
                             {"white", "mirror and glass where all else is white and shines"}},
                            "what is seen"};
    Choice<Show> show{this,
                      "show",
                      Show::light,
                      {{"light"}, {"cut", "what the depth leaves out"}, {"rays", "how many a sample takes"}},
                      "of each pixel"};
    Whole depth{this, "depth", 8, {0, 16}, "rays that follow each other, at most"};
    NumberChoice samples{this, "samples", 16, {1, 4, 16, 64, 256}, "rays through each pixel"};
    Choice<SamplePattern> pattern{this,
                                  "pattern",
                                  SamplePattern::sequence,
                                  {{"regular", "the middles of equal cells"},
                                   {"random"},
                                   {"jittered", "one in each cell, at random"},
                                   {"sequence", "a (0,2)-sequence"}},
                                  "where in the pixel, and on the lamp"};
    Real lampSize{this, "lamp-size", 1.1, {0, 2}, "half a side of the lamp"};
    Real index{this, "index", 1.5, {1, 2.5}, "of the glass"};
    Choice<FresnelForm> form{this,
                             "fresnel",
                             FresnelForm::exact,
                             {{"exact"}, {"schlick", "Schlick's curve, by the angle on the ray's own side"}},
                             "which part glass reflects"};
    Toggle shadows{this, "shadows", true, "ask whether the lamp is seen"};
    Toggle filtered{this, "filtered", true, "average the floor's squares over the ray's cone"};
    Choice<RayStructure> structure{this,
                                   "structure",
                                   RayStructure::tree,
                                   {{"none", "every triangle is asked"},
                                    {"boxes", "those of the patches whose box is met"},
                                    {"grid", "those in the cells along the ray"},
                                    {"tree", "a bounding volume hierarchy"}},
                                   "how a ray finds its triangle"};
    NumberChoice triangles{this,
                           "triangles",
                           4096,
                           {1024, 4096, 16384, 65536, 262144, 1048576},
                           "of the teapot, less those that have collapsed to an edge"};
    Angle eyeTurn{this, "eye-turn", 0, "of the eye about the middle"};
    Real eyeHeight{this, "eye-height", 2, {0.2, 5}, "of the eye above the floor"};
    Whole seed{this, "seed", 1, {1, 8}, "of what is random"};

    Readout rays{this, "rays", "rays a pixel, with those to the lamp"};
    Readout cut{this, "cut", "of the light that rays would bring, what the depth leaves out", "%"};
    Readout cutMost{this, "cut-most", "the same, of the pixel where it is most", "%"};
    Readout missing{this, "missing", "in the white room: how far a pixel's light and what is cut are from 1, at most"};

    TracePicture picture;
    mutable std::shared_ptr<const TriangleFinder> madeFinder;
    mutable MadeFor<RayStructure, int> finderFor;

    RayTrace() {
        bindKeys(Key::left, Key::right, eyeTurn, 5);
        bindKeys(Key::down, Key::up, depth, 1);
        bindDrag(eyeTurn, 0.5, eyeHeight, 0.01);
        const auto hasLamp = [this] { return room != TracedRoom::white; };
        const auto hasGlass = [this] { return room == TracedRoom::stillLife || room == TracedRoom::white; };
        const auto hasTriangles = [this] { return room == TracedRoom::teapot; };
        lampSize.onlyWhen(hasLamp, "there is no lamp");
        shadows.onlyWhen(hasLamp, "there is no lamp");
        filtered.onlyWhen([this] { return room == TracedRoom::stillLife || room == TracedRoom::teapot; },
                          "there are no squares");
        structure.onlyWhen(hasTriangles, "there are no triangles");
        triangles.onlyWhen(hasTriangles, "there are no triangles");
        index.onlyWhen(hasGlass, "there is no glass");
        form.onlyWhen(hasGlass, "there is no glass");
        depth.onlyWhen([this] { return room != TracedRoom::softShadow && room != TracedRoom::lamp; },
                       "nothing is followed");
        lampSize.onlyWhen([this] { return shadows; }, "without shadows only the lamp's middle is asked");
    }

    void init() override {}

    void check() const override {
        if (room != TracedRoom::teapot) return;
        const int most = structure == RayStructure::none ? 1024 : structure == RayStructure::boxes ? 4096 : 1 << 20;
        if (triangles > most)
            throw Error("--triangles",
                        "must be at most " + std::to_string(most) + " with --structure " + structure.text() +
                            ", or a picture takes minutes; with grid or tree it may be",
                        triangles.text());
    }

    std::shared_ptr<const TriangleFinder> finder() const {
        if (room != TracedRoom::teapot) return {};
        if (finderFor.changed(structure, triangles)) {
            const int cells = static_cast<int>(std::lround(std::sqrt(triangles / 64.0)));
            madeFinder = findTriangles(structure, teapotTriangles(cells));
        }
        return madeFinder;
    }

    TracePicture::Plan plan(int width, int height) const {
        const mat4 turn = rotateY(eyeTurn);
        const vec3 eye(turn * vec4(0.3, eyeHeight, 6.2, 1));
        const TraceOptions options{
            .depth = depth, .shadows = shadows, .schlick = form == FresnelForm::schlick, .filtered = filtered};
        const double size = shadows ? double(lampSize) : 0;
        return {tracedRoom(room, size, index, finder()),
                {eye, {0.1, 0.65, 0}, 34.4},
                options,
                pattern,
                samples,
                static_cast<std::uint32_t>(int(seed)),
                width,
                height};
    }

    // ---- the passes: blocks, then a sample more for each pixel

    int passes(const FrameInfo&) const override { return TracePicture::passesOf(samples); }
    void refine(const FrameInfo& frame, int pass) override { picture.pass(plan(frame.width(), frame.height()), pass); }

    void draw(const Frame& frame) override {
        showImage(frame, 0, 0, shown());
        const double pixels = double(picture.light().size());
        double all = 0, most = 0, off = 0;
        for (std::size_t i = 0; i < picture.light().size(); ++i) {
            all += picture.cut()[i];
            most = std::max(most, picture.cut()[i]);
            const vec3 sum = picture.light()[i] + picture.cut()[i] - 1.0;
            off = std::max({off, std::abs(sum.x), std::abs(sum.y), std::abs(sum.z)});
        }
        rays = double(picture.rays()) / pixels;
        cut = 100 * all / pixels;
        cutMost = 100 * most;
        if (room == TracedRoom::white) missing = off;
    }

    // The light, or a number of each pixel in grey, white where it is largest.
    Picture shown() const {
        if (show == Show::light) return developed(picture.light(), picture.width(), picture.height());
        const double most = std::max(largest(), 1e-300);
        std::vector<vec3> greys;
        greys.reserve(numbers().size());
        for (const double number : numbers()) greys.emplace_back(number / most);
        return developed(greys, picture.width(), picture.height());
    }
    const std::vector<double>& numbers() const { return show == Show::cut ? picture.cut() : picture.raysAt(); }
    double largest() const { return *std::ranges::max_element(numbers()); }

    void annotate(const Frame& frame) override {
        if (show == Show::light) return;
        const std::string what = show == Show::rays
                                     ? rounded("white: %.3g rays a sample", largest())
                                     : rounded("white: %.3g %% of the light is cut off", 100 * largest());
        const TextStyle style{std::clamp(frame.height() / 20, 8, 24)};
        drawText(frame, 6, frame.height() - textHeight(style) - 6, what, style);
    }

    // For the study: the middle of a picture of 48 x 32 pixels for each of eight seeds, as grey; of triangles the t of a thousand rays, 0 for none.
    static constexpr int studyWidth = 24, studyHeight = 16, studySeeds = 8;
    std::vector<double> values() const override {
        if (room == TracedRoom::teapot) return thousandRays();
        std::vector<double> greys;
        for (int one = 1; one <= studySeeds; ++one) {
            TracePicture::Plan small = plan(studyWidth, studyHeight);
            small.view.fovy = halved(small.view.fovy);
            small.seed = static_cast<std::uint32_t>(100 * int(seed) + one);
            TracePicture made;
            made.pass(small, 0);
            for (int pass = TracePicture::passesOf(0); pass < TracePicture::passesOf(samples); ++pass)
                made.pass(small, pass);
            for (const vec3& light : made.light()) greys.push_back((light.x + light.y + light.z) / 3);
        }
        return greys;
    }
    // By how much the seeds' mean squares differ from each other, each taken from the mean of all seeds' pictures.
    std::vector<std::pair<std::string, double>> valueCounts() const override {
        if (room == TracedRoom::teapot) return {};
        const std::vector<double> greys = values();
        constexpr std::size_t pixels = std::size_t{studyWidth} * studyHeight;
        std::vector<double> mean(pixels, 0), squares(studySeeds, 0);
        for (std::size_t i = 0; i < greys.size(); ++i) mean[i % pixels] += greys[i] / studySeeds;
        for (std::size_t i = 0; i < greys.size(); ++i)
            squares[i / pixels] += (greys[i] - mean[i % pixels]) * (greys[i] - mean[i % pixels]);
        double sum = 0, deviation = 0;
        for (const double one : squares) sum += one / studySeeds;
        for (const double one : squares) deviation += (one - sum) * (one - sum) / (studySeeds - 1);
        return {{"deviation of the seeds (%)", sum > 0 ? 100 * std::sqrt(deviation) / sum : 0}};
    }
    std::vector<double> thousandRays() const {
        const TracePicture::Plan small = plan(40, 25);
        std::vector<double> ts;
        for (const Ray& ray : raysThrough(small)) {
            const auto hit = small.scene.mesh->nearest(ray);
            ts.push_back(hit ? hit->hit.t : 0);
        }
        return ts;
    }
};

constexpr Declaration declaration{
    .name = "ray-trace",
    .sentence =
        "Rays followed through mirrors and glass to a lamp with an area, in passes that make the picture better.",
    .lookFor =
        "The glass ball turns the room upside down, and its shadow has light in it; the lamp's shadows are "
        "sharp where a ball touches the floor.",
    .chapter = "Rays, clipping and pixels",
    .number = 23,
    .width = 480,
    .height = 320,
    .background = vec4(1, 1, 1, 1),
    .presets =
        {
            {"still-life", "Mirror, glass, squares that do not flicker, soft shadows."},
            {"teapot", "Triangles, which a tree finds.", {{"room", "teapot"}}},
            {"soft",
             "A large lamp asked at random places: the noise of few samples.",
             {{"lamp-size", "2"}, {"room", "soft-shadow"}, {"pattern", "random"}, {"samples", "4"}}},
            {"diamond", "A larger index: more is reflected, and more totally.", {{"index", "2.4"}}},
            {"cut-off",
             "Where all light is 1, what is missing is what the depth has cut off.",
             {{"room", "white"}, {"depth", "3"}, {"show", "cut"}}},
            {"rays", "How many rays a sample takes: most where glass and mirror see each other.", {{"show", "rays"}}},
        },
};

const bool added = addDemo<RayTrace, declaration>();

}  // namespace

// The readouts of bump-map, and its study: its pictures against lines of sight to the displaced surface.
#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "bump-map.h"
#include "mv/demo/cached.h"
#include "mv/demo/lesson.h"
#include "mv/math/color.h"
#include "shared/in_rows.h"
#include "shared/relief_maps.h"
#include "shared/relief_rays.h"
#include "shared/seen_pixels.h"

namespace mv::bump_map {

using namespace claims;

void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers) {
    if (s.method == Method::displaced) {
        const auto [first, last] = piecesInView(s, leftPane(s, frame).aspect());
        numbers.set("triangles", (last - first + 1) * gpu.real->mesh.count() / 3.0);
        return numbers.set("lookups", 1);
    }
    constexpr std::array<int, 5> lookupsOf{1, 5, 2, 3, 3};
    numbers.set("triangles", gpu.flat->mesh.count() / 3.0);
    numbers.set("lookups",
                lookupsOf.at(static_cast<std::size_t>(s.method)) + (s.method == Method::occlusion ? s.layers : 0));
}

// A ring of the orange is measured, 5 degrees wide: the sines of its edges.
vec2 measuredBand(const Settings& s) {
    if (s.body == ReliefBody::wall) return {-1, 1e9};
    return {s.angle < 2.5 ? -1 : std::sin(radians(s.angle - 2.5)), std::sin(radians(s.angle + 2.5))};
}

namespace {

// The luminance of the displaced surface along lines of sight; of the background beside the orange.
class Seen {
  public:
    Seen(const Settings& s, const FrameInfo& frame)
        : relief_{s.body, s.depth, isMirrored(s)}, width_(frame.width()), height_(frame.height()), angle_(s.angle) {
        const Scene scene = sceneOf(s, frame);
        worldFromClip_ = glm::inverse(scene.clipFromWorld());
        light_ = vec3(scene.lights.front().position);
        way_ = glm::normalize(vec3(worldFromClip_ * vec4(0, 0, 1, 0)));
    }

    // Columns and rows from the upper left corner.
    vec3 from(double column, double row) const {
        return vec3(worldFromClip_ * vec4(2 * column / width_ - 1, 1 - 2 * row / height_, -1, 1));
    }
    double at(double column, double row) const {
        const auto hit = firstHit(relief_, from(column, row), way_);
        if (!hit) return beside_;
        return luminance(reliefLight(hit->color, displacedNormal(relief_, *hit), light_, -way_));
    }
    // On the orange a ring, 5 degrees wide.
    bool counts(double column, double row) const {
        if (relief_.body == ReliefBody::wall) return true;
        const double away = glm::length(glm::cross(way_, from(column, row)));
        return (angle_ < 2.5 || away >= std::sin(radians(angle_ - 2.5))) && away <= std::sin(radians(angle_ + 2.5));
    }
    // The mean of side x side lines of sight; -1 where nothing counts.
    std::vector<double> means(int side, const std::function<void(double)>& progress = {}) const {
        std::vector<double> means(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
        const std::thread::id here = std::this_thread::get_id();
        inRows(height_, 0, [&](int row) {
            for (int column = 0; column < width_; ++column)
                means[pixelIndex(column, row, width_)] = mean(column, row, side);
            if (progress && std::this_thread::get_id() == here) progress(double(row) / height_);
        });
        return means;
    }

    bool operator==(const Seen&) const = default;

  private:
    double mean(int column, int row, int side) const {
        if (!counts(column + 0.5, row + 0.5)) return -1;
        double sum = 0;
        for (int i = 0; i < side; ++i) {
            for (int j = 0; j < side; ++j) sum += at(column + (j + 0.5) / side, row + (i + 0.5) / side);
        }
        return sum / (side * side);
    }

    // The background is kept in sRGB.
    double beside_ = luminance({linearFromSrgb(0.93), linearFromSrgb(0.94), linearFromSrgb(0.96)});
    Relief relief_;
    int width_, height_;
    double angle_;
    mat4 worldFromClip_;
    vec3 light_, way_;
};

// Lines of sight along each side of a pixel: of the orange some thousand pixels count, and many are at its outline.
int sideOf(const Settings& s) { return s.body == ReliefBody::wall ? 2 : 6; }

// Paint and heights are formulas, which a picture of the user's own is not.
bool isMeasured(const Settings& s) { return !s.picture.isSet(); }

Reference reference(const Demo& demo, const ReferenceFrame& frame, const std::function<void(double)>& progress) {
    const auto s = settingsOf<Settings>(demo);
    if (!isMeasured(s)) throw Error("--picture", "must be none to be measured", s.picture.name);
    const Seen seen(s, frame);
    const int side = sideOf(s);
    Reference right{.values = seen.means(side, progress)};
    right.regions = regionsOfSeen(right.values);
    if (frame.ownError) right.ownError = rmsBetween(right.values, seen.means(2 * side, progress)).value_or(0);
    right.work = double(side) * side * double(right.values.size());
    return right;
}

// The error of the present settings, in few pixels.
std::vector<double> errorNow(Probing& probing) {
    const auto s = settingsOf<Settings>(probing.demo());
    if (!isMeasured(s)) return {};
    constexpr int width = 80, height = 60;
    const std::vector<float> shown = probing.measured(width, height);
    if (shown.empty()) return {};
    const Seen seen(s, {probing.frame().index(), width, height});
    static Cached<std::vector<double>, Seen> kept;
    return rmsOfShown(shown, kept.of({seen}, [](const Seen& one) { return one.means(2); }));
}

// How far the normals of the normal map are from the true ones, before any filter: the root mean square, in degrees.
std::vector<double> errorOfMap(Probing& probing) {
    const auto s = settingsOf<Settings>(probing.demo());
    if (!isMeasured(s)) return {};
    static Cached<double, ReliefBody, double, int, Kept> kept;
    return {kept.of({s.body, s.depth, s.mapSize, s.texels}, [](ReliefBody body, double depth, int size, Kept texels) {
        return normalMapError({body, depth}, size, texels == Kept::bytes);
    })};
}

Study study() {
    Study study;
    study.quantity = "luminance of the wall, and of a ring of the orange that is seen at the angle";
    study.reference =
        "the mean of 4 lines of sight a pixel to the displaced wall, 36 to the orange, marched in double precision";
    study.makeReference = reference;
    study.reads = {"body", "depth", "angle", "mirrored", "picture", "lamp-turn", "lamp-height", "spin-x", "spin-y"};
    study.scenes = {{"wall", {{"body", "wall"}}}, {"orange", {{"body", "orange"}, {"depth", "0.04"}}}};
    for (const std::string method : {"smooth", "height", "normal", "parallax", "occlusion", "displaced"}) {
        StudyLine line{method, {{"method", method}, {"beside", "off"}}, "angle", {"0", "20", "40", "60", "80", "85"}};
        if (method == "displaced") line.scenes = {"wall"};
        study.lines.push_back(line);
    }
    study.problem = "angle";
    study.wrongBeyond = 0.05;
    study.width = 320;
    study.height = 240;
    const auto paint = rows("smooth"), bumped = rows("normal"), mesh = rows("displaced").in("wall");
    const auto maps = rows("height", "normal", "parallax", "occlusion");
    study.says = {
        claim("straight-on", "Straight on, a normal map leaves a fifth of the wall's error by mere paint, or less.",
              {ratio(of::rms, bumped.in("wall").at(0), paint.in("wall"), 0, 0.2)}),
        claim("as-wrong-as-paint",
              "From 40 degrees on it leaves at least five sixths of that error: the light is right, but in the wrong "
              "place.",
              {ratio(of::rms, bumped.in("wall").from(40), paint.in("wall"), 0.83, 1.5)}),
        claim("occlusion-pays",
              "From 20 to 80 degrees parallax occlusion leaves two thirds of the normal map's error, or less.",
              {ratio(of::rms, rows("occlusion").in("wall").from(20).upTo(80), bumped.in("wall"), 0, 0.67)}),
        claim("all-fail", "At 85 degrees no map leaves less than three quarters of the wall's error by mere paint.",
              {ratio(of::rms, maps.in("wall").at(85), paint.in("wall"), 0.75, 1.5)}),
        claim("mesh-is-right",
              "From 60 degrees on the displaced mesh has at most nine tenths of the error of parallax occlusion.",
              {ratio(of::rms, mesh.from(60), rows("occlusion").in("wall"), 0, 0.9)}),
        claim("orange-inside",
              "On the orange a normal map leaves at most half of the error by mere paint up to 60 degrees.",
              {ratio(of::rms, bumped.in("orange").upTo(60), paint.in("orange"), 0, 0.5)}),
        claim("orange-outline",
              "At 85 degrees all maps are as wrong there as mere paint, within 5 %: what is wrong is the outline.",
              {ratio(of::rms, maps.in("orange").at(85), paint.in("orange"), 0.95, 1.05)}),
        claim("layers-cost",
              "On a processor parallax occlusion in 32 layers takes at least one and a half times as long as a normal "
              "map.",
              {ratio(of::time, rows("occlusion"), bumped, 1.5, 100)}),
        claim("layers-cost-little", "On this GPU it takes at most twice as long.",
              {ratio(of::time, rows("occlusion"), bumped, 0, 2)}),
        note("The wall's error by a normal map does not grow all the way: from 60 to 80 degrees bricks are seen "
             "narrower, and "
             "so are the places at which it is wrong."),
        note("On the orange a ring counts that is seen at the angle, give or take 2.5 degrees.")};
    return study;
}

const bool studied = addStudy("bump-map", study());
const bool probed = addProbes(
    "bump-map",
    {{{{"picture-error", "root mean square error of the luminance against the displaced surface, in 80 x 60 pixels"}},
      errorNow},
     {{{"map-error", "how far the normal map's normals are from the true ones, root mean square", "deg"}},
      errorOfMap}});

}  // namespace
}  // namespace mv::bump_map

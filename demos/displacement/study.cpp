// The readouts of displacement, and its study: which pixels it covers, against lines of sight to the true relief; and
// holes.
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <utility>
#include <vector>

#include "displacement.h"
#include "mv/demo/cached.h"
#include "mv/demo/lesson.h"
#include "mv/gl/functions.h"
#include "shared/relief_rays.h"

namespace mv::displacement {

using namespace claims;

void readOut(Gpu& gpu, const Settings& s, const Frame&, Numbers& numbers) {
    if (gpu.rasterized) numbers.set("triangles", *gpu.rasterized);
    if (!isTessellated(s)) return;
    numbers.set("patches", double(gpu.counted.patches - gpu.counted.leftOut));
    numbers.set("left-out", double(gpu.counted.leftOut));
}

// Draw what a study measures: a picture that is 0 in the pixels beside the surface.
void drawCoverage(Gpu& gpu, const Settings& s, const Frame& frame) {
    glClearColor(0, 0, 0, 0);
    glClear(GL_COLOR_BUFFER_BIT);
    draw(gpu, s, frame);
}

namespace {

// Which lines of sight meet the relief, in double precision.
class Seen {
  public:
    Seen(const Settings& s, const FrameInfo& frame) : relief_{s.body, s.depth}, frame_(frame) {
        const Scene scene = sceneOf(s, frame);
        worldFromClip_ = glm::inverse(scene.clipFromWorld());
        eye_ = vec3(glm::inverse(scene.viewFromWorld)[3]);
    }

    // Columns and rows from the upper left corner. Rays are marched only where the bodies without depth and with all of it do
    // not say so already.
    bool covers(double column, double row) const {
        const vec4 far = worldFromClip_ * vec4(2 * column / frame_.width() - 1, 1 - 2 * row / frame_.height(), 1, 1);
        const vec3 way = glm::normalize(vec3(far) / far.w - eye_);
        if (relief_.body == ReliefBody::wall) {
            if (!(way.z < 0) || !isInWall(at(way, 0))) return false;
            if (isInWall(at(way, -relief_.depth))) return true;
            // The eye stands before the wall: a line that leaves it has met nothing of it, and does not come back.
            const auto hit = firstHit(relief_, eye_, way);
            return hit && isInWall(hit->smooth);
        }
        const double away = glm::length(glm::cross(way, eye_));
        if (away >= 1) return false;
        return away < 1 - relief_.depth || firstHit(relief_, eye_, way).has_value();
    }

  private:
    vec3 at(const vec3& way, double z) const { return eye_ + (z - eye_.z) / way.z * way; }
    static bool isInWall(const vec3& p) { return p.x >= wallStart && p.x <= wallEnd && std::abs(p.y) <= wallTop; }

    Relief relief_;
    FrameInfo frame_;
    mat4 worldFromClip_;
    vec3 eye_;
};

Reference reference(const Demo& demo, const ReferenceFrame& frame, const std::function<void(double)>& progress) {
    const Seen seen(settingsOf<Settings>(demo), frame);
    Reference right;
    right.values.reserve(static_cast<std::size_t>(frame.width()) * static_cast<std::size_t>(frame.height()));
    for (int row = 0; row < frame.height(); ++row) {
        for (int column = 0; column < frame.width(); ++column)
            right.values.push_back(seen.covers(column + 0.5, row + 0.5) ? 1 : 0);
        if (progress) progress(double(row) / frame.height());
    }
    right.work = double(right.values.size());
    return right;
}

// Pixels that the surface does not cover, and from which no way leads to the picture's edge through others of that kind.
std::vector<double> holesNow(Probing& probing) {
    const int width = probing.frame().width(), height = probing.frame().height();
    std::vector<float> covered = probing.measured(width, height);
    if (covered.empty()) return {};
    std::vector<std::pair<int, int>> reached;
    const auto reach = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= width || y >= height || covered[pixelIndex(x, y, width)] > 0) return;
        covered[pixelIndex(x, y, width)] = 1;
        reached.emplace_back(x, y);
    };
    for (int x = 0; x < width; ++x) {
        for (const int y : {0, height - 1}) reach(x, y);
    }
    for (int y = 0; y < height; ++y) {
        for (const int x : {0, width - 1}) reach(x, y);
    }
    while (!reached.empty()) {
        const auto [x, y] = reached.back();
        reached.pop_back();
        reach(x - 1, y);
        reach(x + 1, y);
        reach(x, y - 1);
        reach(x, y + 1);
    }
    double holes = 0;
    for (const float value : covered) holes += value > 0 ? 0 : 1;
    return {holes};
}

// The processor's mesh asks no map.
std::vector<double> errorOfMap(Probing& probing) {
    const auto s = settingsOf<Settings>(probing.demo());
    if (s.method == Method::prepared) return {};
    static Cached<double, ReliefBody, double, int> kept;
    return {1000 * kept.of({s.body, s.depth, s.mapSize}, [](ReliefBody body, double depth, int size) {
        return heightMapError({body, depth}, size);
    })};
}

Study study() {
    Study study;
    study.quantity = "whether the surface covers the middle of a pixel";
    study.reference = "a line of sight through it to the relief, marched in double precision";
    study.makeReference = reference;
    study.reads = {"body", "depth", "distance", "angle", "spin-x", "spin-y"};
    study.scenes = {{"wall"}, {"orange", {{"body", "orange"}}}};
    const std::vector<std::string> cells{"4", "8", "16", "32", "64"};
    study.lines = {
        {"not moved", {{"method", "bumped"}, {"levels", "fixed"}}, "level", {"16"}},
        {"prepared", {{"method", "prepared"}}, "level", cells},
        {"fixed level", {{"levels", "fixed"}}, "level", cells},
        {"finer map", {{"levels", "fixed"}, {"map-size", "512"}}, "level", {"64"}},
        {"by distance", {{"levels", "distance"}}, "fineness", {"8", "16", "32", "64", "128", "256"}},
    };
    study.axis = ErrorAxis::fraction;
    const auto prepared = rows("prepared"), fixed = rows("fixed level"), distant = rows("by distance");
    const StudyNumber made = of::count("triangles made");
    const auto onWall = [](const StudyRows& which, double p) { return which.in("wall").at(p); };
    const auto onOrange = [](const StudyRows& which, double p) { return which.in("orange").at(p); };
    study.says = {
        claim("moved-is-nearer",
              "From level 16 on, what is moved leaves at most a third of the wrong pixels of what is not.",
              {ratio(of::wrong, rows("prepared", "fixed level").from(16), rows("not moved"), 0, 0.333)}),
        claim("coarse-is-worse",
              "At level 4 the moved orange has more than twice the wrong pixels of the one that is not moved, at level "
              "16: "
              "a coarse outline is off by more than the pores are deep.",
              {ratio(of::wrong, onOrange(fixed, 4), rows("not moved").in("orange"), 2, 4)}),
        claim("finer-is-nearer", "Wrong pixels go as the level or the fineness to a power between -1.6 and -1.",
              {slope(of::wrong, rows("prepared", "fixed level", "by distance"), -1.6, -1)}),
        claim("far-needs-less",
              "On the wall levels by distance with fineness 64 are as near as level 16 for all, give or take a tenth, "
              "with a "
              "quarter of the triangles.",
              {ratio(of::wrong, onWall(distant, 64), onWall(fixed, 16), 0.9, 1.1),
               ratio(made, onWall(distant, 64), onWall(fixed, 16), 0, 0.25)}),
        claim(
            "nearer-with-as-many",
            "With fineness 128 they have no more triangles than level 16, and at most six tenths of its wrong pixels.",
            {ratio(of::wrong, onWall(distant, 128), onWall(fixed, 16), 0, 0.6),
             ratio(made, onWall(distant, 128), onWall(fixed, 16), 0, 1)}),
        claim("orange-alike",
              "On the orange, all of which is about as far away, they do not pay: fineness 64 is between level 8 and "
              "level "
              "16, in wrong pixels as in triangles.",
              {ratio(of::wrong, onOrange(distant, 64), onOrange(fixed, 8), 0, 1),
               ratio(of::wrong, onOrange(distant, 64), onOrange(fixed, 16), 1, 3),
               ratio(made, onOrange(distant, 64), onOrange(fixed, 8), 1, 4),
               ratio(made, onOrange(distant, 64), onOrange(fixed, 16), 0, 1)}),
        claim("map-limits",
              "On the orange at level 64 the map of 256 rows leaves more than twice the wrong pixels of the prepared "
              "mesh, "
              "which asks the relief itself; one of 512 rows leaves less than six tenths of its own.",
              {ratio(of::wrong, onOrange(fixed, 64), onOrange(prepared, 64), 2, 5),
               ratio(of::wrong, onOrange(rows("finer map"), 64), onOrange(fixed, 64), 0, 0.6)}),
        claim(
            "prepared-is-faster",
            "On a processor a prepared mesh of 32 cells a patch or more is drawn faster than the tessellator makes one "
            "of that level.",
            {ratio(of::time, fixed.from(32), prepared, 1, 20)}),
        claim("tessellator-is-faster", "On this GPU the tessellator's is the faster.",
              {ratio(of::time, fixed.from(32), prepared, 0, 1)}),
        note("A prepared mesh is made once, before the first picture, and that time is not counted. It stays as it is: "
             "where the eye comes near, it is too coarse, and far away too fine."),
        note("Wrong are pixels at the outline alone: all others are covered by every method, or by none.")};
    return study;
}

const bool studied = addStudy("displacement", study());
const bool probed =
    addProbes("displacement",
              {{{{"holes", "pixels of the background that are seen through the surface", "px"}}, holesNow},
               {{{"map-error", "how far the height map is off between its texels, root mean square", "thousandths"}},
                errorOfMap}});

}  // namespace
}  // namespace mv::displacement

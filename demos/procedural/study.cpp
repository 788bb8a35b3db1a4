// The readouts of procedural, and its study: its numbers against the true mean of each pixel.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mv/demo/lesson.h"
#include "mv/image/picture.h"
#include "mv/math/transform.h"
#include "procedural.h"
#include "shared/in_rows.h"
#include "shared/seen_pixels.h"

namespace mv::procedural {

using namespace claims;

// The depth of the sphere's nearest point, and of the floor in the middle and at the lower edge.
static constexpr double frontOfSphere = 4.2 - sphereRadius, middleOfFloor = 5.1, frontOfFloor = 1.81;

// How far apart the points of neighbouring pixels are across a surface at this depth; the wall is seen without perspective.
static double pixelAt(const Settings& s, const FrameInfo& frame, double depth) {
    if (s.view == View::wall) return 3 / (s.zoom * frame.height());
    return 2 * depth * std::tan(radians(20)) / frame.height();
}

void readOut(Gpu&, const Settings& s, const Frame& frame, Numbers& numbers) {
    numbers.set("pixel", pixelAt(s, frame, s.view == View::floor ? middleOfFloor : frontOfSphere));
    const auto far = static_cast<float>(std::max(std::abs(placeOf(s).centre.x), 1e-30));
    numbers.set("float-step", double(std::nextafter(far, HUGE_VALF)) - double(far));
    if (!isFromTexture(s)) return;
    numbers.set("texel", textureSide(s, frame) / s.texels);
    numbers.set("texture-size", std::pow(s.texels, 3) / 1024);
}

// An octave of which no pixel keeps anything costs as much as another; only leave-out does not compute it.
void nameFinerOctaves(const Settings& s, const Frame& frame) {
    if (s.filter == Filter::leaveOut || s.pattern == Pattern::brick) return;
    const double finest = pixelAt(s, frame, s.view == View::floor ? frontOfFloor : frontOfSphere) /
                          (s.filter == Filter::samples ? s.samples : 1);
    for (const auto& octave : placeOf(s).octaveList()) {
        // A wave is two cells long, as in shaders/include/procedural.glsl
        if (octave.weight == 0 || 0.5 * octave.frequency * finest < 1) continue;
        frame.needless("octave of frequency " + numberText(octave.frequency) + ", finer than every pixel");
    }
}

Scene sceneOf(const Settings& s, const FrameInfo& frame) {
    Scene scene;
    scene.objects = {{.name = "body", .mesh = s.view == View::sphere ? sphere(sphereRadius, 128, 64) : square()}};
    scene.viewFromWorld = bodyMatrices(s, frame).clipFromBody;
    return scene;
}

namespace {

// Which point of the pattern a place of the picture shows, as an offset from its centre.
class Shown {
  public:
    Shown(const Settings& s, const FrameInfo& frame)
        : s_(s),
          turn_(bodyMatrices(s, frame).viewFromBody),
          frame_(frame),
          bodyFromClip_(glm::inverse(bodyMatrices(s, frame).clipFromBody)) {}

    // Columns and rows from the upper left corner. Nothing beside the body; of the floor nothing beyond 20 units, of the sphere
    // nothing that is turned away by more than 60 degrees.
    std::optional<vec3> at(double column, double row, bool isMiddle = false) const {
        const vec2 place(2 * column / frame_.width() - 1, 1 - 2 * row / frame_.height());
        if (s_.view == View::wall) return vec3(1.5 * frame_.aspect() * place.x, 1.5 * place.y, 0) / s_.zoom;
        const vec4 near = bodyFromClip_ * vec4(place, -1, 1), far = bodyFromClip_ * vec4(place, 0.5, 1);
        const vec3 from = vec3(near) / near.w, way = glm::normalize(vec3(far) / far.w - from);
        if (s_.view == View::floor) {
            const double t = -from.y / way.y;
            const vec3 offset = 400.0 * vec3(from.x + t * way.x, 0.5 - (from.z + t * way.z), 0);
            return t > 0 && (!isMiddle || offset.y < 20) ? std::optional(offset) : std::nullopt;
        }
        const double along = -glm::dot(from, way), square = glm::dot(from, from) - along * along;
        if (square > 1.69) return {};
        const vec3 point = from + (along - std::sqrt(1.69 - square)) * way;
        return !isMiddle || (turn_ * vec4(point, 0)).z > 0.5 * 1.3 ? std::optional(point) : std::nullopt;
    }

  private:
    Settings s_;
    mat4 turn_;
    FrameInfo frame_;
    mat4 bodyFromClip_;
};

// The mean of side x side points of each pixel in every row and column of that step, the upper row first; -1 where nothing is
// asked.
std::vector<double> trueMeans(const Settings& s, const FrameInfo& frame, int side, int step = 1) {
    const Shown shown(s, frame);
    const PatternPlace place = placeOf(s);
    std::vector<double> means(static_cast<std::size_t>(frame.width()) * static_cast<std::size_t>(frame.height()), -1.0);
    inRows((frame.height() + step - 1) / step, 0, [&](int line) {
        const int row = line * step;
        std::vector<vec3> offsets;
        for (int column = 0; column < frame.width(); column += step) {
            if (!shown.at(column + 0.5, row + 0.5, true)) continue;
            offsets.clear();
            for (int i = 0; i < side; ++i) {
                for (int j = 0; j < side; ++j) {
                    const auto offset = shown.at(column + (j + 0.5) / side, row + (i + 0.5) / side);
                    if (offset) offsets.push_back(*offset);
                }
            }
            double sum = 0;
            for (const double value : patternAt(place, offsets)) sum += value;
            means[pixelIndex(column, row, frame.width())] = sum / double(offsets.size());
        }
    });
    return means;
}

Reference reference(const Settings& s, const ReferenceFrame& frame) {
    Reference right{.values = trueMeans(s, frame, 20)};
    right.regions = regionsOfSeen(right.values);
    if (frame.ownError) {
        // One pixel of 16 is enough for a root mean square.
        right.ownError = rmsBetween(right.values, trueMeans(s, frame, 40, 4)).value_or(0);
    }
    return right;
}

Study study() {
    Study study;
    study.quantity =
        "the pattern's number 0..1 in the pixels of a wall, or of a floor up to 20 times the eye's height away";
    study.reference = "the mean of 400 points of each pixel, in double precision";
    study.makeReference = [](const Demo& demo, const ReferenceFrame& frame, const auto&) {
        return reference(settingsOf<Settings>(demo), frame);
    };
    study.width = 240;
    study.height = 180;
    const auto floorOf = [](const std::string& pattern) {
        return std::vector<KnobSetting>{{"view", "floor"}, {"pattern", pattern}, {"octaves", "6"}};
    };
    study.scenes = {{"noise", floorOf("noise")},
                    {"brick", floorOf("brick")},
                    {"wall", {{"view", "wall"}, {"pattern", "wood"}, {"octaves", "3"}}}};
    const std::vector<std::string> floors{"noise", "brick"};
    study.lines = {{.method = "one point", .settings = {{"filter", "none"}}},
                   {.method = "samples",
                    .settings = {{"filter", "samples"}},
                    .knob = "samples",
                    .values = {"2", "3", "4", "6", "8"},
                    .scenes = floors},
                   {.method = "left out", .settings = {{"filter", "leave-out"}}, .scenes = floors},
                   {.method = "3D texture",
                    .settings = {{"source", "texture"}},
                    .knob = "texels",
                    .values = {"16", "32", "64", "128"},
                    .scenes = {"wall"}}};
    study.reads = {"pattern", "view", "source", "octaves", "zoom", "endless", "distance", "turn"};
    study.wrongBeyond = 0.05;
    study.says = {
        claim("samples", "Four times the samples, twice a side, leave at most 0.7 of the error.",
              {ratio(of::rms, rows("samples").at(4), rows("samples").at(2), 0, 0.7),
               ratio(of::rms, rows("samples").at(8), rows("samples").at(4), 0, 0.7)}),
        claim("bricks-left-out",
              "Bricks averaged over the pixel by a formula have less than half of the error of one point.",
              {ratio(of::rms, rows("left out").in("brick"), rows("one point").in("brick"), 0, 0.5)}),
        claim("cheap", "Leaving out takes at most 1.5 times as long as one point a pixel.",
              {ratio(of::time, rows("left out"), rows("one point"), 0, 1.5)}),
        claim("octaves-left-out",
              "Noise without the octaves that a pixel cannot show has at most 0.9 of the error of one point.",
              {ratio(of::rms, rows("left out").in("noise"), rows("one point").in("noise"), 0, 0.9)}),
        claim(
            "texels",
            "Measured on a processor, a 3D texture of 16 texels a side is nothing like the wood's formula, and from 64 "
            "texels to 128, for eight times the memory, its error falls to between a fifth and a third: the straight "
            "line between two texels is off by the square of their distance.",
            {atLeast(of::rms, rows("3D texture").at(16), 0.3),
             ratio(of::rms, rows("3D texture").at(128), rows("3D texture").at(64), 0.2, 0.34)}),
        claim("lookup", "On a processor a lookup takes at most a quarter of the time of three octaves and a cosine.",
              {ratio(of::time, rows("3D texture"), rows("one point").in("wall"), 0, 0.25)}),
        note("It is not nearer by more, since the mean of an octave over a few of its cells is not 0, and "
             "only samples find it; "
             "but it does not flicker.")};
    return study;
}

const bool studied = addStudy("procedural", study());

}  // namespace
}  // namespace mv::procedural

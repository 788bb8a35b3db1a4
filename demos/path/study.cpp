// The readouts of path, and its study: the turn of carried frames after a lap, and the length of a lap.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <string>
#include <vector>

#include "mv/demo/lesson.h"
#include "mv/motion/ode_adaptive.h"
#include "path.h"

namespace mv::path {
namespace {

void tellTrack(const Gpu& gpu, const Settings& s, const FrameInfo& frame, Numbers& numbers) {
    const double part = lapPart(s, frame), exact = pathOf(s.ride).way.length();
    const PathSample now = motionAt(s.ride, parameterAt(s.ride, part));
    const PathFrame axes = frameAt(gpu.lap, part, now.velocity);
    numbers.set("car-speed", glm::length(now.velocity));
    if (std::abs(axes.forward.y) < 0.999) numbers.set("lean", closingAngle(frameByUp(now.velocity, worldUp), axes));
    numbers.set("flips", double(gpu.lap.flips.size()));
    numbers.set("vanished", double(gpu.vanishedAt.size()));
    const auto [least, most] = std::ranges::minmax(gpu.lap.turns);
    numbers.set("most-turn", std::max(-least, most));
    if (s.ride.up == Up::minimizing)
        numbers.set("closing-angle", closingAngle(gpu.lap.frames.front(), gpu.lap.frames.back()));
    numbers.set("length", lengthOf(s.ride));
    numbers.set("length-off", lengthOf(s.ride) - exact);
}

void tellPoses(const Settings& s, const FrameInfo& frame, Numbers& numbers) {
    static constexpr std::array turnedBy{"turned-angles", "turned-slerp", "turned-nlerp"};
    static constexpr std::array unevenBy{"uneven-angles", "uneven-slerp", "uneven-nlerp"};
    const Turnings turnings = turningsOf(s.poses);
    for (std::size_t way = 0; way < turnings.size(); ++way) {
        const Turning& turning = turnings.at(way);
        numbers.set(turnedBy.at(way), turning.whole);
        if (turning.slowest > 1e-9) numbers.set(unevenBy.at(way), turning.fastest / turning.slowest);
    }
    const vec3 angles = anglesAt(s.poses, betweenAt(s, frame)), ahead(0, 0, -1);
    numbers.set("axes-apart", 90 - std::abs(s.poses.order == EulerOrder::yxz ? angles.x : angles.y));
    const quat from = orientationOf(s.poses.from), to = orientationOf(s.poses.to);
    const AxisAngle turn = axisAngleOf(to * inverse(from));
    numbers.set("axis-x", turn.axis.x);
    numbers.set("axis-y", turn.axis.y);
    numbers.set("axis-z", turn.axis.z);
    numbers.set("nose-turn", axisAngleOf(turnBetween(turned(from, ahead), turned(to, ahead))).degrees);
}

}  // namespace

void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers) {
    if (s.show == Show::track)
        tellTrack(gpu, s, frame, numbers);
    else
        tellPoses(s, frame, numbers);
}

// The frame's turn about the path after a lap, or the lap's length.
std::vector<double> values(const Settings& s) {
    if (s.ride.lengthBy != LengthBy::adaptive) return {lengthOf(s.ride)};
    const auto frames = minimizingFrames(samplesOf(s.ride), worldUp, s.ride.transport);
    return {closingAngle(frames.front(), frames.back())};
}

namespace {

using namespace mv::claims;

// The carried vector is the solution of u' = -(u . T') T, T being the tangent; the way is that of s' = |velocity|. Both
// by Dormand-Prince, from key to key, since what is between is smooth.
struct Carried {
    vec3 up;
    double way;
};
Carried carriedRound(const Curve<vec3>& curve, const vec3& firstUp, double tolerance) {
    OdeProblem problem;
    problem.dimension = 4;
    std::vector<double> state{firstUp.x, firstUp.y, firstUp.z, 0};
    const std::vector<double>& breaks = curve.breaks();
    for (std::size_t i = 1; i < breaks.size(); ++i) {
        const double last = std::nextafter(breaks[i], breaks[i - 1]);  // at a key at() speaks of the span that begins
        problem.slope = [&](double t, std::span<const double> y, std::span<double> slope) {
            const CurvePoint<vec3> at = curve.at(std::min(t, last));
            const double speed = glm::length(at.velocity);
            const vec3 tangent = at.velocity / speed;
            const vec3 change = (at.acceleration - glm::dot(at.acceleration, tangent) * tangent) / speed;
            const vec3 turn = -glm::dot(vec3(y[0], y[1], y[2]), change) * tangent;
            for (int axis = 0; axis < 3; ++axis) slope[static_cast<std::size_t>(axis)] = turn[axis];
            slope[3] = speed;
        };
        const OdeResult result = integrateAdaptive(problem, OdeMethod::dormandPrince, breaks[i - 1], breaks[i], state,
                                                   {.relative = tolerance, .absolute = tolerance});
        if (!result.reachedEnd()) throw Error("reference", "must reach the end of the lap", result.failure);
        state = result.y;
    }
    return {{state[0], state[1], state[2]}, state[3]};
}

double quantityOf(const Demo& demo, double tolerance) {
    const Ride ride = settingsOf<Settings>(demo).ride;
    const Curve<vec3>& curve = pathOf(ride).curve;
    const PathFrame first = frameByUp(curve.at(0).velocity, {0, 1, 0});
    const Carried carried = carriedRound(curve, first.up, tolerance);
    if (ride.lengthBy != LengthBy::adaptive) return carried.way;
    return closingAngle(first, frameByUp(curve.at(1).velocity, carried.up));
}

Reference reference(const Demo& demo, const ReferenceFrame& frame) {
    Reference made;
    made.values = {quantityOf(demo, 1e-13)};
    if (frame.ownError) made.ownError = std::abs(made.values[0] - quantityOf(demo, 1e-11));
    return made;
}

Study study() {
    Study study;
    study.quantity = "the turn about the path of a frame that was carried round a lap, degrees; the lap's length, m";
    study.reference = "the differential equation of both, by Dormand-Prince from key to key to 1e-13";
    study.makeReference = [](const Demo& demo, const ReferenceFrame& frame, const auto&) {
        return reference(demo, frame);
    };
    const std::vector<KnobSetting> knot{{"track", "knot"}, {"up", "minimizing"}, {"pace", "parameter"}};
    const auto with = [&knot](const std::string& curve) {
        std::vector<KnobSetting> settings = knot;
        settings.push_back({"curve", curve});
        return settings;
    };
    study.scenes = {{"spline", with("spline")}, {"Catmull-Rom", with("catmull-rom")}, {"length of the park", {}}};
    // 36 spans: 13 steps more than a multiple, so that the keys are at the same places between two samples each time
    const std::vector<std::string> off{"121", "229", "481", "949", "1885", "3793"};
    const std::vector<std::string> on{"144", "288", "576", "1152", "2304", "4608"};
    for (const std::string transport : {"re-orthogonalize", "project", "rotate", "double-reflection"}) {
        study.lines.push_back({.method = transport,
                               .settings = {{"transport", transport}},
                               .knob = "steps",
                               .values = off,
                               .scenes = {"spline", "Catmull-Rom"}});
    }
    study.lines.push_back({.method = "double-reflection, samples on the keys",
                           .settings = {{"transport", "double-reflection"}},
                           .knob = "steps",
                           .values = on,
                           .scenes = {"Catmull-Rom"}});
    for (const std::string rule : {"chords", "simpson", "gauss"}) {
        study.lines.push_back({.method = rule,
                               .settings = {{"length-by", rule}},
                               .knob = "pieces",
                               .values = {"2", "4", "8", "16", "32", "64"},
                               .scenes = {"length of the park"}});
    }
    study.says = {
        claim("order-one", "Re-orthogonalizing halves its error with twice the steps.",
              {slope(of::rms, rows("re-orthogonalize"), -1.1, -0.9)}),
        claim("order-two",
              "Projection and rotation have a quarter of it with twice the steps, where curvature is continuous.",
              {slope(of::rms, rows("project", "rotate").in("spline"), -2.1, -1.9)}),
        claim("order-four", "Double reflection has a sixteenth.",
              {slope(of::rms, rows("double-reflection").in("spline"), -4.1, -3.9)}),
        claim("order-three-at-jumps",
              "On a Catmull-Rom curve, whose curvature jumps at the keys, double reflection has an eighth only.",
              {slope(of::rms, rows("double-reflection").in("Catmull-Rom").from(400), -3.1, -2.9)}),
        claim("order-four-between-jumps", "With a sample on each key it has a sixteenth there, too.",
              {slope(of::rms, rows("double-reflection, samples on the keys").upTo(2500), -4.1, -3.9)}),
        claim("thousandth",
              "From 400 steps on double reflection errs by less than a thousandth of rotation on the spline.",
              {ratio(of::rms, rows("double-reflection").in("spline").from(400), rows("rotate"), 0, 1e-3)}),
        claim("length-orders",
              "Of the length, chords have a quarter of the error with twice as many, Simpson a sixteenth.",
              {slope(of::rms, rows("chords"), -2.1, -1.9), slope(of::rms, rows("simpson"), -4.1, -3.9)}),
        claim("length-gauss", "Gauss's rule with 8 nodes between two keys is right to 10 nm, with 16 to rounding.",
              {atMost(of::rms, rows("gauss").at(8), 1e-8), atMost(of::rms, rows("gauss").from(16), 1e-12)}),
        claim("length-best", "From 4 nodes on nothing is both nearer and faster than Gauss's rule.",
              {unbeaten(rows("gauss").from(4), rows("chords", "simpson"))}),
        note("A step of double reflection errs by the fifth power of its length where the curve is smooth, and there "
             "are "
             "1/length of them. A step across a jump of curvature errs by the third power, and there is one for each "
             "key: "
             "from some number of steps on these are all that is left. Where the samples are on the keys no step goes "
             "across. The spline's jumps are one derivative higher, and cost the fourth power."),
        note(
            "The steps off the keys are 13 more than a multiple of the 36 spans, so that each key is at the same place "
            "between two samples every time; at other numbers the error goes up and down about the same slope.")};
    study.reads = {"track", "curve", "length-by"};
    study.ofValues = true;
    return study;
}

const bool studied = addStudy("path", study());

}  // namespace
}  // namespace mv::path

// path: a car on a closed curve in space. Forward is the direction of its velocity; which way is up is a choice, and some
// choices fail. And between two poses: three angles against slerp and nlerp.
//
// Claims (each is a test in tests/claims/path.cpp; X30 and X31 in docs/stability.md are slerp and products of turns):
// - [forward-is-velocity] The car looks where it goes, by every rule, and its frame is orthonormal and right-handed.
// - [on-its-side] On a flat bend up by the acceleration lays the car on its side; minus gravity it leans by atan(v^2/(rg)).
// - [flips-at-inflections] On the flat figure of eight the acceleration's up turns over at both inflections; that of the
//   banked and of the minimizing frame nowhere.
// - [no-turn-about-the-path] The minimizing frame does not turn about the path. On a flat curve it closes; in space it does
//   not, and spread over the lap its closing angle is gone.
// - [equal-ways] By arc length equal times are equal ways; by the parameter they are not.
// - [chase-keeps-car] The chase camera keeps the car in the same place of its picture.
// - [shortest-turn] Slerp takes the shortest turn at constant speed, nlerp the same at another, three angles neither.
// - [gimbal-lock] Where the nose points straight up, yaw and roll are one turn: other angles, the same pose, another way.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/made_for.h"
#include "mv/geometry/plot.h"
#include "mv/gl/drawing.h"
#include "mv/gl/gl.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "mv/motion/minimizing_frame.h"
#include "mv/motion/orientation.h"
#include "mv/motion/turn.h"
#include "shared/car.h"
#include "shared/lap.h"
#include "shared/pose_sphere.h"
#include "shared/spin.h"
#include "shared/strip.h"
#include "shared/track.h"

using namespace mv;

namespace {

enum class Show { track, poses };
enum class Up { fixed, acceleration, banking, minimizing };
enum class Pace { way, parameter };
enum class LengthBy { adaptive, chords, simpson, gauss };

constexpr double carLength = 4;  // metres
const vec3 gravity(0, -9.81, 0), worldUp(0, 1, 0);
const vec4 ink(0.1, 0.1, 0.1, 1), orange(0.85, 0.45, 0, 1), blue = forwardColor, green = upColor;

struct PathDemo final : Demo {
    Choice<Show> show{
        this, "scene", Show::track, {{"track"}, {"poses", "three ways between two poses"}}, "what is shown"};
    Choice<Track> track{this,
                        "track",
                        Track::park,
                        {{"park", "bend, hills and a loop"},
                         {"eight", "flat, with two inflections"},
                         {"ring", "flat, of radius 20 m"},
                         {"knot", "a trefoil"}},
                        "which curve"};
    Choice<Through> curve{this,
                          "curve",
                          Through::spline,
                          {{"spline"}, {"catmull-rom", "its curvature jumps"}},
                          "what goes through its keys"};
    Choice<Up> up{this,
                  "up",
                  Up::banking,
                  {{"fixed", "the world's"},
                   {"acceleration", "the slide's"},
                   {"banking", "acceleration minus gravity"},
                   {"minimizing", "carried along without a turn about the path"}},
                  "which way is up for the car"};
    Choice<Transport> transport{this,
                                "transport",
                                Transport::doubleReflection,
                                {{"re-orthogonalize"}, {"project"}, {"rotate"}, {"double-reflection"}},
                                "how the minimizing frame is carried from sample to sample"};
    Whole steps{this, "steps", 360, {120, 8000}, "samples of the lap that frames are made for"};
    Toggle spread{this, "spread", false, "turn the minimizing frame a little everywhere, so that it closes"};
    Choice<Pace> pace{this, "pace", Pace::way, {{"way"}, {"parameter"}}, "of what the car covers equal steps"};
    Real speed{this, "speed", 14, {1, 40}, "of the car, averaged over the lap", "m/s"};
    Choice<LengthBy> lengthBy{this,
                              "length-by",
                              LengthBy::adaptive,
                              {{"adaptive"}, {"chords"}, {"simpson"}, {"gauss"}},
                              "rule for the length"};
    Whole pieces{this, "pieces", 4, {2, 64}, "chords, parts or nodes of that rule between two keys"};
    Real start{this, "start", 42, {0, 100}, "where frame 0 is: the part of the lap, or between the poses", "%"};
    PoseKnobs from{this, {"from-yaw", "from-pitch", "from-roll"}, {0, 40, 0}};
    PoseKnobs to{this, {"to-yaw", "to-pitch", "to-roll"}, {180, 55, 180}};
    Spin spin{this, 0, 0, vec2(0.5)};
    Choice<EulerOrder> order{this,
                             "order",
                             EulerOrder::yxz,
                             {{"yxz", "yaw, pitch, roll: as the poses are given"},
                              {"xyz", "about x, then y, then z"},
                              {"zyx", "about z, then y, then x"}},
                             "which three angles of the poses are mixed; the last acts first"};

    Readout carSpeed{this, "car-speed", "of the car now", "m/s"};
    Readout lean{this, "lean", "of the car now, to the right", "deg"};
    Readout flips{this, "flips", "places where up turns by more than 90 degrees within a car's length, 4 m"};
    Readout vanished{this, "vanished", "samples at which the rule has no up"};
    Readout mostTurn{this, "most-turn", "largest turn of up about the path, by the metre", "deg/m"};
    Readout closing{this, "closing-angle", "by which the minimizing frame misses itself after a lap", "deg"};
    Readout length{this, "length", "of the lap, by the chosen rule", "m"};
    Readout lengthOff{this, "length-off", "how far that is off", "m"};
    Readout axesApart{this, "axes-apart",
                      "by three angles: angle between the axes of the first and the last now; 0 is lock", "deg"};
    std::array<Readout, 3> turned{Readout{this, "turned-angles", "whole turn by three angles", "deg"},
                                  Readout{this, "turned-slerp", "whole turn by slerp", "deg"},
                                  Readout{this, "turned-nlerp", "whole turn by nlerp", "deg"}};
    std::array<Readout, 3> uneven{Readout{this, "uneven-angles", "by three angles: largest speed by smallest"},
                                  Readout{this, "uneven-slerp", "by slerp: largest speed by smallest"},
                                  Readout{this, "uneven-nlerp", "by nlerp: largest speed by smallest"}};

    std::array<Readout, 3> axisNow{Readout{this, "axis-x", "of the axis about which slerp turns, by the smaller angle"},
                                   Readout{this, "axis-y", "the same: y"}, Readout{this, "axis-z", "the same: z"}};
    Readout noseTurn{this, "nose-turn", "smallest turn that takes the first nose to the second, whatever the roof does",
                     "deg"};

    Program program;
    Mesh trackOnGround, car;
    Drawing drawing;

    Lap lap;
    std::vector<std::size_t> vanishedAt;
    MadeFor<Track, Through, Up, Transport, int, bool, Pace, double> lapFor;

    PathDemo() {
        bindHandle("car", {&start}, [this](const FrameInfo& frame) -> std::optional<vec2> {
            if (show != Show::track) return std::nullopt;
            const Pane pane = outsidePane(frame);
            return pictureFromPane(pane, outside(pane), motionAt(parameterAt(lapPart(frame))).position);
        });
        for (PoseKnobs* pose : {&from, &to}) {
            const auto where = [this, pose](const FrameInfo& frame) -> std::optional<vec2> {
                if (show != Show::poses) return std::nullopt;
                const vec3 nose = mv::turned(pose->orientation(), vec3(0, 0, -1));
                return pictureFromPane(posePane(frame, 1), poseView(posePane(frame, 1)), nose);
            };
            bindHandle(pose == &from ? "nose at from" : "nose at to", {&pose->yaw, &pose->pitch}, where);
        }
        const auto isTrack = [this] { return show == Show::track; };
        const auto isPoses = [this] { return show == Show::poses; };
        for (Knob* knob :
             std::vector<Knob*>{&track, &curve, &up, &transport, &steps, &spread, &pace, &speed, &lengthBy, &pieces})
            knob->onlyWhen(isTrack, "between two poses there is no track");
        for (Knob* knob : std::vector<Knob*>{&from.yaw, &from.pitch, &from.roll, &to.yaw, &to.pitch, &to.roll})
            knob->onlyWhen(isPoses, "the track has no keys of poses");
        order.onlyWhen(isPoses, "the track has no keys of poses");
        for (Knob* knob : std::vector<Knob*>{&transport, &spread})
            knob->onlyWhen([this] { return up == Up::minimizing; }, "the other rules carry nothing along");
        pieces.onlyWhen([this] { return lengthBy != LengthBy::adaptive; }, "adaptive chooses for itself");
    }

    void init() override {
        program = Program("path");
        car = Mesh(carLookingAlongMinusZ(1), "car");
    }

    void draw(const Frame& frame) override {
        glEnable(GL_DEPTH_TEST);
        program.use();
        drawing.begin(frame);
        if (show == Show::track)
            drawTrack(frame);
        else
            drawPoses(frame);
        glViewport(0, 0, frame.width(), frame.height());
        drawing.draw(frame);
    }

    // ---- the car on the track

    const TrackPath& path() const { return trackPath(track, curve); }

    // Position, velocity and acceleration of the car where the curve has this parameter, per second. At equal ways the
    // acceleration has no part along the path; no rule reads that part, so it is left in.
    PathSample motionAt(double parameter) const {
        const CurvePoint<vec3> at = path().curve.at(parameter);
        const double rate = speed / (pace == Pace::way ? glm::length(at.velocity) : path().way.length());
        return {at.position, rate * at.velocity, rate * rate * at.acceleration};
    }

    // Of the lap's time that is covered, 0 to 1; and where the car is then.
    double lapPart(const FrameInfo& frame) const {
        return std::fmod(start / 100 + frame.time() * speed / path().way.length(), 1);
    }
    double parameterAt(double part) const {
        return pace == Pace::parameter ? part : path().way.timeAt(part * path().way.length());
    }

    FramesByRule framesOf(std::span<const PathSample> samples) const {
        switch (up) {
            case Up::fixed:
                return framesByUp(samples, worldUp);
            case Up::acceleration:
                return framesByAcceleration(samples);
            case Up::banking:
                return framesByBanking(samples, gravity);
            case Up::minimizing:
                break;
        }
        FramesByRule carried;
        carried.frames = minimizingFrames(samples, worldUp, transport);
        if (spread) carried.frames = closedFrames(samples, std::move(carried.frames));
        return carried;
    }

    std::vector<PathSample> samplesOfLap() const {
        std::vector<PathSample> samples;
        for (int i = 0; i <= steps; ++i) samples.push_back(motionAt(parameterAt(double(i) / steps)));
        return samples;
    }

    // The lap is made anew when one of these knobs has moved.
    void followKnobs() {
        if (!lapFor.changed(track, curve, up, transport, steps, spread, pace, speed)) return;
        const std::vector<PathSample> samples = samplesOfLap();
        FramesByRule by = framesOf(samples);
        vanishedAt = std::move(by.vanished);
        lap = lapOf(samples, std::move(by.frames), carLength);
        trackOnGround = Mesh(trackMesh(lap.samples, lap.frames), "track");
    }

    double lengthByRule() const {
        const Curve<vec3>& line = path().curve;
        const int spans = static_cast<int>(line.breaks().size()) - 1;
        switch (lengthBy) {
            case LengthBy::chords:
                return arcLengthByChords(line, spans * pieces);
            case LengthBy::simpson:
                return arcLengthBySimpson(line, 2 * spans * pieces);
            case LengthBy::gauss:
                return arcLengthByGauss(line, pieces);
            case LengthBy::adaptive:
                break;
        }
        return path().way.length();
    }

    // For the study: the frame's turn about the path after a lap, or the lap's length.
    std::vector<double> values() const override {
        if (lengthBy != LengthBy::adaptive) return {lengthByRule()};
        const auto frames = minimizingFrames(samplesOfLap(), worldUp, transport);
        return {closingAngle(frames.front(), frames.back())};
    }

    // ---- the picture of the track

    static Pane outsidePane(const FrameInfo& frame) { return paneAboveStrip(frame, 0, 0.58); }

    mat4 outside(const Pane& pane) const {
        const double half = 0.306 * std::max(1.0, 1.42 / pane.aspect());  // of what is 1 before the eye
        return perspective(2 * degrees(std::atan(half)), pane.aspect(), 20, 400) *
               lookAt(vec3(-7, 72, 92), vec3(-7, 0, 4), worldUp) * spin.turn();
    }

    void drawTrack(const Frame& frame) {
        followKnobs();
        const double part = lapPart(frame);
        const PathSample now = motionAt(parameterAt(part));
        const PathFrame axes = frameAt(lap, part, now.velocity);
        const mat4 worldFromCar = worldFromFrame(axes, now.position);
        // The chase camera has its place in the car's own frame
        const mat4 chaseFromCar = lookAt(vec3(0, 4.5, 11), vec3(0, 1.5, -8), worldUp);
        const mat4 chaseFromWorld = chaseFromCar * glm::inverse(worldFromCar);
        frame.show("worldFromCar", worldFromCar);
        frame.show("chaseFromWorld", chaseFromWorld);

        const Pane left = outsidePane(frame), right = paneAboveStrip(frame, 0.58, 1);
        drawing.in(left);
        drawFrom(left, outside(left), worldFromCar);
        drawLap(drawing, outside(left), lap);
        for (const std::size_t i : vanishedAt) drawing.point(outside(left), lap.samples[i].position, 9, orange);
        drawFrame(drawing, outside(left), now.position, axes, 6, 3);
        drawWords(drawing, frame, left, 0, {{"up: " + up.text(), ink}});
        drawWords(drawing, frame, left, 1, {{lengthText(), ink}});
        drawWords(drawing, frame, left, -1, {{"forward", forwardColor}, {"up", upColor}, {"right", rightColor}});
        drawing.in(right);
        drawFrom(right, perspective(60, right.aspect(), 1, 400) * chaseFromWorld, worldFromCar);
        drawWords(drawing, frame, right, 0, {{"chase camera", ink}});
        drawGraphs(frame, part, now);
        measure(now, axes);
    }

    std::string lengthText() const {
        std::string text = rounded("lap: %.2f m", lengthByRule());
        if (lengthBy != LengthBy::adaptive)
            text += " by " + lengthBy.text() + rounded(", off by %.1g m", lengthByRule() - path().way.length());
        return text;
    }

    void drawFrom(const Pane& pane, const mat4& clipFromWorld, const mat4& worldFromCar) {
        glViewport(pane.x, pane.y, pane.width, pane.height);
        program.set("clipFromWorld", clipFromWorld);
        program.set("worldFromModel", mat4(1));
        trackOnGround.draw();
        program.set("worldFromModel", worldFromCar * scale(carLength / 10));
        car.draw();
    }

    void drawGraphs(const Frame& frame, double part, const PathSample& now) {
        const ArcLength& way = path().way;
        std::vector<vec2> byParameter, turns;
        double fastest = 0, most = 0.1;
        for (int i = 0; i <= 400; ++i) {
            const double parameter = i / 400.0;
            const double speedThere = glm::length(path().curve.at(parameter).velocity) * speed / way.length();
            byParameter.emplace_back(way.lengthAt(parameter), speedThere);
            fastest = std::max(fastest, speedThere);
        }
        for (std::size_t i = 1; i < lap.ways.size(); ++i) {
            turns.emplace_back(lap.ways[i], lap.turns[i]);
            most = std::max(most, std::abs(lap.turns[i]));
        }
        drawing.in({0, 0, frame.width(), frame.height()});
        const Axis along{0, way.length(), "m along the lap"};
        const Plot speeds{graphInStrip(frame, 0, 0.5), along, {0, roundAbove(fastest)}};
        drawing.curve(speeds, std::array{vec2(0, speed), vec2(way.length(), speed)}, {blue, 2});
        drawing.curve(speeds, byParameter, {orange, 2});
        drawing.point(speeds.pixel({way.lengthAt(parameterAt(part)), glm::length(now.velocity)}), 8, ink);
        drawAxes(drawing, frame, speeds, {{"speed, m/s:", ink}, {"equal ways", blue}, {"equal parameters", orange}});
        const Plot turning{graphInStrip(frame, 0.5, 1), along, {-roundAbove(most), roundAbove(most)}};
        drawing.curve(turning, turns, {green, 1.5});
        drawAxes(drawing, frame, turning, {{"turn of up about the path, deg/m", green}});
    }

    void measure(const PathSample& now, const PathFrame& axes) {
        carSpeed = glm::length(now.velocity);
        lean.clear();
        if (std::abs(axes.forward.y) < 0.999) lean = closingAngle(frameByUp(now.velocity, worldUp), axes);
        flips = double(lap.flips.size());
        vanished = double(vanishedAt.size());
        const auto [least, most] = std::ranges::minmax(lap.turns);
        mostTurn = std::max(-least, most);
        closing.clear();
        if (up == Up::minimizing) closing = closingAngle(lap.frames.front(), lap.frames.back());
        length = lengthByRule();
        lengthOff = lengthByRule() - path().way.length();
    }

    // ---- between two poses

    // 0 to 1 and back in eight seconds.
    double between(const FrameInfo& frame) const {
        return 1 - std::abs(1 - std::fmod(start / 100 + frame.time() / 4, 2));
    }

    // About x, y and z: those that the pose is given by, or those of another order that make the same pose.
    vec3 anglesOf(const PoseKnobs& pose) const {
        const YawPitchRoll angles = pose.angles();
        if (order == EulerOrder::yxz) return {angles.pitch, angles.yaw, angles.roll};
        return eulerAnglesOf(pose.orientation(), order).degrees;
    }
    vec3 anglesAt(double t) const { return glm::mix(anglesOf(from), anglesOf(to), t); }
    quat poseAt(std::size_t way, double t) const {
        if (way == 1) return slerp(from.orientation(), to.orientation(), t);
        if (way == 2) return nlerp(from.orientation(), to.orientation(), t);
        return quatFromEuler(anglesAt(t), order);
    }

    static Pane posePane(const FrameInfo& frame, std::size_t way) {
        return paneAboveStrip(frame, double(way) / 3, double(way + 1) / 3);
    }
    mat4 poseView(const Pane& pane) const {
        const double half = 1.2 * std::max(1.0, 1 / pane.aspect());  // of the world, 5 before the eye
        return perspective(2 * degrees(std::atan(half / 5)), pane.aspect(), 1, 20) *
               lookAt(vec3(4.2, 2, 1.8), vec3(0), worldUp) * spin.turn();
    }

    void drawPoses(const Frame& frame) {
        static const std::array<ColoredWords::value_type, 3> names{
            {{"three angles", orange}, {"slerp", blue}, {"nlerp", green}}};
        const double t = between(frame);
        std::array<Turning, 3> turnings;
        mat4 last(0);
        for (std::size_t way = 0; way < 3; ++way) {
            turnings[way] = turningOf([&](double then) { return poseAt(way, then); });
            const Turning& turning = turnings[way];
            const Pane pane = posePane(frame, way);
            const mat4 clipFromWorld = poseView(pane), turn = rotationMatrix(poseAt(way, t));
            glViewport(pane.x, pane.y, pane.width, pane.height);
            if (clipFromWorld != last) program.set("clipFromWorld", clipFromWorld);
            last = clipFromWorld;
            program.set("worldFromModel", turn * scale(0.08) * translate(0, -2, 0));
            car.draw();
            drawing.in(pane);
            drawTurning(drawing, clipFromWorld, turning, names[way].second);
            const vec3 angles = anglesAt(t);
            const bool hasRings = way == 0 && order == EulerOrder::yxz;
            if (hasRings)
                drawGimbal(drawing, clipFromWorld, {angles.y, angles.x, angles.z}, {rightColor, upColor, forwardColor});
            else
                drawFrame(drawing, clipFromWorld, vec3(0), {-vec3(turn[2]), vec3(turn[1]), vec3(turn[0])}, 1, 2);
            drawWords(drawing, frame, pane, 0, {names[way]});
            drawWords(drawing, frame, pane, 1, {{rounded("turns by %.1f°", turning.whole), ink}});
            if (hasRings)
                drawWords(drawing, frame, pane, -1, {{"yaw", upColor}, {"pitch", rightColor}, {"roll", forwardColor}});
            else
                drawWords(drawing, frame, pane, -1,
                          {{"forward", forwardColor}, {"up", upColor}, {"right", rightColor}});
            turned[way] = turning.whole;
            uneven[way].clear();
            if (turning.slowest > 1e-9) uneven[way] = turning.fastest / turning.slowest;
        }
        const vec3 angles = anglesAt(t);
        axesApart = 90 - std::abs(order == EulerOrder::yxz ? angles.x : angles.y);
        const AxisAngle turn = axisAngleOf(to.orientation() * inverse(from.orientation()));
        for (int i = 0; i < 3; ++i) axisNow.at(std::size_t(i)) = turn.axis[i];
        const vec3 ahead(0, 0, -1);
        noseTurn = axisAngleOf(turnBetween(mv::turned(from.orientation(), ahead), mv::turned(to.orientation(), ahead)))
                       .degrees;
        sayLock(frame);

        const double fastest = std::max({turnings[0].fastest, turnings[1].fastest, turnings[2].fastest, 1.0});
        drawing.in({0, 0, frame.width(), frame.height()});
        const Plot plot{graphInStrip(frame, 0, 1), {0, 1, "t"}, {0, roundAbove(fastest)}};
        for (std::size_t way = 0; way < 3; ++way) drawing.curve(plot, turnings[way].speeds, {names[way].second, 2});
        drawAxes(drawing, frame, plot, {{"speed of the turn, deg per t:", ink}, names[0], names[1], names[2]});
    }

    void sayLock(const Frame& frame) const {
        for (const auto& [name, pose] : {std::pair("from", &from), std::pair("to", &to)}) {
            const YawPitchRoll found = yawPitchRollOf(pose->orientation());
            if (!found.locked) continue;
            frame.say(std::string("gimbal lock at pose ") + name +
                      ": its nose is on the axis of yaw, so yaw and roll are one turn, and other angles, yaw " +
                      rounded("%.6g", found.yaw) + " and roll 0, are the same pose");
        }
    }
};

constexpr Declaration declaration{
    .name = "path",
    .sentence = "A car on a curve: forward is the velocity, up is a choice; and three ways from one pose to another.",
    .lookFor = "The sleepers lean into each bend, so that a passenger is pressed straight down into the seat.",
    .chapter = "Motion",
    .number = 35,
    .width = 960,
    .height = 560,
    .animated = true,
    .background = vec4(0.95, 0.97, 1, 1),
    .needs = {.depth = true},
    .presets =
        {
            {"banking",
             "The sleepers lean into each bend, so that a passenger is pressed straight into the seat.",
             {},
             {{"flips", 0, 0}}},
            {"acceleration",
             "The slide's rule lays the car on its side in the bends, and turns it over at each red dot.",
             {{"up", "acceleration"}},
             {{"flips", 3, 3}}},
            {"fixed",
             "Upright in every bend, until the path points at the sky: in the loop the car turns over twice.",
             {{"up", "fixed"}},
             {{"flips", 2, 2}}},
            {"minimizing",
             "Carried along without a turn about the path: it never flips, but a lap leaves it 12 degrees off.",
             {{"up", "minimizing"}},
             {{"flips", 0, 0}, {"closing-angle", 11.5, 12.5}}},
            {"poses",
             "Nose up by 85 degrees more, past the vertical: slerp does that, three angles whirl by 131 degrees.",
             {{"scene", "poses"}},
             {{"turned-slerp", 84.9, 85.1}, {"turned-angles", 131, 132}}},
            {"gimbal-lock",
             "Nose straight up: the rings of yaw and pitch lie in one plane, and yaw does what roll does.",
             {{"scene", "poses"},
              {"from-pitch", "0"},
              {"to-yaw", "90"},
              {"to-pitch", "90"},
              {"to-roll", "0"},
              {"start", "100"}}},
        },
};

const bool added = addDemo<PathDemo, declaration>();

}  // namespace

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
#include "shared/car.h"
#include "shared/lap.h"
#include "shared/pose_sphere.h"
#include "shared/spin.h"
#include "shared/track.h"

using namespace mv;

namespace {

enum class Show { track, poses };
enum class Up { fixed, acceleration, banking, minimizing };
enum class Pace { way, parameter };
enum class LengthBy { adaptive, chords, simpson, gauss };

constexpr double carLength = 4;  // metres
const vec3 gravity(0, -9.81, 0), worldUp(0, 1, 0);
const vec4 red(0.80, 0.10, 0.10, 1), green(0.05, 0.55, 0.10, 1), blue(0.10, 0.30, 0.85, 1), orange(0.85, 0.45, 0, 1);
const vec4 ink(0.1, 0.1, 0.1, 1);
using Words = std::pair<std::string, vec4>;  // in a colour

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
                          {{"spline", "curvature is continuous"}, {"catmull-rom", "curvature jumps at the keys"}},
                          "what is laid through its keys"};
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
    Choice<Pace> pace{
        this,
        "pace",
        Pace::way,
        {{"way", "equal ways in equal times, by arc length"}, {"parameter", "equal steps of the parameter"}},
        "how the car goes round"};
    Real speed{this, "speed", 14, {1, 40}, "of the car, averaged over the lap", "m/s"};
    Choice<LengthBy> lengthBy{
        this,
        "length-by",
        LengthBy::adaptive,
        {{"adaptive", "Gauss's rule, halved until it is right"}, {"chords"}, {"simpson"}, {"gauss"}},
        "how the readout length is made"};
    Whole pieces{this, "pieces", 4, {2, 64}, "chords, parts or nodes of that rule between two keys"};
    Real start{this, "start", 42, {0, 100}, "where frame 0 is: the part of the lap, or between the poses", "%"};
    PoseKnobs from{this, "from", {0, 40, 0}}, to{this, "to", {180, 55, 180}};
    Spin spin{this, 0, 0, vec2(0.5)};

    Readout carSpeed{this, "car-speed", "of the car now", "m/s"};
    Readout lean{this, "lean", "of the car now, to the right", "deg"};
    Readout flips{this, "flips", "places where up turns by more than 90 degrees within a car's length, 4 m"};
    Readout vanished{this, "vanished", "samples at which the rule has no up"};
    Readout mostTurn{this, "most-turn", "largest turn of up about the path, by the metre", "deg/m"};
    Readout closing{this, "closing-angle", "by which the minimizing frame misses itself after a lap", "deg"};
    Readout length{this, "length", "of the lap, by the chosen rule", "m"};
    Readout lengthOff{this, "length-off", "how far that is off", "m"};
    Readout axesApart{this, "axes-apart", "by three angles: angle between the axes of yaw and roll now; 0 is lock",
                      "deg"};
    std::array<Readout, 3> turned{Readout{this, "turned-angles", "whole turn by three angles", "deg"},
                                  Readout{this, "turned-slerp", "whole turn by slerp", "deg"},
                                  Readout{this, "turned-nlerp", "whole turn by nlerp", "deg"}};
    std::array<Readout, 3> uneven{Readout{this, "uneven-angles", "by three angles: largest speed by smallest"},
                                  Readout{this, "uneven-slerp", "by slerp: largest speed by smallest"},
                                  Readout{this, "uneven-nlerp", "by nlerp: largest speed by smallest"}};

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
        for (const auto& [name, pose] : {std::pair("from", &from), std::pair("to", &to)}) {
            bindHandle(name, {&pose->yaw, &pose->pitch}, [this, pose](const FrameInfo& frame) -> std::optional<vec2> {
                if (show != Show::poses) return std::nullopt;
                const vec3 nose(-rotationMatrix(pose->orientation())[2]);
                return pictureFromPane(posePane(frame, 1), poseView(posePane(frame, 1)), nose);
            });
        }
        const auto isTrack = [this] { return show == Show::track; };
        const auto isPoses = [this] { return show == Show::poses; };
        for (Knob* knob :
             std::vector<Knob*>{&track, &curve, &up, &transport, &steps, &spread, &pace, &speed, &lengthBy, &pieces})
            knob->onlyWhen(isTrack, "between two poses there is no track");
        for (Knob* knob : std::vector<Knob*>{&from.yaw, &from.pitch, &from.roll, &to.yaw, &to.pitch, &to.roll})
            knob->onlyWhen(isPoses, "the track has no keys of poses");
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

    // Position, velocity and acceleration of the car where the curve has this parameter, per second.
    PathSample motionAt(double parameter) const {
        const CurvePoint<vec3> at = path().curve.at(parameter);
        if (pace == Pace::parameter) {
            const double rate = speed / path().way.length();  // laps a second
            return {at.position, rate * at.velocity, rate * rate * at.acceleration};
        }
        // At constant speed the acceleration has no part along the path
        const double perParameter = glm::length(at.velocity), rate = speed / perParameter;
        const vec3 forward = at.velocity / perParameter;
        return {at.position, rate * at.velocity,
                rate * rate * (at.acceleration - glm::dot(at.acceleration, forward) * forward)};
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

    // A part of the width, above the graphs.
    static Pane paneOf(const FrameInfo& frame, double from, double to) {
        const int low = frame.height() * 3 / 10, left = int(from * frame.width());
        return {left, low, std::max(1, int(to * frame.width()) - left), frame.height() - low};
    }
    static Pane outsidePane(const FrameInfo& frame) { return paneOf(frame, 0, 0.58); }

    mat4 outside(const Pane& pane) const {
        return perspective(34, pane.aspect(), 20, 400) * lookAt(vec3(-7, 72, 92), vec3(-7, 0, 4), worldUp) *
               spin.turn();
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

        const Pane left = outsidePane(frame), right = paneOf(frame, 0.58, 1);
        drawing.in(left);
        drawFrom(left, outside(left), worldFromCar);
        markLap(outside(left));
        drawAxes(outside(left), now.position, axes, 6, 3);
        words(frame, {6, left.height - 6}, {{"up: " + up.text(), ink}});
        words(frame, {6, left.height - 6 - 1.6 * textSize(frame)}, {{lengthText(), ink}});
        words(frame, {6, 1.6 * textSize(frame)}, {{"forward", blue}, {"up", green}, {"right", red}});
        drawing.in(right);
        drawFrom(right, perspective(60, right.aspect(), 1, 400) * chaseFromWorld, worldFromCar);
        words(frame, {6, right.height - 6}, {{"chase camera", ink}});
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

    void drawAxes(const mat4& clipFromWorld, const vec3& at, const PathFrame& axes, double size, double width) {
        drawing.edge(clipFromWorld, at, at + size * axes.forward, {blue, width});
        drawing.edge(clipFromWorld, at, at + size * axes.up, {green, width});
        drawing.edge(clipFromWorld, at, at + size * axes.right, {red, width});
    }

    // Small frames along the curve; where up turns over, and where the rule has none.
    void markLap(const mat4& clipFromWorld) {
        double next = 0;
        for (std::size_t i = 0; i < lap.samples.size(); ++i) {
            if (lap.ways[i] < next) continue;
            next = lap.ways[i] + 5;
            drawAxes(clipFromWorld, lap.samples[i].position, lap.frames[i], 3, 1.5);
        }
        for (const std::size_t i : vanishedAt) drawing.point(clipFromWorld, lap.samples[i].position, 9, orange);
        for (const std::size_t i : lap.flips) drawing.point(clipFromWorld, lap.samples[i].position, 11, red);
    }

    void drawGraphs(const Frame& frame, double part, const PathSample& now) {
        const ArcLength& way = path().way;
        std::vector<vec2> byParameter, turns;
        double fastest = 0, most = 1;
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
        const Plot speeds{graphBox(frame, 0, 1), along, {0, 1.15 * fastest}};
        drawing.curve(speeds, std::array{vec2(0, speed), vec2(way.length(), speed)}, {blue, 2});
        drawing.curve(speeds, byParameter, {orange, 2});
        drawing.point(speeds.pixel({way.lengthAt(parameterAt(part)), glm::length(now.velocity)}), 8, ink);
        nameGraph(frame, speeds, {{"speed, m/s:", ink}, {"equal ways", blue}, {"equal parameters", orange}});
        const Plot turning{graphBox(frame, 1, 2), along, {-1.15 * most, 1.15 * most}};
        drawing.curve(turning, turns, {green, 1.5});
        nameGraph(frame, turning, {{"turn of up about the path, deg/m", green}});
    }

    // From one half of the width to another.
    static Box graphBox(const FrameInfo& frame, int from, int to) {
        const double w = frame.width(), low = std::min(46.0, 0.1 * frame.height());
        return {{from * w / 2 + std::min(64.0, w / 8), low}, {to * w / 2 - w / 60, 0.26 * frame.height()}};
    }
    void nameGraph(const Frame& frame, const Plot& plot, const std::vector<Words>& title) {
        drawing.axes(plot);
        words(frame, {plot.box.low.x, plot.box.high.y + 1.4 * textSize(frame)}, title);
    }

    static int textSize(const FrameInfo& frame) {
        return std::max(8, std::min(frame.width() / 60, frame.height() / 35));
    }
    void words(const Frame& frame, vec2 at, const std::vector<Words>& parts) {
        for (const auto& [text, color] : parts) {
            const TextStyle style{textSize(frame), color, vec4(1, 1, 1, 0.6)};
            drawing.text(at, text, style);
            at.x += textWidth(text, style) + 4;
        }
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

    YawPitchRoll anglesAt(double t) const {
        const YawPitchRoll a = from.angles(), b = to.angles();
        return {glm::mix(a.yaw, b.yaw, t), glm::mix(a.pitch, b.pitch, t), glm::mix(a.roll, b.roll, t)};
    }
    quat poseAt(std::size_t way, double t) const {
        if (way == 1) return slerp(from.orientation(), to.orientation(), t);
        if (way == 2) return nlerp(from.orientation(), to.orientation(), t);
        return quatFromYawPitchRoll(anglesAt(t).yaw, anglesAt(t).pitch, anglesAt(t).roll);
    }

    static Pane posePane(const FrameInfo& frame, std::size_t way) {
        return paneOf(frame, double(way) / 3, double(way + 1) / 3);
    }
    mat4 poseView(const Pane& pane) const {
        const double half = 1.2 * std::max(1.0, 1 / pane.aspect());  // of the world, 5 before the eye
        return perspective(2 * degrees(std::atan(half / 5)), pane.aspect(), 1, 20) *
               lookAt(vec3(4.2, 2, 1.8), vec3(0), worldUp) * spin.turn();
    }

    void drawPoses(const Frame& frame) {
        static const std::array<Words, 3> names{{{"three angles", orange}, {"slerp", blue}, {"nlerp", green}}};
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
            if (way == 0)
                drawGimbal(drawing, clipFromWorld, anglesAt(t), {red, green, blue});
            else
                drawAxes(clipFromWorld, vec3(0), {-vec3(turn[2]), vec3(turn[1]), vec3(turn[0])}, 1, 2);
            words(frame, {6, pane.height - 6}, {names[way]});
            words(frame, {6, pane.height - 6 - 1.6 * textSize(frame)},
                  {{rounded("turns by %.1f°", turning.whole), ink}});
            turned[way] = turning.whole;
            uneven[way].clear();
            if (turning.slowest > 1e-9) uneven[way] = turning.fastest / turning.slowest;
        }
        axesApart = 90 - std::abs(anglesAt(t).pitch);
        sayLock(frame);

        const double fastest = std::max({turnings[0].fastest, turnings[1].fastest, turnings[2].fastest, 1.0});
        drawing.in({0, 0, frame.width(), frame.height()});
        const Plot plot{graphBox(frame, 0, 2), {0, 1, "t"}, {0, 1.15 * fastest}};
        for (std::size_t way = 0; way < 3; ++way) drawing.curve(plot, turnings[way].speeds, {names[way].second, 2});
        nameGraph(frame, plot, {{"speed of the turn, deg per t:", ink}, names[0], names[1], names[2]});
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

const bool added = addDemo<PathDemo>({
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
             "The world's up is right until the loop, where the car turns over twice.",
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
});

}  // namespace

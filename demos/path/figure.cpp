// The figures over track and poses of path: frames, graphs and words.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "mv/formatted.h"
#include "mv/geometry/plot.h"
#include "path.h"
#include "shared/strip.h"

namespace mv::path {

// The length of the lap by the chosen rule.
double lengthOf(const Ride& ride) {
    const Curve<vec3>& line = pathOf(ride).curve;
    const int spans = static_cast<int>(line.breaks().size()) - 1;
    if (ride.lengthBy == LengthBy::chords) return arcLengthByChords(line, spans * ride.pieces);
    if (ride.lengthBy == LengthBy::simpson) return arcLengthBySimpson(line, 2 * spans * ride.pieces);
    if (ride.lengthBy == LengthBy::gauss) return arcLengthByGauss(line, ride.pieces);
    return pathOf(ride).way.length();
}
namespace {

const vec4 ink(0.1, 0.1, 0.1, 1), orange(0.85, 0.45, 0, 1), blue = forwardColor, green = upColor;
const std::array<ColoredWords::value_type, 3> ways{{{"three angles", orange}, {"slerp", blue}, {"nlerp", green}}};
const ColoredWords axisWords{{"forward", forwardColor}, {"up", upColor}, {"right", rightColor}};

std::string lengthText(const Ride& ride) {
    std::string text = formatted("lap: %.2f m", lengthOf(ride));
    if (ride.lengthBy != LengthBy::adaptive)
        text +=
            " by " + nameOf(ride.lengthBy) + formatted(", off by %.1g m", lengthOf(ride) - pathOf(ride).way.length());
    return text;
}

// Speed over the way, at equal ways and at equal parameters; and the turn of up.
void drawGraphs(Gpu& gpu, const Settings& s, const PathSample& now, const FrameInfo& frame) {
    Drawing& drawing = gpu.drawing;
    const ArcLength& way = pathOf(s.ride).way;
    std::vector<vec2> byParameter, turns;
    double fastest = 0, most = 0.1;
    for (int i = 0; i <= 400; ++i) {
        const double parameter = i / 400.0;
        const double speedThere =
            glm::length(pathOf(s.ride).curve.at(parameter).velocity) * s.ride.speed / way.length();
        byParameter.emplace_back(way.lengthAt(parameter), speedThere);
        fastest = std::max(fastest, speedThere);
    }
    for (std::size_t i = 1; i < gpu.lap.ways.size(); ++i) {
        turns.emplace_back(gpu.lap.ways[i], gpu.lap.turns[i]);
        most = std::max(most, std::abs(gpu.lap.turns[i]));
    }
    drawing.in({0, 0, frame.width(), frame.height()});
    const Axis along{0, way.length(), "m along the lap"};
    const Plot speeds{graphInStrip(frame, 0, 0.5), along, {0, roundAbove(fastest)}};
    const double here = way.lengthAt(parameterAt(s.ride, lapPart(s, frame)));
    drawing.curve(speeds, std::array{vec2(0, s.ride.speed), vec2(way.length(), s.ride.speed)}, {blue, 2});
    drawing.curve(speeds, byParameter, {orange, 2});
    drawing.point(speeds.pixel({here, glm::length(now.velocity)}), 8, ink);
    drawAxes(drawing, frame, speeds, {{"speed, m/s:", ink}, {"equal ways", blue}, {"equal parameters", orange}});
    const Plot turning{graphInStrip(frame, 0.5, 1), along, {-roundAbove(most), roundAbove(most)}};
    drawing.curve(turning, turns, {green, 1.5});
    drawAxes(drawing, frame, turning, {{"turn of up about the path, deg/m", green}});
}

}  // namespace

void showTrack(Gpu& gpu, const Settings& s, const PathSample& now, const PathFrame& axes, const FrameInfo& frame) {
    Drawing& drawing = gpu.drawing;
    const Pane left = outsidePane(frame), right = paneAboveStrip(frame, 0.58, 1);
    const mat4 clipFromWorld = clipFromOutside(s, left);
    drawing.in(left);
    drawLap(drawing, clipFromWorld, gpu.lap);
    for (const std::size_t i : gpu.vanishedAt) drawing.point(clipFromWorld, gpu.lap.samples[i].position, 9, orange);
    drawFrame(drawing, clipFromWorld, now.position, axes, 6, 3);
    drawWords(drawing, frame, left, 0, {{"up: " + nameOf(s.ride.up), ink}});
    drawWords(drawing, frame, left, 1, {{lengthText(s.ride), ink}});
    drawWords(drawing, frame, left, -1, axisWords);
    drawing.in(right);
    drawWords(drawing, frame, right, 0, {{"chase camera", ink}});
    drawGraphs(gpu, s, now, frame);
}

// The way of nose and roof on the sphere. Three angles as the poses are given have gimbal rings.
void showPose(Drawing& drawing, const Settings& s, std::size_t way, const Turning& turning, const FrameInfo& frame) {
    static const ColoredWords ringWords{{"yaw", upColor}, {"pitch", rightColor}, {"roll", forwardColor}};
    const double t = betweenAt(s, frame);
    const Pane pane = posePane(frame, way);
    const mat4 clipFromWorld = clipFromPoses(s, pane), turn = rotationMatrix(poseAt(s.poses, way, t));
    const vec3 angles = anglesAt(s.poses, t);
    const bool hasRings = way == 0 && s.poses.order == EulerOrder::yxz;
    drawing.in(pane);
    drawTurning(drawing, clipFromWorld, turning, ways.at(way).second);
    if (hasRings)
        drawGimbal(drawing, clipFromWorld, {angles.y, angles.x, angles.z}, {rightColor, upColor, forwardColor});
    else
        drawFrame(drawing, clipFromWorld, vec3(0), {-vec3(turn[2]), vec3(turn[1]), vec3(turn[0])}, 1, 2);
    drawWords(drawing, frame, pane, 0, {ways.at(way)});
    drawWords(drawing, frame, pane, 1, {{formatted("turns by %.1f°", turning.whole), ink}});
    drawWords(drawing, frame, pane, -1, hasRings ? ringWords : axisWords);
}

void showTurnings(Drawing& drawing, const Turnings& turnings, const FrameInfo& frame) {
    const double fastest = std::max({turnings[0].fastest, turnings[1].fastest, turnings[2].fastest, 1.0});
    drawing.in({0, 0, frame.width(), frame.height()});
    const Plot plot{graphInStrip(frame, 0, 1), {0, 1, "t"}, {0, roundAbove(fastest)}};
    for (std::size_t way = 0; way < 3; ++way) drawing.curve(plot, turnings.at(way).speeds, {ways.at(way).second, 2});
    drawAxes(drawing, frame, plot, {{"speed of the turn, deg per t:", ink}, ways[0], ways[1], ways[2]});
}

// Warn of a pose with gimbal lock.
void tellLock(const Poses& poses, const Frame& frame) {
    for (const auto& [name, pose] : {std::pair("from", &poses.from), std::pair("to", &poses.to)}) {
        const YawPitchRoll found = yawPitchRollOf(orientationOf(*pose));
        if (!found.locked) continue;
        frame.say(std::string("gimbal lock at pose ") + name +
                  ": its nose is on the axis of yaw, so yaw and roll are one turn, and other angles, yaw " +
                  formatted("%.6g", found.yaw) + " and roll 0, are the same pose");
    }
}

}  // namespace mv::path

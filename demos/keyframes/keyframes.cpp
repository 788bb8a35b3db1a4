// keyframes: what moves between keys that somebody has set: a ball, the value of a function, a camera.
#include "keyframes.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mv::keyframes {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    static constexpr std::array scenes{drawBall, drawRunge, drawCamera, drawFlight};
    gpu.drawing.begin(frame);
    scenes.at(static_cast<std::size_t>(s.which))(gpu, s, frame);
    gpu.drawing.draw(frame);
}

void drawBall(Gpu& gpu, const Settings& s, const Frame& frame) {
    // Lay a curve through the keys, and find where the ball is on it
    const Motion<vec3> motion = ballMotion(s);
    const double now = momentOf(motion, frame.time());

    // Draw path and ball, and beside them the ball's speed and acceleration over time
    const Pane pane = leftPane(frame.inUnits());
    showWay(gpu.drawing, s, motion, now, pane);
    showBall(gpu.drawing, motion, now, pane);
    showGraphs(gpu.drawing, s, motion, now, frame.inUnits());
    tell(s, frame);
}

// The motion through the keys, one a second. A closed curve returns to the first key.
Motion<vec3> ballMotion(const Settings& s) {
    std::vector<Keyframe<vec3>> through;
    for (const vec2& key : s.keys) through.push_back({double(through.size()), vec3(key, 0)});
    if (s.curve.kind == KeyCurve::Kind::periodic) through.push_back({double(through.size()), through[0].value});
    return s.curve.through(through, vec3(0), vec3(0));
}

// The time within the motion. The ball rests before 0 and after the end, and then begins again. A closed curve has no end.
double momentOf(const Motion<vec3>& motion, double time) {
    if (motion.curve().isClosed()) return std::fmod(time, motion.end());
    return std::fmod(time, motion.end() + 2 * rest) - rest;
}

std::vector<double> timesOf(std::size_t count) {
    std::vector<double> times;
    for (std::size_t i = 0; i < count; ++i) times.push_back(double(i));
    return times;
}

}  // namespace mv::keyframes

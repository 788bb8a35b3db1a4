// frame-rate: one motion moved in four ways: per picture, per second, as a function of the time, and in steps of one length.
#include "frame-rate.h"

#include <climits>
#include <cmath>

#include "mv/gl/functions.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/narrow_view.h"

namespace mv::frame_rate {

void draw(Gpu& gpu, const Settings& s, const Running& now, const Frame& frame) {
    constexpr std::array ofBeside{drawDisplays, drawWays};  // in the order of Beside
    gpu.drawing.begin(frame);
    ofBeside.at(std::size_t(s.beside))(gpu, s, now, frame);
    gpu.drawing.draw(frame);
    frame.count("pictures of the display", double(now.pictures));
}

// Draw cubes, clocks and balls by the times of the four ways, and how long each of the last pictures stayed.
void drawWays(Gpu& gpu, const Settings& s, const Running& now, const Frame& frame) {
    const std::array<double, 4> time = times(s, now);
    drawCubes(gpu, s, time, frame);
    drawClocks(gpu.drawing, s, now, time, frame.inUnits());
    drawPictures(gpu.drawing, s, now, frame.inUnits());
}

// The same by the first way's times on three displays, and how the error grew.
void drawDisplays(Gpu& gpu, const Settings& s, const Running& now, const Frame& frame) {
    const std::array<double, 4> time = timesBeside(s, now);
    drawCubes(gpu, s, time, frame);
    drawClocks(gpu.drawing, s, now, time, frame.inUnits());
    drawErrors(gpu.drawing, s, now, frame.inUnits());
}

// Draw a cube for each time, turned as far as it is after this time.
void drawCubes(Gpu& gpu, const Settings& s, const std::array<double, 4>& time, const Frame& frame) {
    glEnable(GL_DEPTH_TEST);
    gpu.program.use();
    for (int way = 0; way < 4; ++way) {
        const auto [x, y, width, height] = cubePane(frame, way);
        glViewport(x, y, width, height);
        gpu.program.set("clipFromModel",
                        clipFromCube(turnOf(s, time[static_cast<std::size_t>(way)]), double(width) / height));
        gpu.cube.draw();
    }
    glViewport(0, 0, frame.width(), frame.height());
}

// Move from one picture to the next. `elapsed` is the time that a program measures between the two. Returns the steps of the
// fourth way.
int move(Moved& moved, const Settings& s, double elapsed) {
    // 1. Turn by a fixed angle for each picture: wrong on any display but one of 60 Hz
    moved.turnByPictures += s.speed / 60;

    // 2. Add up the times between pictures. The turn is the speed times the sum
    moved.elapsed.add(elapsed);
    moved.elapsedFloat += static_cast<float>(elapsed);

    // 3. Add up nothing: the turn is a function of the time

    // 4. Take steps of one length, as many as the time owes. A simulation needs them, since other steps make another motion
    return moveInSteps(moved, s, elapsed);
}

int moveInSteps(Moved& moved, const Settings& s, double elapsed) {
    const double h = stepTime(s);
    const int most = s.cap ? mostSteps : INT_MAX;
    int steps = 0;
    for (moved.owed += elapsed; moved.owed >= h && steps < most; ++steps) {
        moved.before = moved.after;
        moved.after = double(++moved.steps) * h;
        moved.owed -= h;
    }
    // Drop the whole steps that the cap leaves owed
    const double dropped = moved.owed - std::fmod(moved.owed, h);
    moved.lost += dropped;
    moved.owed -= dropped;
    return steps;
}

// The time of each way. All motion follows from it: the cube's turn is speed times time, hands and ball have formulas.
std::array<double, 4> times(const Settings& s, const Running& now) {
    const Moved& moved = now.moved;
    const double perPicture = s.speed > 0 ? moved.turnByPictures / s.speed : double(now.pictures) / 60;
    const std::array<double, 4> sums{moved.elapsed.sum, moved.elapsedFloat, moved.elapsed.value(), now.shownAt};
    const double perSecond = sums.at(static_cast<std::size_t>(s.sum));
    const double inSteps = s.between ? glm::mix(moved.before, moved.after, moved.owed / stepTime(s)) : moved.after;
    return {perPicture, perSecond, now.shownAt, inSteps};
}

// The first way's time on three displays, and the second way's on the chosen one.
std::array<double, 4> timesBeside(const Settings& s, const Running& now) {
    std::array<double, 4> result{0, 0, 0, times(s, now)[1]};
    for (std::size_t i = 0; i < now.others.size(); ++i) result.at(i) = times(onDisplay(s, i), now.others[i])[0];
    return result;
}

double turnOf(const Settings& s, double time) { return std::fmod(s.speed * time, 360); }
double stepTime(const Settings& s) { return 1.0 / s.steps; }

mat4 clipFromCube(double turn, double aspect) {
    const mat4 viewFromWorld = lookAt(vec3(0, 1.6, 2.6), vec3(0, 0, 0), vec3(0, 1, 0));
    // In a narrow pane from farther away, as it were: all of the cube is seen
    return perspective(fovyAcross(40, aspect), aspect, 1, 10) * viewFromWorld * rotateY(turn);
}

}  // namespace mv::frame_rate

#pragma once
#include <array>
#include <cmath>
#include <vector>

#include "mv/demo/frame.h"
#include "mv/demo/numbers.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/drawing.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"

namespace mv::frame_rate {

enum class Display { hz60, ntsc, hz144, hz240 };
enum class Sum { doubles, floats, compensated, product };
enum class Hands { clockwise, asWritten };
enum class Ball { asWritten, falling };
enum class Beside { displays, ways };

struct Settings {
    Beside beside = Beside::displays;
    Display display = Display::hz144;
    double speed = 100;     // degrees a second
    double hours = 1;       // at frame 0
    double load = 2;        // ms
    double jitter = 0;      // ms
    double hiccup = 0;      // ms
    int steps = 60;         // a second
    double stepLoad = 0.1;  // ms
    bool cap = true;
    bool between = true;
    Sum sum = Sum::doubles;
    Hands hands = Hands::clockwise;
    Ball ball = Ball::asWritten;
};

struct Gpu {
    Program program{"frame-rate"};
    Mesh cube{colorCube(), "cube"};
    Drawing drawing;
};

// A sum that adds up its rounding errors, too. Source: Kahan, CACM 8 (1965); Neumaier's order of the terms.
struct CompensatedSum {
    double sum = 0, lost = 0;
    void add(double x) {
        const double next = sum + x;
        lost += std::abs(sum) >= std::abs(x) ? (sum - next) + x : (x - next) + sum;
        sum = next;
    }
    double value() const { return sum + lost; }
};

// The state that each way of moving keeps from picture to picture. Times are seconds.
struct Moved {
    double turnByPictures = 0;  // degrees: the sum of the steps of one picture each
    CompensatedSum elapsed;
    float elapsedFloat = 0;
    double owed = 0, before = 0, after = 0, lost = 0;
    long steps = 0;
};

// A picture that the display has shown, and the steps of the fourth way for it.
struct Shown {
    double at, lasted;  // seconds
    int steps;
    bool operator==(const Shown&) const = default;
};

// How far the first way's time was off, in seconds.
struct OffAt {
    double at, off;
    bool operator==(const OffAt&) const = default;
};

// The state kept from frame to frame: the display, and the motion on it.
struct Running {
    long refreshes = 0;  // of the display, up to the picture that it shows
    long pictures = 0;
    long waiting = 1;    // refreshes until the next picture is ready
    double shownAt = 0;  // seconds
    Moved moved;
    std::vector<Shown> last;
    std::vector<OffAt> offs;      // since the start, evenly spread
    double spread = 0.1;          // seconds between two of them
    std::vector<Running> others;  // displays of 60, 144 and 240 Hz, where these are beside each other
};

constexpr int mostSteps = 5;  // for one picture, with a cap

// The technique: frame-rate.cpp. All times are seconds.
void draw(Gpu& gpu, const Settings& s, const Running& now, const Frame& frame);
void drawWays(Gpu& gpu, const Settings& s, const Running& now, const Frame& frame);
void drawDisplays(Gpu& gpu, const Settings& s, const Running& now, const Frame& frame);
void drawCubes(Gpu& gpu, const Settings& s, const std::array<double, 4>& time, const Frame& frame);
std::array<double, 4> times(const Settings& s, const Running& now);
std::array<double, 4> timesBeside(const Settings& s, const Running& now);
double turnOf(const Settings& s, double time);
int move(Moved& moved, const Settings& s, double elapsed);
int moveInSteps(Moved& moved, const Settings& s, double elapsed);
double stepTime(const Settings& s);
mat4 clipFromCube(double turn, double aspect);

// The simulated display: display.cpp.
Running start(const Settings& s);
void step(Running& now, const Settings& s, int index);
double hertz(const Settings& s);
inline constexpr std::array<Display, 3> besideEachOther{Display::hz60, Display::hz144, Display::hz240};
Settings onDisplay(const Settings& s, std::size_t other);

// The ball, 1 high at most, t seconds after it was thrown: ball.cpp.
double ballHeight(Ball ball, double t);
double slidesHeight(double t);
double fallingHeight(double t);

// Clocks, balls and the display's last pictures: figure.cpp.
Pane cubePane(const FrameInfo& frame, int way);
void drawClocks(Drawing& drawing, const Settings& s, const Running& now, const std::array<double, 4>& time,
                const FrameInfo& frame);
void drawPictures(Drawing& drawing, const Settings& s, const Running& now, const FrameInfo& frame);
void drawErrors(Drawing& drawing, const Settings& s, const Running& now, const FrameInfo& frame);

// study.cpp.
void readOut(Gpu& gpu, const Settings& s, const Running& now, const Frame& frame, Numbers& numbers);
std::vector<double> values(const Settings& s);

}  // namespace mv::frame_rate

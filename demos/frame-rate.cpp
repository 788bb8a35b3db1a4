// frame-rate: one motion moved in four ways on a display that is simulated: per picture, per second, as a function of the
// time, and in steps of one length.
//
// Claims (each is a test in tests/claims/frame-rate.cpp; X32 in docs/stability.md is the clock of a day):
// - [right-ones-agree] After an hour, at an irrational speed, what is moved per second and what is a function of the time
//   agree to 1e-12, whatever the display does; what goes in steps is where they were less than two steps before.
// - [wrong-by-its-ratio] What is moved per picture goes display/60 times as fast, and slower where pictures are left out.
// - [made-for-60] On a display of 60 Hz that keeps up nobody sees which of the first three it is.
// - [hands-turn-backwards] As the slide has them, by positive angles, the hands go round the wrong way.
// - [spiral] Where a step takes longer to compute than it lasts, each picture takes longer than the one before; with a cap
//   it does not, and time is lost.
// - [same-frame] A frame is the same whatever was drawn before it, and whoever moved a knob meanwhile.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/geometry/plot.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/drawing.h"
#include "mv/gl/gl.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

using namespace mv;

namespace {

enum class Display { hz60, ntsc, hz144, hz240 };
constexpr std::array<double, 4> rates{60, 60'000 / 1001.0, 144, 240};  // pictures a second
enum class Sense { clockwise, asWritten };
enum class Sum { doubles, floats, compensated, product };

constexpr double secondsShown = 2;  // of the display's last pictures
constexpr int mostSteps = 5;        // for one picture, with a cap
const mat4 viewFromWorld = lookAt(vec3(0, 1.6, 2.6), vec3(0, 0, 0), vec3(0, 1, 0));
const vec4 red(0.75, 0.15, 0.1, 1), blue(0.1, 0.3, 0.7, 1), grey(0.6, 0.6, 0.6, 1), ink(0.1, 0.1, 0.1, 1);

// Added up without losing what is too small for the sum. Source: Kahan, CACM 8 (1965); Neumaier's order of the terms.
struct CompensatedSum {
    double sum = 0, lost = 0;
    void add(double x) {
        const double next = sum + x;
        lost += std::abs(sum) >= std::abs(x) ? (sum - next) + x : (x - next) + sum;
        sum = next;
    }
    double value() const { return sum + lost; }
};

// Of the display, and of what each way of moving remembers from one picture to the next.
struct Running {
    long refreshes = 0;  // of the display, until the picture that it shows
    long pictures = 0;
    long waiting = 1;    // refreshes until the next picture is ready
    double shownAt = 0;  // seconds

    double turnPerPicture = 0;
    CompensatedSum elapsed;
    float elapsedFloat = 0;
    double owed = 0, before = 0, after = 0, lost = 0;
    long steps = 0;

    struct Picture {
        double at, lasted;
        int steps;
        bool operator==(const Picture&) const = default;
    };
    std::vector<Picture> last;
};

// A number from 0 to 1 that looks random, the same for the same n. Source: Steele, Lea, Flood, SplitMix (2014).
double scattered(long n) {
    auto z = static_cast<std::uint64_t>(n) * 0x9E3779B97F4A7C15U;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

struct FrameRate final : Demo {
    Choice<Display> display{this,
                            "display",
                            Display::hz144,
                            {{"60"}, {"59.94", "60000/1001, as television has it"}, {"144"}, {"240"}},
                            "pictures a second that the simulated display can show"};
    Real speed{this, "speed", 100, {0, 720}, "how fast the cube is to turn", "deg/s"};
    Real hours{this, "hours", 1, {0, 24}, "how long the program has been running at frame 0", "h"};
    Real load{this, "load", 2, {0, 100}, "time to draw a picture", "ms"};
    Real jitter{this, "jitter", 0, {0, 20}, "by how much more that differs at random", "ms"};
    Real hiccup{this, "hiccup", 0, {0, 500}, "how much longer one picture in two seconds takes", "ms"};
    NumberChoice rate{this, "steps", 60, {15, 60, 240}, "steps a second of the fourth way"};
    Real stepLoad{this, "step-load", 0.1, {0, 40}, "time to compute one of these steps", "ms"};
    Toggle cap{this, "cap", true, "at most 5 steps for a picture; what is owed beyond is dropped"};
    Toggle between{this, "between", true, "show the steps' motion between two steps, not the last one"};
    Choice<Sum> sum{this,
                    "sum",
                    Sum::doubles,
                    {{"double"},
                     {"float"},
                     {"compensated", "the roundings are added up, too"},
                     {"product", "it does not: the number of the refresh times its length"}},
                    "how the second way adds up its time"};
    Choice<Sense> sense{this,
                        "hands",
                        Sense::clockwise,
                        {{"clockwise"}, {"as-written", "by t/10 and t/120 degrees, as the slide has it"}},
                        "which way the hands go"};

    Readout perPictureOff{this, "per-picture-off", "how far the first way's time is off", "s"};
    Readout perSecondOff{this, "per-second-off", "how far the second way's time is off", "s"};
    Readout stepsOff{this, "steps-off", "how far the fourth way's time is off", "s"};
    Readout lost{this, "lost", "time that the cap has dropped", "s"};
    Readout pictureLasts{this, "picture-lasts", "how long the picture that is shown lasts", "ms"};
    Readout turnPerSecond{this, "turn-per-second", "the cube's turn by the second way, whole turns taken off", "deg"};
    Readout turnOfTime{this, "turn-of-time", "the cube's turn by the third way, whole turns taken off", "deg"};

    Memory<Running> running{this};
    Program program;
    Mesh cube;
    Drawing drawing;

    FrameRate() {
        for (Knob* knob : std::vector<Knob*>{&display, &speed, &hours, &rate, &sum}) knob->beginsAnew();
    }

    void init() override {
        program = Program("frame-rate");
        cube = Mesh(colorCube(), "cube");
    }

    // ---- the four ways to move; `elapsed` is what a program measures since its last picture

    void move(Running& now, double elapsed) const {
        // 1. Wrong: so much for each picture, made for a display of 60 Hz
        now.turnPerPicture += speed / 60;

        // 2. Speed times time: the time since the last picture, added up
        now.elapsed.add(elapsed);
        now.elapsedFloat += static_cast<float>(elapsed);

        // 3. A function of the time: nothing is added up (turnOf below)

        // 4. Steps of one length, as many as the time needs: what a simulation wants, which is not the same for other steps
        now.owed += elapsed;
        int steps = 0;
        for (; now.owed >= stepTime() && !(cap && steps == mostSteps); ++steps) {
            now.before = now.after;
            now.after = double(++now.steps) * stepTime();
            now.owed -= stepTime();
        }
        if (now.owed >= stepTime()) {
            const double dropped = now.owed - std::fmod(now.owed, stepTime());
            now.lost += dropped;
            now.owed -= dropped;
        }
        now.waiting = refreshesFor(load + steps * stepLoad, now);
        now.last.push_back({now.shownAt, double(now.waiting) / hertz(), steps});
    }

    // What each way takes for the time. It moves all else: the cube by speed times it, hands and ball by their formulas.
    std::array<double, 4> times(const Running& now) const {
        const double perSecond = sum == Sum::floats        ? double(now.elapsedFloat)
                                 : sum == Sum::compensated ? now.elapsed.value()
                                 : sum == Sum::product     ? now.shownAt
                                                           : now.elapsed.sum;
        const double inSteps = between ? glm::mix(now.before, now.after, now.owed / stepTime()) : now.after;
        return {speed > 0 ? now.turnPerPicture / speed : double(now.pictures) / 60, perSecond, now.shownAt, inSteps};
    }

    double hertz() const { return rates.at(static_cast<std::size_t>(Display(display))); }
    double stepTime() const { return 1.0 / rate; }
    double handsTurn(double time, double secondsADegree) const {
        return (sense == Sense::clockwise ? -1 : 1) * time / secondsADegree;
    }
    static double ballHeight(double time) {  // thrown anew every six seconds
        const double t = std::fmod(time, 6);
        return std::abs(std::sin(4 * t + 0.6)) * std::exp(-0.35 * t);
    }

    // ---- the simulated display

    // It shows a picture at a refresh, when the picture is ready.
    long refreshesFor(double milliseconds, const Running& now) const {
        if (jitter > 0) milliseconds += jitter * scattered(now.pictures);
        if (hiccup > 0 && std::floor(now.shownAt / 2) != std::floor((now.shownAt - 1 / hertz()) / 2))
            milliseconds += hiccup;
        return std::max(1L, static_cast<long>(std::ceil(milliseconds / 1000 * hertz())));
    }

    void showUntil(Running& now, double time) const {
        while (double(now.refreshes + now.waiting) / hertz() <= time) {
            const double before = now.shownAt;
            now.refreshes += now.waiting;
            now.shownAt = double(now.refreshes) / hertz();
            ++now.pictures;
            move(now, now.shownAt - before);
            if (now.last.size() > 1000) now.last.erase(now.last.begin(), now.last.begin() + 500);
        }
    }

    void reset() override {
        *running = {};
        showUntil(*running, hours * 3600);
    }
    void step(int index) override { showUntil(*running, hours * 3600 + index / 60.0); }

    // ---- the picture

    void draw(const Frame& frame) override {
        const Running& now = *running;
        const auto time = times(now);
        static const std::array<std::string, 4> names{"per picture", "per second", "of the time", "in steps"};
        drawing.begin(frame);
        glEnable(GL_DEPTH_TEST);
        program.use();
        double shownTurn = 0;
        for (std::size_t way = 0; way < 4; ++way) {
            const Pane pane = paneOf(frame, static_cast<int>(way));
            const double turn = std::fmod(speed * time[way], 360);

            // The cube
            const Pane low{pane.x, pane.y, pane.width, std::max(pane.height / 2, 1)};
            glViewport(low.x, low.y, low.width, low.height);
            if (way == 0 || turn != shownTurn) {
                program.set("clipFromModel", perspective(40, low.aspect(), 1, 10) * viewFromWorld * rotateY(turn));
            }
            shownTurn = turn;
            cube.draw();

            // Clock and ball, and how wrong they are
            drawing.in(pane);
            drawClock(pane, time[way], time[2]);
            drawBall(pane, ballHeight(time[way]));
            const vec4 color = std::abs(time[way] - time[2]) > 2 * stepTime() ? red : ink;
            words(pane, 0.99, names[way], ink, 1.2);
            words(pane, 0.91, rounded("%.2f s", time[way]), color);
            words(pane, 0.85, offBy(time[way] - time[2]), color);
        }
        glViewport(0, 0, frame.width(), frame.height());
        drawPictures(frame, now);
        drawing.draw(frame);

        perPictureOff = time[0] - time[2];
        perSecondOff = time[1] - time[2];
        stepsOff = time[3] - time[2];
        lost = now.lost;
        pictureLasts = now.last.empty() ? 0 : 1000 * now.last.back().lasted;
        turnPerSecond = std::fmod(speed * time[1], 360);
        turnOfTime = std::fmod(speed * time[2], 360);
        frame.count("pictures of the display", double(now.pictures));
    }

    // Four beside each other, above the display's last pictures.
    static Pane paneOf(const Frame& frame, int way) {
        const int low = frame.height() / 4, width = std::max(frame.width() / 4, 1);
        return {way * width, low, width, frame.height() - low};
    }
    static double unit(const Pane& pane) { return std::min(pane.width / 240.0, pane.height / 420.0); }

    void words(const Pane& pane, double height, const std::string& text, const vec4& color, double size = 1) {
        const int pixels = std::max(8, static_cast<int>(16 * size * unit(pane)));
        drawing.text({12 * unit(pane), height * pane.height}, text, {pixels, color, vec4(0)});
    }
    static std::string offBy(double seconds) {
        if (std::abs(seconds) < 1e-9) return "right";
        if (std::abs(seconds) < 0.001) return rounded("off by %.0g s", seconds);
        return rounded("off by %+.3f s", seconds);
    }

    void drawClock(const Pane& pane, double time, double right) {
        const vec2 middle(0.36 * pane.width, 0.625 * pane.height);
        const double radius = 66 * unit(pane);
        const auto at = [&](double degrees, double part) {  // from twelve, counter-clockwise
            return middle + part * radius * vec2(-std::sin(radians(degrees)), std::cos(radians(degrees)));
        };
        std::vector<vec2> rim = circle(middle, radius);
        rim.push_back(rim.front());
        drawing.line(rim, {ink, 1.5});
        for (int hour = 0; hour < 12; ++hour) drawing.line(at(30 * hour, 0.88), at(30 * hour, 1), {ink, 1.5});
        drawing.line(middle, at(-right / 10, 0.8), {vec4(0.8, 0.8, 0.8, 1), 4});  // where the hands ought to be
        drawing.line(middle, at(-right / 120, 0.55), {vec4(0.8, 0.8, 0.8, 1), 6});
        drawing.line(middle, at(handsTurn(time, 10), 0.8), {blue, 2});
        drawing.line(middle, at(handsTurn(time, 120), 0.55), {blue, 4});
    }

    void drawBall(const Pane& pane, double height) {
        const double low = 0.5 * pane.height, high = 0.76 * pane.height, x = 0.83 * pane.width, size = 20 * unit(pane);
        drawing.line({x - size, low}, {x + size, low}, {ink, 2});
        drawing.point({x, low + size / 2 + height * (high - low - size)}, size, vec4(0.85, 0.45, 0.1, 1));
    }

    // How long each of the last pictures stood, and in how many steps.
    void drawPictures(const Frame& frame, const Running& now) {
        const double low = std::min(48.0, frame.height() / 10.0), right = frame.width() - 16.0;
        const Box box{{std::min(64.0, frame.width() / 8.0), low}, {right, frame.height() / 4.0 - 10}};
        double longest = 20;
        const double end = now.shownAt;
        for (const auto& one : now.last) {
            if (one.at > end - secondsShown) longest = std::max(longest, 1000 * one.lasted);
        }
        const Plot plot{box, {-secondsShown, 0, "seconds before the picture that is shown"}, {0, 1.1 * longest, "ms"}};
        drawing.in({0, 0, frame.width(), frame.height()});
        for (const auto& one : now.last) {
            const double from = one.at - end;
            if (from <= -secondsShown) continue;
            const vec2 foot = plot.pixel({from, 0}), head = plot.pixel({from, 1000 * one.lasted});
            drawing.fill({foot - vec2(1, 0), head + vec2(0.5, 0)}, one.lasted > 1.5 / hertz() ? red : grey);
            const double dot = std::min(1.0 + one.steps, 6.0);
            if (one.steps > 0) drawing.fill({head - vec2(dot), head + vec2(dot)}, blue);
        }
        drawing.axes(plot);
    }

    // For the study: the time that is told after these hours of pictures, each a refresh long.
    std::vector<double> values() const override {
        const double each = 1 / hertz();
        const long pictures = std::lround(hours * 3600 * hertz());
        float inFloat = 0;
        CompensatedSum inDouble;
        double product = 0;
        for (long i = 1; i <= pictures; ++i) {
            if (sum == Sum::floats) inFloat += static_cast<float>(each);
            if (sum == Sum::doubles) inDouble.sum += each;
            if (sum == Sum::compensated) inDouble.add(each);
            if (sum == Sum::product) product = double(i) * each;
        }
        return {double(inFloat) + inDouble.value() + product};
    }
};

constexpr Declaration declaration{
    .name = "frame-rate",
    .sentence = "Motion per picture, per second, of the time and in steps, on a display that is simulated.",
    .lookFor =
        "After an hour at 144 Hz the first clock is 84 minutes fast; the others are right, the last to two steps.",
    .chapter = "Motion",
    .number = 33,
    .width = 960,
    .height = 560,
    .animated = true,
    .background = vec4(1, 1, 1, 1),
    .needs = {.depth = true},
    .presets =
        {
            {"hour",
             "What was made for 60 Hz runs 2.4 times as fast at 144: it is off by 5040 s in an hour.",
             {},
             {{"per-picture-off", 5039.9, 5040.2}}},
            {"made-for-60",
             "At 60 Hz, and from the start, all agree: a mistake that its author cannot see.",
             {{"display", "60"}, {"hours", "0"}}},
            {"backwards",
             "The slide's formulas, t/10 and t/120 degrees: positive angles turn the hands backwards.",
             {{"hands", "as-written"}, {"display", "60"}}},
            {"stutter",
             "Pictures late at random, one of them very late: the first way is thrown off, and the fourth loses what "
             "the cap drops.",
             {{"jitter", "12"}, {"hiccup", "300"}, {"hours", "0.01"}}},
            {"spiral",
             "A step of 1/60 s takes 20 ms to compute: 5 are owed for each picture, and the cap drops the rest.",
             {{"step-load", "20"}, {"hours", "0.01"}}},
            {"no-cap",
             "Without the cap each picture takes longer than the one before, and soon none comes any more.",
             {{"step-load", "20"}, {"cap", "off"}, {"hours", "0.002"}}},
        },
};

const bool added = addDemo<FrameRate, declaration>();

}  // namespace

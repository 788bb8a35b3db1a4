// The figures over the cubes of frame-rate: clocks, balls, words, and the display's last pictures.
#include <algorithm>
#include <cmath>
#include <string>

#include "frame-rate.h"
#include "mv/formatted.h"
#include "mv/geometry/plot.h"
#include "mv/gl/word_size.h"

namespace mv::frame_rate {
namespace {

const vec4 red(0.75, 0.15, 0.1, 1), blue(0.1, 0.3, 0.7, 1), grey(0.6, 0.6, 0.6, 1), ink(0.1, 0.1, 0.1, 1);
// Of displays of 60, 144 and 240 Hz, and of what is right on all of them.
const std::array<vec4, 4> besideColors{vec4(0.35, 0.35, 0.35, 1), vec4(0.80, 0.45, 0.05, 1), vec4(0.50, 0.25, 0.75, 1),
                                       blue};
constexpr double secondsShown = 2;  // of the display's last pictures

double unit(const Pane& pane) { return std::min(pane.width / 240.0, pane.height / 420.0); }

void words(Drawing& drawing, const Pane& pane, double height, const std::string& text, const vec4& color,
           double size = 1) {
    const int pixels = std::max(leastWords, static_cast<int>(16 * size * unit(pane)));
    drawing.text({12 * unit(pane), height * pane.height}, text, {pixels, color, vec4(0)});
}
std::string offBy(double seconds) {
    if (std::abs(seconds) < 1e-6) return "right";
    if (std::abs(seconds) < 0.001) return formatted("off by %.0g s", seconds);
    return formatted("off by %+.3f s", seconds);
}

// The hands turn by t/10 and t/120 degrees. Grey: where they ought to be.
void drawClock(Drawing& drawing, const Settings& s, const Pane& pane, double time, double right) {
    const vec2 middle(0.36 * pane.width, 0.625 * pane.height);
    const double radius = 66 * unit(pane);
    const auto at = [&](double degrees, double part) {  // from twelve, counter-clockwise
        return middle + part * radius * vec2(-std::sin(radians(degrees)), std::cos(radians(degrees)));
    };
    std::vector<vec2> rim = circle(middle, radius);
    rim.push_back(rim.front());
    drawing.line(rim, {ink, 1.5});
    for (int hour = 0; hour < 12; ++hour) drawing.line(at(30 * hour, 0.88), at(30 * hour, 1), {ink, 1.5});
    const double sign = s.hands == Hands::clockwise ? -1 : 1;
    drawing.line(middle, at(-right / 10, 0.8), {vec4(0.8, 0.8, 0.8, 1), 4});
    drawing.line(middle, at(-right / 120, 0.55), {vec4(0.8, 0.8, 0.8, 1), 6});
    drawing.line(middle, at(sign * time / 10, 0.8), {blue, 2});
    drawing.line(middle, at(sign * time / 120, 0.55), {blue, 4});
}

// The ball is thrown anew every six seconds.
void drawBall(Drawing& drawing, const Settings& s, const Pane& pane, double time) {
    const double height = ballHeight(s.ball, std::fmod(time, 6));
    const double low = 0.5 * pane.height, high = 0.76 * pane.height, x = 0.83 * pane.width, size = 20 * unit(pane);
    drawing.line({x - size, low}, {x + size, low}, {ink, 2});
    drawing.point({x, low + size / 2 + height * (high - low - size)}, size, vec4(0.85, 0.45, 0.1, 1));
}

// Four beside each other, above the display's last pictures.
Pane paneOf(const FrameInfo& frame, int way) {
    const int low = frame.height() / 4, width = std::max(frame.width() / 4, 1);
    return {way * width, low, width, frame.height() - low};
}

}  // namespace

Pane cubePane(const FrameInfo& frame, int way) {
    const Pane pane = paneOf(frame, way);
    return {pane.x, pane.y, pane.width, std::max(pane.height / 2, 1)};
}

void drawClocks(Drawing& drawing, const Settings& s, const Running& now, const std::array<double, 4>& time,
                const FrameInfo& frame) {
    const bool areDisplays = s.beside == Beside::displays;
    const std::array<std::string, 4> names =
        areDisplays ? std::array<std::string, 4>{"at 60 Hz", "at 144 Hz", "at 240 Hz", "per second"}
                    : std::array<std::string, 4>{"per picture", "per second", "of the time", "in steps"};
    for (int way = 0; way < 4; ++way) {
        const double here = time[static_cast<std::size_t>(way)],
                     right =
                         areDisplays && way < 3 ? now.others.at(static_cast<std::size_t>(way)).shownAt : now.shownAt;
        const Pane pane = paneOf(frame, way);
        drawing.in(pane);
        drawClock(drawing, s, pane, here, right);
        drawBall(drawing, s, pane, here);
        const vec4 color = std::abs(here - right) > 2 * stepTime(s) ? red : ink;
        const auto column = static_cast<std::size_t>(way);
        words(drawing, pane, 0.99, names[column], areDisplays ? besideColors.at(column) : ink, 1.2);
        words(drawing, pane, 0.91, formatted("%.2f s", here), color);
        words(drawing, pane, 0.85, offBy(here - right), color);
    }
}

// How far the first way was off on each display since the start, and that the second way is right.
void drawErrors(Drawing& drawing, const Settings& s, const Running& now, const FrameInfo& frame) {
    const double low = std::min(48.0, frame.height() / 10.0), right = frame.width() * 0.66;
    const Box box{{std::min(64.0, frame.width() / 8.0), low}, {right, frame.height() / 4.0 - 10}};
    double least = 0, most = 0;
    for (const Running& display : now.others) {
        for (const OffAt& one : display.offs) {
            least = std::min(least, one.off);
            most = std::max(most, one.off);
        }
    }
    const double room = std::max(0.05 * (most - least), 0.01);
    const Plot plot{
        box, {0, std::max(now.shownAt, 1.0), "seconds since the start"}, {least - room, most + room, "off by, s"}};
    drawing.in({0, 0, frame.width(), frame.height()});
    drawing.axes(plot);
    const double secondWay = times(s, now)[1] - now.shownAt;
    drawing.line(plot.pixel({0, 0}), plot.pixel({plot.x.high, secondWay}), {besideColors.back(), 3});
    for (std::size_t i = 0; i < now.others.size(); ++i) {
        std::vector<vec2> curve{{0, 0}};
        for (const OffAt& one : now.others[i].offs) curve.emplace_back(one.at, one.off);
        drawing.curve(plot, curve, {besideColors.at(i), i == 0 ? 1.5 : 2.5});
    }

    // Name the lines, the highest first
    const int height = std::clamp(frame.height() / 36, leastWords, 15);
    vec2 at(right + 12, box.high.y + 6);
    const auto say = [&](const std::string& text, const vec4& color) {
        drawing.text(at, text, {height, color, vec4(0)});
        at.y -= 1.4 * height;
    };
    say("a fixed turn a picture:", ink);
    for (std::size_t i = now.others.size(); i-- > 0;) {
        const Running& display = now.others[i];
        const double ratio = display.shownAt > 0 ? times(onDisplay(s, i), display)[0] / display.shownAt : 1;
        say(formatted("%.0f Hz: ", hertz(onDisplay(s, i))) +
                (std::abs(ratio - 1) < 1e-3 ? "right" : formatted("%.3g times as fast", ratio)),
            besideColors.at(i));
    }
    say("speed times seconds: right", besideColors.back());
}

// A line for each picture, as high as it lasted; a square tells in how many steps the fourth way went to it.
void drawPictures(Drawing& drawing, const Settings& s, const Running& now, const FrameInfo& frame) {
    const double low = std::min(48.0, frame.height() / 10.0), right = frame.width() - 16.0;
    const Box box{{std::min(64.0, frame.width() / 8.0), low}, {right, frame.height() / 4.0 - 10}};
    const auto first =
        std::ranges::find_if(now.last, [&](const Shown& one) { return one.at > now.shownAt - secondsShown; });
    const std::vector<Shown> seen(first, now.last.end());
    double longest = 20;
    for (const Shown& one : seen) longest = std::max(longest, 1000 * one.lasted);

    const Plot plot{box, {-secondsShown, 0, "seconds before the picture that is shown"}, {0, 1.1 * longest, "ms"}};
    drawing.in({0, 0, frame.width(), frame.height()});
    for (const Shown& one : seen) {
        const double from = one.at - now.shownAt;
        const vec2 foot = plot.pixel({from, 0}), head = plot.pixel({from, 1000 * one.lasted});
        drawing.fill({foot - vec2(1, 0), head + vec2(0.5, 0)}, one.lasted > 1.5 / hertz(s) ? red : grey);
        const double dot = std::min(1.0 + one.steps, 6.0);
        if (one.steps > 0) drawing.fill({head - vec2(dot), head + vec2(dot)}, blue);
    }
    drawing.axes(plot);
}

}  // namespace mv::frame_rate

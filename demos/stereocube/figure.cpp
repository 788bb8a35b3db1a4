// Over the picture of stereocube: both eyes, the screen and a corner from above; and where somebody says how wide the picture
// is, a ruler: 63.5 mm, and the largest parallax.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "mv/formatted.h"
#include "mv/gl/functions.h"
#include "mv/gl/word_size.h"
#include "stereocube.h"

namespace mv::stereocube {

// Parallaxes of the corners that are before both eyes' near planes, in pixels of an eye's picture.
std::optional<Parallax> parallaxOf(const Settings& s, const FrameInfo& frame) {
    const Lens lens = lensOf(s, frame);
    const Eye left = leftEye(s, lens), right = rightEye(s, lens);
    const Pane pane = paneOf(s, frame, 0);
    return mv::parallaxOf(pointsOf(s), left.clipFromEye * left.eyeFromWorld, right.clipFromEye * right.eyeFromWorld,
                          pane.width, pane.height, near);
}

// The window at the convergence distance is the screen: so much of the scene's unit is a millimetre there.
std::optional<OnScreen> onScreen(const Settings& s, const FrameInfo& frame) {
    const std::optional<Parallax> parallax = parallaxOf(s, frame);
    if (s.screenWidth == 0 || isBeside(s) || !parallax) return std::nullopt;
    OnScreen result{parallax->mostAcross * s.screenWidth / frame.width(), std::nullopt};
    const auto [fovy, aspect] = lensOf(s, frame);
    const double window = 2 * s.convergence * std::tan(radians(fovy / 2)) * aspect;
    if (s.stereo == Stereo::offAxis) result.atInfinity = s.eyeSep * s.screenWidth / window;
    return result;
}

void figure(Gpu& gpu, const Settings& s, const Frame& frame) {
    const std::optional<OnScreen> here = onScreen(s, frame);
    if (!here && !hasPlan(s)) return;
    gpu.drawing.begin(frame);
    if (here) drawRuler(gpu, s, frame, *here);
    if (hasPlan(s)) drawPlan(gpu, s, frame);
    const bool isMasked = s.colors == Colors::masks && !isShaded(s);
    if (isMasked) glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gpu.drawing.draw(frame);
    if (here && here->most > betweenPupils)
        frame.say("eyes that are 63.5 mm apart would have to turn outwards: the parallax here is up to " +
                  formatted("%.3g mm", here->most));
}

static vec4 inkOf(const Settings& s) { return vec4(vec3(s.background == Paper::white ? 0.25 : 0.75), 1); }

void drawRuler(Gpu& gpu, const Settings& s, const FrameInfo& frame, const OnScreen& here) {
    const bool isTooFar = here.most > betweenPupils;
    const vec4 ink = inkOf(s), red(0.8, 0.15, 0.1, 1);
    const double pixelsPerMm = frame.width() / s.screenWidth;
    const int size = std::clamp(frame.height() / 36, leastWords, 16);
    const auto bar = [&](double row, double mm, const std::string& words, const vec4& color) {
        const double y = row * 1.9 * size, end = 10 + std::min(mm * pixelsPerMm, 2.0 * frame.width());
        gpu.drawing.line({10, y}, {end, y}, {color, 3});
        gpu.drawing.text({12, y + 1.35 * size}, words + formatted(": %.4g mm", mm), {size, color, vec4(0)});
    };
    bar(0.5, betweenPupils, "between two eyes", ink);
    if (here.most > 0) bar(1.6, here.most, "largest parallax", isTooFar ? red : ink);
}

bool hasPlan(const Settings& s) { return s.plan && !isBeside(s) && !isShaded(s); }

// From above, the eyes on the left: the farthest corner, a line from each eye to it, and how far these are apart on the screen.
void drawPlan(Gpu& gpu, const Settings& s, const FrameInfo& frame) {
    const std::vector<vec3> points = pointsOf(s);
    const vec3 corner = *std::ranges::max_element(points, [](const vec3& a, const vec3& b) { return a.z < b.z; });
    const double ahead = corner.z - s.zDist;
    if (ahead < near) return;
    const double unit = 0.36 * std::min(frame.width(), frame.height()) / std::max({ahead, s.convergence, 1.0});
    const int size = std::clamp(frame.height() / 46, 7, 16);
    const vec2 eyes(0.60 * frame.width(), 0.125 * frame.height());
    const auto place = [&](double x, double forwards) { return eyes + unit * vec2(forwards, x); };
    const vec4 ink = inkOf(s), pale(vec3(ink), 0.45), mark(0.85, 0.45, 0, 1);

    // The plan's directions: ahead is to the right, and the eyes' left, +x, is up
    const double half = 0.085 * frame.height() / unit;
    gpu.drawing.line(place(-half, s.convergence), place(half, s.convergence), {pale, 2});
    for (std::size_t i = 0; i + 1 < points.size(); i += 2) {
        const auto ends = std::pair(points[i], points[i + 1]);
        gpu.drawing.line(place(ends.first.x, ends.first.z - s.zDist), place(ends.second.x, ends.second.z - s.zDist),
                         {pale, 1});
    }
    std::vector<vec2> onScreen;
    for (const double eye : {s.eyeSep / 2, -s.eyeSep / 2}) {
        gpu.drawing.line(place(eye, 0), place(corner.x, ahead), {ink, 1.2});
        gpu.drawing.point(place(eye, 0), 7, ink);
        onScreen.push_back(place(eye + (corner.x - eye) * s.convergence / ahead, s.convergence));
    }
    gpu.drawing.line(onScreen[0], onScreen[1], {mark, 5});
    gpu.drawing.point(place(corner.x, ahead), 6, mark);

    const TextStyle words{size, ink, vec4(0)};
    const auto above = [&](const vec2& at, const std::string& text, const TextStyle& style) {
        gpu.drawing.textAround(at + vec2(0, 0.9 * size), text, style);
    };
    above(place(half, s.convergence), "screen", words);
    above(place(s.eyeSep / 2, 0), "left eye", words);
    above(place(-s.eyeSep / 2, 0) - vec2(0, 1.9 * size), "right eye", words);
    const vec3 only[] = {corner};
    const Lens lens = lensOf(s, frame);
    const Eye left = leftEye(s, lens), right = rightEye(s, lens);
    const auto parallax = mv::parallaxOf(only, left.clipFromEye * left.eyeFromWorld,
                                         right.clipFromEye * right.eyeFromWorld, frame.width(), frame.height(), near);
    if (!parallax) return;
    const TextStyle style{size, mark, vec4(0)};
    const std::string told = "seen from above: parallax of a corner " + formatted("%.3g px", parallax->mostAcross);
    vec2 middle = place(0, std::max(ahead, s.convergence) / 2) - vec2(0, 0.115 * frame.height());
    if (frame.isUpright()) middle.x = std::min(middle.x, frame.width() - textWidth(told, style) / 2.0 - 4);
    above(middle, told, style);
}

}  // namespace mv::stereocube

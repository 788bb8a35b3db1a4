// A ruler over the picture of stereocube, where somebody says how wide it is: 63.5 mm, and the largest parallax.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "mv/gl/functions.h"
#include "mv/gl/word_size.h"
#include "stereocube.h"

namespace mv::stereocube {

// Of the corners that are before both eyes' near planes, in pixels of an eye's picture.
std::optional<Parallax> parallaxOf(const Settings& s, const FrameInfo& frame) {
    const Lens lens = lensOf(s, frame);
    const Eye left = leftEye(s, lens), right = rightEye(s, lens);
    const mat4 worldFromModel = worldFromModelOf(s);
    const Pane pane = paneOf(s, frame, 0);
    std::vector<vec3> corners;
    for (const fvec3& corner : wireOf(s).positions) corners.emplace_back(worldFromModel * vec4(vec3(corner), 1));
    return mv::parallaxOf(corners, left.clipFromEye * left.eyeFromWorld, right.clipFromEye * right.eyeFromWorld,
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
    if (!here) return;
    const bool isTooFar = here->most > betweenPupils;
    const vec4 ink(vec3(s.background == Paper::white ? 0.25 : 0.75), 1), red(0.8, 0.15, 0.1, 1);
    const double pixelsPerMm = frame.width() / s.screenWidth;
    const int size = std::clamp(frame.height() / 36, leastWords, 16);
    const auto bar = [&](double row, double mm, const std::string& words, const vec4& color) {
        const double y = row * 1.9 * size, end = 10 + std::min(mm * pixelsPerMm, 2.0 * frame.width());
        gpu.drawing.line({10, y}, {end, y}, {color, 3});
        gpu.drawing.text({12, y + 1.35 * size}, words + rounded(": %.4g mm", mm), {size, color, vec4(0)});
    };
    gpu.drawing.begin(frame);
    bar(0.5, betweenPupils, "between two eyes", ink);
    if (here->most > 0) bar(1.6, here->most, "largest parallax", isTooFar ? red : ink);
    if (s.colors == Colors::masks) glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    gpu.drawing.draw(frame);
    if (isTooFar)
        frame.say("eyes that are 63.5 mm apart would have to turn outwards: the parallax here is up to " +
                  rounded("%.3g mm", here->most));
}

}  // namespace mv::stereocube

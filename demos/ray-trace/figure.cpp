// What ray-trace shows of its passes.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

#include "mv/gl/text.h"
#include "mv/gl/word_size.h"
#include "mv/math/transform.h"
#include "ray-trace.h"

namespace mv::ray_trace {

TracePicture::Plan planOf(const Settings& s, int width, int height, std::shared_ptr<const TriangleFinder> finder) {
    const vec3 eye(rotateY(s.eyeTurn) * vec4(0.3, s.eyeHeight, 6.2, 1));
    return {.scene = tracedRoom(s.room, s.shadows ? s.lampSize : 0, s.index, std::move(finder)),
            .view = {eye, {0.1, 0.65, 0}, 34.4},
            .options = {.depth = s.depth,
                        .shadows = s.shadows,
                        .schlick = s.fresnel == Fresnel::schlick,
                        .highlight = s.highlight,
                        .falloff = s.falloff,
                        .filtered = s.filtered},
            .pattern = s.pattern,
            .samples = s.samples,
            .seed = static_cast<std::uint32_t>(s.seed),
            .width = width,
            .height = height};
}

std::shared_ptr<const TriangleFinder> finderOf(const Settings& s) {
    if (s.room != TracedRoom::teapot) return {};
    return findTriangles(s.structure, teapotTriangles(static_cast<int>(std::lround(std::sqrt(s.triangles / 64.0)))));
}

static const std::vector<double>& numbersOf(const Settings& s, const Made& made) {
    return s.show == Show::cut ? made.picture.cut() : made.picture.raysAt();
}
static double largest(const Settings& s, const Made& made) { return *std::ranges::max_element(numbersOf(s, made)); }

// The light, or a number of each pixel in grey, white where it is largest.
Picture shown(const Settings& s, const Made& made) {
    const TracePicture& picture = made.picture;
    if (s.show == Show::light) return developed(picture.light(), picture.width(), picture.height());
    const double most = std::max(largest(s, made), 1e-300);
    std::vector<vec3> greys;
    for (const double number : numbersOf(s, made)) greys.emplace_back(number / most);
    return developed(greys, picture.width(), picture.height());
}

void drawFigure(Gpu&, const Settings& s, const Made& made, const Frame& frame) {
    if (s.show == Show::light) return;
    const std::string what = s.show == Show::rays
                                 ? rounded("white: %.3g rays a sample", largest(s, made))
                                 : rounded("white: %.3g %% of the light is cut off", 100 * largest(s, made));
    const TextStyle style{std::clamp(frame.height() / 20, leastWords, 24)};
    drawText(frame, 6, frame.height() - textHeight(style) - 6, what, style);
}

}  // namespace mv::ray_trace

// The figure of ray-trace: its passes.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>

#include "mv/formatted.h"
#include "mv/gl/text.h"
#include "mv/gl/word_size.h"
#include "mv/math/transform.h"
#include "ray-trace.h"
#include "spectrum.h"

namespace mv::ray_trace {

// The scene of each wavelength, which differ by the glass' index alone.
std::vector<TracePicture::Colored> colorsOf(const Settings& s, int wavelengths) {
    if (wavelengths == 1 || (s.room != TracedRoom::stillLife && s.room != TracedRoom::glassBall)) return {};
    std::vector<TracePicture::Colored> colors;
    for (const TracedWavelength& one : tracedWavelengths(wavelengths)) {
        // No glass has an index below that of nothing
        const double index = std::max(1.0, indexAt(one.nanometres, s.index, s.abbe));
        colors.push_back({tracedRoom(s.room, s.shadows ? s.lampSize : 0, index), one.share});
    }
    return colors;
}

TracePicture::Plan planOf(const Settings& s, int width, int height, std::shared_ptr<const TriangleFinder> finder) {
    const vec3 eye(rotateY(s.eyeTurn) * vec4(0.3, s.eyeHeight, 6.2, 1));
    TracedScene scene = tracedRoom(s.room, s.shadows ? s.lampSize : 0, s.index, std::move(finder), s.globeTurn);
    scene.leave = s.leave;
    return {.scene = std::move(scene),
            .colors = colorsOf(s, s.wavelengths),
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
    if (s.room == TracedRoom::strips) return findTriangles(RayStructure::tree, floorOfStrips(s.triangles));
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
    if (s.show == Show::light) return picture.developed();
    const double most = std::max(largest(s, made), 1e-300);
    std::vector<vec3> greys;
    for (const double number : numbersOf(s, made)) greys.emplace_back(number / most);
    return developed(greys, picture.width(), picture.height());
}

void drawFigure(Gpu&, const Settings& s, const Made& made, const Frame& frame) {
    if (s.show == Show::light) return;
    const std::string what = s.show == Show::rays
                                 ? formatted("white: %.3g rays a sample", largest(s, made))
                                 : formatted("white: %.3g %% of the light is cut off", 100 * largest(s, made));
    const TextStyle style{std::clamp(frame.height() / 20, leastWords, 24)};
    drawText(frame, 6, frame.height() - textHeight(style) - 6, what, style);
}

}  // namespace mv::ray_trace

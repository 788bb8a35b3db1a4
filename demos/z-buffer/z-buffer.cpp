// z-buffer: what hides what, by the order of drawing, by a sort, or by a depth for each pixel, in several formats.
#include "z-buffer.h"

#include <algorithm>
#include <cmath>

#include "mv/gl/functions.h"
#include "mv/math/depth_range.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

namespace mv::z_buffer {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    const mat4 clip = clipFromView(s, frame.aspect());
    frame.show("clipFromView", clip);

    // Draw into a target with a depth buffer of the format under test. The buffer that is shown is a texture. The picture's own
    // target needs no depth, and the painter's algorithm needs none at all
    const bool showsDepth = s.shown == Shown::depth;
    constexpr GLenum formats[] = {GL_DEPTH_COMPONENT16, GL_DEPTH_COMPONENT24, GL_DEPTH_COMPONENT32F};
    const Target::Buffers buffers{.depth = s.depthTest || showsDepth,
                                  .texture = !showsDepth,
                                  .depthFormat = formats[static_cast<std::size_t>(s.format)],
                                  .depthTexture = showsDepth};
    gpu.drawn.begin(frame.width(), frame.height(), buffers, "scene");
    drawPlates(gpu, s, clip);

    // Show the colours, or the depths
    frame.bindTarget();
    gpu.show.use();
    gpu.show.set("drawn", 0);
    gpu.show.set("grey", showsDepth);
    if (showsDepth)
        gpu.drawn.bindDepth(0);
    else
        gpu.drawn.bindColor(0);
    gpu.cover.draw();
    tell(s, frame);
}

void drawPlates(Gpu& gpu, const Settings& s, const mat4& clipFromView) {
    // Clear the depths to the farthest one. The smaller depth wins where near is 0, the larger one where near is 1
    const float farthest = nearIsOne(s) ? 0 : 1;
    glClearColor(float(background.r), float(background.g), float(background.b), 1);
    glClear(GL_COLOR_BUFFER_BIT);
    glClearBufferfv(GL_DEPTH, 0, &farthest);

    // Keep the nearest surface in each pixel, and blend translucent ones
    if (s.depthTest) glEnable(GL_DEPTH_TEST);
    if (nearIsOne(s)) glDepthFunc(GL_GREATER);
    if (hasZeroToOne(s)) glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    if (s.opacity < 1) glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);

    // Draw the parts in their order
    const Program& program = s.mapping == Mapping::logarithmic ? *gpu.byLogarithm : gpu.byMatrix;
    program.use();
    program.set("clipFromView", clipFromView);
    if (s.mapping == Mapping::logarithmic) program.set("far", s.far);
    const std::array<Plate, 3> plates = platesOf(s);
    const std::vector<double> cuts = cutsOf(s);
    if (gpu.plateFor.changed(cuts)) gpu.plate = Mesh(plateMesh(cuts), "plate");
    for (const Part& part : partsInOrder(s.order, plates, cuts)) {
        program.set("viewFromPlate", plates[part.plate].viewFromPlate);
        program.set("color", vec4(plates[part.plate].color, s.opacity));
        gpu.plate.draw(6 * part.first, 6 * part.count);
    }

    // Restore the state: the draw that follows is not of this scene
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    if (hasZeroToOne(s)) glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
}

// The painter's algorithm draws the farthest part first, and nearer parts over it.
std::vector<Part> partsInOrder(Order order, const std::array<Plate, 3>& plates, std::span<const double> cuts) {
    const std::size_t cells = cuts.size() - 1;
    std::vector<Part> parts;
    if (order != Order::sorted) {
        // Red is plate 0, green 1 and blue 2
        constexpr std::size_t orders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
        for (const std::size_t plate : orders[static_cast<std::size_t>(order)]) parts.push_back({plate, 0, cells});
        return parts;
    }
    for (std::size_t plate = 0; plate < 3; ++plate)
        for (std::size_t cell = 0; cell < cells; ++cell) parts.push_back({plate, cell, 1});
    const auto distance = [&](const Part& part) {
        const double middle = (cuts[part.first] + cuts[part.first + 1]) / 2;
        return -(plates[part.plate].viewFromPlate * vec4(middle, 0, 0, 1)).z;
    };
    std::ranges::stable_sort(parts, [&](const Part& a, const Part& b) { return distance(a) > distance(b); });
    return parts;
}

// The mappings differ in the third row of the matrix alone.
mat4 clipFromView(const Settings& s, double aspect) {
    const double fovy = fovyFor(aspect);
    if (s.mapping == Mapping::infinite) return infinitePerspective(fovy, aspect, s.near);
    if (s.mapping == Mapping::reversed) return perspective(fovy, aspect, s.near, s.far, DepthRange::oneToZero);
    if (s.mapping == Mapping::flipped) return perspective(fovy, aspect, s.near, s.far, DepthRange::oneToMinusOne);
    if (s.mapping == Mapping::zeroToOne) return perspective(fovy, aspect, s.near, s.far, DepthRange::zeroToOne);
    return perspective(fovy, aspect, s.near, s.far);
}

// 50 degrees across at least: a picture that is higher than wide gains above and below.
double fovyFor(double aspect) { return aspect < 1 ? 2 * degrees(std::atan(std::tan(radians(25)) / aspect)) : 50; }

// The depth that is written for a distance.
float depthOf(const Settings& s, const mat4& clipFromView, float distance) {
    if (s.mapping == Mapping::logarithmic) return std::log2(1 + distance) / std::log2(1 + float(s.far));
    return windowDepth(fmat4(clipFromView), distance, hasZeroToOne(s));
}

bool hasZeroToOne(const Settings& s) { return s.mapping == Mapping::reversed || s.mapping == Mapping::zeroToOne; }
bool nearIsOne(const Settings& s) { return s.mapping == Mapping::reversed || s.mapping == Mapping::flipped; }

std::array<Plate, 3> platesOf(const Settings& s) {
    const mat4 viewFromThings = translate(0, 0, -5) * rotateX(s.spinX) * rotateY(s.spinY);
    if (s.scene == Which::cycle) return barsInACycle(viewFromThings * translate(-0.1, -0.35, 0));
    if (s.scene == Which::panes) return panes(viewFromThings, 5 * s.separation);
    return roadOnGround(s.far, s.separation);
}

// The cuts of a plate. A cell of the road is a quarter as long as its distance: over a cell the GPU interpolates depth in
// float, with an error relative to the largest depth there, that of the near end.
std::vector<double> cutsOf(const Settings& s) {
    std::vector<double> ends{0};
    if (s.scene == Which::road) {
        for (double along = 1 / s.far; along < 1; along *= 1.25) ends.push_back(along);
    } else {
        for (int i = 1; i < s.pieces; ++i) ends.push_back(double(i) / s.pieces);
    }
    ends.push_back(1);
    return ends;
}

}  // namespace mv::z_buffer

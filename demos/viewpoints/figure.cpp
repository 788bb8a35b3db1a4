// The cameras of viewpoints, seen from outside: all nine, numbered; or the axes of one at its eye, and lookAt's matrix with a row in
// the colour of each.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/matrix.hpp>
#include <string>

#include "mv/formatted.h"
#include "mv/gl/functions.h"
#include "mv/gl/text_column.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "viewpoints.h"

namespace mv::viewpoints {

static const std::array<vec4, 4> rowColors{vec4(0.8, 0.1, 0.1, 1), vec4(0, 0.45, 0.1, 1), vec4(0.1, 0.25, 0.9, 1),
                                           vec4(0.45, 0.45, 0.45, 1)};
static const vec4 grey(0.45, 0.45, 0.45, 1), ink(0.1, 0.1, 0.1, 1);

// A number with so many decimals, or with none where they are 0.
static std::string cell(double value, int decimals) {
    const double scale = std::pow(10, decimals), nearest = std::round(value * scale) / scale;
    if (nearest == std::round(nearest)) return formatted("%.0f", nearest + 0.0);  // 0 instead of -0
    return formatted(decimals == 2 ? "%.2f" : "%.3f", nearest);
}

// Write a row of a matrix, with each number ending at its place.
static void writeRow(TextColumn& text, const mat4& m, int row, const std::array<int, 4>& ends, const vec4& color) {
    for (int column = 0; column < 4; ++column)
        text.right(ends.at(std::size_t(column)), cell(m[column][row], column == 3 ? 2 : 3), color);
}

// Write lookAt's matrix, and the product that it is.
static void writeProduct(const Settings& s, const Frame& frame, const Gaze& gaze) {
    TextColumn text(8, 5, 14);
    text.left(0, gaze.space == Space::world ? "lookAt, in the world" : "lookAt, in the car");
    text.left(264, "R: rows u, v, w");
    text.left(482, "T(-eye)");
    text.next();
    const mat4 look = viewByAxes(gaze);
    for (int row = 0; row < 4; ++row) {
        const vec4& color = rowColors.at(std::size_t(row));
        writeRow(text, look, row, {52, 108, 164, 230}, color);
        text.left(240, row == 1 ? "=" : "");
        writeRow(text, turnInto(axesOf(gaze)), row, {308, 364, 420, 442}, color);
        text.left(458, row == 1 ? "*" : "");
        writeRow(text, translate(-gaze.eye), row, {490, 512, 534, 606}, ink);
        text.next();
    }
    const vec3 eye = eyeOf(look);
    const bool isTurnedAfter = gaze.space == Space::car && s.view == View::house;
    text.left(0, "eye = -R^T t = (" + cell(eye.x, 2) + ", " + cell(eye.y, 2) + ", " + cell(eye.z, 2) + ")" +
                     (isTurnedAfter ? ", and then the slide turns the picture" : ""));
    drawText(frame, text.lines);
}

// Draw the axes at the eye, and the gaze to what it looks at.
static void drawAxes(Drawing& drawing, const mat4& clipFromWorld, const mat4& viewFromWorld, const Pane& pane) {
    const vec3 eye = eyeOf(viewFromWorld);
    const mat3 axes = transpose(mat3(viewFromWorld));
    const auto pixel = [&](const vec3& place) {
        return pixelFromNdc(ndcFromClip(clipFromWorld * vec4(place, 1)), pane.width, pane.height);
    };
    drawing.line(pixel(eye), pixel(eye - 150.0 * axes[2]), {grey, 1});
    constexpr std::array names{"u", "v", "w"};
    for (int axis = 0; axis < 3; ++axis) {
        const vec4& color = rowColors.at(std::size_t(axis));
        drawing.arrow(pixel(eye), pixel(eye + 50.0 * axes[axis]), {.color = color, .width = 2.5});
        drawing.textAround(pixel(eye + 62.0 * axes[axis]), names.at(std::size_t(axis)), {15, color, vec4(0)});
    }
    drawing.point(pixel(eye), 7, ink);
}

Pane lowerPane(const Settings& s, const FrameInfo& frame) {
    return {0, 0, frame.width(), s.camera != Outside::off ? std::max(1, frame.height() / 2) : frame.height()};
}
static Pane upperPane(const FrameInfo& frame) {
    const int height = std::max(1, frame.height() / 2);
    return {0, frame.height() - height, frame.width(), height};
}

// Draw nine numbered cameras, and of the chosen one the gaze and what is up. Those of the car stand round it in a circle.
static void drawCameras(Drawing& drawing, const Settings& s, const Car& car, const mat4& clipFromWorld,
                        const Pane& pane) {
    const vec4 chosenColor(0.80, 0.30, 0, 1), upColor(0, 0.35, 0.65, 1);
    const int size = std::clamp(pane.height / 24, 8, 22);
    const bool hasWords = pane.height >= 100;  // else the numbers would lie over each other
    const auto pixel = [&](const vec3& place) {
        return pixelFromNdc(ndcFromClip(clipFromWorld * vec4(place, 1)), pane.width, pane.height);
    };
    for (int view = 0; view < 9; ++view) {
        Settings other = s;
        other.view = View(view);
        const bool isChosen = other.view == s.view, isOfCar = view >= 3 && view <= 7;
        const mat4 viewFromWorld = lookFrom(other, car).viewFromWorld;
        const vec3 eye = eyeOf(viewFromWorld), back(transpose(viewFromWorld)[2]), up(transpose(viewFromWorld)[1]);
        const vec4& color = isChosen ? chosenColor : ink;
        const vec2 from = pixel(eye);
        const double turned = radians(90 - 72.0 * (view - 3));
        vec2 label = isOfCar ? pixel(car.place) + 3.6 * size * vec2(std::cos(turned), std::sin(turned)) : from;
        label.y = std::min(label.y, pane.height - 1.0 * size);  // of a camera that is higher up than the pane
        if (isOfCar) drawing.line(label, from, {color, 1});
        if (isChosen) {
            const double reach = view < 3 || view == 8 ? 90 : 45;
            drawing.arrow(from, pixel(eye - reach * back), {color, 3});
            drawing.arrow(from, pixel(eye + 0.55 * reach * up), {upColor, 3});
            if (hasWords) drawing.textAround(pixel(eye + 0.75 * reach * up), "up", {size, upColor, vec4(0)});
        } else if (!isOfCar) {
            drawing.arrow(from, pixel(eye - 45.0 * back), {color, 1.2});
        }
        drawing.point(label, 1.5 * size + 2, ink);
        drawing.point(label, 1.5 * size, isChosen ? chosenColor : vec4(1));
        if (hasWords) drawing.textAround(label, std::to_string(view + 1), {size, isChosen ? vec4(1) : ink, vec4(0)});
    }
    if (!hasWords) return;
    drawing.text({6, pane.height - 4.0},
                 "nine cameras; below, what number " + std::to_string(int(s.view) + 1) + " sees", {size, ink, vec4(0)});
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    if (s.camera == Outside::off) return;
    // Draw the scene once more, from outside, into the upper half
    const bool isAll = s.camera == Outside::all;
    const Pane pane = upperPane(frame);
    const mat4 clipFromOutside = translate(0, isAll ? 0 : -0.5, 0) * perspective(34, pane.aspect(), 1, 2000);
    const mat4 outsideFromWorld = isAll ? lookAt(vec3(50, -380, 460), vec3(50, 45, 0), vec3(0, 0, 1))
                                        : lookAt(vec3(420, -560, 400), vec3(70, 10, 40), vec3(0, 0, 1));
    const Car car = carAt(frame.index());
    const auto [x, y, width, height] = frame.pixels(pane);
    glViewport(x, y, width, height);
    glScissor(x, y, width, height);
    glEnable(GL_SCISSOR_TEST);
    glClearColor(0.82F, 0.95F, 0.82F, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    gpu.program.use();
    setSun(gpu, s, outsideFromWorld);
    gpu.program.set("clipFromView", clipFromOutside);
    drawScenery(gpu, clipFromOutside, outsideFromWorld);
    drawCar(gpu, outsideFromWorld * car.worldFromCar);

    // Draw all cameras, or the axes of one and the product that its lookAt is
    glDisable(GL_SCISSOR_TEST);
    const FrameInfo inPixels = frame.inPixels();
    glViewport(0, 0, inPixels.width(), inPixels.height());
    gpu.drawing.begin(frame);
    gpu.drawing.in(pane);
    const mat4 clipFromWorld = clipFromOutside * outsideFromWorld;
    if (isAll)
        drawCameras(gpu.drawing, s, car, clipFromWorld, pane);
    else
        drawAxes(gpu.drawing, clipFromWorld, lookFrom(s, car).viewFromWorld, pane);
    gpu.drawing.draw(frame);
    if (!isAll) writeProduct(s, frame, gazeOf(s, car));
}

}  // namespace mv::viewpoints

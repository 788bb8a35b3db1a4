#include "mv/gl/drawing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "mv/demo/handle.h"
#include "mv/gl/state.h"
#include "mv/gl/word_sheet.h"
#include "mv/gl/word_size.h"
#include "mv/math/clip.h"
#include "mv/math/projection.h"

namespace mv {
namespace {

constexpr double onTop = -1;  // the depth of what nothing hides

const char* const shapesVertex = R"(
in vec4 position;
in vec4 color;
out vec4 paint;
void main() {
    paint = color;
    gl_Position = position;
}
)";
const char* const shapesFragment = R"(
in vec4 paint;
out vec4 fragColor;
void main() { fragColor = paint; }
)";

constexpr int tickTextHeight = 13;
const TextStyle tickStyle{.height = tickTextHeight, .background = vec4(0)};

// Without those that the picture's edge would cut off and those that would lie over earlier ones.
std::vector<TextLine> readable(const FrameInfo& frame, const std::vector<TextLine>& lines) {
    std::vector<TextLine> kept;
    std::vector<Box> taken;  // y downwards
    for (const TextLine& line : lines) {
        if (line.text.empty()) continue;
        const vec2 low = vec2(line.x, line.y) + double(wordPadding);
        const Box box{low, low + vec2(textWidth(line.text, line.style) - 2 * wordPadding, line.style.height)};
        const auto isOver = [&](const Box& other) {
            return box.low.x < other.high.x && other.low.x < box.high.x && box.low.y < other.high.y &&
                   other.low.y < box.high.y;
        };
        const bool isCut = box.low.x < 0 || box.low.y < 0 || box.high.x > frame.width() || box.high.y > frame.height();
        if (isCut || std::ranges::any_of(taken, isOver)) continue;
        taken.push_back(box);
        kept.push_back(line);
    }
    return kept;
}

}  // namespace

void Drawing::begin(const Frame& any) {
    const FrameInfo frame = any.FrameInfo::inUnits();
    height_ = frame.height();
    scale_ = frame.scale();
    sizeScale_ = frame.sizeScale();
    pane_ = {0, 0, frame.width(), frame.height()};
    painted_.clear();
    words_.clear();
    tested_ = false;
}

std::optional<vec2> Drawing::pixelOf(const mat4& clipFromModel, const vec3& at) const {
    return pictureFromPane({0, 0, pane_.width, pane_.height}, clipFromModel, at);
}

void Drawing::in(const Pane& pane) { pane_ = pane; }

std::vector<vec2> Drawing::pixels(std::span<const vec2> places) const {
    std::vector<vec2> result;
    result.reserve(places.size());
    for (const vec2& place : places) result.push_back(pixel(place));
    return result;
}

void Drawing::place(std::size_t first, const Box& box) {
    cutTo(painted_, first, {pixel(glm::max(box.low, vec2(0))), pixel(glm::min(box.high, whole().high))});
    const vec3 corner(pixel(vec2(pane_.x, pane_.y)), 0);
    for (std::size_t i = first; i < painted_.size(); ++i) painted_[i].position += corner;
}

void Drawing::stroke(std::span<const vec3> points, const Stroke& stroke, const Box& box) {
    const std::size_t first = painted_.size();
    std::vector<vec3> places;
    places.reserve(points.size());
    for (const vec3& point : points) places.emplace_back(pixel(vec2(point)), point.z);
    strokeLine(painted_, places, stroke.width * sizeScale_, stroke.color);
    place(first, box);
}

void Drawing::line(std::span<const vec2> points, const Stroke& stroke) {
    std::vector<vec3> places;
    places.reserve(points.size());
    for (const vec2& point : points) places.emplace_back(point, onTop);
    this->stroke(places, stroke, whole());
}

void Drawing::line(const vec2& from, const vec2& to, const Stroke& stroke) { line(std::array{from, to}, stroke); }

void Drawing::arrow(const vec2& from, const vec2& to, const Stroke& stroke) {
    const double length = glm::length(to - from);
    if (length == 0) return;
    const vec2 along = (to - from) / length, left(-along.y, along.x);
    const double head = std::min(length, 5 + 2 * stroke.width);
    line(from, to - 0.8 * head * along, stroke);
    const std::size_t first = painted_.size();
    fillConvex(painted_,
               pixels(std::array{to, to - head * along + 0.4 * head * left, to - head * along - 0.4 * head * left}),
               onTop, stroke.color);
    place(first, whole());
}

void Drawing::fill(const Box& box, const vec4& color) {
    const std::size_t first = painted_.size();
    fillConvex(painted_,
               pixels(std::array{box.low, vec2(box.high.x, box.low.y), box.high, vec2(box.low.x, box.high.y)}), onTop,
               color);
    place(first, whole());
}

void Drawing::point(const vec2& at, double size, const vec4& color) {
    const std::size_t first = painted_.size();
    fillConvex(painted_, circle(pixel(at), sizeScale_ * size / 2), onTop, color);
    place(first, whole());
}

void Drawing::point(const mat4& clipFromModel, const vec3& at, double size, const vec4& color) {
    if (const auto pixel = pixelOf(clipFromModel, at)) point(*pixel, size, color);
}

void Drawing::text(const vec2& upperLeft, const std::string& words, const TextStyle& style) {
    TextStyle fitted = style;
    while (fitted.height > leastWords && upperLeft.x + textWidth(words, fitted) - wordPadding > pane_.width) {
        --fitted.height;
    }
    write(upperLeft, words, fitted);
}

void Drawing::write(const vec2& upperLeft, const std::string& words, const TextStyle& style) {
    words_.push_back(
        {pane_.x + int(std::floor(upperLeft.x)), height_ - pane_.y - int(std::floor(upperLeft.y)), words, style});
}

void Drawing::text(const mat4& clipFromModel, const vec3& at, const vec2& moved, const std::string& words,
                   const TextStyle& style) {
    if (const auto pixel = pixelOf(clipFromModel, at)) write(*pixel + moved, words, style);
}

void Drawing::textAround(const vec2& middle, const std::string& words, const TextStyle& style) {
    write(middle + vec2(-textWidth(words, style), textHeight(style)) / 2.0, words, style);
}

void Drawing::edge(const mat4& clipFromModel, const vec3& from, const vec3& to, const Stroke& stroke) {
    const std::span<const vec4> nearAndFar = std::span(clipVolume()).subspan(4);
    const std::vector<vec4> ends =
        clipPolygon({clipFromModel * vec4(from, 1), clipFromModel * vec4(to, 1)}, nearAndFar);
    if (ends.size() < 2) return;
    std::array<vec3, 2> places;
    for (std::size_t i = 0; i < 2; ++i) {
        const vec3 ndc = ndcFromClip(ends[i]);
        places[i] = vec3(pixelFromNdc(ndc, pane_.width, pane_.height), ndc.z);
    }
    tested_ = true;
    this->stroke(places, stroke, whole());
}

void Drawing::axes(const Plot& plot, const Stroke& stroke) {
    const Box& box = plot.box;
    const bool hasRoom = std::min(box.size().x, box.size().y) >= 2 * tickTextHeight;
    const auto label = [&](const vec2& middle, const std::string& words) {
        const vec2 low = middle - vec2(textWidth(words, tickStyle) / 2.0 - wordPadding, tickTextHeight / 2.0);
        if (hasRoom && low.x >= 0 && low.y >= 0) textAround(middle, words, tickStyle);
    };
    line(std::array{vec2(box.low.x, box.high.y), box.low, vec2(box.high.x, box.low.y)}, stroke);
    for (const double value : ticks(plot.x, std::max(1, int(box.size().x / 60)))) {
        const vec2 at = plot.pixel({value, plot.y.low});
        line(at, at - vec2(0, 5), stroke);
        label(at - vec2(0, 14), tickText(value));
    }
    for (const double value : ticks(plot.y, std::max(1, int(box.size().y / 30)))) {
        const vec2 at = plot.pixel({plot.x.low, value});
        line(at, at - vec2(5, 0), stroke);
        const std::string words = tickText(value);
        label(at - vec2(6 + textWidth(words, tickStyle) / 2.0, 0), words);
    }
    label({(box.low.x + box.high.x) / 2, box.low.y - 30}, plot.x.name);
    const double left = box.low.x - 34;
    if (hasRoom && left + wordPadding >= 0) text({left, box.high.y + 26}, plot.y.name, tickStyle);
}

void Drawing::curve(const Plot& plot, std::span<const vec2> values, const Stroke& stroke) {
    std::vector<vec3> places;
    places.reserve(values.size());
    for (const vec2& value : values) places.emplace_back(plot.pixel(value), onTop);
    // Along an edge of the box all of its width is seen
    this->stroke(places, stroke, {plot.box.low - stroke.width, plot.box.high + stroke.width});
}

void Drawing::pixelGrid(const Plot& plot, const Stroke& stroke) {
    const vec2 low = plot.box.low, high = plot.box.high;
    for (long x = std::lround(std::ceil(plot.x.low)); double(x) <= plot.x.high; ++x) {
        const double at = plot.pixel({double(x), plot.y.low}).x;
        line({at, low.y}, {at, high.y}, stroke);
    }
    for (long y = std::lround(std::ceil(plot.y.low)); double(y) <= plot.y.high; ++y) {
        const double at = plot.pixel({plot.x.low, double(y)}).y;
        line({low.x, at}, {high.x, at}, stroke);
    }
}

void Drawing::draw(const Frame& any) {
    const FrameInfo frame = any.FrameInfo::inUnits();
    if (!painted_.empty()) {
        MeshData data;
        const vec2 size = frame.scale() * vec2(frame.width(), frame.height());
        for (const PaintedVertex& vertex : painted_) {
            const vec2 part = vec2(vertex.position) / size;
            data.positions.emplace_back(2 * part.x - 1, 2 * part.y - 1, vertex.position.z);
            data.colors.emplace_back(vertex.color);
        }
        const StateScope scope;
        setOverlayState(tested_ ? Overlay::hiddenByWhatIsNearer : Overlay::onTop);
        if (program_.id() == 0) program_ = Program::fromText("drawing", shapesVertex, shapesFragment);
        if (data.positions != uploaded_.positions || data.colors != uploaded_.colors) {
            mesh_ = Mesh(data, "drawing");
            uploaded_ = std::move(data);
        }
        program_.use();
        mesh_.draw();
    }
    const FrameInfo inPixels = frame.inPixels();
    drawText(inPixels, readable(inPixels, linesInPixels(frame, words_)));
}

}  // namespace mv

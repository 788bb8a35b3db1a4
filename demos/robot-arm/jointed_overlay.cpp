#include "jointed_overlay.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstddef>

#include "mv/formatted.h"
#include "mv/gl/text_column.h"
#include "mv/gl/word_size.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

namespace mv {
namespace {

const vec4 ink(0.1, 0.1, 0.1, 1), grey(0.6, 0.6, 0.6, 1), red(0.8, 0.15, 0.1, 1), reach(0.89, 0.94, 0.99, 1);

std::string withSmallLetter(std::string name) {
    name[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(name[0])));
    return name;
}

}  // namespace

std::string shortNumber(double value) { return tableNumber(std::round(value * 1000) / 1000); }

void JointedOverlay::begin(const Frame& any) {
    const Frame frame = any.inUnits();
    size_ = std::max(leastWords, static_cast<int>(16 * std::min(frame.width() / 960.0, frame.height() / 560.0)));
    below.begin(frame);
    above.begin(frame);
    look({0, 0, frame.width(), frame.height()}, mat4(1));
}

void JointedOverlay::look(const Pane& pane, const mat4& clipFromWorld) {
    pane_ = pane;
    clipFromWorld_ = clipFromWorld;
    lines_ = 0;
    below.in(pane);
    above.in(pane);
}

vec2 JointedOverlay::pixel(const vec3& world) const {
    return pixelFromNdc(ndcFromClip(clipFromWorld_ * vec4(world, 1)), pane_.width, pane_.height);
}

void JointedOverlay::say(const std::string& words, const vec4& color) {
    above.text({size_ / 2, pane_.height - size_ / 3.0 - 1.3 * size_ * lines_++}, words, {size_, color, vec4(0)});
}

void JointedOverlay::ring(double inner, double outer) {
    const double metre = pixel({1, 0, 0}).x - pixel({0, 0, 0}).x;
    below.point(pixel({0, 0, 0}), 2 * outer * metre, reach);
    below.point(pixel({0, 0, 0}), 2 * inner * metre, vec4(1));
}

void JointedOverlay::circleAt(double height, double radius) {
    std::vector<vec2> rim;
    for (int k = 0; k <= 90; ++k) rim.push_back(pixel(vec3(rotateY(4.0 * k) * vec4(radius, height, 0, 1))));
    below.line(rim, {0.93 * reach, 2});
}

void JointedOverlay::target(const vec3& at, const vec3& goal) {
    above.edge(clipFromWorld_, at, goal, {red, 1.5});
    above.point(clipFromWorld_, at, 13, red);
    above.point(clipFromWorld_, at, 8, vec4(1));
    if (goal != at) above.point(clipFromWorld_, goal, 11, red);
}

void JointedOverlay::stick(const Jointed& thing, const std::vector<mat4>& worldFromPart, const Stroke& stroke) {
    std::vector<vec2> points;
    for (const vec3& at : stickOf(thing, worldFromPart)) points.push_back(pixel(at));
    below.line(points, stroke);
}

void JointedOverlay::angles(const Jointed& thing, const std::vector<mat4>& worldFromPart,
                            const std::vector<double>& degrees) {
    for (std::size_t i = 0; i < degrees.size(); ++i) {
        const Joint& joint = thing.tree.joints()[i];
        if (joint.kind == JointKind::fixed) continue;
        const mat4 worldFromRest = (joint.parent ? worldFromPart[*joint.parent] : mat4(1)) * joint.parentFromJoint;
        const auto at = [&](double angle, double radius) {
            return pixel(vec3(worldFromRest * rotate(angle, joint.axis) * vec4(radius, 0, 0, 1)));
        };
        const bool isLimited = std::isfinite(joint.least) && std::isfinite(joint.most);
        const bool isAtLimit = degrees[i] == joint.least || degrees[i] == joint.most;
        const double low = isLimited ? joint.least : 0, high = isLimited ? joint.most : std::fmod(degrees[i], 360);
        std::vector<vec2> arc;
        for (int k = 0; k <= 60; ++k) arc.push_back(at(low + (high - low) * k / 60, 0.35));
        above.line(arc, {isAtLimit ? red : grey, 1.5});
        above.line(at(degrees[i], 0.28), at(degrees[i], 0.42), {isAtLimit ? red : ink, 2.5});
        above.textAround(at((low + high) / 2, 0.58), thing.parts[i].angle + formatted(" %.1f°", degrees[i]),
                         {size_ * 7 / 8, isAtLimit ? red : ink, vec4(1, 1, 1, 0.6)});
    }
}

void JointedOverlay::product(const Frame& frame, const Jointed& thing, const std::vector<mat4>& worldFromPart,
                             const std::vector<double>& degrees, const Pane& beside, bool isInPlane,
                             const std::vector<std::string>& told) {
    const int size = !told.empty() ? size_ * 9 / 8 : isInPlane ? size_ : std::max(leastWords, size_ * 7 / 8);
    const std::vector<int> rows = isInPlane ? std::vector{0, 1, 3} : std::vector{0, 1, 2, 3};
    // Names stand left of their matrices, or above them where there is no room
    const int entries = static_cast<int>(rows.size()) * 7 * size / 2;
    const bool isNarrow = 10 * size + entries + size / 2 > beside.width;
    const int from = isNarrow ? size / 2 : 10 * size, to = from + entries;
    const int left = beside.x;
    TextColumn column(left, frame.height() - beside.y - beside.height + size / 2, size);
    std::size_t written = 0;
    const auto tell = [&](const vec4& color) {
        if (written >= told.size()) return;
        column.left(size / 2, told[written++], color);
        column.next();
    };
    above.in({0, 0, frame.width(), frame.height()});
    const auto bracket = [&](double x, double inwards, double high, double low) {
        above.line(std::vector<vec2>{{x + inwards, high}, {x, high}, {x, low}, {x + inwards, low}}, {grey, 1});
    };
    const auto write = [&](const std::string& sign, const std::string& name, const mat4& matrix, const vec4& color) {
        frame.show(name, matrix);
        if (isNarrow) {
            column.left(size / 2, sign + name);
            column.next();
        }
        for (const int row : rows) {
            if (row == 1 && !isNarrow) column.left(size / 2, sign + name);
            int right = from;
            for (const int k : rows) column.right(right += 7 * size / 2, shortNumber(matrix[k][row]));
            column.next();
        }
        const double bottom = frame.height() - column.lines.back().y - size - 2.0;
        const double top = bottom + (size + 3.0) * double(rows.size());
        bracket(left + from, 0.4 * size, top, bottom);
        bracket(left + to + 0.4 * size, -0.4 * size, top, bottom);
        if (!told.empty()) column.next(size / 4);
        tell(color);
        column.next(size / 2);
    };
    std::string parent = "world", sign = "   ";
    for (const std::size_t i : thing.tree.pathTo(thing.end.joint)) {
        const std::string& name = thing.parts[i].name;
        write(sign, parent.append("From").append(name), thing.tree.parentFromTurned(i, degrees[i]),
              vec4(0.75 * thing.parts[i].color, 1));
        parent = withSmallLetter(name);
        sign = "* ";
    }
    write("= ", "worldFrom" + thing.parts[thing.end.joint].name, worldFromPart[thing.end.joint], ink);
    while (written < told.size()) tell(ink);
    for (const TextLine& line : column.lines) above.text({line.x, frame.height() - line.y}, line.text, line.style);
    above.in(pane_);
}

void JointedOverlay::residuals(const Frame& frame, const std::vector<ResidualCurve>& curves, int left, int allowed,
                               int most) {
    static const std::array<vec4, 3> colors{vec4(0.80, 0.45, 0.05, 1), vec4(0.50, 0.25, 0.75, 1),
                                            vec4(0.05, 0.50, 0.35, 1)};
    const int size = size_;
    const Box box{{left + 4.5 * size, 3.2 * size}, {frame.width() - size, frame.height() * 0.27}};
    const Plot plot{box, {0, double(most), "iterations"}, {1e-12, 10, "residual, m", true}};
    above.in({0, 0, frame.width(), frame.height()});
    above.line(plot.pixel({allowed, plot.y.low}), plot.pixel({allowed, plot.y.high}), {grey, 1});
    double x = left + 9.0 * size;
    for (std::size_t i = 0; i < curves.size(); ++i) {
        const auto& [name, history, isChosen] = curves[i];
        const vec4 color = colors.at(i % colors.size());
        std::vector<vec2> values;
        values.reserve(history.size());
        for (const IkIteration& each : history) values.emplace_back(values.size(), std::max(each.residual, plot.y.low));
        above.curve(plot, values, {color, isChosen ? 3.5 : 1.5});
        if (!values.empty()) above.point(plot.pixel(values.back()), isChosen ? 8 : 6, color);
        above.text({x, box.high.y + 1.4 * size}, name, {size, color, vec4(0)});
        x += textWidth(name, {.height = size}) + size;
    }
    above.axes(plot);
    above.in(pane_);
}

}  // namespace mv

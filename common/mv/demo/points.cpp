#include "mv/demo/points.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mv/demo/number.h"

namespace mv {

Points::Points(Demo* owner, Literal name, std::vector<vec2> initial, Limits limits, Literal help, Literal unit)
    : Knob(owner, name, help, unit), initial_(std::move(initial)), limits_(limits) {
    Points::parse(textOf(initial_));  // refused, if it is none
}

std::string Points::textOf(const std::vector<vec2>& points) {
    std::string text;
    for (const vec2& point : points)
        text += (text.empty() ? "" : "/") + numberText(point.x) + "," + numberText(point.y);
    return text;
}

void Points::parse(std::string_view text) {
    std::vector<vec2> points;
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t slash = std::min(rest.find('/'), rest.size());
        const std::string_view pair = rest.substr(0, slash);
        rest.remove_prefix(slash);
        const std::size_t comma = pair.find(',');
        vec2 point;
        if (comma == pair.npos || !readNumber(pair.substr(0, comma), point.x) ||
            !readNumber(pair.substr(comma + 1), point.y))
            throw refused(text);
        for (int axis = 0; axis < 2; ++axis) {
            // To a rounding of the text: 0.3 is no exact multiple of 0.1
            const double allowed = onGrid(point[axis], axis);
            if (std::abs(allowed - point[axis]) > 1e-6 * limits_.grid) throw refused(text);
            point[axis] = allowed;
        }
        points.push_back(point);
        if (rest.size() == 1) throw refused(text);  // a slash, and nothing behind it
        if (!rest.empty()) rest.remove_prefix(1);
    }
    if (points.size() < limits_.least || points.size() > limits_.most) throw refused(text);
    points_ = std::move(points);
}

std::string Points::range() const {
    const auto axis = [&](const char* name, double low, double high) {
        return std::string(name) + " in " + numberText(low) + " .. " + numberText(high);
    };
    std::string count = std::to_string(limits_.least);
    if (!isFixedNumber()) count += " .. " + std::to_string(limits_.most);
    return count + (limits_.most == 1 ? " point x,y" : " points x,y/x,y") + " with " +
           axis("x", limits_.low.x, limits_.high.x) + ", " + axis("y", limits_.low.y, limits_.high.y) +
           ", multiples of " + numberText(limits_.grid);
}

std::vector<std::string> Points::sweep() const {
    std::vector<vec2> spread;
    for (std::size_t i = 0; i < limits_.most; ++i) {
        const vec2 at =
            limits_.low + double(i) / double(std::max<std::size_t>(limits_.most, 2) - 1) * (limits_.high - limits_.low);
        spread.emplace_back(onGrid(at.x, 0), onGrid(at.y, 1));
    }
    const vec2 corner(onGrid(limits_.low.x, 0), onGrid(limits_.low.y, 1));
    return {textOf(std::vector<vec2>(limits_.least, corner)), initialText(), textOf(spread)};
}

bool Points::step(double amount) {
    const std::vector<vec2> before = points_;
    for (vec2& point : points_) point.x = onGrid(point.x + amount, 0);
    return points_ != before;
}

bool Points::widget(Panel& panel) {
    bool moved = panel.words(*this);
    if (isFixedNumber()) return moved;
    if (panel.button(*this, "+", points_.size() < limits_.most)) moved |= add(points_.size() - 1);
    if (panel.button(*this, "-", points_.size() > limits_.least)) moved |= remove(points_.size() - 1);
    return moved;
}

Coordinate Points::coordinate(std::size_t point, int axis) {
    const auto set = [this, point, axis](double value) {
        points_[point][axis] = std::clamp(value, limits_.low[axis], limits_.high[axis]) + 0.0;
    };
    return {[this, point, axis] { return points()[point][axis]; }, set, limits_.low[axis], limits_.high[axis],
            limits_.grid};
}

bool Points::add(std::size_t after) {
    if (points_.size() >= limits_.most) return false;
    const vec2 point = points_[after];
    points_.insert(points_.begin() + std::ptrdiff_t(after) + 1, point);
    return true;
}

bool Points::remove(std::size_t point) {
    if (points_.size() <= limits_.least) return false;
    points_.erase(points_.begin() + std::ptrdiff_t(point));
    return true;
}

double Points::onGrid(double value, int axis) const {
    // Whole steps of the grid that lie within the limits, as divided once
    const double parts = 1 / limits_.grid, low = std::ceil(limits_.low[axis] * parts - 1e-9),
                 high = std::floor(limits_.high[axis] * parts + 1e-9);
    return std::clamp(std::round(value * parts), low, high) / parts + 0.0;
}

}  // namespace mv

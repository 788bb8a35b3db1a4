#include "figure.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "mv/formatted.h"
#include "mv/gl/word_size.h"
#include "mv/motion/ode_stability.h"

namespace mv {
namespace {

constexpr double farAway = 100;    // m
constexpr double fullColor = 0.1;  // part of the length by which a spring of full colour is stretched

vec4 colorOf(const Spring& spring, double length) {
    const double stretch = length / spring.restLength - 1;
    const vec4 rest(0.65, 0.65, 0.65, 1);
    return glm::mix(rest, stretch > 0 ? springRed : springBlue, std::min(std::abs(stretch) / fullColor, 1.0));
}

vec3 middleOf(const SpringSystem& system, std::span<const double> state) {
    vec3 sum(0);
    double mass = 0;
    for (std::size_t i = 0; i < system.points.size(); ++i) {
        sum += system.points[i].mass * positionOf(state, i);
        mass += system.points[i].mass;
    }
    return sum / mass;
}

// The frame of a graph: room for two lines of words above it, and for numbers beside and below.
Box boxOf(const Pane& pane) {
    const double left = std::min(58.0, pane.width / 6.0), low = std::min(46.0, pane.height / 5.0);
    return {{left, low}, {std::max(pane.width - 18.0, left + 1), std::max(pane.height - 48.0, low + 1)}};
}

}  // namespace

vec2 springPixel(const Pane& pane, const vec3& place) {
    const double unit = std::min(pane.width, pane.height) / 2.9;
    return vec2(pane.width, pane.height) / 2.0 + unit * vec2(place.x - 0.25 * place.z, place.y - 0.35 * place.z);
}

int drawSprings(Drawing& drawing, const Pane& pane, const SpringSetup& setup, std::span<const double> state) {
    const auto& [points, springs, gravity] = setup.system;
    const bool hasFixed = std::ranges::any_of(points, &PointMass::isFixed);
    const vec3 middle = hasFixed ? vec3(0) : middleOf(setup.system, state);
    const auto place = [&](std::size_t point) { return positionOf(state, point) - middle; };
    const auto isNear = [&](std::size_t point) { return glm::length(place(point)) < farAway; };
    const bool holds = setup.hasHand && springs.back().stiffness > 0;
    for (std::size_t i = 0; i < springs.size(); ++i) {
        const Spring& spring = springs[i];
        const bool isHand = setup.hasHand && i + 1 == springs.size();
        if (!isNear(spring.a) || !isNear(spring.b) || (isHand && !holds)) continue;
        const double length = glm::distance(place(spring.a), place(spring.b));
        drawing.line(springPixel(pane, place(spring.a)), springPixel(pane, place(spring.b)),
                     isHand ? Stroke{springHand, 1.5} : Stroke{colorOf(spring, length), 3});
    }
    const double unit = std::min(pane.width, pane.height) / 480.0;
    int lost = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool isHand = setup.hasHand && i + 1 == points.size();
        if (!isNear(i)) {
            ++lost;
        } else if (!isHand) {
            drawing.point(springPixel(pane, place(i)), (points[i].isFixed ? 12 : 9) * unit,
                          points[i].isFixed ? springGrey : springInk);
        } else if (holds) {
            drawing.point(springPixel(pane, place(i)), 14 * unit, springHand);
        }
    }
    return lost;
}

void drawPhase(Drawing& drawing, const Pane& pane, const SpringGame& game) {
    const std::vector<double>& y = game.state();
    const vec2 unit(pulled, pulled * std::sqrt(game.rule().springs.stiffness));
    const vec2 computed = vec2(y[3], y[9]) / unit, exact = game.exact() / unit;
    const vec2 middle = vec2(0.5, 0.6) * vec2(pane.width, pane.height);
    const double radius = 0.24 * std::min(pane.width, pane.height);
    std::vector<vec2> rim = circle(middle, radius);
    rim.push_back(rim.front());
    drawing.line(rim, {springGrey, 1});
    drawing.line(middle, middle + radius * exact, {vec4(0.75, 0.75, 0.75, 1), 7});
    if (glm::length(computed) < farAway) drawing.line(middle, middle + radius * computed, {springBlue, 2.5});
    paneWords(drawing, pane, middle - vec2(radius, 1.15 * radius), "place and speed: blue computed, grey true",
              springInk);
}

void drawEnergy(Drawing& drawing, const Pane& pane, const SpringGame& game) {
    const std::vector<EnergySample>& samples = game.graph();
    const double first = game.first(), whole = game.whole(), largestDrift = game.largestDrift();
    const double last = samples.back().time, from = std::max(0.0, last - 10);
    double low = 0, high = 0;
    for (const EnergySample& sample : samples) {
        if (sample.time < from) continue;
        low = std::min({low, sample.energy, sample.balance});
        high = std::max({high, sample.energy, sample.balance});
    }
    // Not all of a blow-up: it would make a line of all before it
    const double most = whole > 0 ? 1.5 * whole : 1;
    const Axis joules{std::max(low, -most), high > 0 ? 1.2 * std::min(high, most) : 1, "J"};
    const Box box = boxOf(pane);
    const Plot plot{box, {from, std::max(10.0, last), "s"}, joules};
    drawing.in(pane);
    drawing.axes(plot);
    std::vector<vec2> energies, balances;
    for (const EnergySample& sample : samples) {
        if (sample.time < from) continue;
        // Draw points beyond the axis just beyond it, and cut them off there
        const auto within = [&](double energy) { return std::clamp(energy, joules.low - most, joules.high + most); };
        energies.emplace_back(sample.time, within(sample.energy));
        balances.emplace_back(sample.time, within(sample.balance));
    }
    const vec4& color = largestDrift > 1e-3 ? springRed : springInk;
    drawing.line(plot.pixel({from, first}), plot.pixel({plot.x.high, first}), {springGrey, 1});
    drawing.curve(plot, balances, {color, 3});
    drawing.curve(plot, energies, {springBlue, 2});
    paneWords(drawing, pane, {box.low.x, pane.height - 1.0}, "energy", springBlue);
    const std::string off =
        largestDrift < 1e3 ? formatted("off by up to %.1e", largestDrift) : "off by 1000 times and more";
    paneWords(drawing, pane, {box.low.x, pane.height - 22.0}, "energy + dissipated - work: " + off, color);
}

Plot stabilityPlot(const Pane& pane, std::span<const std::complex<double>> numbers) {
    const Box box = boxOf(pane);
    const double aspect = box.size().x / box.size().y;
    double half = 3.4;
    for (const std::complex<double>& z : numbers) {
        half = std::max({half, 1.2 * std::abs(z.imag()), -z.real() / aspect});
    }
    return {box, {-1.25 * aspect * half, 0.75 * aspect * half}, {-half, half}};
}

MeshData stabilityGrid(OdeMethod method, const Plot& plot) {
    constexpr std::uint32_t columns = 240, rows = 144;  // Re z = 0 is a column of it
    MeshData grid;
    for (std::uint32_t row = 0; row <= rows; ++row) {
        for (std::uint32_t column = 0; column <= columns; ++column) {
            const double x = glm::mix(plot.x.low, plot.x.high, double(column) / columns);
            const double y = glm::mix(plot.y.low, plot.y.high, double(row) / rows);
            const double growth = amplification(method, {x, y});
            const double g = std::isfinite(growth) ? (growth - 1) / (growth + 1) : 1;
            grid.positions.emplace_back(x, y, g);
            if (row == rows || column == columns) continue;
            const std::uint32_t at = row * (columns + 1) + column, above = at + columns + 1;
            grid.indices.insert(grid.indices.end(), {at, at + 1, above, above, at + 1, above + 1});
        }
    }
    return grid;
}

void paneWords(Drawing& drawing, const Pane& pane, const vec2& at, const std::string& text, const vec4& color) {
    drawing.text(at, text, {std::clamp(pane.width / 32, leastWords, 15), color});
}

std::vector<std::string> wrapped(const std::string& text, std::size_t width) {
    std::vector<std::string> lines(1);
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t to = std::min(text.find(' ', from), text.size());
        const std::string word = text.substr(from, to - from);
        if (!lines.back().empty() && lines.back().size() + 1 + word.size() > width) lines.emplace_back();
        if (!lines.back().empty()) lines.back() += ' ';
        lines.back() += word;
        from = to + 1;
    }
    return lines;
}

}  // namespace mv

#include "lap.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "mv/error.h"
#include "mv/motion/minimizing_frame.h"

namespace mv {

Lap lapOf(std::vector<PathSample> samples, std::vector<PathFrame> frames, double window) {
    if (samples.size() != frames.size() || samples.size() < 2) {
        throw Error("lapOf", "must have a frame for each sample, and two at least", std::to_string(frames.size()));
    }
    Lap lap{std::move(samples), std::move(frames), {0}, {0}, {}};
    std::vector<double> turned{0};  // degrees since the first sample
    for (std::size_t i = 1; i < lap.samples.size(); ++i) {
        const double way = glm::distance(lap.samples[i - 1].position, lap.samples[i].position);
        if (way == 0) throw Error("lapOf", "must move from sample to sample", std::to_string(i));
        const double turn = closingAngle(turnedTo(lap.frames[i - 1], lap.frames[i].forward), lap.frames[i]);
        lap.ways.push_back(lap.ways.back() + way);
        lap.turns.push_back(turn / way);
        turned.push_back(turned.back() + turn);
    }
    for (std::size_t first = 0, last = 0; first < turned.size(); ++first) {
        last = std::max(first, last);
        while (last + 1 < turned.size() && lap.ways[last] < lap.ways[first] + window) ++last;
        if (std::abs(turned[last] - turned[first]) <= 90) continue;
        std::size_t fastest = last;
        for (std::size_t i = first + 1; i <= last; ++i) {
            if (std::abs(lap.turns[i]) > std::abs(lap.turns[fastest])) fastest = i;
        }
        lap.flips.push_back(fastest);
        first = last;
    }
    return lap;
}

PathFrame frameAt(const Lap& lap, double part, const vec3& velocity) {
    const double place = part * double(lap.frames.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(place), lap.frames.size() - 2);
    const PathFrame before = turnedTo(lap.frames[i], velocity), after = turnedTo(lap.frames[i + 1], velocity);
    const double turn = closingAngle(before, after);
    return std::abs(turn) > 90 ? before : rolled(before, (place - double(i)) * turn);
}

void drawFrame(Drawing& drawing, const mat4& clipFromWorld, const vec3& at, const PathFrame& frame, double size,
               double width) {
    drawing.edge(clipFromWorld, at, at + size * frame.forward, {forwardColor, width});
    drawing.edge(clipFromWorld, at, at + size * frame.up, {upColor, width});
    drawing.edge(clipFromWorld, at, at + size * frame.right, {rightColor, width});
}

void drawLap(Drawing& drawing, const mat4& clipFromWorld, const Lap& lap) {
    double next = 0;
    for (std::size_t i = 0; i < lap.samples.size(); ++i) {
        if (lap.ways[i] < next) continue;
        next = lap.ways[i] + 5;
        drawFrame(drawing, clipFromWorld, lap.samples[i].position, lap.frames[i], 3, 1.5);
    }
    for (const std::size_t i : lap.flips) drawing.point(clipFromWorld, lap.samples[i].position, 11, rightColor);
}

}  // namespace mv

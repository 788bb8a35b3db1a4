#include "mv/motion/path_frame.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/math/robust.h"

namespace mv {
namespace {

// The frame, or none where up is 0 or within 1e-12 rad of the velocity's line. Both are finite, the velocity is not 0.
std::optional<PathFrame> frameFrom(const vec3& velocity, const vec3& up) {
    // Not from unit vectors: their rounding would be what is left of an up nearly along the velocity.
    const vec3 along = scaledForSquares(velocity), upward = scaledForSquares(up);
    const vec3 sideways = accurateCross(along, upward);
    if (!(glm::length(sideways) >= 1e-12 * glm::length(along) * glm::length(upward)) || sideways == vec3(0)) return {};
    const vec3 forward = unit(along), right = unit(sideways);
    return PathFrame{forward, unit(glm::cross(right, forward)), right};
}

void requireVelocity(std::string_view subject, const vec3& velocity) {
    requireFinite(subject, "the velocity", velocity);
    if (velocity == vec3(0)) throw Error(subject, "the velocity must not be 0: a cusp has no forward", "(0, 0, 0)");
}

PathFrame requiredFrame(std::string_view subject, std::string_view name, const vec3& velocity, const vec3& up) {
    requireVelocity(subject, velocity);
    requireFinite(subject, name, up);
    if (const auto frame = frameFrom(velocity, up)) return *frame;
    throw Error(subject, std::string(name).append(" must be more than 1e-12 rad off the velocity's line, and not 0"),
                vectorText(up));
}

vec3 axisLeastAligned(const vec3& direction) {
    int least = 1;
    for (const int i : {2, 0}) {
        if (std::abs(direction[i]) < std::abs(direction[least])) least = i;
    }
    vec3 axis(0);
    axis[least] = 1;
    return axis;
}

template <typename UpOf>
FramesByRule framesBy(std::string_view subject, std::string_view name, std::span<const PathSample> samples, UpOf upOf) {
    requireMoving(subject, samples);
    FramesByRule result;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const vec3& velocity = samples[i].velocity;
        const vec3 up = upOf(samples[i]);
        requireFinite(subject, name, up);
        std::optional<PathFrame> carried;
        if (i > 0) carried = turnedTo(result.frames.back(), velocity);
        auto frame = frameFrom(velocity, up);
        if (!frame) {
            result.vanished.push_back(i);
            frame = carried ? carried : frameFrom(velocity, axisLeastAligned(unit(velocity)));
        } else if (carried && glm::dot(frame->up, carried->up) < 0) {
            result.flipped.push_back(i);
        }
        result.frames.push_back(*frame);
    }
    return result;
}

}  // namespace

mat4 worldFromFrame(const PathFrame& frame, const vec3& position) {
    requireFinite("worldFromFrame", "the position", position);
    return {vec4(frame.right, 0), vec4(frame.up, 0), vec4(-frame.forward, 0), vec4(position, 1)};
}

PathFrame rolled(const PathFrame& frame, double degrees) {
    requireFinite("rolled", "the angle", degrees);
    const double angle = radians(std::fmod(degrees, 360.0)), c = std::cos(angle), s = std::sin(angle);
    return {frame.forward, c * frame.up + s * frame.right, c * frame.right - s * frame.up};
}

PathFrame turnedTo(const PathFrame& frame, const vec3& velocity) {
    requireVelocity("turnedTo", velocity);
    const vec3 forward = unit(velocity), sum = frame.forward + forward;
    const double squares = glm::dot(sum, sum);
    if (!(squares > 1e-12)) {
        throw Error("turnedTo", "directions must be more than 1e-6 rad off opposite ones", vectorText(velocity));
    }
    // Mirrored twice: along the old forward, and along the sum. Drop the part of up along the new forward that rounding
    // leaves.
    const vec3 turned = frame.up - 2 * glm::dot(frame.up, sum) / squares * sum;
    const vec3 up = unit(turned - glm::dot(turned, forward) * forward);
    return {forward, up, glm::cross(forward, up)};
}

PathFrame frameByUp(const vec3& velocity, const vec3& up) { return requiredFrame("frameByUp", "up", velocity, up); }

PathFrame frameByAcceleration(const vec3& velocity, const vec3& acceleration) {
    return requiredFrame("frameByAcceleration", "the acceleration", velocity, acceleration);
}

PathFrame frameByBanking(const vec3& velocity, const vec3& acceleration, const vec3& gravity) {
    return requiredFrame("frameByBanking", "acceleration - gravity", velocity, acceleration - gravity);
}

std::vector<PathSample> samplesOf(const Path& path, double from, double to, int intervals) {
    if (!path.position || !path.velocity || !path.acceleration) {
        throw Error("samplesOf", "a path must have position, velocity and acceleration");
    }
    requireFinite("samplesOf", "the first parameter", from);
    requireFinite("samplesOf", "the last parameter", to);
    if (from == to) throw Error("samplesOf", "the parameters must differ", numberText(from));
    if (intervals < 1) throw Error("samplesOf", "there must be at least 1 interval", std::to_string(intervals));
    std::vector<PathSample> samples;
    for (int i = 0; i <= intervals; ++i) {
        const double part = static_cast<double>(i) / intervals;
        const double t = i == intervals ? to : (1 - part) * from + part * to;
        samples.push_back({path.position(t), path.velocity(t), path.acceleration(t)});
        requireFinite("samplesOf", "the position", samples.back().position);
        requireFinite("samplesOf", "the velocity", samples.back().velocity);
        requireFinite("samplesOf", "the acceleration", samples.back().acceleration);
    }
    return samples;
}

void requireMoving(std::string_view subject, std::span<const PathSample> samples) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const PathSample& sample = samples[i];
        const bool isUsable = isFinite(sample.position) && isFinite(sample.velocity) && isFinite(sample.acceleration);
        if (isUsable && sample.velocity != vec3(0)) continue;
        const std::string here = std::string(subject).append(", sample ").append(std::to_string(i));
        requireFinite(here, "the position", sample.position);
        requireFinite(here, "the acceleration", sample.acceleration);
        requireVelocity(here, sample.velocity);
    }
}

FramesByRule framesByUp(std::span<const PathSample> samples, const vec3& up) {
    return framesBy("framesByUp", "up", samples, [&](const PathSample&) { return up; });
}

FramesByRule framesByAcceleration(std::span<const PathSample> samples) {
    return framesBy("framesByAcceleration", "the acceleration", samples,
                    [](const PathSample& sample) { return sample.acceleration; });
}

FramesByRule framesByBanking(std::span<const PathSample> samples, const vec3& gravity) {
    return framesBy("framesByBanking", "acceleration - gravity", samples,
                    [&](const PathSample& sample) { return sample.acceleration - gravity; });
}

}  // namespace mv

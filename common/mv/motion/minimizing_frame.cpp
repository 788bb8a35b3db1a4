#include "mv/motion/minimizing_frame.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/math/robust.h"

namespace mv {
namespace {

constexpr std::string_view minimizing = "minimizingFrames";

// v in a mirror across n, of any length.
vec3 mirrored(const vec3& v, const vec3& n) { return v - 2 * glm::dot(n, v) / glm::dot(n, n) * n; }

std::string between(std::size_t i) { return std::to_string(i - 1) + " and " + std::to_string(i); }

// Up at sample i from the frame before, not yet perpendicular to the new tangent; `chord` leads there and is not 0.
vec3 upByChord(const vec3& up, const vec3& oldTangent, const vec3& tangent, const vec3& chord, Transport transport,
               std::size_t i) {
    requireFinite(minimizing, "the distance between samples", chord);
    const vec3 along = unit(chord);
    if (!(glm::dot(along, oldTangent) > 0 && glm::dot(along, tangent) > 0)) {
        throw Error(minimizing, "the chord must be within 90 degrees of its tangents: more samples are needed",
                    "between " + between(i));
    }
    if (transport == Transport::project) return up - glm::dot(up, tangent) / glm::dot(along, tangent) * along;
    return mirrored(mirrored(up, along), tangent - mirrored(oldTangent, along));
}

PathFrame nextFrame(const PathFrame& frame, const PathSample& from, const PathSample& to, Transport transport,
                    std::size_t i) {
    const vec3 tangent = unit(to.velocity);
    if (!(glm::dot(frame.forward, tangent) > 0)) {
        throw Error(minimizing, "tangents must be less than 90 degrees apart: more samples are needed",
                    "between " + between(i));
    }
    const bool hasChord = transport == Transport::project || transport == Transport::doubleReflection;
    vec3 up = frame.up;
    if (hasChord && to.position != from.position) {
        up = upByChord(up, frame.forward, tangent, to.position - from.position, transport, i);
    } else if (transport != Transport::reorthogonalize) {
        return turnedTo(frame, to.velocity);
    }
    up = unit(up - glm::dot(up, tangent) * tangent);
    return {tangent, up, glm::cross(tangent, up)};
}

}  // namespace

std::vector<PathFrame> minimizingFrames(std::span<const PathSample> samples, const vec3& firstUp, Transport transport) {
    requireMoving(minimizing, samples);
    std::vector<PathFrame> frames;
    frames.reserve(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        frames.push_back(i == 0 ? frameByUp(samples[i].velocity, firstUp)
                                : nextFrame(frames.back(), samples[i - 1], samples[i], transport, i));
    }
    return frames;
}

double closingAngle(const PathFrame& first, const PathFrame& last) {
    if (!(glm::length(last.forward - first.forward) <= 1e-6)) {
        throw Error("closingAngle", "the path must end in the direction in which it began",
                    vectorText(last.forward) + " after " + vectorText(first.forward));
    }
    const double angle = degrees(std::atan2(glm::dot(last.up, first.right), glm::dot(last.up, first.up)));
    return angle <= -180 ? 180 : angle;
}

std::vector<PathFrame> closedFrames(std::span<const PathSample> samples, std::vector<PathFrame> frames) {
    if (frames.size() != samples.size() || frames.size() < 2) {
        throw Error("closedFrames", "there must be a frame to each sample, and two at least",
                    std::to_string(frames.size()) + " frames, " + std::to_string(samples.size()) + " samples");
    }
    std::vector<double> covered{0};
    for (std::size_t i = 1; i < samples.size(); ++i) {
        covered.push_back(covered.back() + glm::length(samples[i].position - samples[i - 1].position));
    }
    requirePositive("closedFrames", "the length of the path", covered.back());
    const double gap = glm::length(samples.back().position - samples.front().position);
    if (!(gap <= 1e-6 * covered.back())) {
        throw Error("closedFrames", "the path must end where it began", numberText(gap) + " away");
    }
    const double angle = closingAngle(frames.front(), frames.back());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        frames[i] = rolled(frames[i], -angle * (covered[i] / covered.back()));
    }
    return frames;
}

}  // namespace mv

#include "path/track.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <span>
#include <vector>

#include "../math/support.h"
#include "mv/geometry/check.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr std::array tracks{Track::park, Track::eight, Track::ring, Track::knot};

std::vector<PathSample> lapOf(const TrackPath& path, int steps) {
    std::vector<PathSample> samples;
    for (int i = 0; i <= steps; ++i) {
        const CurvePoint<vec3> at = path.curve.at(double(i) / steps);
        samples.push_back({at.position, at.velocity, at.acceleration});
    }
    return samples;
}

TEST(Track, IsClosedAboveTheGroundAndMoves) {
    for (const Track track : tracks) {
        for (const Through through : {Through::spline, Through::catmullRom}) {
            const TrackPath& path = trackPath(track, through);
            EXPECT_EQ(path.curve.start(), 0);
            EXPECT_EQ(path.curve.end(), 1);
            const CurvePoint<vec3> first = path.curve.at(0), last = path.curve.at(1);
            EXPECT_EQ(first.position, last.position);
            EXPECT_EQ(first.velocity, last.velocity);
            for (const PathSample& sample : lapOf(path, 1000)) {
                EXPECT_GT(sample.position.y, 1);
                EXPECT_GT(glm::length(sample.velocity), 10);  // metres a lap
            }
            // The keys are the same
            const double key = path.curve.breaks()[3];
            EXPECT_EQ(path.curve.position(key), trackPath(track, Through::spline).curve.position(key));
        }
    }
}

TEST(Track, TurnsAreWhatTheyAreCalled) {
    // Six roundings of 20, and the spline's error between keys of 1/384 h^4 = 2.4e-7 of the radius
    for (const PathSample& sample : lapOf(trackPath(Track::ring, Through::spline), 640)) {
        EXPECT_NEAR(std::hypot(sample.position.x, sample.position.z), 20, 20 * 3e-7);
        EXPECT_NEAR(sample.position.y, 2, 1e-14);
    }
    // Its turn changes sense twice a lap
    const auto eight = lapOf(trackPath(Track::eight, Through::spline), 999);
    int changes = 0;
    for (std::size_t i = 1; i < eight.size(); ++i) {
        const auto sense = [&](std::size_t k) { return glm::cross(eight[k].velocity, eight[k].acceleration).y > 0; };
        changes += sense(i) != sense(i - 1);
    }
    EXPECT_EQ(changes, 2);
    // The park goes head over heels once: forward is behind itself at the top of the loop
    const auto park = lapOf(trackPath(Track::park, Through::spline), 999);
    EXPECT_GT(std::ranges::max(park, {}, [](const PathSample& s) { return s.position.y; }).position.y, 15.9);
}

TEST(Track, MeshIsSoundAndNeedsAFrameForEachSample) {
    const auto samples = lapOf(trackPath(Track::park, Through::spline), 200);
    const auto by = framesByBanking(samples, {0, -9.81, 0});
    const MeshData mesh = trackMesh(samples, by.frames);
    validate(mesh);
    for (const fvec3& normal : mesh.normals) EXPECT_NEAR(glm::length(normal), 1, 1e-6);
    EXPECT_EQ(refusal([&] { trackMesh(samples, std::span(by.frames).first(200)); }),
              "trackMesh: must have a frame for each sample, 200");
}

}  // namespace

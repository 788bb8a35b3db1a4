#include "gpu-stages/exact_patch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

using namespace mv;

namespace {

// The net is 3 units wide, and x and z are linear in u and v.
double heightAt(const ExactPatch& exact, const vec3& at) {
    return pointOf(exact.patch(), (at.x + 1.5) / 3, (1.5 - at.z) / 3).position.y;
}
bool isOverIt(const vec3& at) { return std::abs(at.x) <= 1.5 && std::abs(at.z) <= 1.5; }

// The error that halving ends with, on ways of less than 20 units.
constexpr double tolerance = 20 * 1e-13;

TEST(ExactPatch, IsMetFromAboveAndFromBelow) {
    for (const double bend : {0.0, -0.3, 0.1}) {
        const ExactPatch exact(bend);
        for (int i = 1; i < 10; ++i) {
            for (int k = 1; k < 10; ++k) {
                const vec3 on = pointOf(exact.patch(), i / 10.0, k / 10.0).position;
                for (const double side : {5.0, -5.0}) {
                    const auto hit = exact.firstHit(on + vec3(0, side, 0), on - vec3(0, side, 0));
                    ASSERT_TRUE(hit);
                    EXPECT_NEAR(*hit, 0.5, tolerance);
                }
            }
        }
    }
}

// Lines that are nearly flat go through its hills: there is no place on the surface before the first.
TEST(ExactPatch, IsMetFirstWhereNothingIsBefore) {
    const ExactPatch exact(0.1);
    int met = 0, missed = 0, again = 0;
    for (int i = -10; i <= 10; ++i) {
        for (int k = 0; k <= 20; ++k) {
            const vec3 from(0.31, 2, 6), to(0.3 * i, 0.1 * k - 0.8, -6);
            const auto hit = exact.firstHit(from, to);
            const auto isAbove = [&](double t) {
                const vec3 at = glm::mix(from, to, t);
                return at.y > heightAt(exact, at);
            };
            bool first = true, begun = false;
            for (int step = 0; step <= 2000; ++step) {
                const double t = step / 2000.0;
                if (!isOverIt(glm::mix(from, to, t))) continue;
                if (!begun) first = isAbove(t);
                begun = true;
                if (!hit || t < *hit - 1e-9) {
                    ASSERT_EQ(isAbove(t), first) << i << " " << k << " " << t;
                } else {
                    again += t > *hit + 1e-9 && isAbove(t) == first ? 1 : 0;
                }
            }
            if (!hit) {
                ++missed;
                continue;
            }
            ++met;
            const vec3 at = glm::mix(from, to, *hit);
            EXPECT_NEAR(at.y, heightAt(exact, at), 10 * tolerance) << "slopes are below 10";
        }
    }
    EXPECT_GT(met, 50);
    EXPECT_GT(missed, 50);
    EXPECT_GT(again, 0) << "some lines go through it and come out again";
}

TEST(ExactPatch, IsMissedBesideIt) {
    const ExactPatch exact;
    EXPECT_FALSE(exact.firstHit({1.6, 5, 0}, {1.6, -5, 0}));
    EXPECT_FALSE(exact.firstHit({0, 5, -1.6}, {0, -5, -1.6}));
    EXPECT_FALSE(exact.firstHit({-5, 3, 0}, {5, 3, 0})) << "above all of its control points";
    EXPECT_FALSE(exact.firstHit({0, 9, 0}, {0, 8, 0})) << "ends before it";
    EXPECT_TRUE(exact.firstHit({1.5, 5, 0}, {1.5, -5, 0})) << "its edge is a part of it";
}

}  // namespace

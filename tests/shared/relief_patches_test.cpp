#include "displacement/relief_patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <string>
#include <utility>

#include "../math/support.h"
#include "mv/geometry/check.h"
#include "mv/geometry/tessellation.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "support/random.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr ReliefBody patchBodies[] = {ReliefBody::wall, ReliefBody::orange};

// A point of a patch, moved by a part of the depth, as the shader moves it.
vec3 movedPoint(const Relief& relief, const ReliefPatch& patch, double u, double v, double part) {
    const vec3 at = glm::mix(glm::mix(patch[0], patch[1], u), glm::mix(patch[2], patch[3], u), v);
    if (relief.body == ReliefBody::wall) return at - vec3(0, 0, part * relief.depth);
    return (1 - part * relief.depth) * glm::normalize(at);
}

}  // namespace

// Each edge within the surface belongs to two patches, with the same bits in both; the orange has no others.
TEST(ReliefPatches, share_their_corners) {
    for (const ReliefBody body : patchBodies) {
        std::map<std::array<double, 6>, int> edges;
        const auto patches = reliefPatches(body);
        EXPECT_EQ(patches.size(), 96);
        for (const ReliefPatch& patch : patches) {
            for (const auto& [a, b] : {std::pair{0, 1}, {1, 3}, {3, 2}, {2, 0}}) {
                const vec3 &p = patch.at(std::size_t(a)), &q = patch.at(std::size_t(b));
                const std::array<double, 3> from{p.x, p.y, p.z}, to{q.x, q.y, q.z};
                const auto& first = std::min(from, to);
                const auto& last = std::max(from, to);
                // Once each way round, so that neighbours face the same side.
                edges[{first[0], first[1], first[2], last[0], last[1], last[2]}] += from < to ? 1 : 100;
            }
        }
        long single = 0;
        for (const auto& [edge, times] : edges) {
            EXPECT_TRUE(times == 101 || times == 1 || times == 100) << times;
            single += times != 101 ? 1 : 0;
        }
        EXPECT_EQ(single, body == ReliefBody::wall ? 2 * 48 + 2 * 2 : 0);
    }
}

TEST(ReliefPatches, are_cut_on_the_smooth_surface) {
    for (const ReliefBody body : patchBodies) {
        for (const int cells : {1, 3, 16}) {
            const MeshData mesh = cutPatches(body, cells);
            validate(mesh);
            EXPECT_EQ(mesh.indices.size(), std::size_t(96) * 6 * std::size_t(cells * cells));
            for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
                const vec3 at(mesh.positions[i]);
                const vec3 wanted = smoothPoint(body, vec2(mesh.texCoords[i]));
                // Floats of up to 33 units; a pole has any u.
                if (body == ReliefBody::orange || std::abs(at.x) > 0) {
                    EXPECT_LT(glm::distance(at, wanted), 4e-6);
                }
                if (body == ReliefBody::orange) {
                    EXPECT_NEAR(glm::length(at), 1, 1e-6);
                }
            }
            // u goes round at most a quarter within a triangle: nowhere from 1 back to 0.
            for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
                for (int k = 1; k < 3; ++k)
                    EXPECT_LE(std::abs(mesh.texCoords[mesh.indices[i + std::size_t(k)]].x -
                                       mesh.texCoords[mesh.indices[i]].x),
                              0.3751F);
            }
        }
    }
    EXPECT_EQ(refusal([] { (void)cutPatches(ReliefBody::wall, 0); }), "cutPatches: must have cells in 1 .. 64, 0");
    EXPECT_EQ(refusal([] { (void)cutPatches(ReliefBody::wall, 65); }), "cutPatches: must have cells in 1 .. 64, 65");
}

// No point that is seen belongs to a patch that is left out, by cameras anywhere; and some patches are left out.
TEST(ReliefPatches, are_drawn_in_parts_where_there_are_too_many_vertices) {
    const std::vector<ReliefPatch> patches = reliefPatches(ReliefBody::orange);
    for (const int parts : {1, 8}) {
        std::size_t corners = 0;
        for (const MeshData& part : patchCorners(patches, parts)) {
            EXPECT_EQ(part.positions.size(), 4 * patches.size() / std::size_t(parts));
            corners += part.positions.size();
        }
        EXPECT_EQ(corners, 4 * patches.size());
    }
    EXPECT_EQ(refusal([&] { (void)patchCorners(patches, 0); }), "patchCorners: must be in one part at least, 0");
    for (const double level : {1.0, 2.0, 7.0, 25.0, 26.0, 64.0}) {
        const PatchCount count = countPatches(patches, {ReliefBody::orange}, {.fixedLevel = level}, scale(0.01));
        EXPECT_EQ(count.vertices, 96 * (level + 1) * (level + 1));
        EXPECT_EQ(count.partsToDraw(), level < 26 ? 1 : 8);
        EXPECT_LE(12 * (level + 1) * (level + 1), 65536);
    }
}

TEST(ReliefPatches, what_is_left_out_is_not_seen) {
    Random random(24);
    long left = 0, seen = 0;
    for (int i = 0; i < 60; ++i) {
        const Relief relief{i % 2 == 0 ? ReliefBody::wall : ReliefBody::orange, random.number(0, 0.25)};
        const vec3 eye = relief.body == ReliefBody::wall ? vec3(random.number(-3, 10), random.number(-1, 1), 0.5)
                                                         : 1.3 * glm::normalize(vec3(random.number(-1, 1), 0.3, 1));
        const vec3 at = relief.body == ReliefBody::wall ? eye + vec3(random.number(-3, 3), 0, random.number(-1, 0.1))
                                                        : vec3(random.number(-1, 1), random.number(-1, 1), 0);
        const mat4 clipFromBody = perspective(40, 1.5, 0.01, 20) * lookAtAnyRoll(eye, at);
        for (const ReliefPatch& patch : reliefPatches(relief.body)) {
            const bool isOutside = isOutsideView(relief, patch, clipFromBody);
            left += isOutside ? 1 : 0;
            bool isSeen = false;
            for (int k = 0; k < 200; ++k) {
                const vec4 clip =
                    clipFromBody *
                    vec4(movedPoint(relief, patch, random.number(0, 1), random.number(0, 1), random.number(0, 1)), 1);
                isSeen |= std::abs(clip.x) < clip.w && std::abs(clip.y) < clip.w && std::abs(clip.z) < clip.w;
            }
            seen += isSeen ? 1 : 0;
            EXPECT_FALSE(isOutside && isSeen);
        }
    }
    EXPECT_GT(left, 1000);
    EXPECT_GT(seen, 200);
}

TEST(ReliefPatches, neighbours_agree_on_levels) {
    for (const ReliefBody body : patchBodies) {
        std::map<std::array<double, 6>, double> levelOf;
        LevelRule rule{.fineness = 100, .eye = vec3(0.1, 0.2, 1.5)};
        for (const ReliefPatch& patch : reliefPatches(body)) {
            const PatchLevels levels = patchLevels({body}, patch, rule, scale(0.01));
            const std::array<std::pair<int, int>, 4> ends{{{0, 2}, {0, 1}, {1, 3}, {2, 3}}};
            for (std::size_t i = 0; i < 4; ++i) {
                const vec3 p = patch.at(std::size_t(ends.at(i).first)), q = patch.at(std::size_t(ends.at(i).second));
                const vec3 middle = p + q, length = glm::abs(p - q);
                const auto [known, isNew] = levelOf.try_emplace(
                    {middle.x, middle.y, middle.z, length.x, length.y, length.z}, levels.outer.at(i));
                EXPECT_EQ(known->second, levels.outer.at(i));
            }
            rule.agrees = false;
            const PatchLevels own = patchLevels({body}, patch, rule, scale(0.01));
            for (const double level : own.outer) EXPECT_EQ(level, own.inner);
            rule.agrees = true;
        }
        rule = {.fixedLevel = 7};
        EXPECT_EQ(patchLevels({body}, reliefPatches(body)[0], rule, scale(0.01)).triangles(), 98);
        EXPECT_EQ(patchLevels({body}, reliefPatches(body)[0], rule, translate(9, 0, 0) * scale(0.01)).triangles(), 0);
        rule.leavesOut = false;
        EXPECT_EQ(patchLevels({body}, reliefPatches(body)[0], rule, translate(9, 0, 0) * scale(0.01)).triangles(), 98);
    }
}

// Between texels heights are off by the second derivative times the square of a texel.
TEST(ReliefPatches, finer_maps_are_nearer) {
    for (const ReliefBody body : patchBodies) {
        const double ratio = heightMapError({body}, 256) / heightMapError({body}, 512);
        EXPECT_NEAR(ratio, 4, 0.8) << "the next term is smaller by as much again";
    }
}

#include "track.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <string>
#include <vector>

#include "mv/error.h"

namespace mv {

namespace {

std::vector<vec3> keysOf(Track track) {
    if (track == Track::park) {
        return {{-24, 2, 28},  {-12, 2, 27.5},      {0, 2, 27},         {6.06, 5.5, 26.7}, {6.06, 12.5, 26.3},
                {0, 16, 26},   {-6.06, 12.5, 25.7}, {-6.06, 5.5, 25.3}, {0, 2, 25},        {11, 2, 24.5},
                {22, 2, 22},   {32, 2, 14},         {36, 2, 3},         {34, 2.5, -9},     {26, 4, -18},
                {15, 8, -23},  {3, 10.5, -25},      {-9, 8, -22},       {-19, 4, -14},     {-29, 3.5, -10},
                {-40, 5, -14}, {-48, 6, -8},        {-50, 5, 4},        {-46, 3, 17},      {-36, 2, 26}};
    }
    const int count = track == Track::knot ? 36 : 64;
    std::vector<vec3> keys;
    for (int i = 0; i < count; ++i) {
        const double t = 2 * pi * i / count, s = std::sin(t), c = std::cos(t);
        if (track == Track::ring) keys.emplace_back(20 * c, 2, -20 * s);
        if (track == Track::eight) keys.emplace_back(36 * c, 2, -36 * c * s);
        if (track == Track::knot) {
            keys.emplace_back(9 * (s + 2 * std::sin(2 * t)), 9 - 5 * std::sin(3 * t), 9 * (c - 2 * std::cos(2 * t)));
        }
    }
    return keys;
}

TrackPath makePath(Track track, Through through) {
    std::vector<vec3> places = keysOf(track);
    places.push_back(places.front());
    Curve<vec3>::Keys keys;
    for (std::size_t i = 0; i < places.size(); ++i) {
        keys.push_back({double(i) / double(places.size() - 1), places[i]});
    }
    Curve<vec3> curve = through == Through::spline ? Curve<vec3>::periodicSpline(keys)
                                                   : Curve<vec3>::catmullRom(keys, Knots::uniform, Ends::closed);
    return {curve, ArcLength(curve)};
}

// The corners, in order round the face.
void addQuad(MeshData& mesh, const std::array<vec3, 4>& corners, const vec3& normal, const vec3& color) {
    for (const std::size_t i : std::initializer_list<std::size_t>{0, 1, 2, 0, 2, 3}) {
        mesh.positions.emplace_back(corners.at(i));
        mesh.normals.emplace_back(normal);
        mesh.colors.emplace_back(color, 1);
    }
}

void addGround(MeshData& mesh) {
    constexpr int half = 14;
    constexpr double side = 10;
    for (int x = -half; x < half; ++x) {
        for (int z = -half; z < half; ++z) {
            const double left = x * side, back = z * side;
            addQuad(
                mesh,
                {vec3(left, 0, back + side), {left + side, 0, back + side}, {left + side, 0, back}, {left, 0, back}},
                {0, 1, 0}, (x + z) % 2 == 0 ? vec3(0.66, 0.80, 0.60) : vec3(0.70, 0.84, 0.64));
        }
    }
}

void addPillar(MeshData& mesh, const vec3& top) {
    constexpr double half = 0.12;
    const std::array<vec2, 4> around{{{-half, -half}, {half, -half}, {half, half}, {-half, half}}};
    for (std::size_t i = 0; i < 4; ++i) {
        const vec3 from(around.at(i).x, 0, around.at(i).y), to(around.at((i + 1) % 4).x, 0, around.at((i + 1) % 4).y);
        const vec3 foot(top.x, 0, top.z);
        addQuad(mesh, {top + from, top + to, foot + to, foot + from}, (from + to) / glm::length(from + to),
                {0.72, 0.72, 0.74});
    }
}

void addSleeper(MeshData& mesh, const vec3& middle, const PathFrame& frame) {
    const vec3 across = 1.3 * frame.right, along = 0.3 * frame.forward, below = 0.15 * frame.up;
    const std::array<vec3, 4> top{middle - across - along - 0.05 * frame.up, middle + across - along - 0.05 * frame.up,
                                  middle + across + along - 0.05 * frame.up, middle - across + along - 0.05 * frame.up};
    addQuad(mesh, top, frame.up, {0.80, 0.66, 0.46});
    addQuad(mesh, {top[3] - below, top[2] - below, top[1] - below, top[0] - below}, -frame.up, {0.36, 0.26, 0.20});
}

// Whether `way` has come to `next`, which goes on by whole steps of `each` until it is ahead again.
bool isNext(double& next, double way, double each) {
    if (way < next) return false;
    next = (std::floor(way / each) + 1) * each;
    return true;
}

}  // namespace

const TrackPath& trackPath(Track track, Through through) {
    static const std::array<TrackPath, 8> paths{
        makePath(Track::park, Through::spline),  makePath(Track::park, Through::catmullRom),
        makePath(Track::eight, Through::spline), makePath(Track::eight, Through::catmullRom),
        makePath(Track::ring, Through::spline),  makePath(Track::ring, Through::catmullRom),
        makePath(Track::knot, Through::spline),  makePath(Track::knot, Through::catmullRom)};
    return paths.at(static_cast<std::size_t>(track) * 2 + static_cast<std::size_t>(through));
}

MeshData trackMesh(std::span<const PathSample> samples, std::span<const PathFrame> frames) {
    if (samples.size() != frames.size()) {
        throw Error("trackMesh", "must have a frame for each sample", std::to_string(frames.size()));
    }
    MeshData mesh;
    addGround(mesh);
    double way = 0, nextSleeper = 0, nextPillar = 0;
    for (std::size_t i = 1; i < samples.size(); ++i) {
        const vec3 from = samples[i - 1].position, to = samples[i].position;
        for (const double side : {-0.75, 0.75}) {
            const vec3 nearEdge = frames[i - 1].right * (side - 0.12), farEdge = frames[i - 1].right * (side + 0.12);
            const vec3 nearNext = frames[i].right * (side - 0.12), farNext = frames[i].right * (side + 0.12);
            addQuad(mesh, {from + nearEdge, from + farEdge, to + farNext, to + nearNext}, frames[i].up,
                    {0.45, 0.47, 0.52});
        }
        if (isNext(nextSleeper, way, 1.2)) addSleeper(mesh, from, frames[i - 1]);
        if (isNext(nextPillar, way, 6)) addPillar(mesh, from - 0.2 * frames[i - 1].up);
        way += glm::distance(from, to);
    }
    return mesh;
}

}  // namespace mv

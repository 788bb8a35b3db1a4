#include "mirror_room.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <string>

#include "mv/error.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/word_size.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/narrow_view.h"

namespace mv {
namespace {

const vec4 red(0.8, 0.1, 0.1, 1), blue(0.1, 0.35, 0.8, 1), grey(0.5, 0.5, 0.5, 1), ink(0.1, 0.1, 0.1, 1);
const vec3 secondMiddle(0, 1.2, 3.4), halfU(1.4, 0, 0), halfV(0, 1, 0);

std::vector<vec2> ringRound(const vec2& middle, double radius) {
    std::vector<vec2> ring;
    ring.reserve(33);
    for (int i = 0; i <= 32; ++i) {
        const double angle = i * std::numbers::pi / 16;
        ring.push_back(middle + radius * vec2(std::cos(angle), std::sin(angle)));
    }
    return ring;
}

}  // namespace

std::vector<Mirror> MirrorRoom::mirrors() const {
    std::vector<Mirror> all{{lookedAt(), vec3(rotateY(turn) * vec4(halfU, 0)), halfV}};
    if (hasSecond) all.push_back({secondMiddle, -halfU, halfV});
    return all;
}

Scene MirrorRoom::scene(double aspect) const {
    static const MeshData floor = grid(1, 1, 10, 10), back = box({-1.5, -1.1, -0.1}, {1.5, 1.1, -0.03}),
                          round = sphere(ballRadius, 64, 32), cube = box(vec3(-0.3), vec3(0.3)),
                          cone = lathe(std::array{vec2(0, 0), vec2(0.3, 0), vec2(0, 1)}, 64),
                          column = box({-0.25, 0, -0.25}, {0.25, 2.7, 0.25});
    const vec3 beside = eye - lookedAt();
    if (std::hypot(beside.x, beside.z) < 0.01)
        throw Error("eye", "must not be above or below the middle of the first mirror, on which it looks");
    Scene scene;
    scene.objects = {{"floor", floor, translate(0, 0, 0.5), {0.82, 0.80, 0.74}},
                     {"frame", back, translate(lookedAt()) * rotateY(turn), {0.45, 0.33, 0.22}},
                     {"ball", round, translate(ball), {0.20, 0.45, 0.80}},
                     {"cube", cube, translate(-1.1, 0.3, -0.9) * rotateY(30), {0.95, 0.65, 0.15}},
                     {"cone", cone, translate(0.75, 0, -0.9), {0.25, 0.60, 0.30}},
                     {"column", column, translate(0.9, 0, -2.9), {0.80, 0.20, 0.18}}};
    if (hasSecond)
        scene.objects.push_back({"second frame", back, translate(secondMiddle) * rotateY(180), {0.35, 0.27, 0.20}});
    scene.lights = {{.position = vec4(3, 5, 2, 0)}};
    scene.viewFromWorld = lookAt(eye, lookedAt(), vec3(0, 1, 0));
    // The frame of the mirror is seen in a narrow picture, too
    scene.clipFromView = translate(-0.3, 0, 0) * perspective(fovyAcross(50, aspect, 1.2), aspect, 0.1, 200);
    return scene;
}

Plot planOfRoom(const FrameInfo& frame) {
    const double height = std::min(0.94 * frame.height(), 0.5 * frame.width()), width = 0.66 * height;
    const vec2 high(frame.width() - 0.03 * height, frame.height() - 0.03 * height);
    return {{high - vec2(width, height), high}, {-3.1, 3.1}, {4.2, -5.2}};
}

void drawPlan(Drawing& drawing, const FrameInfo& frame, const MirrorRoom& room, const Scene& scene,
              const std::vector<std::vector<SeenMirror>>& chains) {
    const Plot plot = planOfRoom(frame);
    const int words = std::clamp(frame.height() / 38, leastWords, 16);
    const double meter = plot.pixel({1, 0}).x - plot.pixel({0, 0}).x;
    const auto at = [&](const vec3& p) { return plot.pixel({p.x, p.z}); };
    const auto label = [&](const vec2& where, const std::string& text, const vec4& color) {
        drawing.textAround(where, text, {words, color, vec4(0)});
    };
    drawing.fill(plot.box, vec4(1, 1, 1, 0.88));

    // Draw all that stands there: ball, cube, cone and column
    for (std::size_t i = 2; i < 6; ++i) {
        const SceneObject& object = scene.objects[i];
        drawing.point(at(vec3(object.worldFromObject[3])), 0.6 * meter, vec4(object.color, 1));
    }
    const auto mirrors = room.mirrors();
    for (const Mirror& mirror : mirrors)
        drawing.line(at(mirror.middle - mirror.halfU), at(mirror.middle + mirror.halfU), {ink, 3});
    label(at(mirrors[0].middle - 0.7 * mirrors[0].halfU) + vec2(0, 0.9 * words), "mirror", ink);

    // Draw the images of the ball, and the way of its light
    for (const auto& chain : chains) {
        for (const SeenMirror& mirror : chain) {
            const vec3 image(mirror.worldFromShown * vec4(room.ball, 1));
            if (image.z > plot.y.low || image.z < plot.y.high || std::abs(image.x) > plot.x.high) continue;
            drawing.line(ringRound(at(image), 0.3 * meter), {blue, 1});
        }
    }
    if (!chains.empty() && chains[0][0].which == 0) {
        const Mirror& mirror = mirrors[0];
        const vec3 image(chains[0][0].worldFromShown * vec4(room.ball, 1));
        const double from = glm::dot(mirror.plane(), vec4(room.eye, 1)), to = glm::dot(mirror.plane(), vec4(image, 1));
        const vec3 hit = glm::mix(room.eye, image, from / (from - to));
        const double right = glm::dot(hit - mirror.middle, mirror.halfU) / glm::dot(halfU, halfU);
        if (to < 0 && std::abs(right) < 1 && std::abs(hit.y - mirror.middle.y) < halfV.y) {
            drawing.line(at(hit), at(image), {grey, 1});
            drawing.arrow(at(room.ball), at(hit), {red, 1.5});
            drawing.arrow(at(hit), at(room.eye), {red, 1.5});
        }
        if (to < 0) label(at(image) + vec2(0, 0.3 * meter + 0.7 * words), "image of the ball", blue);
    }
    drawing.point(at(room.eye), 10, red);
    label(at(room.eye) + vec2(1.6 * words, 0.6 * words), "eye", red);
    label(at(room.ball) - vec2(0, 0.3 * meter + 0.7 * words), "ball", blue);
}

}  // namespace mv

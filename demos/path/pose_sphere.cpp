#include "pose_sphere.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "mv/math/transform.h"

namespace mv {

namespace {

constexpr int parts = 180;  // of a turning

// A circle about the y axis of the ring, in the world.
std::vector<vec3> circleOf(const mat4& worldFromRing, double radius, double height = 0) {
    std::vector<vec3> points;
    for (int degrees = 0; degrees <= 360; degrees += 6) {
        points.emplace_back(worldFromRing * rotateY(degrees) * vec4(radius, height, 0, 1));
    }
    return points;
}

}  // namespace

Turning turningOf(const std::function<quat(double t)>& poseAt) {
    Turning turning;
    turning.slowest = HUGE_VAL;
    quat last = poseAt(0);
    for (int i = 0; i <= parts; ++i) {
        const quat now = poseAt(double(i) / parts);
        const mat4 turned = rotationMatrix(now);
        turning.nose.emplace_back(-turned[2]);
        turning.roof.emplace_back(turned[1]);
        if (i == 0) continue;
        const double turn = angleBetween(last, now), speed = turn * parts;
        turning.speeds.emplace_back((i - 0.5) / parts, speed);
        turning.whole += turn;
        turning.slowest = std::min(turning.slowest, speed);
        turning.fastest = std::max(turning.fastest, speed);
        last = now;
    }
    return turning;
}

void drawOnSphere(Drawing& drawing, const mat4& clipFromWorld, const std::vector<vec3>& points, const Stroke& stroke) {
    const vec3 towardsEye(glm::inverse(clipFromWorld) * vec4(0, 0, -1, 0));
    for (std::size_t i = 1; i < points.size(); ++i) {
        const bool isBehind = glm::dot(points[i], towardsEye) < 0;
        drawing.edge(clipFromWorld, points[i - 1], points[i],
                     {vec4(vec3(stroke.color), isBehind ? 0.35 : 1), isBehind ? 0.7 * stroke.width : stroke.width});
    }
}

void drawTurning(Drawing& drawing, const mat4& clipFromWorld, const Turning& turning, const vec4& color) {
    const Stroke pale{vec4(0.80, 0.82, 0.86, 1), 1};
    for (const double latitude : {-60.0, -30.0, 0.0, 30.0, 60.0}) {
        const double angle = radians(latitude);
        drawOnSphere(drawing, clipFromWorld, circleOf(mat4(1), std::cos(angle), std::sin(angle)), pale);
    }
    for (int longitude = 0; longitude < 180; longitude += 30) {
        drawOnSphere(drawing, clipFromWorld, circleOf(rotateY(longitude) * rotateX(90), 1), pale);
    }
    drawOnSphere(drawing, clipFromWorld, turning.roof, {vec4(0.6, 0.6, 0.65, 1), 2});
    drawOnSphere(drawing, clipFromWorld, turning.nose, {color, 3});
    for (const vec3& end : {turning.nose.front(), turning.nose.back()}) {
        drawing.point(clipFromWorld, end, 8, vec4(0.1, 0.1, 0.1, 1));
    }
}

void drawGimbal(Drawing& drawing, const mat4& clipFromWorld, const YawPitchRoll& angles,
                const std::array<vec4, 3>& colors) {
    constexpr double outerRadius = 0.86, innerRadius = 0.76;
    const mat4 outer = rotateY(angles.yaw), inner = outer * rotateX(angles.pitch);
    const vec3 pitchAxis(outer[0]), yawAxis(0, 1, 0), rollAxis(inner[2]);
    drawOnSphere(drawing, clipFromWorld, circleOf(outer * rotateX(90), outerRadius), {colors[1], 2});
    drawOnSphere(drawing, clipFromWorld, circleOf(inner, innerRadius), {colors[0], 2});
    drawing.edge(clipFromWorld, 1.1 * yawAxis, -1.1 * yawAxis, {colors[1], 2});
    drawing.edge(clipFromWorld, outerRadius * pitchAxis, -outerRadius * pitchAxis, {colors[0], 2});
    drawing.edge(clipFromWorld, innerRadius * rollAxis, -rollAxis, {colors[2], 2});
}

}  // namespace mv

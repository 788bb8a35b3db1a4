#include "exact_sphere.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace mv::shading {

ExactSphere::ExactSphere(const Settings& s, const FrameInfo& frame) : ExactSphere(s, sceneOf(s, frame)) {}

ExactSphere::ExactSphere(const Settings& s, const Scene& scene)
    : worldFromClip_(glm::inverse(scene.clipFromWorld())),
      eye_(glm::inverse(scene.viewFromWorld)[3]),
      lamp_(scene.lights.front().position),
      lobe_(materialOf(s.material).isBrushed ? Lobe::brushed : s.lobe),
      part_(materialOf(s.material).highlight),
      exponent_(s.exponent) {}

std::vector<double> ExactSphere::picture(int width, int height, int side) const {
    std::vector<double> values;
    for (int row = 0; row < height; ++row) {
        for (int column = 0; column < width; ++column) values.push_back(pixel(column, row, width, height, side));
    }
    return values;
}

std::optional<double> ExactSphere::at(double x, double y) const {
    const vec4 far = worldFromClip_ * vec4(x, y, 1, 1);
    const vec3 way = glm::normalize(vec3(far) / far.w - eye_);
    const double along = -glm::dot(eye_, way), square = glm::dot(eye_, eye_) - along * along;
    if (square > std::pow(sphereRadius * 6 / 7, 2)) return {};
    const vec3 point = eye_ + (along - std::sqrt(sphereRadius * sphereRadius - square)) * way;
    return part_ * highlight(lobe_, glm::normalize(point), glm::normalize(lamp_ - point), -way, exponent_);
}

double ExactSphere::pixel(int column, int row, int width, int height, int side) const {
    const auto sample = [&](double right, double down) {
        return at(2 * (column + right) / width - 1, 1 - 2 * (row + down) / height);
    };
    if (!sample(0.5, 0.5)) return -1;
    double sum = 0;
    for (int i = 0; i < side; ++i) {
        for (int j = 0; j < side; ++j) sum += sample((i + 0.5) / side, (j + 0.5) / side).value_or(0);
    }
    return sum / (side * side);
}

}  // namespace mv::shading

#include "mv/motion/springs.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <utility>

#include "mv/error.h"
#include "mv/math/require.h"

namespace mv {
namespace {

constexpr const char* springsSubject = "springs";

void requireNotNegative(const std::string& name, double value) {
    if (!(value >= 0 && isFinite(value))) {
        throw Error(springsSubject, name + " must be 0 or more and finite", numberText(value));
    }
}

void requireSize(const SpringSystem& system, std::span<const double> state) {
    if (state.size() == 6 * system.points.size()) return;
    throw Error(springsSubject,
                "the state of " + std::to_string(system.points.size()) + " points must have six numbers for each",
                std::to_string(state.size()));
}

void add(std::span<double> values, std::size_t point, const vec3& v) {
    for (std::size_t i = 0; i < 3; ++i) values[3 * point + i] += v[static_cast<int>(i)];
}

void addBlock(std::vector<MatrixEntry>& entries, std::size_t row, std::size_t column, const mat3& block) {
    for (int i = 0; i < 3; ++i) {
        for (int j = 0; j < 3; ++j) {
            entries.push_back({static_cast<int>(row) + i, static_cast<int>(column) + j, block[j][i]});
        }
    }
}

// f of y = (q, v): v, and the forces divided by the masses.
void slopeOf(const SpringSystem& system, std::span<const double> y, std::span<double> dydt) {
    const std::size_t n = system.points.size();
    const std::span<double> accelerations = dydt.subspan(3 * n);
    for (std::size_t i = 0; i < 3 * n; ++i) {
        dydt[i] = y[3 * n + i];
        accelerations[i] = 0;
    }
    for (const Spring& spring : system.springs) {
        const vec3 d = positionOf(y, spring.b) - positionOf(y, spring.a);
        vec3 force = spring.stiffness * d;  // on a
        if (spring.restLength > 0 || spring.damping > 0) {
            const double length = glm::length(d), rate = glm::dot(d, velocityOf(y, spring.b) - velocityOf(y, spring.a));
            force += (spring.damping * rate / length - spring.stiffness * spring.restLength) * (d / length);
        }
        add(accelerations, spring.a, force / system.points[spring.a].mass);
        add(accelerations, spring.b, -force / system.points[spring.b].mass);
    }
    for (std::size_t p = 0; p < n; ++p) {
        if (!system.points[p].isFixed) {
            add(accelerations, p, system.gravity);
        } else {
            for (std::size_t i = 3 * p; i < 3 * p + 3; ++i) dydt[i] = accelerations[i] = 0;
        }
    }
}

void jacobianOf(const SpringSystem& system, std::span<const double> y, std::vector<MatrixEntry>& entries) {
    const std::size_t n = system.points.size();
    for (std::size_t p = 0; p < n; ++p) {
        if (!system.points[p].isFixed) addBlock(entries, 3 * p, 3 * (n + p), mat3(1));
    }
    for (const Spring& spring : system.springs) {
        const vec3 d = positionOf(y, spring.b) - positionOf(y, spring.a);
        const vec3 v = velocityOf(y, spring.b) - velocityOf(y, spring.a);
        // The force on a is k d + (c u.v - k L) u with the unit vector u along d, whose derivative is (I - u u^T)/|d|.
        mat3 byPosition = spring.stiffness * mat3(1), byVelocity(0);
        if (spring.restLength > 0 || spring.damping > 0) {
            const double length = glm::length(d);
            const vec3 u = d / length;
            const mat3 along = glm::outerProduct(u, u), across = (mat3(1) - along) / length;
            byVelocity = spring.damping * along;
            byPosition += (spring.damping * glm::dot(u, v) - spring.stiffness * spring.restLength) * across +
                          spring.damping * glm::outerProduct(u, across * v);
        }
        for (const auto& [point, other] : {std::pair(spring.a, spring.b), std::pair(spring.b, spring.a)}) {
            if (system.points[point].isFixed) continue;
            const std::size_t row = 3 * (n + point);
            const double mass = system.points[point].mass;
            addBlock(entries, row, 3 * point, byPosition / -mass);
            addBlock(entries, row, 3 * other, byPosition / mass);
            if (spring.damping == 0) continue;
            addBlock(entries, row, 3 * (n + point), byVelocity / -mass);
            addBlock(entries, row, 3 * (n + other), byVelocity / mass);
        }
    }
}

}  // namespace

std::vector<double> springState(std::span<const vec3> positions, std::span<const vec3> velocities) {
    if (positions.size() != velocities.size()) {
        throw Error(springsSubject,
                    "there must be a velocity for each of the " + std::to_string(positions.size()) + " points",
                    std::to_string(velocities.size()));
    }
    std::vector<double> state;
    state.reserve(6 * positions.size());
    for (const auto& vectors : {positions, velocities}) {
        for (const vec3& v : vectors) state.insert(state.end(), {v.x, v.y, v.z});
    }
    return state;
}

vec3 positionOf(std::span<const double> state, std::size_t point) {
    return {state[3 * point], state[3 * point + 1], state[3 * point + 2]};
}
vec3 velocityOf(std::span<const double> state, std::size_t point) {
    return positionOf(state.subspan(state.size() / 2), point);
}

void requireSprings(const SpringSystem& system) {
    if (system.points.empty()) throw Error(springsSubject, "there must be a point", "none");
    for (const PointMass& point : system.points) requirePositive(springsSubject, "each mass", point.mass);
    for (const Spring& spring : system.springs) {
        if (spring.a >= system.points.size() || spring.b >= system.points.size() || spring.a == spring.b) {
            throw Error(springsSubject,
                        "each spring must join two of the " + std::to_string(system.points.size()) + " points",
                        std::to_string(spring.a) + " and " + std::to_string(spring.b));
        }
        requireNotNegative("each stiffness", spring.stiffness);
        requireNotNegative("each rest length", spring.restLength);
        requireNotNegative("each damping", spring.damping);
    }
    requireFinite(springsSubject, "gravity", system.gravity);
}

void requireSprings(const SpringSystem& system, std::span<const double> state) {
    requireSprings(system);
    requireSize(system, state);
    for (const double number : state) requireFinite(springsSubject, "each number of the state", number);
    for (std::size_t p = 0; p < system.points.size(); ++p) {
        if (system.points[p].isFixed && velocityOf(state, p) != vec3(0)) {
            throw Error(springsSubject, "a fixed point must have the velocity 0", vectorText(velocityOf(state, p)));
        }
    }
    for (const Spring& spring : system.springs) {
        if ((spring.restLength > 0 || spring.damping > 0) &&
            positionOf(state, spring.a) == positionOf(state, spring.b)) {
            throw Error(springsSubject, "the ends of a spring with a rest length or damping must be in two places",
                        vectorText(positionOf(state, spring.a)));
        }
    }
}

OdeProblem springProblem(const SpringSystem& system) {
    requireSprings(system);
    bool isDamped = false;
    for (const Spring& spring : system.springs) isDamped = isDamped || spring.damping > 0;
    return {.dimension = 6 * system.points.size(),
            .slope = [system](double, std::span<const double> y, std::span<double> dydt) { slopeOf(system, y, dydt); },
            .sparseJacobian = [system](double, std::span<const double> y,
                                       std::vector<MatrixEntry>& entries) { jacobianOf(system, y, entries); },
            .isMechanical = true,
            .isVelocityFree = !isDamped,
            .isAutonomous = true};
}

double springEnergy(const SpringSystem& system, std::span<const double> state) {
    requireSize(system, state);
    double energy = 0;
    for (std::size_t p = 0; p < system.points.size(); ++p) {
        if (system.points[p].isFixed) continue;
        const vec3 v = velocityOf(state, p);
        energy += system.points[p].mass * (glm::dot(v, v) / 2 - glm::dot(system.gravity, positionOf(state, p)));
    }
    for (const Spring& spring : system.springs) {
        const double stretch =
            glm::length(positionOf(state, spring.b) - positionOf(state, spring.a)) - spring.restLength;
        energy += spring.stiffness / 2 * stretch * stretch;
    }
    return std::isnan(energy) ? std::numeric_limits<double>::infinity() : energy;
}

vec3 linearMomentum(const SpringSystem& system, std::span<const double> state) {
    requireSize(system, state);
    vec3 sum(0);
    for (std::size_t p = 0; p < system.points.size(); ++p) {
        if (!system.points[p].isFixed) sum += system.points[p].mass * velocityOf(state, p);
    }
    return sum;
}

vec3 angularMomentum(const SpringSystem& system, std::span<const double> state) {
    requireSize(system, state);
    vec3 sum(0);
    for (std::size_t p = 0; p < system.points.size(); ++p) {
        if (!system.points[p].isFixed) {
            sum += glm::cross(positionOf(state, p), system.points[p].mass * velocityOf(state, p));
        }
    }
    return sum;
}

}  // namespace mv

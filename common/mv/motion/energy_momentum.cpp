#include "mv/motion/energy_momentum.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <utility>

#include "mv/error.h"
#include "mv/math/require.h"

namespace mv {
namespace {

// A spring over one step, h long, in which its end b moves by `move` more than its end a.
struct SpringStep {
    SpringStep(const Spring& theSpring, const vec3& before, const vec3& move, double length)
        : spring(theSpring), mean(before + move / 2.0), after(before + move), h(length) {
        const double lengthBefore = glm::length(before);
        lengthAfter = glm::length(after);
        meanLength = (lengthBefore + lengthAfter) / 2;
        // The difference of the lengths by that of their squares, which does not cancel.
        const double sum = lengthBefore + lengthAfter;
        change = sum > 0 ? glm::dot(2.0 * mean, move) / sum : 0;
        turning = spring.damping * change / h - spring.stiffness * spring.restLength;
    }
    bool hasDirection() const { return spring.restLength > 0 || spring.damping > 0; }

    // On a. Not finite where a force has no direction.
    vec3 force() const {
        return hasDirection() ? spring.stiffness * mean + turning / meanLength * mean : spring.stiffness * mean;
    }
    // The derivative of the force by `move`.
    mat3 forceByMove() const {
        mat3 result = spring.stiffness / 2 * mat3(1);
        if (!hasDirection()) return result;
        result += turning / (2 * meanLength) * mat3(1);
        if (lengthAfter == 0) return result;
        const double factor = spring.damping / (h * meanLength) - turning / (2 * meanLength * meanLength);
        return result + glm::outerProduct(mean, factor / lengthAfter * after);
    }
    double dissipated() const { return spring.damping * change * change / h; }

    const Spring& spring;
    vec3 mean, after;
    double h, lengthAfter, meanLength, change, turning;
};

vec3 between(std::span<const double> positions, const Spring& spring) {
    return positionOf(positions, spring.b) - positionOf(positions, spring.a);
}

// A step's accelerations, as a function of how far each point moves.
struct StepForces {
    const SpringSystem& system;
    std::span<const double> state;
    double h;

    void operator()(double, std::span<const double> moves, std::span<double> accelerations) const {
        std::ranges::fill(accelerations, 0);
        const auto add = [&](std::size_t point, const vec3& acceleration) {
            if (system.points[point].isFixed) return;
            for (int i = 0; i < 3; ++i) accelerations[3 * point + static_cast<std::size_t>(i)] += acceleration[i];
        };
        for (std::size_t p = 0; p < system.points.size(); ++p) add(p, system.gravity);
        for (const Spring& spring : system.springs) {
            const vec3 force = SpringStep(spring, between(state, spring), between(moves, spring), h).force();
            add(spring.a, force / system.points[spring.a].mass);
            add(spring.b, -force / system.points[spring.b].mass);
        }
    }

    void jacobian(std::span<const double> moves, std::vector<MatrixEntry>& entries) const {
        for (const Spring& spring : system.springs) {
            const mat3 block = SpringStep(spring, between(state, spring), between(moves, spring), h).forceByMove();
            for (const auto& [point, other] : {std::pair(spring.a, spring.b), std::pair(spring.b, spring.a)}) {
                if (system.points[point].isFixed) continue;
                const int row = 3 * static_cast<int>(point), there = 3 * static_cast<int>(other);
                for (int i = 0; i < 3; ++i) {
                    for (int j = 0; j < 3; ++j) {
                        const double value = block[j][i] / system.points[point].mass;
                        entries.push_back({row + i, row + j, -value});
                        entries.push_back({row + i, there + j, value});
                    }
                }
            }
        }
    }
};

}  // namespace

EnergyMomentumStepper::EnergyMomentumStepper(SpringSystem system, double start, double step, std::vector<double> state,
                                             const FixedOptions& options)
    : system_(std::move(system)),
      start_(start),
      step_(step),
      state_(std::move(state)),
      mostHalvings_(options.mostHalvings),
      stage_(options.newtonTolerance) {
    requireSprings(system_, state_);
    requireSteps("energy-momentum", start, step, options);
}

std::string EnergyMomentumStepper::whole(double h, std::vector<double>& state, double& dissipated) {
    const std::size_t n = 3 * system_.points.size();
    const StepForces forces{system_, state, h};
    // The measure of a move: the longest spring, and a tenth of it, since what is left in a move of h is 2/h
    // times as much in a velocity.
    double longest = 0;
    for (const Spring& spring : system_.springs) {
        longest = std::max({longest, glm::length(between(state, spring)), spring.restLength});
    }
    const OdeProblem problem{
        .dimension = n,
        .slope = forces,
        .sparseJacobian = [&](double, std::span<const double> moves,
                              std::vector<MatrixEntry>& entries) { forces.jacobian(moves, entries); },
        .scale = std::vector<double>(n, longest > 0 ? longest / 10 : 1)};
    // move = h v + h^2/2 a(move), since the mean velocity is v + h/2 a.
    std::vector<double> free(n), moves(n);
    for (std::size_t i = 0; i < n; ++i) free[i] = h * state[n + i];
    if (std::string why = stage_.solve(problem, 0, h * h / 2, free, moves, counts_); !why.empty()) return why;
    for (std::size_t i = 0; i < n; ++i) {
        if (system_.points[i / 3].isFixed) moves[i] = 0;  // and not what elimination rounds it to
    }

    for (const Spring& spring : system_.springs) {
        dissipated += SpringStep(spring, between(state, spring), between(moves, spring), h).dissipated();
    }
    for (std::size_t i = 0; i < n; ++i) {
        state[i] += moves[i];
        state[n + i] = 2 * moves[i] / h - state[n + i];
    }
    return allFinite(state) ? "" : "the state is not finite";
}

std::string EnergyMomentumStepper::halved(double h, std::vector<double>& state, double& dissipated, int depth) {
    std::vector<double> after = state;
    double taken = dissipated;
    std::string why = whole(h, after, taken);
    if (why.empty()) {
        ++counts_.accepted;
        state = std::move(after);
        dissipated = taken;
        return "";
    }
    ++counts_.rejected;
    if (depth == mostHalvings_) return why;
    for (int half = 0; half < 2; ++half) {
        if (why = halved(h / 2, state, dissipated, depth + 1); !why.empty()) return why;
    }
    return "";
}

bool EnergyMomentumStepper::step() {
    if (!failure_.empty()) return false;
    std::vector<double> state = state_;
    double dissipated = dissipated_;
    const std::int64_t accepted = counts_.accepted;
    if (const std::string why = halved(step_, state, dissipated, 0); !why.empty()) {
        failure_ = "gave up at t = " + numberText(time()) + ": no step " + std::to_string(index_ + 1) +
                   " by energy-momentum, because " + why;
        counts_.accepted = accepted;
        return false;
    }
    state_ = std::move(state);
    dissipated_ = dissipated;
    ++index_;
    return true;
}

}  // namespace mv

#include "mv/motion/spring_stepper.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace mv {
namespace {

using Values = std::vector<double>;

// The vector of a spring, from its end a to its end b.
struct Motion {
    vec3 along, velocity;  // unit vector
    double length, rate;
};
Motion motionOf(const Spring& spring, std::span<const double> y) {
    const vec3 d = positionOf(y, spring.b) - positionOf(y, spring.a);
    const double length = glm::length(d);
    const vec3 along = d / length, velocity = velocityOf(y, spring.b) - velocityOf(y, spring.a);
    return {along, velocity, length, glm::dot(along, velocity)};
}

// y of the plain problem, of that with d: s stands behind the positions, d at the end.
Values without(std::span<const double> y) {
    const std::size_t n = y.size() / 2 - 1;
    Values result(y.begin(), y.begin() + static_cast<std::ptrdiff_t>(n));
    result.insert(result.end(), y.begin() + static_cast<std::ptrdiff_t>(n) + 1, y.end() - 1);
    return result;
}
Values with(const Values& y) {
    const auto half = y.begin() + static_cast<std::ptrdiff_t>(y.size() / 2);
    Values result(y.begin(), half);
    result.push_back(0);
    result.insert(result.end(), half, y.end());
    result.push_back(0);
    return result;
}

void addRow(const Spring& spring, std::span<const double> y, std::vector<MatrixEntry>& entries) {
    const auto [along, velocity, length, rate] = motionOf(spring, y);
    const int last = static_cast<int>(y.size()) - 1, half = static_cast<int>(y.size() / 2);
    const vec3 byVelocity = 2 * spring.damping * rate * along;
    const vec3 byPosition = 2 * spring.damping * rate / length * (velocity - rate * along);
    for (int i = 0; i < 3; ++i) {
        const int a = 3 * static_cast<int>(spring.a) + i, b = 3 * static_cast<int>(spring.b) + i;
        entries.push_back({last, a, -byPosition[i]});
        entries.push_back({last, b, byPosition[i]});
        entries.push_back({last, half + a, -byVelocity[i]});
        entries.push_back({last, half + b, byVelocity[i]});
    }
}

bool isDamped(const SpringSystem& system) {
    return std::ranges::any_of(system.springs, [](const Spring& spring) { return spring.damping > 0; });
}

FixedStepper makeStepper(const SpringSystem& system, OdeMethod method, double start, double step, const Values& state) {
    requireSprings(system, state);
    if (!isDamped(system)) return {springProblem(system), method, start, step, state};
    OdeProblem problem = dissipatingProblem(system);
    // Energies are other numbers than places: without sizes a large one would make those of all others coarse.
    double length = 0, stiffness = 0;
    for (const double number : state) length = std::max(length, std::abs(number));
    for (const Spring& spring : system.springs) {
        length = std::max(length, spring.restLength);
        stiffness = std::max(stiffness, spring.stiffness);
    }
    const double size = length > 0 ? length / 1000 : 1;
    problem.scale.assign(problem.dimension, size);
    problem.scale[problem.dimension / 2 - 1] = problem.scale.back() = std::max(size, stiffness * length * size);
    return {std::move(problem), method, start, step, with(state)};
}

}  // namespace

OdeProblem dissipatingProblem(const SpringSystem& system) {
    OdeProblem problem = springProblem(system);
    const std::size_t n = problem.dimension / 2;
    problem.dimension += 2;
    problem.isVelocityFree = false;
    problem.slope = [system, plain = problem.slope, n](double t, std::span<const double> y, std::span<double> dydt) {
        const Values state = without(y);
        Values slope(state.size());
        plain(t, state, slope);
        std::copy_n(slope.begin(), n, dydt.begin());
        std::copy_n(slope.begin() + static_cast<std::ptrdiff_t>(n), n,
                    dydt.begin() + static_cast<std::ptrdiff_t>(n) + 1);
        dydt[n] = y.back();
        double power = 0;
        for (const Spring& spring : system.springs) {
            if (spring.damping == 0) continue;
            const double rate = motionOf(spring, y).rate;
            power += spring.damping * rate * rate;
        }
        dydt.back() = power;
    };
    problem.sparseJacobian = [system, plain = problem.sparseJacobian, n](double t, std::span<const double> y,
                                                                         std::vector<MatrixEntry>& entries) {
        plain(t, without(y), entries);
        const int half = static_cast<int>(n);
        for (MatrixEntry& entry : entries) {
            if (entry.row >= half) ++entry.row;
            if (entry.column >= half) ++entry.column;
        }
        entries.push_back({half, 2 * half + 1, 1});
        for (const Spring& spring : system.springs) {
            if (spring.damping > 0) addRow(spring, y, entries);
        }
    };
    return problem;
}

SpringStepper::SpringStepper(const SpringSystem& system, OdeMethod method, double start, double step, Values state)
    : stepper_(makeStepper(system, method, start, step, state)), state_(std::move(state)) {}

SpringStepper::SpringStepper(const SpringSystem& system, double start, double step, Values state)
    : stepper_(EnergyMomentumStepper(system, start, step, state)), state_(std::move(state)) {}

bool SpringStepper::step() {
    if (!std::visit([](auto& stepper) { return stepper.step(); }, stepper_)) return false;
    if (const auto* conserving = std::get_if<EnergyMomentumStepper>(&stepper_)) {
        std::ranges::copy(conserving->state(), state_.begin());
        dissipated_ = conserving->dissipated();
        return true;
    }
    const std::span<const double> y = std::get<FixedStepper>(stepper_).state();
    const bool isPlain = y.size() == state_.size();
    state_ = isPlain ? Values(y.begin(), y.end()) : without(y);
    if (!isPlain) dissipated_ = y.back();
    return true;
}

std::int64_t SpringStepper::index() const {
    return std::visit([](const auto& stepper) { return stepper.index(); }, stepper_);
}
double SpringStepper::time() const {
    return std::visit([](const auto& stepper) { return stepper.time(); }, stepper_);
}
const OdeCounts& SpringStepper::counts() const {
    return std::visit([](const auto& stepper) -> const OdeCounts& { return stepper.counts(); }, stepper_);
}
const std::string& SpringStepper::failure() const {
    return std::visit([](const auto& stepper) -> const std::string& { return stepper.failure(); }, stepper_);
}

}  // namespace mv

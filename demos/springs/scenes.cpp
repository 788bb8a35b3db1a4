#include "scenes.h"

#include <cmath>
#include <complex>
#include <glm/geometric.hpp>

#include "mv/math/require.h"

namespace mv {
namespace {

constexpr double pointMass = 0.1;                // kg, of chain, net and cloth
const vec3 corner(0.6, -0.4, 0);                 // where the mass that the hand holds begins
const vec3 across(1.2, 0, 0), down(0, -1.2, 0);  // sides of the net
const vec3 slant(0, -0.72, 0.96);                // of the cloth: as long

// The last point of a grid of masses is the corner; the first row's ends are fixed.
void addGrid(SpringSetup& setup, const SpringSettings& settings, const vec3& side, bool hasDiagonals) {
    const auto n = static_cast<std::size_t>(settings.masses);
    const auto index = [n](std::size_t row, std::size_t column) { return row * n + column; };
    const auto join = [&](std::size_t a, std::size_t b) { setup.system.springs.push_back({.a = a, .b = b}); };
    for (std::size_t row = 0; row < n; ++row) {
        for (std::size_t column = 0; column < n; ++column) {
            const double last = double(n - 1);
            setup.slack.push_back(corner + (double(row) / last - 1) * side + (double(column) / last - 1) * across);
            const bool isCorner = row == 0 && (column == 0 || column == n - 1);
            setup.system.points.push_back({.mass = pointMass, .isFixed = isCorner});
            if (column > 0) join(index(row, column - 1), index(row, column));
            if (row > 0) join(index(row - 1, column), index(row, column));
            if (hasDiagonals && row > 0 && column > 0) {
                join(index(row - 1, column - 1), index(row, column));
                join(index(row - 1, column), index(row, column - 1));
            }
        }
    }
}

void addChain(SpringSetup& setup, const SpringSettings& settings) {
    const auto n = static_cast<std::size_t>(settings.masses);
    for (std::size_t i = 0; i < n; ++i) {
        setup.slack.push_back(corner + (double(i) / double(n - 1) - 1) * (across + down));
        setup.system.points.push_back({.mass = pointMass, .isFixed = i == 0});
        if (i > 0) setup.system.springs.push_back({.a = i - 1, .b = i});
    }
}

}  // namespace

bool isHung(SpringScene scene) { return scene != SpringScene::threeMasses && scene != SpringScene::oneSpring; }

SpringSetup makeSprings(const SpringSettings& settings) {
    requireRange("makeSprings", "masses", settings.masses, 2, 1000);
    SpringSetup setup;
    SpringSystem& system = setup.system;
    std::vector<vec3> places, velocities;
    if (settings.scene == SpringScene::chain) addChain(setup, settings);
    if (settings.scene == SpringScene::net) addGrid(setup, settings, down, false);
    if (settings.scene == SpringScene::cloth) addGrid(setup, settings, slant, true);
    if (settings.scene == SpringScene::threeMasses) {
        system.points = {{.mass = 1}, {.mass = 2}, {.mass = 3}};
        for (std::size_t i = 0; i < 3; ++i) system.springs.push_back({.a = i, .b = (i + 1) % 3});
        setup.slack = {{0, 0, 0}, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}};
        places = {{0, 0, 0}, {1.1, 0, 0}, {0.4, 0.95, 0.1}};
        velocities = {{0, 1, 0}, {0.5, 0, 1}, {-1, 0, 0.2}};
    }
    if (settings.scene == SpringScene::oneSpring) {
        system.points = {{.isFixed = true}, {.mass = 1}};
        system.springs = {{.a = 0, .b = 1}};
        setup.slack = {{-10, -1.1, 0}, {0, -1.1, 0}};
        places = {setup.slack[0], {pulled, -1.1, 0}};
    }

    for (Spring& spring : system.springs) {
        spring.stiffness = settings.stiffness;
        spring.damping = settings.damping;
        spring.restLength = glm::distance(setup.slack[spring.a], setup.slack[spring.b]);
    }
    if (isHung(settings.scene)) {
        system.gravity = vec3(0, -settings.gravity, 0);
        const std::size_t held = setup.slack.size() - 1;
        setup.hasHand = true;
        setup.slack.emplace_back(settings.hand, setup.slack[held].z);
        system.points.push_back({.isFixed = true});
        system.springs.push_back({.a = held, .b = held + 1, .stiffness = settings.grip});
    }
    if (places.empty()) places = setup.slack;
    velocities.resize(places.size(), vec3(0));
    setup.start = springState(places, velocities);
    return setup;
}

vec2 swung(const SpringSettings& settings, const vec2& placeAndSpeed, double h) {
    // q'' = -k q - 2 g q' of a mass of 1; w is imaginary beyond critical damping
    const double k = settings.stiffness, g = settings.damping / 2;
    const std::complex<double> w = std::sqrt(std::complex<double>(k - g * g));
    const double c = std::cos(w * h).real(), s = std::abs(w) > 0 ? (std::sin(w * h) / w).real() : h;
    const double q = placeAndSpeed.x, v = placeAndSpeed.y;
    return std::exp(-g * h) * vec2(q * c + (v + g * q) * s, v * c - (k * q + g * v) * s);
}

double turnBetween(const SpringSettings& settings, std::span<const double> before, std::span<const double> after) {
    const auto phase = [&](std::span<const double> state) {
        return std::atan2(-velocityOf(state, 1).x / std::sqrt(settings.stiffness), positionOf(state, 1).x);
    };
    const double turn = phase(after) - phase(before);
    return turn < 0 ? turn + 2 * pi : turn;
}

}  // namespace mv

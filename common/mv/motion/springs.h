// Masses on springs: forces, energy, momenta, and the problem y' = f(t, y) that they make.
//
// The state y of n points is one list: x, y, z of each point's position, then in the same order their velocities.
// Units are any that agree: mass, length, time; stiffness is force by length, damping force by speed, energy mass by
// speed squared.
#pragma once
#include <cstddef>
#include <span>
#include <vector>

#include "mv/math/types.h"
#include "mv/motion/ode.h"

namespace mv {

struct PointMass {
    double mass = 1;       // above 0
    bool isFixed = false;  // stays where it is; its velocity is 0
};

// Pulls its two ends together by stiffness * (length - restLength) + damping * (rate of the length), all three 0 or
// more. With a rest length above 0 it is not linear: it turns with its ends.
struct Spring {
    std::size_t a = 0, b = 0;  // indices of points
    double stiffness = 1, restLength = 0, damping = 0;
};

struct SpringSystem {
    std::vector<PointMass> points;
    std::vector<Spring> springs;
    vec3 gravity{0, 0, 0};  // an acceleration of all that is not fixed
};

// The state of points at these positions and velocities. Refused: lists of different lengths.
std::vector<double> springState(std::span<const vec3> positions, std::span<const vec3> velocities);
vec3 positionOf(std::span<const double> state, std::size_t point);
vec3 velocityOf(std::span<const double> state, std::size_t point);

// Throws Error("springs", ...) unless there is a point, masses are positive, stiffness, rest length and damping 0 or
// more, all finite, and each spring joins two different points. With a state: unless it is finite, of these points,
// fixed ones at rest, and no spring with a rest length has its two ends in one place.
void requireSprings(const SpringSystem& system);
void requireSprings(const SpringSystem& system, std::span<const double> state);

// The system as y' = f(t, y), mechanical, autonomous, with its sparse Jacobian. The problem keeps a copy of the system.
// f is not finite where a spring with a rest length or damping has its two ends in one place: such a force has no
// direction. Refused: what requireSprings refuses.
OdeProblem springProblem(const SpringSystem& system);

// Kinetic energy, that of the springs, and of height against gravity (0 at the origin). Infinity where it overflows.
// Refused, here and below: a state of another size than the system's.
double springEnergy(const SpringSystem& system, std::span<const double> state);
// Sums of m v and of p x m v about the origin, of the points that are not fixed.
vec3 linearMomentum(const SpringSystem& system, std::span<const double> state);
vec3 angularMomentum(const SpringSystem& system, std::span<const double> state);

}  // namespace mv

// Masses on springs that the lesson plays with, in metres, kilograms and newtons. No GL.
#pragma once
#include <span>
#include <vector>

#include "mv/motion/springs.h"

namespace mv {

enum class SpringScene {
    chain,        // hangs from its first mass
    net,          // upright, from its two upper corners
    cloth,        // slanting, from its two upper corners; its squares have diagonals
    threeMasses,  // thrown, with rest lengths and without gravity: row X33 of docs/stability.md
    oneSpring,    // 1 kg on 10 m of spring along x: by a linear law, as long as it stays on its side of the wall
};
inline constexpr double pulled = 0.1;  // m, by which the one spring is stretched at first

// Chain, net and cloth: those with gravity and a hand.
bool isHung(SpringScene scene);

struct SpringSettings {
    SpringScene scene = SpringScene::net;
    int masses = 5;               // of the chain, or along a side of net and cloth: 2 or more
    double stiffness = 1000;      // N/m, of each spring but the hand's
    double damping = 0;           // N s/m, of the same
    double gravity = 9.81;        // m/s^2 downwards; the hung ones
    double grip = 0;              // N/m, of the spring to the hand; 0: it does not pull
    vec2 hand = vec2(0.6, -0.4);  // where the mass that it holds begins
    bool operator==(const SpringSettings&) const = default;
};

struct SpringSetup {
    SpringSystem system;
    std::vector<vec3> slack;    // places at which no spring but the hand's pulls
    std::vector<double> start;  // the state at time 0
    bool hasHand = false;       // the last point, fixed; its spring is the last one
};

// Refused: fewer than two masses. Other settings are refused by who integrates them (mv/motion/springs.h).
SpringSetup makeSprings(const SpringSettings& settings);

// The exact motion of the one spring: its place (from where it is slack) and speed a time h later.
vec2 swung(const SpringSettings& settings, const vec2& placeAndSpeed, double h);
// From a state of it to another, the turn of place against speed/sqrt(k/m), from 0 to below 2 pi.
double turnBetween(const SpringSettings& settings, std::span<const double> before, std::span<const double> after);

}  // namespace mv

// Known problems on which integrators are measured: stiff ones, and two that are not.
#pragma once
#include <string>
#include <vector>

#include "mv/motion/ode.h"

namespace mv {

// A problem with where it starts, and what is known of its end.
struct OdeCase {
    std::string name;
    OdeProblem problem;
    double start, end;
    std::vector<double> initial;
    std::vector<double> reference;  // y at the end; empty where none is known
    double absolute;                // a tolerance at which the smallest component of the reference still has its digits
};

// q'' = -w^2 q - 2 ratio w q' from q = 1 at rest, for a time of 10/w; y = (q, v). The reference is the formula.
// Refused: w <= 0, a damping ratio outside [0, 1), NaN, infinity.
OdeCase springCase(double w, double ratio);

// 100 masses of 1 on a line, joined by springs whose stiffnesses are 1 and 1e6 in turn, the outermost fixed to walls;
// the stiff ones are damped by 1000, 0.7 of what is critical for their pair. The chain starts at rest, bent like sin(pi
// x), each stiff pair as one. y = (q, v), 200 numbers, until t = 10. No reference.
OdeCase chainCase();

// The classics, as in Hairer and Wanner II, IV.1 and IV.10, and the "Test Set for Initial Value Problem Solvers"
// (Mazzia and Magherini, 2008), whose references these are.
OdeCase robertsonCase();            // a chemical reaction with rates from 0.04 to 3e7, until t = 1e11
OdeCase vanDerPolCase(double eps);  // y'' = ((1 - y^2) y' - y)/eps until t = 2. Reference for 1e-6. Refused: eps <= 0
OdeCase hiresCase();                // "high irradiance response" of a plant, 8 substances, until t = 321.8122
OdeCase oregonatorCase();           // the Belousov-Zhabotinskii reaction, until t = 360
OdeCase pleiadesCase();             // seven stars in a plane, not stiff, until t = 3; no analytic Jacobian

// All of them: springs of w = 1, undamped and of ratio 0.1, the chain, and the classics with van der Pol at 1e-6.
std::vector<OdeCase> odeCases();

}  // namespace mv

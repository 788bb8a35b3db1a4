// The integrators by name, and the coefficients that define them.
#pragma once
#include <array>
#include <complex>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace mv {

// A step is `h` long. Symplectic Euler and velocity Verlet integrate mechanical problems only.
enum class OdeMethod {
    explicitEuler,     // y + h f(y)
    symplecticEuler,   // v + h a(q, v), then q + h v with the new v
    velocityVerlet,    // q + h v + h^2/2 a, then v + h/2 (a + a'), where a' reads v + h a
    explicitMidpoint,  // Runge's, of order 2
    rungeKutta4,       // the classical one
    dormandPrince,     // 5(4), explicit, seven stages of which the last is the next step's first
    implicitEuler,     // L-stable
    implicitMidpoint,  // A-stable, keeps quadratic invariants
    bdf2,              // L-stable, two steps; its first one, and one after halved steps, is implicit Euler's
    rodas,             // Rosenbrock 4(3), L-stable, stiffly accurate: six linear systems with one matrix, no Newton
    radau,             // Radau IIA of order 5, L-stable, stiffly accurate: three stages by a simplified Newton's method
};
inline constexpr std::array<OdeMethod, 11> odeMethods{
    OdeMethod::explicitEuler, OdeMethod::symplecticEuler, OdeMethod::velocityVerlet, OdeMethod::explicitMidpoint,
    OdeMethod::rungeKutta4,   OdeMethod::dormandPrince,   OdeMethod::implicitEuler,  OdeMethod::implicitMidpoint,
    OdeMethod::bdf2,          OdeMethod::rodas,           OdeMethod::radau};

// The field's name: "explicit Euler", "Dormand-Prince 5(4)".
std::string_view methodName(OdeMethod method);
// p, where the error after a given time shrinks like h^p.
int methodOrder(OdeMethod method);
bool needsMechanical(OdeMethod method);
// The method solves linear systems: implicit Euler, implicit midpoint, BDF2, RODAS and Radau.
bool isImplicit(OdeMethod method);
// The method has an error estimate, and so can choose its steps: Dormand-Prince, RODAS and Radau.
bool isAdaptive(OdeMethod method);

// Stages k_i = f(t + c_i h, y + h sum_j a_ij k_j), then y + h sum_i b_i k_i. a is lower triangular and stored row by
// row, `stages` numbers each; with zeros on the diagonal the method is explicit. `error` has b_i less those of the
// embedded method, empty where there is none.
struct ButcherTableau {
    int stages;
    std::vector<double> a, b, c;
    std::vector<double> error = {};
    double element(int row, int column) const {
        return a[static_cast<std::size_t>(row) * b.size() + static_cast<std::size_t>(column)];
    }
};
// Answers for explicit Euler and midpoint, Runge-Kutta 4, Dormand-Prince, implicit Euler and midpoint; Error for the
// others. Source: Hairer, Norsett and Wanner, "Solving Ordinary Differential Equations I", 2nd ed., II.1 and II.5.
const ButcherTableau& tableau(OdeMethod method);

// RODAS, in the form without products by the Jacobian J:
//     (1/(h gamma) I - J) u_i = f(t + alpha_i h, y + sum_j a_ij u_j) + sum_j c_ij/h u_j + h d_i df/dt
// and then y + sum_i m_i u_i. The last u is the error estimate. dense[0] and [1] make the interpolation of order 3.
// Source: Hairer and Wanner, "Solving Ordinary Differential Equations II", 2nd ed., IV.7 and VI.4; their code RODAS.
struct RosenbrockCoefficients {
    static constexpr int stages = 6;
    double gamma;
    std::array<std::array<double, stages>, stages> a, c;
    std::array<double, stages> alpha, d, m;
    std::array<std::array<double, stages>, 2> dense;
};
const RosenbrockCoefficients& rodasCoefficients();

// Radau IIA of three stages: y_i = y + h sum_j a_ij f(t + c_j h, y_j), of which the last is the result. Its inverse A^-1
// has a real eigenvalue and a complex pair, and T^-1 A^-1 T is diagonal but for that pair's block
// (re, -im; im, re): `transform` is T, `inverse` T^-1. `error` has the weights of the stages less y in the error
// estimate, which is (real/h - J)^-1 (f(t, y) + sum_i error_i (y_i - y)/h).
// Source: Hairer and Wanner, "Solving Ordinary Differential Equations II", 2nd ed., IV.5 and IV.8.
struct RadauCoefficients {
    static constexpr std::size_t stages = 3;
    std::array<std::array<double, stages>, stages> a;
    std::array<double, stages> c;
    std::array<std::array<double, stages>, stages> transform, inverse;
    double real;
    std::complex<double> complex;
    std::array<double, stages> error;
};
const RadauCoefficients& radauCoefficients();

}  // namespace mv

// Ordinary differential equations y' = f(t, y), and how an integration of one ended.
//
// Integrators are in mv/motion/ode_fixed.h (equal steps) and ode_adaptive.h (steps by tolerance), spring systems in
// springs.h. An impossible request is refused by an Error. A failure that only shows on the way is an answer in words:
// the run gave up, where and why, with the last finite state. No state that is handed out has a NaN or an infinity.
#pragma once
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mv {

// One element of a sparse matrix, rows and columns counted from 0.
struct MatrixEntry {
    int row, column;
    double value;
};

// A problem y' = f(t, y), in whatever units its maker chose.
struct OdeProblem {
    // How many numbers y has: 1 or more.
    std::size_t dimension = 0;
    // dydt = f(t, y). The function may leave NaN or infinity where f is not defined: the integrators then shorten the
    // step or give up.
    std::function<void(double t, std::span<const double> y, std::span<double> dydt)> slope;
    // df/dy, row by row: element (i, j), the derivative of f_i by y_j, at i * dimension + j; zeros are there before
    // the call. Implicit methods use differencedJacobian where there is neither this nor the next.
    std::function<void(double t, std::span<const double> y, std::span<double> jacobian)> jacobian = {};
    // The same for systems in which few elements are not 0: adds entries to an empty list; those of one place are
    // summed. Elimination then costs about as much as there are entries, instead of dimension^3.
    std::function<void(double t, std::span<const double> y, std::vector<MatrixEntry>& entries)> sparseJacobian = {};
    // y is (q, v), positions and then as many velocities, and f is (v, acceleration). Symplectic Euler and velocity
    // Verlet need it, and read the second half of f alone.
    bool isMechanical = false;
    // The acceleration does not read v: velocity Verlet then evaluates it once a step instead of twice. Trap: where
    // it does read v this is silently of order 1.
    bool isVelocityFree = false;
    // f does not read t: Rosenbrock methods then need no df/dt. Trap: where it does read t this is silently of order 1.
    bool isAutonomous = false;
    // Typical sizes of the components, each above 0, or none: from what size on a change of a component matters.
    std::vector<double> scale = {};
};

// The cost of an integration.
struct OdeCounts {
    std::int64_t evaluations = 0;       // of f, those of differenced Jacobians included
    std::int64_t jacobians = 0;         // evaluated or differenced
    std::int64_t factorizations = 0;    // of the matrices of implicit methods
    std::int64_t newtonIterations = 0;  // linear systems solved by Newton's method
    std::int64_t accepted = 0;          // steps, those that halving made included
    std::int64_t rejected = 0;          // steps tried in vain
    bool operator==(const OdeCounts&) const = default;
};

// How an integration ended.
struct OdeResult {
    // "" where it reached the end, else "gave up at t = 0.25: ..., because ...".
    std::string failure = {};
    // The last time that was reached, and y there: finite.
    double t = 0;
    std::vector<double> y = {};
    OdeCounts counts = {};
    // y at each of AdaptiveOptions::stops that was reached.
    std::vector<std::vector<double>> atStops = {};

    bool reachedEnd() const { return failure.empty(); }
};

// Throws Error(subject, ...) unless the problem can be asked: it has a dimension and a slope, not both Jacobians,
// positive finite scales (none or one for each component), an even dimension where it is mechanical; and y is finite
// and of its dimension.
void requireProblem(std::string_view subject, const OdeProblem& problem, double t, std::span<const double> y);

// True where no number is NaN or infinite.
bool allFinite(std::span<const double> numbers);
// Why a step ends where they are not, in words after "because".
inline constexpr const char* notFinite = "the slope or the state is not finite";

// df/dy at (t, y) by forward differences, row by row as OdeProblem::jacobian; `slope` is f(t, y). Component j is
// moved by sqrt(2^-52) of its size: the largest of |y_j|, |span * slope_j| (how far it moves in a time `span`, 0 or
// more) and its scale. The scale, where the problem names none, is 1e-6 of the largest |y|, and a thousandth of it for
// a component that is 0 but for roundings. About half of the digits are right where this is the component's size. The
// call costs `dimension` evaluations, which it adds to `evaluations`. Not finite where f is not. Trap: a component that
// is always much smaller than the others needs a scale. Source: Dennis and Schnabel, "Numerical Methods for
// Unconstrained Optimization" (1983), 5.4.
std::vector<double> differencedJacobian(const OdeProblem& problem, double t, std::span<const double> y,
                                        std::span<const double> slope, double span, std::int64_t& evaluations);

}  // namespace mv

#include "mv/motion/ode_stability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/motion/eigenvalues.h"

namespace mv {
namespace {

using Complex = std::complex<double>;

constexpr double infinity = std::numeric_limits<double>::infinity();

// R(z) = 1 + z sum_i b_i k_i of a method with lower triangular coefficients:
// k_i (1 - z a_ii) = 1 + z sum_j<i a_ij k_j.
template <typename A, typename B>
Complex ofStages(int stages, A a, B b, Complex z) {
    std::array<Complex, 8> k;
    Complex result = 1;
    for (int i = 0; i < stages; ++i) {
        Complex sum = 1;
        for (int j = 0; j < i; ++j) sum += z * (a(i, j) * k[static_cast<std::size_t>(j)]);
        k[static_cast<std::size_t>(i)] = sum / (1.0 - z * a(i, i));
        result += z * (b(i) * k[static_cast<std::size_t>(i)]);
    }
    return result;
}

// The same in the form of Rosenbrock methods: u_i (1/gamma - z) = z (1 + sum a_ij u_j) + sum c_ij u_j, here divided
// by z where that is large, and its products would overflow.
Complex ofRosenbrock(const RosenbrockCoefficients& coefficients, Complex z) {
    std::array<Complex, RosenbrockCoefficients::stages> u;
    Complex result = 1;
    const bool isLarge = std::abs(z) > 1;
    const Complex of1 = isLarge ? 1.0 / z : 1, ofZ = isLarge ? 1 : z;
    for (std::size_t i = 0; i < u.size(); ++i) {
        Complex stage = 1, sum = 0;
        for (std::size_t j = 0; j < i; ++j) {
            stage += coefficients.a[i][j] * u[j];
            sum += coefficients.c[i][j] * u[j];
        }
        u[i] = (ofZ * stage + of1 * sum) / (of1 / coefficients.gamma - ofZ);
        result += coefficients.m[i] * u[i];
    }
    return result;
}

// Radau's: (1 + 2z/5 + z^2/20) / (1 - 3z/5 + 3z^2/20 - z^3/60), beyond 1 in powers of 1/z.
Complex ofRadau(Complex z) {
    if (std::abs(z) <= 1) return (1.0 + z * (0.4 + z / 20.0)) / (1.0 - z * (0.6 - z * (0.15 - z / 60.0)));
    const Complex w = 1.0 / z;
    return w * (w * w + 0.4 * w + 0.05) / (w * w * w - 0.6 * w * w + 0.15 * w - 1.0 / 60);
}

// The larger root of (1 - 2z/3) x^2 - 4x/3 + 1/3, which is 1 at z = 0.
Complex ofBdf2(Complex z) {
    if (std::abs(z) > 1e100) z *= 1e100 / std::abs(z);  // its limit, 0, to 1e-50
    const Complex root = std::sqrt(1.0 + 2.0 * z), leading = 3.0 - 2.0 * z;
    const Complex a = (2.0 + root) / leading, b = (2.0 - root) / leading;
    return std::abs(a) >= std::abs(b) ? a : b;
}

// The largest absolute eigenvalue of a real matrix of two rows.
double spectralRadius(double a, double b, double c, double d) {
    const double mean = (a + d) / 2, discriminant = (a - d) / 2 * ((a - d) / 2) + b * c;
    if (discriminant >= 0) return std::abs(mean) + std::sqrt(discriminant);
    return std::hypot(mean, std::sqrt(-discriminant));
}

// The growth of q and h v, of q'' = -k q - c q' and a step of 1.
double ofMechanical(OdeMethod method, double k, double c) {
    if (method == OdeMethod::symplecticEuler) return spectralRadius(1 - k, 1 - c, -k, 1 - c);
    const double a = 1 - k / 2, b = 1 - c / 2;  // the new q
    return spectralRadius(a, b, (-k - k * a + c * k) / 2, 1 + (-c - k * b - c * (1 - c)) / 2);
}

double finiteOr(double value, double otherwise) { return std::isfinite(value) ? value : otherwise; }

// Row after row.
std::vector<double> jacobianAt(const OdeProblem& problem, double t, std::span<const double> y) {
    std::vector<double> values(problem.dimension * problem.dimension);
    if (problem.sparseJacobian) {
        std::vector<MatrixEntry> entries;
        problem.sparseJacobian(t, y, entries);
        for (const auto& [row, column, value] : entries)
            values[static_cast<std::size_t>(row) * problem.dimension + static_cast<std::size_t>(column)] += value;
    } else if (problem.jacobian) {
        problem.jacobian(t, y, values);
    } else {
        std::vector<double> slope(problem.dimension);
        problem.slope(t, y, slope);
        std::int64_t evaluations = 0;
        values = differencedJacobian(problem, t, y, slope, 0, evaluations);
    }
    return values;
}

}  // namespace

std::complex<double> stabilityFunction(OdeMethod method, std::complex<double> z) {
    requireFinite("stabilityFunction", "z", vec2(z.real(), z.imag()));
    if (needsMechanical(method)) {
        throw Error("stabilityFunction", "must be asked for a method with one factor; amplification knows the others",
                    methodName(method));
    }
    Complex result;
    if (method == OdeMethod::bdf2) {
        result = ofBdf2(z);
    } else if (method == OdeMethod::radau) {
        result = ofRadau(z);
    } else if (method == OdeMethod::rodas) {
        result = ofRosenbrock(rodasCoefficients(), z);
    } else {
        const ButcherTableau& butcher = tableau(method);
        result = ofStages(
            butcher.stages, [&](int i, int j) { return butcher.element(i, j); },
            [&](int i) { return butcher.b[static_cast<std::size_t>(i)]; }, z);
    }
    return std::isfinite(result.real()) && std::isfinite(result.imag()) ? result : Complex(infinity, 0);
}

double amplification(OdeMethod method, std::complex<double> z) {
    requireFinite("amplification", "z", vec2(z.real(), z.imag()));
    if (needsMechanical(method)) return finiteOr(ofMechanical(method, std::norm(z), -2 * z.real()), infinity);
    return std::abs(stabilityFunction(method, z));
}

double amplification(OdeMethod method, std::complex<double> z, std::complex<double> partner) {
    requireFinite("amplification", "z", vec2(z.real(), z.imag()));
    requireFinite("amplification", "the partner", vec2(partner.real(), partner.imag()));
    if (partner != std::conj(z) && (z.imag() != 0 || partner.imag() != 0)) {
        throw Error("amplification", "the two must be conjugates, or both real");
    }
    if (needsMechanical(method)) {
        return finiteOr(ofMechanical(method, (z * partner).real(), -(z + partner).real()), infinity);
    }
    return std::max(std::abs(stabilityFunction(method, z)), std::abs(stabilityFunction(method, partner)));
}

double stabilityLimit(OdeMethod method) {
    // Growth by less than this in a step is rounding; explicit midpoint grows by 8e-7 at the first step tried.
    constexpr double unseen = 1e-9, first = 0.05, last = 100;
    const auto isStable = [&](double wh) { return amplification(method, {0, wh}) <= 1 + unseen; };
    double stable = 0, unstable = first;
    while (isStable(unstable)) {
        stable = unstable;
        if (unstable > last) return infinity;
        unstable += 1e-3;
    }
    if (stable == 0) return 0;
    while (unstable - stable > 1e-7) {
        const double middle = (stable + unstable) / 2;
        (isStable(middle) ? stable : unstable) = middle;
    }
    return stable;
}

std::vector<std::complex<double>> eigenvalues(const OdeProblem& problem, double t, std::span<const double> y) {
    requireProblem("eigenvalues", problem, t, y);
    std::vector<double> jacobian = jacobianAt(problem, t, y);
    if (!std::ranges::all_of(jacobian, [](double value) { return std::isfinite(value); }))
        throw Error("eigenvalues", "the Jacobian must be finite", "t = " + numberText(t));
    std::vector<Complex> result = eigenvaluesOf(std::move(jacobian), problem.dimension);
    std::ranges::stable_sort(result, [](const Complex& a, const Complex& b) { return std::norm(a) > std::norm(b); });
    return result;
}

}  // namespace mv

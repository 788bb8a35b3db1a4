// The coefficients are the published ones: they fulfil the order conditions, which wrong digits do not.
#include "mv/motion/ode_method.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "math/support.h"

using namespace mv;
using namespace mv::test;

namespace {

using Matrix = std::vector<std::vector<double>>;
using Vector = std::vector<double>;

// A rooted tree: one condition on the coefficients. Source: Hairer, Norsett and Wanner I, II.2.
struct Tree {
    std::vector<Tree> children;
    int order() const {
        int nodes = 1;
        for (const Tree& child : children) nodes += child.order();
        return nodes;
    }
    double density() const {
        double product = order();
        for (const Tree& child : children) product *= child.density();
        return product;
    }
};

std::vector<Tree> trees(int order);

// All multisets of trees that have `nodes` nodes together, none of them later than `last` in the order of (size,
// number).
void addForests(int nodes, int largest, std::size_t lastNumber, std::vector<Tree>& chosen, std::vector<Tree>& found) {
    if (nodes == 0) {
        found.push_back({chosen});
        return;
    }
    for (int size = std::min(nodes, largest); size >= 1; --size) {
        const std::vector<Tree> candidates = trees(size);
        for (std::size_t i = 0; i < candidates.size(); ++i) {
            if (size == largest && i > lastNumber) break;
            chosen.push_back(candidates[i]);
            addForests(nodes - size, size, i, chosen, found);
            chosen.pop_back();
        }
    }
}

std::vector<Tree> trees(int order) {
    std::vector<Tree> found, chosen;
    addForests(order - 1, order - 1, 1000, chosen, found);
    return found;
}

// The term that stage i makes of the tree: `single` stands where a node has one child, `several` where it has more.
Vector weights(const Tree& tree, const Matrix& single, const Matrix& several) {
    const std::size_t n = single.size();
    const Matrix& a = tree.children.size() == 1 ? single : several;
    Vector product(n, 1);
    for (const Tree& child : tree.children) {
        const Vector inner = weights(child, single, several);
        for (std::size_t i = 0; i < n; ++i) {
            double sum = 0;
            for (std::size_t j = 0; j < n; ++j) sum += a[i][j] * inner[j];
            product[i] *= sum;
        }
    }
    return product;
}

// The largest violation of a condition of the order.
double violation(int order, const Vector& b, const Matrix& single, const Matrix& several) {
    double worst = 0;
    for (const Tree& tree : trees(order)) {
        const Vector phi = weights(tree, single, several);
        double sum = 0;
        for (std::size_t i = 0; i < b.size(); ++i) sum += b[i] * phi[i];
        worst = std::max(worst, std::abs(sum - 1 / tree.density()));
    }
    return worst;
}

TEST(OdeMethod, ThereAreAsManyTreesAsConditions) {
    const std::vector<std::size_t> counts{1, 1, 2, 4, 9, 20};
    for (int order = 1; order <= 6; ++order)
        EXPECT_EQ(trees(order).size(), counts[static_cast<std::size_t>(order - 1)]);
}

// Sums of some products of numbers up to 20, each rounded.
constexpr double rounding = 1e-14;
// The smallest violation that a missed condition has here; the largest rounding is 1e12 times smaller.
constexpr double missed = 1e-4;

TEST(OdeMethod, RungeKuttaTableausHaveTheirOrders) {
    for (const OdeMethod method : odeMethods) {
        if (needsMechanical(method) || method == OdeMethod::bdf2 || method == OdeMethod::rodas ||
            method == OdeMethod::radau)
            continue;
        SCOPED_TRACE(methodName(method));
        const ButcherTableau& t = tableau(method);
        const auto n = static_cast<std::size_t>(t.stages);
        Matrix a(n, Vector(n));
        for (std::size_t i = 0; i < n; ++i) {
            double sum = 0;
            for (std::size_t j = 0; j < n; ++j) sum += a[i][j] = t.element(static_cast<int>(i), static_cast<int>(j));
            EXPECT_NEAR(sum, t.c[i], rounding);
        }
        const int order = methodOrder(method);
        for (int p = 1; p <= order; ++p) EXPECT_LT(violation(p, t.b, a, a), rounding) << "order " << p;
        EXPECT_GT(violation(order + 1, t.b, a, a), missed);
        if (t.error.empty()) continue;
        Vector embedded = t.b;
        for (std::size_t i = 0; i < n; ++i) embedded[i] -= t.error[i];
        for (int p = 1; p < order; ++p) EXPECT_LT(violation(p, embedded, a, a), rounding) << "embedded, order " << p;
        EXPECT_GT(violation(order, embedded, a, a), missed);
    }
}

// RODAS in its usual form: with the inverse of Gamma = (gamma_ij), which is diag(1/gamma) - C, a = alpha Gamma^-1 and
// m = b Gamma^-1. Source: Hairer and Wanner II, IV.7.
struct RosenbrockForm {
    Matrix gamma, alpha, beta;
    Vector b, embedded;
};

RosenbrockForm usualForm(const RosenbrockCoefficients& r) {
    constexpr std::size_t n = RosenbrockCoefficients::stages;
    RosenbrockForm form{Matrix(n, Vector(n)), Matrix(n, Vector(n)), Matrix(n, Vector(n)), Vector(n), Vector(n)};
    for (std::size_t column = 0; column < n; ++column) {
        for (std::size_t i = 0; i < n; ++i) {  // (diag(1/gamma) - C) Gamma = I, from the top
            double sum = i == column ? 1 : 0;
            for (std::size_t j = 0; j < i; ++j) sum += r.c[i][j] * form.gamma[j][column];
            form.gamma[i][column] = sum * r.gamma;
        }
    }
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t j = 0; j < n; ++j) {
            for (std::size_t k = 0; k < n; ++k) form.alpha[i][j] += r.a[i][k] * form.gamma[k][j];
            form.beta[i][j] = form.alpha[i][j] + form.gamma[i][j];
            form.b[j] += r.m[i] * form.gamma[i][j];
            if (i + 1 < n) form.embedded[j] += r.m[i] * form.gamma[i][j];  // without the last stage
        }
    }
    return form;
}

TEST(OdeMethod, RodasHasItsOrders) {
    const RosenbrockCoefficients& r = rodasCoefficients();
    const RosenbrockForm form = usualForm(r);
    // The published coefficients have 16 digits, of numbers up to 34.
    constexpr double digits = 1e-13;
    for (int p = 1; p <= 4; ++p) EXPECT_LT(violation(p, form.b, form.beta, form.alpha), digits) << "order " << p;
    EXPECT_GT(violation(5, form.b, form.beta, form.alpha), missed);
    for (int p = 1; p <= 3; ++p) EXPECT_LT(violation(p, form.embedded, form.beta, form.alpha), digits) << p;
    EXPECT_GT(violation(4, form.embedded, form.beta, form.alpha), missed);
    for (std::size_t i = 0; i < r.alpha.size(); ++i) {
        double alpha = 0, d = 0;
        for (std::size_t j = 0; j < r.alpha.size(); ++j) {
            alpha += form.alpha[i][j];
            d += form.gamma[i][j];
        }
        EXPECT_NEAR(alpha, r.alpha[i], digits);
        EXPECT_NEAR(d, r.d[i], digits);
    }
    // Stiffly accurate: the last stage is the result, so that what is infinitely stiff comes out at its equilibrium.
    for (std::size_t j = 0; j < r.m.size(); ++j) EXPECT_NEAR(form.b[j], form.beta.back()[j], digits);
}

TEST(OdeMethod, RadauHasItsOrderAndItsTransformation) {
    const RadauCoefficients& r = radauCoefficients();
    Matrix a(3, Vector(3));
    const Vector b(r.a[2].begin(), r.a[2].end());  // stiffly accurate: the last stage is the result
    for (std::size_t i = 0; i < 3; ++i) {
        a[i].assign(r.a[i].begin(), r.a[i].end());
        EXPECT_NEAR(a[i][0] + a[i][1] + a[i][2], r.c[i], rounding);
    }
    for (int p = 1; p <= 5; ++p) EXPECT_LT(violation(p, b, a, a), rounding) << "order " << p;
    EXPECT_GT(violation(6, b, a, a), missed);

    // A T D = T, where D is diagonal but for the complex pair's block, and T^-1 T = 1. The published T has 20 digits.
    const double re = r.complex.real(), im = r.complex.imag();
    const Matrix d{{r.real, 0, 0}, {0, re, -im}, {0, im, re}};
    const auto at = [](const auto& m, std::size_t i, std::size_t j) { return m[i][j]; };
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            double unit = 0, same = 0;
            for (std::size_t k = 0; k < 3; ++k) {
                unit += at(r.inverse, i, k) * at(r.transform, k, j);
                for (std::size_t l = 0; l < 3; ++l) same += a[i][k] * at(r.transform, k, l) * d[l][j];
            }
            EXPECT_NEAR(unit, i == j ? 1 : 0, rounding);
            EXPECT_NEAR(same, at(r.transform, i, j), rounding);
        }
    }
    // The error estimate is of order 3: of y' = t^k, k = 0 to 2, it is 0, and not of t^3.
    for (int k = 0; k <= 3; ++k) {
        double sum = k == 0 ? 1 : 0;
        for (std::size_t i = 0; i < 3; ++i) sum += r.error[i] * std::pow(r.c[i], k + 1) / (k + 1);
        if (k < 3) {
            EXPECT_NEAR(sum, 0, rounding) << k;
        } else {
            EXPECT_GT(std::abs(sum), missed);
        }
    }
}

TEST(OdeMethod, OnlyRungeKuttaMethodsHaveATableau) {
    EXPECT_EQ(refusal([] { tableau(OdeMethod::bdf2); }), "tableau: must be asked for a Runge-Kutta method, BDF2");
    for (const OdeMethod method : odeMethods) {
        EXPECT_EQ(isAdaptive(method),
                  method == OdeMethod::dormandPrince || method == OdeMethod::rodas || method == OdeMethod::radau);
        EXPECT_FALSE(methodName(method).empty());
    }
}

}  // namespace

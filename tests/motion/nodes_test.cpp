#include "mv/motion/nodes.h"

#include "math/support.h"
#include "mv/motion/gauss.h"

using namespace mv;
using namespace mv::test;

namespace {

std::vector<double> equispaced(int count) {
    std::vector<double> times;
    for (int i = 0; i < count; ++i) times.push_back(i);
    return times;
}

TEST(ChebyshevNodes, AreTheExtremaOfTheirPolynomial) {
    const auto nodes = chebyshevNodes(9, -1, 1);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        EXPECT_NEAR(std::abs(std::cos(8 * std::acos(nodes[i]))), 1, 1e-14);  // 8 times the rounding of acos
        EXPECT_EQ(nodes[i], -nodes[nodes.size() - 1 - i]);
    }
    const auto shifted = chebyshevNodes(30, 0.1, 0.7);
    EXPECT_EQ(shifted.front(), 0.1);
    EXPECT_EQ(shifted.back(), 0.7);
    EXPECT_NO_THROW(chebyshevNodes(1000, -1e308, 1e308));
}

TEST(LebesgueConstant, IsKnownForFewNodes) {
    EXPECT_EQ(lebesgueConstant(equispaced(1)), 1);
    EXPECT_EQ(lebesgueConstant(equispaced(2)), 1);
    EXPECT_NEAR(lebesgueConstant(equispaced(3)), 1.25, 1e-15);  // 3/8 + 3/4 + 1/8
    // 2/pi ln(n) + 1 bounds that of Chebyshev nodes of degree n.
    for (const int count : {13, 50, 200}) {
        EXPECT_LT(lebesgueConstant(chebyshevNodes(count, 3, 4)), 2 / pi * std::log(count - 1) + 1);
    }
}

TEST(SwingWarning, FromThirteenEquispacedKeysOn) {
    EXPECT_FALSE(swingWarning(equispaced(12)));
    EXPECT_EQ(
        swingWarning(equispaced(13)).value_or("none"),
        "one polynomial through 13 keys at these times swings between them: a key that is off by 1 moves it by 70 or "
        "more; a spline does not, nor the times of chebyshevNodes");
    EXPECT_TRUE(swingWarning(equispaced(81)));
    EXPECT_TRUE(swingWarning(std::vector<double>{0, 0.001, 1}));
    EXPECT_FALSE(swingWarning(chebyshevNodes(13, -1, 1)));
    EXPECT_FALSE(swingWarning(chebyshevNodes(100, -1, 1)));
}

TEST(GaussLegendre, IsExactUpToItsDegree) {
    for (const int count : {1, 2, 3, 10, 33, 64}) {
        const GaussRule rule = gaussLegendre(count);
        for (int power = 0; power < 2 * count; ++power) {
            double sum = 0;
            for (std::size_t i = 0; i < rule.nodes.size(); ++i) sum += rule.weights[i] * std::pow(rule.nodes[i], power);
            // Weights add up to 2; 2e-15 of each node is `power` times that of its power, times a weight of 2/(power + 1).
            EXPECT_NEAR(sum, power % 2 == 0 ? 2.0 / (power + 1) : 0, 4e-15) << count << ", " << power;
        }
        // And no further: the error for the next even power is that of its monic Legendre polynomial, squared.
        if (count > 10) continue;
        double sum = 0;
        for (std::size_t i = 0; i < rule.nodes.size(); ++i) sum += rule.weights[i] * std::pow(rule.nodes[i], 2 * count);
        EXPECT_GT(2.0 / (2 * count + 1) - sum, 1e-7) << count;
    }
}

TEST(Nodes, RefusalsSayWhatWouldHaveBeenRight) {
    EXPECT_EQ(refusal([] { chebyshevNodes(1, 0, 1); }), "chebyshevNodes: count must be 2 to 1000, 1");
    EXPECT_EQ(refusal([] { chebyshevNodes(3, 1, 1); }), "chebyshevNodes: low must be below high, 1, 1");
    EXPECT_EQ(refusal([] { chebyshevNodes(3, 0, notANumber); }), "chebyshevNodes: high must be finite, nan");
    EXPECT_EQ(
        refusal([] { chebyshevNodes(100, 1, 1 + 0x1p-50); }).rfind("chebyshevNodes: low and high must be so far", 0),
        0u);
    EXPECT_EQ(refusal([] { lebesgueConstant({}); }), "lebesgueConstant: there must be one time at least, 0");
    EXPECT_EQ(refusal([] {
                  swingWarning(std::vector<double>{1, 1});
              }),
              "lebesgueConstant: times must increase, 1 after 1");
    EXPECT_EQ(refusal([] { gaussLegendre(65); }), "gaussLegendre: count must be 1 to 64, 65");
}

}  // namespace

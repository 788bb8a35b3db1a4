// Gauss's rules, which integrate polynomials exactly from the fewest values.
#pragma once
#include <vector>

namespace mv {

// A rule: the integral over -1..1 is about the sum of weights[i] f(nodes[i]). Nodes increase.
struct GaussRule {
    std::vector<double> nodes, weights;
};

// The Gauss-Legendre rule of `count` nodes: exact for polynomials up to degree 2 count - 1; on smooth functions the error
// falls exponentially with count. Nodes and weights are right within 2e-15. Refused: count outside 1..64.
// Source: the nodes are the zeros of the Legendre polynomial, by Newton's method from Tricomi's estimate.
GaussRule gaussLegendre(int count);

}  // namespace mv

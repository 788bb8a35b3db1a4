// Eigenvalues of a real matrix, without its eigenvectors.
#pragma once
#include <complex>
#include <cstddef>
#include <vector>

namespace mv {

// All eigenvalues of a matrix of n rows and n columns, row after row, each as often as it is one, in no order; complex ones as
// conjugate pairs. Scaled and balanced here, since Eigen balances nothing, and positions and velocities of springs have different
// units; then by Eigen's real Schur form. Costs some 10 n^3 operations; rows and columns of zeros cost nothing. Off by some roundings
// of the largest for each row; one that is defective of order k by the k-th root of that. Error: entries that are not finite, or not
// found within 40 n steps. Source: Golub and Van Loan, "Matrix Computations", 4th ed., 7.4, 7.5.
std::vector<std::complex<double>> eigenvaluesOf(std::vector<double> matrix, std::size_t n);

}  // namespace mv

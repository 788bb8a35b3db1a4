// A matrix in words: to copy it elsewhere, and what an entry of it is made of.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "mv/math/types.h"

namespace mv {

enum class MatrixForm { text, latex, cpp };

// The matrix as on paper, a line a row; as LaTeX's bmatrix; or as a constant of GLM in C++, column by column. Roundings of 0
// are 0, and other entries have six digits.
std::string matrixText(const std::string& name, const mat4& matrix, MatrixForm form);

// Of an entry of xFromZ, where two of these matrices are xFromY and yFromZ and it is their product: its sum of products with
// their values. "" of any other.
std::string entryInWords(const std::vector<std::pair<std::string, mat4>>& matrices, const std::string& name, int row,
                         int column);

}  // namespace mv

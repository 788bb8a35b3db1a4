// A matrix in words: copied elsewhere, and what an entry is made of.
#include "mv/paper/matrix_text.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <sstream>

#include "mv/math/projection.h"
#include "mv/math/transform.h"

using namespace mv;

namespace {

using Matrices = std::vector<std::pair<std::string, mat4>>;

const mat4 clipFromView = perspective(50, 1.5, 0.5, 20);
const mat4 viewFromWorld = lookAt(vec3(1, 2, 5), vec3(0), vec3(0, 1, 0));
const mat4 clipFromWorld = clipFromView * viewFromWorld;

}  // namespace

TEST(MatrixText, is_the_matrix_in_rows_and_in_columns) {
    const mat4 matrix = translate(1, 2, 3);
    EXPECT_EQ(matrixText("m", matrix, MatrixForm::text), "1\t0\t0\t1\n0\t1\t0\t2\n0\t0\t1\t3\n0\t0\t0\t1\n");
    EXPECT_EQ(matrixText("m", matrix, MatrixForm::latex),
              "\\begin{bmatrix}\n1 & 0 & 0 & 1 \\\\\n0 & 1 & 0 & 2 \\\\\n0 & 0 & 1 & 3 \\\\\n0 & 0 & 0 & "
              "1\n\\end{bmatrix}\n");
    EXPECT_EQ(matrixText("worldFromBox", matrix, MatrixForm::cpp),
              "const glm::dmat4 worldFromBox(  // column by column\n    1, 0, 0, 0,\n    0, 1, 0, 0,\n    0, 0, 1, 0,\n"
              "    1, 2, 3, 1);\n");
    mat4 rounded = matrix;
    rounded[0][1] = -1e-17;
    EXPECT_EQ(matrixText("m", rounded, MatrixForm::text), matrixText("m", matrix, MatrixForm::text));
}

TEST(MatrixText, an_entry_is_the_sum_that_it_says) {
    const Matrices all{
        {"clipFromView", clipFromView}, {"viewFromWorld", viewFromWorld}, {"clipFromWorld", clipFromWorld}};
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            const std::string words = entryInWords(all, "clipFromWorld", row, column);
            ASSERT_TRUE(words.starts_with("clipFromView * viewFromWorld:\n")) << words;
            std::istringstream terms(words.substr(words.find('\n') + 1));
            double sum = 0, a = 0, b = 0;
            char times = 0, plus = 0;
            for (int k = 0; k < 4; ++k) {
                ASSERT_TRUE(terms >> a >> times >> b) << words;
                EXPECT_EQ(times, '*');
                sum += a * b;
                if (k < 3) terms >> plus;
            }
            EXPECT_NEAR(sum, clipFromWorld[column][row], 4 * 2e-5 * 5) << "four products of numbers with six digits";
        }
    }
}

TEST(MatrixText, says_nothing_of_what_is_no_product) {
    const Matrices others{{"clipFromView", clipFromView},
                          {"viewFromWorld", viewFromWorld},
                          {"clipFromWorld", 1.1 * clipFromWorld},
                          {"viewFromModel", viewFromWorld},
                          {"odd", clipFromWorld}};
    for (const auto& [name, matrix] : others) EXPECT_EQ(entryInWords(others, name, 0, 0), "") << name;
    EXPECT_EQ(entryInWords(others, "missing", 0, 0), "");
}

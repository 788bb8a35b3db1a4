#include "mv/paper/matrix_text.h"

#include <algorithm>
#include <cctype>
#include <cmath>

#include "mv/paper/report.h"
#include "mv/paper/tables.h"

namespace mv {
namespace {

std::string entry(const mat4& matrix, int row, int column) {
    return formatted("%.6g", withoutRounding(matrix[column][row], largestEntry(matrix)));
}

// "world" and "model" of "worldFromModel"; two "" of another name.
std::pair<std::string, std::string> spacesOf(const std::string& name) {
    const auto from = name.find("From");
    if (from == std::string::npos || from == 0 || from + 4 == name.size()) return {};
    std::string source = name.substr(from + 4);
    source[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(source[0])));
    return {name.substr(0, from), source};
}

// By how much the product may differ from a matrix that is rounded, or multiplied in another order: its roundings.
constexpr double roundings = 1e-6;  // of the largest entry, as a float has

bool isProduct(const mat4& whole, const mat4& a, const mat4& b) {
    const mat4 difference = whole - a * b;
    return largestEntry(difference) <= roundings * std::max(largestEntry(whole), largestEntry(a) * largestEntry(b));
}

}  // namespace

std::string matrixText(const std::string& name, const mat4& matrix, MatrixForm form) {
    const char* const between = form == MatrixForm::latex ? " & " : form == MatrixForm::cpp ? ", " : "\t";
    const char* const after = form == MatrixForm::latex ? " \\\\\n" : form == MatrixForm::cpp ? ",\n" : "\n";
    std::string body;
    for (int line = 0; line < 4; ++line) {
        if (form == MatrixForm::cpp) body += line == 0 ? "" : "    ";
        for (int i = 0; i < 4; ++i) {
            const bool byColumns = form == MatrixForm::cpp;
            body += (i == 0 ? "" : between) + entry(matrix, byColumns ? i : line, byColumns ? line : i);
        }
        if (line < 3 || form == MatrixForm::text) body += after;
    }
    if (form == MatrixForm::latex) return "\\begin{bmatrix}\n" + body + "\n\\end{bmatrix}\n";
    if (form == MatrixForm::cpp) return "const glm::dmat4 " + name + "(  // column by column\n    " + body + ");\n";
    return body;
}

std::string entryInWords(const std::vector<std::pair<std::string, mat4>>& matrices, const std::string& name, int row,
                         int column) {
    const auto whole = std::ranges::find(matrices, name, &std::pair<std::string, mat4>::first);
    const auto [to, from] = spacesOf(name);
    if (whole == matrices.end() || to.empty()) return "";
    for (const auto& [nameOfA, a] : matrices) {
        for (const auto& [nameOfB, b] : matrices) {
            const auto [toOfA, fromOfA] = spacesOf(nameOfA);
            const auto [toOfB, fromOfB] = spacesOf(nameOfB);
            if (toOfA != to || fromOfB != from || fromOfA != toOfB || toOfB.empty()) continue;
            if (!isProduct(whole->second, a, b)) continue;
            std::string text = nameOfA + " * " + nameOfB + ":\n";
            for (int k = 0; k < 4; ++k) text += (k == 0 ? "" : " + ") + entry(a, row, k) + " * " + entry(b, k, column);
            return text;
        }
    }
    return "";
}

}  // namespace mv

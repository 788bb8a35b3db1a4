// Small things that reports, pages and plots say with: numbers as text, and cells of tables.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "mv/formatted.h"

namespace mv {

// Columns of text, each as wide as its widest cell and two spaces apart; the first `left` of them flush left.
inline std::string aligned(const std::vector<std::vector<std::string>>& rows, std::size_t left) {
    std::vector<std::size_t> widths;
    for (const auto& row : rows) {
        widths.resize(std::max(widths.size(), row.size()));
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
    }
    std::string text;
    for (const auto& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string space(widths[i] - row[i].size(), ' ');
            line += i < left ? row[i] + space : space + row[i];
            line += "  ";
        }
        while (line.ends_with(' ')) line.pop_back();
        text += line + "\n";
    }
    return text;
}

// A cell of a Markdown table: a bar would end it.
inline std::string tableCell(const std::string& text) {
    std::string escaped;
    for (const char c : text) escaped += c == '|' ? std::string("\\|") : std::string(1, c);
    return escaped;
}

}  // namespace mv

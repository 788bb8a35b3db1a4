#include "gpu-stages/stage_table.h"

#include <gtest/gtest.h>

#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace mv;

namespace {

// The cells of a table's row, without the spaces round them.
std::vector<std::string> cellsOf(const std::string& line) {
    std::vector<std::string> cells;
    std::istringstream stream(line.substr(1));
    for (std::string cell; std::getline(stream, cell, '|');)
        cells.push_back(cell.size() < 2 ? "" : cell.substr(1, cell.size() - 2));
    return cells;
}

TEST(StageTable, IsThatOfThePage) {
    std::ifstream page(std::string(MVGL_SOURCE_DIR) + "/demos/gpu-stages/gpu-stages.md");
    std::vector<std::vector<std::string>> rows;
    bool isTable = false;
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("| OpenGL |")) isTable = true;
        if (line.empty()) isTable = false;
        if (isTable) rows.push_back(cellsOf(line));
    }
    ASSERT_EQ(rows.size(), stageNames.size() + 2) << "and a heading of two lines";
    for (std::size_t i = 0; i < stageNames.size(); ++i) {
        const StageName& stage = stageNames.at(i);
        const std::vector<std::string>& row = rows[i + 2];
        ASSERT_EQ(row.size(), 4U) << stage.openGl;
        EXPECT_EQ(row[0].substr(0, row[0].find(" (")), stage.openGl) << "before its version in parentheses";
        for (std::size_t k = 0; k < 3; ++k) {
            const std::string name = stage.direct3d.at(k);
            EXPECT_EQ(row[k + 1], name.empty() ? "-" : name) << stage.openGl;
        }
    }
}

TEST(StageTable, CountsInWords) {
    EXPECT_EQ(primitivesText(1, GL_TRIANGLES), "1 triangle");
    EXPECT_EQ(primitivesText(0, GL_LINES), "0 lines");
    EXPECT_EQ(primitivesText(16, GL_POINTS), "16 points");
    const CountedPrimitives lines{true, GL_LINES, {.generated = 2, .written = 2, .positions = std::vector<fvec4>(3)}};
    EXPECT_EQ(lines.found(), 1.5) << "a half one is none of the others' count";
}

// A heading takes 32 pixels of a pane that keeps as many.
TEST(StageTable, LeavesRoomForAHeading) {
    EXPECT_EQ(belowHeading(FrameInfo(1, 200, 64), 0).height, 32);
    EXPECT_EQ(belowHeading(FrameInfo(1, 200, 63), 0).height, 63);
    EXPECT_EQ(belowHeading(FrameInfo(1, 200, 64), 1).y, 0);
}

}  // namespace

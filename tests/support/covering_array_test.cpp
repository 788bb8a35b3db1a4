#include "support/covering_array.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>

using namespace mv::test;

namespace {

int at(const CoveringRow& row, int factor) { return row[static_cast<std::size_t>(factor)]; }

bool has(const CoveringRow& row, const ValuePair& pair) {
    return at(row, pair.factorA) == pair.valueA && at(row, pair.factorB) == pair.valueB;
}

bool everything(const CoveringRow&) { return true; }

std::vector<int> levelsOf(std::initializer_list<std::pair<int, int>> factorsByLevel) {
    std::vector<int> levels;
    for (const auto& [level, factors] : factorsByLevel)
        levels.insert(levels.end(), static_cast<std::size_t>(factors), level);
    return levels;
}

CoveringArray coverAll(const std::vector<int>& levels) {
    return coveringArray(levels, CoveringRow(levels.size(), 0), everything);
}

}  // namespace

TEST(CoveringArray, has_every_pair) {
    for (const auto& levels : {levelsOf({{2, 2}}), levelsOf({{1, 3}}), levelsOf({{3, 1}, {1, 1}}), levelsOf({{2, 9}}),
                               levelsOf({{7, 1}, {5, 1}, {3, 14}, {2, 8}})}) {
        const CoveringArray array = coverAll(levels);
        EXPECT_TRUE(array.refused.empty());
        forEachPair(levels, [&](const ValuePair& pair) {
            EXPECT_TRUE(std::any_of(array.rows.begin(), array.rows.end(),
                                    [&](const CoveringRow& row) { return has(row, pair); }))
                << "factor " << pair.factorA << " = " << pair.valueA << ", " << pair.factorB << " = " << pair.valueB;
        });
        for (const CoveringRow& row : array.rows) {
            ASSERT_EQ(row.size(), levels.size());
            for (std::size_t i = 0; i < row.size(); ++i) {
                EXPECT_GE(row[i], 0);
                EXPECT_LT(row[i], levels[i]);
            }
        }
    }
}

// Never fewer than the two largest numbers of values demand, and about as few as others reach.
TEST(CoveringArray, has_few_rows) {
    struct Case {
        std::vector<int> levels;
        std::size_t least, most;
    };
    // For two values the least is known (Kleitman and Spencer, "Families of k-independent sets", 1973): N rows serve
    // C(N - 1, N / 2) factors. For 3 to the 4th it is an orthogonal array. The mixed ones are those of Cohen, Gibbons,
    // Mugridge and Colbourn, "Constructing test suites for interaction testing" (2003), with the least by simulated
    // annealing. A greedy method is allowed half as many again, and 3 to the 4th 2 more.
    for (const Case& c : {Case{levelsOf({{2, 4}}), 5, 7}, Case{levelsOf({{2, 10}}), 6, 9},
                          Case{levelsOf({{3, 4}}), 9, 13}, Case{levelsOf({{5, 1}, {3, 8}, {2, 2}}), 15, 22},
                          Case{levelsOf({{7, 1}, {6, 1}, {5, 1}, {4, 6}, {3, 8}, {2, 3}}), 42, 63}}) {
        const std::size_t rows = coverAll(c.levels).rows.size();
        EXPECT_GE(rows, c.least);
        EXPECT_LE(rows, c.most);
        std::printf("%zu factors: %zu rows, %zu known\n", c.levels.size(), rows, c.least);
    }
}

// A pair that is not allowed is in no row, and in `refused` where the pair itself is to blame; every other pair is covered.
TEST(CoveringArray, keeps_to_what_is_allowed) {
    const std::vector<int> levels(6, 3);
    const CoveringRow usual(6, 1);
    const auto allowed = [](const CoveringRow& row) {
        return !(row[0] == 2 && row[3] == 0) && row[1] + row[2] + row[4] < 6 && row[5] + row[1] < 4;
    };
    const CoveringArray array = coveringArray(levels, usual, allowed);
    for (const CoveringRow& row : array.rows) EXPECT_TRUE(allowed(row));
    forEachPair(levels, [&](const ValuePair& pair) {
        const bool covered =
            std::any_of(array.rows.begin(), array.rows.end(), [&](const CoveringRow& row) { return has(row, pair); });
        const bool impossible = (pair.factorA == 0 && pair.factorB == 3 && pair.valueA == 2 && pair.valueB == 0) ||
                                (pair.factorA == 1 && pair.factorB == 5 && pair.valueA == 2 && pair.valueB == 2);
        const bool refused = std::any_of(array.refused.begin(), array.refused.end(), [&](const ValuePair& other) {
            return other.factorA == pair.factorA && other.factorB == pair.factorB && other.valueA == pair.valueA &&
                   other.valueB == pair.valueB;
        });
        EXPECT_EQ(covered, !impossible);
        EXPECT_EQ(refused, impossible);
    });
}

TEST(CoveringArray, is_always_the_same) {
    const std::vector<int> levels = levelsOf({{4, 2}, {3, 5}});
    EXPECT_EQ(coverAll(levels).rows, coverAll(levels).rows);
}

// Few rows in which every two factors meet in every pair of their values.
#pragma once
#include <cstddef>
#include <functional>
#include <vector>

namespace mv::test {

// One value for each factor, counted from 0.
using CoveringRow = std::vector<int>;

struct ValuePair {
    int factorA, valueA, factorB, valueB;
};

// Calls action(pair) for every pair of values of two factors.
template <class Action>
void forEachPair(const std::vector<int>& levels, Action action) {
    const int factors = static_cast<int>(levels.size());
    for (int a = 0; a < factors; ++a) {
        for (int b = a + 1; b < factors; ++b) {
            for (int i = 0; i < levels[static_cast<std::size_t>(a)]; ++i) {
                for (int j = 0; j < levels[static_cast<std::size_t>(b)]; ++j) action(ValuePair{a, i, b, j});
            }
        }
    }
}

struct CoveringArray {
    std::vector<CoveringRow> rows;   // each is allowed
    std::vector<ValuePair> refused;  // pairs for which no allowed row was found; `usual` with the pair in it is refused
};

// A covering array of strength 2: every pair of values of two factors is in a row, or in `refused`. levels[i] is the
// number of values of factor i, and `usual` a row of ordinary values, which is allowed. Always the same for the same
// arguments. At least two factors.
// Greedy, after Cohen, Dalal, Fredman and Patton, "The AETG system" (IEEE Trans. Softw. Eng. 23, 1997).
CoveringArray coveringArray(const std::vector<int>& levels, const CoveringRow& usual,
                            const std::function<bool(const CoveringRow&)>& allowed);

}  // namespace mv::test

#include "support/covering_array.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <optional>
#include <random>

namespace mv::test {
namespace {

// Rows tried for each one taken; more give hardly fewer rows.
constexpr int candidates = 40;

class Builder {
  public:
    Builder(const std::vector<int>& levels, const CoveringRow& usual,
            const std::function<bool(const CoveringRow&)>& allowed)
        : levels_(levels), usual_(usual), allowed_(allowed) {
        int values = 0;
        for (const int count : levels) {
            first_.push_back(values);
            values += count;
        }
        open_.assign(static_cast<std::size_t>(values), std::vector<bool>(static_cast<std::size_t>(values), false));
        forEachPair(levels_, [&](const ValuePair& pair) { setOpen(pair, true); });
    }

    CoveringArray build() {
        CoveringArray result;
        while (const std::optional<ValuePair> pair = busiestOpen()) {
            CoveringRow best;
            int most = 0;
            for (int i = 0; i < candidates; ++i) {
                const std::optional<CoveringRow> row = candidate(*pair);
                const int gain = row ? openPairs(*row) : 0;
                if (gain > most) {
                    most = gain;
                    best = *row;
                }
            }
            if (most == 0) {
                result.refused.push_back(*pair);
                setOpen(*pair, false);
                continue;
            }
            forEachPair(levels_, [&](const ValuePair& covered) {
                if (at(best, covered.factorA) == covered.valueA && at(best, covered.factorB) == covered.valueB) {
                    setOpen(covered, false);
                }
            });
            result.rows.push_back(best);
        }
        return result;
    }

  private:
    static int at(const CoveringRow& row, int factor) { return row[static_cast<std::size_t>(factor)]; }
    int factors() const { return static_cast<int>(levels_.size()); }
    // std's distributions differ from library to library.
    int random(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

    std::size_t number(int factor, int value) const {
        const int all = at(first_, factor) + value;
        return static_cast<std::size_t>(all);
    }
    void setOpen(const ValuePair& pair, bool open) {
        const std::size_t a = number(pair.factorA, pair.valueA), b = number(pair.factorB, pair.valueB);
        open_[a][b] = open_[b][a] = open;
    }
    bool isOpen(int factorA, int valueA, int factorB, int valueB) const {
        return open_[number(factorA, valueA)][number(factorB, valueB)];
    }
    // An open pair of the two values that are in most of them.
    std::optional<ValuePair> busiestOpen() {
        const auto count = [&](int factor, int value) {
            const std::vector<bool>& with = open_[number(factor, value)];
            return std::count(with.begin(), with.end(), true);
        };
        std::vector<ValuePair> busiest;
        std::ptrdiff_t most = 0;
        forEachPair(levels_, [&](const ValuePair& pair) {
            if (!isOpen(pair.factorA, pair.valueA, pair.factorB, pair.valueB)) return;
            const auto open = count(pair.factorA, pair.valueA) + count(pair.factorB, pair.valueB);
            if (open > most) busiest.clear();
            most = std::max(most, open);
            if (open == most) busiest.push_back(pair);
        });
        if (busiest.empty()) return {};
        return busiest[static_cast<std::size_t>(random(static_cast<int>(busiest.size())))];
    }
    int openPairs(const CoveringRow& row) const {
        int count = 0;
        for (int a = 0; a < factors(); ++a) {
            for (int b = a + 1; b < factors(); ++b) count += isOpen(a, at(row, a), b, at(row, b));
        }
        return count;
    }

    // A row with the pair in it: factor after factor, each with the value that covers most with those before it. Where
    // that row is not allowed, one factor after the other becomes usual until it is.
    std::optional<CoveringRow> candidate(const ValuePair& pair) {
        CoveringRow row = usual_;
        row[static_cast<std::size_t>(pair.factorA)] = pair.valueA;
        row[static_cast<std::size_t>(pair.factorB)] = pair.valueB;
        std::vector<int> order(levels_.size());
        std::iota(order.begin(), order.end(), 0);
        for (int i = factors() - 1; i > 0; --i) {
            std::swap(order[static_cast<std::size_t>(i)], order[static_cast<std::size_t>(random(i + 1))]);
        }
        std::erase(order, pair.factorA);
        std::erase(order, pair.factorB);
        std::vector<int> set{pair.factorA, pair.factorB};
        for (const int factor : order) {
            int best = 0, most = -1;
            const int start = random(at(levels_, factor));
            for (int i = 0; i < at(levels_, factor); ++i) {
                const int value = (start + i) % at(levels_, factor);
                const auto gain = std::count_if(
                    set.begin(), set.end(), [&](int other) { return isOpen(factor, value, other, at(row, other)); });
                if (static_cast<int>(gain) > most) {
                    most = static_cast<int>(gain);
                    best = value;
                }
            }
            row[static_cast<std::size_t>(factor)] = best;
            set.push_back(factor);
        }
        for (std::size_t i = 0; !allowed_(row); ++i) {
            if (i == order.size()) return {};
            const auto factor = static_cast<std::size_t>(order[i]);
            row[factor] = usual_[factor];
        }
        return row;
    }

    const std::vector<int>& levels_;
    const CoveringRow& usual_;
    const std::function<bool(const CoveringRow&)>& allowed_;
    std::vector<int> first_;  // the number of each factor's first value, counting all values
    std::vector<std::vector<bool>> open_;
    std::mt19937 random_{1};
};

}  // namespace

CoveringArray coveringArray(const std::vector<int>& levels, const CoveringRow& usual,
                            const std::function<bool(const CoveringRow&)>& allowed) {
    return Builder(levels, usual, allowed).build();
}

}  // namespace mv::test

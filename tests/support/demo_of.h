// A demo of a test's own: its settings by rows, and all that it does, or does wrong, by Demo's functions.
#pragma once
#include <utility>
#include <vector>

#include "mv/demo/lesson.h"

namespace mv::test {

template <class Settings>
class DemoOf : public Demo {
  public:
    explicit DemoOf(std::vector<Row<Settings>> rows = {}) : rows_(std::move(rows)) {
        for (const Row<Settings>& row : rows_) addRow(row, &s, &row_detail::example<Settings>());
    }
    void init() override {}
    void draw(const Frame&) override {}

    Settings s = {};

  private:
    std::vector<Row<Settings>> rows_;
};

}  // namespace mv::test

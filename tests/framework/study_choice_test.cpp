#include "mv/study/choice.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mv/study/study.h"

using namespace mv;

namespace {

template <class Action>
std::string refusal(const Action& action) {
    try {
        action();
        return "accepted";
    } catch (const Error& error) {
        return error.what();
    }
}

std::vector<std::size_t> allRows(const StudyRun& run) {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < run.rows.size(); ++i) rows.push_back(i);
    return rows;
}

}  // namespace

// Every committed study, at every number that it has as a bound: the row chosen keeps the bound, and none that keeps it,
// too, is cheaper (more exact).
TEST(StudyBound, the_row_chosen_keeps_it_and_no_other_is_better) {
    int tried = 0;
    for (const DemoInfo& info : catalogue()) {
        const auto run = committedStudy(info.name);
        if (!run) continue;
        const auto rows = allRows(*run);
        for (const StudyRow& row : run->rows) {
            if (!isPlotted(row)) continue;
            for (const StudyBound& bound : {StudyBound{StudyBound::Of::time, row.msMedian},
                                            StudyBound{StudyBound::Of::error, run->shownError(row)}}) {
                const bool ofTime = bound.of == StudyBound::Of::time;
                const auto asked = [&](const StudyRow& r) { return ofTime ? r.msMedian : run->shownError(r); };
                const auto paid = [&](const StudyRow& r) { return ofTime ? run->shownError(r) : r.msMedian; };
                const auto choice = rowWithin(*run, rows, bound);
                ASSERT_TRUE(choice) << "the row itself keeps it";
                const StudyRow& best = run->rows[*choice];
                EXPECT_TRUE(isPlotted(best));
                EXPECT_LE(asked(best), bound.value);
                for (const StudyRow& other : run->rows) {
                    if (isPlotted(other) && asked(other) <= bound.value) {
                        EXPECT_LE(paid(best), paid(other));
                    }
                }
                ++tried;
            }
        }
        for (const StudyBound::Of of : {StudyBound::Of::time, StudyBound::Of::error}) {
            EXPECT_FALSE(rowWithin(*run, rows, {of, -1})) << "no number is below 0";
            ASSERT_TRUE(nearestTo(*run, rows, {of, -1}));
            for (const StudyRow& row : run->rows) {
                const StudyRow& nearest = run->rows[*nearestTo(*run, rows, {of, -1})];
                if (!isPlotted(row)) continue;
                if (of == StudyBound::Of::time) {
                    EXPECT_LE(nearest.msMedian, row.msMedian);
                } else {
                    EXPECT_LE(run->shownError(nearest), run->shownError(row));
                }
            }
        }
    }
    EXPECT_GT(tried, 100);
}

// Rows that do not set the problem's knob were measured with its initial value.
TEST(StudyBound, only_rows_of_the_present_problem_are_chosen) {
    const StudyRun depths = committedStudy("z-buffer").value();
    const std::string scene = scenesOf(depths)[0];
    const auto demo = findDemo("z-buffer").make();
    for (const char* far : {"100", "1e4", "1e6"}) {
        demo->knob("far").parse(far);
        const auto rows = rowsOfProblem(depths, scene, *demo, "axis");
        ASSERT_FALSE(rows.empty());
        for (const std::size_t i : rows) EXPECT_EQ(depths.rows[i].parameter, far);
    }
    demo->knob("far").parse("300");
    EXPECT_EQ(refusal([&] { rowsOfProblem(depths, scene, *demo, "axis"); }),
              "axis: needs a --far that the study has in '" + scene + "': 100, 10000, 1e+06, 300");
    const StudyRun lights = committedStudy("shadow-lights").value();
    const auto many = findDemo("shadow-lights").make();
    many->knob("scene").parse("circle");
    for (const std::size_t i : rowsOfProblem(lights, "circle", *many, "axis")) {
        EXPECT_NE(lights.rows[i].knob, "lights")
            << "the initial number of lights, 3, is that of the rows by resolution";
    }
}

TEST(StudyBound, what_was_measured_otherwise_is_said) {
    const auto demo = findDemo("shadow-map").make();
    const StudyRun run = committedStudy("shadow-map").value();
    const StudyRow& row = run.rows.at(0);
    EXPECT_EQ(measuredOtherwise(row, *demo), "");
    demo->knob("resolution").parse("2048");
    EXPECT_EQ(measuredOtherwise(row, *demo), "") << "the row sets it";
    demo->knob("spin-y").parse("12");
    EXPECT_EQ(measuredOtherwise(row, *demo), "spin-y");
}

#include "mv/run/study_choice.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "mv/run/command_line.h"
#include "mv/run/study.h"

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

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// The command as it is once the setting has been chosen.
Command chosen(const std::vector<std::string>& words) {
    Command command = parseCommandLine(words);
    chooseByStudy(command);
    return command;
}

std::string word(const Command& command, const std::string& knob) {
    const auto demo = command.demo->make();
    applyKnobs(*demo, command.knobs);
    return demo->word(knob);
}

std::vector<std::size_t> allRows(const StudyRun& run) {
    std::vector<std::size_t> rows;
    for (std::size_t i = 0; i < run.rows.size(); ++i) rows.push_back(i);
    return rows;
}

}  // namespace

TEST(StudyBound, reads_times_and_errors) {
    EXPECT_EQ(readWithin("5ms").value, 5);
    EXPECT_EQ(readWithin("0.5s").value, 500);
    EXPECT_DOUBLE_EQ(readWithin("200us").value, 0.2);
    EXPECT_EQ(readError("0.01").value, 0.01);
    EXPECT_EQ(readError("1%").value, 0.01);
    EXPECT_EQ(readError("0").value, 0);
    for (const char* wrong : {"5", "ms", "5 ms", "5m", "-5ms", "0ms", "nanms", "infms", "5msx", "1e999ms"}) {
        EXPECT_TRUE(has(refusal([&] { readWithin(wrong); }), "--within: must be a time above 0 with its unit"))
            << wrong;
    }
    for (const char* wrong : {"x", "-1", "1ms", "1 %", "nan", "inf", "%", "1e999"}) {
        EXPECT_TRUE(has(refusal([&] { readError(wrong); }), "--error: must be a number from 0 on")) << wrong;
    }
}

// Of every committed study, at every number that it has as a bound: the row chosen keeps the bound, and none that keeps it,
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

// Whatever is chosen, the demo takes, and makes a picture of it.
TEST(StudyBound, what_is_chosen_can_be_drawn) {
    for (const DemoInfo& info : catalogue()) {
        const auto run = committedStudy(info.name);
        if (!run) continue;
        SCOPED_TRACE(info.name);
        Command command = parseCommandLine({info.name, "--within", "1000s"});
        const std::string said = refusal([&] { chooseByStudy(command); });
        // Where several scenes are meant it says how each is told; each of these is then accepted.
        if (said == "accepted") {
            const auto demo = info.make();
            applyKnobs(*demo, command.knobs);
            EXPECT_NO_THROW(demo->check());
            continue;
        }
        ASSERT_TRUE(has(said, "must be told which scene") || has(said, "needs a --")) << said;
        if (!has(said, "(--")) continue;
        int scenes = 0;
        for (auto at = said.find("(--"); at != std::string::npos; at = said.find("(--", at + 1)) {
            std::vector<std::string> words{info.name, "--within", "1000s"};
            std::istringstream flags(said.substr(at + 1, said.find(')', at) - at - 1));
            for (std::string flag; flags >> flag;) words.push_back(flag);
            EXPECT_EQ(refusal([&] { chosen(words); }), "accepted") << words.back();
            ++scenes;
        }
        EXPECT_GE(scenes, 2) << said;
    }
}

TEST(StudyBound, flags_of_knobs_restrict_the_choice) {
    const Command free = chosen({"shadow-methods", "--scene", "still-life", "--error", "0.001"});
    EXPECT_EQ(word(free, "scene"), "still-life");
    const auto run = committedStudy("shadow-methods").value();
    const Command filtered =
        chosen({"shadow-methods", "--scene", "still-life", "--method", "pcf3", "--error", "0.001"});
    EXPECT_EQ(word(filtered, "method"), "pcf3");
    EXPECT_EQ(word(filtered, "slope-bias"), "4") << "as that row has it";
    // No row has it: refused, with what the rows have.
    EXPECT_EQ(
        refusal([] {
            chosen({"shadow-methods", "--scene", "still-life", "--method", "pcf3", "--slope-bias", "3", "--error",
                    "0.001"});
        }),
        "--slope-bias: must be as in a setting that the study has in 'still life', for --error to choose it: 4, 3");
    EXPECT_TRUE(has(refusal([] {
                        chosen({"shadow-methods", "--scene", "still-life", "--error", "1e-9", "--method", "pcf3"});
                    }),
                    "--error: must be at least "));
    // What the study does not set is the user's.
    EXPECT_EQ(word(chosen({"shadow-methods", "--scene", "still-life", "--error", "0.001", "--spin-y", "12"}), "spin-y"),
              "12");
}

TEST(StudyBound, only_rows_of_the_present_problem_are_chosen) {
    for (const char* far : {"100", "1e4", "1e6"}) {
        const Command command = chosen({"z-buffer", "--far", far, "--error", "0"});
        EXPECT_EQ(word(command, "mapping"), "reversed") << far;
        const auto demo = command.demo->make();
        demo->knob("far").parse(far);
        EXPECT_EQ(word(command, "far"), demo->word("far"));
    }
    EXPECT_EQ(refusal([] {
                  chosen({"z-buffer", "--far", "300", "--error", "0"});
              }),
              "--error: needs a --far that the study has in 'separation 1e-5': 100, 10000, 1e+06, 300");
    // The circle's rows by resolution set no number of lights: they have the initial one, 3.
    EXPECT_EQ(word(chosen({"shadow-lights", "--scene", "circle", "--within", "100s"}), "method"), "maps");
    EXPECT_EQ(word(chosen({"shadow-lights", "--scene", "circle", "--lights", "4", "--within", "100s"}), "method"),
              "volumes");
    EXPECT_TRUE(has(refusal([] {
                        chosen({"shadow-lights", "--scene", "circle", "--lights", "5", "--within", "1s"});
                    }),
                    "needs a --lights that the study has in 'circle': 1, 2, 4, 8"));
}

TEST(StudyBound, scenes_are_those_of_the_present_settings) {
    // soft-shadows opens with the cube; its other scene is told by --scene alone, and takes its own size of the lamp.
    EXPECT_EQ(word(chosen({"soft-shadows", "--error", "0.05"}), "scene"), "cube");
    const Command table = chosen({"soft-shadows", "--scene", "table", "--error", "0.05"});
    EXPECT_EQ(word(table, "scene"), "table");
    EXPECT_EQ(word(table, "lamp-size"), "0.5");
    EXPECT_EQ(refusal([] {
                  chosen({"shadow-map", "--error", "0.05"});
              }),
              "--error: must be told which scene of the study is meant: 'cube on plane' (--scene cube-on-plane), "
              "'still life' (--scene still-life)");
}

TEST(StudyBound, what_cannot_be_is_said) {
    EXPECT_TRUE(has(refusal([] {
                        chosen({"cube-cull", "--error", "0.1"});
                    }),
                    "--error: needs a demo with a committed study"));
    EXPECT_TRUE(
        has(refusal([] {
                chosen({"soft-shadows", "--error", "1%"});
            }),
            "--error: must be a number here and no part in percent: the study's error is the root mean square error"));
    EXPECT_TRUE(has(refusal([] { chosen({"soft-shadows", "--within", "1us"}); }), "--within: must be at least "));
}

// Committed studies: their pages are made from them, and what does not depend on the machine is measured again.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "mv/run/study.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

const std::filesystem::path folder = std::filesystem::path(MVGL_SOURCE_DIR) / "docs/errors-and-times";

std::string fileText(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    EXPECT_TRUE(stream) << path;
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<std::string> studiedDemos() {
    std::vector<std::string> names;
    for (const DemoInfo& info : catalogue()) {
        if (info.study) names.push_back(info.name);
    }
    return names;
}

bool isLong() { return std::getenv("MVGL_LONG") != nullptr; }

// Slower rows than this are left to the long run, and so are the scenes before the last, each of which has a reference of
// its own: seconds of rays.
constexpr double shortMs = 40;

class Studies : public testing::TestWithParam<std::string> {};

// An error is a sum over pixels of which GL rounds a few differently from one driver to the next: 2 % of it, or the
// weight of one pixel in ten thousand, may differ. On the same driver nothing does.
void expectSame(double before, double now, const std::string& what) {
    EXPECT_NEAR(now, before, std::max(0.02 * before, 1e-4)) << what;
}

// The errors of values are roundings, of any size: another machine's sine may move one of many by a last place.
void expectSameRounding(double before, double now, const std::string& what) {
    EXPECT_NEAR(now, before, std::max(0.25 * before, 1e-16)) << what;
}

}  // namespace

// Every demo that declares a study has a committed run of it, with all its rows, and every committed run has its page.
TEST(StudyPages, are_there_and_fresh) {
    ASSERT_FALSE(studiedDemos().empty());
    for (const std::string& name : studiedDemos()) {
        SCOPED_TRACE(name);
        const DemoInfo& demo = findDemo(name);
        ASSERT_TRUE(std::filesystem::exists(folder / (name + ".json"))) << "./test --update-studies measures it";
        const StudyRun run = readStudy(fileText(folder / (name + ".json")));
        EXPECT_EQ(fileText(folder / (name + ".md")), studyPage(run, demo)) << "./run --docs . makes it anew";
        EXPECT_NE(fileText(folder / (name + ".svg")).find("</svg>"), std::string::npos);
        EXPECT_FALSE(demo.study->says.empty()) << "two sentences of what it says";
        std::size_t declared = 0;
        for (const StudyLine& line : demo.study->lines) {
            const std::size_t scenes = line.scenes.empty() ? demo.study->scenes.size() : line.scenes.size();
            declared += scenes * (line.knob.empty() ? 1 : line.values.size());
        }
        EXPECT_EQ(run.rows.size(), declared) << "the declaration has changed";
        ASSERT_TRUE(committedStudy(name)) << "built in, for the window";
        EXPECT_EQ(studyJson(*committedStudy(name)), studyJson(run));
        for (const StudyRow& row : run.rows) {
            EXPECT_TRUE(!row.ok() || row.rounds >= 7) << row.method << " " << row.parameter;
        }
    }
}

// Errors and counts, measured again.
TEST_P(Studies, errors_and_counts_hold) {
    const DemoInfo& demo = findDemo(GetParam());
    const StudyRun before = readStudy(fileText(folder / (demo.name + ".json")));
    stage().open(demo, demo.study->width, demo.study->height);
    StudyOptions options{.timed = false};
    options.wanted = [&](const StudyRow& row) {
        for (const StudyRow& old : before.rows) {
            if (old.scene == row.scene && old.method == row.method && old.parameter == row.parameter) {
                return isLong() || (old.msMedian < shortMs && row.scene == demo.study->scenes.back().name);
            }
        }
        return true;
    };
    const StudyRun now = runStudy(stage(), *demo.study, options);
    stage().close();
    ASSERT_EQ(now.rows.size(), before.rows.size());
    int compared = 0;
    for (std::size_t i = 0; i < now.rows.size(); ++i) {
        const StudyRow &old = before.rows[i], &row = now.rows[i];
        const std::string what = row.scene + ", " + row.method + " " + row.parameter;
        if (row.status == notMeasured) continue;
        ++compared;
        EXPECT_EQ(row.status, old.status) << what;
        (demo.study->ofValues ? expectSameRounding : expectSame)(old.all.rms, row.all.rms, what + ": rms");
        expectSame(old.all.fraction, row.all.fraction, what + ": wrong");
        expectSame(old.inside.rms, row.inside.rms, what + ": rms beside the edges");
        expectSame(old.inside.fraction, row.inside.fraction, what + ": wrong beside the edges");
        ASSERT_EQ(row.counts.size(), old.counts.size()) << what;
        for (std::size_t k = 0; k < row.counts.size(); ++k) {
            EXPECT_EQ(row.counts[k].first, old.counts[k].first) << what;
            // Fragments on an edge are GL's to round; the rest is exact.
            const double allowed = row.counts[k].first == "fragments" ? 0.001 * old.counts[k].second : 0;
            EXPECT_NEAR(row.counts[k].second, old.counts[k].second, allowed) << what << ": " << row.counts[k].first;
        }
    }
    EXPECT_GT(compared, 0);
    std::printf("%s: %d of %zu rows measured again\n", demo.name.c_str(), compared, now.rows.size());
}

// --vary KNOB=a,b is two runs with --KNOB a and --KNOB b: each value is judged by what is right for it. Of every knob, the
// ends of its range, after its initial value, whose reference must not serve them.
TEST_P(Studies, a_varied_knob_is_judged_as_one_that_is_set) {
    const DemoInfo& demo = findDemo(GetParam());
    int compared = 0, moved = 0;
    const auto declared = demo.make();
    for (const Knob* knob : declared->knobs()) {
        SCOPED_TRACE(knob->name());
        const std::vector<std::string> sweep = knob->sweep(), values{knob->initialText(), sweep.front(), sweep.back()};
        if (knob->initialText().find(',') != std::string::npos) continue;  // points, which a list cannot have
        std::string vary = knob->name() + "=";
        for (const std::string& value : values) vary += (vary.ends_with('=') ? "" : ",") + value;
        // A few pixels suffice: a reference of other settings is wrong by far.
        const auto run = [&](const std::vector<KnobSetting>& set, Study study) {
            study.width = 24;
            study.height = 18;
            stage().open(demo, study.width, study.height);
            applyKnobs(stage().demo(), set);
            StudyRun rows = runStudy(stage(), study, {.timed = false});
            stage().close();
            return rows;
        };
        const StudyRun varied = run({}, studyOf(demo, {}, vary));
        ASSERT_EQ(varied.rows.size(), values.size());
        for (std::size_t i = 0; i < values.size(); ++i) {
            Study single = *demo.study;
            single.scenes = {{"as set", {}}};
            single.lines = {{"as set", {}}};
            const StudyRow row = varied.rows[i], set = run({{knob->name(), values[i]}}, single).rows.at(0);
            SCOPED_TRACE(values[i]);
            EXPECT_EQ(row.status, set.status);
            EXPECT_EQ(row.all.n, set.all.n);
            EXPECT_EQ(row.all.rms, set.all.rms);
            EXPECT_EQ(row.all.max, set.all.max);
            EXPECT_EQ(row.all.fraction, set.all.fraction);
            EXPECT_EQ(row.inside.rms, set.inside.rms);
            EXPECT_EQ(row.unmatched, set.unmatched);
            ++compared;
            if (row.ok() && row.all.rms != varied.rows[0].all.rms) ++moved;
        }
    }
    EXPECT_GT(moved, 0) << "a knob that matters must be among them";
    std::printf("%s: %d settings, %d with errors of their own\n", demo.name.c_str(), compared, moved);
}

INSTANTIATE_TEST_SUITE_P(Committed, Studies, testing::ValuesIn(studiedDemos()), parameterWord);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Studies);

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

INSTANTIATE_TEST_SUITE_P(Committed, Studies, testing::ValuesIn(studiedDemos()), parameterWord);
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Studies);

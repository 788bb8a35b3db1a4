// Its committed study of error against run time: what does not depend on the machine is measured again.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "mv/paper/docs.h"
#include "mv/study/claims.h"
#include "mv/study/data.h"
#include "mv/study/study.h"
#include "visits/visit.h"

namespace mv::test {
namespace {

std::vector<std::string> studiedDemos() {
    std::vector<std::string> names;
    for (const DemoInfo& info : catalogue()) {
        if (info.study) names.push_back(info.name);
    }
    return names;
}

class Studies : public testing::TestWithParam<std::string> {};

// What ./test --full measures again: of the first scene the fastest row of each method. --long measures all.
std::set<std::string> rowsOfFullRun(const StudyRun& run) {
    std::map<std::string, const StudyRow*> fastest;
    for (const StudyRow& row : run.rows) {
        if (row.scene != run.rows.front().scene) continue;
        const StudyRow*& known = fastest[row.method];
        if (!known || (row.ok() && (!known->ok() || row.msMedian < known->msMedian))) known = &row;
    }
    std::set<std::string> names;
    for (const auto& [line, row] : fastest) names.insert(nameOf(*row));
    return names;
}

// How many of the wrong values another driver may judge otherwise: they lie on edges, where rounding decides, one in fifty
// at most, and twenty where all is wrong. So none may of less than 50, and 0 stays 0. On the same driver nothing differs.
double valuesAllowed(const StudyError& before) {
    return std::min(20.0, std::floor(0.02 * double(before.n) * before.fraction));
}

// Of pictures, in pixels.
void expectSamePixels(const StudyError& before, const StudyError& now, const std::string& what) {
    const double allowed = valuesAllowed(before), n = double(before.n);
    EXPECT_NEAR(double(now.n), n, allowed) << what << ": pixels that count";
    // The committed numbers have six digits, which is far less than a pixel of the largest picture.
    EXPECT_NEAR(now.fraction * n, before.fraction * n, allowed + 0.01 * std::min(1.0, before.fraction * n))
        << what << ": wrong pixels";
    // A pixel that is judged otherwise moves the sum of squares by 1 at most. The weights of a filter have eight bits on some
    // hardware, and their rounding is a thousandth of the sum.
    EXPECT_NEAR(now.rms * now.rms * n, before.rms * before.rms * n, allowed + 1e-3 * before.rms * before.rms * n)
        << what << ": squares";
    // The same weights: half a step of them, and less than what is measured.
    EXPECT_NEAR(now.max, before.max, std::min(1.0 / 512, 0.1 * before.max)) << what << ": largest";
}

// Of values: roundings, of any size. Another machine's sine may move one of many by a last place.
void expectSameValues(const StudyError& before, const StudyError& now, const std::string& what) {
    EXPECT_EQ(now.n, before.n) << what << ": values that count";
    const double n = double(before.n);
    EXPECT_NEAR(now.fraction * n, before.fraction * n,
                valuesAllowed(before) + 0.01 * std::min(1.0, before.fraction * n))
        << what << ": wrong values";
    EXPECT_NEAR(now.rms, before.rms, 0.25 * before.rms) << what << ": rms";
    EXPECT_NEAR(now.max, before.max, 0.25 * before.max) << what << ": largest";
}

// ---- Claims

// The outcomes of two rows are exchanged, and not what they are called.
void exchange(StudyRow& a, StudyRow& b) {
    std::swap(a.all, b.all);
    std::swap(a.awayFromEdges, b.awayFromEdges);
    std::swap(a.msMedian, b.msMedian);
    std::swap(a.rounds, b.rounds);
    std::swap(a.counts, b.counts);
    std::swap(a.status, b.status);
}

bool failsOn(const StudyRun& run, const Predicate& predicate) {
    try {
        return !evaluate(run, predicate).holds;
    } catch (const Error&) {
        return false;  // it says nothing of these rows
    }
}

// Whether the predicate fails on the rows of two lines exchanged (of two methods, or of one in two scenes), or of one line from
// back to front: by which.
std::string exchangeThatFails(const StudyRun& run, const Predicate& predicate) {
    std::vector<std::vector<std::size_t>> lines;
    for (std::size_t i = 0; i < run.rows.size(); ++i) {
        const auto same = std::find_if(lines.begin(), lines.end(), [&](const auto& line) {
            return run.rows[line[0]].scene == run.rows[i].scene && run.rows[line[0]].method == run.rows[i].method;
        });
        if (same == lines.end()) {
            lines.push_back({i});
        } else {
            same->push_back(i);
        }
    }
    const auto name = [&](const auto& line) { return run.rows[line[0]].scene + ", " + run.rows[line[0]].method; };
    for (std::size_t a = 0; a < lines.size(); ++a) {
        StudyRun changed = run;
        for (std::size_t i = 0; i < lines[a].size() / 2; ++i)
            exchange(changed.rows[lines[a][i]], changed.rows[lines[a][lines[a].size() - 1 - i]]);
        if (failsOn(changed, predicate)) return name(lines[a]) + " from back to front";
        for (std::size_t b = a + 1; b < lines.size(); ++b) {
            changed = run;
            for (std::size_t i = 0; i < std::min(lines[a].size(), lines[b].size()); ++i)
                exchange(changed.rows[lines[a][i]], changed.rows[lines[b][i]]);
            if (failsOn(changed, predicate)) return name(lines[a]) + " and " + name(lines[b]) + " exchanged";
        }
    }
    return "";
}

void expectHolds(const StudyRun& run, const Saying& saying, const Predicate& predicate) {
    const Evaluation evaluation = evaluate(run, predicate);
    std::string failures;
    for (const std::string& failure : evaluation.failures) failures += "\n  " + failure;
    EXPECT_TRUE(evaluation.holds) << run.demo << " [" << saying.id << "] " << saying.sentence << "\n  "
                                  << evaluation.text << failures;
}

// The committed rows bear out what the study says, of each machine that a sentence is about.
TEST_P(Studies, claims_hold) {
    const DemoInfo& demo = findDemo(GetParam());
    for (const StudyRun& run : studiesInTree(MVGL_SOURCE_DIR, demo.name)) {
        SCOPED_TRACE(machineName(run));
        for (const Saying& saying : demo.study->says) {
            if (!isAbout(saying, run)) continue;
            for (const Predicate& predicate : saying.predicates) expectHolds(run, saying, predicate);
        }
    }
}

// Each predicate fails on rows that exist: no claim would hold of just anything.
TEST_P(Studies, claims_can_fail) {
    const DemoInfo& demo = findDemo(GetParam());
    const std::vector<StudyRun> runs = studiesInTree(MVGL_SOURCE_DIR, demo.name);
    int claims = 0, predicates = 0;
    for (const Saying& saying : demo.study->says) {
        claims += saying.isClaim() ? 1 : 0;
        for (const Predicate& predicate : saying.predicates) {
            ++predicates;
            const auto about = std::ranges::find_if(runs, [&](const auto& run) { return isAbout(saying, run); });
            ASSERT_NE(about, runs.end()) << saying.id << ": no machine that it is about";
            const StudyRun& run = *about;
            EXPECT_NE(exchangeThatFails(run, predicate), "")
                << "[" << saying.id << "] " << evaluate(run, predicate).text << ": holds whatever lines are exchanged";
        }
    }
    std::printf("%s: %d claims, %d predicates\n", demo.name.c_str(), claims, predicates);
}

// A reference is kept while the settings that it says it reads are as they were, so it depends on no other: in each scene of the study, and
// in each preset, which --study measures in, too, both ends of each other knob make the same one. (In a small picture: what is read is the
// same.) In ./test --long.
TEST_P(Studies, references_depend_on_what_they_read) {
    if (!isLong()) return;
    const Study& study = *findDemo(GetParam()).study;
    if (study.reads.empty()) return;  // it is made anew for each row
    DemoRun run(GetParam(), 24, 18);
    Demo& demo = run.demo();
    const auto reference = [&]() -> std::optional<Reference> {
        try {
            if (!study.ofValues) demo.check();
            return study.makeReference(demo, {FrameInfo(study.frame, 24, 18)}, [](double) {});
        } catch (const Error&) {
            return {};  // no picture, or none that has a reference
        }
    };
    const auto sameNumbers = [](const std::vector<double>& a, const std::vector<double>& b) {
        return std::ranges::equal(a, b, [](double x, double y) { return x == y || (x != x && y != y); });
    };
    std::vector<StudyScene> scenes = study.scenes;
    for (const Preset& preset : findDemo(GetParam()).presets) scenes.push_back({preset.name, preset.settings});
    int compared = 0;
    for (const StudyScene& scene : scenes) {
        for (Knob* knob : demo.knobs()) knob->reset();
        applyKnobs(demo, scene.settings);
        const std::optional<Reference> right = reference();
        for (Knob* knob : demo.knobs()) {
            if (!right || std::ranges::count(study.reads, std::string(knob->name())) > 0) continue;
            const std::string usual = knob->text();
            for (const std::string& text : {knob->sweep().front(), knob->sweep().back()}) {
                knob->parse(text);
                const std::optional<Reference> other = reference();
                if (!other) continue;
                ++compared;
                EXPECT_TRUE(sameNumbers(other->values, right->values) &&
                            sameNumbers(other->averages, right->averages) && other->regions == right->regions)
                    << scene.name << ": --" << knob->name() << " " << text
                    << " makes another reference, and is not among what it reads";
            }
            knob->parse(usual);
        }
    }
    std::printf("%s: %d references compared\n", GetParam().c_str(), compared);
}

// Errors and counts, measured again.
TEST_P(Studies, errors_and_counts_hold) {
    const DemoInfo& demo = findDemo(GetParam());
    const StudyRun before = studiesInTree(MVGL_SOURCE_DIR, demo.name).at(0);
    stage().open(demo, demo.study->width, demo.study->height);
    StudyOptions options{.timed = false};
    const std::set<std::string> few = rowsOfFullRun(before);
    options.wanted = [&](const StudyRow& row) { return isLong() || few.contains(nameOf(row)); };
    const StudyRun now = runStudy(stage(), *demo.study, options);
    stage().close();
    ASSERT_EQ(now.rows.size(), before.rows.size());
    int compared = 0;
    std::set<std::string> lines, linesMet;
    for (std::size_t i = 0; i < now.rows.size(); ++i) {
        const StudyRow &old = before.rows[i], &row = now.rows[i];
        const std::string what = nameOf(row);
        if (isLong() || row.scene == now.rows.front().scene) lines.insert(row.scene + ", " + row.method);
        if (row.status == notMeasured) continue;
        linesMet.insert(row.scene + ", " + row.method);
        ++compared;
        EXPECT_EQ(nameOf(old), what);
        EXPECT_EQ(row.status, old.status) << what;
        const auto expectSame = demo.study->ofValues ? expectSameValues : expectSamePixels;
        expectSame(old.all, row.all, what);
        expectSame(old.awayFromEdges, row.awayFromEdges, what + ", away from edges");
        EXPECT_EQ(row.unmatched, old.unmatched) << what;
        ASSERT_EQ(row.counts.size(), old.counts.size()) << what;
        for (std::size_t k = 0; k < row.counts.size(); ++k) {
            EXPECT_EQ(row.counts[k].first, old.counts[k].first) << what;
            // Fragments on an edge are GL's to round; the rest is exact.
            const double allowed = row.counts[k].first == "fragments" ? 0.001 * old.counts[k].second : 0;
            EXPECT_NEAR(row.counts[k].second, old.counts[k].second, allowed) << what << ": " << row.counts[k].first;
        }
    }
    EXPECT_EQ(linesMet, lines) << "every method is met";
    std::printf("%s: %d of %zu rows measured again\n", demo.name.c_str(), compared, now.rows.size());
    if (!isLong()) return;
    // Those on times, and those of another kind of renderer, are evaluated on the committed rows alone.
    for (const Saying& saying : demo.study->says) {
        if (!isAbout(saying, now)) continue;
        for (const Predicate& predicate : saying.predicates) {
            if (!predicate.asksTimes()) expectHolds(now, saying, predicate);
        }
    }
}

// --vary KNOB=a,b is two runs with --KNOB a and --KNOB b: each value is judged by what is right for it. The ends of
// each knob's range, after its initial value, whose reference must not serve them. In ./test --long.
TEST_P(Studies, a_varied_knob_is_judged_as_one_that_is_set) {
    if (!isLong()) return;
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
            EXPECT_EQ(row.awayFromEdges.rms, set.awayFromEdges.rms);
            EXPECT_EQ(row.unmatched, set.unmatched);
            ++compared;
            if (row.ok() && row.all.rms != varied.rows[0].all.rms) ++moved;
        }
    }
    EXPECT_GT(moved, 0) << "a knob that matters must be among them";
    std::printf("%s: %d settings, %d with errors of their own\n", demo.name.c_str(), compared, moved);
}

INSTANTIATE_TEST_SUITE_P(Demos, Studies, testing::ValuesIn(studiedDemos()), parameterWord);

}  // namespace
}  // namespace mv::test

#include "mv/study/study.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mv/gl/gl.h"
#include "support/demo_of.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

const char* const quadShader =
    "void main() { gl_Position = vec4(2.0 * vec2(gl_VertexID & 1, gl_VertexID >> 1) - 1.0, 0.0, 1.0); }\n";
const char* const stepShader = R"(
uniform float cells, edge, width, broken;
uniform bool measuring;
out vec4 color;
void main() {
    float x = (floor(gl_FragCoord.x / width * cells) + 0.5) / cells;
    float lit = (x > edge) == (broken < 0.5) ? 1.0 : 0.0;
    color = measuring ? vec4(lit) : vec4(vec3(lit), 1.0);
}
)";

// Light to the right of a line, shadow to the left, known only to the middles of `cells` cells.
struct Line {
    int cells = 8;
    double edge = 0.3;
    bool broken = false, refused = false, nowhere = false;
};
struct Step final : DemoOf<Line> {
    Step()
        : DemoOf(together(
              whole("cells", &Line::cells, {1, 4096}, "cells across"),
              mv::number("edge", &Line::edge, {0, 1}, "of the picture's width; 0.3 is on no boundary of 2^k cells"),
              toggle("broken", &Line::broken, "light and shadow exchanged"),
              toggle("refused", &Line::refused, "a setting that makes no picture"),
              toggle("nowhere", &Line::nowhere, "nothing is measured"))) {}
    Program program;
    VertexArray empty;
    inline static int references = 0;  // made so far
    void init() override {
        program = Program::fromText("step", quadShader, stepShader);
        empty = makeVertexArray();
    }
    void check() const override {
        if (s.refused) throw Error("--refused", "must be off");
    }
    void draw(const Frame& frame) override {
        const float clear = frame.measuring() ? -1 : 0;
        glClearColor(clear, clear, clear, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        if (s.nowhere) return;
        program.use();
        program.set("cells", double(s.cells));
        program.set("edge", s.edge);
        program.set("width", double(frame.width()));
        program.set("broken", s.broken ? 1.0 : 0.0);
        glBindVertexArray(empty.id());
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
        frame.count("cells", s.cells);
    }
    Reference reference(const ReferenceFrame& frame, const std::function<void(double)>& progress) const {
        ++references;
        Reference right;
        for (int y = 0; y < frame.height(); ++y) {
            for (int x = 0; x < frame.width(); ++x) right.values.push_back((x + 0.5) / frame.width() > s.edge ? 1 : 0);
        }
        right.regions.assign(right.values.size(), 0);
        progress(1);
        if (frame.ownError) right.ownError = 0;
        return right;
    }
};

template <class T>
void referenceBy(Study& study) {
    study.makeReference = [](const Demo& demo, const ReferenceFrame& frame, const auto& progress) {
        return dynamic_cast<const T&>(demo).reference(frame, progress);
    };
}

Study stepStudy() {
    Study study;
    referenceBy<Step>(study);
    study.quantity = "lit or not";
    study.reference = "the line itself";
    study.scenes = {{"line", {}}};
    study.lines = {{"cells", {}, "cells", {"4", "16", "64", "256", "1024"}},
                   {"broken", {{"broken", "on"}}, "cells", {"1024"}},
                   {"refused", {{"refused", "on"}}},
                   {"nowhere", {{"nowhere", "on"}}},
                   {"edges", {{"cells", "1024"}}, "edge", {"0.1", "0.5", "0.9"}},
                   {"edges again", {{"cells", "512"}}, "edge", {"0.9"}}};
    study.axis = ErrorAxis::fraction;
    study.reads = {"edge"};
    study.width = 1000;
    study.height = 4;
    return study;
}

// The integral of e^x over 0..1 by n trapezia; the error falls as n^-2.
struct Parts {
    int n = 4;
};
struct Trapezia final : DemoOf<Parts> {
    Trapezia() : DemoOf({whole("n", &Parts::n, {1, 100000}, "trapezia")}) {}
    std::vector<double> values() const override {
        double sum = (1 + std::exp(1.0)) / 2;
        for (int i = 1; i < s.n; ++i) sum += std::exp(double(i) / s.n);
        return {sum / s.n};
    }
    std::vector<std::pair<std::string, double>> valueCounts() const override { return {{"terms", s.n + 1.0}}; }
    static Reference reference(const ReferenceFrame&, const std::function<void(double)>&) {
        return {.values = {std::exp(1.0) - 1}};
    }
};

Study trapeziaStudy() {
    Study study;
    referenceBy<Trapezia>(study);
    study.quantity = "integral";
    study.reference = "in closed form";
    study.scenes = {{"", {}}};
    study.lines = {{"trapezia", {}, "n", {"4", "16", "64", "256"}}};
    study.ofValues = true;
    return study;
}

template <class T>
DemoInfo infoOf(Literal name, Study study) {
    DemoInfo made;
    made.name = name;
    made.study = std::move(study);
    made.make = [] { return std::make_unique<T>(); };
    return made;
}

const StudyRow& row(const StudyRun& run, const std::string& method, const std::string& parameter = "") {
    for (const StudyRow& each : run.rows) {
        if (each.method == method && each.parameter == parameter) return each;
    }
    throw Error("row", "must be there", method + " " + parameter);
}

StudyRun stepRun(const StudyOptions& options = {.timed = false}) {
    static const DemoInfo made = infoOf<Step>("step", stepStudy());
    stage().open(made, 10, 10);
    StudyRun run = runStudy(stage(), stepStudy(), options);
    EXPECT_EQ(stage().front().width(), 10) << "the stage has its size again";
    EXPECT_EQ(stage().demo().knob("cells").text(), "8") << "and the knobs their values";
    stage().close();
    return run;
}

}  // namespace

// By hand: with 4 cells the second cell's middle, .375, is light, so all of .25..1 is: .05 of the picture is wrong.
TEST(StudyRun, errors_are_what_they_are_by_hand) {
    const StudyRun run = stepRun();
    const StudyRow& four = row(run, "cells", "4");
    EXPECT_EQ(four.status, "ok");
    EXPECT_EQ(four.all.n, 4000);
    EXPECT_DOUBLE_EQ(four.all.fraction, 0.05);
    EXPECT_DOUBLE_EQ(four.all.rms, std::sqrt(0.05));
    EXPECT_EQ(four.all.max, 1);
    // The band are the two columns at the edge, of which the left one is wrong.
    EXPECT_EQ(four.awayFromEdges.n, 4000 - 8);
    EXPECT_DOUBLE_EQ(four.awayFromEdges.fraction, 196.0 / 3992);
    EXPECT_EQ(four.unmatched, 0);
}

// The error of a cell is at most its half and .3 lies at no fixed place in it, so the slope is -1 with much scatter.
TEST(StudyRun, slope_is_fitted) {
    const auto slope = errorSlope(stepRun(), "line", "cells");
    ASSERT_TRUE(slope);
    EXPECT_NEAR(*slope, -1, 0.25);
    EXPECT_FALSE(errorSlope(stepRun(), "line", "broken")) << "one point has no slope";
}

TEST(StudyRun, a_broken_method_shows) {
    const StudyRun run = stepRun();
    EXPECT_GT(row(run, "broken", "1024").all.fraction, 0.99);
    EXPECT_LT(row(run, "cells", "1024").all.fraction, 0.002);
}

// A knob that the reference reads has one for each of its values; rows that differ in others share it.
TEST(StudyRun, each_setting_has_its_reference) {
    const int before = Step::references;
    const StudyRun run = stepRun();
    for (const char* edge : {"0.1", "0.5", "0.9"}) EXPECT_LT(row(run, "edges", edge).all.fraction, 0.002) << edge;
    EXPECT_LT(row(run, "edges again", "0.9").all.fraction, 0.004);
    EXPECT_EQ(Step::references - before, 4) << "at 0.3, whatever the cells and whatever is broken, 0.1, 0.5 and 0.9";
}

// A reference is kept for as long as what it depends on, by Study::reads, stays.
TEST(StudyRun, a_reference_depends_on_what_it_reads) {
    struct Two {
        bool usesB = false;
        double b = 1;
        int more = 0;
    };
    struct Branch final : DemoOf<Two> {
        Branch()
            : DemoOf(together(toggle("uses-b", &Two::usesB, "whether b counts"),
                              mv::number("b", &Two::b, {0, 9}, "a number"),
                              whole("more", &Two::more, {0, 9}, "how many times the method is wrong by 1"))) {}
        int* references = nullptr;
        double right() const { return s.usesB ? s.b : 0; }
        std::vector<double> values() const override { return {right() + s.more}; }
        Reference reference(const ReferenceFrame&, const std::function<void(double)>&) const {
            ++*references;
            if (s.usesB && s.b > 8) throw Error("--b", "must be at most 8 for a reference", word("b"));
            return {.values = {right()}};
        }
    };
    int references = 0;
    DemoInfo made = infoOf<Branch>("branch", trapeziaStudy());
    made.make = [&] {
        auto demo = std::make_unique<Branch>();
        demo->references = &references;
        return demo;
    };
    Study study = trapeziaStudy();
    referenceBy<Branch>(study);
    study.reads = {"uses-b", "b"};
    study.lines = {{"off", {}, "b", {"1", "2", "3"}},
                   {"on", {{"uses-b", "on"}}, "b", {"1", "2", "3", "9", "2"}},
                   {"wrong", {{"uses-b", "on"}, {"b", "3"}}, "more", {"1", "4"}}};
    stage().open(made, 4, 4);
    const StudyRun run = runStudy(stage(), study, {.timed = false});
    stage().close();
    EXPECT_EQ(references, 7) << "of 1, 2, 3 while it is off; of 1, 2, 3, and of 9 in vain";
    for (const StudyRow& each : run.rows) {
        if (each.parameter == "9") {
            EXPECT_EQ(each.status, "--b: must be at most 8 for a reference, 9");
            continue;
        }
        EXPECT_EQ(each.status, "ok") << each.method << " " << each.parameter;
        EXPECT_EQ(each.all.max, each.method != "wrong" ? 0 : each.parameter == "1" ? 1 : 4) << each.parameter;
    }
}

TEST(StudyRun, a_line_may_keep_to_some_scenes) {
    static const DemoInfo made = infoOf<Step>("step", stepStudy());
    Study study = stepStudy();
    study.scenes = {{"left", {{"edge", "0.2"}}}, {"right", {{"edge", "0.7"}}}};
    study.lines = {{"cells", {}, "cells", {"64"}}, {"finer", {}, "cells", {"1024"}, {"right"}}};
    stage().open(made, 10, 10);
    const StudyRun run = runStudy(stage(), study, {.timed = false});
    stage().close();
    ASSERT_EQ(run.rows.size(), 3U);
    EXPECT_EQ(run.rows[2].scene, "right");
    EXPECT_EQ(run.rows[2].method, "finer");
    for (const StudyRow& each : run.rows) EXPECT_LT(each.all.fraction, 0.02) << each.scene;
}

TEST(StudyRun, regions_are_whole_rows) {
    static const DemoInfo made = infoOf<Step>("step", stepStudy());
    Study study = stepStudy();
    study.lines = {{"cells", {}, "cells", {"64"}}};
    const auto makeReference = study.makeReference;
    const auto statusWith = [&](int across, std::size_t regions) {
        study.makeReference = [&](const Demo& demo, const ReferenceFrame& frame, const auto& progress) {
            Reference reference = makeReference(demo, frame, progress);
            reference.across = across;
            reference.regions.assign(regions, 0);
            return reference;
        };
        stage().open(made, 10, 10);
        std::string status = runStudy(stage(), study, {.timed = false}).rows.at(0).status;
        stage().close();
        return status;
    };
    // The study's picture is 1000 x 4
    EXPECT_EQ(statusWith(0, 4000), "ok");
    EXPECT_EQ(statusWith(20, 4000), "ok");
    EXPECT_EQ(statusWith(7, 4000),
              "reference: must have whole rows of regions, one for each of its 4000 values, 4000 in rows of 7");
    EXPECT_EQ(statusWith(0, 3999),
              "reference: must have whole rows of regions, one for each of its 4000 values, 3999 in rows of 1000");
}

TEST(StudyRun, failures_stay_as_rows) {
    const StudyRun run = stepRun();
    EXPECT_EQ(run.rows.size(), 12U);
    EXPECT_EQ(row(run, "refused").status, "--refused: must be off");
    EXPECT_NE(row(run, "nowhere").status.find("must have values to compare"), std::string::npos);
    const std::string table = studyTable(run);
    EXPECT_NE(table.find("failed: line, refused : --refused: must be off"), std::string::npos) << table;
}

TEST(StudyRun, counts_work) {
    const StudyRow four = row(stepRun(), "cells", "4");
    const std::vector<std::pair<std::string, double>> expected{
        {"draws", 1}, {"triangles", 2}, {"fragments", 4000}, {"passes", 1}, {"cells", 4}};
    EXPECT_EQ(four.counts, expected);
}

TEST(StudyRun, times_every_round_and_tells) {
    std::vector<std::string> lines;
    const StudyRun run =
        stepRun({.rounds = 7, .timed = true, .progress = [&](const std::string& line) { lines.push_back(line); }});
    EXPECT_EQ(row(run, "cells", "4").rounds, 7);
    EXPECT_EQ(row(stepRun({.rounds = 7, .seconds = 1e-9}), "cells", "4").rounds, 1) << "one, however long it takes";
    EXPECT_GT(row(run, "cells", "4").msMedian, 0);
    EXPECT_GE(row(run, "cells", "4").msMad, 0);
    EXPECT_EQ(row(run, "refused").rounds, 0);
    EXPECT_EQ(run.referenceErrors.size(), 1U);
    for (const std::string& line : lines) EXPECT_EQ(line.rfind("study ", 0), 0U) << line;
}

TEST(StudyRun, of_values_needs_no_picture) {
    const DemoInfo made = infoOf<Trapezia>("trapezia", trapeziaStudy());
    stage().open(made, 4, 4);
    StudyRun run = runStudy(stage(), trapeziaStudy(), {});
    stage().close();
    // The trapezium rule: error h^2/12 (e - 1) to first order.
    EXPECT_NEAR(row(run, "trapezia", "64").all.rms, (std::exp(1.0) - 1) / 12 / 64 / 64, 1e-9);
    EXPECT_EQ(row(run, "trapezia", "64").counts, (std::vector<std::pair<std::string, double>>{{"terms", 65}}));
    EXPECT_NEAR(*errorSlope(run, "", "trapezia"), -2, 0.01);
    // Times that a run measures are anybody's; of these the slope is known.
    for (StudyRow& each : run.rows) {
        EXPECT_GT(each.msMedian, 0) << each.parameter;
        each.msMedian = 3 * std::pow(std::stod(each.parameter), 1.5);
    }
    EXPECT_NEAR(*timeSlope(run, "", "trapezia"), 1.5, 1e-9);
}

TEST(StudyData, pareto_best_is_marked) {
    StudyRun run;
    const auto add = [&](const std::string& name, double error, double ms, const std::string& status = "ok") {
        StudyRow each;
        each.method = name;
        each.all.rms = error;
        each.msMedian = ms;
        each.rounds = 7;
        each.status = status;
        run.rows.push_back(each);
    };
    add("exact but slow", 0, 9);
    add("good", 0.1, 2);
    add("as good, slower", 0.1, 3);
    add("worse and slower", 0.2, 4);
    add("fast", 0.5, 1);
    add("failed", 0, 0, "no");
    add("fastest, and two in three are wrong", 0.9, 0.1);
    run.rows.back().all.fraction = 2.0 / 3;
    markBest(run);
    std::string best;
    for (const StudyRow& each : run.rows) best += each.best ? '*' : '.';
    EXPECT_EQ(best, "**..*..");
}

// Who has the easier problem does not beat who has the harder one.
TEST(StudyData, best_is_judged_among_equal_problems) {
    StudyRun run;
    run.demo = run.renderer = "a name";
    run.problem = "far";
    const auto add = [&](const std::string& far, double error, double ms, double mad = 0) {
        StudyRow each;
        each.settings = {{"far", far}};
        each.all.rms = error;
        each.msMedian = ms;
        each.msMad = mad;
        each.rounds = 7;
        run.rows.push_back(each);
    };
    add("100", 0.1, 1);
    add("1e4", 0.2, 2);
    add("10000", 0.3, 3);  // the same problem as 1e4, and worse
    add("1e6", 0.4, 4);
    add("1e6", 0.5, 3.9);         // faster, but by less than
    run.rows.back().msMad = 0.2;  // what its own time is known to
    add("1e6", 0.5, 3.7);
    markBest(run);
    std::string best;
    for (const StudyRow& each : run.rows) best += each.best ? '*' : '.';
    EXPECT_EQ(best, "**.*.*");
    run.problem.clear();
    markBest(run);
    EXPECT_TRUE(run.rows[0].best);
    EXPECT_FALSE(run.rows[1].best) << "of one problem the first beats them all";
    EXPECT_EQ(readStudy(studyCsv(run)).problem, "");
    run.problem = "far";
    EXPECT_EQ(readStudy(studyCsv(run)).problem, "far");
    for (const ErrorAxis axis : {ErrorAxis::rms, ErrorAxis::fraction, ErrorAxis::max}) {
        run.axis = axis;
        EXPECT_EQ(readStudy(studyCsv(run)).axis, axis);
    }
}

// A committed row is judged as the declaration has it, and as it is judged today.
TEST(StudyData, committed_rows_are_judged_among_equal_problems) {
    int studies = 0;
    for (const DemoInfo& info : catalogue()) {
        const auto committed = committedStudy(info.name);
        if (!committed) continue;
        ++studies;
        EXPECT_EQ(committed->problem, info.study.value().problem) << info.name;
        if (!committed->problem.empty()) {
            EXPECT_NO_THROW(info.make()->knob(committed->problem)) << info.name;
        }
        StudyRun again = *committed;
        markBest(again);
        for (std::size_t i = 0; i < again.rows.size(); ++i) {
            const StudyRow& each = again.rows[i];
            EXPECT_EQ(committed->rows[i].best, each.best) << info.name << " " << each.method << " " << each.parameter;
        }
    }
    EXPECT_GT(studies, 0);
}

TEST(StudyData, csv_reads_back) {
    StudyRun run = stepRun();
    run.note = "as it was";
    run.rows[0].method = "a, \"quoted\" # one";
    run.referenceErrors = {{"line", 0.25}, {"", 1e-9}};
    const std::string text = studyCsv(run);
    const StudyRun again = readStudy(text);
    EXPECT_EQ(studyCsv(again), text);
    EXPECT_EQ(again.note, run.note);
    EXPECT_EQ(again.referenceErrors, run.referenceErrors);
    ASSERT_EQ(again.rows.size(), run.rows.size());
    for (std::size_t i = 0; i < run.rows.size(); ++i) {
        EXPECT_EQ(again.rows[i].method, run.rows[i].method);
        EXPECT_EQ(again.rows[i].knob, run.rows[i].knob);
        EXPECT_EQ(again.rows[i].parameter, run.rows[i].parameter);
        EXPECT_EQ(again.rows[i].status, run.rows[i].status);
        EXPECT_EQ(again.rows[i].counts, run.rows[i].counts);
        EXPECT_EQ(again.rows[i].settings.size(), run.rows[i].settings.size());
    }
    // As an editor of tables writes it.
    std::string windows;
    for (const char c : text) windows += c == '\n' ? "\r\n" : std::string(1, c);
    EXPECT_EQ(studyCsv(readStudy(windows)), text);
}

TEST(StudyData, what_is_no_study_is_refused) {
    const std::string text = studyCsv(stepRun());
    const auto problem = [](const std::string& wrong) -> std::string {
        try {
            readStudy(wrong);
            return "accepted";
        } catch (const Error& error) {
            return error.what();
        }
    };
    const auto replaced = [&](const std::string& part, const std::string& other) {
        std::string changed = text;
        return changed.replace(changed.find(part), part.size(), other);
    };
    const std::string rule = "study: must be the text of a study's CSV file of this version, ";
    EXPECT_EQ(problem(""), rule + "it has no table");
    EXPECT_EQ(problem("{}"), rule + "column 'scene' is not there");
    EXPECT_EQ(problem(replaced("# demo: ", "# name: ")), rule + "'# demo:' is missing");
    EXPECT_EQ(problem(replaced("# threads: ", "# threads: many")),
              rule + "'threads' is no number: 'many" + text.substr(text.find("# threads: ") + 11, 1) + "'");
    EXPECT_EQ(problem(replaced(",MAD,", ",mad,")), rule + "column 'MAD' is not there");
    EXPECT_EQ(problem(replaced(",cells,4,ok,", ",cells,ok,")).substr(0, rule.size() + 5), rule + "line ");
    EXPECT_EQ(problem(replaced(",cells,4,ok,", ",cells,4,ok,-")),
              "study: must have no times and errors below 0; see 'rms', -0.223607");
    EXPECT_EQ(problem(replaced("# error: fraction", "# error: least")), "axis: must be rms, fraction or max, least");
}

TEST(StudyData, csv_has_a_line_a_row) {
    const StudyRun run = stepRun();
    std::string csv = studyCsv(run);
    csv.erase(0, csv.find("\nscene,") + 1);
    EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')), run.rows.size() + 1);
    const auto columns = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
    const auto end = csv.find('\n');
    EXPECT_EQ(columns(csv.substr(0, end)), columns(csv.substr(end + 1, csv.find('\n', end + 1) - end - 1)));
}

TEST(StudyData, names_who_draws) {
    EXPECT_EQ(drawerOf("llvmpipe (LLVM 15.0.6, 256 bits)"), Drawer::processor);
    EXPECT_EQ(drawerOf("softpipe"), Drawer::processor);
    EXPECT_EQ(drawerOf("ANGLE (Google, Vulkan 1.3.0 (SwiftShader Device), SwiftShader driver)"), Drawer::processor);
    EXPECT_EQ(drawerOf("NVIDIA H100 80GB HBM3/PCIe/SSE2"), Drawer::gpu);
    EXPECT_EQ(drawerOf("AMD Radeon RX 6600 (radeonsi, navi23)"), Drawer::gpu);
    StudyRun run;
    run.width = 4;
    run.renderer = "llvmpipe (LLVM 15.0.6, 256 bits)";
    run.processor = "AMD EPYC";
    EXPECT_EQ(machineName(run), "a processor (llvmpipe)");
    run.renderer = "NVIDIA H100 80GB HBM3/PCIe/SSE2";
    EXPECT_EQ(machineName(run), "this GPU (NVIDIA H100 80GB HBM3)");
    run.width = 0;
    run.threads = 2;
    EXPECT_EQ(machineName(run), "AMD EPYC, 2 threads") << "no renderer computes values";
}

// Another machine has the rows of the first one, in their order; what a study has gained since that machine was had is not measured there.
TEST(StudyData, committed_studies_are_of_the_same_rows) {
    int ofGpu = 0;
    for (const DemoInfo& info : catalogue()) {
        const std::vector<StudyRun> runs = committedStudies(info.name);
        if (runs.empty()) continue;
        SCOPED_TRACE(info.name);
        EXPECT_EQ(drawerOf(runs[0].renderer), Drawer::processor);
        EXPECT_EQ(drawerOf(committedStudy(info.name)->renderer), Drawer::processor);
        EXPECT_EQ(drawerOf(committedStudy(info.name, Drawer::gpu)->renderer), drawerOf(runs.back().renderer));
        for (const StudyRun& run : runs) {
            ofGpu += drawerOf(run.renderer) == Drawer::gpu;
            EXPECT_EQ(run.demo, info.name);
            auto next = runs[0].rows.begin();
            for (const StudyRow& row : run.rows) {
                next = std::find_if(next, runs[0].rows.end(), [&](const StudyRow& other) {
                    return other.scene == row.scene && other.method == row.method && other.parameter == row.parameter;
                });
                ASSERT_NE(next, runs[0].rows.end()) << row.scene << ", " << row.method << " " << row.parameter;
                ++next;
            }
        }
    }
    EXPECT_EQ(ofGpu, 25);
}

TEST(StudyPlot, is_an_svg_with_every_method) {
    const StudyRun run = stepRun({.rounds = 2, .timed = true});
    const std::string svg = studySvg(run);
    EXPECT_EQ(svg.rfind("<svg ", 0), 0U);
    for (std::size_t i = 0; i < run.rows.size(); ++i) {
        const bool isThere = svg.find("data-row=\"" + std::to_string(i) + "\"") != std::string::npos;
        EXPECT_EQ(isThere, isPlotted(run.rows[i])) << i;
    }
    for (const char* word : {"cells", "broken", "Pareto-best", "the line itself"}) {
        EXPECT_NE(svg.find(word), std::string::npos) << word;
    }
    StudyRun empty = run;
    for (StudyRow& each : empty.rows) each.status = "failed";
    EXPECT_THROW(studySvg(empty), Error);
}

// A committed study is a file that somebody sent: all of it is shown as it is, and nothing is taken for a mark.
TEST(StudyPlot, a_hostile_study_stays_text) {
    const std::string hostile =
        "x</text><script>alert('y')</script>\"' a,b # c\n<g data-row=\"0\">&amp; \t\r " + std::string("\0i", 2) + "j";
    StudyRun run;
    run.demo = "demo " + hostile;
    run.quantity = "quantity " + hostile;
    run.reference = "reference " + hostile;
    run.host = "host " + hostile;
    run.renderer = "renderer " + hostile;
    run.processor = "processor " + hostile;
    run.width = 4;
    for (const std::string& scene : {"scene " + hostile, "other " + hostile}) {
        run.referenceErrors.emplace_back(scene, 0.1);
        for (const char* parameter : {"1", "2", "3"}) {
            StudyRow each;
            each.scene = scene;
            each.method = "method " + hostile;
            each.parameter = parameter + hostile;
            each.all.rms = 1.0 / parameter[0];
            each.msMedian = parameter[0];
            each.rounds = 7;
            each.counts = {{"count " + hostile, 1}};
            run.rows.push_back(each);
        }
    }
    markBest(run);
    const std::string svg = studySvg(readStudy(studyCsv(run)));
    for (const char* word : {"demo", "quantity", "reference", "renderer", "processor", "scene", "other", "method"}) {
        EXPECT_NE(svg.find(std::string(word) + " x&lt;/text&gt;&lt;script&gt;alert"), std::string::npos) << word;
    }
    EXPECT_EQ(svg.find("<script"), std::string::npos);
    std::size_t groups = 0;
    for (auto at = svg.find("<g "); at != std::string::npos; at = svg.find("<g ", at + 1)) ++groups;
    EXPECT_EQ(groups, run.rows.size()) << "one a point, and none of the texts'";
    EXPECT_NE(svg.find("&amp;amp;"), std::string::npos);
}

TEST(Vary, makes_a_study_by_hand) {
    const DemoInfo made = infoOf<Step>("step", stepStudy());
    const auto values = [&](const std::string& vary) { return studyOf(made, {}, vary).lines.at(0).values; };
    EXPECT_EQ(values("cells=1,2,5"), (std::vector<std::string>{"1", "2", "5"}));
    EXPECT_EQ(values("cells=4..4096:6"), (std::vector<std::string>{"4", "16", "64", "256", "1024", "4096"}));
    EXPECT_EQ(values("cells=1..3:9"), (std::vector<std::string>{"1", "2", "3"})) << "whole, and each once";
    EXPECT_EQ(values("broken=on,off"), (std::vector<std::string>{"on", "off"}));
    for (const char* wrong :
         {"cells", "cells=", "=3", "cells=0,1", "cells=1..5:1", "cells=1..x:3", "cell=1,2", "cells=1..9999:3"}) {
        EXPECT_THROW(studyOf(made, {}, wrong), Error) << wrong;
    }
    EXPECT_THROW(studyOf(infoOf<Step>("step", stepStudy()), {{"cells", "0"}}, "cells=1,2"), Error);
    DemoInfo without = made;
    without.study.reset();
    EXPECT_THROW(studyOf(without, {}, ""), Error);
}

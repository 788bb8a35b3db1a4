// Demos for the tests of the window: one with every kind of knob, that moves, one that cannot be opened, and one with a
// study.
//
// PROBE_SHADERS names a folder with probe.vert and probe.frag to read and watch, so that a test edits files of its own.
// PROBE_HOLD names a file: as long as it is there, the study goes on.
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <new>
#include <string>
#include <thread>

#include "../support/demo_of.h"
#include "mv/gl/gl.h"
#include "mv/gl/object.h"
#include "mv/gl/shader_source.h"
#include "mv/study/data.h"

using namespace mv;
using namespace mv::test;

namespace {

std::string watched(const std::string& name) {
    const char* folder = std::getenv("PROBE_SHADERS");
    return folder ? std::string(folder) + "/" + name : "";
}

const bool vertexAdded = addShaderFile("probe.vert", R"(
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(corner - 0.5, 0.0, 1.0);
}
)",
                                       watched("probe.vert"));
const bool fragmentAdded = addShaderFile("probe.frag", R"(
uniform float level;
out vec4 fragColor;
void main() { fragColor = vec4(level, 0.5, 0.5, 1.0); }
)",
                                         watched("probe.frag"));

enum class Mood { calm, loud, exhausted };

struct Settings {
    double level = 0.25;
    int count = 3;
    bool note = false;
    Mood mood = Mood::calm;
    double angle = 0;
};

struct Probe final : DemoOf<Settings> {
    Readout shown{this, "shown", "the frame that is shown"};
    Readout never{this, "never", "what no setting measures", "px"};

    Program program;
    VertexArray vertexArray;

    Probe()
        : DemoOf(together(mv::number("level", &Settings::level, {0, 1},
                                     "how red the square is; 1 is refused together with mood loud"),
                          whole("count", &Settings::count, {1, 9}, "a whole number", "pieces"),
                          toggle("note", &Settings::note, "say a sentence about the picture"),
                          mv::word("mood", &Settings::mood,
                                   {{"calm", "nothing is refused and the picture is as it is"},
                                    {"loud", "a level of 1 is refused"},
                                    {"exhausted", "for a count of 4 there is no memory"}},
                                   "what is refused"),
                          mv::angle("angle", &Settings::angle, "an angle that turns on"))) {
        addControl(keySets(key('4'), "count", "4"));
        addControl(keys(key('N'), key('S'), "level", 0.125));  // S is the window's own key for saving, too
        addControl(mv::drag("angle", 1, "level", 0.001));
    }

    void init() override {
        program = Program("probe");
        vertexArray = makeVertexArray();
    }
    void check() const override {
        if (s.mood == Mood::loud && s.level == 1) throw Error("--level", "must be less than 1 while --mood is loud");
    }
    void draw(const Frame& frame) override {
        if (s.mood == Mood::exhausted && s.count == 4) throw std::bad_alloc();
        glClearColor(0.2F, 0.3F, static_cast<float>(frame.index() % 60) / 60, 1);
        glClear(GL_COLOR_BUFFER_BIT);
        program.use();
        program.set("level", s.level);
        glBindVertexArray(vertexArray.id());
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
        glBindVertexArray(0);
        // Left on: the window must not show half of a picture for it.
        glEnable(GL_SCISSOR_TEST);
        glScissor(0, 0, frame.width() / 2, frame.height() / 2);
        glColorMask(GL_FALSE, GL_TRUE, GL_FALSE, GL_TRUE);
        frame.show("screenFromFrame", mat4(double(frame.index())));
        if (s.note) frame.say("This sentence is beside the picture because --note is on.");
        shown = frame.index();
    }
};

struct Broken final : DemoOf<Settings> {
    void init() override { throw Error("broken", "must never open; that is what it is for"); }
};

enum class Function { exponential, root };
enum class Rule { trapezia, simpson, exact };

// The integral over 0 .. 1 of e^x, or of the square root of x, from n strips.
struct Strips {
    Function function = Function::exponential;
    Rule rule = Rule::trapezia;
    int n = 4;
    double level = 0.5;
};
struct Integral final : DemoOf<Strips> {
    Integral()
        : DemoOf(together(
              mv::word("function", &Strips::function, {{"exp"}, {"root"}}, "what is integrated"),
              mv::word("rule", &Strips::rule, {{"trapezia"}, {"simpson"}, {"exact"}}, "how; simpson needs an even n"),
              whole("n", &Strips::n, {1, 100000}, "strips"),
              mv::number("level", &Strips::level, {0, 1}, "the picture's grey, which the study does not look at"))) {}

    void draw(const Frame&) override {
        const auto grey = static_cast<float>(s.level);
        glClearColor(grey, grey, grey, 1);
        glClear(GL_COLOR_BUFFER_BIT);
    }
    double at(double x) const { return s.function == Function::exponential ? std::exp(x) : std::sqrt(x); }
    double right() const { return s.function == Function::exponential ? std::exp(1.0) - 1 : 2.0 / 3; }
    std::vector<double> values() const override {
        if (s.rule == Rule::exact) return {right()};
        if (s.rule == Rule::simpson && s.n % 2 == 1) throw Error("--n", "must be even for simpson");
        double sum = at(0) + at(1);
        for (int i = 1; i < s.n; ++i) sum += at(double(i) / s.n) * (s.rule == Rule::simpson ? (i % 2 == 1 ? 4 : 2) : 2);
        return {sum / s.n / (s.rule == Rule::simpson ? 3 : 2)};
    }
    Reference reference(const std::function<void(double)>& progress) const {
        const char* hold = std::getenv("PROBE_HOLD");
        for (double done = 0; hold && std::filesystem::exists(hold); done += (1 - done) / 100) {
            progress(done);
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
        }
        return {.values = {right()}};
    }
};

Study integralStudy() {
    Study study;
    study.quantity = "the integral";
    study.reference = "in closed form";
    study.makeReference = [](const Demo& demo, const ReferenceFrame&, const auto& progress) {
        return dynamic_cast<const Integral&>(demo).reference(progress);
    };
    study.scenes = {{"exp", {{"function", "exp"}}}, {"root", {{"function", "root"}}}};
    study.lines = {{"trapezia", {{"rule", "trapezia"}}, "n", {"4", "16", "64", "256"}},
                   {"simpson", {{"rule", "simpson"}}, "n", {"4", "16", "64", "255"}},
                   {"exact", {{"rule", "exact"}}}};
    study.ofValues = true;
    return study;
}

// The measurements of a machine of long ago: errors as the rules have them, times as if each strip took a microsecond.
std::string committedIntegral() {
    const Study study = integralStudy();
    StudyRun run;
    run.demo = "integral";
    run.quantity = study.quantity;
    run.reference = study.reference;
    run.host = run.renderer = "no driver";
    run.processor = "a machine of long ago";
    run.threads = 1;
    for (const StudyScene& scene : study.scenes) {
        for (const StudyLine& line : study.lines) {
            for (const std::string& n : line.values.empty() ? std::vector<std::string>{""} : line.values) {
                StudyRow row;
                row.scene = scene.name;
                row.method = line.method;
                row.parameter = n;
                if (!n.empty()) row.knob = "n";
                row.settings = {{"function", scene.name}, {"rule", line.method}};
                if (!n.empty()) row.settings.push_back({"n", n});
                const double strips = n.empty() ? 10000 : std::stod(n);
                const double power = line.method == "simpson" ? -4 : -2;
                row.all.rms = row.all.max = n.empty() ? 0 : std::pow(strips, scene.name == "exp" ? power : -1.5) / 10;
                row.all.n = row.awayFromEdges.n = 1;
                row.awayFromEdges = row.all;
                row.msMedian = 1e-3 * strips * (line.method == "simpson" ? 1.1 : 1);
                row.msMad = row.msMedian / 50;
                row.rounds = 7;
                row.counts = {{"strips", strips}};
                if (n == "255") row.status = "--n: must be even for simpson";
                run.rows.push_back(row);
            }
        }
    }
    markBest(run);
    return studyCsv(run);
}

constexpr Declaration integralDeclaration{
    .name = "integral",
    .sentence = "A demo with a study of errors and times.",
    .lookFor = "",
    .chapter = "Shadows",
    .number = 99,
    .width = 400,
    .height = 300,
};
const bool integralAdded = addDemo(integralDeclaration, {}, "", [] { return std::make_unique<Integral>(); });
const bool studyAdded = addStudy("integral", integralStudy());
const bool studyFileAdded = addStudyFile("integral", committedIntegral());

constexpr Declaration probeDeclaration{
    .name = "probe",
    .sentence = "Every kind of knob, and a square whose background moves.",
    .lookFor = "The background goes from green to blue once a second.",
    .chapter = "Viewing and projection",
    .number = 1,
    .width = 400,
    .height = 300,
    .animated = true,
};
const bool probeAdded = addDemo(probeDeclaration, {}, "", [] { return std::make_unique<Probe>(); });

constexpr Declaration brokenDeclaration{
    .name = "broken",
    .sentence = "A demo that cannot be opened.",
    .lookFor = "",
    .chapter = "Viewing and projection",
    .number = 2,
};
const bool brokenAdded = addDemo(brokenDeclaration, {}, "", [] { return std::make_unique<Broken>(); });

}  // namespace

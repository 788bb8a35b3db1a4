#include "mv/study/study.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <thread>

#include "mv/image/file.h"
#include "mv/image/picture.h"
#include "mv/paper/tables.h"
#include "mv/run/render.h"
#include "mv/show/median.h"

namespace mv {

std::string nameOf(const StudyRow& row) {
    std::string name = row.scene.empty() ? row.method : row.scene + ", " + row.method;
    if (!row.parameter.empty()) name += " " + row.parameter;
    return name;
}

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::time_point from) {
    return std::chrono::duration<double, std::milli>(Clock::now() - from).count();
}

// ---- Errors

// The pixels where rounding decides what is seen: those that have a neighbour with another region or another value.
std::vector<bool> edgeBand(const Reference& reference, int columns, double wrongBeyond) {
    std::vector<bool> band(reference.values.size(), false);
    if (reference.regions.empty()) return band;
    const int width = reference.across > 0 ? reference.across : columns;
    const int height = static_cast<int>(band.size() / static_cast<std::size_t>(width));
    if (reference.regions.size() != band.size() ||
        band.size() != static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {
        throw Error("reference",
                    "must have whole rows of regions, one for each of its " + std::to_string(band.size()) + " values",
                    std::to_string(reference.regions.size()) + " in rows of " + std::to_string(width));
    }
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const std::size_t here = pixelIndex(x, y, width);
            for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v) {
                for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) {
                    const std::size_t there = pixelIndex(u, v, width);
                    if (reference.regions[here] != reference.regions[there] ||
                        std::abs(reference.values[here] - reference.values[there]) > wrongBeyond) {
                        band[here] = true;
                    }
                }
            }
        }
    }
    return band;
}

struct ErrorSum {
    double squares = 0, max = 0;
    long wrong = 0, n = 0;
    void add(double difference, bool isWrong) {
        squares += difference * difference;
        max = std::max(max, difference);
        wrong += isWrong ? 1 : 0;
        ++n;
    }
    StudyError result() const {
        if (n == 0) return {};
        return {std::sqrt(squares / double(n)), max, double(wrong) / double(n), n};
    }
};

// A value below this is no value: the target was cleared to -1.
constexpr double noValue = -0.5;

void measureErrors(StudyRow& row, const std::vector<double>& values, const Reference& reference,
                   const std::vector<bool>& band, const Study& study) {
    if (values.size() != reference.values.size()) {
        throw Error("study", "must have as many values as its reference, " + std::to_string(reference.values.size()),
                    std::to_string(values.size()));
    }
    const std::vector<double>& averages = reference.averages.empty() ? reference.values : reference.averages;
    ErrorSum all, awayFromEdges;
    long unmatchedAwayFromEdges = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (!std::isfinite(values[i])) throw Error("value " + std::to_string(i), "must be finite");
        const bool wanted = reference.regions.empty() || reference.regions[i] >= 0;
        const bool given = study.ofValues || values[i] > noValue;
        if (wanted != given) {
            ++row.unmatched;
            if (!band[i]) ++unmatchedAwayFromEdges;
        }
        if (!wanted || !given) continue;
        const double difference = std::abs(values[i] - averages[i]);
        const bool wrong = std::abs(values[i] - reference.values[i]) > study.wrongBeyond;
        all.add(difference, wrong);
        if (!band[i]) awayFromEdges.add(difference, wrong);
    }
    row.all = all.result();
    row.awayFromEdges = awayFromEdges.result();
    if (all.n == 0) throw Error("study", "must have values to compare, and has none");
    if (unmatchedAwayFromEdges > 0) {
        throw Error("study",
                    "must draw its quantity in the pixels that the reference counts; away from edges these differ",
                    std::to_string(unmatchedAwayFromEdges));
    }
}

// ---- Settings

std::vector<KnobSetting> presentSettings(const Demo& demo) {
    std::vector<KnobSetting> settings;
    for (const Knob* knob : demo.knobs()) settings.push_back({knob->name(), knob->text()});
    return settings;
}

std::vector<StudyRow> rowsOf(const Study& study) {
    std::vector<StudyRow> rows;
    for (const StudyScene& scene : study.scenes) {
        for (const StudyLine& line : study.lines) {
            const bool here = line.scenes.empty() ||
                              std::find(line.scenes.begin(), line.scenes.end(), scene.name) != line.scenes.end();
            if (!here) continue;
            StudyRow row;
            row.scene = scene.name;
            row.method = line.method;
            row.settings = scene.settings;
            row.settings.insert(row.settings.end(), line.settings.begin(), line.settings.end());
            if (line.knob.empty()) {
                rows.push_back(row);
                continue;
            }
            for (const std::string& value : line.values) {
                rows.push_back(row);
                rows.back().knob = line.knob;
                rows.back().parameter = value;
                rows.back().settings.push_back({line.knob, value});
            }
        }
    }
    return rows;
}

// ---- Progress: a line at most twice a second

class Teller {
  public:
    explicit Teller(const StudyOptions& options) : tell_(options.progress) {}
    void operator()(const std::string& line) {
        if (!tell_ || milliseconds(last_) < 500) return;
        last_ = Clock::now();
        tell_(line);
    }

  private:
    std::function<void(const std::string&)> tell_;
    Clock::time_point last_ = Clock::now();
};

// ---- What is right

// A reference, and the knobs that it was made of: where they have these values, whatever the others have, it is the same.
struct KnownReference {
    Reference reference;
    std::vector<bool> band;
    std::vector<KnobSetting> madeOf;

    bool holds(const Demo& demo) const {
        return std::all_of(madeOf.begin(), madeOf.end(),
                           [&](const KnobSetting& setting) { return demo.knob(setting.name).text() == setting.text; });
    }
};

// For the present settings. Error: they make no picture, or the demo cannot make a reference of them.
KnownReference referenceHere(const Demo& demo, const Study& study, bool ownError,
                             const std::function<void(double part)>& progress) {
    if (!study.makeReference) throw Error("study", "must say how its reference is made (Study::makeReference)");
    if (!study.ofValues) demo.check();  // as before each picture; values need none
    KnownReference known;
    known.reference =
        study.makeReference(demo, {FrameInfo(study.frame, study.width, study.height), ownError}, progress);
    for (const Knob* knob : demo.knobs()) {
        if (study.reads.empty()) known.madeOf.push_back({knob->name(), knob->text()});
    }
    for (const std::string& name : study.reads) known.madeOf.push_back({name, demo.word(name)});
    const std::size_t pixels = static_cast<std::size_t>(study.width) * static_cast<std::size_t>(study.height);
    if (!study.ofValues && known.reference.values.size() != pixels) {
        throw Error("reference", "must have a value for each pixel", std::to_string(known.reference.values.size()));
    }
    known.band = edgeBand(known.reference, study.width, study.wrongBeyond);
    return known;
}

// ---- One row

std::vector<double> measuredValues(Stage& stage, const Study& study) {
    if (study.ofValues) return stage.demo().values();
    const std::vector<float> pixels = stage.measure(study.frame);
    return {pixels.begin(), pixels.end()};
}

// The cost of the frame in numbers that do not depend on the machine.
void countWork(Stage& stage, const Study& study, StudyRow& row) {
    if (study.ofValues) {
        row.counts = stage.demo().valueCounts();
        return;
    }
    GLuint query = 0, samples = 0;
    glGenQueries(1, &query);
    glBeginQuery(GL_SAMPLES_PASSED, query);
    stage.draw(study.frame);
    glEndQuery(GL_SAMPLES_PASSED);
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &samples);
    glDeleteQueries(1, &query);
    const Counters& counters = stage.frameCounters();
    row.counts = {{"draws", double(counters.draws)},
                  {"triangles", double(counters.triangles)},
                  {"fragments", double(samples)},
                  {"passes", double(counters.passes)}};
    row.counts.insert(row.counts.end(), stage.notes().counts.begin(), stage.notes().counts.end());
}

// A scene with several references is known as well as the worst of them.
void noteOwnError(StudyRun& run, const std::string& scene, double error) {
    for (auto& [name, worst] : run.referenceErrors) {
        if (name != scene) continue;
        worst = std::max(worst, error);
        return;
    }
    run.referenceErrors.emplace_back(scene, error);
}

// A frame that takes this long does not notice what the last setting left in the caches.
constexpr double slowMs = 300;

double timedMs(Stage& stage, const Study& study, double lastMs) {
    if (study.ofValues) {
        stage.demo().values();
        constexpr int enough = 1000;  // in so many any clock has moved, but for one that stands still
        int repeats = 0;
        const auto start = Clock::now();
        do {
            stage.demo().values();
            ++repeats;
            if (repeats == enough && milliseconds(start) <= 0)
                throw Error("clock", "must not stand still while something is timed");
        } while (milliseconds(start) < 2);
        return milliseconds(start) / repeats;
    }
    if (lastMs < slowMs) {
        stage.draw(study.frame);
        glFinish();
    }
    const auto start = Clock::now();
    stage.draw(study.frame);
    glFinish();
    return milliseconds(start);
}

// Sets the times of these rows, round by round, so that what else the machine does falls on all of them. No round begins
// that would end after the time allowed, but for the first. `prepare` has the row's settings taken; rounds count from 1.
void timeRows(Stage& stage, const Study& study, const std::vector<StudyRow*>& rows, const StudyOptions& options,
              const std::function<void(const StudyRow& row, int round)>& prepare) {
    std::vector<std::vector<double>> times(rows.size());
    const auto start = Clock::now();
    int rounds = 0;
    // As long as a round takes on the average, once more.
    const auto fits = [&] { return milliseconds(start) * (rounds + 1) <= 1000 * options.seconds * rounds; };
    while (rounds < options.rounds && (rounds == 0 || fits())) {
        ++rounds;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            prepare(*rows[i], rounds);
            times[i].push_back(timedMs(stage, study, times[i].empty() ? 0 : times[i].back()));
        }
    }
    for (std::size_t i = 0; i < rows.size() && rounds > 0; ++i) {
        rows[i]->rounds = rounds;
        rows[i]->msMedian = median(times[i]);
        for (double& time : times[i]) time = std::abs(time - rows[i]->msMedian);
        rows[i]->msMad = median(times[i]);
    }
}

void nameMachine(StudyRun& run, const Stage& stage) {
    run.host = stage.driver().host;
    run.renderer = stage.driver().renderer;
    run.processor = processorName();
    run.threads = static_cast<int>(std::thread::hardware_concurrency());
}

}  // namespace

std::string processorName() {
    std::ifstream facts("/proc/cpuinfo");
    for (std::string line; std::getline(facts, line);) {
        const auto colon = line.find(": ");
        if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "processor not named by the system";
}

StudyRun runStudy(Stage& stage, const Study& study, const StudyOptions& options) {
    Demo& demo = stage.demo();
    const int width = stage.front().width(), height = stage.front().height();
    const std::vector<KnobSetting> before = presentSettings(demo);
    StudyRun run;
    run.demo = stage.info().name;
    run.quantity = study.quantity;
    run.reference = study.reference;
    run.axis = study.axis;
    run.problem = study.problem;
    run.wrongBeyond = study.wrongBeyond;
    run.width = study.ofValues ? 0 : study.width;  // numbers have no size
    run.height = study.ofValues ? 0 : study.height;
    run.frame = study.frame;
    nameMachine(run, stage);
    run.rows = rowsOf(study);
    for (StudyRow& row : run.rows) {
        if (options.wanted && !options.wanted(row)) row.status = notMeasured;
    }
    Teller tell(options);
    const auto steps =
        std::to_string(run.rows.size() * static_cast<std::size_t>(1 + (options.timed ? options.rounds : 0)));
    std::size_t step = 0;
    const auto at = [&](const std::string& what) {
        return "study " + std::to_string(step) + "/" + steps + ": " + what;
    };

    if (!study.ofValues) stage.resize(study.width, study.height);
    const auto apply = [&](const StudyRow& row) {
        applyKnobs(demo, before);
        applyKnobs(demo, row.settings);
    };
    // A reference at a time, since it may be large and slow: with it all rows that it is right for.
    std::vector<StudyRow*> left;
    for (StudyRow& row : run.rows) {
        if (row.ok()) left.push_back(&row);
    }
    while (!left.empty()) {
        StudyRow& first = *left.front();
        KnownReference known;
        try {
            apply(first);
            known = referenceHere(demo, study, options.timed, [&](double part) {
                tell(at("reference of " + nameOf(first) + " " + std::to_string(std::lround(100 * part)) + " %"));
            });
        } catch (const Error& error) {
            ++step;
            first.status = error.what();
            left.erase(left.begin());
            continue;
        }
        if (known.reference.ownError >= 0) noteOwnError(run, first.scene, known.reference.ownError);
        std::vector<StudyRow*> others;
        for (StudyRow* row : left) {
            apply(*row);
            if (!known.holds(demo)) {
                others.push_back(row);
                continue;
            }
            tell(at("errors of " + nameOf(*row)));
            ++step;
            try {
                measureErrors(*row, measuredValues(stage, study), known.reference, known.band, study);
                countWork(stage, study, *row);
            } catch (const Error& error) {
                row->status = error.what();
            }
        }
        left = std::move(others);
    }
    std::vector<StudyRow*> timed;
    for (StudyRow& row : run.rows) {
        if (options.timed && row.ok()) timed.push_back(&row);
    }
    timeRows(stage, study, timed, options, [&](const StudyRow& row, int round) {
        ++step;
        tell(at("round " + std::to_string(round) + ", " + nameOf(row)));
        apply(row);
    });
    markBest(run);
    applyKnobs(demo, before);
    stage.resize(width, height);
    return run;
}

namespace {

// ---- --vary

double numberOf(const std::string& text) {
    double value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    if (result.ec != std::errc() || result.ptr != text.data() + text.size() || !std::isfinite(value)) {
        throw UsageError("--vary", "must be KNOB=A..B:N or KNOB=a,b,c with numbers A, B and N", "'" + text + "'");
    }
    return value;
}

// N values from A to B: in equal ratios where both are positive, else in equal steps.
std::vector<std::string> valuesBetween(const std::string& text, bool whole) {
    const auto dots = text.find(".."), colon = text.rfind(':');
    const double low = numberOf(text.substr(0, dots));
    const double high = numberOf(text.substr(dots + 2, colon - dots - 2));
    const double count = numberOf(text.substr(colon + 1));
    if (count < 2 || count > 1000 || count != std::floor(count)) {
        throw UsageError("--vary", "must try 2 .. 1000 values", text.substr(colon + 1));
    }
    std::vector<std::string> values;
    for (int i = 0; i < static_cast<int>(count); ++i) {
        const double part = i / (count - 1);
        double value = low > 0 && high > 0 ? low * std::pow(high / low, part) : low + (high - low) * part;
        if (i + 1 == static_cast<int>(count)) value = high;
        char digits[32];
        std::snprintf(digits, sizeof digits, whole ? "%.0f" : "%.6g", value);
        if (values.empty() || values.back() != digits) values.emplace_back(digits);
    }
    return values;
}

std::vector<std::string> listed(const std::string& text) {
    std::vector<std::string> values;
    std::size_t from = 0;
    while (from <= text.size()) {
        const auto comma = std::min(text.find(',', from), text.size());
        values.push_back(text.substr(from, comma - from));
        from = comma + 1;
    }
    return values;
}

}  // namespace

Study studyOf(const DemoInfo& info, const std::vector<KnobSetting>& knobs, const std::string& vary) {
    if (!info.study) {
        throw Error(info.name,
                    "declares no study, so there is nothing that is right to compare with; those that do: see "
                    "docs/errors-and-times");
    }
    Study study = *info.study;
    if (vary.empty()) return study;
    const Varied varied = variedBy(info, knobs, vary);
    study.scenes = {{"as set", {}}};
    study.lines = {{.method = varied.knob, .settings = {}, .knob = varied.knob, .values = varied.values}};
    study.says.clear();
    return study;
}

Varied variedBy(const DemoInfo& info, const std::vector<KnobSetting>& knobs, const std::string& vary) {
    const auto equals = vary.find('=');
    if (equals == std::string::npos || equals == 0 || equals + 1 == vary.size()) {
        throw UsageError("--vary", "must be KNOB=A..B:N or KNOB=a,b,c", "'" + vary + "'");
    }
    const std::string name = vary.substr(0, equals), text = vary.substr(equals + 1);
    const auto demo = info.make();
    applyKnobs(*demo, knobs);
    Knob& knob = demo->knob(name);
    const bool range = text.find("..") != std::string::npos && text.rfind(':') != std::string::npos;
    Varied varied{name, range ? valuesBetween(text, knob.kind() == Knob::Kind::whole) : listed(text)};
    for (const std::string& value : varied.values) knob.parse(value);  // refused before anything is drawn
    return varied;
}

// Those that were not there, the innermost first.
static std::vector<std::filesystem::path> makeFolder(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> made;
    std::error_code failure;
    for (std::filesystem::path path = folder; !path.empty() && !std::filesystem::exists(path, failure);
         path = path.parent_path())
        made.push_back(path);
    std::filesystem::create_directories(folder, failure);
    if (failure) throw Error(folder.string(), "could not be made", failure.message());
    return made;
}

void study(const Command& command) {
    const DemoInfo& info = *command.demo;
    Study wanted = studyOf(info, command.knobs, command.vary);
    if (command.width) wanted.width = command.width;
    if (command.height) wanted.height = command.height;
    if (command.frameGiven) wanted.frame = command.firstFrame;
    // Ask before what takes minutes whether there is a place for it. Who ends the study meanwhile finds nothing left.
    const std::vector<std::filesystem::path> made = makeFolder(command.folder);
    for (const char* file : {"/study.csv", "/study.json", "/study.svg"}) requireWritable(command.folder + file);
    for (const std::filesystem::path& folder : made) std::filesystem::remove(folder);

    HeadlessStage headless(command.host);
    headless.stage.open(info, wanted.width, wanted.height);
    applyKnobs(headless.stage.demo(), command.knobs);
    StudyOptions options;
    options.progress = [](const std::string& line) { std::cerr << line << std::endl; };
    const StudyRun run = runStudy(headless.stage, wanted, options);
    headless.stage.close();

    std::cout << studyTable(run) << std::flush;
    if (!std::cout) throw Error("standard output", "could not be written");
    makeFolder(command.folder);
    writeFileAtomically(command.folder + "/study.csv", std::string_view(studyCsv(run)));
    const bool anyOk = std::any_of(run.rows.begin(), run.rows.end(), [](const StudyRow& row) { return row.ok(); });
    if (!anyOk) throw Error(info.name, "must have a setting that can be measured; the reasons are in the table above");
    writeFileAtomically(command.folder + "/study.svg", std::string_view(studySvg(run)));
    std::cerr << "written: study.csv and study.svg in " << command.folder << "\n";
}

}  // namespace mv

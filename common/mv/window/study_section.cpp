#include "mv/window/study_section.h"

#include <algorithm>
#include <charconv>
#include <iostream>
#include <set>
#include <string>

#include "mv/show/caught.h"
#include "mv/show/stage.h"
#include "mv/study/study.h"
#include "mv/window/study_view.h"

namespace mv {
namespace {

constexpr std::size_t largestStudy = 64U << 20;  // bytes of its file

// "study 12/60: doing this" -> 12, 60
std::optional<std::pair<int, int>> stepOf(const std::string& line) {
    const std::string start = "study ";
    if (!line.starts_with(start)) return {};
    std::pair<int, int> step;
    const char* end = line.data() + line.size();
    const auto first = std::from_chars(line.data() + start.size(), end, step.first);
    if (first.ec != std::errc() || first.ptr == end || *first.ptr != '/') return {};
    const auto second = std::from_chars(first.ptr + 1, end, step.second);
    if (second.ec != std::errc() || step.second < 1 || step.first < 0) return {};
    return step;
}

}  // namespace

StudySection::StudySection(const DemoInfo& info, Gui& gui, const std::string& renderer) : info_(info), gui_(gui) {
    try {
        runs_ = committedStudies(info.name);
        std::size_t first = 0;
        for (std::size_t i = 0; i < runs_.size(); ++i) {
            if (runs_[i].width > 0 && drawerOf(runs_[i].renderer) == drawerOf(renderer)) first = i;
        }
        if (!runs_.empty()) show(first);
    } catch (const std::exception&) {
        problem_ = caughtSentence("study");
    }
}

void StudySection::show(std::size_t run) {
    run_ = run;
    scenes_ = scenesOf(shown());
    if (scene_ >= scenes_.size()) scene_ = 0;
    settings_.clear();
    const auto demo = info_.make();
    std::set<std::string> names;
    for (const StudyRow& row : shown().rows)
        for (const KnobSetting& setting : row.settings) names.insert(setting.name);
    for (const StudyRow& row : shown().rows) {
        auto& settings = settings_.emplace_back(row.settings);
        try {
            // What another row sets, and this one does not, was as it opens
            for (const std::string& name : names) {
                demo->knob(name).reset();
                if (std::ranges::find(row.settings, name, &KnobSetting::name) == row.settings.end())
                    settings->push_back({name, demo->knob(name).text()});
            }
            applyKnobs(*demo, *settings);
            for (KnobSetting& setting : *settings) setting.text = demo->knob(setting.name).text();
        } catch (const Error&) {
            settings.reset();  // a study older than the knobs; the click on it says so
        }
    }
}

// ---- Measuring

void StudySection::start() {
    problem_.clear();
    try {
        measurement_.emplace(info_.name);
    } catch (const std::exception&) {
        measurement_.reset();
        problem_ = caughtSentence("study");
    }
}

bool StudySection::advance() {
    if (!measurement_) return false;
    const std::optional<int> ended =
        measurement_->child.status();  // first: what it wrote before it ended is there then
    const std::vector<std::string> lines = measurement_->child.takeLines();
    for (const std::string& line : lines) {
        if (const auto step = stepOf(line)) {
            measurement_->done = std::min(1.0, double(step->first) / step->second);
            measurement_->steps = std::to_string(step->first) + " of " + std::to_string(step->second);
            measurement_->doing = line.substr(std::min(line.find(": "), line.size() - 2) + 2);
        } else if (line.starts_with("error: ")) {
            measurement_->problem = line.substr(7);
        } else if (line.starts_with("note: ")) {
            std::cerr << line << std::endl;  // the terminal has these, as without a window
        }
    }
    if (ended) finish(*ended);
    return ended || !lines.empty();
}

void StudySection::finish(int status) {
    const auto file = measurement_->folder.path() / "study.csv";
    problem_ = measurement_->problem;
    if (problem_.empty() && status != 0) problem_ = "the measurement ended with status " + std::to_string(status);
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored)) {
        try {
            StudyRun run = readStudy(readTextFile(file, largestStudy));
            if (measured_) runs_.pop_back();
            runs_.push_back(std::move(run));
            measured_ = true;
            show(runs_.size() - 1);
        } catch (const std::exception&) {
            problem_ = caughtSentence("study");
        }
    }
    measurement_.reset();
}

void StudySection::showMeasurement() {
    const float width = ImGui::GetContentRegionAvail().x;
    if (!measurement_) {
        if (info_.study && button("Measure here", {width, 0})) start();
        tooltip("runs the study on this machine, in a program of its own without a window");
        if (!problem_.empty()) wrapped(color::error, problem_);
        return;
    }
    const float cancel = ImGui::CalcTextSize("Cancel").x + 2 * ImGui::GetStyle().FramePadding.x;
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    ImGui::ProgressBar(static_cast<float>(measurement_->done), {width - cancel - ImGui::GetStyle().ItemSpacing.x, 0},
                       measurement_->steps.empty() ? "starting" : measurement_->steps.c_str());
    ImGui::PopStyleColor();
    ImGui::SameLine();
    const bool stop = button("Cancel");
    if (!measurement_->doing.empty()) wrapped(color::dim, measurement_->doing);
    if (info_.animated) wrapped(color::dim, "Time stands still here meanwhile, not to disturb it.");
    if (stop) measurement_.reset();
}

// ---- The plot

std::optional<std::size_t> StudySection::rowHere(const Demo& demo) const {
    if (runs_.empty() || scenes_.empty()) return std::nullopt;
    for (std::size_t i = 0; i < shown().rows.size(); ++i) {
        if (shown().rows[i].scene != scenes_[scene_] || !settings_[i]) continue;
        const bool same = std::all_of(settings_[i]->begin(), settings_[i]->end(), [&](const KnobSetting& setting) {
            return demo.knob(setting.name).text() == setting.text;
        });
        if (same) return i;
    }
    return std::nullopt;
}

std::string StudySection::origin() const {
    if (runs_.empty()) return "";
    return (isMeasuredHere(run_) ? "Measured here: " : "Committed, measured on: ") + machineText(shown()) + ".";
}

// The scene to begin with: that of the present settings.
void StudySection::findScene(const Demo& demo) {
    sceneFound_ = true;
    for (scene_ = 0; scene_ < scenes_.size(); ++scene_) {
        if (rowHere(demo)) return;
    }
    scene_ = 0;
}

std::string StudySection::here(const Demo& demo) const {
    const auto row = rowHere(demo);
    return row ? rowName(shown().rows[*row]) : "";
}

// The rows of the shown scene that compete for the present problem; none where the study has not that problem, which a click
// on an axis says.
std::vector<std::size_t> StudySection::choosable(const Demo& demo) const {
    try {
        return rowsOfProblem(shown(), scenes_[scene_], demo, "axis");
    } catch (const Error&) {
        return {};
    }
}

bool StudySection::take(Demo& demo, std::size_t row) {
    problem_.clear();
    if (settings_[row]) {
        applyKnobs(demo, *settings_[row]);
        return true;
    }
    problem_ = rowName(shown().rows[row]) + ": its settings are no longer what the knobs take";
    return false;
}

bool StudySection::choose(Demo& demo, const StudyBound& bound, const std::vector<std::size_t>& rows) {
    bound_ = bound;
    problem_.clear();
    try {
        if (rows.empty()) rowsOfProblem(shown(), scenes_[scene_], demo, "axis");  // says why there are none
    } catch (const Error& error) {
        problem_ = error.what();
        return false;
    }
    if (const auto chosen = rowWithin(shown(), rows, bound)) return take(demo, *chosen);
    const auto nearest = nearestTo(shown(), rows, bound);
    problem_ = "No setting keeps " + boundText(bound) +
               (nearest ? "; the nearest is " + rowSentence(shown(), shown().rows[*nearest]) : "");
    return false;
}

std::string StudySection::asked(const Demo& demo) const {
    if (!bound_ || runs_.empty() || scenes_.empty()) return "";
    const auto chosen = rowWithin(shown(), choosable(demo), *bound_);
    return std::string(bound_->of == StudyBound::Of::time ? "time " : "error ") + boundText(*bound_) + ": " +
           (chosen ? rowName(shown().rows[*chosen]) : "nothing");
}

void StudySection::chooseMachine() {
    const auto nameOfRun = [&](std::size_t i) {
        return isMeasuredHere(i) ? std::string("this machine, measured here") : machineName(runs_[i]);
    };
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    const bool open = ImGui::BeginCombo("##machine", ("On " + nameOfRun(run_)).c_str());
    if (!open) {
        notePlace("machine");
        return;
    }
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        if (ImGui::Selectable(nameOfRun(i).c_str(), i == run_)) show(i);
        notePlace("machine " + nameOfRun(i));
    }
    if (gui_.wantsPopupClosed()) ImGui::CloseCurrentPopup();
    ImGui::EndCombo();
}

void StudySection::chooseScene() {
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    const bool open = ImGui::BeginCombo("##scene", ("Scene: " + scenes_[scene_]).c_str());
    if (!open) {
        notePlace("plot scene");
        return;
    }
    for (std::size_t i = 0; i < scenes_.size(); ++i) {
        if (ImGui::Selectable(scenes_[i].c_str(), i == scene_)) scene_ = i;
        notePlace("plot scene " + scenes_[i]);
    }
    if (gui_.wantsPopupClosed()) ImGui::CloseCurrentPopup();
    ImGui::EndCombo();
}

void StudySection::showWords(const Demo& demo, std::optional<std::size_t> here) const {
    if (here) {
        const std::string others = measuredOtherwise(shown().rows[*here], demo);
        if (!others.empty()) wrapped(color::note, "Here, but measured with other values of " + others + ".");
    }
    for (const StudyRow& row : shown().rows) {
        if (row.scene == scenes_[scene_] && !row.ok()) wrapped(color::error, rowName(row) + ": " + row.status);
    }
    wrapped(color::dim, "Of: " + shown().quantity + ". Reference: " + referenceText(shown()) + ".");
    wrapped(isMeasuredHere(run_) ? color::note : color::dim, origin());
}

bool StudySection::show(Demo& demo) {
    bool moved = false;
    if (!runs_.empty() && !scenes_.empty()) {
        if (!sceneFound_) findScene(demo);
        if (runs_.size() > 1) chooseMachine();
        if (scenes_.size() > 1) chooseScene();
        const auto here = rowHere(demo);
        StudyPlotMarks marks{.here = here, .bound = bound_, .rows = choosable(demo)};
        if (bound_) marks.chosen = rowWithin(shown(), marks.rows, *bound_);
        const StudyPlotClick click = showStudyPlot(shown(), scenes_[scene_], marks, gui_.scale());
        if (click.bound) moved = choose(demo, *click.bound, marks.rows);
        if (click.row) {
            bound_.reset();
            moved = take(demo, *click.row);
        }
        showWords(demo, here);
    }
    showMeasurement();
    return moved;
}

}  // namespace mv

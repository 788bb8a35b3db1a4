#include "mv/run/study_choice.h"

#include <algorithm>
#include <tuple>

#include "mv/run/command_line.h"
#include "mv/run/copyable.h"
#include "mv/run/study.h"
#include "mv/run/words.h"

namespace mv {
namespace {

// The settings as the demo's knobs write them, so that "1e4" and "10000" are one. Nothing where a knob refuses its value:
// the study is older than the knobs.
std::optional<std::vector<KnobSetting>> asKnobsHave(const DemoInfo& info, std::vector<KnobSetting> settings) {
    const auto demo = info.make();
    try {
        applyKnobs(*demo, settings);
        for (KnobSetting& setting : settings) setting.text = demo->knob(setting.name).text();
    } catch (const Error&) {
        return {};
    }
    return settings;
}

const KnobSetting* find(const std::vector<KnobSetting>& settings, const std::string& name) {
    const auto found = std::find_if(settings.rbegin(), settings.rend(),
                                    [&](const KnobSetting& setting) { return setting.name == name; });
    return found == settings.rend() ? nullptr : &*found;
}

// The settings in `given` that the other settings have otherwise.
std::vector<KnobSetting> contradictions(const std::vector<KnobSetting>& given,
                                        const std::vector<KnobSetting>& settings) {
    std::vector<KnobSetting> against;
    for (const KnobSetting& setting : given) {
        const KnobSetting* other = find(settings, setting.name);
        if (other && other->text != setting.text) against.push_back(setting);
    }
    return against;
}

std::string flags(const std::vector<KnobSetting>& settings) {
    std::string text;
    for (const KnobSetting& setting : settings) {
        text += (text.empty() ? "--" : " --") + setting.name + " " + quotedForShell(setting.text);
    }
    return text;
}

bool anyRowSets(const StudyRun& run, const std::string& scene, const std::string& knob) {
    return std::any_of(run.rows.begin(), run.rows.end(),
                       [&](const StudyRow& row) { return row.scene == scene && find(row.settings, knob); });
}

struct SceneChoice {
    std::string name;
    std::vector<KnobSetting> settings;  // what tells it from the other scenes
};

// What all rows of a scene set alike is the scene's own; what all scenes set alike tells none from the others. A knob that
// only other scenes set has its initial value in this one.
std::vector<SceneChoice> scenesIn(const StudyRun& run, const DemoInfo& info) {
    std::vector<SceneChoice> scenes;
    for (const std::string& name : scenesOf(run)) {
        std::optional<std::vector<KnobSetting>> common;
        for (const StudyRow& row : run.rows) {
            if (row.scene != name) continue;
            const auto settings = asKnobsHave(info, row.settings);
            if (!settings) continue;
            if (!common) {
                common = settings;
                continue;
            }
            std::erase_if(*common, [&](const KnobSetting& setting) {
                const KnobSetting* other = find(*settings, setting.name);
                return !other || other->text != setting.text;
            });
        }
        if (common) scenes.push_back({name, *common});
    }
    std::vector<KnobSetting> initial;
    const auto demo = info.make();
    for (const SceneChoice& scene : scenes) {
        for (const KnobSetting& setting : scene.settings) {
            // Of a row, not of a scene: what moves along a line or is a method's in another scene
            const bool ofEach = std::all_of(scenes.begin(), scenes.end(), [&](const SceneChoice& other) {
                return find(other.settings, setting.name) != nullptr || !anyRowSets(run, other.name, setting.name);
            });
            if (ofEach && !find(initial, setting.name)) {
                initial.push_back({setting.name, demo->knob(setting.name).initialText()});
            }
        }
    }
    for (SceneChoice& scene : scenes) {
        std::vector<KnobSetting> completed;
        for (const KnobSetting& setting : initial) {
            const KnobSetting* own = find(scene.settings, setting.name);
            completed.push_back(own ? *own : setting);
        }
        scene.settings = std::move(completed);
    }
    const std::vector<SceneChoice> all = scenes;
    for (SceneChoice& scene : scenes) {
        std::erase_if(scene.settings, [&](const KnobSetting& setting) {
            return std::all_of(all.begin(), all.end(), [&](const SceneChoice& other) {
                return find(other.settings, setting.name)->text == setting.text;
            });
        });
    }
    return scenes;
}

// The scenes, each with the first of its settings: "'cube on plane' (--scene cube-on-plane), 'still life' (...)".
std::string listOf(const std::vector<SceneChoice>& scenes) {
    std::string text;
    for (const SceneChoice& scene : scenes) {
        text += (text.empty() ? "'" : ", '") + scene.name + "'";
        // One that no other scene shares says it alone; else all of them do.
        const auto own = std::find_if(scene.settings.begin(), scene.settings.end(), [&](const KnobSetting& setting) {
            return std::none_of(scenes.begin(), scenes.end(), [&](const SceneChoice& other) {
                return &other != &scene && find(other.settings, setting.name)->text == setting.text;
            });
        });
        if (scene.settings.empty()) continue;
        text += " (" + flags(own != scene.settings.end() ? std::vector{*own} : scene.settings) + ")";
    }
    return text;
}

const SceneChoice& sceneFor(const std::vector<SceneChoice>& scenes, const Demo& demo,
                            const std::vector<KnobSetting>& given, const std::string& subject) {
    std::vector<const SceneChoice*> fitting, present;
    for (const SceneChoice& scene : scenes) {
        if (!contradictions(given, scene.settings).empty()) continue;
        fitting.push_back(&scene);
        const bool here = std::all_of(scene.settings.begin(), scene.settings.end(), [&](const KnobSetting& setting) {
            return demo.knob(setting.name).text() == setting.text;
        });
        if (here) present.push_back(&scene);
    }
    // Of several that are the present settings, the one that says most.
    const auto says = [](const SceneChoice* a, const SceneChoice* b) {
        return a->settings.size() < b->settings.size();
    };
    if (!present.empty()) return **std::max_element(present.begin(), present.end(), says);
    if (fitting.size() == 1) return *fitting.front();
    if (fitting.empty()) {
        throw UsageError(subject, "must be asked of a scene that the study has: " + listOf(scenes),
                         "given: " + flags(given));
    }
    throw UsageError(subject, "must be told which scene of the study is meant: " + listOf(scenes));
}

// As the study's rows have the problem, canonical.
std::string presentProblem(const StudyRun& run, const Demo& demo) {
    StudyRow here;
    here.settings = {{run.problem, demo.knob(run.problem).text()}};
    return problemOf(run, here);
}

}  // namespace

// ---- Bounds

std::string boundText(const StudyBound& bound) {
    if (bound.of == StudyBound::Of::time) return formatted("%.3g ms", bound.value);
    return bound.percent ? formatted("%.3g %%", 100 * bound.value) : errorText(bound.value);
}

std::optional<std::size_t> rowWithin(const StudyRun& run, const std::vector<std::size_t>& rows,
                                     const StudyBound& bound) {
    std::optional<std::size_t> best;
    const bool ofTime = bound.of == StudyBound::Of::time;
    const auto rank = [&](std::size_t i) {
        const double error = run.shownError(run.rows[i]), time = run.rows[i].msMedian;
        return ofTime ? std::tuple(error, time, i) : std::tuple(time, error, i);
    };
    for (const std::size_t i : rows) {
        const StudyRow& row = run.rows[i];
        if (!isPlotted(row) || (ofTime ? row.msMedian : run.shownError(row)) > bound.value) continue;
        if (!best || rank(i) < rank(*best)) best = i;
    }
    return best;
}

std::optional<std::size_t> nearestTo(const StudyRun& run, const std::vector<std::size_t>& rows,
                                     const StudyBound& bound) {
    StudyBound loosest = bound;
    double least = -1;
    for (const std::size_t i : rows) {
        if (!isPlotted(run.rows[i])) continue;
        const double value = bound.of == StudyBound::Of::time ? run.rows[i].msMedian : run.shownError(run.rows[i]);
        if (least < 0 || value < least) least = value;
    }
    loosest.value = least;
    return rowWithin(run, rows, loosest);
}

std::string rowSentence(const StudyRun& run, const StudyRow& row) {
    std::string text = row.method;
    if (!row.parameter.empty()) text += ", " + knobOf(run, row.scene, row.method) + " " + row.parameter;
    return text + ": " + errorName(run.axis) + " " + errorText(run.shownError(row)) +
           formatted(", %.3g ms", row.msMedian);
}

// ---- Rows to choose from

std::vector<std::size_t> rowsOfProblem(const StudyRun& run, const std::string& scene, const Demo& demo,
                                       const std::string& subject) {
    std::vector<std::size_t> all, equal, unset;
    std::string known;
    const std::string here = run.problem.empty() ? "" : presentProblem(run, demo);
    for (std::size_t i = 0; i < run.rows.size(); ++i) {
        const StudyRow& row = run.rows[i];
        if (row.scene != scene) continue;
        const std::string problem = problemOf(run, row);
        all.push_back(i);
        if (problem == here) equal.push_back(i);
        if (problem.empty()) unset.push_back(i);
        if (!problem.empty() && ("," + known + ",").find(", " + problem + ",") == std::string::npos) {
            known += (known.empty() ? " " : ", ") + problem;
        }
    }
    if (run.problem.empty()) return all;
    if (!equal.empty()) return equal;
    // Rows that do not set the knob were measured with its initial value.
    if (!unset.empty() && demo.knob(run.problem).isInitial()) return unset;
    throw UsageError(subject, "needs a --" + run.problem + " that the study has in '" + scene + "':" + known, here);
}

StudyCandidates candidates(const StudyRun& run, const DemoInfo& info, const Demo& demo,
                           const std::vector<KnobSetting>& given, const std::string& subject) {
    const auto asked = asKnobsHave(info, given).value_or(given);
    const std::vector<SceneChoice> scenes = scenesIn(run, info);
    if (scenes.empty()) throw Error(subject, "needs a study whose settings the demo still takes");
    const SceneChoice& scene = sceneFor(scenes, demo, asked, subject);
    StudyCandidates found{scene.name, scene.settings, {}};
    // Of the rows that have most of what is given: the knob that they have otherwise, and what they have for it.
    long most = -1;
    std::string refused, has;
    for (const std::size_t i : rowsOfProblem(run, scene.name, demo, subject)) {
        const auto settings = asKnobsHave(info, run.rows[i].settings);
        if (!settings) continue;
        const std::vector<KnobSetting> against = contradictions(asked, *settings);
        if (against.empty()) {
            found.rows.push_back(i);
            continue;
        }
        const auto agreeing = std::count_if(asked.begin(), asked.end(), [&](const KnobSetting& setting) {
            const KnobSetting* other = find(*settings, setting.name);
            return other && other->text == setting.text;
        });
        if (agreeing > most) {
            most = agreeing;
            refused = against.front().name;
            has.clear();
        }
        if (agreeing < most || against.front().name != refused) continue;
        const std::string& value = find(*settings, refused)->text;
        if ((", " + has + ",").find(", " + value + ",") == std::string::npos) has += (has.empty() ? "" : ", ") + value;
    }
    if (found.rows.empty()) {
        throw UsageError("--" + refused,
                         "must be as in a setting that the study has" +
                             (scene.name.empty() ? "" : " in '" + scene.name + "'") + ", for " + subject +
                             " to choose it: " + has,
                         find(asked, refused)->text);
    }
    return found;
}

std::string measuredOtherwise(const StudyRow& row, const Demo& demo) {
    std::string others;
    for (const Knob* knob : demo.knobs()) {
        if (!find(row.settings, knob->name()) && !knob->isInitial()) {
            others += (others.empty() ? "" : ", ") + knob->name();
        }
    }
    return others;
}

}  // namespace mv

#include "mv/demo/preset.h"

#include <algorithm>

#include "mv/demo/demo.h"

namespace mv {
namespace {

bool isKebabCase(std::string_view name) {
    const auto allowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
    return !name.empty() && name.front() != '-' && name.back() != '-' && name.find("--") == std::string_view::npos &&
           std::all_of(name.begin(), name.end(), allowed);
}

std::vector<std::string> namesOf(const DemoInfo& info) {
    std::vector<std::string> names;
    for (const Preset& preset : info.presets) names.push_back(preset.name);
    return names;
}

}  // namespace

void checkPresets(const DemoInfo& info) {
    const std::vector<std::string> names = namesOf(info);
    for (const Preset& preset : info.presets) {
        const std::string subject = "preset '" + preset.name + "' of " + info.name;
        if (!isKebabCase(preset.name)) throw Error(subject, "must have a name of small letters, digits and single -");
        if (std::count(names.begin(), names.end(), preset.name) > 1) throw Error(subject, "must be declared once");
        if (preset.lookFor.empty()) throw Error(subject, "must say what to look for");
    }
    const auto first = info.presets.begin();
    if (first != info.presets.end() && !first->settings.empty()) {
        throw Error("preset '" + first->name + "' of " + info.name,
                    "must have no settings: the first preset is the knobs' initial values", settingsText(*first));
    }
}

const Preset& findPreset(const DemoInfo& info, std::string_view name) {
    const std::vector<std::string> names = namesOf(info);
    const auto found = std::find(names.begin(), names.end(), name);
    if (found != names.end()) return info.presets[static_cast<std::size_t>(found - names.begin())];
    if (names.empty()) throw Error("--preset", "is of no use here: " + info.name + " has none");
    std::string rule = "must be ";
    for (const std::string& each : names) rule += (each == names.front() ? "" : " | ") + each;
    throw Error("--preset", rule, "'" + std::string(name) + "'" + suggestion(name, names));
}

void applyPreset(Demo& demo, const Preset& preset) {
    for (Knob* knob : demo.knobs()) knob->reset();
    applyKnobs(demo, preset.settings);
}

std::vector<KnobSetting> changedKnobs(const Demo& from, const Demo& to) {
    std::vector<KnobSetting> changed;
    for (std::size_t i = 0; i < to.knobs().size(); ++i) {
        const std::string text = to.knobs()[i]->text();
        if (text != from.knobs()[i]->text()) changed.push_back({to.knobs()[i]->name(), text});
    }
    return changed;
}

bool isAtPreset(const Demo& demo, const Preset& preset) {
    return std::all_of(demo.knobs().begin(), demo.knobs().end(), [&](const Knob* knob) {
        const auto setting = std::find_if(preset.settings.begin(), preset.settings.end(),
                                          [&](const KnobSetting& s) { return s.name == knob->name(); });
        return setting == preset.settings.end() ? knob->isInitial() : knob->text() == setting->text;
    });
}

std::string settingsText(const Preset& preset) {
    std::string text;
    for (const auto& [name, value] : preset.settings)
        text.append(text.empty() ? "--" : " --").append(name).append(" ").append(value);
    return text;
}

}  // namespace mv

// Presets: settings of a demo that are worth a look, by a name and with a sentence. Buttons in the window, --preset NAME on
// the command line, rows in the documentation, pictures in the tests.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "mv/demo/knob.h"

namespace mv {

class Demo;
struct DemoInfo;

// A readout's value that the sentence of a preset tells, and the range in which that is true.
struct ExpectedReadout {
    Literal readout;
    double low, high;
};

struct Preset {
    Literal name;                              // in kebab-case
    Literal lookFor;                           // one sentence
    std::vector<KnobSetting> settings = {};    // all other knobs are at their initial values
    std::vector<ExpectedReadout> expect = {};  // in frame 1; a test looks
};

// Throws Error where presets are not as a demo's have to be: names in kebab-case, each once, each with its sentence, and
// the first one without settings, since it is what the demo opens with.
void checkPresets(const DemoInfo& info);

// The demo's preset of that name, or Error with all names and the nearest one.
const Preset& findPreset(const DemoInfo& info, std::string_view name);

// Sets every knob: those that the preset names, and the others to their initial values. Error: no such knob, or a value
// that it refuses.
void applyPreset(Demo& demo, const Preset& preset);

// The knobs of the second one whose values are not those of the first, in the order of the knobs: both have the same.
std::vector<KnobSetting> changedKnobs(const Demo& from, const Demo& to);

// Whether the knobs are just so.
bool isAtPreset(const Demo& demo, const Preset& preset);

// "--spin-x 20 --spin-y 30"; "" for the initial values.
std::string settingsText(const Preset& preset);

}  // namespace mv

// What a knob may ask of a user interface, without naming one: the window's panel implements it with Dear ImGui.
#pragma once
#include <string>
#include <vector>

#include "mv/demo/literal.h"

namespace mv {

class Knob;

// One setting of a Choice: the word typed on the command line and what it means.
struct Option {
    std::string word;
    std::string meaning = {};
};
// The same as a demo declares it.
struct DeclaredOption {
    Literal word;
    Literal meaning = {};
    operator Option() const { return {word, meaning}; }
};

// How a knob goes through its range: by equal differences, or by equal factors.
enum class Scale { linear, logarithmic };

// The numbers that a knob allows.
struct NumberRange {
    double low, high;
    Scale scale = Scale::linear;
    bool orZero = false;  // and 0, which no factor leads to; for a logarithmic range alone
};

// The widgets a knob can be shown with. Each returns true when the user has just changed `value`.
class Panel {
  public:
    virtual ~Panel() = default;
    virtual bool slider(const Knob& knob, double& value, const NumberRange& range) = 0;
    virtual bool slider(const Knob& knob, int& value, int low, int high) = 0;
    virtual bool checkbox(const Knob& knob, bool& value) = 0;
    // The value as words, which are edited when they are clicked: for any kind of knob.
    virtual bool words(const Knob& knob) = 0;
    // A small button after what the row has so far; true when it is pressed.
    virtual bool button(const Knob& knob, const std::string& label, bool enabled) = 0;
    virtual bool choose(const Knob& knob, int& index, const std::vector<Option>& options) = 0;
    // The name of a file: as words, where nothing better is at hand.
    virtual bool file(const Knob& knob) { return words(knob); }
};

}  // namespace mv

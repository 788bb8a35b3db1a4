#include "mv/demo/controls.h"

#include "mv/demo/demo.h"

namespace mv {
namespace {

std::pair<std::string, std::string> controlText(const Binding& binding) {
    const std::string amount = binding.knob->stepText(binding.amount, binding.knob->unit());
    switch (binding.gesture) {
        case Gesture::dragAcross:
            return {"Drag right", binding.knob->name() + " " + amount + " a pixel"};
        case Gesture::dragDown:
            return {"Drag down", binding.knob->name() + " " + amount + " a pixel"};
        case Gesture::wheel:
            return {"Wheel up", binding.knob->name() + " " + amount + " a notch"};
        case Gesture::key:
            break;
    }
    return {keyName(binding.key), binding.knob->name() + (binding.text.empty() ? " " + amount : " = " + binding.text)};
}

}  // namespace

std::vector<std::pair<std::string, std::string>> controlsOf(const Demo& demo) {
    std::vector<std::pair<std::string, std::string>> controls;
    for (const Binding& binding : demo.bindings()) {
        if (binding.amount != 0 || !binding.text.empty()) controls.push_back(controlText(binding));
    }
    for (const Handle& handle : demo.handles()) {
        std::string knobs;
        for (const Knob* knob : handle.knobs) knobs += (knobs.empty() ? "" : ", ") + knob->name();
        controls.emplace_back("Drag the " + handle.name, knobs);
    }
    return controls;
}

}  // namespace mv

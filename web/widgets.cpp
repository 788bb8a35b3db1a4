#include "widgets.h"

namespace mv {
namespace {

class Described final : public Panel {
  public:
    nlohmann::ordered_json widget;

    bool slider(const Knob&, double&, const NumberRange& range) override {
        widget["kind"] = "number";
        widget["low"] = range.low;
        widget["high"] = range.high;
        widget["whole"] = false;
        widget["logarithmic"] = range.scale == Scale::logarithmic;
        widget["orZero"] = range.orZero;
        return false;
    }
    bool slider(const Knob&, int&, int low, int high) override {
        widget["kind"] = "number";
        widget["low"] = low;
        widget["high"] = high;
        widget["whole"] = true;
        widget["logarithmic"] = widget["orZero"] = false;
        return false;
    }
    bool checkbox(const Knob&, bool&) override { return is("switch"); }
    bool words(const Knob&) override { return is("words"); }
    bool button(const Knob&, const std::string& label, bool enabled) override {
        widget["buttons"].push_back({{"label", label}, {"enabled", enabled}});
        return false;
    }
    bool choose(const Knob&, int&, const std::vector<Option>& options) override {
        widget["options"] = nlohmann::ordered_json::array();
        for (const Option& option : options)
            widget["options"].push_back({{"word", option.word}, {"meaning", option.meaning}});
        return is("choice");
    }

  private:
    bool is(const char* kind) {
        widget["kind"] = kind;
        return false;
    }
};

class Pressing final : public Panel {
  public:
    explicit Pressing(std::string label) : label_(std::move(label)) {}
    bool slider(const Knob&, double&, const NumberRange&) override { return false; }
    bool slider(const Knob&, int&, int, int) override { return false; }
    bool checkbox(const Knob&, bool&) override { return false; }
    bool words(const Knob&) override { return false; }
    bool button(const Knob&, const std::string& label, bool enabled) override { return enabled && label == label_; }
    bool choose(const Knob&, int&, const std::vector<Option>&) override { return false; }

  private:
    std::string label_;
};

}  // namespace

nlohmann::ordered_json widgetsOf(Demo& demo) {
    auto widgets = nlohmann::ordered_json::object();
    for (Knob* knob : demo.knobs()) {
        Described described;
        knob->widget(described);
        widgets[knob->name()] = std::move(described.widget);
    }
    return widgets;
}

bool pressButton(Knob& knob, const std::string& label) {
    Pressing pressing(label);
    return knob.widget(pressing);
}

}  // namespace mv

#include "widgets.h"

#include <utility>
#include <vector>

#include "mv/demo/file_knob.h"

namespace mv {
namespace {

// Writes what a knob is set by as one object.
class Described final : public Panel {
  public:
    explicit Described(JsonText& json) : json_(json) {}
    bool slider(const Knob&, double&, const NumberRange& range) override {
        return isNumber(range.low, range.high, false, range.scale == Scale::logarithmic, range.orZero);
    }
    bool slider(const Knob&, int&, int low, int high) override { return isNumber(low, high, true, false, false); }
    bool checkbox(const Knob&, bool&) override { return is("switch"); }
    bool words(const Knob&) override { return is("words"); }
    bool file(const Knob& knob) override {
        json_.add("accept", static_cast<const FileKnob&>(knob).endings());
        return is("file");
    }
    bool button(const Knob&, const std::string& label, bool enabled) override {
        buttons_.push_back({label, enabled});
        return false;
    }
    bool choose(const Knob&, int&, const std::vector<Option>& options) override {
        json_.array("options");
        for (const Option& option : options)
            json_.object().add("word", option.word).add("meaning", option.meaning).end();
        json_.end();
        return is("choice");
    }
    // What stands beside the widget itself.
    void buttons() {
        if (buttons_.empty()) return;
        json_.array("buttons");
        for (const auto& [label, enabled] : buttons_) json_.object().add("label", label).add("enabled", enabled).end();
        json_.end();
    }

  private:
    bool is(const char* kind) {
        json_.add("kind", kind);
        return false;
    }
    bool isNumber(double low, double high, bool whole, bool logarithmic, bool orZero) {
        json_.add("low", low).add("high", high).add("whole", whole);
        json_.add("logarithmic", logarithmic).add("orZero", orZero);
        return is("number");
    }
    JsonText& json_;
    std::vector<std::pair<std::string, bool>> buttons_;
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

void addWidgets(JsonText& json, Demo& demo) {
    for (Knob* knob : demo.knobs()) {
        json.object(knob->name());
        Described described(json);
        knob->widget(described);
        described.buttons();
        json.end();
    }
}

bool pressButton(Knob& knob, const std::string& label) {
    Pressing pressing(label);
    return knob.widget(pressing);
}

}  // namespace mv

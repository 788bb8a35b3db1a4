// The knobs of a demo as widgets of Dear ImGui.
#pragma once
#include <array>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/show/session.h"
#include "mv/window/comparison.h"
#include "mv/window/gui.h"

namespace mv {

class KnobPanel {
  public:
    KnobPanel(Gui& gui, Session& session) : gui_(gui), session_(session) {}

    // A row for each knob: name, widget, unit, and a button that sets it back; a second row for the other value of the
    // one that is compared. Those that do nothing now are folded below. True when one was moved.
    // `refused`: names of knobs whose values make no picture together.
    bool show(Comparison& comparison, const std::vector<std::string>& refused);
    // A bar that goes there and back by itself; true while it does.
    bool advance(double seconds);
    bool sweeping() const { return !sweep_.empty(); }

    // A field for a value to be typed hangs open in the place of a bar; closing it leaves the value as it was.
    bool fieldOpen() const { return !typed_.empty(); }
    void closeField() { typed_.clear(); }

  private:
    bool row(Knob& knob, float labelWidth, const std::string& side);
    bool otherRow(Knob& knob, float labelWidth, Comparison& comparison);
    bool rows(const std::vector<Knob*>& knobs, float labelWidth, Comparison& comparison);
    // The widget of a knob. True when it was moved.
    bool widget(Knob& knob);
    bool slider(const Knob& knob, double& value);
    bool checkbox(bool& value);
    bool points(Knob& knob);
    bool button(const std::string& label, bool enabled);
    bool choose(int& index, const std::vector<Option>& options);
    bool file(const Knob& knob);
    bool bar(const Knob& knob, double& value, double low, double high, double digits, const std::string& text);
    bool logarithmicBar(const Knob& knob, double& value, const NumberRange& range);
    void sweepButton(float width);
    bool field(Knob& knob);
    void openField(const Knob& knob);

    // The name of the row that is being made: the knob's name, with " B" for the other value of the one that is
    // compared.
    std::string rowName_;
    Gui& gui_;
    Session& session_;
    // The row whose value is being typed; "" for none.
    std::string typed_;
    std::array<char, 1024> text_{};
    std::string refusal_;
    bool focusField_ = false;
    std::vector<std::string> refused_;
    std::vector<const Knob*> idle_;  // what does nothing now, as of when nothing was moved
    std::string sweep_;              // the row whose bar goes by itself; "" for none
    double place_ = 0;               // of it, 0..1
    float sweepSeconds_ = 4;         // there, and as long back
    double barPlace_ = 0;            // of the bar that was made last
    bool backwards_ = false, hasMoved_ = false;
};

// Name, range, unit, initial value: what the mouse over a knob tells.
std::string knobTip(const Knob& knob);

}  // namespace mv

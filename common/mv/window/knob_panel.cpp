#include "mv/window/knob_panel.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "mv/paper/tables.h"

namespace mv {
namespace {

// The words behind the name of the knob that is compared.
constexpr const char *sideA = " A", *sideB = " B";
constexpr const char* resetSign = "\u21BA";  // an arrow turning back

std::string trimmed(const std::string& text) {
    const auto first = text.find_first_not_of(" \t");
    if (first == std::string::npos) return {};
    return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

// The value's text with its unit, as a format of printf that prints just that.
std::string asFormat(const Knob& knob, const std::string& text) {
    std::string format;
    for (const char c : text + (knob.unit().empty() ? "" : " " + knob.unit())) {
        format += c;
        if (c == '%') format += c;
    }
    return format;
}

// The decimal number nearest to the value with so many digits after the point, and none for a negative number.
double rounded(double value, int digits) {
    char text[400];  // the longest double
    std::snprintf(text, sizeof text, "%.*f", std::max(digits, 0), value);
    const double number = std::strtod(text, nullptr);
    return number == 0 ? 0 : number;  // never -0
}

// The decimal number of three digits nearest to the value, which is as fine as a hand can choose on a logarithmic bar.
double threeDigits(double value) { return std::strtod(formatted("%.2e", value).c_str(), nullptr); }

}  // namespace

std::string knobTip(const Knob& knob) {
    std::string tip = knob.help() + "\n" + knob.rangeInFull() + "; initially " + knob.initialText();
    for (const Option& option : knob.options()) {
        if (!option.meaning.empty()) tip += "\n" + option.word + ": " + option.meaning;
    }
    return tip;
}

bool KnobPanel::show(Comparison& comparison, const std::vector<std::string>& refused) {
    refused_ = refused;
    const Demo& demo = session_.demo();
    float labelWidth = 0;
    for (const Knob* knob : demo.knobs()) {
        const std::string label = knob->name() + (knob == comparison.knob() ? sideA : "");
        labelWidth = std::max(labelWidth, ImGui::CalcTextSize(label.c_str()).x);
    }
    // A very long name goes above its widget instead of leaving the widget no room.
    labelWidth = std::min(labelWidth, ImGui::GetContentRegionAvail().x * 0.4F) + ImGui::GetStyle().ItemSpacing.x;
    // No row goes from under a hand that moves something
    if (!ImGui::IsAnyMouseDown() && typed_.empty() && sweep_.empty()) {
        idle_.clear();
        for (const Knob* knob : demo.knobs()) {
            if (!knob->idleReason().empty() && knob != comparison.knob()) idle_.push_back(knob);
        }
    }
    std::vector<Knob*> working, idle;
    for (Knob* knob : demo.knobs()) (std::ranges::find(idle_, knob) == idle_.end() ? working : idle).push_back(knob);
    bool moved = rows(working, labelWidth, comparison);
    if (!idle.empty()) {
        const std::string words = std::to_string(idle.size()) + (idle.size() == 1 ? " that does" : " that do") +
                                  " nothing in these settings###idle";
        const bool open =
            ImGui::TreeNodeEx(words.c_str(), ImGuiTreeNodeFlags_NoTreePushOnOpen | ImGuiTreeNodeFlags_SpanAvailWidth);
        notePlace("idle settings");
        std::string names;
        for (const Knob* knob : idle) names += (names.empty() ? "" : ", ") + knob->name();
        tooltip(names);
        if (open) moved |= rows(idle, labelWidth, comparison);
    }
    const bool initial = std::all_of(demo.knobs().begin(), demo.knobs().end(), [](Knob* k) { return k->isInitial(); });
    ImGui::BeginDisabled(initial);
    if (mv::button("Reset all")) {
        for (Knob* knob : demo.knobs()) knob->reset();
        typed_.clear();
        moved = true;
    }
    ImGui::EndDisabled();
    return moved;
}

bool KnobPanel::rows(const std::vector<Knob*>& knobs, float labelWidth, Comparison& comparison) {
    bool moved = false;
    for (Knob* knob : knobs) {
        const bool compared = knob == comparison.knob();
        ImGui::PushID(knob->name().c_str());
        moved |= row(*knob, labelWidth, compared ? sideA : "");
        if (compared) moved |= otherRow(*knob, labelWidth, comparison);
        ImGui::PopID();
    }
    return moved;
}

// The widgets are the knob's own, so for the moment it holds the other value.
bool KnobPanel::otherRow(Knob& knob, float labelWidth, Comparison& comparison) {
    const std::string present = knob.text();
    knob.parse(comparison.other());
    ImGui::PushID(sideB);
    const bool moved = row(knob, labelWidth, sideB);
    ImGui::PopID();
    comparison.setOther(knob.text());
    knob.parse(present);
    return moved;
}

bool KnobPanel::row(Knob& knob, float labelWidth, const std::string& side) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const std::string idle = knob.idleReason();
    const bool isFile = knob.kind() == Knob::Kind::file;
    const std::string tip =
        knobTip(knob) +
        (isFile ? "\nDrop one onto the window, or click and type its name.\nIt is " + knob.text() : "") +
        (idle.empty() ? "" : "\nIt does nothing now: " + idle + ".");
    rowName_ = knob.name() + (side == sideB ? sideB : "");
    const float left = ImGui::GetCursorPosX();
    ImGui::AlignTextToFramePadding();
    ImGui::BeginDisabled(!idle.empty());
    if (std::ranges::find(refused_, knob.name()) != refused_.end()) {
        ImGui::TextColored(color::error, "%s%s", knob.name().c_str(), side.c_str());
    } else if (side.empty()) {
        ImGui::TextUnformatted(knob.name().c_str());
    } else {
        ImGui::TextColored(color::heading, "%s%s", knob.name().c_str(), side.c_str());
    }
    tooltip(tip);
    if (ImGui::GetItemRectSize().x <= labelWidth) ImGui::SameLine(left + labelWidth);

    const float resetWidth = ImGui::CalcTextSize(resetSign).x + 2 * style.FramePadding.x;
    using Kind = Knob::Kind;
    const bool isBar = knob.kind() == Kind::number || knob.kind() == Kind::angle || knob.kind() == Kind::whole;
    const float sweepWidth = isBar ? resetWidth + style.ItemSpacing.x / 2 : 0;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - resetWidth - sweepWidth - style.ItemSpacing.x);
    const bool typing = typed_ == rowName_;
    bool moved = typing ? field(knob) : widget(knob);
    if (!typing) tooltip(tip);
    ImGui::EndDisabled();

    if (isBar) {
        ImGui::SameLine(0, style.ItemSpacing.x / 2);
        ImGui::BeginDisabled(!idle.empty());
        sweepButton(resetWidth);
        ImGui::EndDisabled();
    }
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - resetWidth);
    if (knob.isInitial()) {
        ImGui::Dummy({resetWidth, ImGui::GetFrameHeight()});
    } else {
        if (ImGui::Button(resetSign)) {
            knob.reset();
            moved = true;
        }
        notePlace("reset " + rowName_);
        tooltip("back to " + knob.initialText());
    }
    if (isBar && sweep_ == rowName_) {
        ImGui::SetCursorPosX(left + labelWidth);
        ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - resetWidth - style.ItemSpacing.x);
        ImGui::SliderFloat("##seconds", &sweepSeconds_, 1, 60, "%.1f s there, as long back",
                           ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoInput);
        notePlace("sweep seconds");
    }
    if (typing && !refusal_.empty()) wrapped(color::error, refusal_);
    for (const Option& option : knob.options()) {
        if (option.meaning.empty() || option.word != knob.text()) continue;
        ImGui::SetCursorPosX(left + labelWidth);
        wrapped(color::dim, option.meaning);
    }
    return moved;
}

bool KnobPanel::widget(Knob& knob) {
    switch (knob.kind()) {
        case Knob::Kind::number:
        case Knob::Kind::angle:
        case Knob::Kind::whole: {
            double value = knob.number();
            const bool moved = slider(knob, value);
            if (moved) knob.setNumber(value);
            return moved;
        }
        case Knob::Kind::toggle: {
            bool value = knob.isOn();
            const bool moved = checkbox(value);
            if (moved) knob.setOn(value);
            return moved;
        }
        case Knob::Kind::oneOf:
        case Knob::Kind::word: {
            int index = knob.index();
            const bool moved = choose(index, knob.options());
            if (moved) knob.choose(index);
            return moved;
        }
        case Knob::Kind::points:
            return points(knob);
        case Knob::Kind::file:
            return file(knob);
    }
    return false;
}

bool KnobPanel::slider(const Knob& knob, double& value) {
    const NumberRange range = knob.numbers();
    if (knob.kind() == Knob::Kind::whole) {
        // The number itself: of a knob whose end stands for as many as there are, that is how many these are.
        return bar(knob, value, range.low, range.high, 0, numberText(value));
    }
    if (range.scale == Scale::logarithmic) return logarithmicBar(knob, value, range);
    const double low = range.low, high = range.high;
    // As fine as a hand can choose on a bar of some 200 pixels; finer values are typed.
    const double digits = high > low ? -std::floor(std::log10((high - low) / 500)) : 0;
    return bar(knob, value, low, high, digits, knob.text());
}

// The bar goes by the logarithm, and over its first twentieth it is 0 where that is allowed.
bool KnobPanel::logarithmicBar(const Knob& knob, double& value, const NumberRange& range) {
    const double gap = range.orZero ? 0.05 : 0, decades = std::log10(range.high / range.low);
    double place = value == 0 ? 0 : gap + (1 - gap) * std::log10(value / range.low) / decades;
    if (!bar(knob, place, 0, 1, 4, knob.text())) return false;
    const bool byKeys = !ImGui::IsMouseDown(ImGuiMouseButton_Left);
    if (byKeys && value == 0) place = std::max(place, gap);  // an arrow key leaves 0 in one step
    const double before = value, exponent = (place - gap) / (1 - gap) * decades;
    value = exponent < 0 ? 0 : std::clamp(threeDigits(range.low * std::pow(10.0, exponent)), range.low, range.high);
    return value != before;
}

bool KnobPanel::bar(const Knob& knob, double& value, double low, double high, double digits, const std::string& text) {
    const double before = value;
    double shown = value;
    if (sweep_ == rowName_ && hasMoved_) {
        hasMoved_ = false;
        value = std::clamp(rounded(low + place_ * (high - low), static_cast<int>(digits)), low, high);
        shown = value;
    }
    // The format is the text itself, so that the bar shows all digits there are and ImGui rounds nothing.
    ImGui::SliderScalar("##bar", ImGuiDataType_Double, &shown, &low, &high, asFormat(knob, text).c_str(),
                        ImGuiSliderFlags_NoInput);
    notePlace(rowName_);
    barPlace_ = high > low ? (before - low) / (high - low) : 0;
    const bool byHand = ImGui::IsItemHovered() && (ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) ||
                                                   (ImGui::IsItemClicked() && ImGui::GetIO().KeyCtrl));
    if (byHand) {
        openField(knob);
        return false;
    }
    if (ImGui::IsItemFocused() && gui_.navigating() && ImGui::IsKeyPressed(ImGui::GetKeyIndex(ImGuiKey_Enter), false)) {
        openField(knob);
        return false;
    }
    if (ImGui::IsItemActive() && sweep_ == rowName_) sweep_.clear();  // the hand has it
    if (sweep_ == rowName_) return value != before;
    if (shown == before || !ImGui::IsItemActive()) return false;
    value = std::clamp(rounded(shown, static_cast<int>(digits)), low, high);
    // An arrow key moves by a hundredth of the bar; where that is less than the bar tells apart, by as much as it does
    if (value == before && !ImGui::IsMouseDown(ImGuiMouseButton_Left))
        value = std::clamp(before + std::copysign(std::pow(10, -digits), shown - before), low, high);
    return value != before;
}

bool KnobPanel::advance(double seconds) {
    if (sweep_.empty()) return false;
    place_ += (backwards_ ? -1 : 1) * seconds / double(sweepSeconds_);
    if (place_ >= 1 || place_ <= 0) backwards_ = place_ >= 1;
    place_ = std::clamp(place_, 0.0, 1.0);
    hasMoved_ = true;
    return true;
}

void KnobPanel::sweepButton(float width) {
    const bool isOn = sweep_ == rowName_;
    ImGui::PushID("sweep");
    if (ImGui::Button(isOn ? "\u25A0###" : "\u25B6###", {width, 0})) {
        sweep_ = isOn ? "" : rowName_;
        place_ = barPlace_;
        backwards_ = false;
    }
    ImGui::PopID();
    notePlace("sweep " + rowName_);
    tooltip(isOn ? "stop here" : "go through the range by itself, there and back");
}

void KnobPanel::openField(const Knob& knob) {
    typed_ = rowName_;
    std::snprintf(text_.data(), text_.size(), "%s", knob.text().c_str());
    refusal_.clear();
    focusField_ = true;
}

// A field for a value to be typed. Refuse a value out of range with the range, and keep the field.
bool KnobPanel::field(Knob& knob) {
    if (focusField_) ImGui::SetKeyboardFocusHere();
    focusField_ = false;
    const bool red = !refusal_.empty();
    if (red) ImGui::PushStyleColor(ImGuiCol_FrameBg, color::errorBack);
    const bool entered = ImGui::InputText("##field", text_.data(), text_.size(),
                                          ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    if (red) ImGui::PopStyleColor();
    notePlace(rowName_);
    if (!entered) {
        if (ImGui::IsItemDeactivated()) typed_.clear();  // Escape, or a click elsewhere: as it was
        return false;
    }
    const std::string before = knob.text();
    refusal_ = session_.set(knob.name(), trimmed(text_.data()));
    if (refusal_.empty()) {
        typed_.clear();
    } else {
        focusField_ = true;
    }
    return knob.text() != before;
}

bool KnobPanel::checkbox(bool& value) {
    const bool moved = ImGui::Checkbox("##box", &value);
    notePlace(rowName_);
    return moved;
}

// As words, which are edited when they are clicked.
bool KnobPanel::points(Knob& knob) {
    // Words that do not fit are in the tip; buttons come after it
    const float width = ImGui::CalcItemWidth() - 2 * (ImGui::GetFrameHeight() + ImGui::GetStyle().ItemSpacing.x);
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
    if (ImGui::Button((knob.text() + "##words").c_str(), {width, 0})) openField(knob);
    ImGui::PopStyleColor();
    notePlace(rowName_);
    tooltip(knob.text());
    if (knob.isFixedNumber()) return false;
    const std::size_t last = knob.points().size() - 1;
    bool moved = false;
    if (button("+", knob.canAddPoint())) moved |= knob.addPoint(last);
    if (button("-", knob.canRemovePoint())) moved |= knob.removePoint(last);
    return moved;
}

// The end of a long path says more than its beginning.
bool KnobPanel::file(const Knob& knob) {
    const float width = ImGui::CalcItemWidth(), room = width - 2 * ImGui::GetStyle().FramePadding.x;
    std::string shown = knob.text();
    while (shown.find('/') != std::string::npos && ImGui::CalcTextSize(shown.c_str()).x > room)
        shown.erase(0, shown.find('/') + 1);
    ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_FrameBg));
    if (ImGui::Button((shown + "##file").c_str(), {width, 0})) openField(knob);
    ImGui::PopStyleColor();
    notePlace(rowName_);
    return false;
}

bool KnobPanel::button(const std::string& label, bool enabled) {
    ImGui::SameLine();
    ImGui::BeginDisabled(!enabled);
    const bool pressed = ImGui::Button(label.c_str(), {ImGui::GetFrameHeight(), 0});
    ImGui::EndDisabled();
    notePlace(rowName_ + " " + label);
    return pressed;
}

bool KnobPanel::choose(int& index, const std::vector<Option>& options) {
    const Option& present = options[static_cast<std::size_t>(index)];
    bool moved = false;
    const bool open = ImGui::BeginCombo("##choice", present.word.c_str());
    if (!open) notePlace(rowName_);
    if (open) {
        ImGui::PushStyleColor(ImGuiCol_Header, ImGui::GetStyleColorVec4(ImGuiCol_Button));
        float wordWidth = 0;
        for (const Option& option : options) {
            wordWidth = std::max(wordWidth, ImGui::CalcTextSize(option.word.c_str()).x);
        }
        const float textHeight = ImGui::GetTextLineHeight();
        for (std::size_t i = 0; i < options.size(); ++i) {
            const bool chosen = static_cast<int>(i) == index;
            ImGui::PushID(static_cast<int>(i));
            const float meaningWidth = ImGui::CalcTextSize(options[i].meaning.c_str()).x;
            const float gap = options[i].meaning.empty() ? 0 : 2 * ImGui::GetStyle().ItemSpacing.x;
            // The whole line can be clicked, not only its words.
            const float width = std::max(wordWidth + gap + meaningWidth, ImGui::GetContentRegionAvail().x);
            if (ImGui::Selectable("##option", chosen, 0, {width, textHeight}) && !chosen) {
                index = static_cast<int>(i);
                moved = true;
            }
            notePlace(rowName_ + " " + options[i].word);
            ImGui::SameLine(ImGui::GetStyle().WindowPadding.x);
            ImGui::TextUnformatted(options[i].word.c_str());
            if (!options[i].meaning.empty()) {
                ImGui::SameLine(ImGui::GetStyle().WindowPadding.x + wordWidth + gap);
                ImGui::TextDisabled("%s", options[i].meaning.c_str());
            }
            ImGui::PopID();
        }
        ImGui::PopStyleColor();
        if (gui_.wantsPopupClosed()) ImGui::CloseCurrentPopup();
        ImGui::EndCombo();
    }
    return moved;
}

}  // namespace mv

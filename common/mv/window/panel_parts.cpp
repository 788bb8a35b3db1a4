#include "mv/window/panel_parts.h"
#include "mv/demo/controls.h"
#include "mv/paper/matrix_text.h"
#include "mv/paper/report.h"
#include "mv/paper/tables.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <limits>

namespace mv {
namespace {

// A number of a matrix as it is written on paper: four digits after the point, none where it is whole. `after` is the
// part from the point on, so that numbers of a column can stand with their points under each other.
struct Cell {
    std::string text;
    std::size_t after = 0;
};

Cell cellOf(double exact, double largest) {
    const double number = withoutRounding(exact, largest);
    const double size = std::abs(number);
    if (number == 0) return {"0"};
    if (size >= 1e6 || size < 5e-5) return {formatted("%.2e", number)};
    std::string text = formatted("%.4f", number);
    // Zeros at the end go only where they say nothing: 0.5 is exactly that, 0.3000 is nearly 0.3.
    if (std::abs(number - std::strtod(text.c_str(), nullptr)) <= 1e-12 * size) {
        text.erase(text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.pop_back();
    }
    const auto point = text.find('.');
    return {text, point == std::string::npos ? 0 : text.size() - point};
}

void rightAligned(const std::string& text, float right) {
    ImGui::SetCursorPosX(right - ImGui::CalcTextSize(text.c_str()).x);
    ImGui::TextUnformatted(text.c_str());
}

// "viewFromModel": from which coordinates to which.
std::string matrixTip(const std::string& name) {
    const auto from = name.find("From");
    std::string tip = "Rows and columns as on paper; a point is a column on the right of it.";
    if (from == std::string::npos || from == 0) return tip;
    std::string source = name.substr(from + 4);
    if (!source.empty() && source[0] >= 'A' && source[0] <= 'Z') source[0] = static_cast<char>(source[0] - 'A' + 'a');
    return "Takes a point from " + source + " to " + name.substr(0, from) + " coordinates. " + tip;
}

void showMatrix(const FrameNotes& notes, const std::string& name, const mat4& matrix) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float margin = style.FramePadding.x;
    const float left = ImGui::GetCursorPosX() + margin;
    const float step = (ImGui::GetWindowContentRegionMax().x - left - 2 * margin) / 4;
    const float digit = ImGui::CalcTextSize("0").x, point = ImGui::CalcTextSize(".").x;
    const ImVec2 top = ImGui::GetCursorScreenPos();
    const double largest = largestEntry(matrix);
    std::array<std::size_t, 4> after{};  // of each column, the longest part from the point on
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            auto& longest = after[static_cast<std::size_t>(column)];
            longest = std::max(longest, cellOf(matrix[column][row], largest).after);
        }
    }
    const auto width = [&](std::size_t part) { return part == 0 ? 0 : point + digit * float(part - 1); };
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {0, style.ItemSpacing.y / 3});
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            if (column > 0) ImGui::SameLine();
            const Cell cell = cellOf(matrix[column][row], largest);
            const float missing = width(after[static_cast<std::size_t>(column)]) - width(cell.after);
            // One in the form 1e+06 is as long as the column is wide: it goes to its right end.
            const bool longForm = cell.text.find('e') != std::string::npos;
            rightAligned(cell.text, left + step * float(column + 1) - (longForm ? 0 : missing));
            notePlace(name + " " + std::to_string(row) + std::to_string(column));
            if (!ImGui::IsItemHovered()) continue;
            const std::string made = entryInWords(notes.matrices, name, row, column);
            tooltip(numberText(matrix[column][row] + 0.0) + (made.empty() ? "" : "\n" + made));  // exactly
        }
    }
    ImGui::PopStyleVar();
    // The brackets
    const float x0 = top.x + margin / 2, x1 = top.x + 4 * step + 2 * margin, y0 = top.y - 1;
    const float y1 = ImGui::GetItemRectMax().y + 1;
    const ImU32 ink = ImGui::GetColorU32(color::dim);
    for (const auto& [x, inwards] : {std::pair{x0, margin * 0.6F}, std::pair{x1, -margin * 0.6F}}) {
        ImGui::GetWindowDrawList()->AddLine({x, y0}, {x, y1}, ink, 1.5F);
        ImGui::GetWindowDrawList()->AddLine({x, y0}, {x + inwards, y0}, ink, 1.5F);
        ImGui::GetWindowDrawList()->AddLine({x, y1}, {x + inwards, y1}, ink, 1.5F);
    }
    ImGui::Dummy({0, style.ItemSpacing.y / 2});
}

// A button of several of which one is chosen; its place is noted under `place`.
bool choiceButton(const char* label, const std::string& place, bool chosen) {
    if (chosen) {
        ImGui::PushStyleColor(ImGuiCol_Button, color::heading);
        ImGui::PushStyleColor(ImGuiCol_ButtonHovered, color::heading);
        ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_WindowBg));
    }
    const bool pressed = ImGui::Button(label);
    notePlace(place);
    if (chosen) ImGui::PopStyleColor(3);
    return pressed;
}

// A list of the knobs: which one to compare.
bool chooseComparison(Demo& demo, Comparison& comparison, Gui& gui) {
    bool started = false;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    const bool open = ImGui::BeginCombo("##compare", "Compare with ...", ImGuiComboFlags_HeightLarge);
    if (!open) {
        notePlace("Compare with");
        tooltip("the present value of a setting with another one, in one picture");
        return false;
    }
    for (Knob* knob : demo.knobs()) {
        if (!canCompare(*knob)) continue;
        const std::string other = valueToCompareWith(*knob);
        if (ImGui::Selectable((knob->name() + ": " + knob->text() + " with " + other).c_str())) {
            comparison.start(*knob, other);
            started = true;
        }
        notePlace("compare " + knob->name());
    }
    if (gui.wantsPopupClosed()) ImGui::CloseCurrentPopup();
    ImGui::EndCombo();
    return started;
}

// Which view of the two; true when it has ended.
bool showCompared(Comparison& comparison) {
    using View = Comparison::View;
    wrapped(color::heading, "A: " + comparison.labelA() + "\nB: " + comparison.labelB());
    const std::array<std::pair<const char*, View>, 4> views{
        {{"divider", View::divider}, {"A", View::a}, {"B", View::b}, {"difference", View::difference}}};
    for (const auto& [name, view] : views) {
        if (view != View::divider) ImGui::SameLine(0, ImGui::GetStyle().ItemSpacing.x / 2);
        if (choiceButton(name, name, view == comparison.view())) comparison.setView(view);
    }
    if (comparison.view() == View::divider) wrapped(color::dim, "Drag the line in the picture, or press [ and ].");
    if (comparison.view() == View::difference && comparison.drawn()) {
        wrapped(comparison.difference());
        wrapped(color::dim, "Dark: the same. Orange to yellow: it differs, yellow the most.");
    }
    if (!button("Stop comparing", {ImGui::GetContentRegionAvail().x, 0})) return false;
    comparison.stop();
    return true;
}

}  // namespace

bool section(const char* title) {
    ImGui::Spacing();
    ImGui::PushStyleColor(ImGuiCol_Text, color::heading);
    Folds& folds = static_cast<Gui*>(ImGui::GetIO().UserData)->folds();
    const bool folded = folds.has(title);
    ImGui::SetNextItemOpen(!folded);
    const bool open = ImGui::CollapsingHeader(title);
    notePlace(std::string("section ") + title);
    ImGui::PopStyleColor();
    if (open == folded) folds.set(title, !open);
    return open;
}

bool showPresets(const DemoInfo& info, Demo& demo) {
    const ImGuiStyle& style = ImGui::GetStyle();
    const float gap = style.ItemSpacing.x / 2, right = ImGui::GetWindowContentRegionMax().x;
    float x = ImGui::GetCursorPosX();
    const Preset* present = nullptr;
    bool pressed = false;
    for (const Preset& preset : info.presets) {
        const float width = ImGui::CalcTextSize(preset.name.c_str()).x + 2 * style.FramePadding.x;
        // The next one in the line, while there is room for it
        if (&preset != info.presets.data()) {
            if (x + gap + width <= right) {
                ImGui::SameLine(0, gap);
                x += gap;
            } else {
                x = ImGui::GetCursorPosX();
            }
        }
        x += width;
        const bool chosen = !present && isAtPreset(demo, preset);
        if (chosen) present = &preset;
        if (choiceButton(preset.name.c_str(), "preset " + preset.name, chosen)) {
            applyPreset(demo, preset);
            pressed = true;
        }
        tooltip(preset.lookFor);
    }
    // As high as the longest of the sentences, so that nothing below moves away under the mouse
    const ImVec2 top = ImGui::GetCursorPos();
    float height = 0;
    for (const Preset& preset : info.presets) {
        height = std::max(height, ImGui::CalcTextSize(preset.lookFor.c_str(), nullptr, false, right - top.x).y);
    }
    wrapped(color::dim, present ? present->lookFor : "Settings of your own.");
    ImGui::SetCursorPos(top);
    ImGui::Dummy({0, height});
    return pressed;
}

void showReadouts(const Demo& demo, const Comparison& comparison) {
    const bool both = comparison.on() && !comparison.sideA().readouts.empty();
    float nameWidth = 0;
    for (const Readout* readout : demo.readouts()) {
        nameWidth = std::max(nameWidth, ImGui::CalcTextSize(readout->name().c_str()).x);
    }
    const float left = ImGui::GetCursorPosX(), number = ImGui::CalcTextSize("   -0.123456e+00").x;
    const float rightA =
        left + nameWidth + (both ? std::min(number, (ImGui::GetContentRegionAvail().x - nameWidth) / 2) : number);
    const float rightB = 2 * rightA - left - nameWidth;
    if (both) {
        ImGui::PushStyleColor(ImGuiCol_Text, color::heading);
        rightAligned("A", rightA);
        ImGui::SameLine();
        rightAligned("B", rightB);
        ImGui::PopStyleColor();
    }
    const auto text = [](std::optional<double> value) { return value ? formatted("%.6g", *value) : std::string("-"); };
    for (std::size_t i = 0; i < demo.readouts().size(); ++i) {
        const Readout& readout = *demo.readouts()[i];
        ImGui::BeginGroup();
        ImGui::TextUnformatted(readout.name().c_str());
        ImGui::SameLine();
        rightAligned(text(both ? comparison.sideA().readouts[i] : readout.value()), rightA);
        if (both) {
            ImGui::SameLine();
            rightAligned(text(comparison.sideB().readouts[i]), rightB);
        } else if (!readout.unit().empty()) {
            ImGui::SameLine();
            ImGui::TextDisabled("%s", readout.unit().c_str());
        }
        ImGui::EndGroup();
        tooltip(readout.help() + (both && !readout.unit().empty() ? "; in " + readout.unit() : "") +
                (readout.value() ? "" : "\n-: this setting does not measure it"));
    }
}

bool showComparison(Demo& demo, Comparison& comparison, Gui& gui) {
    return comparison.on() ? showCompared(comparison) : chooseComparison(demo, comparison, gui);
}

std::string showMatrices(const FrameNotes& notes) {
    std::string copied;
    for (const auto& [name, matrix] : notes.matrices) {
        ImGui::PushID(name.c_str());
        const bool open =
            ImGui::TreeNodeEx(name.c_str(), ImGuiTreeNodeFlags_DefaultOpen | ImGuiTreeNodeFlags_NoTreePushOnOpen |
                                                ImGuiTreeNodeFlags_SpanAvailWidth);
        tooltip(matrixTip(name));
        if (open) {
            showMatrix(notes, name, matrix);
            ImGui::TextColored(color::dim, "copy as");
            for (const auto& [label, form] :
                 {std::pair{"text", MatrixForm::text}, {"LaTeX", MatrixForm::latex}, {"C++", MatrixForm::cpp}}) {
                ImGui::SameLine();
                if (ImGui::SmallButton(label)) copied = matrixText(name, matrix, form);
                notePlace(name + " as " + label);
            }
        }
        ImGui::PopID();
    }
    return copied;
}

void showPasses(int done, int passes) {
    char text[48];
    std::snprintf(text, sizeof text, "pass %d of %d", done, passes);
    ImGui::ProgressBar(float(done) / float(passes), {-1, 0}, text);
    tooltip("the picture gets better with each pass; a setting that moves begins it anew");
}

bool showTime(Session& session, float scale) {
    Playback& playback = session.playback();
    bool moved = false;
    const ImVec2 size{70 * scale, 0};
    const bool playing = playback.playing();
    if (ImGui::Button(playing ? "Pause###pause" : "Play###pause", size)) playback.toggle();
    notePlace("Pause");
    tooltip("or the space bar");
    ImGui::SameLine();
    if (button("Step", size)) {
        playback.step();
        moved = true;
    }
    tooltip("one frame further, and pause there");
    ImGui::SameLine();
    if (button("Restart", size)) {
        session.restart();
        moved = true;
    }
    tooltip("back to frame 1, with the settings as they are now");
    auto speed = static_cast<float>(playback.speed());
    ImGui::SetNextItemWidth(2 * size.x + ImGui::GetStyle().ItemSpacing.x);
    if (ImGui::SliderFloat("##speed", &speed, 0.1F, 4, "speed %.1fx",
                           ImGuiSliderFlags_Logarithmic | ImGuiSliderFlags_NoInput)) {
        playback.setSpeed(std::clamp(double(std::round(speed * 10) / 10), 0.1, 4.0));
    }
    notePlace("time speed");  // a demo may have a knob of the other name
    tooltip("0.1 .. 4 times 60 frames a second");
    ImGui::SameLine();
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    int frame = playback.frame();
    if (ImGui::DragInt("##frame", &frame, 1, 0, std::numeric_limits<int>::max(), "frame %d",
                       ImGuiSliderFlags_AlwaysClamp)) {
        playback.goTo(frame);
        moved = true;
    }
    notePlace("frame");
    tooltip("drag to go back and forth");
    return moved;
}

bool isBound(const Demo& demo, char letter) {
    return std::any_of(demo.bindings().begin(), demo.bindings().end(), [&](const Binding& binding) {
        return binding.gesture == Gesture::key && binding.key == key(letter);
    });
}

void showControls(const Demo& demo, bool animated, bool menu, bool fromMenu, bool comparing) {
    std::vector<std::pair<std::string, std::string>> lines = controlsOf(demo);
    if (!demo.handles().empty())
        lines.emplace_back("Tab, arrows", "pick what can be dragged, and move it by a pixel (Shift: ten)");
    if (std::any_of(demo.handles().begin(), demo.handles().end(),
                    [](const Handle& handle) { return bool(handle.add); }))
        lines.emplace_back("Ins, Del", "one more of what is picked or under the mouse, or one less");
    // A letter that the demo has for itself does the window's part together with Ctrl.
    lines.emplace_back(isBound(demo, 'H') ? "Ctrl+H" : "H", "hide and show this panel");
    lines.emplace_back(isBound(demo, 'S') ? "Ctrl+S" : "S", "save the picture");
    if (comparing) lines.emplace_back("[ and ]", "move the line between A and B");
    if (animated) lines.emplace_back("Space", "pause and play");
    if (menu) lines.emplace_back("Backspace", "back to the menu");
    lines.emplace_back("Tab, F6", demo.handles().empty() ? "to this panel" : "after the last one, to this panel");
    lines.emplace_back("in the panel", "Tab, arrows: on; Space: press, or move by arrows; Enter: type; Esc: back");
    lines.emplace_back("Ctrl+Z", "undo a setting (with Shift: redo)");
    lines.emplace_back("F11", "full screen");
    lines.emplace_back("Ctrl + and -", "larger and smaller words (Ctrl+0: as they were)");
    lines.emplace_back("Ctrl+L", "a light panel, or a dark one");
    lines.emplace_back("Esc", menu && fromMenu ? "back to the menu" : "quit");
    lines.emplace_back("Ctrl+click", "type the value of a slider");
    float width = 0;
    for (const auto& [what, does] : lines) width = std::max(width, ImGui::CalcTextSize(what.c_str()).x);
    const float column = ImGui::GetCursorPosX() + width + 2 * ImGui::GetStyle().ItemSpacing.x;
    for (const auto& [what, does] : lines) {
        ImGui::TextUnformatted(what.c_str());
        ImGui::SameLine(column);
        wrapped(color::dim, does);
    }
}

float messagesHeight(const std::vector<Message>& messages, float width, float most) {
    if (messages.empty()) return 0;
    const ImGuiStyle& style = ImGui::GetStyle();
    float height = 0;
    for (const Message& message : messages) {
        height += ImGui::CalcTextSize(message.text.c_str(), nullptr, false, width - 2 * style.WindowPadding.x).y +
                  2 * style.FramePadding.y + style.ItemSpacing.y;
    }
    return std::min(std::ceil(height), most);
}

void showMessages(const std::vector<Message>& messages, float height) {
    const ImGuiStyle& style = ImGui::GetStyle();
    ImGui::BeginChild("messages", {0, height});
    for (const Message& message : messages) {
        const float width = ImGui::GetContentRegionAvail().x;
        const ImVec2 size = ImGui::CalcTextSize(message.text.c_str(), nullptr, false, width - 2 * style.FramePadding.x);
        const ImVec2 low = ImGui::GetCursorScreenPos();
        const ImVec2 high{low.x + width, low.y + size.y + 2 * style.FramePadding.y};
        ImGui::GetWindowDrawList()->AddRectFilled(
            low, high, ImGui::GetColorU32(message.error ? color::errorBack : color::noteBack), style.FrameRounding);
        ImGui::SetCursorScreenPos({low.x + style.FramePadding.x, low.y + style.FramePadding.y});
        ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width - 2 * style.FramePadding.x);
        ImGui::PushStyleColor(ImGuiCol_Text, message.error ? color::error : color::note);
        ImGui::TextUnformatted(message.text.c_str());
        ImGui::PopStyleColor();
        ImGui::PopTextWrapPos();
        ImGui::SetCursorScreenPos({low.x, high.y + style.ItemSpacing.y});
    }
    ImGui::EndChild();
}

}  // namespace mv

// Where widgets stood in the last frame, for those who drive the window by program.
#pragma once
#include <imgui.h>

#include <map>
#include <string>

namespace mv {

// Name -> upper left and lower right corner in window coordinates; --window --report=json prints it.
using Places = std::map<std::string, ImVec4>;

// Notes the widget made last under that name.
inline void notePlace(Places& places, const std::string& name) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    places[name] = {low.x, low.y, high.x, high.y};
}

// A button whose place is noted under its label.
inline bool button(Places& places, const char* label, ImVec2 size = {0, 0}) {
    const bool pressed = ImGui::Button(label, size);
    notePlace(places, label);
    return pressed;
}

}  // namespace mv

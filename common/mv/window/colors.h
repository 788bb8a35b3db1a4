// The colours of the panel, on a dark ground and on a light one.
#pragma once
#include <imgui.h>

namespace mv {

// Colours of words that mean something, as setColors() has them.
namespace color {
inline ImVec4 dim, heading, note, error, noteBack, errorBack;
}  // namespace color

// Sets those, and Dear ImGui's. Words have a contrast of 4.5 at least, by WCAG 2.1, to each ground that they stand on.
void setColors(ImGuiStyle& style, bool light);

}  // namespace mv

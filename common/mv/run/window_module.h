// The door between the programs and mvgl-window.so, the module with GLFW and Dear ImGui.
//
// The module is opened only to show a window, so that a headless run maps neither of them.
#pragma once
#include <vector>

#include "mv/run/command_line.h"

namespace mv {

// Opens a window with the command's demo, or the launcher's menu where it names none, and returns when it is closed.
// Error: no display, no module, or a driver without the OpenGL that is needed.
void openWindow(const Command& command);

// The function that the module exports, under the name below.
using WindowMain = void (*)(const Command& command);
inline constexpr const char* windowMainName = "mvglWindowMain";

}  // namespace mv

// The keys, the mouse and the wheel in a demo's picture, and what each does, for people.
#pragma once
#include <string>
#include <utility>
#include <vector>

namespace mv {

class Demo;

// A gesture and its effect: "Drag right", "spin-y +0.5 deg a pixel"; "Drag the light", "light-x, light-z". The demo's
// bindings, then its handles; what a host adds (Tab, Space) is the host's.
std::vector<std::pair<std::string, std::string>> controlsOf(const Demo& demo);

}  // namespace mv

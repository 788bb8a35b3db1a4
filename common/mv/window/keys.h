// Keys of the keyboard, as demos name them.
#pragma once
#include <optional>

#include "mv/demo/binding.h"

namespace mv {

// The demo's name for a key of GLFW's: a letter as the user's keyboard has it, a digit (also of the number pad), an
// arrow; nothing for all others.
std::optional<Key> demoKey(int glfwKey, int scancode);

}  // namespace mv

#include "mv/window/keys.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace mv {

std::optional<Key> demoKey(int glfwKey, int scancode) {
    switch (glfwKey) {
        case GLFW_KEY_LEFT:
            return Key::left;
        case GLFW_KEY_RIGHT:
            return Key::right;
        case GLFW_KEY_UP:
            return Key::up;
        case GLFW_KEY_DOWN:
            return Key::down;
        default:
            break;
    }
    if (glfwKey >= GLFW_KEY_KP_0 && glfwKey <= GLFW_KEY_KP_9) {
        return key(static_cast<char>('0' + (glfwKey - GLFW_KEY_KP_0)));
    }
    // The key's place says which digit it is where digits need Shift (on a French keyboard).
    if (glfwKey >= GLFW_KEY_0 && glfwKey <= GLFW_KEY_9) return key(static_cast<char>('0' + (glfwKey - GLFW_KEY_0)));
    const char* name = glfwGetKeyName(glfwKey, scancode);
    if (name && name[0] >= 'a' && name[0] <= 'z' && name[1] == '\0') return key(static_cast<char>(name[0] - 'a' + 'A'));
    if (glfwKey >= GLFW_KEY_A && glfwKey <= GLFW_KEY_Z && !name) {
        return key(static_cast<char>('A' + (glfwKey - GLFW_KEY_A)));
    }
    return {};
}

}  // namespace mv

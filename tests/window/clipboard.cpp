// Prints what is in the clipboard, as another program that it is pasted into would get it.
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <iostream>

int main() {
    if (!glfwInit()) return 1;
    glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
    glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
    GLFWwindow* window = glfwCreateWindow(1, 1, "clipboard", nullptr, nullptr);
    const char* text = window ? glfwGetClipboardString(window) : nullptr;
    if (text) std::cout << text << "\n";
    glfwTerminate();
    return text ? 0 : 1;
}

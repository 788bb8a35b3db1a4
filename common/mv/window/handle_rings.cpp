#include "mv/window/handle_rings.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

namespace mv {
namespace {

constexpr double reach = 12;     // pixels at ordinary density
constexpr float ringRadius = 8;  // pixels at ordinary density

}  // namespace

double handReach(const Gui& gui, const PictureInWindow& picture) {
    return reach * double(gui.scale()) * picture.pixelsPerUnit;
}

std::optional<HandleInput::Move> handleMove(int glfwKey) {
    switch (glfwKey) {
        case GLFW_KEY_TAB:
            return HandleInput::Move::next;
        case GLFW_KEY_INSERT:
            return HandleInput::Move::more;
        case GLFW_KEY_DELETE:
            return HandleInput::Move::less;
        case GLFW_KEY_ESCAPE:
            return HandleInput::Move::letGo;
        case GLFW_KEY_LEFT:
            return HandleInput::Move::left;
        case GLFW_KEY_RIGHT:
            return HandleInput::Move::right;
        case GLFW_KEY_UP:
            return HandleInput::Move::up;
        case GLFW_KEY_DOWN:
            return HandleInput::Move::down;
        default:
            return {};
    }
}

std::string showHandles(HandleInput& hand, const Demo& demo, const FrameInfo& frame, const PictureInWindow& picture,
                        bool mouseOver, const Gui& gui) {
    const ImVec2 mouse = ImGui::GetMousePos();
    std::optional<vec2> pointer;
    if (mouseOver) pointer = picture.pixel(double(mouse.x), double(mouse.y));
    hand.hover(demo, frame, pointer, handReach(gui, picture));
    std::string active;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float scale = gui.scale();
    for (const HandleInput::Place& place : hand.places(demo, frame)) {
        if (place.active) active = place.name;
        const vec2 at = picture.window(place.at);
        const ImVec2 middle{float(at.x), float(at.y)};
        const float radius = ringRadius * scale;
        notePlace("handle " + place.name, {middle.x - radius, middle.y - radius, middle.x + radius, middle.y + radius});
        if (!mouseOver && !hand.holds() && !hand.picks()) continue;
        // Light within dark, to be seen on any picture
        list.AddCircle(middle, radius, ImGui::GetColorU32(ImGuiCol_WindowBg), 0, (place.active ? 5.0F : 3.5F) * scale);
        list.AddCircle(middle, radius, ImGui::GetColorU32(place.active ? ImGuiCol_CheckMark : ImGuiCol_Text), 0,
                       (place.active ? 2.5F : 1.5F) * scale);
    }
    if (hand.isOver() || hand.holds()) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
    return active;
}

}  // namespace mv

#include "mv/window/hand.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "mv/error.h"
#include "mv/geometry/strokes.h"

namespace mv {
namespace {

constexpr double reach = 12;       // pixels at ordinary density: so near to a handle the mouse takes it
constexpr float ringRadius = 8;    // pixels at ordinary density
const vec2 newcomersStep(24, 24);  // pixels
constexpr double shiftSteps = 10;  // pixels

// What has no place in the present settings is not there.
std::optional<vec2> placeOf(const Handle& handle, const FrameInfo& frame, std::size_t which) {
    try {
        return handle.where(frame, which);
    } catch (const Error&) {
        return std::nullopt;
    }
}

}  // namespace

std::string Hand::nameOf(const Demo& demo, const Grip& grip) const {
    const Handle& handle = demo.handles()[grip.handle];
    return handle.count() == 1 ? handle.name : handle.name + " " + std::to_string(grip.which + 1);
}

std::vector<Hand::Place> Hand::placesOf(const Demo& demo, const FrameInfo& frame) const {
    std::vector<Place> all;
    for (std::size_t i = 0; i < demo.handles().size(); ++i) {
        const Handle& handle = demo.handles()[i];
        for (std::size_t which = 0; which < handle.count(); ++which) {
            const std::optional<vec2> at = placeOf(handle, frame, which);
            const Box picture{vec2(0), vec2(frame.width(), frame.height())};
            if (at && picture.holds(*at)) all.push_back({{i, which}, *at});
        }
    }
    return all;
}

std::optional<Hand::Place> Hand::nearest(const Demo& demo, const FrameInfo& frame, const PictureInWindow& picture,
                                         double x, double y) const {
    const vec2 pointer = picture.pixel(x, y);
    double least = reach * double(gui_.scale()) * picture.pixelsPerUnit;
    std::optional<Place> found;
    for (const Place& place : placesOf(demo, frame)) {
        const double distance = glm::length(place.at - pointer);
        if (distance > least) continue;
        least = distance;
        found = place;
    }
    return found;
}

bool Hand::press(Demo& demo, const FrameInfo& frame, const PictureInWindow& picture, double x, double y) {
    picked_.reset();
    held_.reset();
    if (const auto place = nearest(demo, frame, picture, x, y)) held_ = {place->grip, place->at - picture.pixel(x, y)};
    return held_.has_value();
}

bool Hand::move(Demo& demo, const FrameInfo& frame, const PictureInWindow& picture, double x, double y) {
    if (!held_) return false;
    const Handle& handle = demo.handles()[held_->grip.handle];
    return handle.drag(frame, held_->grip.which, picture.pixel(x, y) + held_->offset);
}

bool Hand::key(Demo& demo, const FrameInfo& frame, int glfwKey, bool shift, bool& moved) {
    if (glfwKey == GLFW_KEY_TAB) {
        const std::vector<Place> all = placesOf(demo, frame);
        auto next = all.begin();
        if (picked_) {
            next = std::find_if(all.begin(), all.end(), [&](const Place& place) { return place.grip == *picked_; });
            if (next != all.end()) ++next;
        }
        picked_.reset();
        if (next != all.end()) picked_ = next->grip;
        return !demo.handles().empty();
    }
    if (glfwKey == GLFW_KEY_INSERT || glfwKey == GLFW_KEY_DELETE) {
        const std::optional<Grip> meant = picked_ ? picked_ : under_;
        if (!meant) return false;
        const Handle& handle = demo.handles()[meant->handle];
        const auto& change = glfwKey == GLFW_KEY_INSERT ? handle.add : handle.remove;
        moved = change && change(meant->which);
        if (!moved) return true;
        held_.reset();
        picked_.reset();
        under_.reset();
        // A new one would be hidden by the one that it was made from
        if (glfwKey == GLFW_KEY_INSERT) {
            picked_ = {meant->handle, meant->which + 1};
            const std::optional<vec2> at = placeOf(handle, frame, picked_->which);
            if (at) handle.drag(frame, picked_->which, *at + newcomersStep);
        }
        return true;
    }
    if (!picked_) return false;
    if (glfwKey == GLFW_KEY_ESCAPE) {
        picked_.reset();
        return true;
    }
    const double steps = shift ? shiftSteps : 1;
    vec2 step(0);
    if (glfwKey == GLFW_KEY_LEFT) step = {-steps, 0};
    if (glfwKey == GLFW_KEY_RIGHT) step = {steps, 0};
    if (glfwKey == GLFW_KEY_UP) step = {0, steps};
    if (glfwKey == GLFW_KEY_DOWN) step = {0, -steps};
    if (step == vec2(0)) return false;
    const Handle& handle = demo.handles()[picked_->handle];
    if (const auto at = placeOf(handle, frame, picked_->which)) moved = handle.drag(frame, picked_->which, *at + step);
    return true;
}

void Hand::show(const Demo& demo, const FrameInfo& frame, const PictureInWindow& picture, bool mouseOver) {
    hovered_.clear();
    // Points may have been taken away beside this
    const auto isGone = [&](const Grip& grip) { return grip.which >= demo.handles()[grip.handle].count(); };
    if (picked_ && isGone(*picked_)) picked_.reset();
    if (held_ && isGone(held_->grip)) held_.reset();
    const ImVec2 mouse = ImGui::GetMousePos();
    std::optional<Place> under;
    if (mouseOver && !held_) under = nearest(demo, frame, picture, double(mouse.x), double(mouse.y));
    under_.reset();
    if (under) under_ = under->grip;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float scale = gui_.scale();
    for (const Place& place : placesOf(demo, frame)) {
        const std::string name = nameOf(demo, place.grip);
        const bool active = (under && under->grip == place.grip) || (held_ && held_->grip == place.grip) ||
                            (picked_ && *picked_ == place.grip);
        if (active) hovered_ = name;
        const vec2 at = picture.window(place.at);
        const ImVec2 middle{float(at.x), float(at.y)};
        const float radius = ringRadius * scale;
        notePlace("handle " + name, {middle.x - radius, middle.y - radius, middle.x + radius, middle.y + radius});
        if (!mouseOver && !held_ && !picked_) continue;
        // Light within dark, to be seen on any picture
        list.AddCircle(middle, radius, ImGui::GetColorU32(ImGuiCol_WindowBg), 0, (active ? 5.0F : 3.5F) * scale);
        list.AddCircle(middle, radius, ImGui::GetColorU32(active ? ImGuiCol_SliderGrabActive : ImGuiCol_Text), 0,
                       (active ? 2.5F : 1.5F) * scale);
    }
    if (under || held_) ImGui::SetMouseCursor(ImGuiMouseCursor_Hand);
}

}  // namespace mv

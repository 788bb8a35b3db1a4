#include "mv/window/step_section.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mv/image/compare.h"
#include "mv/window/gui.h"

namespace mv {
namespace {

constexpr int longestSide = 320;  // of a buffer's picture, in pixels
constexpr int loupeReach = 5;     // pixels to each side of the one that is magnified

std::string sizeText(int width, int height) { return std::to_string(width) + " x " + std::to_string(height); }

// The pixels round that one, magnified, and a frame round it; `cell` is the side of each.
void showLoupe(const Picture& picture, const glm::ivec2& pixel, ImVec2 corner, float cell) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    for (int y = -loupeReach; y <= loupeReach; ++y) {
        for (int x = -loupeReach; x <= loupeReach; ++x) {
            const glm::ivec2 at = pixel + glm::ivec2(x, y);
            if (at.x < 0 || at.y < 0 || at.x >= picture.width || at.y >= picture.height) continue;
            const std::uint8_t* rgba =
                &picture.rgba[4 * (std::size_t(at.y) * std::size_t(picture.width) + std::size_t(at.x))];
            const ImVec2 low{corner.x + float(x + loupeReach) * cell, corner.y + float(y + loupeReach) * cell};
            list.AddRectFilled(low, {low.x + cell, low.y + cell}, IM_COL32(rgba[0], rgba[1], rgba[2], 255));
        }
    }
    // Light within dark, to be seen on any colour
    const ImVec2 low{corner.x + float(loupeReach) * cell, corner.y + float(loupeReach) * cell};
    list.AddRect({low.x - 2, low.y - 2}, {low.x + cell + 2, low.y + cell + 2}, IM_COL32_BLACK);
    list.AddRect({low.x - 1, low.y - 1}, {low.x + cell + 1, low.y + cell + 1}, IM_COL32_WHITE);
}

}  // namespace

bool StepSection::show(const std::optional<glm::ivec2>& pixel) {
    const float width = ImGui::GetContentRegionAvail().x;
    if (!session_.until()) {
        buffers_.clear();
        picture_ = -1;
        const bool pressed = button("Step through the draws", {width, 0});
        tooltip("stops the frame after one of its draws, and shows what that draw is made of; or --until K");
        if (pressed) {
            session_.setSamples(0);
            session_.stopAfter(1);
            begins_ = true;
        }
        return pressed;
    }
    if (!session_.steps()) {  // no setting has made a picture yet
        if (!button("Show the whole frame", {width, 0})) return false;
        session_.stopAfter({});
        return true;
    }
    const FrameSteps steps = *session_.steps();  // a copy: another picture may come before the end
    bool moved = showSlider(steps);
    if (button("Show the whole frame", {width, 0})) {
        session_.stopAfter({});
        moved = true;
    }
    if (session_.error().empty()) {
        showDraw(steps);
        showBuffers(steps, pixel);
    }
    return moved;
}

void StepSection::outline(int width) {
    if (outlinedPicture_ == session_.picturesDrawn()) return;
    outlinedPicture_ = session_.picturesDrawn();
    outlined_.reset();
    line_.reset();
    if (!session_.until() || !session_.steps() || !session_.error().empty()) return;
    const int until = session_.steps()->until;
    if (until == 0 || !session_.steps()->draws[static_cast<std::size_t>(until) - 1].inPicture) return;
    // Draw what was there before, and then again what is shown
    const Picture after = stage_.picture();
    stage_.stopAfter(session_.drawnFrame(), until - 1);
    const Picture before = stage_.picture();
    stage_.stopAfter(session_.drawnFrame(), until);
    outlined_ = compare(before, after).beyond;
    if (*outlined_ > 0) line_.emplace(context_, differenceOutline(before, after, width));
}

void StepSection::showOutline(float wide, float high) const {
    if (line_ && outlined_ && session_.until())
        ImGui::GetBackgroundDrawList()->AddImage(line_->imguiId(), {0, 0}, {wide, high});
}

bool StepSection::showSlider(const FrameSteps& steps) {
    const int all = static_cast<int>(steps.draws.size());
    int until = *session_.until();
    const float arrow = ImGui::GetFrameHeight(), gap = ImGui::GetStyle().ItemSpacing.x / 2;
    const auto step = [&](const char* label, const char* tip, int by) {
        const bool pressed = button(label, {arrow, 0});
        tooltip(tip);
        if (pressed) until = std::clamp(until + by, 0, all);
    };
    step("<##draw", "one draw less", -1);
    ImGui::SameLine(0, gap);
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x - arrow - gap);
    const std::string words = until == 0 ? "before draw 1 of " : until == 1 ? "draw 1 of " : "draws 1 to %d of ";
    ImGui::SliderInt("##until", &until, 0, all, (words + std::to_string(all)).c_str(),
                     ImGuiSliderFlags_NoInput | ImGuiSliderFlags_AlwaysClamp);
    notePlace("until");
    tooltip("the frame stops after this draw; what comes later is left out, clears and copies, too");
    ImGui::SameLine(0, gap);
    // The keys that were at the button which is gone go on here
    if (std::exchange(begins_, false)) ImGui::SetKeyboardFocusHere();
    step(">##draw", "one draw more", 1);
    if (until == *session_.until()) return false;
    session_.stopAfter(until);
    return true;
}

void StepSection::showDraw(const FrameSteps& steps) const {
    if (steps.until == 0) {
        wrapped(color::dim, "Nothing is drawn yet: the picture is as it was cleared.");
        return;
    }
    const DrawStep& draw = steps.draws[static_cast<std::size_t>(steps.until) - 1];
    wrapped("Draw " + std::to_string(steps.until) + ": " + draw.mesh + "\nprogram " + draw.program + "\n" +
            std::to_string(draw.count) + (draw.indexed ? " indices" : " vertices") + " as " + draw.primitive +
            "\ninto " + (draw.inPicture ? "the picture" : draw.target + ", " + sizeText(draw.width, draw.height)));
    if (outlined_)
        wrapped(*outlined_ > 0 ? "It changes " + std::to_string(*outlined_) + " pixels, which have a line round them."
                               : "It changes no pixel of the picture.");
    wrapped(color::heading, "State that is not the initial one");
    if (draw.state.empty()) wrapped(color::dim, "none");
    for (const std::string& call : draw.state) wrapped(color::dim, call);
}

void StepSection::showBuffers(const FrameSteps& steps, std::optional<glm::ivec2> pixel) {
    if (picture_ != session_.picturesDrawn()) {
        picture_ = session_.picturesDrawn();
        buffers_.clear();
        for (const BufferPicture& buffer : steps.shown.buffers) {
            Picture small =
                buffer.picture.rgba.empty() ? Picture(1, 1) : shrink(buffer.picture, longestSide, longestSide);
            // The section shows the colour; its opacity is the window's affair.
            for (std::size_t i = 3; i < small.rgba.size(); i += 4) small.rgba[i] = 255;
            buffers_.emplace_back(context_, small);
        }
    }
    const TargetPictures& shown = steps.shown;
    wrapped(
        color::heading,
        "Buffers of " + (shown.isPicture ? "the picture" : shown.target + ", " + sizeText(shown.width, shown.height)));
    // What a pixel of them has: of a buffer below, or of the picture where it is theirs
    if (!shown.isPicture) pixel.reset();
    const ImVec2 at = ImGui::GetMousePos();
    for (std::size_t i = 0; i < placed_.size() && i < shown.buffers.size(); ++i) {
        const auto& [left, top, right, bottom] = placed_[i];
        if (at.x < left || at.y < top || at.x >= right || at.y >= bottom || !ImGui::IsWindowHovered()) continue;
        const Picture& picture = shown.buffers[i].picture;
        pixel = glm::ivec2(int((at.x - left) / (right - left) * float(picture.width)),
                           int((at.y - top) / (bottom - top) * float(picture.height)));
    }
    placed_.assign(buffers_.size(), {});
    const float width = ImGui::GetContentRegionAvail().x, gap = ImGui::GetStyle().ItemSpacing.x;
    const ImVec2 top = ImGui::GetCursorPos();
    std::string values;
    for (const BufferPicture& buffer : shown.buffers) {
        const std::string value = pixel ? valueAt(buffer, pixel->x, pixel->y) : "";
        if (!value.empty()) values += "\n" + buffer.name + " " + value;
    }
    if (values.empty())
        wrapped(color::dim, "The mouse over one of them shows what a pixel has.");
    else
        wrapped("pixel " + std::to_string(pixel->x) + ", " + std::to_string(pixel->y) + " from the upper left" +
                values);
    notePlace("pixel values");
    // As high without a pixel, so that no buffer moves from under the mouse
    const float cell = std::floor((width - 2 * gap) / 3 / (2 * loupeReach + 1)), side = cell * (2 * loupeReach + 1);
    const float loupes = top.y + float(shown.buffers.size() + 1) * ImGui::GetTextLineHeightWithSpacing();
    ImGui::SetCursorPos({top.x, loupes});
    const ImVec2 corner = ImGui::GetCursorScreenPos();
    for (std::size_t i = 0; pixel && i < shown.buffers.size(); ++i) {
        const BufferPicture& buffer = shown.buffers[i];
        if (valueAt(buffer, pixel->x, pixel->y).empty()) continue;
        const ImVec2 at{corner.x + float(i) * (side + gap), corner.y};
        showLoupe(buffer.picture, *pixel, at, cell);
        notePlace("loupe " + buffer.name, {at.x, at.y, at.x + side, at.y + side});
    }
    ImGui::Dummy({width, side});
    for (std::size_t i = 0; i < buffers_.size(); ++i) {
        const BufferPicture& buffer = shown.buffers[i];
        wrapped(color::dim, buffer.name + ": " + buffer.range);
        if (buffer.picture.rgba.empty()) continue;
        const float wide = std::min(width, width * float(buffers_[i].width()) / float(buffers_[i].height()));
        ImGui::Image(buffers_[i].imguiId(), {wide, wide * float(buffers_[i].height()) / float(buffers_[i].width())});
        notePlace("buffer " + buffer.name);
        const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
        placed_[i] = {low.x, low.y, high.x, high.y};
    }
}

}  // namespace mv

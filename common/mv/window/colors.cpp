#include "mv/window/colors.h"

#include <array>

namespace mv {
namespace {

// Each colour on a dark ground and on a light one.
struct GroundColor {
    ImGuiCol which;
    ImVec4 dark, light;
};
const auto groundColors = std::to_array<GroundColor>({
    {ImGuiCol_WindowBg, {0.118F, 0.129F, 0.149F, 1}, {0.965F, 0.969F, 0.976F, 1}},
    {ImGuiCol_PopupBg, {0.157F, 0.173F, 0.200F, 1}, {1, 1, 1, 1}},
    {ImGuiCol_Text, {0.925F, 0.937F, 0.957F, 1}, {0.10F, 0.12F, 0.15F, 1}},
    {ImGuiCol_TextDisabled, {0.72F, 0.755F, 0.81F, 1}, {0.32F, 0.35F, 0.40F, 1}},
    {ImGuiCol_Border, {0.275F, 0.302F, 0.345F, 1}, {0.72F, 0.75F, 0.79F, 1}},
    {ImGuiCol_FrameBg, {0.192F, 0.212F, 0.247F, 1}, {0.875F, 0.890F, 0.914F, 1}},
    {ImGuiCol_FrameBgHovered, {0.235F, 0.263F, 0.310F, 1}, {0.82F, 0.85F, 0.89F, 1}},
    {ImGuiCol_FrameBgActive, {0.263F, 0.298F, 0.357F, 1}, {0.77F, 0.82F, 0.88F, 1}},
    {ImGuiCol_SliderGrab, {0.22F, 0.43F, 0.70F, 1}, {0.47F, 0.69F, 0.95F, 1}},
    {ImGuiCol_SliderGrabActive, {0.20F, 0.40F, 0.65F, 1}, {0.38F, 0.62F, 0.91F, 1}},
    {ImGuiCol_CheckMark, {0.549F, 0.753F, 1.0F, 1}, {0.10F, 0.33F, 0.63F, 1}},
    {ImGuiCol_Button, {0.204F, 0.302F, 0.424F, 1}, {0.78F, 0.86F, 0.95F, 1}},
    {ImGuiCol_ButtonHovered, {0.259F, 0.388F, 0.545F, 1}, {0.69F, 0.81F, 0.94F, 1}},
    {ImGuiCol_ButtonActive, {0.28F, 0.43F, 0.60F, 1}, {0.60F, 0.75F, 0.91F, 1}},
    {ImGuiCol_Header, {0.165F, 0.184F, 0.216F, 1}, {0.90F, 0.92F, 0.945F, 1}},
    {ImGuiCol_HeaderHovered, {0.216F, 0.247F, 0.298F, 1}, {0.85F, 0.88F, 0.92F, 1}},
    {ImGuiCol_HeaderActive, {0.243F, 0.282F, 0.345F, 1}, {0.80F, 0.84F, 0.89F, 1}},
    {ImGuiCol_Separator, {0.235F, 0.259F, 0.298F, 1}, {0.80F, 0.82F, 0.85F, 1}},
    {ImGuiCol_NavHighlight, {1.0F, 0.80F, 0.35F, 1}, {0.66F, 0.35F, 0, 1}},
    {ImGuiCol_ScrollbarGrab, {0.290F, 0.318F, 0.365F, 1}, {0.70F, 0.73F, 0.77F, 1}},
});
struct WordColor {
    ImVec4* which;
    ImVec4 dark, light;
};
const auto wordColors = std::to_array<WordColor>({
    {&color::dim, {0.72F, 0.755F, 0.81F, 1}, {0.32F, 0.35F, 0.40F, 1}},
    {&color::heading, {0.55F, 0.78F, 1.00F, 1}, {0.06F, 0.32F, 0.60F, 1}},
    {&color::note, {1.00F, 0.80F, 0.35F, 1}, {0.45F, 0.29F, 0, 1}},
    {&color::error, {1.00F, 0.52F, 0.48F, 1}, {0.70F, 0.10F, 0.08F, 1}},
    {&color::noteBack, {0.26F, 0.20F, 0.07F, 1}, {0.99F, 0.94F, 0.80F, 1}},
    {&color::errorBack, {0.33F, 0.09F, 0.09F, 1}, {0.99F, 0.87F, 0.86F, 1}},
});

}  // namespace

void setColors(ImGuiStyle& style, bool light) {
    (light ? ImGui::StyleColorsLight : ImGui::StyleColorsDark)(&style);
    for (const GroundColor& color : groundColors) style.Colors[color.which] = light ? color.light : color.dark;
    for (const WordColor& color : wordColors) *color.which = light ? color.light : color.dark;
    for (const ImGuiCol clear : {ImGuiCol_ChildBg, ImGuiCol_ScrollbarBg}) style.Colors[clear] = {0, 0, 0, 0};
}

}  // namespace mv

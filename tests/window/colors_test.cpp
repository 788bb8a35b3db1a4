// The panel's words can be read: each colour of words on each ground that it stands on, dark and light.
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "mv/math/color.h"
#include "mv/math/color_difference.h"
#include "mv/window/colors.h"

namespace {

double contrast(const ImVec4& a, const ImVec4& b) {
    const auto linear = [](const ImVec4& c) { return mv::linearFromSrgb(mv::vec3(c.x, c.y, c.z)); };
    return mv::contrast(linear(a), linear(b));
}

class Colors : public testing::TestWithParam<bool> {
  protected:
    void SetUp() override { mv::setColors(style_, GetParam()); }
    const ImVec4& of(ImGuiCol which) const { return style_.Colors[which]; }
    void expectReadable(const std::string& words, const ImVec4& color, const std::vector<ImGuiCol>& grounds) {
        for (const ImGuiCol ground : grounds)
            EXPECT_GE(contrast(color, of(ground)), 4.5) << words << " on " << ImGui::GetStyleColorName(ground);
    }

  private:
    ImGuiStyle style_;
};

TEST_P(Colors, words_have_a_contrast_of_at_least_4_5_to_what_is_behind_them) {
    expectReadable(
        "words", of(ImGuiCol_Text),
        {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive,
         ImGuiCol_SliderGrab, ImGuiCol_SliderGrabActive, ImGuiCol_Button, ImGuiCol_ButtonHovered, ImGuiCol_ButtonActive,
         ImGuiCol_Header, ImGuiCol_HeaderHovered, ImGuiCol_HeaderActive});
    // In fields, lists of options (whose chosen one has a button's ground) and beside readouts
    expectReadable("faint words", of(ImGuiCol_TextDisabled),
                   {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_Button,
                    ImGuiCol_HeaderHovered, ImGuiCol_HeaderActive});
    expectReadable("dim words", mv::color::dim, {ImGuiCol_WindowBg, ImGuiCol_PopupBg});
    expectReadable(
        "a heading", mv::color::heading,
        {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_Header, ImGuiCol_HeaderHovered, ImGuiCol_HeaderActive});
    expectReadable("a note", mv::color::note, {ImGuiCol_WindowBg});
    expectReadable("an error", mv::color::error, {ImGuiCol_WindowBg});
    EXPECT_GE(contrast(mv::color::note, mv::color::noteBack), 4.5);
    EXPECT_GE(contrast(mv::color::error, mv::color::errorBack), 4.5);
    EXPECT_GE(contrast(of(ImGuiCol_Text), mv::color::errorBack), 4.5) << "what is typed, where it is refused";
    EXPECT_GE(contrast(of(ImGuiCol_WindowBg), mv::color::heading), 4.5) << "the chosen preset";
}

// WCAG 2.1, 1.4.11: parts of the interface have 3.
TEST_P(Colors, marks_have_a_contrast_of_at_least_3) {
    for (const ImGuiCol ground : {ImGuiCol_FrameBg, ImGuiCol_FrameBgHovered, ImGuiCol_FrameBgActive})
        EXPECT_GE(contrast(of(ImGuiCol_CheckMark), of(ground)), 3);
    for (const ImGuiCol ground : {ImGuiCol_WindowBg, ImGuiCol_FrameBg, ImGuiCol_Button})
        EXPECT_GE(contrast(of(ImGuiCol_NavHighlight), of(ground)), 3);
}

TEST_P(Colors, no_ground_is_seen_through) {
    for (const ImGuiCol ground :
         {ImGuiCol_WindowBg, ImGuiCol_PopupBg, ImGuiCol_FrameBg, ImGuiCol_SliderGrab, ImGuiCol_Button, ImGuiCol_Header})
        EXPECT_EQ(of(ground).w, 1);
}

INSTANTIATE_TEST_SUITE_P(Panel, Colors, testing::Bool(),
                         [](const auto& of) { return std::string(of.param ? "light" : "dark"); });

}  // namespace

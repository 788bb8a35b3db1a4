#include "mv/window/gui.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui_impl_glfw.h>
#include <imgui_impl_opengl3.h>
#include <imgui_internal.h>  // what makes the focus visible, in older ones

#include <algorithm>
#include <array>
#include <cfloat>
#include <cmath>
#include <limits>

#include "mv/error.h"
#include "mv/gl/font.h"
#include "mv/window/colors.h"

namespace mv {
namespace {

constexpr double tipDelay = 0.5;  // seconds

// Latin, Greek (angles), dashes and quotes, arrows, mathematics, shapes: what sentences about graphics are made of.
constexpr ImWchar glyphRanges[] = {0x20,   0x17F,  0x370,  0x3FF,  0x2010, 0x2044, 0x2070, 0x209C,
                                   0x2190, 0x21FF, 0x2200, 0x22FF, 0x25A0, 0x25FF, 0};

ImFont* addFont(double size) {
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    config.OversampleH = 2;
    const auto bytes = fontFile();
    // ImGui takes the bytes without const, and without changing them.
    void* data = const_cast<std::byte*>(bytes.data());
    return ImGui::GetIO().Fonts->AddFontFromMemoryTTF(data, static_cast<int>(bytes.size()),
                                                      static_cast<float>(std::round(size)), &config, glyphRanges);
}

}  // namespace

Gui::Gui(Window& window) : window_(window) {
    IMGUI_CHECKVERSION();
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // nothing is written into the folder one happens to stand in
    io.LogFilename = nullptr;
    io.UserData = this;                     // what notePlace() finds without being told of it
    io.ConfigInputTextCursorBlink = false;  // a blinking bar would have the window drawn for ever
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), false);
    ImGui_ImplOpenGL3_Init("#version 330");
}

Gui::~Gui() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void Gui::setLooks() {
    const double contentScale = window_.contentScale(), pixelsPerUnit = window_.size().pixelsPerUnit();
    if (contentScale == contentScale_ && pixelsPerUnit == pixelsPerUnit_ && zoom_ == zoomed_ && light_ == lit_) return;
    zoomed_ = zoom_;
    lit_ = light_;
    contentScale_ = contentScale;
    pixelsPerUnit_ = pixelsPerUnit;
    scale_ = static_cast<float>(contentScale * zoom_ / pixelsPerUnit);

    ImGuiStyle style;
    setColors(style, light_);
    style.WindowRounding = 0;
    style.WindowBorderSize = 0;
    style.WindowPadding = {12, 12};
    style.FramePadding = {8, 4};
    style.FrameRounding = style.GrabRounding = style.PopupRounding = style.ChildRounding = 4;
    style.ItemSpacing = {8, 6};
    style.ItemInnerSpacing = {6, 4};
    style.ScrollbarSize = 12;
    style.GrabMinSize = 12;
    style.ScaleAllSizes(scale_);
    ImGui::GetStyle() = style;

    // Letters are made for the framebuffer's own pixels and laid out in window coordinates.
    ImGuiIO& io = ImGui::GetIO();
    io.Fonts->Clear();
    ImFont* body = addFont(15 * contentScale * zoom_);
    title_ = addFont(20 * contentScale * zoom_);
    if (!body || !title_) throw Error("font", "must be a TrueType file");
    io.FontDefault = body;
    io.FontGlobalScale = static_cast<float>(1 / pixelsPerUnit);
    ImGui_ImplOpenGL3_DestroyFontsTexture();  // made again by the next frame
    ImGui_ImplOpenGL3_CreateFontsTexture();
}

void Gui::feed(const Event& event) {
    GLFWwindow* handle = window_.handle();
    mouseX_ = event.x;
    mouseY_ = event.y;
    // Tab goes from handle to handle of the picture, and in the panel from widget to widget: to Dear ImGui it would open the
    // next field for typing.
    if ((event.kind == Event::Kind::key || event.kind == Event::Kind::keyUp) && event.key == GLFW_KEY_TAB) {
        if (event.kind == Event::Kind::key)
            tabAs_ = !navigating_ || typing()                  ? 0
                     : (event.modifiers & GLFW_MOD_SHIFT) != 0 ? GLFW_KEY_UP
                                                               : GLFW_KEY_DOWN;
        if (tabAs_ != 0 && !event.repeat) {
            ImGui_ImplGlfw_KeyCallback(handle, tabAs_, 0, event.kind == Event::Kind::key ? GLFW_PRESS : GLFW_RELEASE,
                                       0);
        }
        return;
    }
    switch (event.kind) {
        case Event::Kind::key:
            if (!event.repeat) {
                ImGui_ImplGlfw_KeyCallback(handle, event.key, event.scancode, GLFW_PRESS, event.modifiers);
            }
            break;
        case Event::Kind::keyUp:
            ImGui_ImplGlfw_KeyCallback(handle, event.key, event.scancode, GLFW_RELEASE, event.modifiers);
            break;
        case Event::Kind::character:
            ImGui_ImplGlfw_CharCallback(handle, event.codePoint);
            break;
        case Event::Kind::press:
        case Event::Kind::release:
            if (event.key >= 0 && event.key < ImGuiMouseButton_COUNT) {
                down_[static_cast<std::size_t>(event.key)] = event.kind == Event::Kind::press;
            }
            break;
        case Event::Kind::wheel:
            ImGui_ImplGlfw_ScrollCallback(handle, event.across, event.notches);
            break;
        case Event::Kind::move:
        case Event::Kind::drop:
        case Event::Kind::other:
            break;
    }
}

void Gui::setNavigation(bool on) {
    navigating_ = on;
    ImGuiIO& io = ImGui::GetIO();
    if (on)
        io.ConfigFlags |= ImGuiConfigFlags_NavEnableKeyboard;
    else
        io.ConfigFlags &= ~ImGuiConfigFlags_NavEnableKeyboard;
}

bool Gui::tipDue(const ImVec2& corner) {
    tipAsked_ = true;
    if (corner.x != tipCorner_.x || corner.y != tipCorner_.y || ImGui::IsAnyMouseDown()) {
        tipCorner_ = corner;
        tipSince_ = glfwGetTime();
    }
    tipShown_ = glfwGetTime() - tipSince_ >= tipDelay && !ImGui::IsAnyMouseDown();
    return tipShown_;
}

double Gui::untilTip() const {
    if (!tipAsked_ || tipShown_ || ImGui::IsAnyMouseDown()) return std::numeric_limits<double>::infinity();
    return std::max(tipSince_ + tipDelay - glfwGetTime(), 0.0);
}

void Gui::begin() {
    places_.clear();
    if (!tipAsked_) tipCorner_ = {-1, -1};
    tipAsked_ = tipShown_ = false;
    tip_.clear();
    focusing_.clear();
    setLooks();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    // The backend asks how large the window is, where the mouse is and what is pressed by now; the events of this frame may
    // not be as far yet.
    ImGuiIO& io = ImGui::GetIO();
    const WindowSize& size = window_.size();
    io.DisplaySize = {static_cast<float>(size.width()), static_cast<float>(size.height())};
    io.DisplayFramebufferScale = {static_cast<float>(size.pixelsPerUnit()),
                                  static_cast<float>(size.pixelsPerUnitDown())};
    const bool here = glfwGetWindowAttrib(window_.handle(), GLFW_HOVERED) != 0;
    const bool held = std::any_of(down_.begin(), down_.end(), [](bool down) { return down; });
    io.MousePos =
        here || held ? ImVec2(static_cast<float>(mouseX_), static_cast<float>(mouseY_)) : ImVec2(-FLT_MAX, -FLT_MAX);
    std::copy(down_.begin(), down_.end(), io.MouseDown);
    ImGui::NewFrame();
}

void Gui::end() {
    popupOpen_ = ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopup);
    closePopup_ = false;
    focused_ = navigating_ ? focusing_ : "";
    ImGui::Render();
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

void notePlace(const std::string& name) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    notePlace(name, {low.x, low.y, high.x, high.y});
    if (ImGui::IsItemFocused()) static_cast<Gui*>(ImGui::GetIO().UserData)->focusing_ = name;
}

void notePlace(const std::string& name, const ImVec4& place) {
    static_cast<Gui*>(ImGui::GetIO().UserData)->places_[name] = place;
}

bool button(const char* label, ImVec2 size) {
    const bool pressed = ImGui::Button(label, size);
    notePlace(label);
    return pressed;
}

void showFocus() {
#if IMGUI_VERSION_NUM >= 19140
    ImGui::SetNavCursorVisible(true);
#else
    ImGui::GetCurrentContext()->NavDisableHighlight = false;
#endif
}

void beginReachable(const char* name, const ImVec2& size) {
#if IMGUI_VERSION_NUM >= 19090
    ImGui::BeginChild(name, size, ImGuiChildFlags_NavFlattened, ImGuiWindowFlags_AlwaysVerticalScrollbar);
#else
    ImGui::BeginChild(name, size, false, ImGuiWindowFlags_AlwaysVerticalScrollbar | ImGuiWindowFlags_NavFlattened);
#endif
}

std::string brokenAtSpaces(const std::string& text, float width) {
    std::string broken, line;
    for (std::size_t from = 0; from < text.size();) {
        // A word with the space before it, or the end of a line
        std::size_t end = std::min(text.find_first_of(" \n", from + 1), text.size());
        if (text[from] == '\n') end = from + 1;
        const std::string word = text.substr(from, end - from);
        from = end;
        if (word == "\n" || (!line.empty() && ImGui::CalcTextSize((line + word).c_str()).x > width)) {
            broken += line + "\n";
            line = word.substr(word.front() == ' ' || word.front() == '\n' ? 1 : 0);
        } else {
            line += word;
        }
    }
    return broken + line;
}

void tooltip(const std::string& text) {
    if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
    Gui& gui = *static_cast<Gui*>(ImGui::GetIO().UserData);
    if (!gui.tipDue(ImGui::GetItemRectMin())) return;
    gui.setTip(text);
    const float width = ImGui::GetFontSize() * 20, gap = ImGui::GetStyle().WindowPadding.x;
    // Beside the panel, where there is room: below it would cover the next widget
    const float left = ImGui::GetWindowPos().x - gap;
    if (left > width + 2 * gap) ImGui::SetNextWindowPos({left, ImGui::GetItemRectMin().y}, ImGuiCond_Always, {1, 0});
    ImGui::BeginTooltip();
    ImGui::TextUnformatted(brokenAtSpaces(text, width).c_str());
    ImGui::EndTooltip();
}

void wrapped(const std::string& text) {
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(brokenAtSpaces(text, ImGui::GetContentRegionAvail().x).c_str());
    ImGui::PopTextWrapPos();
}

void wrapped(const ImVec4& color, const std::string& text) {
    ImGui::PushStyleColor(ImGuiCol_Text, color);
    wrapped(text);
    ImGui::PopStyleColor();
}

}  // namespace mv

// Dear ImGui in the window: its start and end, its looks, and its frames.
#pragma once
#include <imgui.h>

#include <array>
#include <map>
#include <string>

#include "mv/window/colors.h"
#include "mv/window/folds.h"
#include "mv/window/window.h"

namespace mv {

// The places of a frame's widgets, for those who drive the window by program: name -> upper left and lower right corner
// in window coordinates.
using Places = std::map<std::string, ImVec4>;

class Gui {
  public:
    // Made after the window, and goes before it.
    explicit Gui(Window& window);
    ~Gui();
    Gui(const Gui&) = delete;
    Gui& operator=(const Gui&) = delete;

    // Tells the widgets of an event, before the frame it belongs to.
    void feed(const Event& event);
    // Between the two stand the widgets of one frame; end() draws them into the window.
    void begin();
    void end();

    // Window coordinates for each pixel of a design at ordinary density.
    float scale() const { return scale_; }
    ImFont* titleFont() const { return title_; }
    // Words and widgets as many times as large as the screen's density has them.
    void setZoom(double zoom) { zoom_ = zoom; }
    double zoom() const { return zoom_; }
    // Dark words on a light ground; else light ones on a dark.
    void setLight(bool light) { light_ = light; }
    bool light() const { return light_; }
    // The keys go from widget to widget: arrows and Tab, Space presses, Enter types. Else they are the screen's.
    void setNavigation(bool on);
    bool navigating() const { return navigating_; }
    // The widget that the keys are at, by its place's name; "" for none.
    const std::string& focused() const { return focused_; }
    // The keyboard writes into a field just now.
    bool typing() const { return ImGui::GetIO().WantTextInput; }
    // A list hangs open; a click or Escape is for it.
    bool popupOpen() const { return popupOpen_; }
    void closePopup() { closePopup_ = true; }
    // Asked inside of an open list.
    bool wantsPopupClosed() const { return closePopup_; }

    // Whether words about the widget that stands there, under the mouse, are due: it has rested on it for a moment.
    bool tipDue(const ImVec2& corner);
    // Seconds until such words are to be drawn; infinity where none wait.
    double untilTip() const;
    // Those that are shown; "" for none.
    const std::string& tip() const { return tip_; }
    void setTip(const std::string& text) { tip_ = text; }
    Folds& folds() { return folds_; }

    // The places of the widgets of the last frame, as notePlace() was told; --window --report=json prints them.
    const Places& places() const { return places_; }
    void forgetPlaces() { places_.clear(); }

  private:
    friend void notePlace(const std::string& name);
    friend void notePlace(const std::string& name, const ImVec4& place);
    void setLooks();
    Window& window_;
    ImFont* title_ = nullptr;
    double mouseX_ = 0, mouseY_ = 0;  // as of the last event
    std::array<bool, 5> down_{};      // the buttons of the mouse
    float scale_ = 1;
    double contentScale_ = 0, pixelsPerUnit_ = 0;  // what the looks were made for
    bool popupOpen_ = false, closePopup_ = false;
    double zoom_ = 1, zoomed_ = 0;      // asked for; what the looks were made for
    bool light_ = false, lit_ = false;  // likewise
    bool navigating_ = false;
    int tabAs_ = 0;                   // the key that Tab went down as
    std::string focused_, focusing_;  // of the last frame, and of this one so far
    ImVec2 tipCorner_{};
    bool tipAsked_ = false, tipShown_ = false;
    double tipSince_ = 0;  // seconds of GLFW's clock
    std::string tip_;
    Folds folds_;
    Places places_;
};

// Notes in the Gui's places, under that name, where the last widget stands; or a part of one, in window coordinates.
void notePlace(const std::string& name);
void notePlace(const std::string& name, const ImVec4& place);
// A button whose place is noted under its label.
bool button(const char* label, ImVec2 size = {0, 0});
// Words about the last widget once the mouse has rested on it for half a second, also where it is disabled: left of the panel, or
// under the widget. No button of the mouse is down meanwhile.
void tooltip(const std::string& text);
// The widget that the keys are at is framed from now on, also where the mouse has just moved.
void showFocus();
// A child window that scrolls, and whose widgets the keys reach like those beside it.
void beginReachable(const char* name, const ImVec2& size);
// The words in lines no wider than that, broken at spaces alone: Dear ImGui breaks after a point as well, and so "0.0108" in
// two. U+00A0 keeps words together.
std::string brokenAtSpaces(const std::string& text, float width);
// Words as they are, no wider than the panel.
void wrapped(const std::string& text);
void wrapped(const ImVec4& color, const std::string& text);

}  // namespace mv

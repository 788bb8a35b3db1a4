// A demo in the window: its picture on the left, its panel on the right.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mv/run/command_line.h"
#include "mv/show/session.h"
#include "mv/window/comparison.h"
#include "mv/window/gui.h"
#include "mv/window/handle_rings.h"
#include "mv/window/knob_panel.h"
#include "mv/window/panel_parts.h"
#include "mv/window/screen.h"
#include "mv/window/step_section.h"
#include "mv/window/study_section.h"

namespace mv {

class DemoScreen final : public Screen {
  public:
    // Opens command.demo on the stage and shows the window at its size. With `menu`, there is a way back to one; Escape is it, too, where it comes `fromMenu`.
    // Error: the demo cannot be opened.
    DemoScreen(Window& window, Gui& gui, Stage& stage, const Command& command, bool menu, bool fromMenu);

    void handle(const Event& event) override;
    bool advance(double seconds) override;
    bool moving() const override { return session_.playback().playing() && !study_.measuring(); }
    bool pending() const override { return session_.stale() && pictureWidth() > 0; }
    void draw() override;
    void report(const WindowState& state) override;

  private:
    // The picture takes the framebuffer's left part, of this many pixels; the panel the rest.
    int pictureWidth() const;
    bool overPicture(double x) const;
    // In window coordinates; nothing where there is no divider.
    std::optional<double> dividerX() const;
    bool overDivider(double x) const;
    void moveDivider(double x);
    // The picture that is shown, for its handles.
    FrameInfo shownFrame() const;
    PictureInWindow pictureInWindow() const;
    void onKey(const Event& event);
    bool panelTakes(const Event& event);
    void enterPanel();
    void leavePanel();
    // Notes what settings there are once nothing moves them any more; goes back to those before, or forth again.
    void remember();
    void recall(std::vector<std::vector<KnobSetting>>& from, std::vector<std::vector<KnobSetting>>& to);
    double wantedPanelPixels() const;  // where there is room for a picture beside it
    double panelPixels() const;
    bool overPanelEdge(double x) const;
    void widenPanel(double edge);
    double room(double width, double height, double panel) const;
    void onDrop(const std::string& file);
    void reloadShaders();
    void redraw(bool whole = false);  // with all passes of the picture, or one more
    const Target* shownTarget();      // none: no setting has made a picture yet
    void showPicture();
    void showDividerHandle();
    void showPanel();
    void showPanelContent();
    void showOverlay();
    void showHint();
    void showFile();
    void showSmoothEdges();
    void chooseSamples();
    void save();
    void copyCommand();
    void showFiles();
    std::optional<glm::ivec2> pixelUnderMouse() const;
    std::string commandLine(const std::string& start) const;
    std::string defaultName() const;
    // `plain`: in words about knobs, else as the command line says it.
    std::vector<Message> messages(bool plain = false) const;

    Window& window_;
    Gui& gui_;
    Stage& stage_;
    const DemoInfo& info_;
    Session session_;
    ReportForm report_;
    double density_;              // asked for
    std::optional<int> samples_;  // asked for by the command line or the switch
    bool choosesSamples_;         // with the first picture
    std::string whySamples_;      // what was chosen, and by which time of a frame
    std::string program_;         // how it was started
    bool menu_, fromMenu_;
    KnobPanel knobs_;
    Comparison comparison_;
    StudySection study_;
    StepSection steps_;
    HandleInput handles_;
    std::string handled_;  // what the hand is on

    bool panelShown_ = true, hint_ = false;
    double panelWidth_ = 0;    // asked for, in pixels at ordinary density; 0: as it opens
    double openedPixels_ = 0;  // the picture's width, as the window opened
    bool draggingPanel_ = false;
    int panelComes_ = 0;  // frames until the keys that have gone to the panel are seen there
    std::vector<std::vector<KnobSetting>> past_, future_;  // settings, to go back and forth
    std::vector<KnobSetting> present_;
    bool draggingDivider_ = false;
    double untilReload_ = 0;  // seconds

    std::vector<std::string> shaderErrors_;
    std::string dropError_;  // why the file that was dropped last is not taken
    std::array<char, 256> fileName_{};
    std::string saved_;  // what became of the last saving, and of the last copying
    bool saveFailed_ = false;
};

}  // namespace mv

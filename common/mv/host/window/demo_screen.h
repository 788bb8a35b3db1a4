// A demo in the window: its picture on the left, its panel on the right.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mv/host/window/comparison.h"
#include "mv/host/window/gui.h"
#include "mv/host/window/hand.h"
#include "mv/host/window/knob_panel.h"
#include "mv/host/window/panel_parts.h"
#include "mv/host/window/playback.h"
#include "mv/host/window/screen.h"
#include "mv/host/window/study_section.h"
#include "mv/run/command_line.h"
#include "mv/run/report.h"
#include "mv/run/stage.h"

namespace mv {

class DemoScreen final : public Screen {
  public:
    // Opens command.demo on the stage and shows the window at its size. With `menu`, there is a way back to one.
    // Error: the demo cannot be opened.
    DemoScreen(Window& window, Gui& gui, Stage& stage, const Command& command, bool menu);

    void handle(const Event& event) override;
    bool advance(double seconds) override;
    bool moving() const override { return playback_.playing() && !study_.measuring(); }
    bool pending() const override { return stale_ && pictureWidth() > 0; }
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
    Frame shownFrame() const;
    PictureInWindow pictureInWindow() const;
    void onKey(const Event& event);
    bool binds(Key key) const;
    void reloadShaders();
    void redraw();
    void drawDemo();
    const Target* shownTarget();  // none: no setting has made a picture yet
    void showPicture();
    void showDividerHandle();
    void showPanel();
    void showPanelContent();
    void showOverlay();
    void showFile();
    void save();
    void copyCommand();
    std::string commandLine() const;
    FrameTimes timesForReport(bool closing);
    std::string defaultName() const;
    std::vector<Message> messages() const;

    Window& window_;
    Gui& gui_;
    Stage& stage_;
    const DemoInfo& info_;
    ReportForm report_;
    std::string program_;  // how it was started
    bool menu_;
    Places places_;
    KnobPanel knobs_;
    Comparison comparison_;
    StudySection study_;
    Playback playback_;
    Hand hand_;
    mutable FrameNotes unread_;  // of frames that are not drawn

    bool panelShown_ = true;
    bool dragging_ = false, draggingDivider_ = false;
    double dragX_ = 0, dragY_ = 0;

    bool stale_ = true;        // the picture is not that of the present settings
    bool hasPicture_ = false;  // the stage has one of its present size
    int triedWidth_ = 0, triedHeight_ = 0;
    int drawnFrame_;
    long demoFrames_ = 0;
    double firstMs_ = 0, lastMs_ = 0;
    double untilReload_ = 0;  // seconds

    std::string error_;  // why the present settings make no picture
    std::vector<std::string> shaderErrors_;
    std::array<char, 256> fileName_{};
    std::string saved_;  // what became of the last saving, and of the last copying
    bool saveFailed_ = false;
};

}  // namespace mv

// A demo as a host shows it, whatever the host is: the window is one, a page in a browser another. The host brings a stage
// on its context, a size, the time that has passed and what the user does, and shows the picture that comes of them.
//
// As data mv/paper/report.h has its knobs and, after a picture, its report.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mv/show/frame_times.h"
#include "mv/show/playback.h"
#include "mv/show/stage.h"

namespace mv {

// The beginning of a session, besides the demo.
struct SessionStart {
    int width = 0, height = 0;  // of the picture, in pixels
    std::vector<KnobSetting> knobs = {};
    std::vector<TimedChange> changes = {};
    int frame = 1;
    bool paused = false;            // an animated demo stands still at that frame
    std::optional<int> until = {};  // as Session::stopAfter()
};

// A drawing in place of one picture of the demo: two of its settings, say.
class OtherPicture {
  public:
    struct Cost {
        int pictures = 1;         // of the demo
        double milliseconds = 0;  // of one, until the driver was done with it
    };
    virtual ~OtherPicture() = default;
    // Error: as Demo::check.
    virtual void check(const Demo& demo) = 0;
    // Error: as Stage::draw.
    virtual Cost draw(Stage& stage, int index, bool readouts) = 0;

  protected:
    OtherPicture() = default;
    OtherPicture(const OtherPicture&) = default;
    OtherPicture& operator=(const OtherPicture&) = default;
};

class Session {
  public:
    // Opens the demo on the stage, which stays the caller's and outlives it. Error: as Stage::open; a knob that there is
    // not, or a value that it refuses.
    Session(Stage& stage, const DemoInfo& info, const SessionStart& start);
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    const DemoInfo& info() const { return info_; }
    Demo& demo() { return stage_.demo(); }
    const Demo& demo() const { return stage_.demo(); }
    Playback& playback() { return playback_; }
    const Playback& playback() const { return playback_; }

    // Sets a knob. Why not, where there is no such knob or it refuses the value, which then stays as it was; else "".
    std::string set(const std::string& name, const std::string& text);
    // The picture is to be drawn anew for something that the session does not see: a knob that a widget moved, a shader.
    void touch() { stale_ = true; }

    // The user's actions. A key of the demo's own; false: the host may take it for itself.
    bool press(Key key);
    // A drag that began over the picture; positions in pixels at ordinary density, y downwards.
    void pointerDown(double x, double y);
    void pointerMove(double x, double y);
    void pointerUp() { dragging_ = false; }
    // Over the picture; notches away from the user.
    void wheel(double notches);

    // From now on the picture is stopped after so many of its draws, see Stage::stopAfter(); nothing: it is whole.
    void stopAfter(std::optional<int> draws) {
        stale_ |= draws != until_;
        until_ = draws;
    }
    const std::optional<int>& until() const { return until_; }
    // The draws of the last picture, where it was stopped.
    const std::optional<FrameSteps>& steps() const { return stage_.steps(); }

    // Back to frame 1, with the settings as they are now and nothing changed since.
    void restart();
    // Lets so many seconds pass, as the playback has it.
    void advance(double seconds) { stale_ |= playback_.advance(seconds); }

    // See Stage::setSamples().
    void setSamples(int samples) {
        stale_ |= samples != stage_.samples();
        stage_.setSamples(samples);
    }
    // Of the screen that the picture is shown on, see Stage::setDensity().
    void setDensity(double density) {
        stale_ |= density != stage_.density();
        stage_.setDensity(density);
    }
    // Whether the picture is not that of the present settings and frame; and whether draw() would draw.
    bool stale() const { return stale_; }
    bool due(int width, int height) const { return stale_ || width != triedWidth_ || height != triedHeight_; }
    // Draws the present settings in that size, or `instead` of them, where due; with `readouts` measures what the demo reads
    // out. Settings that make no picture leave the last one and an error().
    void draw(int width, int height, bool readouts, OtherPicture* instead = nullptr);

    // A picture made in passes gets one more with each draw(), and is stale until the last. How far it is: passesDone() of passes(),
    // both 0 where it has none. finish() makes those that are left, for who wants the very picture.
    int passes() const { return stage_.passes(); }
    int passesDone() const { return stage_.passesDone(); }
    void finish(int width, int height, bool readouts, OtherPicture* instead = nullptr);

    // Why the present settings make no picture, in a sentence; "" where they do.
    const std::string& error() const { return error_; }
    // Whether the stage's front() has a picture of its present size, and which frame that is.
    bool hasPicture() const { return hasPicture_; }
    int drawnFrame() const { return drawnFrame_; }
    // The notes of the last picture: matrices, messages, counts.
    const FrameNotes& notes() const { return stage_.notes(); }
    // The first and the last picture's time; with `runs`, that of so many more, which it draws.
    FrameTimes times(int runs = 0);
    long picturesDrawn() const { return pictures_; }
    double lastMilliseconds() const { return lastMs_; }

  private:
    OtherPicture::Cost drawDemo(bool readouts);

    Stage& stage_;
    const DemoInfo& info_;
    Playback playback_;
    bool dragging_ = false;
    double dragX_ = 0, dragY_ = 0;

    std::optional<int> until_;

    bool stale_ = true;        // the picture is not that of the present settings
    bool hasPicture_ = false;  // the stage has one of its present size
    int triedWidth_ = 0, triedHeight_ = 0;
    int drawnFrame_;
    long pictures_ = 0;
    double firstMs_ = 0, lastMs_ = 0;
    std::string error_;
};

}  // namespace mv

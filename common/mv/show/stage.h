// The stage of a demo: a context, a target with just the buffers it needs, and the demo itself.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/gl/functions.h"
#include "mv/gl/steps.h"
#include "mv/gl/target.h"
#include "mv/host/context.h"
#include "mv/show/timeline.h"

namespace mv {

// Who draws, in the driver's own words.
struct DriverInfo {
    std::string host, vendor, renderer, version;
    int glVersion = 0;  // 10 * major + minor
};

// A frame, stopped after one of its draws.
struct FrameSteps {
    std::vector<DrawStep> draws;  // of the whole frame
    int until = 0;                // the picture is that after so many of them
    TargetPictures shown;
};

class Stage {
  public:
    // Takes over the current context. With `keepLast`, a frame that fails leaves the last picture as it was (a window
    // shows it on); without, no second target is made.
    explicit Stage(const Context& context, bool keepLast = false);
    ~Stage();
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    // Makes the demo and its target. Error: the driver lacks what the demo needs, or a shader fails.
    void open(const DemoInfo& info, int width, int height);
    // Says how the demo begins, and what is changed when. Error: no such knob, or a value that it refuses.
    void begin(const std::vector<KnobSetting>& knobs, const std::vector<TimedChange>& changes = {});
    // Deletes both. Error: the demo leaves GL objects behind.
    void close();
    bool isOpen() const { return demo_ != nullptr; }
    void resize(int width, int height);
    // So many samples a pixel in the picture, for smooth edges, where the demo asks for none; 0 at first. What is measured or
    // stopped after a draw has none. Error, from the next resize() or open(): the driver has another number.
    void setSamples(int samples);
    int samples() const { return info_ && info_->needs.samples > 0 ? info_->needs.samples : samples_; }
    // Pixels of the picture for each of an ordinary screen's: a page's devicePixelRatio. Words and lines of figures are no
    // smaller than can be read there. 1 until it is said.
    void setDensity(double density) { density_ = density; }
    double density() const { return density_; }
    // Frame `index` of a picture of that size, as the open demo is told of it.
    FrameInfo frame(int index, int width, int height) const {
        return {index, width, height, figureUnit(width, height, info_->width, info_->height, density_)};
    }
    FrameInfo frame(int index) const { return frame(index, front().width(), front().height()); }

    // Draws frame `index`; with `readouts`, also measures what the demo reads out. Error: the settings make no picture
    // (check()), or GL reports an error.
    void draw(int index, bool readouts = false);
    // For a picture made in passes: the same after one pass more than the last drawNext() of these settings, this frame and
    // this size, and after the first where there was none. Whether it was the last, so that the picture is that of draw();
    // one without passes has it in one. Error: as draw().
    bool drawNext(int index, bool readouts = false);
    // The passes of the last picture: how many it has, and how many of them were made; 0 where it has none.
    int passes() const { return refined_.passes; }
    int passesDone() const { return refined_.done; }
    // Called every two seconds while one draw() makes passes, with the number that are done and that there are.
    std::function<void(int done, int passes)> passesProgress = {};
    // Draws frame `index` once more into the same picture, stopped after so many of its draws (see mv/gl/steps.h), by a demo of
    // its own with the settings and the memory that this one has for frame `index`: the frame is one that has nothing kept
    // from frames before, so a shadow map that is made once is among its draws, and what a stopped frame leaves half made is
    // kept by nobody. The picture is cleared before it also where the demo declares no background: to transparent black.
    // Counters, notes and readouts stay those of the last draw(). Error: more draws than it has, or fewer than 0, with how
    // many it has, and the whole frame is then shown, by steps(), too; else as draw(), but for what OpenGL reports, which a
    // frame that lacks some of its draws may be to blame for.
    void stopAfter(int index, int draws);
    // The draws that stopAfter() found, and none after another draw().
    const std::optional<FrameSteps>& steps() const { return steps_; }
    // Draws frame `index` with frame.measuring() into a target of its own and returns the quantity, one float a pixel,
    // the upper row first; -1 where the demo has none. The picture is not touched. Error: as draw().
    std::vector<float> measure(int index);
    // The notes of the last good draw, or measure.
    const FrameNotes& notes() const { return notes_; }
    const Counters& frameCounters() const { return counters_; }
    // The part of OpenGL's state that the last audited draw left changed, and the stage put back, as changedState()
    // names it.
    const std::vector<std::string>& undone() const { return undone_; }
    Picture picture() const { return front().read(); }
    const Target& front() const { return targets_[shown_]; }

    // The demo's history until the frame that is drawn.
    Timeline& timeline() { return *timeline_; }
    const Timeline& timeline() const { return *timeline_; }
    Demo& demo() { return *demo_; }
    const Demo& demo() const { return *demo_; }
    const DemoInfo& info() const { return *info_; }
    const DriverInfo& driver() const { return driver_; }

  private:
    friend class StageProbing;
    // The results of a draw beside its picture.
    struct Drawn {
        FrameNotes notes;
        Counters counters;
        std::vector<std::string> undone;
    };
    // Which picture the demo has refined, and how far.
    struct Refined {
        std::vector<std::string> knobs;
        int index = 0, width = 0, height = 0;
        int passes = 0, done = 0;
    };
    void makeTargets(int width, int height);
    void refine(const FrameInfo& frame, bool onlyNext);
    bool drawFront(int index, bool readouts, bool onlyNextPass);
    Drawn drawInto(const Target& target, int index, FrameMode mode, bool onlyNextPass = false);
    // With `beginsSteps`, which is called before the demo's first call, the frame may be stopped, and errors of OpenGL's are passed over.
    Drawn paint(Demo& demo, const Target& target, int index, FrameMode mode,
                const std::function<void()>& beginsSteps) const;
    FrameSteps stepsOf(const Target& target, int index, int stopAfter);
    void keep(Drawn drawn);
    void fitForMeasuring(Target& target, int width, int height) const;
    void askProbes(const Target& drawn, int index);
    bool keepLast_;
    double density_ = 1;
    int samples_ = 0;
    DriverInfo driver_;
    const DemoInfo* info_ = nullptr;
    std::unique_ptr<Demo> demo_;
    std::unique_ptr<Timeline> timeline_;
    Target targets_[2];         // the second is made when the first has a picture that is to be kept
    Target measured_, probed_;  // made when something is measured, or probed
    int shown_ = 0;
    bool isDrawn_ = false;  // that one
    FrameNotes notes_;
    Counters counters_;
    std::vector<std::string> undone_;
    std::optional<FrameSteps> steps_;
    Refined refined_;
};

}  // namespace mv

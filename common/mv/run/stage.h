// Where a demo is drawn: a context, a target with just the buffers it needs, and the demo itself.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/gl/functions.h"
#include "mv/gl/target.h"
#include "mv/host/context.h"
#include "mv/run/timeline.h"

namespace mv {

// Who draws, in the driver's own words.
struct DriverInfo {
    std::string host, vendor, renderer, version;
    int glVersion = 0;  // 10 * major + minor
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

    // Draws frame `index`; with `readouts`, also measures what the demo reads out. Error: the settings make no picture
    // (check()), or GL reports an error.
    void draw(int index, bool readouts = false);
    // Draws frame `index` with frame.measuring() into a target of its own and returns the quantity, one float a pixel,
    // the upper row first; -1 where the demo has none. The picture is not touched. Error: as draw().
    std::vector<float> measure(int index);
    // What the last good draw, or measure, left.
    const FrameNotes& notes() const { return notes_; }
    const Counters& frameCounters() const { return counters_; }
    // What of OpenGL's state the last audited draw left changed, and the stage put back, as changedState() names it.
    const std::vector<std::string>& undone() const { return undone_; }
    Picture picture() const { return front().read(); }
    const Target& front() const { return targets_[shown_]; }

    // What the demo has been through until the frame that is drawn.
    Timeline& timeline() { return *timeline_; }
    const Timeline& timeline() const { return *timeline_; }
    Demo& demo() { return *demo_; }
    const Demo& demo() const { return *demo_; }
    const DemoInfo& info() const { return *info_; }
    const DriverInfo& driver() const { return driver_; }

  private:
    friend class StageProbing;
    // What a draw leaves beside its picture.
    struct Drawn {
        FrameNotes notes;
        Counters counters;
        std::vector<std::string> undone;
    };
    void makeTargets(int width, int height);
    Drawn drawInto(const Target& target, int index, FrameMode mode);
    void keep(Drawn drawn);
    void fitForMeasuring(Target& target, int width, int height) const;
    void askProbes(const Target& drawn, int index);
    bool keepLast_;
    DriverInfo driver_;
    const DemoInfo* info_ = nullptr;
    std::unique_ptr<Demo> demo_;
    std::unique_ptr<Timeline> timeline_;
    Target targets_[2];
    Target measured_, probed_;  // made when something is measured, or probed
    int shown_ = 0;
    FrameNotes notes_;
    Counters counters_;
    std::vector<std::string> undone_;
};

}  // namespace mv

// A demo's memory at any frame: from the knobs it begins with, the changes made since, and the steps between.
//
// A frame is a function of these three, so a copied command line, a series of frames, a test and a frame that somebody goes
// back to show the same bytes. Going back starts at the nearest frame that was kept. A demo without a Memory and without timed
// changes has nothing to be brought anywhere, and costs nothing.
#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mv/demo/demo.h"

namespace mv {

// Whether the number of a frame says anything: the demo moves, or something is changed at some frame. Who shows frames plays them
// then, and who names a picture names its frame.
inline bool framesDiffer(const DemoInfo& info, const std::vector<TimedChange>& changes) {
    return info.animated || !changes.empty();
}

class Timeline {
  public:
    // The demo outlives it. Its settings when it is first brought to a frame are those it begins with.
    explicit Timeline(Demo& demo) : demo_(demo) {}
    Timeline(const Timeline&) = delete;
    Timeline& operator=(const Timeline&) = delete;

    // Changes that come (--at); of one frame in this order.
    void setChanges(std::vector<TimedChange> changes);
    // From now on a knob that was moved since the last bring() is a change at that frame, and drops what came later: somebody
    // plays. Before that, a knob that was moved is another beginning.
    void record() { recording_ = true; }
    // Begins anew with the demo's present settings, and without changes.
    void beginAnew();
    // Until it is called with none: frames are as if this knob had had that value all the time (one of two that are compared).
    void vary(std::optional<KnobSetting> other);

    // Brings memory and knobs to the frame. Error: as Demo::step, or a change that its knob refuses.
    void bring(int index);

    // Whether the demo remembers, or is changed at some frame: then the knobs it begins with are not those it has.
    bool matters() const { return demo_.memory() || !told_.changes.empty(); }
    // The settings at the beginning, knobs at their initial values left out, and the changes until that frame.
    std::vector<KnobSetting> beginning() const;
    std::vector<TimedChange> changesUntil(int index) const;

    // Called every two seconds while one bring() lasts, with the frame that is reached and the one that is wanted.
    std::function<void(int reached, int wanted)> progress = {};

  private:
    using Texts = std::vector<std::string>;  // of all knobs, in the demo's order
    struct Told {
        Texts beginning;
        std::vector<TimedChange> changes;  // by frame
    };
    // One way through time, so far.
    struct Run {
        Told told;                                        // that it followed, until `now`
        int now = -1;                                     // -1: not begun
        std::shared_ptr<const void> entered, left;        // memory as of `now`, before and after its changes
        std::map<int, std::shared_ptr<const void>> kept;  // of frames, before their changes
        int keptEach = 60;
    };

    Texts texts() const;
    void setKnobs(const Texts& beginning, const std::vector<TimedChange>& changes, int before);
    void takeWhatWasMoved();
    void keep(Run& run) const;
    Run& runOf(const Told& told);
    void jump(Run& run, const Told& told, int to);
    void change(const Told& told, int frame);
    void follow(Run& run, const Told& told, int index);

    Demo& demo_;
    Told told_;
    bool recording_ = false;
    std::optional<KnobSetting> varied_;
    Texts known_;                             // the knobs as the last bring() left them
    int at_ = -1;                             // where that was
    std::vector<std::unique_ptr<Run>> runs_;  // the one that was followed last in front
};

}  // namespace mv

// The panel's part about error and time: the demo's study, committed of one or more machines, or measured on this one.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/image/file.h"
#include "mv/study/choice.h"
#include "mv/window/child.h"
#include "mv/window/gui.h"

namespace mv {

class StudySection {
  public:
    // `renderer` draws the window: of the committed runs, that of its kind is shown first.
    StudySection(const DemoInfo& info, Gui& gui, const std::string& renderer);

    // Whether the demo has a study at all.
    bool any() const { return info_.study.has_value() || !runs_.empty(); }
    // Listens to a measurement that runs; true when there is something new to show.
    bool advance();
    // Shows the plot and the buttons; true when the settings of a point were taken.
    bool show(Demo& demo);

    bool measuring() const { return measurement_.has_value(); }
    // The machine of the run that is shown, in a sentence; "" where none is.
    std::string origin() const;
    // The row of the present settings: its name, "" for none.
    std::string here(const Demo& demo) const;
    // The demand of a click on an axis, and the row that was chosen: "error 0.02: simpson 16"; "" for nothing.
    std::string asked(const Demo& demo) const;

  private:
    struct Measurement {
        ScratchFolder folder{"study"};
        Child child;
        double done = 0;  // 0..1
        std::string steps, doing, problem;
        explicit Measurement(const std::string& demo)
            : child({demo, "--study", folder.path().string(), "--headless"}) {}
    };
    const StudyRun& shown() const { return runs_[run_]; }
    bool isMeasuredHere(std::size_t run) const { return measured_ && run + 1 == runs_.size(); }
    void show(std::size_t run);
    void start();
    void finish(int status);
    std::optional<std::size_t> rowHere(const Demo& demo) const;
    void findScene(const Demo& demo);
    std::vector<std::size_t> choosable(const Demo& demo) const;
    bool choose(Demo& demo, const StudyBound& bound, const std::vector<std::size_t>& rows);
    bool take(Demo& demo, std::size_t row);
    void showWords(const Demo& demo, std::optional<std::size_t> here) const;
    void showMeasurement();
    void chooseMachine();
    void chooseScene();

    const DemoInfo& info_;
    Gui& gui_;
    std::vector<StudyRun> runs_;  // a machine each; the last is what was measured here, where something was
    bool measured_ = false;
    std::size_t run_ = 0;  // that is shown
    std::vector<std::string> scenes_;
    std::size_t scene_ = 0;
    bool sceneFound_ = false;
    std::optional<StudyBound> bound_;  // that was asked for last
    // The knobs' words after a row was set; nothing where they refuse it.
    std::vector<std::optional<std::vector<KnobSetting>>> settings_;
    std::optional<Measurement> measurement_;
    std::string problem_;
};

}  // namespace mv

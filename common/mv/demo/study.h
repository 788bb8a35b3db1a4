// The measurements of a demo, beside it in its study.cpp: its study, error against run time, and its probes.
//
// A demo that shows an approximation has a study: the settings to try, the quantity that is compared, and a reference made
// by a different and far more exact method. mv/study/study.h runs it. A study file asks the demo for its settings
// (settingsOf, in mv/demo/lesson.h), or for one by the name of its knob (Demo::number, Demo::word), for its scene (Demo::scene) and its
// values (Demo::values).
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mv/demo/claim.h"
#include "mv/demo/frame.h"
#include "mv/demo/knob.h"
#include "mv/image/picture.h"
#include "mv/math/types.h"

namespace mv {

class Demo;

// Some settings that belong together: one line of the plot.
struct StudyLine {
    std::string method;                 // its name in table and plot: "map, 1 tap"
    std::vector<KnobSetting> settings;  // of all points of the line
    std::string knob = {};              // the knob that moves along the line; "" for a single point
    std::vector<std::string> values = {};
    std::vector<std::string> scenes = {};  // that it is measured in, by name; empty: all
};

// A scene in which every line is measured.
struct StudyScene {
    std::string name;
    std::vector<KnobSetting> settings = {};
};

// The picture that a reference is made for, and what else is asked of it.
struct ReferenceFrame : FrameInfo {
    ReferenceFrame(const FrameInfo& info, bool withOwnError = false) : FrameInfo(info), ownError(withOwnError) {}
    bool ownError;  // Reference::ownError is asked for, too, which costs more than the reference itself
};

// The right answer, by the demo's other method. Other values of the settings that it reads (Study::reads: the number of
// lights, say) get a reference of their own; the knobs that it does not read are what is under study.
struct Reference {
    // One for each number compared: for a picture one a pixel, the upper row first.
    std::vector<double> values;
    // The values against which the root mean square and the maximum are measured, where that is not `values` (a pixel's
    // average instead of its centre, say); empty: `values`.
    std::vector<double> averages = {};
    // For a picture, what is seen in each pixel: -1 where nothing counts. A pixel one of whose eight neighbours has
    // another region, or a value that differs by more than Study::wrongBeyond, is in the edge band, where rounding
    // decides. Empty: all values count, and none is at an edge.
    std::vector<int> regions = {};
    // How many of them make a row; 0: as many as the picture has columns.
    int across = 0;
    // The root mean square by which the reference changes when its own sampling is doubled in each direction; negative
    // where it has none to double.
    double ownError = -1;
    // Rays cast, steps taken.
    double work = 0;
};

// Which number of the error is drawn: the root mean square, the part of the values that is wrong, or the largest.
enum class ErrorAxis { rms, fraction, max };

struct Study {
    std::string quantity;   // what is compared: "lit fraction of the floor's pixels"
    std::string reference;  // how the reference is made: "one ray a pixel, in double precision"
    std::vector<StudyScene> scenes;
    std::vector<StudyLine> lines;
    ErrorAxis axis = ErrorAxis::rms;
    // The knob that makes the problem itself harder ("far"), if one does: only rows of the same value compete for best.
    std::string problem = {};
    // A value that is farther than this from the reference is wrong.
    double wrongBeyond = 0.5;
    int width = 640, height = 480;  // of the picture measured
    int frame = 1;
    // The study's statements, for its page: a test evaluates its claims on the committed rows.
    std::vector<Saying> says = {};
    // True: the demo's values() are compared and timed, without GL. False: pictures, drawn with frame.measuring().
    bool ofValues = false;
    // The knobs that the reference depends on: it is kept while these are as they were, and a test holds it to them. Empty: it is made
    // anew for each row.
    std::vector<std::string> reads = {};
    // The right answer for the demo's present settings, in the picture that `frame` describes (its size and index; not
    // drawn into); made by a method that shares nothing with the one under study. Slow ones report the part that is
    // done.
    std::function<Reference(const Demo& demo, const ReferenceFrame& frame,
                            const std::function<void(double part)>& progress)>
        makeReference = {};
};

// The questions that a probe may ask.
class Probing {
  public:
    Probing(const Demo& demo, const FrameInfo& frame) : demo_(demo), frame_(frame) {}
    virtual ~Probing() = default;
    Probing(const Probing&) = delete;
    Probing& operator=(const Probing&) = delete;

    const Demo& demo() const { return demo_; }
    // The picture that is probed: its size and index.
    const FrameInfo& frame() const { return frame_; }
    // The demo's quantity as a study measures it, in width x height pixels, the upper row first; -1 where there is none.
    // With a camera, through that instead of the demo's own, as seen() heeds it (mv/demo/seen.h). Empty where the context has no
    // targets of floats (ES 3.0 without EXT_color_buffer_float).
    virtual std::vector<float> measured(int width, int height, const std::optional<Camera>& camera = {}) = 0;
    // The picture that was just drawn.
    virtual Picture picture() = 0;
    // Its stencil buffer and its depths 0..1, the lower row first; empty in ES, which reads neither back.
    virtual std::vector<unsigned char> stencil() = 0;
    virtual std::vector<float> depths() = 0;

  private:
    const Demo& demo_;
    FrameInfo frame_;
};

// A number about the picture that costs draws or rays of its own: a readout that the demo itself knows nothing of.
struct Probe {
    struct Number {
        Literal name, help, unit = {};
    };
    std::vector<Number> numbers;
    // One value for each number, or none where these settings do not measure them. Asked after the picture is drawn, and
    // only where somebody reads the readouts.
    std::function<std::vector<double>(Probing&)> measure;
};

// Measures the demo of that name; at file scope in its study.cpp, each once for a demo, or Error.
bool addStudy(const std::string& name, Study study);
bool addProbes(const std::string& name, std::vector<Probe> probes);

}  // namespace mv

// A study: what a demo wants to have measured, error against run time. The declaration only; mv/run/study.h runs it.
//
// A demo that shows an approximation declares the settings to try, the quantity that is compared, and a reference made
// by a different and far more exact method.
#pragma once
#include <string>
#include <vector>

#include "mv/demo/frame.h"
#include "mv/demo/knob.h"

namespace mv {

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

// Which number of the error is drawn: the root mean square, or the part of the values that is wrong.
enum class ErrorAxis { rms, fraction };

struct Study {
    std::string quantity;   // what is compared: "lit fraction of the floor's pixels"
    std::string reference;  // how the reference is made: "one ray a pixel, in double precision"
    std::vector<StudyScene> scenes;
    std::vector<StudyLine> lines;
    ErrorAxis axis = ErrorAxis::rms;
    // A value that is farther than this from the reference is wrong.
    double wrongBeyond = 0.5;
    int width = 640, height = 480;  // of the picture measured
    int frame = 1;
    // What the study says, in two sentences, for its page.
    std::string says = {};
    // True: the demo's values() are compared and timed, without GL. False: pictures, drawn with frame.measuring().
    bool ofValues = false;
};

// The picture that a reference is made for, and what else is asked of it.
struct ReferenceFrame : FrameInfo {
    ReferenceFrame(const FrameInfo& info, bool withOwnError = false) : FrameInfo(info), ownError(withOwnError) {}
    bool ownError;  // Reference::ownError is asked for, too, which costs more than the reference itself
};

// What is right, by the demo's other method. Settings that it reads otherwise (the number of lights, say) get a reference
// of their own; the knobs that it does not read are what is under study.
struct Reference {
    // One for each number compared: for a picture one a pixel, the upper row first.
    std::vector<double> values;
    // What the root mean square and the maximum are measured against, where that is not `values` (a pixel's average
    // instead of its centre, say); empty: `values`.
    std::vector<double> averages = {};
    // For a picture, what is seen in each pixel: -1 where nothing counts. A pixel one of whose eight neighbours has
    // another region, or a value that differs by more than Study::wrongBeyond, is in the edge band, where rounding
    // decides. Empty: all values count, and none is at an edge.
    std::vector<int> regions = {};
    // The root mean square by which the reference changes when its own sampling is doubled in each direction; negative
    // where it has none to double.
    double ownError = -1;
    // Rays cast, steps taken.
    double work = 0;
};

}  // namespace mv

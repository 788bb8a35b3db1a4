// What measures clipping: how often each method decides wrongly about a segment aimed at a corner of the window.
#include <string>
#include <vector>

#include "mv/demo/demo.h"
#include "shared/clip_methods.h"

using namespace mv;
using namespace mv::claims;

namespace {

constexpr int segmentsTried = 20000;

// Decided in fractions of whole numbers.
Reference exactly(const Demo& demo) {
    const double offset = demo.number("offset");
    const Box window = exactWindow({vec2(-1.6, -1) + offset, vec2(1.5, 1.2) + offset});
    Reference reference;
    const int bits = exactBits(window);
    for (const Segment& segment : aimedAtCorners(window, segmentsTried))
        reference.values.push_back(clipExactly(segment, window, bits).meets ? 1 : 0);
    return reference;
}

Study study() {
    Study study;
    study.quantity =
        "1 for a segment that is kept, 0 for one that is rejected; 20000 of them, aimed at a corner of the window";
    study.reference = "Liang and Barsky's method in fractions of whole numbers: exact";
    study.makeReference = [](const Demo& demo, const ReferenceFrame&, const auto&) { return exactly(demo); };
    study.axis = ErrorAxis::fraction;
    study.ofValues = true;
    study.problem = "offset";
    study.scenes = {{"window of 3.1 x 2.2"}};
    for (const std::string method : {"cohen-sutherland", "liang-barsky", "cyrus-beck", "exact"}) {
        study.lines.push_back(
            {.method = method, .settings = {{"method", method}}, .knob = "offset", .values = {"0", "1e3", "1e6"}});
    }
    study.says = {
        claim("exact-is-exact",
              "The exact method decides every one of them as the fractions do, however far away the window is.",
              {zero(of::wrong, rows("exact"))}),
        claim("others-by-luck", "Beside the origin each of the others decides more than 1 % of them wrongly.",
              {atLeast(of::wrong, rows("cohen-sutherland", "liang-barsky", "cyrus-beck").at(0), 1)}),
        claim("cutting-again",
              "Cohen and Sutherland's, which cuts what it has cut, errs more the farther away it is: at 1000 and "
              "beyond more than 10 %.",
              {atLeast(of::wrong, rows("cohen-sutherland").from(1000), 10)}),
        claim("four-ulp", "Its ends are off by 4 ulp at most; Cohen and Sutherland's by more than 10.",
              {atMost(of::count("end error, ulp"), rows("exact"), 4),
               atLeast(of::count("end error, ulp"), rows("cohen-sutherland"), 10)}),
        claim("what-it-costs",
              "On such segments, whose signs are all in doubt, the exact method takes one to six times the time of "
              "Liang and "
              "Barsky's.",
              {ratio(of::time, rows("exact"), rows("liang-barsky"), 1, 6)}),
        note("An ulp is a unit in the last place of the largest coordinate of segment and window. Far from the origin "
             "the coordinates "
             "are so coarse that the differences from the window's sides are exact, and the parameters nearly so."),
    };
    return study;
}

[[maybe_unused]] const bool added = addStudy("clipping", study());

}  // namespace

// The readouts of clipping, and its study: how often each method decides wrongly about a segment aimed at a corner
// of the window.
#include <string>
#include <vector>

#include "clipping.h"
#include "mv/demo/lesson.h"
#include "mv/demo/made_for.h"

namespace mv::clipping {

static constexpr int segmentsTried = 20000;

// Kept, so that the time of clipping is not that of aiming.
static const std::vector<Segment>& aimedSegments(const InPlane& s) {
    static MadeFor<int, std::array<vec2, 2>> keptFor;
    static std::vector<Segment> kept;
    if (keptFor.changed(s.offset, s.corners)) kept = aimedAtCorners(exactWindow(farWindowOf(s)), segmentsTried);
    return kept;
}

static Trial trialOf(const InPlane& s) {
    const auto method = [&s](const Segment& one, const Box& window) { return clipped(s.method, one, window); };
    return tryMethod(method, aimedSegments(s), exactWindow(farWindowOf(s)));
}

// 1 for each that the method keeps, 0 for each that it rejects.
std::vector<double> values(const Settings& s) {
    std::vector<double> kept;
    kept.reserve(segmentsTried);
    const Box window = exactWindow(farWindowOf(s.plane));
    for (const Segment& one : aimedSegments(s.plane)) kept.push_back(clipped(s.plane.method, one, window) ? 1 : 0);
    return kept;
}
std::vector<std::pair<std::string, double>> valueCounts(const Settings& s) {
    return {{"end error, ulp", trialOf(s.plane).ulps}};
}

void readOut(Gpu&, const Settings& s, const Frame&, Numbers& numbers) {
    if (s.subject == Subject::segment) {
        const Trial trial = trialOf(s.plane);
        numbers.set("wrong", trial.wrongPercent);
        numbers.set("end-error", trial.ulps);
    }
    if (s.subject == Subject::polygon) numbers.set("area", areaOf(piecesOf(s)));
    if (s.subject == Subject::space) numbers.set("off", missInSpace(s.space));
}

namespace {

using namespace mv::claims;

// Decided in fractions of whole numbers.
Reference exactly(const InPlane& s) {
    const Box window = exactWindow(farWindowOf(s));
    Reference reference;
    const int bits = exactBits(window);
    for (const Segment& segment : aimedSegments(s))
        reference.values.push_back(clipExactly(segment, window, bits).meets ? 1 : 0);
    return reference;
}

Study study() {
    Study study;
    study.quantity =
        "1 for a segment that is kept, 0 for one that is rejected; 20000 of them, aimed at a corner of the window";
    study.reference = "Liang and Barsky's method in fractions of whole numbers: exact";
    study.makeReference = [](const Demo& demo, const ReferenceFrame&, const auto&) {
        return exactly(settingsOf<Settings>(demo).plane);
    };
    study.reads = {"offset", "corners"};
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

[[maybe_unused]] const bool studied = addStudy("clipping", study());

}  // namespace
}  // namespace mv::clipping

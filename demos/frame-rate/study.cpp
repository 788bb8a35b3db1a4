// The readouts of frame-rate, and its study: the time that is told after hours of pictures, by the way it is
// added up.
#include <cmath>
#include <string>
#include <vector>

#include "frame-rate.h"
#include "mv/demo/lesson.h"

namespace mv::frame_rate {

void readOut(Gpu&, const Settings& s, const Running& now, const Frame&, Numbers& numbers) {
    const auto [perPicture, perSecond, right, inSteps] = times(s, now);
    numbers.set("per-picture-off", perPicture - right);
    numbers.set("per-second-off", perSecond - right);
    numbers.set("steps-off", inSteps - right);
    numbers.set("lost", now.moved.lost);
    numbers.set("picture-lasts", now.last.empty() ? 0 : 1000 * now.last.back().lasted);
    numbers.set("turn-per-second", turnOf(s, perSecond));
    numbers.set("turn-of-time", turnOf(s, right));
}

// The time that is told after these hours of pictures, each a refresh long.
std::vector<double> values(const Settings& s) {
    const double each = 1 / hertz(s);
    const long pictures = std::lround(s.hours * 3600 * hertz(s));
    float inFloat = 0;
    CompensatedSum inDouble;
    double product = 0;
    for (long i = 1; i <= pictures; ++i) {
        if (s.sum == Sum::floats) inFloat += static_cast<float>(each);
        if (s.sum == Sum::doubles) inDouble.sum += each;
        if (s.sum == Sum::compensated) inDouble.add(each);
        if (s.sum == Sum::product) product = double(i) * each;
    }
    return {double(inFloat) + inDouble.value() + product};
}

namespace {

using namespace mv::claims;

// The number of pictures times the length of one, which is a ratio of whole numbers.
Reference exactTime(const Demo& demo) {
    const auto s = settingsOf<Settings>(demo);
    const long double exact = s.display == Display::ntsc ? 60'000.0L / 1001 : static_cast<long double>(hertz(s));
    const long double seconds = static_cast<long double>(s.hours) * 3600;
    return {.values = {static_cast<double>(std::round(seconds * exact) / exact)}};
}

Study study() {
    Study study;
    study.quantity = "the time in seconds that is told after so many hours of pictures";
    study.reference = "the number of pictures times the length of one, in long double";
    study.makeReference = [](const Demo& demo, const ReferenceFrame&, const auto&) { return exactTime(demo); };
    study.problem = "hours";
    study.scenes = {{"60 Hz", {{"display", "60"}}}, {"59.94 Hz", {{"display", "59.94"}}}};
    const std::vector<std::string> hours{"0.1", "1", "6", "24"};
    for (const std::string sum : {"float", "double", "compensated", "product"}) {
        study.lines.push_back({.method = sum, .settings = {{"sum", sum}}, .knob = "hours", .values = hours});
    }
    study.wrongBeyond = 1.0 / 60;
    study.says = {
        claim("float-loses-minutes",
              "Added up as floats, sixtieths of a second are three quarters of an hour short after a day.",
              {value(of::rms, rows("float").in("60 Hz").at(24), 2600, 2610)}),
        claim("float-loses-pictures", "Within an hour they are more than a picture short.",
              {atLeast(of::rms, rows("float").in("60 Hz").from(1), 1.0 / 60)}),
        claim("double-is-enough", "In double a day of pictures is off by less than 10 millionths of a second.",
              {atMost(of::rms, rows("double"), 1e-5)}),
        claim("as-the-square",
              "Of sums, as floats or as doubles, the error grows at least as the square of the time: there are more "
              "additions, and a larger sum has coarser places.",
              {slope(of::rms, rows("float", "double"), 2, 3)}),
        claim("compensated", "With the roundings added up, too, it is right to the last places.",
              {atMost(of::rms, rows("compensated"), 3e-11)}),
        claim("product", "So is the number of the picture times its length, which adds up nothing and costs nothing.",
              {atMost(of::rms, rows("product"), 3e-11)}),
        note("The last place of a day in seconds, as a double, is 1.5e-11 s. A 60th is not a number in binary: each "
             "addition rounds, and always alike, so that the errors add up instead of cancelling.")};
    study.reads = {"display", "hours"};
    study.ofValues = true;
    return study;
}

const bool studied = addStudy("frame-rate", study());

}  // namespace
}  // namespace mv::frame_rate

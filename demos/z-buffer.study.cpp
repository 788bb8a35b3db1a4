// What measures z-buffer: how many pairs of points the depths of each format and mapping put in order.
#include <cctype>
#include <string>
#include <vector>

#include "mv/demo/demo.h"

using namespace mv;

namespace {

Study study() {
    Study study;
    study.quantity = "pairs of points at distances z and z (1 + separation) whose depths are not in order";
    study.reference = "which of the two is nearer, as they were made";
    study.makeReference = [](const Demo& demo, const ReferenceFrame&, const auto&) {
        return Reference{.values = std::vector<double>(demo.values().size(), 0)};
    };
    study.scenes = {{"separation 1e-4", {{"near", "0.1"}, {"separation", "1e-4"}}},
                    {"separation 1e-5", {{"near", "0.1"}, {"separation", "1e-5"}}},
                    {"separation 1e-6", {{"near", "0.1"}, {"separation", "1e-6"}}}};
    for (const std::string mapping : {"standard", "infinite", "reversed", "flipped", "logarithmic"}) {
        for (const std::string format : {"D16", "D24", "D32F"}) {
            if (mapping == "flipped" && format != "D32F") continue;  // what it does to integers, reversed shows
            std::string word = format;
            for (char& letter : word) letter = char(std::tolower(letter));
            std::string method = format;
            method.append(" ").append(mapping);
            study.lines.push_back({.method = method,
                                   .settings = {{"format", word}, {"mapping", mapping}},
                                   .knob = "far",
                                   .values = {"100", "1e4", "1e6"}});
        }
    }
    study.axis = ErrorAxis::fraction;
    study.says =
        "Only the float with reversed depth and glClipControl has every pair in order; with standard depth it is no "
        "better than 24 bits, which gain a point or two by reversing. The times are those of this model on a CPU and "
        "say nothing of a GPU's.";
    study.ofValues = true;
    return study;
}

const bool studied = addStudy("z-buffer", study());

}  // namespace

#include "support/hostile_lines.h"

#include <utility>

#include "mv/demo/demo.h"

namespace mv::test {

HostileLines::HostileLines(unsigned seed) : random_(seed) {
    words_ = {"--preset",
              "--shot",
              "--frame",
              "--frames",
              "--size",
              "--headless",
              "--compare",
              "--report",
              "--knobs",
              "--copyable",
              "--list",
              "--version",
              "--help",
              "--gallery",
              "--docs",
              "--study",
              "--vary",
              "--until",
              "--window",
              "--audit",
              "--all",
              "--",
              "-",
              "---",
              "=",
              "--=",
              "-h",
              "a.png",
              "%d.png",
              "%99999999999d",
              "1..3",
              "3..1",
              "0x0",
              "16384x16384",
              "-0",
              "1e400",
              "nan",
              "inf",
              "0x1p3",
              "99999999999999999999",
              "",
              " ",
              "\n",
              "\xff\xfe",
              "cull=back,front",
              "cull=",
              ",",
              "json",
              "5ms",
              "1%",
              "egl",
              std::string(5000, 'x')};
    for (const DemoInfo& info : catalogue()) {
        words_.push_back(info.name);
        for (const Preset& preset : info.presets) words_.push_back(preset.name);
        const auto demo = info.make();
        for (const Knob* knob : demo->knobs()) {
            words_.push_back("--" + knob->name());
            words_.push_back("--" + knob->name() + "=" + knob->initialText());
            for (const std::string& value : knob->sweep()) words_.push_back(value);
        }
    }
}

std::vector<std::string> HostileLines::next() {
    if (pick(2) == 0) return anyWords();
    std::vector<std::string> line = meant();
    for (std::size_t slips = pick(3); slips > 0; --slips) slip(line);
    return line;
}

std::vector<std::string> HostileLines::meant() {
    const DemoInfo& info = catalogue()[pick(catalogue().size())];
    const auto demo = info.make();
    std::vector<std::string> line{info.name};
    if (info.presets.size() > 0 && pick(3) == 0)
        line.push_back("--preset=" + info.presets[pick(info.presets.size())].name);
    for (std::size_t i = pick(4); i > 0; --i) {
        const Knob& knob = *demo->knobs()[pick(demo->knobs().size())];
        const std::vector<std::string> values = knob.sweep();
        line.push_back("--" + knob.name());
        line.push_back(values[pick(values.size())]);
    }
    static const std::vector<std::vector<std::string>> ends{{"--copyable"},
                                                            {"--knobs"},
                                                            {"--knobs=json"},
                                                            {"--help"},
                                                            {"--frame", "30", "--copyable"},
                                                            {"--size", "8x6", "--shot", "a.png"},
                                                            {"--size=8x6", "--frames", "1..3", "--shot", "a%02d.png"}};
    const std::vector<std::string>& end = ends[pick(ends.size())];
    line.insert(line.end(), end.begin(), end.end());
    return line;
}

std::vector<std::string> HostileLines::anyWords() {
    std::vector<std::string> line;
    if (pick(4) != 0) line.push_back(catalogue()[pick(catalogue().size())].name);
    for (std::size_t i = pick(6); i > 0; --i) {
        std::string word = words_[pick(words_.size())];
        if (!word.empty() && pick(8) == 0) word[pick(word.size())] = static_cast<char>(1 + pick(255));
        if (pick(8) == 0) word += "=" + words_[pick(words_.size())];
        line.push_back(word);
    }
    return line;
}

// One of: a letter wrong, a letter lost, a word lost, a word twice, two words exchanged, a word of another line.
void HostileLines::slip(std::vector<std::string>& line) {
    if (line.empty()) return;
    const std::size_t at = pick(line.size());
    std::string& word = line[at];
    switch (pick(6)) {
        case 0:
            if (!word.empty()) word[pick(word.size())] = static_cast<char>(1 + pick(255));
            break;
        case 1:
            if (!word.empty()) word.erase(pick(word.size()), 1);
            break;
        case 2:
            line.erase(line.begin() + static_cast<std::ptrdiff_t>(at));
            break;
        case 3:
            line.insert(line.begin() + static_cast<std::ptrdiff_t>(at), std::string(word));
            break;
        case 4:
            std::swap(word, line[pick(line.size())]);
            break;
        default:
            word = words_[pick(words_.size())];
    }
}

}  // namespace mv::test

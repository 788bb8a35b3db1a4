#include "support/golden.h"

#include <filesystem>
#include <fstream>
#include <sstream>

#include "mv/image/load.h"
#include "support/demo_run.h"

namespace mv::test {
namespace {

std::string folder() { return tree() + "/tests/goldens/"; }

std::string processor() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        if (line.rfind("vendor_id", 0) == 0) return line.substr(line.find(':') + 2);
    }
    return "unknown processor";
}

}  // namespace

const std::vector<GoldenCase>& goldenCases() {
    static const std::vector<GoldenCase> cases = [] {
        std::vector<GoldenCase> read;
        std::ifstream file(folder() + "cases.txt");
        for (std::string line; std::getline(file, line);) {
            if (line.empty() || line.front() == '#') continue;
            std::istringstream words(line);
            GoldenCase golden;
            words >> golden.name;
            std::vector<std::string> arguments;
            for (std::string word; words >> word && word != "|";) arguments.push_back(word);
            if (!words.eof()) {
                words >> golden.elsewhere >> std::ws;
                if (!words || !std::getline(words, golden.reason) || golden.reason.empty())
                    throw Error("tests/goldens/cases.txt", "must say after | how many percent may differ, and why",
                                line);
            }
            // A test program of one demo knows that demo alone, and takes no demo's name.
            if (catalogue().size() == 1) {
                if (arguments.front() != catalogue().front().name) continue;
                arguments.erase(arguments.begin());
            }
            golden.command = parseCommandLine(arguments);
            read.push_back(golden);
        }
        return read;
    }();
    return cases;
}

std::string goldenFile(const std::string& name) { return folder() + name + ".png"; }

Picture drawCase(const GoldenCase& golden) {
    const DemoInfo& info = *golden.command.demo;
    stage().open(info, golden.command.width ? golden.command.width : info.width,
                 golden.command.height ? golden.command.height : info.height);
    stage().begin(golden.command.knobs, golden.command.changes);
    stage().draw(golden.command.firstFrame);
    return stage().picture();
}

std::string recordedDriver() {
    std::ifstream file(folder() + "recorded.txt");
    std::string line;
    std::getline(file, line);
    return line;
}

std::string presentDriver() { return stage().driver().renderer + "; " + stage().driver().version + "; " + processor(); }

std::optional<std::string> mismatch(const GoldenCase& golden, const Picture& drawn, bool keepPictures) {
    constexpr int same = 3;  // levels
    const std::string& name = golden.name;
    const std::string file = goldenFile(name);
    if (!std::filesystem::exists(file))
        return "there is no golden picture " + file + "; ./test --update-goldens makes it";
    const Picture wanted = loadPicture(file);
    if (wanted.width != drawn.width || wanted.height != drawn.height) return "the size differs";
    const bool exact = recordedDriver() == presentDriver();
    const Difference any = compare(wanted, drawn, exact ? 0 : same);
    if (100 * any.fraction <= (exact ? 0 : golden.elsewhere)) return {};
    std::ostringstream reason;
    reason << any.beyond << " pixels (" << 100 * any.fraction << " %) differ by more than " << (exact ? 0 : same)
           << " levels, by at most " << any.maximum << "; allowed: ";
    exact ? reason << "none, since the recorded driver draws" : reason << golden.elsewhere << " %";
    if (keepPictures) {
        reason << "; see " << saveFailure(name + "-drawn", drawn);
        saveFailure(name + "-golden", wanted);
        saveFailure(name + "-difference", differencePicture(wanted, drawn));
    }
    return reason.str();
}

}  // namespace mv::test

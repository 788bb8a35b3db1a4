#include "support/demo_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <set>

#include "mv/gl/undefined.h"
#include "mv/image/compare.h"
#include "mv/image/png.h"
#include "mv/study/data.h"

namespace mv::test {
namespace {

HostKind wantedHost() {
    const char* name = std::getenv("MVGL_TEST_HOST");
    if (!name) return HostKind::automatic;
    if (const std::optional<HostKind> kind = hostNamed(name)) return *kind;
    throw Error("MVGL_TEST_HOST", "must be osmesa | egl | egl-device", name);
}

// A stage on a host, whose driver is listened to.
struct Watched {
    explicit Watched(std::unique_ptr<Context> on) : context(std::move(on)), stage(*context) {
        listenToDriver(true);
        watchUndefined(true);
    }
    std::unique_ptr<Context> context;
    Stage stage;
};

std::unique_ptr<Watched>& present() {
    // Never destroyed by itself, which would be after its driver's end: main() leaves it.
    static auto& only = *new std::unique_ptr<Watched>;
    return only;
}

Watched& watched() {
    if (!present()) stageOn(wantedHost());
    return *present();
}

}  // namespace

Stage& stage() { return watched().stage; }
Stage& stageOn(HostKind host, bool es) {
    leaveStage();  // a program has one table of OpenGL's functions
    std::vector<std::string> notes;
    const ContextRequest request = es ? ContextRequest{.version = 30, .es = true} : ContextRequest{};
    present() = std::make_unique<Watched>(openHeadless(host, request, notes));
    for (const std::string& note : notes) std::fprintf(stderr, "note: %s\n", note.c_str());
    return stage();
}
void leaveStage() { present().reset(); }
bool onLlvmpipe() { return stage().driver().renderer.find("llvmpipe") != std::string::npos; }
void* driverFunction(const char* name) { return watched().context->address(name); }
bool isLong() { return std::getenv("MVGL_LONG") != nullptr; }

DemoRun::DemoRun(const std::string& name, int width, int height) {
    const DemoInfo& info = findDemo(name);
    stage().open(info, width ? width : info.width, height ? height : info.height);
}

DemoRun& DemoRun::set(const std::string& knob, const std::string& value) {
    demo().knob(knob).parse(value);
    return *this;
}

DemoRun& DemoRun::set(const std::string& knob, double value) { return set(knob, numberText(value)); }

DemoRun& DemoRun::preset(const std::string& name) {
    applyPreset(demo(), findPreset(stage().info(), name));
    return *this;
}

Picture DemoRun::picture(int frame) {
    stage().draw(frame, true);
    return stage().picture();
}

bool DemoRun::measured(const std::string& name) {
    for (const Readout* readout : demo().readouts()) {
        if (readout->name() == name) return readout->value().has_value();
    }
    ADD_FAILURE() << "no readout " << name;
    return false;
}

double DemoRun::readout(const std::string& name) {
    for (const Readout* readout : demo().readouts()) {
        if (readout->name() == name && readout->value()) return *readout->value();
    }
    ADD_FAILURE() << "readout " << name << " was not measured";
    return std::numeric_limits<double>::quiet_NaN();
}

mat4 DemoRun::matrix(const std::string& name) {
    for (const auto& [shown, matrix] : stage().notes().matrices) {
        if (shown == name) return matrix;
    }
    ADD_FAILURE() << "no matrix " << name << " was shown";
    return mat4(std::numeric_limits<double>::quiet_NaN());
}

std::vector<std::string> DemoRun::messages() { return stage().notes().messages; }

std::string DemoRun::onlyMessage() {
    const auto said = messages();
    return said.size() == 1 ? said[0] : std::to_string(said.size()) + " messages";
}

std::string DemoRun::refusal() {
    try {
        demo().check();
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

double countOf(const StudyRow& row, const std::string& name) {
    for (const auto& [counted, amount] : row.counts) {
        if (counted == name) return amount;
    }
    ADD_FAILURE() << row.method << " does not count " << name;
    return std::numeric_limits<double>::quiet_NaN();
}

std::vector<std::string> demoNames() {
    std::vector<std::string> names;
    for (const DemoInfo& info : catalogue()) names.push_back(info.name);
    return names;
}

std::string parameterWord(const testing::TestParamInfo<std::string>& parameter) {
    std::string word = parameter.param;
    for (char& c : word) c = c == '-' ? '_' : c;
    return word;
}

bool sameColor(const Pixel& a, const Pixel& b) {
    const auto near = [](int first, int second) { return std::abs(first - second) <= 1; };
    return near(a.red, b.red) && near(a.green, b.green) && near(a.blue, b.blue);
}

long countPixels(const Picture& picture, Pixel color) {
    long count = 0;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < picture.width; ++x) {
            count += sameColor(picture.at(x, y), color) ? 1 : 0;
        }
    }
    return count;
}

long differentPixels(const Picture& a, const Picture& b) { return compare(a, b).beyond; }

int countColors(const Picture& picture, int most) {
    std::set<std::uint32_t> colors;
    for (std::size_t i = 0; i < picture.rgba.size() && static_cast<int>(colors.size()) < most; i += 4) {
        colors.insert(
            static_cast<std::uint32_t>(picture.rgba[i] << 16 | picture.rgba[i + 1] << 8 | picture.rgba[i + 2]));
    }
    return static_cast<int>(colors.size());
}

std::string tree() {
    const char* other = std::getenv("MVGL_TREE");
    return other ? other : MVGL_SOURCE_DIR;
}

std::string fileText(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    EXPECT_TRUE(stream) << path;
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::string demoText(const std::string& name) {
    const std::filesystem::path demos = MVGL_SOURCE_DIR "/demos";
    if (!std::filesystem::is_directory(demos / name)) return fileText(demos / (name + ".cpp"));
    std::string text;
    for (const auto& entry : std::filesystem::directory_iterator(demos / name)) {
        if (entry.path().extension() != ".md") text += fileText(entry.path());
    }
    return text;
}

std::string saveFailure(const std::string& name, const Picture& picture) {
    const std::filesystem::path folder = std::getenv("MVGL_TREE") ? tree() + "/failures" : MVGL_FAILURES;
    std::filesystem::create_directories(folder);
    const auto file = folder / (name + ".png");
    writePng(file, picture);
    return file.string();
}

}  // namespace mv::test

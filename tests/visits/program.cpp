// Its program, as a user or a CI job starts it: from anywhere, on each host, by a copied line.
#include <array>
#include <filesystem>
#include <regex>

#include "support/process.h"
#include "visits/visit.h"

namespace mv::test {
namespace {

namespace fs = std::filesystem;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// How far a picture is, said every two seconds, depends on how busy the machine is.
std::string withoutProgress(const std::string& said) {
    return std::regex_replace(said, std::regex("(pass|step) [0-9]+ of [0-9]+\n"), "");
}

std::string smallSize(const DemoInfo& info) {
    const int by = coarserOften(info);
    return std::to_string(info.width / by) + "x" + std::to_string(info.height / by);
}

// From the root and from a folder that cannot be written: no path is relative to where the program starts.
TEST_P(Visits, program_starts_from_anywhere) {
    TemporaryFolder folder;
    const std::string picture = folder.file("a.png");
    const std::string size = smallSize(findDemo(GetParam()));
    const ProcessResult fromRoot =
        runProcess({program(GetParam()), "--shot", picture, "--size", size}, {.folder = "/"});
    ASSERT_EQ(fromRoot.status, 0) << fromRoot.err;
    TemporaryFolder readOnly;
    fs::permissions(readOnly.path(), fs::perms::owner_read | fs::perms::owner_exec);
    const ProcessResult fromReadOnly = runProcess({program(GetParam()), "--shot", folder.file("b.png"), "--size", size},
                                                  {.folder = readOnly.path().string()});
    ASSERT_EQ(fromReadOnly.status, 0) << fromReadOnly.err;
    EXPECT_EQ(fileText(picture), fileText(folder.file("b.png")));
    EXPECT_EQ(folder.list(), (std::vector<std::string>{"a.png", "b.png"})) << "nothing else is left behind";
}

// Drawn into our own framebuffer object, a picture has the same bytes on every host of one Mesa, by however many threads.
TEST_P(Visits, program_draws_the_same_bytes_on_every_host) {
    TemporaryFolder folder;
    const std::string size = smallSize(findDemo(GetParam()));
    for (const char* host : {"osmesa", "egl", "egl-device"}) {
        const ProcessResult run =
            runProcess({program(GetParam()), "--shot", folder.file(std::string(host) + ".png"),
                        std::string("--headless=") + host, "--frame", "15", "--size", size, "--report"},
                       {.environment = {"LP_NUM_THREADS"}});  // which this test itself may run with
        ASSERT_EQ(run.status, 0) << run.err;
        EXPECT_TRUE(has(run.out, host == std::string("osmesa") ? "host      OSMesa"
                                 : host == std::string("egl")  ? "host      EGL surfaceless"
                                                               : "host      EGL software device"))
            << run.out;
        EXPECT_EQ(withoutProgress(run.err), "") << "no warning, no note";
    }
    EXPECT_EQ(fileText(folder.file("osmesa.png")), fileText(folder.file("egl.png")));
    EXPECT_EQ(fileText(folder.file("osmesa.png")), fileText(folder.file("egl-device.png")));
    const ProcessResult one =
        runProcess({program(GetParam()), "--shot", folder.file("one.png"), "--frame", "15", "--size", size},
                   {.environment = {"LP_NUM_THREADS=0"}});
    ASSERT_EQ(one.status, 0) << one.err;
    EXPECT_EQ(fileText(folder.file("one.png")), fileText(folder.file("osmesa.png")));
}

// With the first knob at one end of its range, whatever demo it is.
TEST_P(Visits, program_copyable_line_makes_the_same_picture) {
    TemporaryFolder folder;
    const auto demo = findDemo(GetParam()).make();
    const Knob& knob = *demo->knobs().front();
    const std::vector<std::string> ends = knob.sweep();
    const std::string value = ends.back() == knob.initialText() ? ends.front() : ends.back();
    ASSERT_NE(value, knob.initialText()) << "a knob at its initial value would not be printed";
    const std::vector<std::string> settings{"--frame", "33", "--size", "200x150", "--" + knob.name(), value};
    std::vector<std::string> asking{program("mvgl"), GetParam(), "--copyable"};
    asking.insert(asking.end(), settings.begin(), settings.end());
    const ProcessResult line = runProcess(asking);
    ASSERT_EQ(line.status, 0) << line.err;
    EXPECT_TRUE(has(line.out, "--" + knob.name() + " " + value)) << line.out;

    // Pasted as it is.
    const std::string pasted = line.out.substr(0, line.out.find('\n')) + " --shot a.png";
    const ProcessResult copied = runProcess({"/bin/sh", "-c", pasted}, {.folder = folder.path().string()});
    ASSERT_EQ(copied.status, 0) << pasted << "\n" << copied.err;
    std::vector<std::string> direct{program(GetParam()), "--shot", folder.file("b.png")};
    direct.insert(direct.end(), settings.begin(), settings.end());
    ASSERT_EQ(runProcess(direct).status, 0);
    EXPECT_EQ(fileText(folder.file("a.png")), fileText(folder.file("b.png")));
}

}  // namespace
}  // namespace mv::test

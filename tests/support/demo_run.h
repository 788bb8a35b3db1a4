// Demos under test: pictures and readouts by demo, knobs and frame. One context serves all runs of a test program.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "mv/image/picture.h"
#include "mv/show/stage.h"
#include "support/sanitized.h"

namespace mv {
struct StudyRow;
}

namespace mv::test {

// The stage of this test program, on the host named by MVGL_TEST_HOST (osmesa, egl, egl-device; the program's own choice
// without). The driver is listened to, and each draw is watched for what OpenGL leaves undefined.
Stage& stage();
// Opens that stage anew on another host, by OpenGL or OpenGL ES 3.0; and ends it: what asks for stage() next has that of MVGL_TEST_HOST.
Stage& stageOn(HostKind host, bool es = false);
void leaveStage();
// Whether Mesa's llvmpipe draws. A check that is asked only of it is no promise of OpenGL's, and the page says so.
bool onLlvmpipe();
// A function of its driver that the table has not; null where the driver has not either.
void* driverFunction(const char* name);
// Whether ./test --long runs it.
bool isLong();

// Whether the demo's picture is made in passes, since it takes long: what is tried in many settings is then tried smaller.
inline bool hasPasses(const DemoInfo& info) { return info.make()->passes(FrameInfo(1, info.width, info.height)) > 0; }

// The number by which such a picture's sides are divided where it is tried often; 1 for other demos.
inline int coarser(const DemoInfo& info) { return hasPasses(info) ? 10 : 1; }
// The number for any demo where many pictures are drawn, each of which still shows something: a third of the sides, a ninth of the points.
inline int coarserOften(const DemoInfo& info) { return std::max(3, coarser(info)); }
// coarser() where once is enough but under the sanitizers, which see the same code in a small one.
inline int coarserIfSanitized(const DemoInfo& info) { return sanitized ? coarser(info) : 1; }

// A demo on that stage, at its own size unless another is given.
//     DemoRun run("cube-cull");
//     const Picture back = run.set("cull", "back").picture();
// A second DemoRun ends the first.
class DemoRun {
  public:
    explicit DemoRun(const std::string& name, int width = 0, int height = 0);
    DemoRun& set(const std::string& knob, const std::string& value);
    DemoRun& set(const std::string& knob, double value);
    // Sets all knobs, by the demo's preset of that name.
    DemoRun& preset(const std::string& name);
    // Draws the frame, readouts too, and returns the picture.
    Picture picture(int frame = 1);
    // A readout of the last picture; a test failure and NaN where it was not measured.
    double readout(const std::string& name);
    bool measured(const std::string& name);
    // A matrix of the last picture, by its shown name; a test failure where there is none.
    mat4 matrix(const std::string& name);
    std::vector<std::string> messages();
    // The message of the last picture where it has one, else how many it has.
    std::string onlyMessage();
    // The words of check() on the present settings; "" where it lets them pass.
    std::string refusal();
    Demo& demo() { return stage().demo(); }
};

// What a row of a study has counted, by its name; a test failure and NaN where it has not.
double countOf(const StudyRow& row, const std::string& name);

// The names of all demos of this test program, and a parameter as a word that a test's name may have.
std::vector<std::string> demoNames();
std::string parameterWord(const testing::TestParamInfo<std::string>& parameter);

// Whether two colours are the same but for one level a channel (alpha aside): a driver may round 0.5 of 255 up or down.
bool sameColor(const Pixel& a, const Pixel& b);
// The number of pixels of this colour, as sameColor() says.
long countPixels(const Picture& picture, Pixel color);
long differentPixels(const Picture& a, const Picture& b);
// How many colours the picture has, counted up to `most`.
int countColors(const Picture& picture, int most = 1000);

// The folder of the sources, or the one that MVGL_TREE names: with tests/goldens and assets, and with the failures (scripts/gpu.sh).
std::string tree();
// The contents of a file; a test failure where it cannot be read.
std::string fileText(const std::filesystem::path& path);
// The source of a demo: its file, or those of its folder, without its page.
std::string demoText(const std::string& name);
// Saves a picture for a person to look at after a failure, in build/failures, or in MVGL_TREE, and returns its path.
std::string saveFailure(const std::string& name, const Picture& picture);

}  // namespace mv::test

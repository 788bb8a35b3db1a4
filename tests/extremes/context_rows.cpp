// X41: machines whose OpenGL is too old, and without any.
#include <string>
#include <vector>

#include "extremes/row.h"
#include "mv/error.h"
#include "support/process.h"

using namespace mv;
using namespace mv::test;

namespace {

[[maybe_unused]] const bool x41 = addRow([] {
    const std::string unchecked = MVGL_BINARY_DIR "/tests/unchecked-context";
    const auto runUnchecked = [&](std::vector<std::string> environment) {
        environment.insert(environment.end(), {"DISPLAY", "EGL_PLATFORM=surfaceless"});
        return runProcess({unchecked}, {.environment = environment});
    };
    if (runUnchecked({}).out != "255\n") throw Error("unchecked-context", "must draw where OpenGL is as it should be");
    double naive = 0, ours = 0;
    for (const std::vector<std::string>& machine :
         {std::vector<std::string>{"MESA_GL_VERSION_OVERRIDE=2.1", "MESA_GLSL_VERSION_OVERRIDE=120"},
          {"__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent.json"}}) {
        const ProcessResult usual = runUnchecked(machine);
        naive += usual.status == 0 && usual.out == "255\n" ? 0 : 1;
        const TemporaryFolder folder;
        const ProcessResult run = runProcess({program("cube-cull"), "--shot", folder.file("a.png"), "--headless=egl"},
                                             {.environment = machine});
        const bool inWords = run.status == 1 && run.err.rfind("error: ", 0) == 0;
        ours += inWords && folder.entries() == 0 ? 0 : 1;
    }
    return Row{.id = "X41",
               .input = "OpenGL 2.1, and no driver",
               .measured = "runs that end with a wrong picture or a crash instead of a sentence and status 1",
               .naive = "take the context as it comes",
               .naiveError = naive,
               .ours = "version and driver are asked for by name",
               .ourError = ours,
               .tolerance = 0,
               .reason = "a black window teaches nothing"};
});

}  // namespace

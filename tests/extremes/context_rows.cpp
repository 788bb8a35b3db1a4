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
    const std::vector<std::string> usual{"DISPLAY", "EGL_PLATFORM=surfaceless"};
    if (runProcess({unchecked}, {.environment = usual}).out != "255\n") {
        throw Error("unchecked-context", "must draw where OpenGL is as it should be");
    }
    struct Machine {
        std::vector<std::string> environment;
        bool canDraw;             // with what is left to it
        bool hasPlatform = true;  // told to the usual form, which asks for the display alone
    };
    const std::vector<Machine> machines{
        {{"MESA_GL_VERSION_OVERRIDE=2.1", "MESA_GLSL_VERSION_OVERRIDE=120"}, false},
        {{"__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent.json"}, false},
        {{"DISPLAY", "WAYLAND_DISPLAY", "EGL_PLATFORM"}, true, false},
        {{"XDG_CACHE_HOME=/dev/null/none", "HOME=/dev/null", "MESA_SHADER_CACHE_DIR=/dev/null/none"}, true},
    };
    double naive = 0, ours = 0;
    for (const Machine& machine : machines) {
        std::vector<std::string> environment = machine.environment;
        if (machine.hasPlatform) environment.insert(environment.end(), usual.begin(), usual.end());
        const ProcessResult taken = runProcess({unchecked}, {.environment = environment});
        naive += taken.status == 0 && taken.out == "255\n" ? 0 : 1;
        const TemporaryFolder folder;
        const ProcessResult run = runProcess({program("cube-cull"), "--shot", folder.file("a.png"), "--headless=egl"},
                                             {.environment = machine.environment});
        const bool inWords = run.status == 1 && run.err.rfind("error: ", 0) == 0 && folder.entries() == 0;
        const bool drawn = run.status == 0 && folder.entries() == 1;
        ours += (machine.canDraw ? drawn : inWords) ? 0 : 1;
    }
    return Row{.id = "X41",
               .input = "OpenGL 2.1; no driver; no display; no place for a shader cache",
               .measured =
                   "runs that end with a wrong picture or a crash, instead of a sentence and status 1 in the first two "
                   "and the right picture in the others",
               .naive = "take the context as it comes",
               .naiveError = naive,
               .ours = "version and driver are asked for by name",
               .ourError = ours,
               .tolerance = 0,
               .reason = "a black window teaches nothing"};
});

}  // namespace

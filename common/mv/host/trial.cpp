#include "mv/host/trial.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>

#include "mv/error.h"
#include "mv/gl/program.h"
#include "mv/gl/target.h"

namespace mv {
namespace {

// The variables of this environment that Mesa and its drivers read, "NAME=value, NAME=value".
std::string driverVariables() {
    static constexpr std::array prefixes{"GALLIUM_", "MESA_", "DRAW_",  "LIBGL_", "LP_",   "GALLIVM_",
                                         "ST_",      "TGSI_", "ZINK_",  "VIRGL",  "SVGA_", "SOFTPIPE_",
                                         "OSMESA_",  "EGL_",  "D3D12_", "NIR_",   "LLVM_", "VK_"};
    std::string list;
    for (char** entry = environ; *entry; ++entry) {
        for (const char* prefix : prefixes) {
            if (std::string_view(*entry).starts_with(prefix)) list += (list.empty() ? "" : ", ") + std::string(*entry);
        }
    }
    return list;
}

// Shaders are compiled for the processor when something is first drawn.
void drawSomething(const Context& context) {
    loadFunctions([&](const char* name) { return context.address(name); });
    const Target target(4, 4, {.depth = true}, "trial");
    const Program program =
        Program::fromText("trial", "void main() { gl_Position = vec4(gl_VertexID & 1, gl_VertexID >> 1, 0.0, 1.0); }\n",
                          "out vec4 color;\nvoid main() { color = vec4(1.0); }\n");
    const VertexArray none = makeVertexArray();
    program.use();
    glBindVertexArray(none.id());
    glDrawArrays(GL_TRIANGLES, 0, 3);
    target.read();
}

// The child: silent, without a core dump, and with an end in any case.
[[noreturn]] void tryInChild(const std::function<std::unique_ptr<Context>()>& open) {
    constexpr unsigned secondsAtMost = 30;
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGILL, SIGFPE, SIGALRM}) std::signal(signal, SIG_DFL);
    const rlimit nothing{0, 0};
    setrlimit(RLIMIT_CORE, &nothing);
    alarm(secondsAtMost);
    const int silence = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(silence, STDOUT_FILENO);
    dup2(silence, STDERR_FILENO);
    try {
        drawSomething(*open());
    } catch (...) {  // refused in words: the parent will hear them
    }
    _exit(0);
}

}  // namespace

std::unique_ptr<Context> openTried(const std::string& host, const std::function<std::unique_ptr<Context>()>& open) {
    const std::string variables = driverVariables();
    if (variables.empty()) return open();
    const pid_t child = fork();
    if (child < 0) throw Error(host, "must be tried in a process of its own", std::strerror(errno));
    if (child == 0) tryInChild(open);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    if (WIFSIGNALED(status)) {
        throw Error(host,
                    std::string("must draw, and is ended by a signal (") + strsignal(WTERMSIG(status)) +
                        "); unset what steers its driver",
                    variables);
    }
    return open();
}

}  // namespace mv

#include "mv/host/trial.h"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <mutex>
#include <string_view>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "mv/error.h"
#include "mv/gl/program.h"
#include "mv/gl/target.h"
#include "mv/host/library.h"

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

// ---- What the system does not give

// The limits of memory in words, and "" where there is none that matters.
std::string memoryLimit() {
    constexpr rlim_t plenty = rlim_t{2} << 30U;
    std::string text;
    for (const auto& [resource, flag] : {std::pair{RLIMIT_AS, "-v"}, {RLIMIT_DATA, "-d"}}) {
        rlimit limit{};
        if (getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY || limit.rlim_cur >= plenty) continue;
        text += (text.empty() ? "ulimit " : " and ") + std::string(flag) + " allows " +
                std::to_string(limit.rlim_cur >> 20U) + " MB";
    }
    return text;
}

// A driver starts threads, as many as there are processors, and waits for ever for those that could not be started.
void requireThreads(const std::string& host) {
    constexpr unsigned fewest = 2, most = 16;
    const std::size_t wanted = std::clamp(std::thread::hardware_concurrency(), fewest, most);
    std::vector<std::thread> threads;
    std::mutex held;
    std::unique_lock lock(held);  // all of them are there at once
    std::string reason;
    try {
        while (threads.size() < wanted) threads.emplace_back([&held] { const std::scoped_lock wait(held); });
    } catch (const std::system_error& error) {
        reason = error.code().message();
    } catch (const std::bad_alloc&) {  // those that are there are still to be joined
        reason = std::strerror(ENOMEM);
    }
    lock.unlock();
    for (std::thread& thread : threads) thread.join();
    if (!reason.empty()) {
        throw ScarceError(host, "must be allowed to start threads; ulimit -u, -v and -d limit them", reason);
    }
}

// Opens it. A failure for want of memory is told as that: a driver that cannot be loaded says that it is missing.
std::unique_ptr<Context> openWithin(const std::string& host, const std::function<std::unique_ptr<Context>()>& open) {
    const std::string limit = memoryLimit();
    if (limit.empty()) return open();
    try {
        return open();
    } catch (const MissingError&) {
        throw;
    } catch (const Error&) {
        throw ScarceError(host, "must have more memory to be opened, some 500 MB", limit);
    }
}

// ---- The end by a signal

constexpr std::array faults{SIGSEGV, SIGABRT, SIGBUS, SIGILL, SIGFPE};

// The words after the signal's name, made before: a handler may not allocate.
std::array<char, 2048> afterFault{};

void say(const char* text) {
    for (std::size_t left = std::strlen(text); left > 0;) {
        const ssize_t written = ::write(STDERR_FILENO, text, left);
        if (written <= 0) return;
        text += written;
        left -= static_cast<std::size_t>(written);
    }
}

const char* faultName(int signal) {
    switch (signal) {
        case SIGSEGV:
            return "Segmentation fault";
        case SIGABRT:
            return "Aborted";
        case SIGBUS:
            return "Bus error";
        case SIGILL:
            return "Illegal instruction";
        default:
            return "Floating point exception";
    }
}

void tellAndEnd(int signal) {
    say("error: driver: must go on, and is ended by a signal (");
    say(faultName(signal));
    say(afterFault.data());
    _exit(1);
}

// Nothing is allocated: there may be nothing.
void requireLimit(decltype(RLIMIT_STACK) resource, rlim_t kilobytes, const char* sentence) {
    rlimit limit{};
    if (getrlimit(resource, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY || limit.rlim_cur >> 10U >= kilobytes)
        return;
    std::array<char, 256> text{};
    std::snprintf(text.data(), text.size(), "error: %s, %llu KB\n", sentence,
                  static_cast<unsigned long long>(limit.rlim_cur >> 10U));
    say(text.data());
    _exit(1);
}

}  // namespace

void requireRoom() {
    // Mesa's compiler takes 300 KB for the longest of the demos' shaders; and a thread of a driver gets as much as this one,
    // where no handler could tell of its end.
    requireLimit(RLIMIT_STACK, 1024,
                 "stack: must be allowed 1024 KB at least, for shaders are compiled on it; raise ulimit -s");
    // The tables of all demos take 3 MB.
    requireLimit(RLIMIT_DATA, 8192,
                 "memory: must be allowed 8192 KB at least for the tables of the demos; raise ulimit -d");
}

void tellOfFaults() {
    // A compiler that has used up the stack for a long shader has none left for the handler.
    static std::array<char, std::size_t{1} << 16U> stack;
    const stack_t other{.ss_sp = stack.data(), .ss_flags = 0, .ss_size = stack.size()};
    sigaltstack(&other, nullptr);
    const std::string variables = driverVariables(), limit = memoryLimit();
    std::string text = "); it wants more memory or stack than there is (ulimit -v, -s; a long shader), or is at fault";
    if (!limit.empty()) text += "; " + limit;
    if (!variables.empty()) text += "; unset what steers it, " + variables;
    std::snprintf(afterFault.data(), afterFault.size(), "%s\n", text.c_str());
    for (const int signal : faults) {
        struct sigaction now {};
        if (sigaction(signal, nullptr, &now) != 0 || now.sa_handler != SIG_DFL) continue;  // a sanitizer's, say
        struct sigaction ours {};
        ours.sa_handler = tellAndEnd;
        ours.sa_flags = SA_ONSTACK;
        sigaction(signal, &ours, nullptr);
    }
}

std::unique_ptr<Context> openTried(const std::string& host, const std::function<std::unique_ptr<Context>()>& open) {
    requireThreads(host);
    const std::string variables = driverVariables();
    if (variables.empty()) return openWithin(host, open);
    const pid_t child = fork();
    if (child < 0) throw Error(host, "must be tried in a process of its own", std::strerror(errno));
    if (child == 0) tryInChild(open);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    // A loader that finds its lists overwritten ends the process by its own exit.
    if (status != 0) {
        const std::string end = WIFSIGNALED(status) ? std::string("a signal (") + strsignal(WTERMSIG(status)) + ")"
                                                    : "its driver (status " + std::to_string(WEXITSTATUS(status)) + ")";
        throw Error(host, "must draw, and is ended by " + end + "; unset what steers its driver", variables);
    }
    return openWithin(host, open);
}

}  // namespace mv

#include "mv/window/child.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <string_view>
#include <system_error>
#include <thread>

#include "mv/error.h"

namespace mv {
namespace {

std::string reason(int number) { return std::generic_category().message(number); }

// The forked process on its way to another program: calls only what is allowed between fork and exec.
[[noreturn]] void becomeProgram(char** argv, int null, int errors, pid_t parent) {
    ::setpgid(0, 0);  // a group of its own, so that what it starts is killed with it
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::getppid() == parent) {  // else it has died before the line above
        ::signal(SIGPIPE, SIG_DFL);
        ::dup2(null, STDIN_FILENO);
        ::dup2(null, STDOUT_FILENO);
        ::dup2(errors, STDERR_FILENO);
        ::execv(argv[0], argv);
        constexpr std::string_view sentence = "error: program: could not be started once more\n";
        [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, sentence.data(), sentence.size());
    }
    ::_exit(127);
}

int exitStatus(int waited) { return WIFEXITED(waited) ? WEXITSTATUS(waited) : 128 + WTERMSIG(waited); }

}  // namespace

Child::Child(const std::vector<std::string>& arguments) {
    int ends[2] = {-1, -1};
    if (::pipe2(ends, O_CLOEXEC) != 0) throw Error("pipe", "could not be made", reason(errno));
    errors_ = ends[0];
    ::fcntl(errors_, F_SETFL, O_NONBLOCK);

    std::vector<std::string> words{"/proc/self/exe"};
    words.insert(words.end(), arguments.begin(), arguments.end());
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const int null = ::open("/dev/null", O_RDWR | O_CLOEXEC);
    const pid_t parent = ::getpid();
    // Not posix_spawn, which cannot ask for PR_SET_PDEATHSIG.
    process_ = ::fork();
    if (process_ == 0) becomeProgram(argv.data(), null, ends[1], parent);
    const int failure = errno;
    ::close(ends[1]);
    if (null >= 0) ::close(null);
    if (process_ < 0) {
        ::close(errors_);
        throw Error("program", "could not be started once more", reason(failure));
    }
}

Child::~Child() {
    if (!status()) {
        ::kill(-process_, SIGTERM);
        for (int waits = 0; !status() && waits < 200; ++waits)
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    if (!status()) {
        ::kill(-process_, SIGKILL);
        int waited = 0;
        while (::waitpid(process_, &waited, 0) < 0 && errno == EINTR) {
        }
    }
    ::close(errors_);
}

std::vector<std::string> Child::takeLines() {
    char bytes[4096];
    for (;;) {
        const ssize_t count = ::read(errors_, bytes, sizeof bytes);
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) break;
        begun_.append(bytes, static_cast<std::size_t>(count));
    }
    std::vector<std::string> lines;
    for (std::size_t end = begun_.find('\n'); end != std::string::npos; end = begun_.find('\n')) {
        lines.push_back(begun_.substr(0, end));
        begun_.erase(0, end + 1);
    }
    return lines;
}

std::optional<int> Child::status() {
    int waited = 0;
    if (!status_ && ::waitpid(process_, &waited, WNOHANG) == process_) status_ = exitStatus(waited);
    return status_;
}

}  // namespace mv

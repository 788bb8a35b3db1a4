#include "mv/run/converter.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <system_error>
#include <thread>
#include <utility>

#include "mv/error.h"

namespace mv {
namespace {

using Clock = std::chrono::steady_clock;

// The forked process on its way to the program: calls only what is allowed between fork and exec.
[[noreturn]] void become(char** argv, int input, pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // what it has written is in a folder that nobody reads
    if (::getppid() == parent) {         // else it has died before the line above
        for (const int ignored : {SIGPIPE, SIGXFSZ}) std::signal(ignored, SIG_DFL);
        ::dup2(input, STDIN_FILENO);
        ::execvp(argv[0], argv);
    }
    ::_exit(127);
}

}  // namespace

Converter::Converter(const std::string& flag, std::vector<std::string> words, std::filesystem::path made,
                     std::chrono::milliseconds patience)
    : name_(words.at(0)), made_(std::move(made)), patience_(patience) {
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    int ends[2] = {-1, -1};
    if (::pipe2(ends, O_CLOEXEC) != 0) throw Error(flag, "must be able to start " + name_, std::strerror(errno));
    ::fcntl(ends[1], F_SETFL, O_NONBLOCK);
    const pid_t parent = ::getpid();
    // Neither popen nor posix_spawn can ask for PR_SET_PDEATHSIG.
    process_ = ::fork();
    if (process_ == 0) become(argv.data(), ends[0], parent);
    const int failure = errno;
    ::close(ends[0]);
    if (process_ < 0) {
        ::close(ends[1]);
        throw Error(flag, "must be able to start " + name_, std::strerror(failure));
    }
    pipe_ = ends[1];
}

Converter::~Converter() {
    if (pipe_ >= 0) ::close(pipe_);
    if (process_ < 0) return;
    ::kill(process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

void Converter::requireProgress() {
    std::error_code none;
    const std::uintmax_t size = std::filesystem::file_size(made_, none);
    if (!none && std::exchange(lastSize_, size) != size) lastMove_ = Clock::now();
    if (Clock::now() - lastMove_ < patience_) return;
    throw Error(name_, "must take what it is given or write what it makes; it hangs",
                "neither for " + std::to_string(patience_.count() / 1000) + " s");
}

bool Converter::give(std::span<const std::byte> bytes) {
    lastMove_ = Clock::now();
    while (!bytes.empty()) {
        const ssize_t count = ::write(pipe_, bytes.data(), bytes.size());
        if (count > 0) {
            bytes = bytes.subspan(static_cast<std::size_t>(count));
            lastMove_ = Clock::now();
            continue;
        }
        if (count < 0 && errno != EAGAIN && errno != EINTR) return false;
        constexpr int milliseconds = 50;
        pollfd room{pipe_, POLLOUT, 0};
        ::poll(&room, 1, milliseconds);
        requireProgress();
    }
    return true;
}

bool Converter::finish() {
    lastMove_ = Clock::now();
    ::close(std::exchange(pipe_, -1));
    int status = 0;
    for (;;) {
        const pid_t ended = ::waitpid(process_, &status, WNOHANG);
        if (ended == process_) break;
        if (ended < 0 && errno != EINTR) return false;
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        requireProgress();
    }
    process_ = -1;
    return status == 0;
}

}  // namespace mv

#include "mv/run/film.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <span>
#include <system_error>
#include <thread>
#include <utility>

#include "mv/error.h"

namespace mv {
namespace {

using Clock = std::chrono::steady_clock;

// The forked process on its way to ffmpeg: calls only what is allowed between fork and exec.
[[noreturn]] void becomeFfmpeg(char** argv, int pictures, pid_t parent) {
    ::prctl(PR_SET_PDEATHSIG, SIGKILL);  // what it has written is in a folder that nobody reads
    if (::getppid() == parent) {         // else it has died before the line above
        for (const int ignored : {SIGPIPE, SIGXFSZ}) std::signal(ignored, SIG_DFL);
        ::dup2(pictures, STDIN_FILENO);
        ::execvp(argv[0], argv);
    }
    ::_exit(127);
}

}  // namespace

Film::Film(const std::string& file, int width, int height, std::chrono::milliseconds patience)
    : file_(file), scratch_("movie"), patience_(patience) {
    if (!isInPath("ffmpeg")) {
        throw Error("--movie",
                    "needs ffmpeg, which is not installed (sudo apt install ffmpeg); --shot a.%04d.png writes "
                    "the pictures without");
    }
    requireWritable(file);
    const std::string extension = std::filesystem::path(file).extension().string();
    made_ = scratch_.path() / ("movie" + extension);
    std::vector<std::string> words{"ffmpeg", "-loglevel", "error", "-y", "-f", "rawvideo", "-pix_fmt", "rgba", "-s"};
    words.push_back(std::to_string(width) + "x" + std::to_string(height));
    for (const char* word : {"-r", "60", "-i", "-", "-vf"}) words.emplace_back(word);
    // Video has half as many colours as pixels a side, and so even sides, and says by which matrix its colours are made, which players
    // guess else; a GIF has a palette of its own
    if (extension == ".gif") {
        words.emplace_back("fps=30,split[a][b];[a]palettegen[p];[b][p]paletteuse");
    } else {
        for (const char* word :
             {"pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv", "-pix_fmt", "yuv420p",
              "-colorspace", "bt709", "-color_primaries", "bt709", "-color_trc", "bt709", "-color_range", "tv"})
            words.emplace_back(word);
    }
    words.push_back(made_.string());
    start(std::move(words));
}

void Film::start(std::vector<std::string> words) {
    std::vector<char*> argv;
    argv.reserve(words.size() + 1);
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    int ends[2] = {-1, -1};
    if (::pipe2(ends, O_CLOEXEC) != 0) throw Error("--movie", "must be able to start ffmpeg", std::strerror(errno));
    ::fcntl(ends[1], F_SETFL, O_NONBLOCK);
    const pid_t parent = ::getpid();
    // Neither popen nor posix_spawn can ask for PR_SET_PDEATHSIG.
    process_ = ::fork();
    if (process_ == 0) becomeFfmpeg(argv.data(), ends[0], parent);
    const int failure = errno;
    ::close(ends[0]);
    if (process_ < 0) {
        ::close(ends[1]);
        throw Error("--movie", "must be able to start ffmpeg", std::strerror(failure));
    }
    pipe_ = ends[1];
}

Film::~Film() {
    if (pipe_ >= 0) ::close(pipe_);
    if (process_ < 0) return;
    ::kill(process_, SIGKILL);
    while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
    }
}

void Film::requireProgress() {
    std::error_code none;
    const std::uintmax_t size = std::filesystem::file_size(made_, none);
    if (!none && std::exchange(lastSize_, size) != size) lastMove_ = Clock::now();
    if (Clock::now() - lastMove_ < patience_) return;
    throw Error("ffmpeg", "must take pictures or write the film; it hangs",
                "neither for " + std::to_string(patience_.count() / 1000) + " s");
}

void Film::add(const Picture& picture) {
    lastMove_ = Clock::now();
    auto rest = std::as_bytes(std::span(picture.rgba));
    while (!rest.empty()) {
        const ssize_t count = ::write(pipe_, rest.data(), rest.size());
        if (count > 0) {
            rest = rest.subspan(static_cast<std::size_t>(count));
            lastMove_ = Clock::now();
            continue;
        }
        if (count < 0 && errno != EAGAIN && errno != EINTR) refuse();
        constexpr int milliseconds = 50;
        pollfd room{pipe_, POLLOUT, 0};
        ::poll(&room, 1, milliseconds);
        requireProgress();
    }
}

void Film::finish() {
    lastMove_ = Clock::now();
    ::close(std::exchange(pipe_, -1));
    int status = 0;
    for (;;) {
        const pid_t ended = ::waitpid(process_, &status, WNOHANG);
        if (ended == process_) break;
        if (ended < 0 && errno != EINTR) refuse();
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
        requireProgress();
    }
    process_ = -1;
    if (status != 0) refuse();
    constexpr std::size_t mostBytes = std::size_t{4} << 30U;
    writeFileAtomically(file_, readFile(made_, mostBytes));
}

void Film::refuse() const { throw Error(file_, "must be a film that this ffmpeg can make; it says why above"); }

}  // namespace mv

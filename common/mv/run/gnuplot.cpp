#include "mv/run/gnuplot.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <string_view>
#include <system_error>

#include "mv/error.h"
#include "mv/image/file.h"

namespace mv {
namespace {

constexpr std::size_t largest = std::size_t{1} << 24U;

std::string reasonText(int errorNumber) { return std::generic_category().message(errorNumber); }

bool isControl(char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7F; }

// Gnuplot's several lines as one.
std::string inOneLine(const std::string& text) {
    std::string line;
    for (const char c : text) {
        const bool space = isControl(c) || c == ' ';
        if (!space || (!line.empty() && line.back() != ' ')) line += space ? ' ' : c;
    }
    while (line.ends_with(' ')) line.pop_back();
    return line;
}

// Runs gnuplot in the folder, where it leaves what it says in the file "errors". Returns "" or why it could not.
std::string runGnuplot(const std::filesystem::path& folder) {
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    ::posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "errors", O_WRONLY | O_CREAT | O_TRUNC, 0666);
    ::posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
    std::string words[] = {"gnuplot", "-d", "plot.gp"};
    char* const argv[] = {words[0].data(), words[1].data(), words[2].data(), nullptr};
    pid_t process = -1;
    const int failure = ::posix_spawnp(&process, argv[0], &actions, nullptr, argv, environ);
    ::posix_spawn_file_actions_destroy(&actions);
    if (failure != 0) return reasonText(failure);
    int status = 0;
    while (::waitpid(process, &status, 0) < 0) {
        if (errno != EINTR) return reasonText(errno);
    }
    if (WIFEXITED(status) && WEXITSTATUS(status) == 0) return "";
    std::string said = inOneLine(readTextFile(folder / "errors", largest));
    return said.empty() ? "it ended without a word" : said;
}

}  // namespace

std::string quotedForGnuplot(const std::string& text) {
    std::string quoted = "'";
    for (const char c : text) {
        if (c == '\'') quoted += '\'';
        quoted += isControl(c) ? ' ' : c;
    }
    return quoted + "'";
}

std::string drawnByGnuplot(const std::string& script) {
    const ScratchFolder scratch("plot");
    writeFileAtomically(scratch.path() / "plot.gp", std::string_view("set output 'plot.svg'\n" + script));
    const std::string problem = runGnuplot(scratch.path());
    std::string svg = problem.empty() ? readTextFile(scratch.path() / "plot.svg", largest) : "";
    if (svg.find("</svg>") == std::string::npos) {
        throw Error("gnuplot", "must be there and draw the plot (package gnuplot-nox)", problem);
    }
    return svg;
}

}  // namespace mv

#include "mv/window/desktop.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <string>

#include "mv/error.h"
#include "mv/image/file.h"

namespace mv {

void openByDesktop(const std::filesystem::path& file) {
    if (!isInPath("xdg-open"))
        throw Error("xdg-open", "must be installed (package xdg-utils) to open this file", file.string());
    const std::string path = file.string();
    const pid_t child = ::fork();
    if (child < 0) throw Error("xdg-open", "could not be started");
    if (child == 0) {
        // Once more, so that nobody waits for it
        if (::fork() != 0) ::_exit(0);
        ::setsid();
        const int null = ::open("/dev/null", O_RDWR | O_CLOEXEC);
        for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) ::dup2(null, stream);
        ::execlp("xdg-open", "xdg-open", path.c_str(), nullptr);
        ::_exit(127);
    }
    int waited = 0;
    while (::waitpid(child, &waited, 0) < 0 && errno == EINTR) {
    }
}

}  // namespace mv

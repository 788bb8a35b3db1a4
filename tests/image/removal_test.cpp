// What a program that is told to end leaves behind: nothing.
#include "mv/image/removal.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <functional>
#include <string>
#include <vector>

#include "mv/image/file.h"
#include "support/temporary_folder.h"

namespace mv {
namespace {

namespace fs = std::filesystem;

// Runs `work` in a child process, which writes a line to `ready` when it has come so far, and sends it the signal then.
// Returns what wait() says of its end.
int endedBy(int signal, const std::function<void(int ready)>& work) {
    int ends[2] = {-1, -1};
    if (pipe(ends) != 0) throw std::runtime_error("no pipe");
    const pid_t child = fork();
    if (child == 0) {
        close(ends[0]);
        try {
            work(ends[1]);
        } catch (...) {
        }
        _exit(99);
    }
    close(ends[1]);
    char byte = 0;
    EXPECT_EQ(read(ends[0], &byte, 1), 1) << "the child has come so far";
    kill(child, signal);
    int status = 0;
    waitpid(child, &status, 0);
    close(ends[0]);
    return status;
}

void tell(int ready) {
    if (write(ready, "!", 1) != 1) _exit(98);
}

[[noreturn]] void rest() {
    for (;;) pause();
}

TEST(Removal, AFolderGoesWithTheProcessThatASignalEnds) {
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) {
        const TemporaryFolder folder;
        const int status = endedBy(signal, [&](int ready) {
            setenv("TMPDIR", folder.path().c_str(), 1);
            const ScratchFolder scratch("plot"), another("study");
            fs::create_directories(scratch.path() / "a/b/c");
            writeFileAtomically(scratch.path() / "a/b/c/file", "text");
            for (int i = 0; i < 300; ++i) writeFileAtomically(scratch.path() / std::to_string(i), "more than one look");
            fs::create_symlink("/", scratch.path() / "not followed");
            tell(ready);
            rest();
        });
        EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << "ended as it would have been: " << status;
        EXPECT_EQ(folder.entries(), 0);
    }
}

// Whenever the signal comes: the child does nothing but write.
TEST(Removal, APartGoesWithTheProcessThatWritesIt) {
    for (int i = 0; i < 10; ++i) {
        const TemporaryFolder folder;
        const int status = endedBy(i % 2 == 0 ? SIGTERM : SIGINT, [&](int ready) {
            const std::string large(std::size_t{16} << 20U, 'x');
            writeFileAtomically(folder / "file", large);
            tell(ready);
            for (;;) writeFileAtomically(folder / "file", large);
        });
        EXPECT_TRUE(WIFSIGNALED(status)) << status;
        EXPECT_EQ(folder.list(), std::vector<std::string>{"file"});
        EXPECT_EQ(fs::file_size(folder / "file"), std::size_t{16} << 20U);
    }
}

// A program that runs under nohup, or that sees to a signal itself, goes on as before.
TEST(Removal, ASignalThatIsSeenToIsLeftAlone) {
    const TemporaryFolder folder;
    const int status = endedBy(SIGHUP, [&](int ready) {
        setenv("TMPDIR", folder.path().c_str(), 1);
        std::signal(SIGHUP, SIG_IGN);
        std::signal(SIGTERM, [](int) { _exit(7); });
        const ScratchFolder scratch("plot");
        tell(ready);
        usleep(1000);
        kill(getpid(), SIGHUP);
        if (!fs::exists(scratch.path())) _exit(1);
        kill(getpid(), SIGTERM);
        rest();
    });
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 7) << status;
    EXPECT_EQ(folder.entries(), 1);
}

// What is removed in the ordinary way is forgotten, and the place for its name used again.
TEST(Removal, PlacesAreUsedAgain) {
    const TemporaryFolder folder;
    const int status = endedBy(SIGTERM, [&](int ready) {
        setenv("TMPDIR", folder.path().c_str(), 1);
        for (int i = 0; i < 100; ++i) const ScratchFolder passing("passing");
        const ScratchFolder last("last");
        tell(ready);
        rest();
    });
    EXPECT_TRUE(WIFSIGNALED(status));
    EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace mv

// A program that is told to end leaves nothing behind.
#include "mv/image/removal.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/prctl.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstddef>
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
    for (const int signal : {SIGTERM, SIGINT, SIGHUP, SIGQUIT, SIGALRM, SIGUSR1, SIGUSR2, SIGPIPE, SIGXCPU}) {
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

// As a file system has it that knows no files without a name.
void refuseUnnamedFiles() {
    std::array filter{
        sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, nr)),
        sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, __NR_openat, 0, 3),
        sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, offsetof(seccomp_data, args[2])),
        sock_filter BPF_JUMP(BPF_JMP | BPF_JSET | BPF_K, O_TMPFILE & ~O_DIRECTORY, 0, 1),
        sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ERRNO | EOPNOTSUPP),
        sock_filter BPF_STMT(BPF_RET | BPF_K, SECCOMP_RET_ALLOW),
    };
    const sock_fprog program{static_cast<unsigned short>(filter.size()), filter.data()};
    if (prctl(PR_SET_NO_NEW_PRIVS, 1, 0, 0, 0) != 0 || prctl(PR_SET_SECCOMP, SECCOMP_MODE_FILTER, &program) != 0) {
        _exit(97);
    }
}

// Whenever the signal comes: the child does nothing but write, over a file and to new ones.
TEST(Removal, APartGoesWithTheProcessThatWritesIt) {
    const std::array signals{SIGTERM, SIGINT, SIGQUIT, SIGUSR1, SIGALRM, SIGXCPU, SIGHUP, SIGKILL};
    for (const bool named : {false, true}) {
        for (const int signal : signals) {
            if (named && signal == SIGKILL) continue;  // that nobody hears
            const TemporaryFolder folder;
            constexpr std::size_t size = std::size_t{16} << 20U;
            const int status = endedBy(signal, [&](int ready) {
                if (named) refuseUnnamedFiles();
                const std::string large(size, 'x');
                writeFileAtomically(folder / "file", large);
                tell(ready);
                for (int i = 0;; ++i) {
                    writeFileAtomically(folder / "file", large);
                    fs::remove(folder / "file");
                    writeFileAtomically(folder / "file", large);
                }
            });
            EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status << " by " << signal;
            for (const std::string& name : folder.list()) {
                // KILL may come between the two calls by which a whole file takes another one's place.
                EXPECT_TRUE(signal == SIGKILL || name == "file") << name << ", named: " << named << ", by " << signal;
                EXPECT_EQ(fs::file_size(folder / name), size) << "never half of it";
            }
        }
    }
}

// Without them all goes as with them.
TEST(Removal, FilesHaveNamesWhereTheSystemWantsIt) {
    const TemporaryFolder folder;
    const int status = endedBy(SIGTERM, [&](int ready) {
        refuseUnnamedFiles();
        writeFileAtomically(folder / "file", "old");
        fs::permissions(folder / "file", static_cast<fs::perms>(0640));
        writeFileAtomically(folder / "file", "new");
        if (open(folder.path().c_str(), O_WRONLY | O_TMPFILE, 0666) >= 0) _exit(96);  // NOLINT: it fails
        tell(ready);
        rest();
    });
    EXPECT_TRUE(WIFSIGNALED(status)) << status;
    EXPECT_EQ(folder.list(), std::vector<std::string>{"file"});
    EXPECT_EQ(readTextFile(folder / "file", 100), "new");
    EXPECT_EQ(fs::status(folder / "file").permissions(), static_cast<fs::perms>(0640));
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

// A file that is removed in the ordinary way is forgotten, and the place for its name used again.
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

#include "mv/image/removal.h"

#include <dirent.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdlib>
#include <cstring>
#include <string>

namespace mv {
namespace {

// All that end a process and that somebody may send, or a limit; those of a fault of the program itself are left to it.
constexpr std::array signals{SIGTERM, SIGINT,    SIGHUP,  SIGQUIT, SIGALRM, SIGUSR1, SIGUSR2,
                             SIGPIPE, SIGVTALRM, SIGPROF, SIGXCPU, SIGXFSZ, SIGIO,   SIGPWR};

// A place for one path. The handler reads what is in it, which may not allocate, lock or throw: so it is here from the
// start, and `noted` is set when the path is whole.
struct Slot {
    std::atomic<bool> taken{false}, noted{false};
    std::array<char, PATH_MAX> path{};
};
std::array<Slot, 24> slots;
// The process whose files they are: a forked one has the handler, too, until it becomes another program.
std::atomic<pid_t> owner{0};

// One entry as the system writes it; readdir() allocates, this does not.
struct RawEntry {
    ino64_t inode;
    off64_t next;
    unsigned short length;
    unsigned char type;
    char name[1];
};

constexpr int deepest = 8;  // of our temporary folders none is

// Removes `name` in the open folder, whatever it is. Calls only what a signal handler may.
void removeAt(int folder, const char* name, int depth) {
    if (::unlinkat(folder, name, 0) == 0 || errno != EISDIR || depth > deepest) return;
    // A program that is ending, too, may put something in meanwhile: then once more.
    for (int attempt = 0; attempt < 100; ++attempt) {
        const int inner = ::openat(folder, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
        if (inner < 0) return;
        alignas(RawEntry) std::array<char, 4096> buffer;
        for (;;) {
            const long got = ::syscall(SYS_getdents64, inner, buffer.data(), buffer.size());
            if (got <= 0) break;
            for (long at = 0; at < got;) {
                const auto* entry = reinterpret_cast<const RawEntry*>(buffer.data() + at);
                const char* inside = buffer.data() + at + offsetof(RawEntry, name);
                if (std::strcmp(inside, ".") != 0 && std::strcmp(inside, "..") != 0) removeAt(inner, inside, depth + 1);
                at += entry->length;
            }
        }
        ::close(inner);
        if (::unlinkat(folder, name, AT_REMOVEDIR) == 0 || errno != ENOTEMPTY) return;
    }
}

void removeNoted() {
    if (::getpid() != owner.load()) return;
    for (const Slot& slot : slots) {
        if (slot.noted.load(std::memory_order_acquire)) removeAt(AT_FDCWD, slot.path.data(), 0);
    }
}

void removeAndEnd(int signal) {
    const int before = errno;
    removeNoted();
    // Blocked until this returns; then it ends the process as it would have done.
    ::signal(signal, SIG_DFL);
    ::raise(signal);
    errno = before;
}

void install() {
    for (Slot& slot : slots) slot.noted = false;  // of the process that this one was forked from
    owner = ::getpid();
    // A library may end the program, as Xlib does when the display has gone.
    static const int registered = std::atexit(removeNoted);
    (void)registered;
    for (const int signal : signals) {
        struct sigaction now {};
        if (::sigaction(signal, nullptr, &now) != 0 || now.sa_handler != SIG_DFL) continue;
        struct sigaction ours {};
        ours.sa_handler = removeAndEnd;
        for (const int other : signals) ::sigaddset(&ours.sa_mask, other);
        ::sigaction(signal, &ours, nullptr);
    }
}

}  // namespace

RemovedOnSignal::RemovedOnSignal(const std::filesystem::path& path) {
    if (owner.load() != ::getpid()) install();
    std::error_code ignored;  // the present folder is gone: then the path as it is
    std::string text = std::filesystem::absolute(path, ignored).string();
    if (ignored) text = path.string();
    for (std::size_t i = 0; i < slots.size(); ++i) {
        if (text.size() >= slots[i].path.size()) return;
        if (slots[i].taken.exchange(true)) continue;
        std::memcpy(slots[i].path.data(), text.c_str(), text.size() + 1);
        slots[i].noted.store(true, std::memory_order_release);
        slot_ = static_cast<int>(i);
        return;
    }
}

RemovedOnSignal::~RemovedOnSignal() {
    if (slot_ < 0) return;
    Slot& slot = slots[static_cast<std::size_t>(slot_)];
    slot.noted = false;
    slot.taken = false;
}

SignalsHeld::SignalsHeld() {
    sigset_t all;
    ::sigfillset(&all);
    ::pthread_sigmask(SIG_BLOCK, &all, &before_);
}

SignalsHeld::~SignalsHeld() { ::pthread_sigmask(SIG_SETMASK, &before_, nullptr); }

}  // namespace mv

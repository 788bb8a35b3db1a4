#include "mv/image/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>

#include "mv/error.h"

namespace mv {
namespace {

namespace fs = std::filesystem;

// The system's words for an error number; unlike strerror it is safe to call from several threads.
std::string reasonText(int errorNumber) { return std::generic_category().message(errorNumber); }

[[noreturn]] void refuseWrite(const fs::path& path, int errorNumber) {
    throw Error(path.string(), "could not be written", reasonText(errorNumber));
}

[[noreturn]] void refuseRead(const fs::path& path, int errorNumber) {
    throw Error(path.string(), "must be a file that exists and may be read", reasonText(errorNumber));
}

// An open file descriptor, closed when it goes out of scope.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(Descriptor&& other) noexcept : number_(std::exchange(other.number_, -1)) {}
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;
    Descriptor& operator=(Descriptor&&) = delete;

    [[nodiscard]] int number() const { return number_; }

    // Closes now, since an error of closing must be heard; a destructor could not tell. Returns 0 or the error number.
    int close() { return ::close(std::exchange(number_, -1)) == 0 ? 0 : errno; }

  private:
    int number_;
};

// Writes all bytes where the descriptor stands. Returns 0 or the error number.
int writeAll(const Descriptor& file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        // write() may take less than it is given, and a signal may interrupt it before it took anything.
        const ssize_t written = ::write(file.number(), bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return errno;
        if (written == 0) return EIO;
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    return 0;
}

void writeAndClose(const fs::path& path, Descriptor file, std::span<const std::byte> bytes) {
    if (const int error = writeAll(file, bytes); error != 0) refuseWrite(path, error);
    if (const int error = file.close(); error != 0) refuseWrite(path, error);
}

// Whether it is open for `mode`, and belongs to whoever started this program: what the program opens itself, and what libraries
// do, is closed when another program is started.
bool isInherited(int number, int mode) {
    const int flags = ::fcntl(number, F_GETFD);
    if (flags < 0 || (flags & FD_CLOEXEC) != 0) return false;
    const int present = ::fcntl(number, F_GETFL) & O_ACCMODE;
    return present == mode || present == O_RDWR;
}

// The stream that the program was started with and that leads to this very file, if any: /dev/stdout, /dev/fd/3, the name of a
// file to which a shell has redirected. The first ones are the usual ones.
std::optional<int> streamOf(const struct stat& file, int mode) {
    constexpr int mostStreams = 256;
    for (int number = mode == O_WRONLY ? STDOUT_FILENO : STDIN_FILENO; number < mostStreams; ++number) {
        struct stat status {};
        if (!isInherited(number, mode) || ::fstat(number, &status) != 0) continue;
        if (status.st_dev == file.st_dev && status.st_ino == file.st_ino) return number;
    }
    return std::nullopt;
}

// Removes the file when it goes out of scope, unless release() said that it is no longer ours to remove.
class NamedTemporary {
  public:
    explicit NamedTemporary(fs::path path) : path_(std::move(path)), removal_(path_) {}
    ~NamedTemporary() {
        if (!path_.empty()) ::unlink(path_.c_str());
    }
    NamedTemporary(const NamedTemporary&) = delete;
    NamedTemporary& operator=(const NamedTemporary&) = delete;

    [[nodiscard]] const fs::path& path() const { return path_; }
    void release() { path_.clear(); }

  private:
    fs::path path_;
    RemovedOnSignal removal_;
};

// A name in the folder that no other process takes. The name does not grow with the target's, which may be as long as
// names can be.
fs::path nextName(const fs::path& folder) {
    static std::atomic<unsigned> counter{0};
    return folder / (".mvgl-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".part");
}

// The file that is written, and how it takes the place of the one at `target`. Each step returns 0 or the error number.
struct Replacement {
    const fs::path& target;
    std::span<const std::byte> bytes;
    const struct stat* before;  // of the file that is there; nullptr: none is

    // The new file's owner and mode, before anybody sees it. The owner first: a change of owner drops bits of the mode.
    [[nodiscard]] int dress(const Descriptor& file) const {
        if (!before) return 0;
        struct stat now {};
        if (::fstat(file.number(), &now) != 0) return errno;
        const bool same = now.st_uid == before->st_uid && now.st_gid == before->st_gid;
        if (!same && ::fchown(file.number(), before->st_uid, before->st_gid) != 0) return errno;
        return ::fchmod(file.number(), before->st_mode & 07777U) == 0 ? 0 : errno;
    }
    [[nodiscard]] int fill(Descriptor& file) const {
        if (const int error = dress(file); error != 0) return error;
        return writeAll(file, bytes);
    }
};

// The file gets its content before it has any name, so that nothing can be left behind when the process ends. EOPNOTSUPP: a file
// system that has no such files, or no /proc to name it by.
int replaceByUnnamed(const Replacement& what, const fs::path& folder) {
    Descriptor file(::open(folder.c_str(), O_WRONLY | O_TMPFILE | O_CLOEXEC, 0666));
    // EISDIR is an old system's word for it, ENOENT that of some network file systems (a folder that is missing fails by name, too).
    if (file.number() < 0) return errno == EISDIR || errno == ENOENT || errno == EINVAL ? EOPNOTSUPP : errno;
    if (const int error = what.fill(file); error != 0) return error;
    const std::string unnamed = "/proc/self/fd/" + std::to_string(file.number());
    const auto link = [&](const fs::path& path) {
        return ::linkat(AT_FDCWD, unnamed.c_str(), AT_FDCWD, path.c_str(), AT_SYMLINK_FOLLOW) == 0 ? 0 : errno;
    };
    // A full disk may only be noticed at the close: so a second descriptor is closed, while this one keeps the file.
    const int closed = ::fcntl(file.number(), F_DUPFD_CLOEXEC, 0);
    if (closed < 0 || ::close(closed) != 0) return errno;
    if (!what.before) {
        const int error = link(what.target);
        if (error != EEXIST)
            return error == ENOENT ? EOPNOTSUPP : error;  // EEXIST: somebody else has made one meanwhile
    }
    // The file has a name for the moment between two calls, in which only KILL and a power cut are heard.
    const SignalsHeld held;
    fs::path name;
    int error = EEXIST;
    while (error == EEXIST) {
        name = nextName(folder);
        error = link(name);
    }
    if (error != 0) return error == ENOENT ? EOPNOTSUPP : error;
    if (::rename(name.c_str(), what.target.c_str()) == 0) return 0;
    error = errno;
    ::unlink(name.c_str());
    return error;
}

int replaceByNamed(const Replacement& what, const fs::path& folder) {
    std::optional<SignalsHeld> held(std::in_place);
    fs::path name;
    int number = -1;
    do {
        name = nextName(folder);
        number = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        // EEXIST: left by a killed process that had our number; take the next name.
    } while (number < 0 && errno == EEXIST);
    if (number < 0) return errno;
    Descriptor file(number);
    NamedTemporary temporary(std::move(name));
    held.reset();
    if (const int error = what.fill(file); error != 0) return error;
    if (const int error = file.close(); error != 0) return error;
    if (::rename(temporary.path().c_str(), what.target.c_str()) != 0) return errno;
    temporary.release();
    return 0;
}

int replace(const Replacement& what) {
    const fs::path folder = what.target.has_parent_path() ? what.target.parent_path() : fs::path(".");
    const int error = replaceByUnnamed(what, folder);
    return error == EOPNOTSUPP ? replaceByNamed(what, folder) : error;
}

// Whether the folder, not the file, is what forbids a replacement: no right to write in it, or to give the new file the owner of
// the old one, or another's file in a folder such as /tmp, or one that something is mounted on.
bool isForbiddenByFolder(int error) {
    return error == EACCES || error == EPERM || error == EBUSY || error == EROFS || error == EXDEV ||
           error == ENAMETOOLONG;
}

// Over what is there, in the file itself: where it fails, the old content is lost. So room is asked for before.
void writeInPlace(const fs::path& path, Descriptor file, std::span<const std::byte> bytes, const std::string& why) {
    const auto size = static_cast<off_t>(bytes.size());
    if (size > 0 && ::fallocate(file.number(), FALLOC_FL_KEEP_SIZE, 0, size) != 0 && errno != EOPNOTSUPP &&
        errno != ENOSYS && errno != EINTR) {
        refuseWrite(path, errno);
    }
    if (const int error = writeAll(file, bytes); error != 0) refuseWrite(path, error);
    if (::ftruncate(file.number(), size) != 0) refuseWrite(path, errno);
    if (const int error = file.close(); error != 0) refuseWrite(path, error);
    std::fprintf(stderr, "note: %s: written in place, not replaced by a new file: %s\n",
                 printable(path.string()).c_str(), why.c_str());
}

// The end of a link, by way of others; the last need not be there. As long as the system itself would follow them.
fs::path withoutLinks(fs::path path) {
    for (int i = 0; i < 40; ++i) {
        std::error_code error;
        const fs::path target = fs::read_symlink(path, error);
        if (error) return path;  // no link
        path = target.is_absolute() ? target : path.parent_path() / target;
    }
    return path;
}

}  // namespace

void writeFileAtomically(const fs::path& path, std::span<const std::byte> bytes) {
    struct stat status {};
    const bool exists = ::stat(path.c_str(), &status) == 0;
    if (!exists && errno != ENOENT) refuseWrite(path, errno);  // links in a circle, say
    if (!exists) {
        const fs::path target = withoutLinks(path);
        const fs::path shown = target == path ? path : fs::path(path.string() + " -> " + target.string());
        if (const int error = replace({target, bytes, nullptr}); error != 0) refuseWrite(shown, error);
        return;
    }
    if (S_ISDIR(status.st_mode)) refuseWrite(path, EISDIR);
    // A stream goes on where it stands, and what is no file is written to as it is.
    const std::optional<int> stream = streamOf(status, O_WRONLY);
    // For a file this asks whether it may be written to, which a rename does not: who protected it, or runs it, meant it.
    Descriptor file(stream ? ::fcntl(*stream, F_DUPFD_CLOEXEC, 0) : ::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (file.number() < 0) refuseWrite(path, errno);
    if (stream || !S_ISREG(status.st_mode)) return writeAndClose(path, std::move(file), bytes);

    if (status.st_nlink > 1) return writeInPlace(path, std::move(file), bytes, "it has another name (a hard link)");
    const fs::path target = withoutLinks(path);
    struct stat found {};
    const bool same =
        ::stat(target.c_str(), &found) == 0 && found.st_dev == status.st_dev && found.st_ino == status.st_ino;
    if (!same) return writeInPlace(path, std::move(file), bytes, "no name of it is known");
    const int error = replace({target, bytes, &status});
    if (error == 0) return;
    if (!isForbiddenByFolder(error)) refuseWrite(path, error);
    writeInPlace(path, std::move(file), bytes, reasonText(error) + " for a new file beside it");
}

void writeFileAtomically(const fs::path& path, std::string_view text) {
    writeFileAtomically(path, std::as_bytes(std::span(text.data(), text.size())));
}

std::string printable(std::string_view text) {
    std::string shown;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto code = static_cast<unsigned char>(text[i]);
        // Unicode has a second set of control characters, U+0080 to U+009F.
        const bool second =
            code == 0xC2 && i + 1 < text.size() && (static_cast<unsigned char>(text[i + 1]) & 0xE0U) == 0x80;
        if (text[i] == '\n') {
            shown += "\\n";
        } else if (text[i] == '\t') {
            shown += "\\t";
        } else if (code < 0x20 || code == 0x7F || second) {
            constexpr std::string_view digits = "0123456789abcdef";
            shown.append("\\x").append(1, digits[code >> 4U]).append(1, digits[code & 15U]);
            if (second) {
                const auto other = static_cast<unsigned char>(text[++i]);
                shown.append("\\x").append(1, digits[other >> 4U]).append(1, digits[other & 15U]);
            }
        } else {
            shown += text[i];
        }
    }
    return shown;
}

void requireWritable(const fs::path& path) {
    struct stat status {};
    if (::stat(path.c_str(), &status) == 0) {
        if (S_ISDIR(status.st_mode)) refuseWrite(path, EISDIR);
        if (!S_ISREG(status.st_mode)) return;
        if (::access(path.c_str(), W_OK) != 0) refuseWrite(path, errno);
    } else {
        const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
        if (errno != ENOENT || ::access(folder.c_str(), W_OK | X_OK) != 0) refuseWrite(path, errno);
    }
}

std::vector<std::byte> readFile(const fs::path& path, std::size_t maximumBytes) {
    // Not to wait for somebody who writes into a pipe of that name, nor for a terminal.
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.number() < 0) refuseRead(path, errno);
    struct stat status {};
    if (::fstat(file.number(), &status) != 0) refuseRead(path, errno);
    if (!S_ISREG(status.st_mode) && !S_ISDIR(status.st_mode)) {
        // But a stream that this program was given comes to an end.
        if (!streamOf(status, O_RDONLY)) {
            throw Error(path.string(), "must be a file that exists and may be read", "it is a pipe or a device");
        }
        ::fcntl(file.number(), F_SETFL, O_RDONLY);
    }

    // Read to the end instead of asking for the size: pipes have none, and the size may change meanwhile.
    constexpr std::size_t step = std::size_t{1} << 16U;
    std::vector<std::byte> bytes;
    std::size_t length = 0;
    for (;;) {
        if (bytes.size() - length < step) bytes.resize(std::max(2 * bytes.size(), 2 * step));
        const ssize_t got = ::read(file.number(), bytes.data() + length, bytes.size() - length);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) refuseRead(path, errno);
        if (got == 0) break;
        length += static_cast<std::size_t>(got);
        if (length > maximumBytes)
            throw Error(path.string(), "must hold at most " + std::to_string(maximumBytes) + " bytes", "it holds more");
    }
    bytes.resize(length);
    return bytes;
}

std::string readTextFile(const fs::path& path, std::size_t maximumBytes) {
    const std::vector<std::byte> bytes = readFile(path, maximumBytes);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

bool isInPath(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        if (::access((folder + "/" + program).c_str(), X_OK) == 0) return true;
    }
    return false;
}

ScratchFolder::ScratchFolder(std::string_view name) {
    constexpr std::string_view rule = "needs a temporary folder that can be written; TMPDIR names one";
    std::error_code missing;
    const fs::path temporary = fs::temp_directory_path(missing);
    if (missing) throw Error(name, rule, missing.message());
    std::string pattern = (temporary / "mvgl-").string().append(name).append("-XXXXXX");
    const SignalsHeld held;
    if (!::mkdtemp(pattern.data())) throw Error(name, rule, pattern + ": " + reasonText(errno));
    path_ = pattern;
    removal_.emplace(path_);
}

ScratchFolder::~ScratchFolder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
}

}  // namespace mv

#include "mv/image/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <optional>
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

// Removes the file when it goes out of scope, unless release() said that it is no longer ours to remove.
class TemporaryFile {
  public:
    explicit TemporaryFile(fs::path path) : path_(std::move(path)), removal_(path_) {}
    ~TemporaryFile() {
        if (!path_.empty()) ::unlink(path_.c_str());
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    [[nodiscard]] const fs::path& path() const { return path_; }
    void release() { path_.clear(); }

  private:
    fs::path path_;
    RemovedOnSignal removal_;
};

void writeAndClose(const fs::path& path, Descriptor file, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        // write() may take less than it is given, and a signal may interrupt it before it took anything.
        const ssize_t written = ::write(file.number(), bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) refuseWrite(path, errno);
        if (written == 0) refuseWrite(path, EIO);
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    if (const int error = file.close(); error != 0) refuseWrite(path, error);
}

// This process's own output stream, if the path names it.
std::optional<int> standardStream(const fs::path& path) {
    if (path == "/dev/stdout") return STDOUT_FILENO;
    if (path == "/dev/stderr") return STDERR_FILENO;
    return std::nullopt;
}

void writeToDevice(const fs::path& path, std::span<const std::byte> bytes) {
    const std::optional<int> stream = standardStream(path);
    Descriptor file(stream ? ::fcntl(*stream, F_DUPFD_CLOEXEC, 0) : ::open(path.c_str(), O_WRONLY | O_CLOEXEC));
    if (file.number() < 0) refuseWrite(path, errno);
    writeAndClose(path, std::move(file), bytes);
}

// A new, empty file in the folder. Its name does not grow with the target's, which may be as long as names can be.
std::pair<Descriptor, fs::path> createTemporary(const fs::path& target, const fs::path& folder) {
    static std::atomic<unsigned> counter{0};
    for (;;) {
        fs::path path = folder / (".mvgl-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".part");
        const int number = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (number >= 0) return {Descriptor(number), std::move(path)};
        // EEXIST: left by a killed process that had our number; take the next name.
        if (errno != EEXIST) refuseWrite(target, errno);
    }
}

// Where a link leads, by way of others; the last need not be there. As long as the system itself would follow them.
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
    if (exists && S_ISDIR(status.st_mode)) refuseWrite(path, EISDIR);
    if (standardStream(path) || (exists && !S_ISREG(status.st_mode))) return writeToDevice(path, bytes);

    fs::path target = withoutLinks(path);
    if (exists) {
        // A rename asks only for the folder's permission; who protected the file itself meant it.
        if (::access(path.c_str(), W_OK) != 0) refuseWrite(path, errno);
        std::error_code error;
        target = fs::canonical(path, error);
        if (error) refuseWrite(path, error.value());
    }
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");

    std::optional<SignalsHeld> held(std::in_place);
    const fs::path shown = exists || target == path ? path : fs::path(path.string() + " -> " + target.string());
    auto [file, temporaryPath] = createTemporary(shown, folder);
    TemporaryFile temporary(std::move(temporaryPath));
    held.reset();
    if (exists && ::fchmod(file.number(), status.st_mode & 07777U) != 0) refuseWrite(path, errno);
    writeAndClose(path, std::move(file), bytes);
    if (::rename(temporary.path().c_str(), target.c_str()) != 0) refuseWrite(path, errno);
    temporary.release();
}

void writeFileAtomically(const fs::path& path, std::string_view text) {
    writeFileAtomically(path, std::as_bytes(std::span(text.data(), text.size())));
}

std::vector<std::byte> readFile(const fs::path& path, std::size_t maximumBytes) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.number() < 0) refuseRead(path, errno);

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

// Whole files in and out, with every step checked: a full disk must be an error, not a broken picture.
#pragma once
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mv/image/removal.h"

namespace mv {

// Writes the bytes as the whole content of the file at `path`, replacing what was there; the folder must exist.
// - The bytes go to a temporary file in the same folder, which then takes the name `path` in one step. Whoever looks
//   at `path` sees the old file or the new one, never half of it, and after a failure the old one is still there.
// - A link is followed, one to a file that is not there yet, too. Of an existing file the permissions are kept, and a
//   write-protected one is refused.
// - What is no file (/dev/full, a pipe, a terminal) is written to directly, as a file must not take its name.
//   "/dev/stdout" and "/dev/stderr" are this process's own streams, not opened anew, so `--shot /dev/stdout >> file`
//   appends; flush std::cout first if something was printed to it.
// Error "path: could not be written, <the system's reason>" on any failure, that of closing the file among them
// (a full disk may only be noticed then).
// The trap: a process that is ended by KILL, not by TERM, INT or HUP, while it writes leaves its ".mvgl-*.part" behind, but
// `path` is whole even then.
// Not fsync'ed: safe against a failing program, not against a power cut.
void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes);
void writeFileAtomically(const std::filesystem::path& path, std::string_view text);

// The whole content of the file at `path`.
// Error if it does not exist, cannot be read, is a folder, or holds more than maximumBytes; so /dev/zero ends, too.
[[nodiscard]] std::vector<std::byte> readFile(const std::filesystem::path& path, std::size_t maximumBytes);
// The same as text, byte by byte.
[[nodiscard]] std::string readTextFile(const std::filesystem::path& path, std::size_t maximumBytes);

// An empty folder of its own in the system's temporary one, which goes with all that is in it when its owner goes, or TERM,
// INT or HUP ends the process.
class ScratchFolder {
  public:
    // `name` is in the folder's, for people. Error: the temporary folder cannot be written to.
    explicit ScratchFolder(std::string_view name);
    ~ScratchFolder();
    ScratchFolder(const ScratchFolder&) = delete;
    ScratchFolder& operator=(const ScratchFolder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  private:
    std::filesystem::path path_;
    std::optional<RemovedOnSignal> removal_;
};

}  // namespace mv

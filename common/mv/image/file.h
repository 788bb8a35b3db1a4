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
// - The bytes go to a new file in the same folder, which then takes the name `path` in one step. Whoever looks at `path` sees the
//   old file or the new one, never half of it, and after a failure the old one is still there. The new file has no name until
//   it is whole (O_TMPFILE), so that nothing is left behind whatever ends the process; where the file system has no such files,
//   it is called ".mvgl-*.part" meanwhile, and removed as mv/image/removal.h says.
// - A link is followed, one to a file that is not there yet, too. The owner and mode of an existing file are kept, and one that is
//   write-protected, or a program that runs, is refused.
// - If a new file cannot take the place of the old one, the old one is written over: it has a second name (a hard link), or
//   its folder may not be written to, or its owner could not be kept. A note on standard error says so, since whoever looks
//   meanwhile sees a part; a lack of room is noticed before.
// - A stream that this program was started with is written to where it stands, by whatever name: /dev/stdout, /dev/fd/3, the
//   file that a shell has redirected it to. Flush std::cout first if something was printed to it. And what is no file
//   (/dev/full, a pipe, a terminal) is written to directly, as a file must not take its name.
// Error "path: could not be written, <the system's reason>" on any failure, that of closing the file among them
// (a full disk may only be noticed then). Trap: beyond its limit of file sizes the system ends a process by SIGXFSZ; where that is
// ignored, as runMain() does, it is an Error as well.
// Not fsync'ed: safe against a failing program, not against a power cut.
void writeFileAtomically(const std::filesystem::path& path, std::span<const std::byte> bytes);
void writeFileAtomically(const std::filesystem::path& path, std::string_view text);

// Error, as writing would say it, where it can be told before: the folder or the file may not be written to. For who has long to
// compute before there is anything to write.
void requireWritable(const std::filesystem::path& path);

// The text for a line of its own: control characters, which names may have, as in C, "two\\nlines".
[[nodiscard]] std::string printable(std::string_view text);

// The whole content of the file at `path`.
// Error if it does not exist, cannot be read, is a folder, a device or a pipe, for whose writer one would wait, or holds more than
// maximumBytes. A stream that this program was started with (/dev/stdin, a shell's <(...)) is read to its end.
[[nodiscard]] std::vector<std::byte> readFile(const std::filesystem::path& path, std::size_t maximumBytes);
// The same as text, byte by byte.
[[nodiscard]] std::string readTextFile(const std::filesystem::path& path, std::size_t maximumBytes);

// Whether a program of that name is in one of the folders of PATH.
[[nodiscard]] bool isInPath(const std::string& program);

// An empty folder of its own in the system's temporary one, which goes with all that is in it when its owner goes, or a
// signal of mv/image/removal.h ends the process.
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

// X40: output to a full disk, a missing folder and the like is an Error, and nothing half-written is left behind.
#include "mv/image/file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <string>

#include "image/messages.h"
#include "image/nobody.h"
#include "support/temporary_folder.h"

namespace mv {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t plenty = 1U << 20U;

std::string textOf(const fs::path& path) {
    const std::vector<std::byte> bytes = readFile(path, plenty);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// In a child process: does writing fail with an Error that names the reason? Ends the child with 0 if so.
[[noreturn]] void exitByRefusal(const fs::path& path, std::string_view text, const std::string& reason) {
    try {
        writeFileAtomically(path, text);
    } catch (const Error& error) {
        _exit(contains(error.what(), reason) ? 0 : 2);
    }
    _exit(1);
}

TEST(WriteFile, WritesAndReplaces) {
    const TemporaryFolder folder;
    for (const std::string& text :
         {std::string("first"), std::string(), std::string(300000, 'x'), std::string("a\0b", 3)}) {
        writeFileAtomically(folder / "file", text);
        EXPECT_EQ(textOf(folder / "file"), text);
        EXPECT_EQ(folder.entries(), 1);
    }
}

TEST(WriteFile, TakesAPathRelativeToTheCurrentFolder) {
    const TemporaryFolder folder;
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());
    writeFileAtomically("file", "text");
    fs::current_path(before);
    EXPECT_EQ(textOf(folder / "file"), "text");
    EXPECT_EQ(folder.entries(), 1);
}

TEST(WriteFile, NewFilesFollowTheUmask) {
    const TemporaryFolder folder;
    const mode_t before = umask(027);
    writeFileAtomically(folder / "file", "text");
    umask(before);
    EXPECT_EQ(fs::status(folder / "file").permissions(), static_cast<fs::perms>(0640));
}

TEST(WriteFile, KeepsPermissionsOfTheReplaced) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "file", "old");
    fs::permissions(folder / "file", static_cast<fs::perms>(0600));
    writeFileAtomically(folder / "file", "new");
    EXPECT_EQ(fs::status(folder / "file").permissions(), static_cast<fs::perms>(0600));
    EXPECT_EQ(textOf(folder / "file"), "new");
}

TEST(WriteFile, FollowsALinkAndKeepsIt) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "elsewhere");
    writeFileAtomically(folder / "elsewhere/file", "old");
    fs::create_symlink("elsewhere/file", folder / "link");
    writeFileAtomically(folder / "link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(textOf(folder / "elsewhere/file"), "new");
}

TEST(WriteFile, FollowsALinkToAFileThatIsNotThereYet) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "elsewhere");
    fs::create_symlink("elsewhere/file", folder / "link");
    fs::create_symlink(folder / "link", folder / "link to the link");
    writeFileAtomically(folder / "link to the link", "new");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_TRUE(fs::is_symlink(folder / "link to the link"));
    EXPECT_EQ(textOf(folder / "elsewhere/file"), "new");
    EXPECT_EQ(folder.entries(), 3);
    // The refusal says where the link leads; it may lead nowhere, or to itself.
    fs::create_symlink("missing/file", folder / "nowhere");
    EXPECT_TRUE(contains(messageOf([&] { writeFileAtomically(folder / "nowhere", "text"); }),
                         "nowhere -> " + (folder / "missing/file").string() + ": could not be written, No such file"));
    fs::create_symlink("circle", folder / "circle");
    EXPECT_TRUE(contains(messageOf([&] { writeFileAtomically(folder / "circle", "text"); }), "symbolic links"));
    EXPECT_EQ(folder.entries(), 5);
}

TEST(WriteFile, TakesTheLongestName) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / std::string(255, 'n'), "text");
    EXPECT_EQ(textOf(folder / std::string(255, 'n')), "text");
    EXPECT_TRUE(contains(messageOf([&] { writeFileAtomically(folder / std::string(256, 'n'), "text"); }),
                         "could not be written, File name too long"));
    EXPECT_EQ(folder.entries(), 1);
}

TEST(WriteFile, AMissingFolderIsAnError) {
    const TemporaryFolder folder;
    const fs::path path = folder / "missing/file";
    EXPECT_EQ(messageOf([&] { writeFileAtomically(path, "text"); }),
              path.string() + ": could not be written, No such file or directory");
    EXPECT_EQ(folder.entries(), 0);
    EXPECT_THROW(writeFileAtomically("", "text"), Error);
}

TEST(WriteFile, AFolderIsNotReplaced) {
    const TemporaryFolder folder;
    fs::create_directory(folder / "sub");
    EXPECT_TRUE(contains(messageOf([&] { writeFileAtomically(folder / "sub", "text"); }), "Is a directory"));
    EXPECT_THROW(writeFileAtomically(folder / "sub/", "text"), Error);
    EXPECT_TRUE(fs::is_directory(folder / "sub"));
    EXPECT_TRUE(fs::is_empty(folder / "sub"));
    EXPECT_EQ(folder.entries(), 1);
}

TEST(WriteFile, AFileIsNoFolder) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "file", "text");
    EXPECT_TRUE(contains(messageOf([&] { writeFileAtomically(folder / "file/below", "x"); }), "Not a directory"));
    EXPECT_EQ(folder.entries(), 1);
}

TEST(WriteFile, AReadOnlyFolderIsAnError) {
    const TemporaryFolder folder;
    fs::permissions(folder.path(), static_cast<fs::perms>(0555));
    EXPECT_EXIT((becomeNobody(), exitByRefusal(folder / "file", "text", "Permission denied")),
                testing::ExitedWithCode(0), "");
    EXPECT_EQ(folder.entries(), 0);
}

TEST(WriteFile, AWriteProtectedFileIsAnError) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "file", "old");
    fs::permissions(folder / "file", static_cast<fs::perms>(0444));
    fs::permissions(folder.path(), static_cast<fs::perms>(0777));
    EXPECT_EXIT((becomeNobody(), exitByRefusal(folder / "file", "new", "Permission denied")),
                testing::ExitedWithCode(0), "");
    EXPECT_EQ(textOf(folder / "file"), "old");
    EXPECT_EQ(folder.entries(), 1);
}

TEST(WriteFile, ALimitReachedHalfWayLeavesTheOldFile) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "file", "old");
    const auto writeBeyondLimit = [&] {
        // Without this the system kills the process; with it write() fails, as on a full disk.
        std::signal(SIGXFSZ, SIG_IGN);
        const rlimit limit{4096, 4096};
        if (setrlimit(RLIMIT_FSIZE, &limit) != 0) _exit(3);
        exitByRefusal(folder / "file", std::string(10000, 'x'), "File too large");
    };
    EXPECT_EXIT(writeBeyondLimit(), testing::ExitedWithCode(0), "");
    EXPECT_EQ(textOf(folder / "file"), "old");
    EXPECT_EQ(folder.entries(), 1);
}

TEST(WriteFile, AFullDeviceIsAnErrorAndStaysADevice) {
    for (const std::size_t size : {std::size_t{1}, plenty}) {
        EXPECT_EXIT((becomeNobody(), exitByRefusal("/dev/full", std::string(size, 'x'),
                                                   "/dev/full: could not be written, No space left on device")),
                    testing::ExitedWithCode(0), "");
    }
    EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST(WriteFile, ADeviceTakesTheBytes) {
    EXPECT_EXIT((becomeNobody(), writeFileAtomically("/dev/null", "text"), _exit(0)), testing::ExitedWithCode(0), "");
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(WriteFile, ALinkToADeviceIsWrittenThrough) {
    const TemporaryFolder folder;
    fs::permissions(folder.path(), static_cast<fs::perms>(0777));
    fs::create_symlink("/dev/full", folder / "link");
    EXPECT_EXIT((becomeNobody(), exitByRefusal(folder / "link", "x", "No space left on device")),
                testing::ExitedWithCode(0), "");
    EXPECT_TRUE(fs::is_symlink(folder / "link"));
    EXPECT_EQ(folder.entries(), 1);
}

TEST(WriteFile, APipeReceivesTheBytes) {
    const TemporaryFolder folder;
    const fs::path pipe = folder / "pipe";
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    const int reader = open(pipe.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC);
    ASSERT_GE(reader, 0);
    writeFileAtomically(pipe, "through");
    char buffer[16] = {};
    EXPECT_EQ(read(reader, buffer, sizeof buffer), 7);
    EXPECT_STREQ(buffer, "through");
    close(reader);
    EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST(WriteFile, StandardOutputIsAppendedTo) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "log", "before ");
    const auto writeToStandardOutput = [&] {
        const int log = open((folder / "log").c_str(), O_WRONLY | O_APPEND | O_CLOEXEC);
        if (dup2(log, STDOUT_FILENO) < 0) _exit(3);
        becomeNobody();
        writeFileAtomically("/dev/stdout", "one ");
        writeFileAtomically("/dev/stdout", "two");
        _exit(0);
    };
    EXPECT_EXIT(writeToStandardOutput(), testing::ExitedWithCode(0), "");
    EXPECT_EQ(textOf(folder / "log"), "before one two");
    EXPECT_EQ(folder.entries(), 1);
}

// Whatever stream of this process it is, and by whatever name; what was in the file stays.
TEST(WriteFile, AStreamIsKnownByWhatItIs) {
    const TemporaryFolder folder;
    fs::permissions(folder.path(), static_cast<fs::perms>(0777));
    for (const std::string name : {"/dev/fd/1", "/proc/self/fd/1", "/dev/fd/7", "log", "link"}) {
        for (const int flags : {0, O_APPEND}) {
            fs::remove(folder / "log");
            fs::remove(folder / "link");
            fs::create_symlink("log", folder / "link");
            const auto writeToStream = [&] {
                fs::current_path(folder.path());
                const int log = open("log", O_WRONLY | O_CREAT | O_CLOEXEC | flags, 0666);
                if (dup2(log, name == "/dev/fd/7" ? 7 : STDOUT_FILENO) < 0) _exit(3);
                becomeNobody();
                if (write(log, "head ", 5) != 5) _exit(4);
                writeFileAtomically(name, "picture ");
                if (write(log, "tail", 4) != 4) _exit(5);
                _exit(0);
            };
            EXPECT_EXIT(writeToStream(), testing::ExitedWithCode(0), "") << name;
            EXPECT_EQ(textOf(folder / "log"), "head picture tail") << name;
        }
    }
}

// A file that the program itself has opened is no stream of its user's.
TEST(WriteFile, AFileThatIsOpenIsReplaced) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "file", "old");
    const int own = open((folder / "file").c_str(), O_RDWR | O_CLOEXEC);
    const int reading = open((folder / "file").c_str(), O_RDONLY);
    writeFileAtomically(folder / "file", "new");
    char buffer[4] = {};
    EXPECT_EQ(pread(own, buffer, 3, 0), 3);
    EXPECT_STREQ(buffer, "old");
    EXPECT_EQ(textOf(folder / "file"), "new");
    close(own);
    close(reading);
}

TEST(WriteFile, AProgramThatRunsIsRefused) {
    const TemporaryFolder folder;
    EXPECT_TRUE(contains(messageOf([&] { writeFileAtomically("/proc/self/exe", "text"); }), "Text file busy"));
    fs::create_symlink("/proc/self/exe", folder / "link");
    EXPECT_TRUE(contains(messageOf([&] { writeFileAtomically(folder / "link", "text"); }), "Text file busy"));
}

struct stat statusOf(const fs::path& path) {
    struct stat status {};
    EXPECT_EQ(stat(path.c_str(), &status), 0) << path;
    return status;
}

TEST(WriteFile, EachNameOfAFileShowsTheNewContent) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "file", std::string(20000, 'o'));
    fs::create_hard_link(folder / "file", folder / "other");
    testing::internal::CaptureStderr();
    writeFileAtomically(folder / "file", "new");
    EXPECT_EQ(testing::internal::GetCapturedStderr(),
              "note: " + (folder / "file").string() +
                  ": written in place, not replaced by a new file: it has another name (a hard link)\n");
    EXPECT_EQ(textOf(folder / "other"), "new");
    EXPECT_EQ(fs::hard_link_count(folder / "file"), 2U);
    EXPECT_EQ(folder.entries(), 2);
}

// The right to write in a file is enough: the folder may be another's.
TEST(WriteFile, AWritableFileInAFolderThatIsNotIsWritten) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "file", "old and longer");
    fs::permissions(folder / "file", static_cast<fs::perms>(0666));
    fs::permissions(folder.path(), static_cast<fs::perms>(0555));
    const ino_t before = statusOf(folder / "file").st_ino;
    EXPECT_EXIT((becomeNobody(), writeFileAtomically(folder / "file", "new"), _exit(0)), testing::ExitedWithCode(0),
                "note: .*file: written in place, not replaced by a new file: Permission denied for a new file beside");
    EXPECT_EQ(textOf(folder / "file"), "new");
    EXPECT_EQ(statusOf(folder / "file").st_ino, before);
    EXPECT_EQ(folder.entries(), 1);
}

TEST(WriteFile, KeepsTheOwner) {
    if (geteuid() != 0) GTEST_SKIP() << "only the superuser has others' files";
    const TemporaryFolder folder;
    writeFileAtomically(folder / "file", "old");
    ASSERT_EQ(chown((folder / "file").c_str(), 1234, 5678), 0);
    ASSERT_EQ(chmod((folder / "file").c_str(), 0664), 0);
    const ino_t before = statusOf(folder / "file").st_ino;
    writeFileAtomically(folder / "file", "new");
    const struct stat now = statusOf(folder / "file");
    EXPECT_NE(now.st_ino, before) << "replaced";
    EXPECT_EQ(now.st_uid, 1234U);
    EXPECT_EQ(now.st_gid, 5678U);
    EXPECT_EQ(now.st_mode & 07777U, 0664U);
    // Who may write in it and cannot give a file away keeps the owner as well.
    fs::permissions(folder.path(), static_cast<fs::perms>(0777));
    fs::permissions(folder / "file", static_cast<fs::perms>(0666));
    EXPECT_EXIT((becomeNobody(), writeFileAtomically(folder / "file", "newer"), _exit(0)), testing::ExitedWithCode(0),
                "written in place");
    EXPECT_EQ(textOf(folder / "file"), "newer");
    EXPECT_EQ(statusOf(folder / "file").st_uid, 1234U);
    EXPECT_EQ(folder.entries(), 1);
}

// As often as one likes, also where the whole path is longer than the system takes at once.
TEST(WriteFile, AFolderOfFiveThousandLetters) {
    const TemporaryFolder folder;
    const fs::path before = fs::current_path();
    fs::current_path(folder.path());
    const std::string part(250, 'd');
    for (int i = 0; i < 20; ++i) {
        ASSERT_EQ(mkdir(part.c_str(), 0777), 0);
        ASSERT_EQ(chdir(part.c_str()), 0);
    }
    for (const char* text : {"first", "second", "third"}) {
        writeFileAtomically("file", text);
        EXPECT_EQ(textOf("file"), text);
    }
    EXPECT_EQ(std::distance(fs::directory_iterator("."), fs::directory_iterator()), 1);
    // The folders are removed from within: their path is too long for remove_all.
    fs::remove("file");
    for (int i = 0; i < 20; ++i) {
        ASSERT_EQ(chdir(".."), 0);
        ASSERT_EQ(rmdir(part.c_str()), 0);
    }
    fs::current_path(before);
}

TEST(Printable, ShowsWhatATerminalObeys) {
    EXPECT_EQ(printable("two\nlines\t\x1b[2J\x7f \xc3\xa4"), "two\\nlines\\t\\x1b[2J\\x7f \xc3\xa4");
    EXPECT_EQ(printable("\xc2\x9b\x31m \xc2\xa0 \xc2"), "\\xc2\\x9b\x31m \xc2\xa0 \xc2");
    EXPECT_EQ(printable(""), "");
}

TEST(ReadFile, GivesEveryByte) {
    const TemporaryFolder folder;
    // Around the sizes at which the buffer grows.
    for (const std::size_t size : {0U, 1U, 65535U, 65536U, 65537U, 131072U, 131073U, 500000U}) {
        const std::string text(size, 'y');
        writeFileAtomically(folder / "file", text);
        EXPECT_EQ(textOf(folder / "file"), text) << size;
    }
}

TEST(ReadFile, HoldsTheLimit) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "file", "12345");
    EXPECT_EQ(readFile(folder / "file", 5).size(), 5U);
    EXPECT_TRUE(contains(messageOf([&] { (void)readFile(folder / "file", 4); }), "must hold at most 4 bytes"));
    EXPECT_THROW((void)readFile("/dev/zero", plenty), Error);
}

// Nobody waits for who might write into it.
TEST(ReadFile, APipeIsNoFile) {
    const TemporaryFolder folder;
    ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
    for (const fs::path& path : {folder / "pipe", fs::path("/dev/zero"), fs::path("/dev/tty")}) {
        const std::string message = messageOf([&] { (void)readFile(path, plenty); });
        EXPECT_TRUE(contains(message, "must be a file that exists and may be read, ")) << message;
    }
    // But what it was given is read, however slowly it comes.
    int ends[2] = {-1, -1};
    ASSERT_EQ(pipe(ends), 0);
    const pid_t writer = fork();
    if (writer == 0) {
        usleep(20000);
        _exit(write(ends[1], "slowly", 6) == 6 ? 0 : 1);
    }
    close(ends[1]);
    EXPECT_EQ(textOf("/dev/fd/" + std::to_string(ends[0])), "slowly");
    close(ends[0]);
    waitpid(writer, nullptr, 0);
}

TEST(WriteFile, WhetherItCanBeWrittenIsKnownBefore) {
    const TemporaryFolder folder;
    writeFileAtomically(folder / "file", "old");
    for (const char* name : {"file", "new"}) EXPECT_NO_THROW(requireWritable(folder / name));
    EXPECT_EQ(folder.entries(), 1);
    EXPECT_TRUE(contains(messageOf([&] { requireWritable(folder / "no/file"); }), "No such file or directory"));
    EXPECT_TRUE(contains(messageOf([&] { requireWritable(folder.path()); }), "Is a directory"));
    EXPECT_TRUE(contains(messageOf([&] { requireWritable(folder / "file/below"); }), "Not a directory"));
    fs::permissions(folder.path(), static_cast<fs::perms>(0555));
    const auto refused = [&](const fs::path& path) {
        becomeNobody();
        try {
            requireWritable(path);
        } catch (const Error& error) {
            _exit(contains(error.what(), "could not be written, Permission denied") ? 0 : 2);
        }
        _exit(1);
    };
    for (const char* name : {"new", "file"}) {
        EXPECT_EXIT(refused(folder / name), testing::ExitedWithCode(0), "") << name;
    }
}

TEST(ReadFile, TellsWhyNot) {
    const TemporaryFolder folder;
    const fs::path path = folder / "missing";
    EXPECT_EQ(messageOf([&] { (void)readFile(path, plenty); }),
              path.string() + ": must be a file that exists and may be read, No such file or directory");
    EXPECT_TRUE(contains(messageOf([&] { (void)readFile(folder.path(), plenty); }), "Is a directory"));
}

}  // namespace
}  // namespace mv

// The programs under hostile input and in hostile surroundings: a clear message, exit status 1 or 2, nothing half-written.
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "mv/image/file.h"
#include "mv/image/load.h"
#include "mv/run/command_line.h"
#include "support/hostile_lines.h"
#include "support/process.h"

using namespace mv;
using namespace mv::test;

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> noDisplay{"DISPLAY", "WAYLAND_DISPLAY"};

std::string fileText(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

// Runs a line of the shell: for what only a shell sets up, as limits.
ProcessResult runShell(const std::string& line, const std::string& folder, std::vector<std::string> environment = {}) {
    return runProcess({"/bin/sh", "-c", line}, {.folder = folder, .environment = std::move(environment)});
}

std::string errorLine(const std::string& text) {
    const auto at = ("\n" + text).find("\nerror: ");
    return at == std::string::npos ? "" : text.substr(at, text.find('\n', at) - at);
}

void expectRefusal(const ProcessResult& result, const std::string& part) {
    EXPECT_EQ(result.status, 1) << result.err;
    EXPECT_NE(errorLine(result.err).find(part), std::string::npos) << result.err;
}

// The parser's answer to the line, in this process: the words of its refusal, "" where it understands it.
std::string usageError(const std::vector<std::string>& line, Command& command) {
    try {
        command = parseCommandLine(line);
        return "";
    } catch (const UsageError& error) {
        return error.what();
    }
}

// Whether running it takes moments and writes into the present folder only.
bool isCheap(const std::vector<std::string>& line, const Command& command) {
    for (const std::string& word : line) {
        if (word.find('/') != std::string::npos) return false;
    }
    if (command.action != Action::render) {
        return command.action != Action::gallery && command.action != Action::docs && command.action != Action::study &&
               command.action != Action::audit;
    }
    return command.width > 0 && command.width * command.height <= 10000 && command.knobs.size() <= 1 &&
           command.lastFrame - command.firstFrame < 10;
}

}  // namespace

// The parser in this process says which lines are understood; the program then agrees, and leaves pictures or nothing.
TEST(Hostile, two_hundred_command_lines) {
    HostileLines lines(200);
    int run = 0, done = 0, misunderstood = 0;
    while (run < 200) {
        const std::vector<std::string> line = lines.next();
        Command command;
        const std::string refusal = usageError(line, command);
        if (refusal.empty() && !isCheap(line, command)) continue;
        ++run;
        const TemporaryFolder folder;
        std::vector<std::string> words{program("mvgl")};
        words.insert(words.end(), line.begin(), line.end());
        const ProcessResult result = runProcess(words, {.folder = folder.path().string(), .environment = noDisplay});
        std::string shown = "mvgl";
        for (const std::string& word : line) shown += " '" + word.substr(0, 60) + "'";
        SCOPED_TRACE(shown);
        if (!refusal.empty()) {
            ++misunderstood;
            EXPECT_EQ(result.status, 2);
            EXPECT_EQ(result.err, "error: " + printable(refusal) + "\n");
            EXPECT_EQ(result.out, "");
        } else if (result.status == 0) {
            ++done;
            EXPECT_EQ(errorLine(result.err), "");
        } else {
            EXPECT_EQ(result.status, 1);
            EXPECT_NE(errorLine(result.err), "") << result.err;
        }
        for (const std::string& name : folder.list()) {
            EXPECT_EQ(result.status, 0) << name << " was left behind";
            EXPECT_NO_THROW((void)loadPicture(folder.path() / name));
        }
    }
    // Enough lines of each kind to mean something.
    EXPECT_GT(done, 20);
    EXPECT_GT(misunderstood, 50);
}

// A full disk: each write fails, as it does for a process whose files may not grow (and /dev/full, in programs.cpp).
TEST(Hostile, a_full_disk) {
    const TemporaryFolder folder;
    const std::string full = "trap '' XFSZ; ulimit -f 0; exec ", cube = program("cube-cull");
    const auto run = [&](const std::string& command) { return runShell(full + command, folder.path().string()); };
    expectRefusal(run(cube + " --shot a.png"), "a.png: could not be written, File too large");
    expectRefusal(run(cube + " --shot f%d.png --frames 1..9"), "f1.png: could not be written, File too large");
    expectRefusal(run(cube + " --shot a.png --compare cull=back,front"), "a.png: could not be written");
    EXPECT_TRUE(folder.list().empty()) << "nothing half-written is left behind";
    expectRefusal(run(program("mvgl") + " --gallery gallery"), ".png: could not be written, File too large");
    EXPECT_TRUE(fs::is_empty(folder / "gallery"));
    for (const char* flags : {" --list", " --help", " --knobs=json", " --copyable", " --headless --report"}) {
        expectRefusal(runShell(cube + flags + " >/dev/full", folder.path().string()), "standard output");
    }
}

// Killed in the middle of a write, the old picture is whole, and so is every picture of a series.
TEST(Hostile, killed_while_writing) {
    const TemporaryFolder folder;
    const std::string picture = program("projections") + " --shot a.png";
    ASSERT_EQ(runShell(picture, folder.path().string()).status, 0);
    const std::string before = fileText(folder.file("a.png"));
    ASSERT_GT(before.size(), 1024U) << "longer than the limit";
    // A file beyond its limit: no signal ends the program within write(), and nothing is left of what was allowed.
    const ProcessResult limited =
        runShell("ulimit -c 0; ulimit -f 1; exec " + picture + " --turn 50", folder.path().string());
    expectRefusal(limited, "a.png: could not be written, File too large");
    EXPECT_TRUE(fileText(folder.file("a.png")) == before);
    EXPECT_EQ(folder.entries(), 1);
    EXPECT_EQ(runShell(picture, folder.path().string()).status, 0);
    EXPECT_TRUE(fileText(folder.file("a.png")) == before);

    // At several moments of a series, after its third picture.
    for (const char* seconds : {"0", "0.003", "0.01", "0.03"}) {
        const TemporaryFolder series;
        const ProcessResult run = runShell(program("cube-cull") +
                                               " --shot f%d.png --frames 1..99999 --size 300x300 & "
                                               "while [ ! -e f3.png ] && kill -0 $!; do sleep 0.005; done; sleep " +
                                               seconds + "; kill -KILL $!; wait $!",
                                           series.path().string());
        EXPECT_EQ(run.status, 128 + SIGKILL) << run.err;
        for (const std::string& name : series.list()) {
            EXPECT_NE(name.front(), '.') << "a part without a name is nobody's to remove";
            EXPECT_EQ(loadPicture(series.path() / name).width, 300) << name;
        }
    }
}

// A child that it has started ends with it, however it ends: here a program that stands for ffmpeg and never comes to an end.
TEST(Hostile, killed_while_filming) {
    for (const std::string signal : {"TERM", "KILL", "USR1"}) {
        const TemporaryFolder folder;
        std::ofstream(folder.file("ffmpeg")) << "#!/bin/sh\necho $$ > process\nexec sleep 1000\n";
        fs::permissions(folder / "ffmpeg", static_cast<fs::perms>(0755));
        const ProcessResult run = runShell(
            "ulimit -c 0; PATH=$PWD:$PATH " + program("cube-cull") +
                " --movie a.mp4 --frames 1..99 & while [ ! -s process ] && kill -0 $!; do sleep 0.01; done; kill -" +
                signal +
                " $!; wait $!; i=0; while kill -0 $(cat process) 2>&- && [ $i -lt 500 ]; do i=$((i + 1)); sleep 0.01; "
                "done; "
                "[ $i -lt 500 ] && echo ended",
            folder.path().string(), {"TMPDIR=" + folder.path().string()});
        EXPECT_EQ(run.out, "ended\n") << signal << run.err;
        EXPECT_FALSE(fs::exists(folder / "a.mp4"));
    }
}

// The program knows what it is given to write to by its kind: a stream goes on where it stands, and what runs is no file
// to write.
TEST(Hostile, streams_and_programs) {
    const TemporaryFolder folder;
    const std::string cube = program("cube-cull");
    ASSERT_EQ(runShell(cube + " --shot alone.png", folder.path().string()).status, 0);
    const std::string whole = "head\n" + fileText(folder.file("alone.png")) + "tail\n";
    for (const char* name : {"/dev/fd/1", "/dev/stdout", "/proc/self/fd/1", "f", "-", "./f"}) {
        for (const char* into : {"> f", ">> f"}) {
            std::ofstream(folder.file("f")) << "";  // for what appends to it, too, it begins empty
            const ProcessResult run =
                runShell("(echo head; " + cube + " --shot " + name + " && echo tail) " + into, folder.path().string());
            EXPECT_EQ(run.status, 0) << run.err;
            EXPECT_TRUE(fileText(folder.file("f")) == whole) << name << into;
        }
    }
    const ProcessResult third =
        runShell("(echo head >&3; " + cube + " --shot /dev/fd/3; echo tail >&3) 3> f", folder.path().string());
    EXPECT_TRUE(fileText(folder.file("f")) == whole) << third.err;
    expectRefusal(runShell(cube + " --shot /proc/self/exe", folder.path().string()),
                  "/proc/self/exe: could not be written, Text file busy");
    EXPECT_EQ(runShell(cube + " --list", folder.path().string()).status, 0) << "it is still there";
    // Closed ones, or those that nobody reads: a sentence, and no other file gets what was meant for them.
    for (const char* flags : {" --report", " --list", " --help", " --knobs", " --copyable", " --audit", " --shot -"}) {
        for (const char* closed : {" >&-", " <&- >&-", " | true"}) {
            const ProcessResult run =
                runShell("(" + cube + flags + "; echo $? >&3) 3> status" + closed, folder.path().string());
            const std::string status = fileText(folder.file("status"));
            EXPECT_EQ(errorLine(run.err).find("could not be written") != std::string::npos, status == "1\n")
                << flags << closed << run.err;
            // A reader may read before it ends.
            EXPECT_TRUE(status == "1\n" || (closed == std::string(" | true") && status == "0\n")) << flags << closed;
        }
    }
    EXPECT_EQ(runShell("exec " + cube + " --shot b.png <&- >&- 2>&-", folder.path().string()).status, 0);
    EXPECT_TRUE(fileText(folder.file("b.png")) == fileText(folder.file("alone.png")));
}

// Names are shown, not obeyed: an error is one line whatever they hold.
TEST(Hostile, names_that_a_terminal_would_obey) {
    const TemporaryFolder folder;
    const std::string name = "two\nlines\x1b[2J\a";
    const std::vector<std::vector<std::string>> lines{{"--shot", "no/" + name},   {"--" + name, "1"},
                                                      {"--cull", name},           {"--shot", name + ".jpg"},
                                                      {"--at", "2", name + "=3"}, {name}};
    for (std::vector<std::string> words : lines) {
        words.insert(words.begin(), program("cube-cull"));
        const ProcessResult run = runProcess(words, {.folder = folder.path().string()});
        EXPECT_NE(run.status, 0);
        EXPECT_EQ(run.err.find('\n'), run.err.size() - 1) << run.err;
        EXPECT_EQ(run.err.find('\x1b'), std::string::npos) << run.err;
        EXPECT_NE(run.err.find("two\\nlines\\x1b[2J"), std::string::npos) << run.err;
    }
}

// No home folder, nor anything else of the surroundings.
TEST(Hostile, no_home_folder) {
    const TemporaryFolder folder;
    const std::string picture = folder.file("a.png");
    for (const char* host : {"osmesa", "egl"}) {
        for (const char* home : {"", "HOME=/nonexistent "}) {
            const ProcessResult run =
                runShell(std::string("exec env -i ") + home + program("cube-cull") + " --shot a.png --headless=" + host,
                         folder.path().string());
            EXPECT_EQ(run.status, 0) << run.err;
            EXPECT_EQ(run.err, "") << home;
            EXPECT_EQ(folder.list(), std::vector<std::string>{"a.png"});
            fs::remove(picture);
        }
    }
    // Nor a folder for temporaries: a study draws its plot itself.
    const ProcessResult study =
        runShell("exec " + program("cube-shadows") + " --study out --vary plane-distance=1 --headless=osmesa",
                 folder.path().string(), {"TMPDIR=/nonexistent"});
    EXPECT_EQ(study.status, 0) << study.err;
    EXPECT_TRUE(fs::exists(folder / "out/study.svg"));
}

// Names that a shell, a pattern or a build system would take apart are names like others.
TEST(Hostile, odd_names) {
    const TemporaryFolder folder;
    const std::string odd = "a#b [1]{2}";
    fs::create_directory(folder / odd);
    const auto run = [&](std::vector<std::string> words) {
        words.front() = program(words.front());
        return runProcess(words, {.folder = folder.path().string(), .environment = {"TMPDIR=" + folder.file(odd)}});
    };
    for (const char* name : {"x#[2].png", "*?.png", "it's \"$HOME\" `x`.png", "two\nlines.png", "%s.png", "-.png"}) {
        const ProcessResult drawn = run({"cube-cull", "--shot", odd + "/" + name, "--size", "9x9"});
        EXPECT_EQ(drawn.status, 0) << drawn.err;
        EXPECT_EQ(loadPicture(folder / odd / name).width, 9) << name;
        fs::remove(folder / odd / name);
    }
    EXPECT_EQ(run({"cube-shadows", "--study", odd + "/o#[1]", "--vary", "plane-distance=1"}).status, 0);
    EXPECT_TRUE(fs::exists(folder / odd / "o#[1]" / "study.svg"));
    fs::remove_all(folder / odd / "o#[1]");
    EXPECT_TRUE(fs::is_empty(folder / odd)) << "not a temporary folder either";
}

// A shader file with a mistake, or what is no file in its place: named, and no picture is written.
TEST(Hostile, shader_files) {
    const TemporaryFolder folder;
    const std::vector<std::string> shaders{"PROBE_SHADERS=" + folder.path().string()};
    const std::string command = "exec " + std::string(MVGL_PROBES) + " probe --shot a.png";
    const auto run = [&] { return runShell(command + " --headless", folder.path().string(), shaders); };
    std::ofstream(folder.file("probe.frag"))
        << "uniform float level;\nout vec4 fragColor;\nvoid main() { fragColor = nonsense; }\n";
    const ProcessResult wrong = run();
    expectRefusal(wrong, "shaders/probe.frag: must compile");
    EXPECT_NE(wrong.err.find("shaders/probe.frag:3: "), std::string::npos) << wrong.err;
    fs::remove(folder / "probe.frag");
    fs::create_directory(folder / "probe.frag");
    expectRefusal(run(), "probe.frag: must be a file that exists and may be read, Is a directory");
    EXPECT_EQ(folder.list(), std::vector<std::string>{"probe.frag"});
    fs::remove(folder / "probe.frag");
    EXPECT_EQ(run().status, 0) << "without the file the program is the one that was built in";
    // Nobody waits for the text of what is no file.
    ASSERT_EQ(mkfifo(folder.file("probe.frag").c_str(), 0600), 0);
    expectRefusal(run(), "probe.frag: must be a file that exists and may be read, it is a pipe or a device");
    fs::remove(folder / "probe.frag");
    // Includes of includes have a sum, too; and a compiler may end the program, by its stack say: in a sentence.
    std::ofstream(folder.file("probe.frag")) << std::string(5 * 1000 * 1000, ' ');
    expectRefusal(run(), "probe.frag: must hold at most 1048576 bytes");
    std::string sums = "uniform float level;\nout vec4 fragColor;\nvoid main() { fragColor = vec4(level";
    for (int i = 0; i < 20'000; ++i) sums += " + level";
    std::ofstream(folder.file("probe.frag")) << sums << "); }\n";
    for (const char* host : {"=osmesa", "=egl"}) {
        const ProcessResult ended =
            runShell("ulimit -c 0; " + command + " --headless" + host, folder.path().string(), shaders);
        if (ended.status != 0) expectRefusal(ended, "is ended by a signal (");
    }
}

// Little memory, no threads, variables that steer a driver into its end: a sentence and a status, and nothing waits for ever.
TEST(Hostile, little_of_everything) {
    const TemporaryFolder folder;
    const std::string picture = "exec timeout 120 " + program("cube-cull") + " --shot a.png";
    int refused = 0, done = 0;
    for (const int megabytes : {24, 50, 100, 150, 200, 250, 300, 400, 500, 600, 4000}) {
        const ProcessResult run = runShell(
            "ulimit -c 0; ulimit -v " + std::to_string(1024 * megabytes) + "; " + picture, folder.path().string());
        SCOPED_TRACE(std::to_string(megabytes) + " MB\n" + run.err);
        // With less the loader itself cannot start it.
        if (run.status == 127) continue;
        ++(run.status == 0 ? done : refused);
        EXPECT_EQ(fs::exists(folder / "a.png"), run.status == 0);
        if (run.status != 0) {
            EXPECT_EQ(run.status, 1);
            EXPECT_NE(errorLine(run.err), "");
            // Nothing that could be installed helps.
            for (const char* words : {"driver is missing", "package"})
                EXPECT_EQ(run.err.find(words), std::string::npos) << words;
            EXPECT_NE(errorLine(run.err).find("memory"), errorLine(run.err).find("threads"));
        }
        fs::remove(folder / "a.png");
    }
    EXPECT_GT(refused, 3);
    EXPECT_GT(done, 0);
    // Stack and data, in KB: the launcher's tables need some before main() begins, and a thread's end by its stack cannot be told.
    // With less than 600 of data the loader itself cannot start it, and with 100 it is killed as it tries.
    const std::vector<std::string> limits{"s 16",   "s 40",   "s 200",   "s 1000",  "s 1024", "d 500",
                                          "d 1000", "d 5000", "d 10000", "d 50000", "n 4"};
    for (const std::string& limit : limits) {
        for (const char* command : {"cube-cull", "mvgl lights"}) {
            const ProcessResult run =
                runShell("ulimit -c 0; ulimit -" + limit + "; exec " + program(command) + " --size 99x99 --shot a.png",
                         folder.path().string());
            SCOPED_TRACE("ulimit -" + limit + " " + command + "\n" + run.err);
            if (run.status == 127) continue;
            EXPECT_EQ(fs::exists(folder / "a.png"), run.status == 0);
            EXPECT_EQ(run.status == 0, limit == "s 1024");
            if (run.status != 0) {
                EXPECT_EQ(run.status, 1);
                EXPECT_NE(errorLine(run.err), "");
            }
            if (limit.starts_with("s") || limit == "d 1000") {
                EXPECT_NE(errorLine(run.err).find("raise ulimit -" + limit.substr(0, 1)) == std::string::npos,
                          run.status != 0);
            }
            fs::remove(folder / "a.png");
        }
    }
    // As somebody who has one process, this one; the superuser has as many as he likes.
    const std::string nobody = geteuid() == 0 ? "setpriv --reuid=65534 --clear-groups " : "";
    expectRefusal(
        runShell("exec " + nobody + "prlimit --nproc=1 " + program("cube-cull") + " --shot /dev/null",
                 folder.path().string()),
        "must be allowed to start threads; ulimit -u, -v and -d limit them, Resource temporarily unavailable");
    // The driver overwrites the heap, and who finds it first is chance: the loader ends a process itself, in words of its own.
    for (const char* host : {"", " --headless=osmesa", " --headless=egl"}) {
        const ProcessResult run =
            runShell("ulimit -c 0; " + picture + host, folder.path().string(), {"LP_NATIVE_VECTOR_WIDTH=7"});
        if (run.status == 0 || (run.status == 127 && run.err.starts_with("Inconsistency detected by ld.so"))) continue;
        expectRefusal(run, "LP_NATIVE_VECTOR_WIDTH=7");
    }
}

// A command that has long to compute says before that there is no place for it; and time that does not pass is not waited for.
TEST(Hostile, studies) {
    const TemporaryFolder folder;
    const std::string study = " --study out --vary plane-distance=1 --headless=osmesa";
    fs::create_directories(folder / "out/study.csv");
    const ProcessResult blocked = runShell("exec " + program("cube-shadows") + study, folder.path().string());
    expectRefusal(blocked, "out/study.csv: could not be written, Is a directory");
    EXPECT_EQ(blocked.err.find("study 1/"), std::string::npos) << "nothing was measured before: " << blocked.err;
    fs::remove_all(folder / "out");
    // Ended while it measures, it leaves nothing, not even the folder.
    const ProcessResult ended = runShell("ulimit -c 0; " + program("cube-shadows") +
                                             " --study a/b --headless=osmesa 2>err & "
                                             "while ! grep -q '^study' err && kill -0 $!; do sleep 0.01; done; "
                                             "kill -USR1 $!; wait $!",
                                         folder.path().string());
    EXPECT_EQ(ended.status, 128 + SIGUSR1) << fileText(folder.file("err"));
    EXPECT_FALSE(fs::exists(folder / "a"));
    const ProcessResult still = runShell("exec timeout 200 " + program("pipeline") + " --study out --vary offset=1",
                                         folder.path().string(), {"LD_PRELOAD=" MVGL_STILL_CLOCK});
    expectRefusal(still, "clock: must not stand still while something is timed");
}

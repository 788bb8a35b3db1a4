// The programs as a user or a CI job starts them: exit statuses, messages, files, hosts.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <tuple>

#include "mv/image/load.h"
#include "mv/image/png.h"
#include "support/demo_run.h"
#include "support/process.h"

using namespace mv;
using namespace mv::test;

namespace {

namespace fs = std::filesystem;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// A line that begins as every error does; a driver may have had its say before it.
void expectRefusal(const ProcessResult& result, int status, const std::string& part) {
    EXPECT_EQ(result.status, status) << result.err;
    const auto line = ("\n" + result.err).find("\nerror: ");
    ASSERT_NE(line, std::string::npos) << result.err;
    EXPECT_TRUE(has(result.err.substr(line), part)) << result.err;
}

}  // namespace

TEST(Program, exit_statuses_and_messages) {
    const std::string cube = program("cube-cull");
    TemporaryFolder folder;
    expectRefusal(runProcess({cube, "--spin-z", "3"}), 2, "did you mean '--spin-x'?");
    expectRefusal(runProcess({cube, "--z-dist", "11"}), 2, "--z-dist: must be -10 .. 10, '11'");
    expectRefusal(runProcess({cube, "--z-dist", "nan", "--shot", folder.file("a.png")}), 2, "--z-dist");
    expectRefusal(runProcess({program("mvgl"), "cube-cul", "--list"}), 2, "did you mean 'cube-cull'?");
    // In range each, impossible together: understood, and cannot be done.
    expectRefusal(runProcess({cube, "--z-dist", "0", "--shot", folder.file("a.png")}), 1, "--z-dist: must not be 0");
    expectRefusal(runProcess({cube, "--shot", folder.file("missing/a.png")}), 1, "missing/a.png");
    expectRefusal(runProcess({cube, "--shot", "/dev/full"}), 1, "/dev/full");
    expectRefusal(runProcess({cube, "--shot", folder.path().string()}), 1, folder.path().string());
    expectRefusal(runProcess({cube, "--size", "20000x5", "--shot", folder.file("a.png")}), 2, "--size");
    EXPECT_TRUE(folder.list().empty()) << "nothing half-written is left behind";
    for (const char* flag : {"--help", "--version", "--list", "--knobs", "--knobs=json", "--copyable"}) {
        const ProcessResult result = runProcess({cube, flag});
        EXPECT_EQ(result.status, 0) << flag;
        EXPECT_FALSE(result.out.empty()) << flag;
        EXPECT_EQ(result.err, "") << flag;
    }
}

// A copied line works where the student is: in a source tree by ./run, which gives the program its own name.
// A knob that was given and changes nothing is named with its reason, where a picture is made; a preset's is not.
TEST(Program, notes_a_knob_that_does_nothing) {
    TemporaryFolder folder;
    const auto notes = [&](std::vector<std::string> words) {
        words.insert(words.begin(), program("cube-cull"));
        const ProcessResult result = runProcess(words, {.folder = folder.path().string()});
        EXPECT_EQ(result.status, 0) << result.err;
        return result.err;
    };
    const std::string idle = "note: --winding does nothing in these settings: front and back faces are treated alike\n";
    EXPECT_EQ(notes({"--cull", "none", "--winding", "cw", "--shot", "a.png"}), idle);
    EXPECT_EQ(notes({"--winding", "cw", "--cull", "both", "--headless"}), idle);
    EXPECT_EQ(notes({"--winding", "cw", "--shot", "a.png"}), "");
    EXPECT_EQ(notes({"--winding", "cw", "--compare", "cull=none,front", "--shot", "a.png"}), "");
    EXPECT_EQ(notes({"--winding", "cw", "--compare", "cull=none,both", "--shot", "a.png"}), idle);
    EXPECT_EQ(notes({"--cull", "none", "--winding", "cw", "--knobs"}), "") << "the list tells it by itself";
}

TEST(Program, run_is_what_a_copied_line_begins_with) {
    TemporaryFolder folder;
    fs::copy_file(MVGL_SOURCE_DIR "/run", folder.path() / "run");
    fs::create_directory(folder.path() / "scripts");
    fs::create_directory(folder.path() / "a folder");
    // The test does not ask what is installed and built.
    std::ofstream(folder.file("scripts/setup.sh"))
        << ". '" MVGL_SOURCE_DIR "/scripts/setup.sh'\nbuild='" MVGL_BINARY_DIR "'\n"
        << "install_packages() { :; }\ncheck_versions() { :; }\nconfigure() { :; }\nbuild_targets() { :; }\n";
    const std::string flags = " cube-cull --spin-x 25 --size 60x40";
    for (const auto& [from, typed, start] : {std::array<std::string, 3>{"", "./run", "./run"},
                                             {"", "bash run", "./run"},
                                             {"a folder", "../run", "../run"}}) {
        const ProcessOptions there{.folder = (folder.path() / from).string()};
        const ProcessResult line = runProcess({"/bin/sh", "-c", typed + flags + " --copyable"}, there);
        ASSERT_EQ(line.out, start + flags + "\n") << line.err;
        const ProcessResult pasted = runProcess({"/bin/sh", "-c", start + flags + " --shot a.png"}, there);
        EXPECT_EQ(pasted.status, 0) << pasted.err;
        EXPECT_TRUE(fs::exists(folder.path() / from / "a.png"));
    }
    // A program that was built or installed is started as it was, whatever its folder is called; under another name than the
    // demo's, with that.
    fs::create_symlink(program("cube-cull"), folder.path() / "a folder" / "it's");
    const ProcessResult own =
        runProcess({"/bin/sh", "-c", "'a folder/it'\\''s' --copyable"}, {.folder = folder.path().string()});
    EXPECT_EQ(own.out, "'a folder/it'\\''s' cube-cull\n") << own.err;
}

TEST(Program, hosts_that_are_missing_are_named) {
    const std::string cube = program("cube-cull");
    TemporaryFolder folder;
    const std::string picture = folder.file("a.png");
    // A libOSMesa.so.8 that is none stands in for the missing one.
    std::ofstream(folder.file("libOSMesa.so.8")) << "no library";
    const std::string noOsmesa = "LD_LIBRARY_PATH=" + folder.path().string();
    const ProcessResult fallback = runProcess({cube, "--shot", picture}, {.environment = {noOsmesa}});
    EXPECT_EQ(fallback.status, 0) << fallback.err;
    EXPECT_TRUE(has(fallback.err, "note: using EGL")) << "no fallback without a line that names it: " << fallback.err;
    EXPECT_TRUE(has(fallback.err, "libosmesa6")) << fallback.err;
    EXPECT_TRUE(fs::exists(picture));
    fs::remove(picture);
    expectRefusal(runProcess({cube, "--shot", picture, "--headless=osmesa"}, {.environment = {noOsmesa}}), 1,
                  "libosmesa6");
    const std::string noEgl = "__EGL_VENDOR_LIBRARY_FILENAMES=/nonexistent.json";
    expectRefusal(runProcess({cube, "--shot", picture, "--headless=egl"}, {.environment = {noEgl}}), 1, "EGL");
    expectRefusal(runProcess({cube, "--shot", picture}, {.environment = {noOsmesa, noEgl}}), 1,
                  "must have OSMesa or EGL");
    for (const char* broken : {"GALLIUM_DRIVER=nosuch", "LIBGL_DRIVERS_PATH=/nonexistent"}) {
        const ProcessResult run = runProcess({cube, "--shot", picture, "--headless=egl"}, {.environment = {broken}});
        if (run.status != 0) expectRefusal(run, 1, "EGL");  // newer Mesas ignore these names and draw
    }
    fs::remove(picture);
    // The floor is OpenGL 3.3.
    for (const char* host : {"--headless=osmesa", "--headless=egl"}) {
        expectRefusal(runProcess({cube, "--shot", picture, host},
                                 {.environment = {"MESA_GL_VERSION_OVERRIDE=2.1", "MESA_GLSL_VERSION_OVERRIDE=120"}}),
                      1, "3.3");
    }
    EXPECT_FALSE(fs::exists(picture));
}

// Where the environment steers the driver into its end, a host is passed over in words: by its name, by the signal and by
// the variable. Never does the program itself end by a signal.
TEST(Program, drivers_that_end_by_a_signal_are_passed_over) {
    TemporaryFolder folder;
    const std::string picture = folder.file("a.png");
    const auto run = [&](const std::string& host, const std::vector<std::string>& environment) {
        fs::remove(picture);
        ProcessResult result =
            runProcess({program("cube-cull"), "--shot", picture, "--headless" + host}, {.environment = environment});
        EXPECT_EQ(fs::exists(picture), result.status == 0) << environment.back() << host;
        return result;
    };
    // An OSMesa that crashes whatever happens
    const std::string crashing = "LD_LIBRARY_PATH=" MVGL_BINARY_DIR "/tests/crashing";
    const ProcessResult passedOver = run("", {crashing, "GALLIUM_DRIVER=llvmpipe"});
    EXPECT_EQ(passedOver.status, 0) << passedOver.err;
    EXPECT_TRUE(has(passedOver.err,
                    "note: using EGL surfaceless, since OSMesa: must draw, and is ended by a signal "
                    "(Segmentation fault); unset what steers its driver, GALLIUM_DRIVER=llvmpipe\n"))
        << passedOver.err;
    expectRefusal(run("=osmesa", {crashing, "GALLIUM_DRIVER=llvmpipe"}), 1,
                  "OSMesa: must draw, and is ended by a signal (Segmentation fault); unset");
    expectRefusal(
        run("=osmesa", {crashing, "OSMESA_EXIT=127"}), 1,
        "OSMesa: must draw, and is ended by its driver (status 127); unset what steers its driver, OSMESA_EXIT=127");
    // The answers of Mesa 22; another one may draw, or refuse in words of its own
    for (const std::string variable : {"GALLIUM_DRIVER=zink", "GALLIUM_DRIVER=virgl", "GALLIUM_DRIVER=nosuch",
                                       "MESA_GLSL_VERSION_OVERRIDE=120", "DRAW_USE_LLVM=0"}) {
        for (const char* host : {"", "=osmesa", "=egl"}) {
            SCOPED_TRACE(variable + " --headless" + host);
            const ProcessResult result = run(host, {variable});
            if (result.status != 0) expectRefusal(result, 1, host == std::string("=egl") ? "EGL" : "OSMesa");
            if (has(result.err, "is ended by a signal")) {
                EXPECT_TRUE(has(result.err, variable)) << result.err;
            }
        }
    }
}

// The program says by name what a driver lacks, and the picture is the one that the sentence promises.
TEST(Program, missing_clip_control_is_named) {
    const TemporaryFolder folder;
    const std::string reversed = folder.path() / "reversed.png", flipped = folder.path() / "flipped.png";
    const std::vector<std::string> road{program("mvgl"), "z-buffer", "--scene",      "road",
                                        "--format",      "d32f",     "--separation", "1e-6"};
    const auto run = [&](std::vector<std::string> more, const ProcessOptions& options) {
        std::vector<std::string> command = road;
        command.insert(command.end(), more.begin(), more.end());
        ProcessResult result = runProcess(command, options);
        EXPECT_EQ(result.status, 0) << result.err;
        return result;
    };
    const ProcessOptions without{.environment = {"MESA_GL_VERSION_OVERRIDE=3.3", "MESA_GLSL_VERSION_OVERRIDE=330",
                                                 "MESA_EXTENSION_OVERRIDE=-GL_ARB_clip_control"}};
    const auto line = [](const std::string& text, const std::string& word) {
        const auto at = text.find(word);
        return at == std::string::npos ? "no " + word : text.substr(at, text.find('\n', at) - at);
    };
    const auto first = run({"--mapping", "reversed", "--report", "--shot", reversed}, without);
    const auto second = run({"--mapping", "flipped", "--report", "--shot", flipped}, without);
    EXPECT_TRUE(has(first.err, "has no clip control"));
    EXPECT_FALSE(has(second.err, "clip control"));
    EXPECT_EQ(loadPicture(reversed), loadPicture(flipped));
    EXPECT_EQ(line(first.out, "misordered"), line(second.out, "misordered"));
    EXPECT_TRUE(has(first.out, "misordered"));
    // As an extension of 3.3 it is used.
    const ProcessOptions extension{.environment = {"MESA_GL_VERSION_OVERRIDE=3.3", "MESA_GLSL_VERSION_OVERRIDE=330"}};
    EXPECT_FALSE(has(run({"--mapping", "reversed", "--shot", reversed}, extension).err, "clip control"));
    EXPECT_NE(loadPicture(reversed), loadPicture(flipped));
}

// The window system is no part of a run without a window: neither GLFW nor libX11 nor the window module is mapped.
TEST(Program, a_headless_run_maps_no_window_system) {
    TemporaryFolder folder;
    for (const std::string host : {"osmesa", "egl"}) {
        // The loader's own trace names every library that is mapped, at the start and later.
        const ProcessResult run =
            runProcess({program("cube-cull"), "--shot", folder.file("a.png"), "--headless=" + host},
                       {.environment = {"LD_DEBUG=files"}});
        ASSERT_EQ(run.status, 0);
        ASSERT_TRUE(has(run.err, "libmvgl.so"));
        ASSERT_TRUE(has(run.err, host == "osmesa" ? "libOSMesa" : "libEGL")) << "what is opened later is named, too";
        for (const char* library : {"libglfw", "libX11.so", "mvgl-window", "libimgui"}) {
            EXPECT_FALSE(has(run.err, library)) << library << " on " << host;
        }
    }
}

TEST(Program, several_frames_and_comparisons_are_written) {
    TemporaryFolder folder;
    const ProcessResult frames =
        runProcess({program("cube-cull"), "--shot", folder.file("f%03d.png"), "--frames", "1..3", "--size", "40x30"});
    EXPECT_EQ(frames.status, 0) << frames.err;
    EXPECT_EQ(folder.list(), (std::vector<std::string>{"f001.png", "f002.png", "f003.png"}));
    const ProcessResult compare = runProcess(
        {program("cube-cull"), "--shot", folder.file("c.png"), "--compare", "cull=back,front", "--size", "200x150"});
    ASSERT_EQ(compare.status, 0) << compare.err;
    const Picture sheet = loadPicture(folder.file("c.png"));
    EXPECT_EQ(sheet.width, 3 * 200 + 8);
    EXPECT_GT(sheet.height, 150);
    // The size that is named is the one that holds.
    const auto compared = [&](const std::string& size) {
        return runProcess(
            {program("cube-cull"), "--shot", folder.file("wide.png"), "--compare", "cull=back,front", "--size", size});
    };
    const ProcessResult wide = compared("6000x10");
    expectRefusal(wide, 1, "--compare: lays three pictures beside each other; each must be at most ");
    expectRefusal(compared("10x16384"), 1, wide.err.substr(0, wide.err.find(" on this driver")));
    const std::string most = " at most ";
    const std::string named = wide.err.substr(wide.err.find(most) + most.size());
    const int across = std::stoi(named), down = std::stoi(named.substr(named.find('x') + 1));
    EXPECT_EQ(compared(std::to_string(across) + "x10").status, 0);
    EXPECT_EQ(compared("10x" + std::to_string(down)).status, 0);
    expectRefusal(compared(std::to_string(across + 1) + "x10"), 1, "each must be at most");
    expectRefusal(compared("10x" + std::to_string(down + 1)), 1, "each must be at most");
    // Both at once: a sheet a frame, each what it is alone.
    const std::vector<std::string> squares{program("mvgl"),      "shadow", "--compare",
                                           "light-height=1.5,2", "--size", "64x48"};
    const auto run = [&](std::vector<std::string> more) {
        std::vector<std::string> words = squares;
        words.insert(words.end(), more.begin(), more.end());
        return runProcess(words).status;
    };
    EXPECT_EQ(run({"--frames", "2..9", "--shot", folder.file("both%d.png")}), 0);
    EXPECT_EQ(run({"--frame", "9", "--shot", folder.file("ninth.png")}), 0);
    EXPECT_FALSE(fs::exists(folder / "both%d.png"));
    EXPECT_EQ(loadPicture(folder.file("both9.png")), loadPicture(folder.file("ninth.png")));
    EXPECT_NE(loadPicture(folder.file("both2.png")), loadPicture(folder.file("ninth.png"))) << "the square turns";
}

// The page of environment says how six files become the one that its knob takes.
TEST(Program, six_faces_become_one_picture) {
    const std::string page = fileText(MVGL_SOURCE_DIR "/demos/environment/environment.md");
    const std::size_t begin = page.find("\nmontage ");
    ASSERT_NE(begin, std::string::npos);
    std::string command = page.substr(begin + 1, page.find('\n', begin + 1) - begin - 1);
    const Picture cut = loadPicture(MVGL_SOURCE_DIR "/assets/evening-faces.png");
    const int side = cut.width / 4;
    const std::string said = "512x512", ours = std::to_string(side) + "x" + std::to_string(side);
    ASSERT_TRUE(has(command, said));
    command.replace(command.find(said), said.size(), ours);
    TemporaryFolder folder;
    const std::array<std::tuple<const char*, int, int>, 6> cells = {
        {{"up", 1, 0}, {"left", 0, 1}, {"front", 1, 1}, {"right", 2, 1}, {"back", 3, 1}, {"down", 1, 2}}};
    for (const auto& [name, column, row] : cells) {
        Picture face(side, side);
        for (int y = 0; y < side; ++y)
            for (int x = 0; x < side; ++x) face.set(x, y, cut.at(column * side + x, row * side + y));
        writePng(folder.file(std::string(name) + ".png"), face);
    }
    const ProcessResult made = runProcess({"/bin/sh", "-c", "cd " + folder.path().string() + " && " + command});
    ASSERT_EQ(made.status, 0) << made.err;
    EXPECT_EQ(loadPicture(folder.file("sky.png")), cut);
}

TEST(Program, the_gallery_has_every_demo) {
    TemporaryFolder folder;
    const ProcessResult run = runProcess({program("mvgl"), "--gallery", folder.file("gallery")});
    ASSERT_EQ(run.status, 0) << run.err;
    const std::string page = fileText(folder.file("gallery/index.html"));
    for (const std::string& name : demoNames()) {
        EXPECT_TRUE(has(page, name + ".png"));
        EXPECT_TRUE(fs::exists(folder.file("gallery/" + name + ".png")));
        EXPECT_TRUE(has(run.err, name)) << "progress is shown";
    }
}

// The commands of a lecture: strips, films, a sentence on two settings, the plot of one scene.
#include "mv/run/lecture.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>

#include <chrono>
#include <cstdlib>
#include <string>

#include "mv/image/file.h"
#include "mv/image/load.h"
#include "mv/image/png.h"
#include "mv/run/film.h"
#include "mv/run/render.h"
#include "support/demo_run.h"
#include "support/temporary_folder.h"

using namespace mv;
using namespace mv::test;

namespace {

class Lectures : public testing::Test {
  protected:
    TemporaryFolder folder;
};

std::string printedBy(void (*action)(const Command&), const std::vector<std::string>& line) {
    testing::internal::CaptureStdout();
    action(parseCommandLine(line));
    return testing::internal::GetCapturedStdout();
}

std::string refusal(void (*action)(const Command&), const std::vector<std::string>& line) {
    try {
        action(parseCommandLine(line));
    } catch (const Error& error) {
        return error.what();
    }
    return "accepted";
}

Picture part(const Picture& whole, int left, int top, int width, int height) {
    Picture result(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) result.set(x, y, whole.at(left + x, top + y));
    }
    return result;
}

}  // namespace

TEST_F(Lectures, a_grid_has_each_picture_under_its_label) {
    const std::string file = folder.file("grid.png");
    render(parseCommandLine(
        {"cube-cull", "--strip", "cull=back,front", "--strip", "depth=on,off", "--size", "90x80", "--shot", file}));
    const Picture grid = loadPicture(file);
    const int label = (grid.height - 4) / 2 - 80;  // the words above a picture; 4 pixels are between two
    EXPECT_GT(label, 8);
    ASSERT_EQ(grid.width, 2 * 90 + 4);
    int row = 0;
    for (const char* depth : {"on", "off"}) {
        int column = 0;
        for (const char* cull : {"back", "front"}) {
            const std::string one = folder.file("one.png");
            render(parseCommandLine({"cube-cull", "--cull", cull, "--depth", depth, "--size", "90x80", "--shot", one}));
            const int left = column * 94, top = row * (label + 84) + label;
            EXPECT_EQ(part(grid, left, top, 90, 80), loadPicture(one)) << cull << " " << depth;
            EXPECT_GT(countColors(part(grid, left, top - label, 90, label)), 2) << "words";
            ++column;
        }
        ++row;
    }
    // The file tells how it is made, and is made so again
    const std::string again = folder.file("again.png");
    render(parseCommandLine({"--from", file, "--shot", again}));
    EXPECT_EQ(loadPicture(again), grid);
    EXPECT_EQ(commandInPng(again), commandInPng(file));
    EXPECT_EQ(refusal(render, {"cube-persp", "--far", "1.6", "--strip", "near=0.5,2", "--shot", file}).substr(0, 15),
              "with near = 2: ");
    EXPECT_EQ(loadPicture(file), grid) << "what failed has not touched the file";
}

TEST_F(Lectures, a_sentence_is_of_the_committed_study_where_it_has_both) {
    const std::vector<std::string> committed{
        "shadow-methods",   "--scene", "cube-on-plane", "--against", "off",          "--keep", "off",
        "--slope-bias",     "2",       "--receiver",    "on",        "--resolution", "1024",   "--versus",
        "method=map,volume"};
    const std::string said = printedBy(printVersus, committed);
    EXPECT_TRUE(said.starts_with("map takes ")) << said;
    EXPECT_NE(said.find(" of the time and is wrong in "), std::string::npos) << said;
    EXPECT_NE(said.find("from the study that is committed: llvmpipe"), std::string::npos) << said;
    EXPECT_EQ(printedBy(printVersus, committed), said) << "nothing is measured";
}

TEST_F(Lectures, a_sentence_is_measured_where_no_study_has_it) {
    const std::string study =
        printedBy(printVersus, {"shadow-methods", "--size", "40x30", "--versus", "method=none,volume"});
    EXPECT_TRUE(study.starts_with("none takes ")) << study;
    EXPECT_NE(study.find("measured here: "), std::string::npos) << study;
    EXPECT_NE(study.find("MAD "), std::string::npos) << study;
    const std::string pictures =
        printedBy(printVersus, {"cube-ortho", "--preset", "turned", "--size", "40x30", "--versus", "volume=on,off"});
    EXPECT_TRUE(pictures.starts_with("volume on takes ")) << pictures;
    EXPECT_EQ(pictures.find("another in 0 %"), std::string::npos) << pictures;
    EXPECT_NE(pictures.find("by no study of what is right"), std::string::npos) << pictures;
}

TEST_F(Lectures, a_plot_is_of_one_scene) {
    const std::string file = folder.file("a.svg");
    writePlot(parseCommandLine({"shadow-methods", "--plot", "still life=" + file}));
    const std::string svg = readTextFile(file, 1 << 20);
    EXPECT_TRUE(svg.starts_with("<svg")) << svg.substr(0, 60);
    EXPECT_NE(svg.find("still life"), std::string::npos);
    EXPECT_EQ(svg.find("cube on plane"), std::string::npos);
    EXPECT_EQ(refusal(writePlot, {"shadow-methods", "--plot", file}),
              "--plot: must name one scene, as 'cube on plane=FILE.svg'; there are: cube on plane, still life");
    EXPECT_NE(refusal(writePlot, {"shadow-methods", "--plot", "moon=" + file}).find("must name a scene"),
              std::string::npos);
    EXPECT_NE(refusal(writePlot, {"cube-ortho", "--plot", file}).find("needs a demo with a study"), std::string::npos);
}

// By a program that stands for rsvg-convert: it keeps the SVG that it is given, or fails.
TEST_F(Lectures, a_plot_may_be_a_png) {
    const std::string before = std::getenv("PATH");
    const auto standIn = [&](const std::string& script) {
        const std::string program = folder.file("rsvg-convert");
        writeFileAtomically(program, "#!/bin/sh\n" + script);
        ::chmod(program.c_str(), 0755);
    };
    const std::string file = folder.file("a.png"), svg = folder.file("a.svg");
    const std::vector<std::string> words{"shadow-methods", "--plot", "still life=" + file};
    ::setenv("PATH", folder.path().c_str(), 1);
    EXPECT_NE(refusal(writePlot, words).find("needs rsvg-convert for a PNG, which is not installed"),
              std::string::npos);
    ::setenv("PATH", (folder.path().string() + ":" + before).c_str(), 1);
    standIn("cat >\"$4\"\n");
    writePlot(parseCommandLine(words));
    writePlot(parseCommandLine({"shadow-methods", "--plot", "still life=" + svg}));
    EXPECT_EQ(readTextFile(file, 1 << 20), readTextFile(svg, 1 << 20));
    standIn("cat >/dev/null; exit 1\n");
    EXPECT_EQ(refusal(writePlot, words), "rsvg-convert: must make a PNG of the plot; it says why above");
    EXPECT_EQ(readTextFile(file, 1 << 20), readTextFile(svg, 1 << 20)) << "the last plot is still there";
    ::setenv("PATH", before.c_str(), 1);
}

// By a program that stands for ffmpeg: it keeps the bytes that it is given, or fails.
TEST_F(Lectures, a_movie_has_every_picture) {
    const std::string before = std::getenv("PATH");
    const auto standIn = [&](const std::string& script) {
        const std::string program = folder.file("ffmpeg");
        writeFileAtomically(program, "#!/bin/sh\n" + script);
        ::chmod(program.c_str(), 0755);
    };
    const std::string file = folder.file("a.gif");
    ::setenv("PATH", folder.path().c_str(), 1);
    EXPECT_NE(refusal(writeMovie, {"viewpoints", "--movie", file, "--frames", "1..3"})
                  .find("needs ffmpeg, which is not installed"),
              std::string::npos);
    ::setenv("PATH", (folder.path().string() + ":" + before).c_str(), 1);
    standIn("for last; do :; done; cat >\"$last\"\n");
    writeMovie(parseCommandLine({"viewpoints", "--movie", file, "--frames", "1..3", "--size", "30x20"}));
    EXPECT_EQ(readFile(file, 1 << 20).size(), 3U * 30 * 20 * 4);
    writeMovie(parseCommandLine({"cube-cull", "--movie", file, "--vary", "spin-x=0..90:7", "--size", "30x20"}));
    const std::vector<std::byte> swept = readFile(file, 1 << 20);
    ASSERT_EQ(swept.size(), 7U * 30 * 20 * 4);
    const std::size_t each = swept.size() / 7;
    EXPECT_FALSE(std::equal(swept.begin(), swept.begin() + long(each), swept.begin() + long(each))) << "it turns";
    EXPECT_NE(
        refusal(writeMovie, {"cube-cull", "--movie", file, "--frames", "1..3"}).find("needs something that moves"),
        std::string::npos);
    standIn("cat >/dev/null; exit 1\n");
    EXPECT_EQ(refusal(writeMovie, {"viewpoints", "--movie", file, "--frames", "1..3"}),
              file + ": must be a film that this ffmpeg can make; it says why above");
    EXPECT_EQ(readFile(file, 1 << 20), swept) << "the last film is still there";
    // One that hangs is not waited for, while it is given pictures or after; and it does not outlive its film.
    for (const char* script :
         {"exec sleep 1000\n", "cat >/dev/null; exec sleep 1000\n", "trap '' TERM; exec sleep 1000\n"}) {
        standIn("echo $$ >\"$(dirname \"$0\")/process\"\n" + std::string(script));
        try {
            Film film(file, 200, 200, std::chrono::milliseconds(1000));
            for (int i = 0; i < 3; ++i) film.add(Picture(200, 200));
            film.finish();
            ADD_FAILURE() << script;
        } catch (const Error& error) {
            EXPECT_STREQ(error.what(),
                         "ffmpeg: must take what it is given or write what it makes; it hangs, neither for 1 s");
        }
        const int process = std::stoi(readTextFile(folder.file("process"), 99));
        EXPECT_EQ(::kill(process, 0), -1) << script;
    }
    // Slow ones write meanwhile, and are waited for.
    standIn(
        "for last; do :; done; cat >/dev/null; for i in 1 2 3 4 5 6 7 8 9; do sleep 0.2; printf $i >>\"$last\"; "
        "done\n");
    Film slow(file, 2, 2, std::chrono::milliseconds(1500));
    slow.add(Picture(2, 2));
    slow.finish();
    EXPECT_EQ(readTextFile(file, 99), "123456789");
    ::setenv("PATH", before.c_str(), 1);
}

TEST_F(Lectures, more_samples_smooth_edges_alone) {
    const std::string plain = folder.file("plain.png"), smooth = folder.file("smooth.png");
    render(parseCommandLine({"cube-cull", "--size", "120x120", "--shot", plain}));
    render(parseCommandLine({"cube-cull", "--size", "120x120", "--multisample", "4", "--shot", smooth}));
    const Picture one = loadPicture(plain), four = loadPicture(smooth);
    EXPECT_GT(countColors(four), countColors(one) + 5) << "mixed at edges";
    EXPECT_EQ(four.at(60, 60), one.at(60, 60));
    EXPECT_EQ(commandInPng(smooth), "cube-cull --size 120x120 --multisample 4");
}

#include "mv/paper/page_numbers.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "mv/paper/docs.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

// A study of two scenes on a processor and on a GPU, and no file.
std::vector<StudyRun> someStudies(const std::string& demo) {
    if (demo != "some") return {};
    StudyRun run;
    run.demo = demo;
    run.renderer = "llvmpipe";
    const auto add = [&](const std::string& scene, const std::string& method, const std::string& p, double fraction,
                         double ms) -> StudyRow& {
        StudyRow row;
        row.scene = scene;
        row.method = method;
        row.parameter = p;
        row.all = {.rms = fraction / 2, .max = 1, .fraction = fraction, .n = 200000};
        row.msMedian = ms;
        row.counts = {{"fragments", 425004}};
        run.rows.push_back(row);
        return run.rows.back();
    };
    add("room", "none", "", 0.025, 4);
    add("room", "map, 1 tap", "256", 0.0008, 5);
    add("room", "map, 1 tap", "512", 0.0004, 6);
    add("room", "map, 1 tap", "1024", 0.0002, 8);
    add("room", "map, 1 tap", "2048", 0, 0).status = "it is too fine";
    add("hall", "none", "", 0, 4);
    run.axis = ErrorAxis::fraction;
    StudyRun gpu = run;
    gpu.renderer = "NVIDIA";
    for (StudyRow& row : gpu.rows) row.msMedian /= 16;
    return {run, gpu};
}

NumberSources& sources() {
    static NumberSources all(someStudies, []() -> Stage& { return stage(); });
    return all;
}

MadeNumber made(const std::string& source) { return sources().make(source); }

std::string marked(const std::string& source, const std::string& text) {
    return "is <!--= " + source + " -->" + text + "<!--/--> wide\n";
}

std::string refusal(const std::string& page) {
    try {
        return withNumbers(page, "demos/some.md", sources());
    } catch (const Error& error) {
        return error.what();
    }
}

}  // namespace

TEST(PageNumbers, have_line_source_and_text) {
    const std::string page = "# a\n" + marked("exact: a - b", "0.4") + "\n" + marked("study a; b; c; ; ms", "296 533");
    const std::vector<PageNumber> numbers = pageNumbers(page, "a.md");
    ASSERT_EQ(numbers.size(), 2U);
    EXPECT_EQ(numbers[0].line, 2);
    EXPECT_EQ(numbers[0].source, "exact: a - b");
    EXPECT_EQ(numbers[1].line, 4);
    EXPECT_EQ(numbers[1].text, "296 533");
    for (const PageNumber& number : numbers) {
        EXPECT_EQ(page.substr(number.from, number.text.size()), number.text);
    }
}

// Each with the file and the line.
TEST(PageNumbers, what_is_no_marker_is_refused_with_its_place) {
    for (const std::string page : {"a <!--= exact: a\n--> 1<!--/-->\n",      // the comment does not end
                                   "a <!--= exact: a -->1\n<!--/-->\n",      // nor does the number
                                   "a 1<!--/-->\n",                          // nothing is opened
                                   "a <!--= exact: a -->one<!--/-->\n",      // no number
                                   "a <!--= exact: a -->1 2<!--/-->\n",      // two
                                   "a <!--= exact: a --><!--/-->\n",         // none
                                   "<!--= exact: a -->1<!--/--> a\n",        // Markdown would take the line for a block
                                   "- <!--= exact: a -->1<!--/--> a\n",      // and the item
                                   "a <!--= run a --b 1; c -->1<!--/-->\n",  // an older Markdown ends the comment at --
                                   "```\na <!--= exact: a -->1<!--/-->\n```\n",  // code is shown as it is
                                   "    a <!--= exact: a -->1<!--/-->\n", "a `b <!--= exact: a -->1<!--/-->`\n"}) {
        SCOPED_TRACE(page);
        try {
            (void)pageNumbers("\n" + page, "demos/a.md");
            FAIL() << "it is no marker";
        } catch (const Error& error) {
            EXPECT_TRUE(std::string(error.what()).starts_with("demos/a.md:")) << error.what();
        }
    }
    EXPECT_EQ(pageNumbers("a `b` <!--= exact: a -->1<!--/-->\n", "a.md").size(), 1U);
    EXPECT_EQ(pageNumbers("| <!--= exact: a -->1<!--/--> |\n", "a.md").size(), 1U) << "a cell is no block";
}

// A number tells what rounds to it.
TEST(PageNumbers, digits_say_how_exact_a_number_is) {
    const auto is = [](double value) { return MadeNumber{value, 0, false}; };
    EXPECT_TRUE(tells("0.014", is(0.0138)));
    EXPECT_TRUE(tells("0.014", is(0.0145)));
    EXPECT_FALSE(tells("0.014", is(0.0146)));
    EXPECT_FALSE(tells("0.0140", is(0.0138)));
    EXPECT_TRUE(tells("4e-7", is(3.6e-7)));
    EXPECT_FALSE(tells("4e-7", is(3.4e-7)));
    EXPECT_TRUE(tells("-0.92", is(-0.924)));
    EXPECT_FALSE(tells("-0.92", is(0.92)));
    EXPECT_TRUE(tells("296 533", is(296533)));
    EXPECT_FALSE(tells("296 533", is(296534)));
    // 0 is exactly that; more digits say how nearly.
    EXPECT_TRUE(tells("0", is(0)));
    EXPECT_FALSE(tells("0", is(1e-9)));
    EXPECT_TRUE(tells("0.00", is(0.004)));
    EXPECT_FALSE(tells("0.00", is(0.006)));
    // A number of another machine differs a little more.
    EXPECT_TRUE(tells("0.014", {0.0146, 0.0002, false}));
    EXPECT_FALSE(tells("a", is(1)));
}

TEST(PageNumbers, are_told_as_before_with_two_digits_at_least) {
    const auto told = [](const std::string& before, double value, bool isCount = false) {
        return toldLike(before, {value, 0, isCount});
    };
    EXPECT_EQ(told("0.5", 0.01384), "0.014");
    EXPECT_EQ(told("0.50", 0.01384), "0.014");
    EXPECT_EQ(told("0.500", 0.01384), "0.0138");
    EXPECT_EQ(told("44", 43.6), "44");
    EXPECT_EQ(told("9", 9.96), "10");
    EXPECT_EQ(told("9.9", 43.61), "44");
    EXPECT_EQ(told("9.9", 1501.2), "1501");
    EXPECT_EQ(told("4e-7", 3.92e-7), "3.9e-7");
    EXPECT_EQ(told("0.1", 3.92e-9), "3.9e-9");
    EXPECT_EQ(told("0.1", 0.000006), "0.0000060");
    EXPECT_EQ(told("-1", -0.9234), "-0.92");
    EXPECT_EQ(told("5", 0), "0");
    EXPECT_EQ(told("5", 12345, true), "12345");
    EXPECT_EQ(told("5 000", 12345, true), "12 345");
    EXPECT_EQ(told("5", 1234567, true), "1 234 567");
    // A number that is told anew holds.
    for (const double value : {0.01384, 43.61, 9.96, 99.96, 1501.2, 3.92e-9, -0.9234, 12345.0, 0.000999}) {
        for (const char* before : {"5", "0.5", "4e-7", "0.500", "1 000"}) {
            EXPECT_TRUE(tells(told(before, value), {value, 0, false})) << before << " " << value;
        }
    }
}

TEST(PageNumbers, come_from_rows_of_studies) {
    EXPECT_DOUBLE_EQ(made("study some; room; map, 1 tap; 256; wrong %").value, 0.08);
    EXPECT_DOUBLE_EQ(made("study some; room; map, 1 tap; 256; rms").value, 0.0004);
    EXPECT_EQ(made("study some; room; map, 1 tap; 256; wrong pixels").value, 160);
    EXPECT_EQ(made("study some; room; map, 1 tap; 256; fragments").value, 425004);
    EXPECT_TRUE(made("study some; room; map, 1 tap; 256; fragments").isCount);
    EXPECT_EQ(made("study some; room; none; ; ms").value, 4);
    EXPECT_EQ(made("study some gpu; room; none; ; ms").value, 0.25);
    // The error halves when p doubles.
    EXPECT_NEAR(made("study some; room; map, 1 tap; ; slope").value, -1, 1e-12);
    // The file is the same everywhere; what a command makes may differ with the driver.
    for (const char* column : {"ms", "fragments", "rms"}) {
        EXPECT_EQ(made(std::string("study some; room; none; ; ") + column).tolerance, 0) << column;
    }
    EXPECT_GT(made("run cube-persp; depth-step").tolerance, 0);
    EXPECT_EQ(made("run cube-persp; draws").tolerance, 0);
}

TEST(PageNumbers, come_from_commands) {
    EXPECT_EQ(made("run cube-cull preset=eye-inside; outside").value, 10);
    EXPECT_EQ(made("run cube-cull spin-x=35 spin-y=30; facing").value, 3);
    EXPECT_EQ(made("run cube-cull spin-x=35 spin-y=30 apart=off; draws").value, 2);
    EXPECT_NE(made("run viewpoints view=5 height=20 frame=100; roll").value,
              made("run viewpoints view=5 height=20 frame=90; roll").value);
}

// Each with the page, the line, and what would have been right.
TEST(PageNumbers, unknown_sources_are_refused_with_their_place) {
    for (const auto& [source, says] : std::vector<std::pair<std::string, std::string>>{
             {"study other; room; none; ; ms",
              "must be one of those committed in docs/errors-and-times, of a processor, other"},
             {"study other gpu; room; none; ; ms", "of a gpu, other"},
             {"study some tpu; room; none; ; ms", "must be study DEMO, or study DEMO gpu"},
             {"study some; attic; none; ; ms", "scene: must be one of 'room', 'hall', 'attic'"},
             {"study some; room; volumes; ; ms", "method: must be one of 'none', 'map, 1 tap', 'volumes'"},
             {"study some; room; map, 1 tap; 300; ms", "p: must be one of '256', '512', '1024', '2048', '300'"},
             {"study some; room; map, 1 tap; 2048; ms", "must have been measured, it is too fine"},
             {"study some; room; none; ; triangles", "column: must be one of 'rms'"},
             {"study some; room; none; ; slope", "needs three rows"},
             {"study some; room; none; ms", "must be study DEMO; SCENE; METHOD; P; COLUMN"},
             {"run cube-cull; angle", "readout: must be one of"},
             {"run cube-cull spim-x=3; facing", "--spim-x"},
             {"run cube-cull spin-x=many; facing", "--spin-x"},
             {"run cube-cull", "must be run DEMO ...; READOUT"},
             {"run no-demo; facing", "no-demo"},
             {"exact: a - b", "must begin with 'study' or 'run'"},
             {"remembered", "must begin with"}}) {
        SCOPED_TRACE(source);
        const std::string text = refusal("# a\n\n" + marked(source, "1"));
        EXPECT_TRUE(text.starts_with("demos/some.md:3, '" + source + "': ")) << text;
        EXPECT_NE(text.find(says), std::string::npos) << text;
    }
}

TEST(PageNumbers, are_told_anew_where_they_no_longer_hold) {
    // One digit is enough while it holds, though a number that is told anew has two.
    const std::string holds = marked("study some; room; map, 1 tap; 256; wrong %", "0.1"),
                      stale = marked("study some; room; none; ; wrong %", "3.3");
    EXPECT_EQ(withNumbers("a\n" + holds + "b\n", "a.md", sources()), "a\n" + holds + "b\n");
    EXPECT_EQ(withNumbers(stale + holds, "a.md", sources()),
              marked("study some; room; none; ; wrong %", "2.5") + holds);
}

TEST(PageNumbers, studies_are_read_from_the_tree) {
    const auto runs = studiesInTree(MVGL_SOURCE_DIR, "shadow-map");
    ASSERT_EQ(runs.size(), 2U);
    EXPECT_EQ(runs[0].demo, "shadow-map");
    EXPECT_EQ(drawerOf(runs[1].renderer), Drawer::gpu);
    EXPECT_TRUE(studiesInTree(MVGL_SOURCE_DIR, "cube-ortho").empty());
    const std::vector<std::string> pages = pagesWithNumbers(MVGL_SOURCE_DIR);
    EXPECT_NE(std::find(pages.begin(), pages.end(), "docs/shadows-compared.md"), pages.end());
    EXPECT_NE(std::find(pages.begin(), pages.end(), "demos/z-buffer/z-buffer.md"), pages.end());
    EXPECT_EQ(std::find(pages.begin(), pages.end(), "CONTRIBUTING.md"), pages.end());
}

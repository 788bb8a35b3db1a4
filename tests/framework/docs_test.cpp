#include "mv/paper/docs.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "mv/demo/chapters.h"
#include "mv/run/command_line.h"
#include "support/temporary_folder.h"

using namespace mv;

TEST(Docs, tables_stand_between_their_markers) {
    const DemoInfo& info = findDemo("cube-cull");
    const std::string page = "# a\nbefore\n<!-- knobs -->\nold\n<!-- /knobs -->\nafter\n";
    const std::string made = lessonPage(page, info);
    EXPECT_EQ(made.find("\nold\n"), std::string::npos);
    EXPECT_NE(made.find("| `--cull` | none \\| back \\| front \\| both | back | which faces to discard |"),
              std::string::npos)
        << made;
    EXPECT_NE(made.find("| `facing` |"), std::string::npos);
    EXPECT_NE(made.find("drag to the right: `spin-y` -1 a pixel"), std::string::npos);
    EXPECT_EQ(made.substr(0, 11), page.substr(0, 11));
    EXPECT_EQ(made.substr(made.size() - 6), "after\n");
    EXPECT_EQ(lessonPage(made, info), made) << "made once, it stays";
    EXPECT_THROW(lessonPage("no markers", info), Error);
}

TEST(Docs, the_catalogue_names_every_demo) {
    const std::string page = cataloguePage();
    for (const DemoInfo& info : catalogue()) {
        EXPECT_NE(page.find("[" + info.name + "](../" + info.page + ")"), std::string::npos);
        EXPECT_NE(page.find(info.lookFor), std::string::npos);
        EXPECT_FALSE(info.sentence.empty());
        EXPECT_FALSE(info.chapter.empty());
        EXPECT_GT(info.number, 0);
    }
}

// One heading a chapter, in the chapters' order; the same order in every list.
TEST(Docs, chapters_are_grouped) {
    const std::vector<Chapter> chapters = catalogueByChapter();
    std::vector<std::string> headings, demos;
    for (const Chapter& chapter : chapters) {
        headings.push_back(chapter.name);
        int last = 0;
        for (const DemoInfo* info : chapter.demos) {
            EXPECT_EQ(info->chapter, chapter.name) << info->name;
            EXPECT_GT(info->number, last) << info->name;
            last = info->number;
            demos.push_back(info->name);
        }
        EXPECT_GT(last, 0) << chapter.name << ": no chapter is empty";
    }
    EXPECT_EQ(headings, std::vector<std::string>(courseChapters.begin(), courseChapters.end()));
    std::vector<std::string> all;
    for (const DemoInfo& info : catalogue()) all.push_back(info.name);
    EXPECT_EQ(demos, all);
    // The page has these headings, each once, and below them these demos.
    std::vector<std::string> onPage, demosOnPage;
    std::istringstream page(cataloguePage());
    for (std::string line; std::getline(page, line);) {
        if (line.starts_with("## ")) onPage.push_back(line.substr(3));
        if (line.starts_with("### [")) demosOnPage.push_back(line.substr(5, line.find(']') - 5));
    }
    EXPECT_EQ(onPage, headings);
    EXPECT_EQ(demosOnPage, all);
}

TEST(Docs, a_chapter_that_is_none_is_refused) {
    const std::size_t before = catalogue().size();
    DemoInfo info;
    info.name = "stray";
    info.chapter = "Shadow";
    try {
        addDemo(info, {}, "", nullptr);
        FAIL() << "there is no such chapter";
    } catch (const Error& error) {
        EXPECT_EQ(
            std::string(error.what()),
            "demo stray: must have no chapter or one of mv/demo/chapters.h ('Viewing and projection', "
            "'Stereo and hidden surfaces', 'Shadows', 'Motion', 'Light, colour and texture', 'Surfaces, mirrors and "
            "stages', 'Rays, clipping and pixels'), 'Shadow'");
    }
    EXPECT_EQ(catalogue().size(), before);
    info.chapter = courseChapters.front();
    EXPECT_EQ(chapterPlace(info), 0U);
    info.chapter = "";  // as a demo that is made elsewhere has it, which comes last
    EXPECT_EQ(chapterPlace(info), courseChapters.size());
}

TEST(Docs, readme_has_all_demos_between_its_markers) {
    const std::string page = "before\n<!-- demos -->\nold\n<!-- /demos -->\nafter\n", made = readmePage(page);
    EXPECT_EQ(made.find("\nold\n"), std::string::npos);
    EXPECT_TRUE(made.starts_with("before\n<!-- demos -->\n") && made.ends_with("<!-- /demos -->\nafter\n")) << made;
    for (const DemoInfo& info : catalogue()) {
        EXPECT_NE(made.find("| [" + info.name + "](" + info.page + ") | " + info.sentence + " |\n"), std::string::npos)
            << info.name;
    }
    EXPECT_EQ(readmePage(made), made) << "made once, it stays";
    EXPECT_THROW(readmePage("no markers"), Error);
}

// README's table of flags says what --help says: the same flags, with values of the same kind.
TEST(Docs, readme_has_the_flags_of_help) {
    // Of --help "--shot FILE", "--headless[=HOST]" ...: what stands before two spaces in a line of a flag that is no knob's.
    const std::string help = parseCommandLine({"--help"}).text;
    std::set<std::string> ofHelp;
    std::istringstream helpLines(help);
    for (std::string line; std::getline(helpLines, line);) {
        if (!line.starts_with("  --")) continue;
        EXPECT_EQ(line.find_first_not_of(' ', line.find("  ", 2)), 30U) << "the second column: " << line;
        ofHelp.insert(line.substr(2, line.find("  ", 2) - 2));
    }
    EXPECT_GT(ofHelp.size(), 15U);
    // Of README: in backquotes in the first column, after the program's name where one stands there.
    std::ifstream readme(std::filesystem::path(MVGL_SOURCE_DIR) / "README.md");
    std::set<std::string> ofReadme;
    bool inTable = false;
    for (std::string line; std::getline(readme, line);) {
        if (line.starts_with("| flag |")) inTable = true;
        if (line.empty()) inTable = false;
        if (!inTable || !line.starts_with("| `")) continue;
        const std::string column = line.substr(2, line.find(" | ", 2) - 2);
        for (std::size_t at = column.find('`'); at != std::string::npos;) {
            const auto end = column.find('`', at + 1);
            const std::string span = column.substr(at + 1, end - at - 1);
            // "mvgl --audit --all" has two, of which no value has a space
            for (std::size_t flag = span.find("--"); flag != std::string::npos;) {
                const auto next = span.find(" --", flag);
                ofReadme.insert(span.substr(flag, next - flag));
                flag = next == std::string::npos ? next : next + 1;
            }
            at = column.find('`', end + 1);
        }
    }
    EXPECT_EQ(ofReadme.erase("--KNOB VALUE"), 1U);
    EXPECT_EQ(ofReadme.erase("--vary KNOB=a,b,c"), 1U) << "the other form of --vary";
    EXPECT_EQ(ofReadme, ofHelp);
}

TEST(Docs, every_missing_page_is_named_at_once) {
    const TemporaryFolder folder;
    for (const DemoInfo& info : catalogue()) {
        if (info.name == "cube-cull" || info.name == "shadow") continue;
        std::filesystem::create_directories((folder.path() / info.page).parent_path());
        std::ofstream(folder.path() / info.page) << "a page\n";
    }
    try {
        writeDocs(folder.path().string());
        FAIL() << "two pages are missing";
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()), "docs in " + folder.path().string() +
                                                 ": each demo must have its page, missing: " +
                                                 findDemo("cube-cull").page + ", " + findDemo("shadow").page);
    }
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "docs"));  // and nothing was written
}

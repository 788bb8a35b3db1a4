#include "mv/run/docs.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "support/temporary_folder.h"

using namespace mv;

TEST(Docs, tables_stand_between_their_markers) {
    const DemoInfo& info = findDemo("cube-cull");
    const std::string page = "# a\nbefore\n<!-- knobs -->\nold\n<!-- /knobs -->\nafter\n";
    const std::string made = lessonPage(page, info);
    EXPECT_EQ(made.find("old"), std::string::npos);
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
        EXPECT_NE(page.find("[" + info.name + "](../demos/" + info.name + ".md)"), std::string::npos);
        EXPECT_NE(page.find(info.lookFor), std::string::npos);
        EXPECT_FALSE(info.sentence.empty());
        EXPECT_FALSE(info.chapter.empty());
        EXPECT_GT(info.number, 0);
    }
}

TEST(Docs, every_missing_page_is_named_at_once) {
    const TemporaryFolder folder;
    const auto pages = folder.path() / "demos";
    std::filesystem::create_directory(pages);
    for (const DemoInfo& info : catalogue()) {
        if (info.name != "cube-cull" && info.name != "shadow") std::ofstream(pages / (info.name + ".md")) << "a page\n";
    }
    try {
        writeDocs(folder.path().string());
        FAIL() << "two pages are missing";
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()),
                  "docs in " + folder.path().string() +
                      ": each demo must have its page, missing: demos/cube-cull.md, demos/shadow.md");
    }
    EXPECT_FALSE(std::filesystem::exists(folder.path() / "docs"));  // and nothing was written
}

// What must agree between the files of a demo: claims and their tests, pages and their commands, shaders and ES.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "mv/gl/program.h"
#include "mv/image/compare.h"
#include "mv/image/load.h"
#include "mv/run/audit.h"
#include "mv/run/docs.h"
#include "mv/run/render.h"
#include "support/demo_run.h"

using namespace mv;

namespace {

namespace fs = std::filesystem;
const fs::path source = MVGL_SOURCE_DIR;

std::string fileText(const fs::path& path) {
    std::ifstream stream(path, std::ios::binary);
    EXPECT_TRUE(stream) << path;
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::set<std::string> matches(const std::string& text, const std::regex& pattern) {
    std::set<std::string> found;
    for (std::sregex_iterator i(text.begin(), text.end(), pattern), end; i != end; ++i) found.insert((*i)[1]);
    return found;
}

}  // namespace

TEST(Claims, each_has_a_test_and_each_test_a_claim) {
    for (const DemoInfo& info : catalogue()) {
        SCOPED_TRACE(info.name);
        const auto claims =
            matches(fileText(source / "demos" / (info.name + ".cpp")), std::regex(R"(// - \[([a-z0-9-]+)\])"));
        auto tests =
            matches(fileText(source / "tests/claims" / (info.name + ".cpp")), std::regex(R"(TEST\(\w+, (\w+)\))"));
        std::set<std::string> ids;
        for (std::string id : tests) {
            std::replace(id.begin(), id.end(), '_', '-');
            ids.insert(id);
        }
        EXPECT_FALSE(claims.empty());
        EXPECT_EQ(claims, ids);
    }
}

TEST(Pages, tables_are_fresh) {
    EXPECT_EQ(fileText(source / "docs/demos.md"), cataloguePage()) << "./run --docs . makes it anew";
    for (const DemoInfo& info : catalogue()) {
        const std::string page = fileText(source / "demos" / (info.name + ".md"));
        EXPECT_EQ(page, lessonPage(page, info)) << info.name << ": ./run --docs . makes it anew";
    }
}

// Words exactly; numbers within 1 %, which is what drivers differ by in the samples on edges.
TEST(Pages, needs_are_fresh) {
    const auto wordsAndNumbers = [](const std::string& page) {
        static const std::regex number("[0-9]+");
        std::vector<double> numbers;
        for (std::sregex_iterator i(page.begin(), page.end(), number), end; i != end; ++i) {
            numbers.push_back(std::stod(i->str()));
        }
        return std::pair(std::regex_replace(page, number, "#"), numbers);
    };
    const auto [words, numbers] = wordsAndNumbers(fileText(source / "docs/needs.md"));
    const auto [newWords, newNumbers] = wordsAndNumbers(needsPage());
    EXPECT_EQ(words, newWords) << "./run --docs . makes it anew";
    ASSERT_EQ(numbers.size(), newNumbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_NEAR(numbers[i], newNumbers[i], 0.01 * numbers[i]);
}

TEST(Pages, strip_is_fresh) {
    const Picture committed = loadPicture(source / "docs/strip.png");
    const Difference difference = compare(committed, pictureStrip());
    // As for the golden pictures on another driver; shrinking averages the difference away, never makes it larger.
    EXPECT_LE(difference.maximum, 3);
    EXPECT_LE(difference.fraction, 0.001);
}

// The links of the pages lead to files that are there.
TEST(Pages, links_lead_somewhere) {
    std::vector<fs::path> pages{source / "README.md", source / "CONTRIBUTING.md", source / "docs/demos.md"};
    for (const DemoInfo& info : catalogue()) pages.push_back(source / "demos" / (info.name + ".md"));
    const std::regex link(R"(\]\(([^)#]+)[^)]*\))");
    for (const fs::path& page : pages) {
        const auto targets = matches(fileText(page), link);
        for (const std::string& target : targets) {
            if (target.rfind("http", 0) == 0) continue;
            EXPECT_TRUE(fs::exists(page.parent_path() / target)) << page << ": " << target;
        }
    }
}

// The shaders of every demo that says so also compile and link as GLSL ES 3.00, which is WebGL 2's language.
TEST(Shaders, compile_as_es) {
    std::vector<std::string> notes;
    const auto context = openHeadless(HostKind::egl, {.version = 30, .es = true}, notes);
    loadFunctions([&](const char* name) { return context->address(name); });
    ASSERT_TRUE(isEs());
    int programs = 0;
    for (const DemoInfo& info : catalogue()) {
        if (!info.needs.beyondEs.empty()) continue;
        EXPECT_NO_THROW(Program{info.name}) << info.name;
        ++programs;
    }
    EXPECT_GT(programs, 0);
    EXPECT_EQ(liveObjects(), 0);
    EXPECT_TRUE(takeErrors().empty());
}

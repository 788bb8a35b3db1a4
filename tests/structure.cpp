// What must agree between the files of a demo: claims and their tests, pages and their commands, shaders and ES.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <memory>
#include <regex>
#include <set>

#include "mv/gl/beyond_es.h"
#include "mv/gl/program.h"
#include "mv/gl/shader_source.h"
#include "mv/image/compare.h"
#include "mv/image/load.h"
#include "mv/paper/audit.h"
#include "mv/paper/docs.h"
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

// What is written of a demo: its file, or those of its folder.
std::string demoText(const std::string& name) {
    if (!fs::is_directory(source / "demos" / name)) return fileText(source / "demos" / (name + ".cpp"));
    std::string text;
    for (const auto& entry : fs::directory_iterator(source / "demos" / name)) {
        if (entry.path().extension() != ".md") text += fileText(entry.path());
    }
    return text;
}

std::set<std::string> matches(const std::string& text, const std::regex& pattern) {
    std::set<std::string> found;
    for (std::sregex_iterator i(text.begin(), text.end(), pattern), end; i != end; ++i) found.insert((*i)[1]);
    return found;
}

// "cube-cull" as "CubeCull".
std::string camelCase(const std::string& name) {
    std::string text;
    bool begins = true;
    for (const char c : name) {
        if (c != '-') text += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        begins = c == '-';
    }
    return text;
}

// The links of a page lead to files that are there.
void expectLinksLead(const fs::path& page) {
    const auto targets = matches(fileText(page), std::regex(R"(\]\(([^)#]+)[^)]*\))"));
    for (const std::string& target : targets) {
        if (target.rfind("http", 0) == 0) continue;
        EXPECT_TRUE(fs::exists(page.parent_path() / target)) << page << ": " << target;
    }
}

// What belongs to one demo.
class OfDemo : public testing::TestWithParam<std::string> {};

}  // namespace

TEST_P(OfDemo, each_claim_has_a_test_and_each_test_a_claim) {
    const fs::path ofFolder = source / "tests" / GetParam() / "claims.cpp";
    const std::string text =
        fileText(fs::exists(ofFolder) ? ofFolder : source / "tests/claims" / (GetParam() + ".cpp"));
    // In the demo's head; a lesson that is a folder has them in the head of their tests
    const auto claims =
        matches(fs::exists(ofFolder) ? text : demoText(GetParam()), std::regex(R"(// - \[([a-z0-9-]+)\])"));
    const auto tests = matches(text, std::regex(R"(TEST\(\w+, (\w+)\))"));
    std::set<std::string> ids;
    for (std::string id : tests) {
        std::replace(id.begin(), id.end(), '_', '-');
        ids.insert(id);
    }
    EXPECT_FALSE(claims.empty());
    EXPECT_EQ(claims, ids);
    // By the suite's name `./test --only NAME` and a reader find them: cube-cull has CubeCull.
    EXPECT_EQ(matches(text, std::regex(R"(TEST\((\w+), \w+\))")), std::set<std::string>{camelCase(GetParam())});
}

TEST_P(OfDemo, the_page_has_fresh_tables_and_links_that_lead_somewhere) {
    const fs::path file = source / findDemo(GetParam()).page;
    const std::string page = fileText(file);
    EXPECT_EQ(page, lessonPage(page, findDemo(GetParam()))) << "./run --docs . makes it anew";
    expectLinksLead(file);
}

INSTANTIATE_TEST_SUITE_P(, OfDemo, testing::ValuesIn(mv::test::demoNames()), mv::test::parameterWord);

TEST(Pages, tables_are_fresh) {
    EXPECT_EQ(fileText(source / "docs/demos.md"), cataloguePage()) << "./run --docs . makes it anew";
    const std::string readme = fileText(source / "README.md");
    EXPECT_EQ(readme, readmePage(readme)) << "README.md: ./run --docs . makes it anew";
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

TEST(Pages, links_lead_somewhere) {
    for (const char* page : {"README.md", "CONTRIBUTING.md", "docs/demos.md"}) expectLinksLead(source / page);
}

// ---- OpenGL ES 3.0, which is WebGL 2's: in processes of their own, since a program has one table of GL functions.

std::unique_ptr<Context> openEs() {
    std::vector<std::string> notes;
    return openHeadless(HostKind::egl, {.version = 30, .es = true}, notes);
}

std::vector<std::string> filesEndingIn(const std::string& end) {
    std::vector<std::string> names;
    for (const std::string& name : shaderFileNames()) {
        if (name.ends_with(end)) names.push_back(name);
    }
    return names;
}

class Shaders : public testing::TestWithParam<std::string> {};

// Every program of a demo compiles and links as GLSL ES 3.00; what it samples is of high precision, as in OpenGL.
TEST_P(Shaders, compile_as_es) {
    const auto context = openEs();
    loadFunctions([&](const char* name) { return context->address(name); });
    ASSERT_TRUE(isEs());
    int compiled = 0;
    for (const std::string& file : filesEndingIn(".vert")) {
        const std::string stem = file.substr(0, file.size() - 5);
        if (stem.substr(0, stem.find_first_of("/.")) != GetParam()) continue;
        bool needsMore = false;  // a stage that ES lacks: said, before anything is compiled
        for (const char* ending : {".geom", ".tesc", ".tese"}) needsMore |= !filesEndingIn(stem + ending).empty();
        if (needsMore) {
            EXPECT_THROW(Program{stem}, Error) << stem;
            continue;
        }
        EXPECT_NO_THROW(Program{stem}) << stem;
        ++compiled;
    }
    // One that draws lines and words alone has the library's programs.
    const bool hasPrograms = demoText(GetParam()).find("Program") != std::string::npos;
    EXPECT_EQ(compiled > 0, hasPrograms) << "shaders/" << GetParam()
                                         << ".vert and .frag must be there for a demo with programs";
    EXPECT_EQ(liveObjects(), 0);
    EXPECT_TRUE(takeErrors().empty());

    const std::string begins = assembleShaderText("any.frag", "").text;
    for (const std::string& file : shaderFileNames()) {
        for (const std::string& type : matches(builtInShader(file), std::regex("\\b([iu]?sampler\\w+) "))) {
            EXPECT_NE(begins.find("precision highp " + type + ";"), std::string::npos) << type << " in " << file;
        }
    }
}

// Whether the picture is said to have been drawn without a whole stage: then it is another one.
bool lacksAStage(const std::vector<std::string>& messages) {
    return std::any_of(messages.begin(), messages.end(), [](const std::string& message) {
        for (const char* stage : {beyond_es::geometryShaders, beyond_es::tessellation, beyond_es::computeShaders}) {
            if (message.find(std::string("has no ") + stage) != std::string::npos) return true;
        }
        return false;
    });
}

// A demo draws in ES what it draws in OpenGL, as it opens and with each choice and switch of its knobs.
TEST_P(Shaders, draw_the_same_in_es) {
    const DemoInfo& info = findDemo(GetParam());
    std::map<std::string, Picture> right;
    const auto drawAll = [&](Stage& stage, const std::function<void(const std::string&, const Picture&)>& drawn) {
        stage.open(info, test::hasPasses(info) ? 32 : 128, test::hasPasses(info) ? 24 : 96);
        const auto draw = [&](const std::string& setting) {
            SCOPED_TRACE(info.name + " " + setting);
            try {
                stage.draw(1, true);
                drawn(setting, stage.picture());
            } catch (const Error& error) {
                ADD_FAILURE() << error.what();
            }
        };
        draw("");
        for (Knob* knob : stage.demo().knobs()) {
            const std::string before = knob->text();
            for (const Option& option : knob->options()) {
                knob->parse(option.word);
                try {
                    stage.demo().check();
                    draw("--" + knob->name() + " " + option.word);
                } catch (const Error&) {  // refused, on both
                }
            }
            knob->parse(before);
        }
        stage.close();
    };
    {
        HeadlessStage headless(HostKind::egl);
        drawAll(headless.stage, [&](const std::string& setting, const Picture& picture) { right[setting] = picture; });
    }
    const auto context = openEs();
    Stage stage(*context);
    ASSERT_TRUE(isEs());
    drawAll(stage, [&](const std::string& setting, const Picture& picture) {
        ASSERT_TRUE(right.contains(setting)) << setting;
        if (lacksAStage(stage.notes().messages)) return;
        EXPECT_EQ(compare(right.at(setting), picture).beyond, 0) << setting;
    });
}

INSTANTIATE_TEST_SUITE_P(, Shaders, testing::ValuesIn(mv::test::demoNames()), mv::test::parameterWord);

// Depths are compared by shaders/include/shadow-map.glsl, which minds what is beyond the map's end.
TEST(ShaderFiles, compare_depths_in_one_place) {
    for (const std::string& file : shaderFileNames()) {
        const std::string text = builtInShader(file);
        if (file == "include/shadow-map.glsl" || text.find("sampler2DShadow") == std::string::npos) continue;
        EXPECT_EQ(text.find("texture"), std::string::npos) << file;
    }
}

// The words of pages: each command line does what a reader who types it expects, or the page says what else, and each measured
// number is what its marker (mv/paper/page_numbers.h) makes. The words that must agree between pages, claims, their tests and shaders.
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "mv/gl/shader_source.h"
#include "mv/image/compare.h"
#include "mv/image/load.h"
#include "mv/paper/audit.h"
#include "mv/paper/docs.h"
#include "mv/paper/page_numbers.h"
#include "mv/run/command_line.h"
#include "mv/study/data.h"
#include "mv/study/study.h"
#include "support/demo_run.h"
#include "support/process.h"

using namespace mv;
using namespace mv::test;

namespace {

namespace fs = std::filesystem;
const fs::path source = MVGL_SOURCE_DIR;

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// One "./run ..." of a page, and what the remark after its # says will come of it:
//     # status 1: WORDS     it ends with that status (2 for what a flag refuses), and its error has these words
//     # says: WORDS         it ends well, and what it prints has these words
//     # the same picture    what it sets cannot be seen
// Any other remark is for the reader alone.
struct PageLine {
    int number = 0;
    std::string text, remark;

    int status() const { return remark.starts_with("status ") ? std::atoi(remark.c_str() + 7) : 0; }
    std::string words() const {
        const auto colon = remark.find(": ");
        const bool expects = remark.starts_with("status ") || remark.starts_with("says: ");
        return expects && colon != std::string::npos ? remark.substr(colon + 2) : "";
    }
    bool isSamePicture() const { return remark.starts_with("the same picture"); }
};

// In a block of code a line that begins so; in the text what stands in backquotes.
std::vector<PageLine> commandsOf(const fs::path& page) {
    std::ifstream stream(page);
    EXPECT_TRUE(stream) << page;
    std::vector<PageLine> commands;
    bool inBlock = false;
    int number = 0;
    for (std::string line; std::getline(stream, line);) {
        ++number;
        if (line.starts_with("```")) {
            inBlock = !inBlock;
        } else if (inBlock && line.starts_with("./run ")) {
            const auto sign = std::min(line.find(" # "), line.size());
            commands.push_back({number, line.substr(0, sign), sign == line.size() ? "" : line.substr(sign + 3)});
        } else if (!inBlock) {
            for (std::size_t at = line.find("`./run "); at != std::string::npos; at = line.find("`./run ", at + 1)) {
                commands.push_back({number, line.substr(at + 1, line.find('`', at + 1) - at - 1), ""});
            }
        }
    }
    return commands;
}

std::vector<std::string> wordsOf(const std::string& text) {
    std::vector<std::string> words;
    std::istringstream stream(text);
    for (std::string word; stream >> word;) words.push_back(word);
    return words;
}

// The arguments of mvgl to try the command, in moments and without a window, and how it was understood.
struct Trial {
    std::vector<std::string> words;
    Command command;  // of the page's own words
    bool isRun =
        true;  // false where understanding it was all: a menu, or a study of minutes that has a test of its own
    std::string picture;  // the file that it is to write; "" for none
};

Trial trialOf(const PageLine& line, bool atItsOwnSize = false) {
    Trial trial;
    trial.words = wordsOf(line.text);
    trial.words.erase(trial.words.begin());
    if (!trial.words.empty() && (trial.words.front() == "DEMO" || trial.words.front() == "<name>")) {
        trial.words.front() = "shadow-map";
    }
    if (line.status() == 2) return trial;  // not to be understood: the program says why
    Command& command = trial.command;
    command = parseCommandLine(trial.words);
    const auto add = [&](const std::vector<std::string>& more) {
        trial.words.insert(trial.words.end(), more.begin(), more.end());
    };
    if (command.action == Action::window) {
        trial.isRun = command.demo != nullptr;  // else the menu
        std::erase(trial.words, "--window");
        // A window may show a report, too; a picture of two settings has none.
        if (command.compareKnob.empty() || command.report == ReportForm::none) add({"--shot", "window.png"});
        trial.picture = "window.png";
    } else if (!command.shot.empty()) {
        trial.picture = frameFile(command.shot, command.firstFrame);
    }
    if (command.action == Action::docs) trial.isRun = false;  // it writes a tree's pages, and here is none
    if (command.action == Action::study && command.vary.empty()) {
        (void)studyOf(*command.demo, command.knobs, command.vary);
        trial.isRun = false;
    }
    const bool draws =
        command.action == Action::window || command.action == Action::render || command.action == Action::study;
    if (draws && command.width == 0 && !atItsOwnSize && !isLong()) add({"--size", "96x72"});
    return trial;
}

ProcessResult tried(const TemporaryFolder& folder, std::vector<std::string> words) {
    words.insert(words.begin(), program("mvgl"));
    std::error_code isThere;
    std::filesystem::create_directory_symlink(MVGL_SOURCE_DIR "/assets", folder.path() / "assets", isThere);
    return runProcess(words, {.folder = folder.path().string(), .environment = {"DISPLAY", "WAYLAND_DISPLAY"}});
}

// The left and the middle one of the three pictures that --compare lays beside each other, 4 pixels apart.
bool showsTwoPictures(const Picture& sheet) {
    const int width = (sheet.width - 8) / 3;
    constexpr int labels = 48;  // the labels above them differ in any case; a line of words is half as high
    for (int y = labels; y < sheet.height; ++y) {
        for (int x = 0; x < width; ++x) {
            if (sheet.at(x, y) != sheet.at(x + width + 4, y)) return true;
        }
    }
    return false;
}

// The picture of a demo with nothing set, in the size of another picture. Kept: each command of a page is compared with it.
const Picture& asItOpens(const std::string& demo, const Picture& like) {
    static std::map<std::string, Picture> known;
    const std::string size = std::to_string(like.width) + "x" + std::to_string(like.height);
    const auto [place, isNew] = known.try_emplace(demo + " " + size);
    if (isNew) {
        const TemporaryFolder folder;
        EXPECT_EQ(tried(folder, {demo, "--shot", "plain.png", "--size", size}).status, 0);
        place->second = loadPicture(folder.path() / "plain.png");
    }
    return place->second;
}

// Whether the picture that the command drew is another one than its demo draws with nothing set; of two that are compared,
// whether they differ.
bool showsWhatItSets(const Trial& trial, const TemporaryFolder& folder) {
    const Picture picture = loadPicture(folder.path() / trial.picture);
    if (!trial.command.compareKnob.empty()) return showsTwoPictures(picture);
    return picture != asItOpens(trial.command.demo->name, picture);
}

bool showsWhatItSetsAtItsOwnSize(const PageLine& line) {
    const Trial trial = trialOf(line, true);
    const TemporaryFolder folder;
    EXPECT_EQ(tried(folder, trial.words).status, 0);
    return showsWhatItSets(trial, folder);
}

// A line for each row of a study that a method was refused or failed in.
std::string refusedRows(const StudyRun& run) {
    std::string rows;
    for (const StudyRow& row : run.rows)
        if (!row.ok()) rows += row.scene + ", " + row.method + ", " + row.parameter + "\n";
    return rows;
}

// The result that a command which ends well is to have, by what it asks for.
void expectOutcome(const PageLine& line, const Trial& trial, const ProcessResult& run, const TemporaryFolder& folder) {
    const Command& command = trial.command;
    EXPECT_FALSE(has(run.err, "does nothing in these settings")) << run.err;
    EXPECT_TRUE(!run.out.empty() || folder.entries() > 0) << "it says or writes something";
    if (command.action == Action::audit) {
        EXPECT_TRUE(has(run.out, "first frame")) << run.out;
    }
    if (command.report == ReportForm::text) {
        const auto demo = command.demo->make();
        for (const Readout* readout : demo->readouts()) {
            EXPECT_TRUE(has(run.out, "readout   " + readout->name())) << run.out;
        }
    }
    if (command.action == Action::study) {
        for (const char* name : {"study.csv", "study.svg"}) {
            EXPECT_TRUE(fs::exists(folder.path() / command.folder / name)) << name;
        }
        const StudyRun study = readStudy(fileText(folder.path() / command.folder / "study.csv"));
        EXPECT_EQ(refusedRows(study), "");
    }
    if (trial.picture.empty()) return;
    ASSERT_TRUE(fs::exists(folder.path() / trial.picture)) << trial.picture;
    const bool sets = !command.knobs.empty() || command.firstFrame > 1 || !command.compareKnob.empty();
    if (!sets) return;
    // A change that is too fine for a small picture shows in one of the demo's own size.
    const bool isAnother = showsWhatItSets(trial, folder) || showsWhatItSetsAtItsOwnSize(line);
    EXPECT_NE(isAnother, line.isSamePicture()) << "what it sets must be seen, or the page say: # the same picture";
}

// The page of the shadows' methods side by side, and others below docs that tell numbers.
std::vector<std::string> pagesOfNumbers() { return pagesWithNumbers(MVGL_SOURCE_DIR); }

std::vector<std::string> pages() {
    std::vector<std::string> names{"README.md", "CONTRIBUTING.md"};
    for (const DemoInfo& info : catalogue()) names.push_back(info.page);
    for (const std::string& page : pagesOfNumbers()) {
        if (page.starts_with("docs/")) names.push_back(page);
    }
    return names;
}

std::string pageWord(const testing::TestParamInfo<std::string>& page) {
    std::string word = fs::path(page.param).stem().string();
    std::replace(word.begin(), word.end(), '-', '_');
    return word;
}

// The commands of ./run that need no program: the tests `site` and `scripts.site` try it.
bool isOfRunItself(const std::string& command) { return command.starts_with("./run --site"); }

class Pages : public testing::TestWithParam<std::string> {};

// ---- What must agree between the files of a demo

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

class OfDemo : public testing::TestWithParam<std::string> {};

}  // namespace

TEST_P(Pages, every_command_does_what_it_says) {
    const fs::path page = fs::path(MVGL_SOURCE_DIR) / GetParam();
    const std::vector<PageLine> commands = commandsOf(page);
    if (GetParam().starts_with("demos/")) {
        EXPECT_GE(commands.size(), 3U) << "a lesson has three things to try";
    }
    for (const PageLine& line : commands) {
        if (isOfRunItself(line.text)) continue;
        SCOPED_TRACE(GetParam() + ":" + std::to_string(line.number) + ": " + line.text);
        std::optional<Trial> trial;
        try {
            trial = trialOf(line);
        } catch (const std::exception& error) {
            ADD_FAILURE() << error.what();
        }
        if (!trial || !trial->isRun) continue;
        const TemporaryFolder folder;
        const ProcessResult run = tried(folder, trial->words);
        EXPECT_EQ(run.status, line.status()) << run.err;
        EXPECT_TRUE(has(run.status == 0 ? run.out + run.err : run.err, line.words())) << run.out << run.err;
        if (run.status == 0 && line.status() == 0) expectOutcome(line, *trial, run, folder);
    }
}

// Errors and counts are made anew; times are those of the committed study.
TEST_P(Pages, every_marked_number_is_made) {
    if (GetParam() == "CONTRIBUTING.md") return;  // it shows markers as code
    const std::string page = fileText(fs::path(MVGL_SOURCE_DIR) / GetParam());
    NumberSources sources([](const std::string& demo) { return studiesInTree(MVGL_SOURCE_DIR, demo); },
                          []() -> Stage& { return stage(); });
    int made = 0;
    for (const PageNumber& number : pageNumbers(page, GetParam())) {
        SCOPED_TRACE(GetParam() + ":" + std::to_string(number.line) + ": " + number.source);
        try {
            const MadeNumber is = sources.make(number.source);
            ++made;
            EXPECT_TRUE(tells(number.text, is)) << "it says " << number.text << ", it is " << numberText(is.value)
                                                << "; ./run --docs . writes " << toldLike(number.text, is);
        } catch (const Error& error) {
            ADD_FAILURE() << error.what();
        }
    }
    std::printf("%s: %d numbers made anew\n", GetParam().c_str(), made);
}

INSTANTIATE_TEST_SUITE_P(All, Pages, testing::ValuesIn(pages()), pageWord);

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
    // By the suite's name `./test --only NAME` and a reader find them: cube-cull has CubeCull, and CubeCullFull what ./test leaves to --full.
    const std::string suite = camelCase(GetParam());
    for (const std::string& is : matches(text, std::regex(R"(TEST\((\w+), \w+\))"))) {
        EXPECT_TRUE(is == suite || is == suite + "Full") << is;
    }
}

TEST_P(OfDemo, the_page_has_fresh_tables_and_links_that_lead_somewhere) {
    const fs::path file = source / findDemo(GetParam()).page;
    const std::string page = fileText(file);
    EXPECT_EQ(page, lessonPage(page, findDemo(GetParam()))) << "./run --docs . makes it anew";
    expectLinksLead(file);
}

INSTANTIATE_TEST_SUITE_P(All, OfDemo, testing::ValuesIn(demoNames()), parameterWord);

TEST(GeneratedPages, tables_are_fresh) {
    EXPECT_EQ(fileText(source / "docs/demos.md"), cataloguePage()) << "./run --docs . makes it anew";
    const std::string readme = fileText(source / "README.md");
    EXPECT_EQ(readme, readmePage(readme)) << "README.md: ./run --docs . makes it anew";
}

// Words exactly; numbers within 1 %, which is what drivers differ by in the samples on edges.
TEST(GeneratedPages, needs_are_fresh) {
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

TEST(GeneratedPages, strip_is_fresh) {
    const Picture committed = loadPicture(source / "docs/strip.png");
    const Difference difference = compare(committed, pictureStrip());
    // As for the golden pictures on another driver; shrinking averages the difference away, never makes it larger.
    EXPECT_LE(difference.maximum, 3);
    EXPECT_LE(difference.fraction, 0.001);
}

// Every demo that declares a study has a committed run of it, with all its rows, and every committed run has its page.
TEST(GeneratedPages, studies_are_there_and_fresh) {
    const fs::path folder = source / "docs/errors-and-times";
    int studied = 0;
    for (const DemoInfo& demo : catalogue()) {
        if (!demo.study) continue;
        ++studied;
        const std::string& name = demo.name;
        SCOPED_TRACE(name);
        const std::vector<StudyRun> runs = studiesInTree(MVGL_SOURCE_DIR, name);
        ASSERT_FALSE(runs.empty()) << "./test --update-studies measures it";
        EXPECT_EQ(drawerOf(runs[0].renderer), Drawer::processor);
        EXPECT_EQ(fileText(folder / (name + ".md")), studyPage(runs, demo)) << "./run --docs . makes it anew";
        const std::vector<StudyRun> builtIn = committedStudies(name);
        ASSERT_EQ(builtIn.size(), runs.size()) << "for the window";
        for (std::size_t i = 0; i < runs.size(); ++i) {
            const std::string stem = name + "." + nameOf(drawerOf(runs[i].renderer));
            EXPECT_EQ(fileText(folder / (stem + ".svg")), studySvg(runs[i])) << "./run --docs . draws it anew";
            EXPECT_EQ(fileText(folder / (stem + ".csv")), studyCsv(runs[i])) << "as a program writes it";
            EXPECT_EQ(studyCsv(builtIn[i]), studyCsv(runs[i]));
        }
        std::set<std::string> ids;
        for (const Saying& saying : demo.study->says) {
            EXPECT_TRUE(saying.sentence.ends_with(".")) << saying.sentence;
            if (!saying.isClaim()) continue;
            EXPECT_TRUE(ids.insert(saying.id).second) << saying.id << " is there twice";
            EXPECT_EQ(saying.id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string::npos)
                << saying.id;
            EXPECT_FALSE(saying.predicates.empty()) << saying.id << ": a claim has a predicate, or is a note";
        }
        EXPECT_FALSE(ids.empty()) << "what it says, a claim at least";
        std::set<std::array<std::string, 3>> declared;
        for (const StudyLine& line : demo.study->lines) {
            for (const StudyScene& scene : demo.study->scenes) {
                if (!line.scenes.empty() && std::ranges::find(line.scenes, scene.name) == line.scenes.end()) continue;
                for (const std::string& value : line.knob.empty() ? std::vector<std::string>{""} : line.values)
                    declared.insert({scene.name, line.method, value});
            }
        }
        for (const StudyRun& run : runs) {
            std::set<std::array<std::string, 3>> measured;
            for (const StudyRow& row : run.rows) measured.insert({row.scene, row.method, row.parameter});
            // A processor is always at hand. A GPU is not, and may lack what was declared since: its rows are old ones, and right
            if (drawerOf(run.renderer) == Drawer::processor)
                EXPECT_EQ(measured, declared) << "the declaration has changed";
            else
                EXPECT_TRUE(std::ranges::includes(declared, measured)) << "the declaration has changed";
            EXPECT_EQ(run.rows.size(), measured.size()) << "a row is there twice";
            for (const StudyRow& row : run.rows) {
                EXPECT_TRUE(!row.ok() || row.rounds >= 1) << row.method << " " << row.parameter;
            }
        }
    }
    EXPECT_GT(studied, 0);
}

TEST(GeneratedPages, links_lead_somewhere) {
    for (const char* page : {"README.md", "CONTRIBUTING.md", "docs/demos.md"}) expectLinksLead(source / page);
}

// Depths are compared by shaders/include/shadow-map.glsl, which minds what is beyond the map's end.
TEST(ShaderFiles, compare_depths_in_one_place) {
    for (const std::string& file : shaderFileNames()) {
        const std::string text = builtInShader(file);
        if (file == "include/shadow-map.glsl") continue;
        for (const std::string& map : matches(text, std::regex(R"(sampler2DShadow (\w+))")))
            EXPECT_TRUE(matches(text, std::regex("(texture\\w*\\(" + map + ")\\b")).empty()) << file;
    }
}

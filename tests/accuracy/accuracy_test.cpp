// The errors of mv/math, measured again (in ./test --long) and compared with the committed ones; the page made of those; and whether every
// function is among them. With MVGL_UPDATE_DOCS=1 the page's words are written anew around the committed numbers; with
// MVGL_LONG=1 a million samples of each function are measured, too.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "accuracy/page.h"
#include "mv/image/file.h"

using namespace mv;
using namespace mv::accuracy;

namespace {

const std::string folder = MVGL_SOURCE_DIR "/docs/";

std::string fileText(const std::filesystem::path& path) {
    std::ifstream stream(path, std::ios::binary);
    EXPECT_TRUE(stream) << path;
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

ErrorTable committedErrors() { return errorsFrom(fileText(folder + "library-errors.csv")); }
WorstTable committedWorst() { return worstFrom(fileText(folder + "library-worst.csv")); }
TimeTable committedTimes() { return timesFrom(fileText(folder + "library-times.csv")); }

// The samples are the same ones, so on one machine the errors are. Another's sine and cosine may round another way, which
// is an ulp of theirs: so a factor of 1.5, and half an ulp where that is more.
bool agree(double was, double is) {
    if (std::isinf(was) || std::isinf(is)) return was == is;
    return std::max(was, is) <= std::max(1.5 * std::min(was, is), std::min(was, is) + 0.5);
}

void compare(const ErrorTable& measured) {
    const ErrorTable committed = committedErrors();
    for (const auto& [what, is] : measured) {
        SCOPED_TRACE(what.function + ", " + what.form + (what.domain == Domain::whole ? ", whole" : ", ordinary"));
        const auto was = committed.find(what);
        ASSERT_NE(was, committed.end()) << "mvgl-bench accuracy --write docs measures it";
        EXPECT_PRED2(agree, was->second.max, is.max);
        EXPECT_PRED2(agree, was->second.mean, is.mean);
        // Parts of 10,000 samples, written to two digits.
        EXPECT_NEAR(was->second.lost, is.lost, 0.01);
        EXPECT_NEAR(was->second.refused, is.refused, 0.01);
        if (what.form == "mv") {
            EXPECT_EQ(is.lost, 0) << "an error above a millionth of the largest entry";
        }
    }
}

}  // namespace

// MVGL_UPDATE_DOCS=1 writes them (the times are mvgl-bench's).
TEST(Accuracy, errors_are_the_committed_ones) {
    const ErrorTable measured = measureAll(shortRun);
    if (std::getenv("MVGL_UPDATE_DOCS") != nullptr) {
        ErrorTable all = measured;
        all.merge(measureAll(pageRun));
        writeFileAtomically(folder + "library-errors.csv", std::string_view(errorsText(all)));
    }
    compare(measured);
}

// A longer run begins with the samples of a shorter one, so its largest error can only be larger. Ten times the samples
// may find one up to twice as large; more would be a corner that the page knows nothing of.
TEST(Accuracy, a_longer_run_finds_no_other_errors) {
    const ErrorTable committed = committedErrors();
    const bool isLong = std::getenv("MVGL_LONG") != nullptr;
    const ErrorTable measured = isLong ? measureAll(longRun) : committed;
    for (const Function& function : functions()) {
        SCOPED_TRACE(function.name);
        const Errors& less = committed.at({function.name, "mv", Domain::whole, isLong ? pageRun : shortRun});
        const Errors& more = measured.at({function.name, "mv", Domain::whole, isLong ? longRun : pageRun});
        EXPECT_GE(more.max * 1.05, less.max);  // two digits
        // An error above 4 ulp is a tail that more samples follow further.
        if (function.reason.empty()) {
            EXPECT_LE(more.max, 2 * less.max + 0.5);
            EXPECT_EQ(more.lost, 0);
        }
        EXPECT_PRED2(agree, less.mean, more.mean);
    }
}

TEST(Accuracy, is_within_the_bounds) {
    const ErrorTable committed = committedErrors();
    for (const Function& function : functions()) {
        EXPECT_LE(committed.at({function.name, "mv", Domain::whole, pageRun}).max, function.bound) << function.name;
    }
}

// The declarations at the beginning of a line, less those that compute nothing that could be off.
TEST(Accuracy, every_function_of_the_headers_is_measured) {
    const std::set<std::string> computeNothing{"vectorText",
                                               "isFinite",
                                               "requireFinite",
                                               "refuseInfinite",
                                               "fitsFloat",
                                               "requireFitsFloat",
                                               "requirePositive",
                                               "requireRange",
                                               "isOrdinary",      // comparisons
                                               "clipVolume",      // a constant
                                               "jitteredSquare",  // random points: none is right
                                               "colorMatching",   // a table
                                               "spectralLocus",   // its chromaticities
                                               "srgbFromHex",     // a quotient of whole numbers
                                               "hexFromSrgb",     // a text
                                               "textbookShadow",  // the lecture's forms, to compare with
                                               "textbookShadowAcrossAxis"};
    std::set<std::string> measured;
    for (const Function& function : functions()) {
        const std::string name = function.name.substr(0, function.name.find(' '));
        if (function.header.find('/') == std::string::npos) {
            measured.insert(name);
            continue;
        }
        // The formulas of mv/motion are measured; what iterates and integrates has studies instead.
        const std::string header = fileText(MVGL_SOURCE_DIR "/common/mv/" + function.header);
        EXPECT_NE(header.find(" " + name + "("), std::string::npos) << name << " is not in " << function.header;
    }
    std::set<std::string> declared;
    const std::regex declaration(R"(^(?:constexpr |inline |const )*[a-zA-Z][\w:<>, ]*[ &>](\w+)\()");
    for (const auto& entry : std::filesystem::directory_iterator(MVGL_SOURCE_DIR "/common/mv/math")) {
        if (entry.path().extension() != ".h") continue;
        std::ifstream header(entry.path());
        for (std::string line; std::getline(header, line);) {
            std::smatch match;
            if (line.rfind("template", 0) == 0 || line.find("= delete") != std::string::npos) continue;
            if (std::regex_search(line, match, declaration) && computeNothing.count(match[1]) == 0) {
                declared.insert(match[1]);
            }
        }
    }
    EXPECT_GT(declared.size(), 20U);
    for (const std::string& name : declared) EXPECT_EQ(measured.count(name), 1U) << name << " is not measured";
    for (const std::string& name : measured) EXPECT_EQ(declared.count(name), 1U) << name << " is not in the headers";
}

TEST(LibraryPage, is_made_of_the_committed_numbers) {
    if (std::getenv("MVGL_UPDATE_DOCS") != nullptr) {
        writeFileAtomically(folder + "library.md",
                            std::string_view(libraryPage(committedErrors(), committedTimes(), committedWorst())));
        writeFileAtomically(folder + "library.svg",
                            std::string_view(libraryCurve(committedErrors(), committedTimes())));
    }
    EXPECT_EQ(fileText(folder + "library.md"), libraryPage(committedErrors(), committedTimes(), committedWorst()))
        << "MVGL_UPDATE_DOCS=1 build/tests/test-accuracy makes it anew";
    EXPECT_EQ(fileText(folder + "library.svg"), libraryCurve(committedErrors(), committedTimes()))
        << "the curve shows other numbers, and is drawn anew by the same";
}

TEST(LibraryPage, numbers_survive_their_files) {
    const ErrorTable errors{{{"f", "mv", Domain::whole, 10}, {1.25, 0.5, 0, 0.001}},
                            {{"f", "GLM double", Domain::ordinary, 10}, {INFINITY, 3e15, 0.5, 0}}};
    EXPECT_EQ(errorsText(errorsFrom(errorsText(errors))), errorsText(errors));
    const TimeTable times{"a machine", {{{"f", "mv"}, {1.5, 0.1}}}};
    EXPECT_EQ(timesText(timesFrom(timesText(times))), timesText(times));
    const WorstTable worst{{{"f", "mv float"}, {2.5, 4, 18446744073709551615U, 100, {0.1, 0, -1e-310}}}};
    EXPECT_EQ(worstText(worstFrom(worstText(worst))), worstText(worst));
    EXPECT_EQ(worstFrom(worstText(worst)).begin()->second.input, worst.begin()->second.input);
    EXPECT_ANY_THROW(errorsFrom("a,b\n1,2\n"));
}

// The measuring itself: a result that is off by a known amount.
TEST(Measure, tells_how_far_a_result_is_off) {
    Function function{.name = "one",
                      .header = "",
                      .returns = "",
                      .measured = "",
                      .domain = "",
                      .reason = "",
                      .sample = [](Random&, Domain) { return Arguments{}; },
                      .truth =
                          [](const Arguments&) {
                              return Truth{{Wide(1), Wide(-3), Wide(0)}, {2, 1}};
                          }};
    const auto errors = [&](double first, double third) {
        const Form form = makeForm<double>("off", [=](const Arguments&) { return vec3(first, -3, third); });
        return measure(function, form, Domain::whole, 3);
    };
    EXPECT_EQ(errors(1, 0).max, 0);
    EXPECT_EQ(errors(1 + 0x1p-50, 0).max, 2);  // the last place of the block's 3 is 2^-51
    EXPECT_EQ(errors(1 + 0x1p-50, 0).mean, 2);
    EXPECT_EQ(errors(1 + 0x1p-50, 0).lost, 0);
    EXPECT_EQ(errors(1.001, 0).lost, 1);
    EXPECT_EQ(errors(NAN, 0).max, INFINITY);
    EXPECT_EQ(errors(NAN, 0).lost, 1);
    EXPECT_GT(errors(1, 1e-300).max, 1e20);  // of a zero even that is much
}

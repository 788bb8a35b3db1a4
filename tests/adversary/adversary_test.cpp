// The worst that a search finds of each function of mv/math, of the intersections and of clipping, against its bound.
//
// MVGL_SEED=n starts from another seed. MVGL_LONG=1 looks longer, from a seed that is printed. MVGL_UPDATE_DOCS=1 writes what
// is worse than the inputs in docs/library-worst.csv there, and docs/library.md anew.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <iostream>
#include <iterator>
#include <random>
#include <regex>
#include <set>

#include "accuracy/page.h"
#include "adversary/search.h"
#include "mv/image/file.h"
#include "mv/math/robust.h"

using namespace mv;
using namespace mv::adversary;
using accuracy::attackedFunctions;
using accuracy::ownForms;
using accuracy::WorstTable;

namespace {

// The ordinary run tries of each form: 20 seconds of one processor for all of them.
constexpr long ordinaryBudget = 20'000, longBudget = 400'000;

const std::string worstFile = MVGL_SOURCE_DIR "/docs/library-worst.csv";

std::string fileText(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

WorstTable committedWorst() { return accuracy::worstFrom(fileText(worstFile)); }

bool isLong() { return std::getenv("MVGL_LONG") != nullptr; }
long budget() { return isLong() ? longBudget : ordinaryBudget; }

std::uint64_t seedOfRun() {
    if (const char* text = std::getenv("MVGL_SEED")) return std::strtoull(text, nullptr, 10);
    return isLong() ? std::random_device()() : 1;
}

const Function& functionNamed(const std::string& name) {
    for (const Function& function : attackedFunctions()) {
        if (function.name == name) return function;
    }
    throw std::logic_error("no function " + name);
}

bool isWithin(const Function& function, const Arguments& a) { return !function.within || function.within(a); }

// A function with another form in the place of ours.
template <typename T = double, typename Call>
Worst searchOf(const std::string& name, Call call, Domain startsFrom) {
    const Form form = accuracy::makeForm<T>("planted", call);
    return search(functionNamed(name), form, startsFrom, 1, ordinaryBudget);
}
// The largest error of as many samples, which no climb changes.
template <typename Call>
double sampledOf(const std::string& name, Call call, Domain domain) {
    return measure(functionNamed(name), accuracy::makeForm<double>("planted", call), domain, ordinaryBudget).max;
}

}  // namespace

// Each of the usual forms is right on the samples but for some ulps, and wrong where the climb ends.
TEST(Search, catches_what_is_planted) {
    struct Planted {
        std::string name;
        double sampled;
        Worst worst;
    };
    const auto planted = [](const std::string& name, auto call) {
        return Planted{name, sampledOf(name, call, Domain::ordinary), searchOf(name, call, Domain::ordinary)};
    };
    const std::vector<Planted> all{
        planted("lookAt",
                [](const auto& a) {
                    return glm::lookAtRH(accuracy::vectorAt(a, 0), accuracy::vectorAt(a, 3), accuracy::vectorAt(a, 6));
                }),
        planted("perspective",
                [](const auto& a) { return glm::perspectiveRH_NO(glm::radians(a[0]), a[1], a[2], a[3]); }),
        planted("rotateX", [](const auto& a) { return glm::rotate(mat4(1), glm::radians(a[0]), vec3(1, 0, 0)); }),
        planted("differenceOfProducts", [](const auto& a) { return a[0] * a[1] - a[2] * a[3]; }),
        planted("unit", [](const auto& a) { return glm::normalize(accuracy::vectorAt(a, 0)); }),
        // Right but where two components are the same number, which no sample has
        planted("largestComponent",
                [](const auto& a) { return a[0] == a[1] ? 0.0 : largestComponent(accuracy::vectorAt(a, 0)); }),
    };
    for (const Planted& form : all) {
        const Function& function = functionNamed(form.name);
        std::cout << form.name << ": " << form.sampled << " ulp in as many samples, " << form.worst.ulp << " found\n";
        EXPECT_GT(form.worst.ulp, 1e6) << form.name;
        EXPECT_LT(form.sampled, 1e3) << form.name << ": the samples alone find it, so the climb proves nothing";
        EXPECT_TRUE(isWithin(function, form.worst.input)) << form.name;
    }
}

TEST(Search, is_the_same_with_the_same_seed_and_counts_what_it_tries) {
    const Function& function = functionNamed("rotate");
    const auto once = [&](std::uint64_t seed) {
        return search(function, *ownForms(function).front(), Domain::whole, seed, 500);
    };
    const Worst first = once(3), again = once(3), other = once(4);
    EXPECT_EQ(first.ulp, again.ulp);
    EXPECT_EQ(first.input, again.input);
    EXPECT_NE(first.input, other.input);
    EXPECT_EQ(first.evaluations, 500);
    EXPECT_LT(first.refused, 250);
    // The result is the one that it says.
    EXPECT_EQ(errorOfCall(function, *ownForms(function).front(), first.input).ulp, first.ulp);
}

// As Accuracy.every_function_of_the_headers_is_measured, which reads mv/math.
TEST(Adversary, every_intersection_is_attacked) {
    std::set<std::string> attacked, declared;
    for (const Function& function : attackedFunctions())
        attacked.insert(function.name.substr(0, function.name.find(' ')));
    std::ifstream header(MVGL_SOURCE_DIR "/common/mv/geometry/ray.h");
    const std::regex declaration(R"(^std::optional<[^(]* (intersect\w+)\(|^class (\w+Test) )");
    for (std::string line; std::getline(header, line);) {
        std::smatch match;
        if (std::regex_search(line, match, declaration)) declared.insert(match[1].matched ? match[1] : match[2]);
    }
    EXPECT_GE(declared.size(), 5U);
    for (const std::string& name : declared) EXPECT_EQ(attacked.count(name), 1U) << name << " is not attacked";
}

TEST(Adversary, every_bound_is_between_nothing_and_its_reason) {
    for (const Function& function : attackedFunctions()) {
        EXPECT_GE(function.bound, 0) << function.name;
        EXPECT_EQ(function.bound > 4, !function.reason.empty()) << function.name;
        EXPECT_EQ(function.limits.empty(), !function.within)
            << function.name << ": limits are said in words, and tested";
    }
}

TEST(Adversary, no_error_is_above_its_bound) {
    const std::uint64_t seed = seedOfRun();
    std::cout << "MVGL_SEED=" << seed << ", " << budget() << " evaluations of each\n"
              << "worst ulp, bound, evaluations of which refused, function, input\n";
    WorstTable table = committedWorst();
    for (const Function& function : attackedFunctions()) {
        for (const Form* form : ownForms(function)) {
            const auto known = table.find({function.name, form->name});
            const std::vector<std::size_t> used = usedArguments(function);
            std::vector<Arguments> starts;
            if (known != table.end()) starts.push_back(known->second.input);
            const Worst worst = search(function, *form, Domain::whole, seed, budget(), starts);
            std::printf("%-9.3g %-4g %6ld %6ld  %s, %s:", worst.ulp, function.bound, worst.evaluations, worst.refused,
                        function.name.c_str(), form->name.c_str());
            for (const std::size_t i : used) std::printf(" %.17g", worst.input[i]);
            std::printf("\n");
            EXPECT_LE(worst.ulp, function.bound) << function.name << ", " << form->name;
            EXPECT_LT(worst.refused, worst.evaluations * 3 / 4) << function.name << ": hardly anything was tried";
            if (known == table.end() || worst.ulp > known->second.ulp) {
                table[{function.name, form->name}] = {worst.ulp, function.bound, seed, worst.evaluations, worst.input};
            }
        }
    }
    if (std::getenv("MVGL_UPDATE_DOCS") == nullptr) return;
    writeFileAtomically(worstFile, std::string_view(accuracy::worstText(table)));
}

// Inputs that were found stay found: these inputs are read on another machine, too, where a sine may round another way.
TEST(Adversary, known_inputs_have_the_committed_errors) {
    const WorstTable table = committedWorst();
    std::size_t forms = 0;
    for (const Function& function : attackedFunctions()) {
        for (const Form* form : ownForms(function)) {
            ++forms;
            SCOPED_TRACE(function.name + ", " + form->name);
            const auto known = table.find({function.name, form->name});
            ASSERT_NE(known, table.end()) << "MVGL_UPDATE_DOCS=1 build/tests/test-adversary searches it";
            EXPECT_TRUE(isWithin(function, known->second.input));
            const double is = errorOfCall(function, *form, known->second.input).ulp, was = known->second.ulp;
            // Half an ulp more or less of a sine, which rotate multiplies by up to 2 in each of three terms.
            EXPECT_NEAR(is, was, 3.05) << "two digits are written";
            EXPECT_EQ(known->second.bound, function.bound);
        }
    }
    EXPECT_EQ(table.size(), forms) << "a function that is no more";
}

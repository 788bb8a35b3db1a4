#include "accuracy/page.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <sstream>
#include <thread>

#include "mv/error.h"
#include "mv/formatted.h"
#include "mv/study/study.h"

namespace mv::accuracy {
namespace {

std::string twoDigits(double value) {
    if (std::isinf(value)) return "inf";
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", value);
    std::snprintf(text, sizeof text, "%g", std::strtod(text, nullptr));  // 500, not 5e+02
    return text;
}

std::string domainText(Domain domain) { return domain == Domain::whole ? "whole" : "ordinary"; }

const std::string errorsHeading = "function,form,domain,samples,max_ulp,mean_ulp,lost,refused";
const std::string timesHeading = "function,form,ns_median,ns_mad";

std::vector<std::vector<std::string>> csvRows(const std::string& text, const std::string& heading) {
    std::vector<std::vector<std::string>> rows;
    const auto columns = std::count(heading.begin(), heading.end(), ',') + 1;
    std::istringstream lines(text);
    bool headed = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind('#', 0) == 0) continue;
        if (!headed) {
            if (line != heading) throw Error("library data", "the heading must be " + heading, line);
            headed = true;
            continue;
        }
        std::vector<std::string> cells;
        std::istringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
        if (std::ssize(cells) != columns) throw Error("library data", "each line must have all columns", line);
        rows.push_back(std::move(cells));
    }
    return rows;
}

double number(const std::string& text) { return std::strtod(text.c_str(), nullptr); }

// One line of the tables' numbers.
struct Numbers {
    const ErrorTable& errors;
    const TimeTable& times;

    const Errors& error(const Function& function, const std::string& form, Domain domain, long samples) const {
        const auto found = errors.find({function.name, form, domain, samples});
        if (found == errors.end()) throw Error("libraryPage", "each function must have its errors", function.name);
        return found->second;
    }
    const Time& time(const Function& function, const std::string& form) const {
        const auto found = times.times.find({function.name, form});
        if (found == times.times.end()) throw Error("libraryPage", "each function must have its times", function.name);
        return found->second;
    }
    std::string ns(const Function& function, const std::string& form) const {
        const Time& t = time(function, form);
        return twoDigits(t.nanoseconds) + " ± " + twoDigits(t.deviation);
    }
};

bool hasTwin(const Function& function) { return function.forms.size() > 1; }

std::string percent(double part) { return part == 0 ? "0" : twoDigits(100 * part) + " %"; }

// The error as a part of the largest entry, for the curve; what is exact stands at its left edge.
double part(const Errors& error, bool isFloat) { return std::max(error.max * (isFloat ? 0x1p-23 : 0x1p-52), 2e-17); }

const std::string worstHeading = "function,form,worst_ulp,bound_ulp,seed,evaluations,input";

// Those up to the last that is not 0.
std::vector<double> leading(const Arguments& input) {
    std::size_t count = input.size();
    while (count > 1 && input[count - 1] == 0) --count;
    return {input.begin(), input.begin() + static_cast<std::ptrdiff_t>(count)};
}

}  // namespace

std::vector<Measurement> measurementsOf(const Function& function, long samples) {
    std::vector<Measurement> list;
    for (const Form& form : function.forms) {
        if (!form.isFloat && (samples == shortRun || form.name == "mv")) {
            list.push_back({function.name, form.name, Domain::whole, samples});
        }
        if (samples == shortRun && hasTwin(function)) {
            list.push_back({function.name, form.name, Domain::ordinary, samples});
        }
    }
    return list;
}

ErrorTable measureAll(long samples) {
    struct Job {
        const Function* function;
        const Form* form;
        Measurement measurement;
    };
    std::vector<Job> jobs;
    for (const Function& function : functions()) {
        for (const Measurement& measurement : measurementsOf(function, samples)) {
            const auto form = std::find_if(function.forms.begin(), function.forms.end(),
                                           [&](const Form& f) { return f.name == measurement.form; });
            jobs.push_back({&function, &*form, measurement});
        }
    }
    ErrorTable table;
    std::mutex guard;
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < jobs.size(); i = next++) {
            const Errors errors =
                measure(*jobs[i].function, *jobs[i].form, jobs[i].measurement.domain, jobs[i].measurement.samples);
            const std::lock_guard lock(guard);
            table[jobs[i].measurement] = errors;
        }
    };
    {
        std::vector<std::jthread> threads;
        for (unsigned i = 0; i < std::max(1U, std::thread::hardware_concurrency()); ++i) threads.emplace_back(work);
    }
    return table;
}

std::string errorsText(const ErrorTable& errors) {
    std::ostringstream text;
    text << "# Errors of mv/math's functions in units of the last place; written by `mvgl-bench accuracy --write "
            "docs`.\n"
         << errorsHeading << "\n";
    for (const auto& [m, e] : errors) {
        text << m.function << "," << m.form << "," << domainText(m.domain) << "," << m.samples << ","
             << twoDigits(e.max) << "," << twoDigits(e.mean) << "," << twoDigits(e.lost) << "," << twoDigits(e.refused)
             << "\n";
    }
    return text.str();
}

ErrorTable errorsFrom(const std::string& text) {
    ErrorTable errors;
    for (const auto& row : csvRows(text, errorsHeading)) {
        const Domain domain = row[2] == "whole" ? Domain::whole : Domain::ordinary;
        errors[{row[0], row[1], domain, std::strtol(row[3].c_str(), nullptr, 10)}] = {number(row[4]), number(row[5]),
                                                                                      number(row[6]), number(row[7])};
    }
    return errors;
}

std::string timesText(const TimeTable& times) {
    std::ostringstream text;
    text << "# " << times.machine << "\n" << timesHeading << "\n";
    for (const auto& [key, time] : times.times) {
        text << key.first << "," << key.second << "," << twoDigits(time.nanoseconds) << "," << twoDigits(time.deviation)
             << "\n";
    }
    return text.str();
}

TimeTable timesFrom(const std::string& text) {
    TimeTable times;
    if (text.rfind("# ", 0) == 0) times.machine = text.substr(2, text.find('\n') - 2);
    for (const auto& row : csvRows(text, timesHeading)) {
        times.times[{row[0], row[1]}] = {number(row[2]), number(row[3])};
    }
    return times;
}

std::string worstText(const WorstTable& worst) {
    std::ostringstream text;
    text << "# The worst that a search has found of each form, arguments as hexadecimal numbers; written by "
            "`MVGL_UPDATE_DOCS=1 build/tests/test-adversary`.\n"
         << worstHeading << "\n";
    for (const auto& [key, found] : worst) {
        text << key.first << "," << key.second << "," << formatted("%.3g", found.ulp) << ","
             << formatted("%g", found.bound) << "," << found.seed << "," << found.evaluations << ",";
        const char* gap = "";
        for (const double value : leading(found.input)) {
            text << gap << formatted("%a", value);
            gap = " ";
        }
        text << "\n";
    }
    return text.str();
}

WorstTable worstFrom(const std::string& text) {
    WorstTable worst;
    for (const auto& row : csvRows(text, worstHeading)) {
        WorstFound found{number(row[2]), number(row[3]), std::strtoull(row[4].c_str(), nullptr, 10),
                         std::strtol(row[5].c_str(), nullptr, 10)};
        std::istringstream input(row[6]);
        std::size_t i = 0;
        for (std::string value; input >> value; ++i) {
            if (i == found.input.size()) throw Error("library data", "there must not be more arguments", row[6]);
            found.input[i] = number(value);
        }
        worst[{row[0], row[1]}] = found;
    }
    return worst;
}

std::string libraryPage(const ErrorTable& errors, const TimeTable& times, const WorstTable& worst) {
    const Numbers numbers{errors, times};
    std::ostringstream page;
    page << R"(# Error and time of the library's functions

What each function of `mv/math`, and of `mv/motion` each that is a formula, returns, how far that is from the truth, and how long it takes. The truth is computed with
50 digits (Boost.Multiprecision) from the very same arguments. Errors are in ulp, units in the last place: the gap between
neighbouring doubles at the size of the true result; rounding alone costs half of one. *Entrywise* takes each number's own
size, which asks the most; otherwise the size is that of the largest entry of what is named. Samples are random, with sizes
spread evenly over the logarithm. Samples miss corners: what a search finds stands [below](#the-worst-that-a-search-finds).

Times are of )"
         << times.machine << R"(, median ± median absolute deviation of interleaved runs.
Written by `build/bin/mvgl-bench accuracy --write docs`; a test measures the errors again. Do not edit.

![Largest error against time per call: mv and GLM in double at the left, within 1e-15 of the truth and mostly within a factor of 2 in time; GLM in float at 1e-7, hardly faster](library.svg)

## The functions

)" << pageRun
         << R"( samples each.

)";
    std::string header;
    for (const Function& function : functions()) {
        if (function.header != header) {
            header = function.header;
            page << (function.name == functions().front().name ? "" : "\n") << "### mv/"
                 << (header.find('/') == std::string::npos ? "math/" : "") << header << "\n\n"
                 << "| function | returns | error measured | max | mean | ns | samples |\n"
                 << "|---|---|---|--:|--:|--:|---|\n";
        }
        const Errors& e = numbers.error(function, "mv", Domain::whole, pageRun);
        page << "| `" << function.name << "` | " << function.returns << " | " << function.measured << " | "
             << twoDigits(e.max) << " | " << twoDigits(e.mean) << " | " << numbers.ns(function, "mv") << " | "
             << function.domain << " |\n";
    }
    page << R"(
## The worst that a search finds

`test-adversary` looks for the arguments on which a function is worst: from random samples it climbs by changing bits, exponents
and signs, and by copying one argument to another. An error above the bound is a failed test. The bound is 4 ulp, less where the
function promises less, and more where the last column counts its roundings, of up to an ulp each; it holds for all that the function accepts, or within the
limits named, which its header names, too. Errors are measured as above, so that a result which is a small difference of
large terms counts in ulp of the terms: rounding the arguments alone would cost as much. Each input is shortened here; [library-worst.csv](library-worst.csv) has all its bits, and a test asks it
again. Evaluations: of the run that found it.

| function | type | error measured | worst | bound | limits | evaluations | input | why more than 4 |
|---|---|---|--:|--:|---|--:|---|---|
)";
    for (const Function& function : attackedFunctions()) {
        for (const Form* form : ownForms(function)) {
            const auto found = worst.find({function.name, form->name});
            if (found == worst.end()) throw Error("libraryPage", "each function must have its worst", function.name);
            page << "| `" << function.name << "` | " << (form->isFloat ? "float" : "double") << " | "
                 << function.measured << " | " << twoDigits(found->second.ulp) << " | "
                 << formatted("%g", found->second.bound) << " | "
                 << (function.limits.empty() ? "all that is accepted" : function.limits) << " | "
                 << found->second.evaluations << " | ";
            const std::vector<double> input = leading(found->second.input);
            for (std::size_t i = 0; i < std::min<std::size_t>(input.size(), 9); ++i) {
                page << (i == 0 ? "" : " ") << formatted("%.4g", input[i]);
            }
            page << (input.size() > 9 ? " …" : "") << " | " << function.reason << " |\n";
        }
    }
    page << R"(
## Against GLM

Ordinary arguments, as scenes have them, )"
         << shortRun << R"( samples: in double both are exact enough, ours with its checks of the arguments. Each
float form got arguments that are floats already, so its error is its own, in ulp of float, each of which is 5e8 of double.
*Lost*: the part of the samples over the whole domain with an error above a millionth, or with NaN. GLM's counterparts are its functions of these names
(`rotate`, `lookAtRH`, `orthoRH_NO`, `perspectiveRH_NO`, `frustumRH_NO`), for normalMatrix `inverseTranspose`, for unit
`normalize`, for accurateCross `cross`, for differenceOfProducts `determinant`.

| function | mv max | mean | ns | lost | GLM double max | mean | ns | lost | GLM float max | mean | ns |
|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|
)";
    for (const Function& function : functions()) {
        if (!hasTwin(function)) continue;
        page << "| `" << function.name << "` |";
        for (const Form& form : function.forms) {
            const Errors& e = numbers.error(function, form.name, Domain::ordinary, shortRun);
            page << " " << twoDigits(e.max) << " | " << twoDigits(e.mean) << " | " << numbers.ns(function, form.name)
                 << " |";
            if (!form.isFloat) {
                page << " " << percent(numbers.error(function, form.name, Domain::whole, shortRun).lost) << " |";
            }
        }
        page << "\n";
    }
    return page.str();
}

std::string libraryCurve(const ErrorTable& errors, const TimeTable& times) {
    const Numbers numbers{errors, times};
    StudyRun run;
    run.demo = "mv/math";
    run.quantity = "results";
    run.reference = "50 digits (Boost.Multiprecision)";
    run.axis = ErrorAxis::max;
    run.processor = times.machine;
    run.threads = 1;
    for (const char* form : {"mv", "GLM double", "GLM float"}) {
        for (const Function& function : functions()) {
            const auto found = std::ranges::find(function.forms, form, &Form::name);
            if (!hasTwin(function) || found == function.forms.end()) continue;
            StudyRow row;
            row.method = found->isFloat        ? "GLM, float"
                         : found->name == "mv" ? "mv, double, arguments checked"
                                               : "GLM, double";
            row.parameter = function.name;
            row.all.max = part(numbers.error(function, form, Domain::ordinary, shortRun), found->isFloat);
            row.msMedian = numbers.time(function, form).nanoseconds;
            row.rounds = 1;
            run.rows.push_back(row);
        }
    }
    return studySvg(run, {.title = "Functions of mv and of GLM, on " + times.machine,
                          .error = "largest error, ordinary arguments, as a part of the largest entry (2e-17: exact)",
                          .time = "time per call (ns)",
                          .joined = false});
}

}  // namespace mv::accuracy

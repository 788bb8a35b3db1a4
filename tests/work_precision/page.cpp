#include "work_precision/page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <sstream>

#include "mv/error.h"
#include "mv/formatted.h"
#include "mv/study/claims.h"
#include "mv/study/study.h"

namespace mv::work_precision {
namespace {

const std::string heading =
    "problem,method,parameter,err_max,err_rms,n,ms_median,ms_mad,rounds,evaluations,jacobians,factorizations,"
    "newton_iterations,accepted,rejected,status";
const std::vector<std::string> countNames{"evaluations",       "jacobians", "factorizations",
                                          "newton_iterations", "accepted",  "rejected"};
constexpr const char* timesTolerance = "error by tolerance";
const std::string best = "the best of ours", cvodeName = "CVODE", odeintName = "Odeint";
const std::vector<std::string> ourChoosers{"Dormand-Prince 5(4)", "RODAS 4(3)", "Radau IIA 5"};

double count(const StudyRow& row, const std::string& name) {
    for (const auto& [counted, amount] : row.counts) {
        if (counted == name) return amount;
    }
    throw Error("work-precision", "each row must have its counts", name);
}

bool hasTolerance(const StudyRow& row) { return row.settings.front().name == "tolerance"; }

// The words that the table shows beside the counts that are stored.
void addTimesTolerance(StudyRow& row) {
    if (row.ok() && hasTolerance(row)) row.counts.emplace_back(timesTolerance, row.all.max / *parameterOf(row));
}

StudyRow bareRow(const std::string& problem, const std::string& method, const std::string& parameter, bool tolerance) {
    StudyRow row;
    row.scene = problem;
    row.method = method;
    row.knob = tolerance ? "tolerance" : "steps";
    row.parameter = parameter;
    row.settings = {{row.knob, parameter}};
    return row;
}

std::string oneLine(std::string text) {
    std::ranges::replace(text, ',', ';');
    std::ranges::replace(text, '\n', ' ');
    return text;
}

}  // namespace

StudyRun emptyRun() {
    StudyRun run;
    run.demo = "work-precision";
    run.quantity = "y at the stops, as a part of each component's size";
    run.reference = "extrapolated linearly implicit Euler steps of order 12 in 34 digits, and the springs' formula";
    run.axis = ErrorAxis::max;
    run.wrongBeyond = 1;
    run.host = "no window";
    run.renderer = "doubles";
    return run;
}

StudyRow rowLeftOut(const Problem& problem, const Solver& solver, double parameter, const std::string& why) {
    StudyRow row = bareRow(problem.ode.name, solver.name, formatted("%g", parameter), solver.hasTolerance);
    row.status = oneLine(why);
    for (const std::string& name : countNames) row.counts.emplace_back(name, 0);
    return row;
}

StudyRow rowOf(const Problem& problem, const Solver& solver, double parameter, const Outcome& outcome) {
    StudyRow row = bareRow(problem.ode.name, solver.name, formatted("%g", parameter), solver.hasTolerance);
    const OdeCounts& c = outcome.counts;
    const std::array<std::int64_t, 6> counts{c.evaluations,      c.jacobians, c.factorizations,
                                             c.newtonIterations, c.accepted,  c.rejected};
    for (std::size_t i = 0; i < counts.size(); ++i) {
        row.counts.emplace_back(countNames[i], static_cast<double>(counts[i]));
    }
    if (!outcome.failure.empty()) {
        row.status = oneLine(outcome.failure);
        return row;
    }
    const Deviation error = deviationOf(problem, outcome.states, committedReference(problem));
    row.all.max = error.largest;
    row.all.rms = error.rootMeanSquare;
    row.all.n = error.values;
    if (!(error.largest <= 1)) {
        row.status =
            "wrong by " + formatted("%.2g", error.largest) + " times the size of a component and does not say so";
    }
    addTimesTolerance(row);
    return row;
}

std::string rowsText(const StudyRun& run, const std::string& cvode) {
    std::string text = "# processor," + run.processor + "\n# threads," + std::to_string(run.threads) + "\n# CVODE," +
                       cvode + "\n" + heading + "\n";
    for (const StudyRow& row : run.rows) {
        text += row.scene + "," + row.method + "," + row.parameter + "," + formatted("%.6g", row.all.max) + "," +
                formatted("%.6g", row.all.rms) + "," + std::to_string(row.all.n) + "," +
                formatted("%.4g", row.msMedian) + "," + formatted("%.2g", row.msMad) + "," + std::to_string(row.rounds);
        for (const std::string& name : countNames) text += "," + formatted("%.0f", count(row, name));
        text += "," + row.status + "\n";
    }
    return text;
}

StudyRun rowsFrom(const std::string& text) {
    StudyRun run = emptyRun();
    std::istringstream lines(text);
    bool isHeaded = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("# processor,")) run.processor = line.substr(12);
        if (line.starts_with("# threads,")) run.threads = std::atoi(line.c_str() + 10);
        if (line.starts_with("# CVODE,")) run.renderer = line.size() > 8 ? "CVODE " + line.substr(8) : "no CVODE";
        if (line.starts_with("#")) continue;
        if (!isHeaded) {
            if (line != heading) throw Error("work-precision.csv", "the heading must be " + heading, line);
            isHeaded = true;
            continue;
        }
        std::vector<std::string> cells;
        std::istringstream stream(line);
        for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
        if (cells.size() != 16) throw Error("work-precision.csv", "each line must have all columns", line);
        const auto number = [&](std::size_t i) { return std::strtod(cells[i].c_str(), nullptr); };
        StudyRow row = bareRow(cells[0], cells[1], cells[2], number(2) < 1);
        row.all.max = number(3);
        row.all.rms = number(4);
        row.all.n = std::lround(number(5));
        row.msMedian = number(6);
        row.msMad = number(7);
        row.rounds = static_cast<int>(number(8));
        for (std::size_t i = 0; i < countNames.size(); ++i) row.counts.emplace_back(countNames[i], number(9 + i));
        row.status = cells[15];
        addTimesTolerance(row);
        run.rows.push_back(std::move(row));
    }
    markBest(run);
    return run;
}

namespace {

// The time at which the line reaches the error.
std::optional<double> timeAt(const StudyRun& run, const std::string& scene, const std::string& method, double error) {
    std::vector<const StudyRow*> line;
    for (const StudyRow& row : run.rows) {
        if (row.scene == scene && row.method == method && isPlotted(row)) line.push_back(&row);
    }
    std::size_t after = line.size();
    while (after > 0 && run.shownError(*line[after - 1]) <= error) --after;
    if (after == line.size()) return {};
    if (after == 0) return line[0]->msMedian;
    const StudyRow &a = *line[after - 1], &b = *line[after];
    const double part = std::log(run.shownError(a) / error) / std::log(run.shownError(a) / run.shownError(b));
    return a.msMedian * std::pow(b.msMedian / a.msMedian, part);
}

}  // namespace

StudyRun atEqualErrors(const StudyRun& run) {
    StudyRun result = emptyRun();
    for (const std::string& scene : scenesOf(run)) {
        for (const char* error : {"0.001", "1e-06", "1e-09"}) {
            const auto add = [&](const std::string& name, const std::vector<std::string>& methods) {
                StudyRow row;
                row.scene = scene;
                row.method = name;
                row.parameter = error;
                row.status = "no row errs so little";
                for (const std::string& method : methods) {
                    const auto time = timeAt(run, scene, method, std::strtod(error, nullptr));
                    if (!time || (row.ok() && *time >= row.msMedian)) continue;
                    row.status = "ok";
                    row.msMedian = *time;
                    row.rounds = 1;
                    row.all.max = std::strtod(error, nullptr);
                    row.settings = {{"method", method}};
                }
                result.rows.push_back(std::move(row));
            };
            std::vector<std::string> ours;
            for (const std::string& method : methodsOf(run, scene)) {
                if (!method.starts_with(cvodeName) && !method.starts_with(odeintName)) ours.push_back(method);
            }
            add(best, ours);
            add(cvodeName, {"CVODE BDF", "CVODE Adams"});
            add(odeintName, {"Odeint rosenbrock4"});
            for (const std::string& method : ourChoosers) add(method, {method});
        }
    }
    return result;
}

namespace {

const StudyRow& rowAt(const StudyRun& run, const std::string& scene, const std::string& method, const std::string& p) {
    for (const StudyRow& row : run.rows) {
        if (row.scene == scene && row.method == method && row.parameter == p) return row;
    }
    throw Error("work-precision", "there must be a row", scene + ", " + method + ", " + p);
}

std::string milliseconds(const StudyRow& row) { return row.ok() ? formatted("%.3g", row.msMedian) : "-"; }

std::string equalErrorTable(const StudyRun& run) {
    const StudyRun times = atEqualErrors(run);
    std::string text =
        "| problem | error | best of ours | ms | CVODE ms | times ours | Odeint ms | times ours |\n"
        "|---|--:|---|--:|--:|--:|--:|--:|\n";
    for (const std::string& scene : scenesOf(run)) {
        for (const char* error : {"0.001", "1e-06", "1e-09"}) {
            const StudyRow& ours = rowAt(times, scene, best, error);
            text += "| " + scene + " | " + error + " | " + (ours.ok() ? ours.settings.front().text : "-") + " | " +
                    milliseconds(ours);
            for (const std::string& other : {cvodeName, odeintName}) {
                const StudyRow& theirs = rowAt(times, scene, other, error);
                text += " | " + milliseconds(theirs) + " | " +
                        (ours.ok() && theirs.ok() ? formatted("%.2g", theirs.msMedian / ours.msMedian) : "-");
            }
            text += " |\n";
        }
    }
    return text;
}

std::string saysText(const StudyRun& run, const std::vector<Saying>& says) {
    std::string text;
    for (const Saying& saying : says) {
        text += "- " + (saying.isClaim() ? "**" + saying.id + "** " : "") + saying.sentence + "\n";
        for (const Predicate& predicate : saying.predicates) text += "  - " + evaluate(run, predicate).text + "\n";
    }
    return text;
}

std::string rowTable(const StudyRun& run, const std::string& scene) {
    std::string text =
        "| method | p | error | by tolerance | ms | evaluations | Jacobians | factorizations | accepted | rejected | "
        "best "
        "|\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|---|\n";
    for (const StudyRow& row : run.rows) {
        if (row.scene != scene || !row.ok()) continue;
        text += "| " + row.method + " | " + row.parameter + " | " + errorText(row.all.max) + " | " +
                (hasTolerance(row) ? formatted("%.2g", count(row, timesTolerance)) : "") + " | " +
                formatted("%.3g", row.msMedian) + " ± " + formatted("%.1g", row.msMad);
        for (const char* name : {"evaluations", "jacobians", "factorizations", "accepted", "rejected"}) {
            text += " | " + formatted("%.0f", count(row, name));
        }
        text += std::string(" | ") + (row.best ? "best" : "") + " |\n";
    }
    return text;
}

// Runs of rows of one method with one reason, after the other.
std::string gapList(const StudyRun& run, const std::string& scene) {
    std::vector<std::pair<std::string, std::string>> gaps;  // method and p's, reason of the first
    std::string method, reason;
    for (const StudyRow& row : run.rows) {
        if (row.scene != scene || row.ok()) continue;
        // The same but for its numbers.
        std::string kind = row.status;
        std::erase_if(kind,
                      [](char c) { return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+' || c == 'e'; });
        if (row.method == method && kind == reason) {
            gaps.back().first += ", " + row.parameter;
            continue;
        }
        method = row.method;
        reason = kind;
        gaps.emplace_back(row.method + " " + row.parameter, row.status);
    }
    std::string text;
    for (const auto& [who, why] : gaps) text += "- " + who + ": " + why + "\n";
    return text.empty() ? "" : "\nGaps, the first one's reason where they are alike:\n\n" + text;
}

}  // namespace

std::vector<Saying> sayingsAtEqualErrors() {
    using namespace claims;
    const auto ours = rows("the best of ours"), cvode = rows("CVODE");
    std::vector<Predicate> sooner;
    for (const char* scene : {"Robertson", "van der Pol", "HIRES", "Oregonator"}) {
        sooner.push_back(ratio(of::time, rows("Radau IIA 5").in(scene).at(1e-9), rows("RODAS 4(3)"), 0, 0.7));
    }
    return {claim("no-slower-than-cvode",
                  "On Robertson and van der Pol the best of ours is no slower than CVODE, at an error of 1e-6 and of "
                  "1e-9; on "
                  "the chain at 1e-6.",
                  {ratio(of::time, ours.in("Robertson").upTo(1e-6), cvode, 0, 1),
                   ratio(of::time, ours.in("van der Pol").upTo(1e-6), cvode, 0, 1),
                   ratio(of::time, ours.in("stiff chain").at(1e-6), cvode, 0, 1)}),
            claim("order-pays",
                  "For an error of 1e-9 Radau, of order 5, takes at most 0.7 times as long as RODAS, of order 4, on "
                  "the stiff "
                  "reactions and van der Pol.",
                  std::move(sooner))};
}

std::vector<Saying> sayings() {
    using namespace claims;
    const StudyRows explicitly = rows("Dormand-Prince 5(4)"), implicitly = rows("RODAS 4(3)", "Radau IIA 5");
    std::vector<Predicate> multiples;
    for (const char* scene : {"undamped spring", "damped spring", "stiff chain", "HIRES"}) {
        multiples.push_back(atMost(of::count(timesTolerance), explicitly.in(scene).from(1e-9), 100));
    }
    for (const char* scene :
         {"undamped spring", "damped spring", "stiff chain", "Robertson", "van der Pol", "HIRES", "Oregonator"}) {
        multiples.push_back(atMost(of::count(timesTolerance), implicitly.in(scene).from(1e-9), 100));
    }
    const StudyRows all = rows("Dormand-Prince 5(4)", "RODAS 4(3)", "Radau IIA 5").in("Pleiades").upTo(1e-4).from(1e-9);
    return {
        claim("explicit-gives-up",
              "An explicit method does not come to the end of the stiffest, whatever the tolerance; it says so.",
              {fails(explicitly.in("Robertson"), "steps are not enough"),
               fails(explicitly.in("van der Pol"), "steps are not enough"),
               fails(explicitly.in("Oregonator"), "steps are not enough")}),
        claim("an-error-is-told",
              "Where ours choose their steps by a tolerance of 1e-2 to 1e-9 they err by at most 100 times of it, or "
              "give up in "
              "words: on all but Pleiades.",
              std::move(multiples)),
        claim("the-chain-to-1e-9",
              "On the chain Radau errs by less than 1e-9; CVODE by more than 1e-8 at every tolerance tried.",
              {atMost(of::max, rows("Radau IIA 5").in("stiff chain").at(1e-10), 1e-9),
               atLeast(of::max, rows("CVODE BDF").in("stiff chain").from(1e-11), 1e-8)}),
        claim("near-passes-spread-errors",
              "Stars that pass near each other spread errors: on Pleiades, from 1e-4 to 1e-9, up to 3000 times the "
              "tolerance. "
              "No error of a step tells of that.",
              {atMost(of::count(timesTolerance), all, 3000)}),
        claim("not-stiff",
              "Pleiades is not stiff: none of our implicit methods beats Dormand-Prince there, down to 1e-9.",
              {unbeaten(explicitly.in("Pleiades").upTo(1e-4).from(1e-9), implicitly)}),
        claim("orders",
              "Equal steps converge by their orders: on the undamped spring the Euler methods by 1, Verlet, both "
              "midpoint "
              "rules and BDF2 by 2, Runge-Kutta 4 by 4.",
              {slope(of::error, rows("explicit Euler", "symplectic Euler", "implicit Euler").in("undamped spring"),
                     -1.1, -0.9),
               slope(of::error,
                     rows("velocity Verlet", "explicit midpoint", "implicit midpoint", "BDF2").in("undamped spring"),
                     -2.1, -1.9),
               // The fourth row has come to rounding.
               slope(of::error, rows("Runge-Kutta 4").in("undamped spring").upTo(1000), -4.1, -3.9)}),
        note("A row that errs by more than a component's whole size without a word counts as failed, and stands among "
             "the "
             "gaps. Equal steps have no error estimate, so they can. Of ours that choose their steps Dormand-Prince "
             "does, on "
             "Pleiades at 1e-2 and 1e-3. Who lets `confirmAdaptive` integrate once more, by a tenth of the tolerance, "
             "is "
             "told: a test does so with every row of ours that has a tolerance and an end."),
        note(
            "No error of a step, and no second run, tells of roundings that add up in what ought to stay as it is. The "
            "chemical problem E5, which is not among these, has such a sum: RODAS, whose linear systems let it drift, "
            "ends there wrong by more than the values' size without a word, and Radau is right (X34 E5 in [the "
            "extremes](stability.md)).")};
}

std::string page(const StudyRun& run) {
    int rounds = 0;
    for (const StudyRow& row : run.rows) rounds = std::max(rounds, row.rounds);
    std::string text =
        "# Error and time of the integrators\n\n"
        "What each integrator of `mv/motion` takes for how small an error, on known problems, most of them stiff, "
        "beside\n"
        "CVODE of SUNDIALS and the Rosenbrock method of Boost.Odeint.\n\n"
        "Times are of an " +
        run.processor + ", " + std::to_string(run.threads) +
        " threads, of which a run uses one: medians and median absolute deviations of up to " + std::to_string(rounds) +
        "\ninterleaved runs. Written by `build/bin/mvgl-bench work-precision --write docs`, with " + run.renderer +
        ".\nA test measures the errors and counts of ours and Odeint's again. Do not edit.\n\n"
        "![Time against error for all methods on eight problems](work-precision.svg)\n\n## What it shows\n\n"
        "Milliseconds at equal errors, interpolated along each one's curve, of the method that is the fastest "
        "there:\n\n" +
        equalErrorTable(run) + "\n" +
        "Under each claim stands what was evaluated, and what a test requires of it.\n\n" +
        saysText(atEqualErrors(run), sayingsAtEqualErrors()) + saysText(run, sayings()) +
        "\n## How it was measured\n\n"
        "- The error is the largest, over all components and over the *stops*, of |y - reference| / max(|reference|, "
        "floor).\n"
        "  Stops are each tenth power of ten before the end, and, but for Robertson's reaction, whose time is "
        "logarithmic,\n"
        "  the tenths of the time. A component below the floor counts as if it were as large.\n"
        "- A tolerance p is relative, and times the floor it is absolute, for everybody alike. p of equal steps is "
        "their\n"
        "  number between two stops.\n"
        "- References: " +
        run.reference +
        ".\n  Formulas and arithmetic are another's than what is measured; the published ends of Robertson, van der "
        "Pol, "
        "HIRES,\n  Oregonator and Pleiades agree with them to 2e-13.\n"
        "- Ours and Odeint's end a step at each stop; CVODE interpolates there, which is its own way and costs it no "
        "steps.\n"
        "  CVODE's memory is made before the clock runs, ours while it does. CVODE has the analytic Jacobian where "
        "there is\n"
        "  one, and the chain as a band of its best order. Odeint's matrices are dense.\n"
        "- No solver may try more than " +
        std::to_string(mostSteps) + " steps by tolerance.\n- *best*: " + bestText(run) + ".\n";
    for (const std::string& scene : scenesOf(run)) {
        text += "\n## " + scene + "\n\n" + rowTable(run, scene) + gapList(run, scene);
    }
    return text;
}

}  // namespace mv::work_precision

// The errors and times of the integrators beside CVODE and Odeint, and the page that shows them.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <thread>

#include "bench/benches.h"
#include "bench/cvode.h"
#include "mv/error.h"
#include "mv/image/file.h"
#include "mv/study/study.h"
#include "work_precision/page.h"

namespace mv::bench {
namespace {

namespace fs = std::filesystem;
using work_precision::Outcome;
using work_precision::Problem;
using work_precision::Solver;

double millisecondsOf(const std::function<Outcome()>& run, int times) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < times; ++i) (void)run();
    const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - start;
    return passed.count() / times;
}

struct Timed {
    StudyRow row;
    std::function<Outcome()> run;
    int repeats, rounds;
    std::vector<double> times = {};
};

// Runs of a millisecond or longer, in turn, the order turning about, the first dropped. Slow ones have fewer rounds, so that
// all of it takes minutes.
void timeRows(std::vector<Timed>& rows) {
    constexpr int mostRounds = 15;
    for (int round = 0; round <= mostRounds; ++round) {
        for (std::size_t k = 0; k < rows.size(); ++k) {
            Timed& timed = rows[round % 2 == 0 ? k : rows.size() - 1 - k];
            if (round > timed.rounds) continue;
            const double ms = millisecondsOf(timed.run, timed.repeats);
            if (round > 0) timed.times.push_back(ms);
        }
    }
    for (Timed& timed : rows) {
        timed.row.msMedian = median(timed.times);
        timed.row.msMad = medianDeviation(timed.times);
        timed.row.rounds = timed.rounds;
    }
}

}  // namespace

void workPrecisionReferences() {
    std::vector<std::pair<std::string, work_precision::States>> references;
    for (const Problem& problem : work_precision::problems()) {
        std::cerr << "the reference of " << problem.ode.name << " ...\n";
        references.emplace_back(problem.ode.name, work_precision::computedReference(problem));
    }
    std::cout << work_precision::referencesText(references);
}

void workPrecisionBench(const std::string& folder) {
    std::vector<Solver> solvers = work_precision::ourSolvers();
    solvers.push_back(work_precision::odeintRosenbrock());
    for (Solver& solver : cvodeSolvers()) solvers.push_back(std::move(solver));
    const bool hasCvode = !cvodeVersion().empty();
    if (!hasCvode && !folder.empty()) {
        throw Error("work-precision",
                    "must be built with CVODE to write the page, which speaks of it (package libsundials-dev)");
    }
    if (!hasCvode) std::cerr << "without CVODE (package libsundials-dev): rows alone, and none of it\n";

    StudyRun run = work_precision::emptyRun();
    run.processor = processorName();
    run.threads = static_cast<int>(std::thread::hardware_concurrency());
    for (const Problem& problem : work_precision::problems()) {
        std::cerr << problem.ode.name << " ...\n";
        std::vector<Timed> timed;
        std::vector<StudyRow> rows;
        std::vector<std::size_t> places;  // of the timed ones in rows
        for (const Solver& solver : solvers) {
            for (const double parameter : solver.parameters) {
                if (const std::string why = solver.refusal(problem, parameter); !why.empty()) {
                    rows.push_back(rowLeftOut(problem, solver, parameter, why));
                    continue;
                }
                auto one = solver.prepare(problem, parameter);
                const auto start = std::chrono::steady_clock::now();
                rows.push_back(rowOf(problem, solver, parameter, one()));
                const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - start;
                if (!rows.back().ok()) continue;
                const double ms = passed.count();
                places.push_back(rows.size() - 1);
                timed.push_back({.row = rows.back(),
                                 .run = std::move(one),
                                 .repeats = std::clamp(static_cast<int>(1 / ms), 1, 200),
                                 .rounds = ms < 10    ? 15
                                           : ms < 100 ? 7
                                                      : 3});
            }
        }
        timeRows(timed);
        for (std::size_t i = 0; i < timed.size(); ++i) rows[places[i]] = timed[i].row;
        std::ranges::move(rows, std::back_inserter(run.rows));
    }

    // The page shows the numbers as the file keeps them.
    const std::string rows = work_precision::rowsText(run, cvodeVersion());
    if (!hasCvode) {
        std::cout << rows;
        return;
    }
    const StudyRun kept = work_precision::rowsFrom(rows);
    const std::string page = work_precision::page(kept);
    if (folder.empty()) {
        std::cout << page;
        return;
    }
    const std::string curve = studySvg(kept);
    writeFileAtomically(fs::path(folder) / "work-precision.csv", std::string_view(rows));
    writeFileAtomically(fs::path(folder) / "work-precision.svg", std::string_view(curve));
    writeFileAtomically(fs::path(folder) / "work-precision.md", std::string_view(page));
}

}  // namespace mv::bench

#include "work_precision/problem.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

#include "mv/error.h"

namespace mv::work_precision {

std::vector<Problem> problems() {
    // How many powers of ten before the end the first stop lies.
    static const std::map<std::string, int> decades{{"undamped spring", 2}, {"damped spring", 2}, {"stiff chain", 5},
                                                    {"Robertson", 15},      {"van der Pol", 7},   {"HIRES", 4},
                                                    {"Oregonator", 5},      {"Pleiades", 2}};
    std::vector<Problem> result;
    for (OdeCase& ode : odeCases()) {
        Problem problem;
        for (int k = decades.at(ode.name); k >= 1; --k) problem.stops.push_back(ode.end * std::pow(10.0, -k));
        for (int tenth = 2; tenth <= 9 && ode.name != "Robertson"; ++tenth) {
            problem.stops.push_back(ode.end * tenth / 10);
        }
        problem.stops.push_back(ode.end);
        // The value of OdeCase::absolute with a relative tolerance of 1e-6.
        problem.floor = 1e6 * ode.absolute;
        problem.ode = std::move(ode);
        result.push_back(std::move(problem));
    }
    return result;
}

std::string referencesText(const std::vector<std::pair<std::string, States>>& references) {
    std::string text = "problem,stop,component,value\n";
    for (const auto& [name, states] : references) {
        for (std::size_t stop = 0; stop < states.size(); ++stop) {
            for (std::size_t i = 0; i < states[stop].size(); ++i) {
                char value[32];
                std::snprintf(value, sizeof value, "%.17g", states[stop][i]);
                text += name + "," + std::to_string(stop) + "," + std::to_string(i) + "," + value + "\n";
            }
        }
    }
    return text;
}

namespace {

std::map<std::string, States> readReferences() {
    const std::string name = WORK_PRECISION_REFERENCES;
    std::ifstream stream(name);
    if (!stream) throw Error(name, "must be there: mvgl-bench work-precision --references writes it");
    std::map<std::string, States> result;
    std::string line;
    std::getline(stream, line);
    while (std::getline(stream, line)) {
        std::istringstream cells(line);
        std::string problem, stop, component, value;
        std::getline(cells, problem, ',');
        std::getline(cells, stop, ',');
        std::getline(cells, component, ',');
        std::getline(cells, value, ',');
        States& states = result[problem];
        const auto at = static_cast<std::size_t>(std::atoi(stop.c_str()));
        if (states.size() <= at) states.resize(at + 1);
        if (value.empty() || std::to_string(states[at].size()) != component) {
            throw Error(name, "each line must be the next component", line);
        }
        states[at].push_back(std::strtod(value.c_str(), nullptr));
    }
    return result;
}

}  // namespace

States committedReference(const Problem& problem) {
    static const std::map<std::string, States> all = readReferences();
    const auto found = all.find(problem.ode.name);
    if (found == all.end() || found->second.size() != problem.stops.size()) {
        throw Error("references.csv", "must have the stops of each problem", problem.ode.name);
    }
    return found->second;
}

Deviation deviationOf(const Problem& problem, const States& states, const States& reference) {
    Deviation error;
    double sum = 0;
    for (std::size_t stop = 0; stop < reference.size(); ++stop) {
        for (std::size_t i = 0; i < reference[stop].size(); ++i) {
            const double size = std::max(std::abs(reference[stop][i]), problem.floor);
            double part = std::abs(states.at(stop).at(i) - reference[stop][i]) / size;
            if (!std::isfinite(part)) part = std::numeric_limits<double>::infinity();
            error.largest = std::max(error.largest, part);
            sum += part * part;
            ++error.values;
        }
    }
    error.rootMeanSquare = std::sqrt(sum / static_cast<double>(error.values));
    return error;
}

}  // namespace mv::work_precision

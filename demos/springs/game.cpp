#include "game.h"

#include <algorithm>
#include <cmath>

#include "mv/formatted.h"
#include "mv/gl/text.h"

namespace mv {

namespace {

constexpr double stillness = 1e-6;  // m/s, and m/s^2

}  // namespace

SpringGame::SpringGame(const SpringRule& rule) : rule_(rule), setup_(makeSprings(rule.springs)) {
    stepper_ = stepperAt(0, setup_.start);
    first_ = energy();
    rests_ = isStill();
    sample(0);
}

SpringStepper SpringGame::stepperAt(double time, const std::vector<double>& state) const {
    const double step = frameTime / rule_.substeps;
    if (!rule_.method) return {setup_.system, time, step, state};
    return {setup_.system, *rule_.method, time, step, state};
}

// The hand, and a change of a knob, change the energy at once. Count that as work.
void SpringGame::take(const SpringRule& rule, double time) {
    const double before = energy();
    std::vector<double> state = stepper_->state();
    rule_ = rule;
    setup_ = makeSprings(rule.springs);
    if (setup_.hasHand) {
        const std::size_t at = state.size() / 2 - 3;
        state[at] = rule.springs.hand.x;
        state[at + 1] = rule.springs.hand.y;
    }
    dissipatedBefore_ = dissipated();
    halvedBefore_ = halved();
    stepper_ = stepperAt(time, state);
    work_ += energy() - before;
    mostWork_ = std::max(mostWork_, std::abs(work_));
    if (rests_) graph_.push_back({time, graph_.back().energy, graph_.back().balance});
    rests_ = false;
}

void SpringGame::advance(const SpringRule& rule, int index) {
    stepsNow_ = 0;
    if (!failure_.empty()) return;
    if (rule != rule_) take(rule, (index - 1) * frameTime);
    const bool isOne = rule.springs.scene == SpringScene::oneSpring;
    for (int i = 0; i < rule.substeps && failure_.empty(); ++i) {
        if (isOne) exact_ = swung(rule.springs, exact_, frameTime / rule.substeps);
        if (rests_) continue;
        const std::vector<double> before = stepper_->state();
        ++stepsNow_;
        if (stepper_->step()) {
            ++steps_;
            if (isOne) turned_ = turnBetween(rule.springs, before, stepper_->state());
        } else {
            const std::string& why = stepper_->failure();
            failure_ = "stopped at step " + std::to_string(steps_ + 1) + ", " +
                       formatted("%.3f s: ", (index - 1 + double(i) / rule.substeps) * frameTime) +
                       why.substr(why.find("because ") + 8);
        }
    }
    if (rests_) return;
    rests_ = isStill();
    sample(index * frameTime);
}

double SpringGame::energy() const {
    double weight = 0;
    for (const PointMass& point : setup_.system.points) {
        if (!point.isFixed) weight -= point.mass * setup_.system.gravity.y;
    }
    return springEnergy(setup_.system, stepper_->state()) + weight * lowerEdge;
}

double SpringGame::dissipated() const { return dissipatedBefore_ + stepper_->dissipated(); }

bool SpringGame::isStill() const {
    const std::vector<double>& y = stepper_->state();
    std::vector<double> slope(y.size());
    springProblem(setup_.system).slope(0, y, slope);
    return std::ranges::all_of(slope, [](double rate) { return std::abs(rate) < stillness; });
}

double SpringGame::drift() const { return whole() > 0 ? (graph_.back().balance - first_) / whole() : 0; }

void SpringGame::sample(double time) {
    const double balance = energy() + dissipatedBefore_ + stepper_->dissipated() - work_;
    graph_.push_back({time, energy(), balance});
    largestDrift_ = std::max(largestDrift_, std::abs(drift()));
    if (graph_.size() > 1200) graph_.erase(graph_.begin(), graph_.begin() + 600);
}

}  // namespace mv

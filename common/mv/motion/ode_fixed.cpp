#include "mv/motion/ode_fixed.h"

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/motion/implicit_stage.h"
#include "mv/motion/one_step.h"
#include "mv/motion/radau_step.h"

namespace mv {
namespace {

using Values = std::vector<double>;

// Symplectic Euler and velocity Verlet: y is (q, v), and of the slope the second half is read.
class MechanicalStep {
  public:
    MechanicalStep(OdeMethod method, std::size_t dimension) : method_(method), slope_(dimension), moved_(dimension) {}

    std::string step(const OdeProblem& problem, double t, double h, std::span<const double> y, std::span<double> next,
                     OdeCounts& counts) {
        const std::size_t n = y.size() / 2;
        const auto evaluate = [&](double time, std::span<const double> at) {
            problem.slope(time, at, slope_);
            ++counts.evaluations;
            return allFinite(std::span(slope_).subspan(n));
        };
        if (!hasSlope_ && !evaluate(t, y)) return why;
        hasSlope_ = false;
        if (method_ == OdeMethod::symplecticEuler) {
            for (std::size_t i = 0; i < n; ++i) {
                next[n + i] = y[n + i] + h * slope_[n + i];
                next[i] = y[i] + h * next[n + i];
            }
            return allFinite(next) ? "" : why;
        }
        for (std::size_t i = 0; i < n; ++i) {
            const double a = slope_[n + i];
            moved_[i] = y[i] + h * (y[n + i] + h / 2 * a);
            moved_[n + i] = y[n + i] + h * a;
            next[n + i] = y[n + i] + h / 2 * a;
        }
        if (!allFinite(moved_) || !evaluate(t + h, moved_)) return why;
        for (std::size_t i = 0; i < n; ++i) {
            next[i] = moved_[i];
            next[n + i] += h / 2 * slope_[n + i];
        }
        hasSlope_ = problem.isVelocityFree;  // then it is the next step's, whatever the velocities
        return allFinite(next) ? "" : why;
    }
    void accept() {}

  private:
    static constexpr const char* why = "the acceleration or the state is not finite";
    OdeMethod method_;
    bool hasSlope_ = false;
    Values slope_, moved_;
};

// Implicit Euler, implicit midpoint, BDF2 and Radau. A step that fails is done in two halves, and so on.
class ImplicitStep {
  public:
    ImplicitStep(OdeMethod method, std::size_t dimension, const FixedOptions& options)
        : method_(method), halvings_(options.mostHalvings), stage_(options.newtonTolerance) {
        if (method == OdeMethod::radau) {
            radau_.emplace(RadauTolerance{options.newtonTolerance, 0, 1, mostRadauIterations}, dimension);
        }
    }

    std::string step(const OdeProblem& problem, double t, double h, std::span<const double> y, std::span<double> next,
                     OdeCounts& counts) {
        now_.assign(y.begin(), y.end());
        const std::int64_t accepted = counts.accepted;
        wasWhole_ = true;
        std::string why = halved(problem, t, h, now_, before_, next, 0, counts);
        // The step as a whole is counted by the stepper.
        counts.accepted = why.empty() ? counts.accepted - 1 : accepted;
        return why;
    }
    void accept() { before_ = wasWhole_ ? Past{now_, lastStep_} : Past{}; }

  private:
    // BDF2 reads the state one step, `step` long, before. There is none at the start, nor after a step that had to be
    // halved: across what was so steep a long step's difference says nothing of the slope, and would be carried on.
    struct Past {
        Values y;
        double step = 0;
    };

    std::string whole(const OdeProblem& problem, double t, double h, const Values& y, const Past& before,
                      std::span<double> next, OdeCounts& counts) {
        if (radau_) {
            std::string why = radau_->step(problem, t, h, y, next, counts);
            if (why.empty()) radau_->accept();
            return why;
        }
        const std::size_t n = y.size();
        std::ranges::copy(y, next.begin());
        if (method_ == OdeMethod::implicitMidpoint) {
            std::string why = stage_.solve(problem, t + h / 2, h / 2, y, next, counts);
            // The stage is the mean of the two ends: so h f, and what is left of its error times h J, is not needed.
            for (std::size_t i = 0; i < n; ++i) next[i] = 2 * next[i] - y[i];
            return why;
        }
        Values constant = y;
        double g = h;
        if (method_ == OdeMethod::bdf2 && !before.y.empty()) {
            // For steps of ratio r; equal ones have 4/3, -1/3 and 2/3. Source: Hairer, Norsett and Wanner I, III.5.
            const double r = h / before.step, past = r * r / (1 + 2 * r);
            for (std::size_t i = 0; i < n; ++i) constant[i] = y[i] + past * (y[i] - before.y[i]);
            g = h * (1 + r) / (1 + 2 * r);
        }
        return stage_.solve(problem, t + h, g, constant, next, counts);
    }

    std::string halved(const OdeProblem& problem, double t, double h, const Values& y, const Past& before,
                       std::span<double> next, int depth, OdeCounts& counts) {
        std::string why = whole(problem, t, h, y, before, next, counts);
        if (why.empty() && !allFinite(next)) why = "the state is not finite";
        if (why.empty()) {
            ++counts.accepted;
            lastStep_ = h;
            wasWhole_ = true;
            return "";
        }
        ++counts.rejected;
        if (depth == halvings_ || t + h / 4 == t) return why;
        Values middle(y.size());
        why = halved(problem, t, h / 2, y, before, middle, depth + 1, counts);
        if (!why.empty()) return why;
        why = halved(problem, t + h / 2, h / 2, middle, wasWhole_ ? Past{y, h / 2} : Past{}, next, depth + 1, counts);
        wasWhole_ = false;
        return why;
    }

    // A contraction by 0.25 will do for a tolerance of 1e-12.
    static constexpr int mostRadauIterations = 20;
    OdeMethod method_;
    int halvings_;
    ImplicitStage stage_;
    std::optional<RadauStep> radau_;
    Values now_;
    Past before_;
    double lastStep_ = 0;
    bool wasWhole_ = true;  // the step that was done last
};

using AnyStep = std::variant<RungeKuttaStep, RosenbrockStep, MechanicalStep, ImplicitStep>;

AnyStep makeStep(OdeMethod method, std::size_t dimension, const FixedOptions& options) {
    if (needsMechanical(method)) return MechanicalStep(method, dimension);
    if (method == OdeMethod::rodas) return RosenbrockStep(rodasCoefficients(), dimension);
    if (isImplicit(method)) return ImplicitStep(method, dimension, options);
    return RungeKuttaStep(tableau(method), dimension);
}

}  // namespace

struct FixedStepper::State {
    OdeProblem problem;
    OdeMethod method;
    double start, step;
    std::int64_t index = 0;
    Values y, next;
    AnyStep oneStep;
    OdeCounts counts = {};
    std::string failure = {};

    double time() const { return start + static_cast<double>(index) * step; }
};

void requireSteps(std::string_view subject, double start, double step, const FixedOptions& options) {
    requireFinite(subject, "t", start);
    requirePositive(subject, "the step", step);
    if (start + step == start) {
        throw Error(subject, "the step must be longer than the rounding of the start", numberText(step));
    }
    if (!(options.newtonTolerance >= 1e-13 && options.newtonTolerance <= 1e-3)) {
        throw Error(subject, "newtonTolerance must be 1e-13 to 0.001", numberText(options.newtonTolerance));
    }
    requireRange(subject, "mostHalvings", options.mostHalvings, 0, 40);
}

FixedStepper::FixedStepper(OdeProblem problem, OdeMethod method, double start, double step, std::vector<double> y,
                           const FixedOptions& options) {
    const std::string subject(methodName(method));
    requireProblem(subject, problem, start, y);
    requireSteps(subject, start, step, options);
    if (needsMechanical(method) && !problem.isMechanical) {
        throw Error(subject, "must have a mechanical problem, of positions and velocities");
    }
    const std::size_t dimension = problem.dimension;
    state_ = std::make_unique<State>(State{.problem = std::move(problem),
                                           .method = method,
                                           .start = start,
                                           .step = step,
                                           .y = std::move(y),
                                           .next = Values(dimension),
                                           .oneStep = makeStep(method, dimension, options)});
}

FixedStepper::FixedStepper(const FixedStepper& other) : state_(std::make_unique<State>(*other.state_)) {}
FixedStepper& FixedStepper::operator=(const FixedStepper& other) {
    if (this != &other) state_ = std::make_unique<State>(*other.state_);
    return *this;
}
FixedStepper::FixedStepper(FixedStepper&&) noexcept = default;
FixedStepper& FixedStepper::operator=(FixedStepper&&) noexcept = default;
FixedStepper::~FixedStepper() = default;

bool FixedStepper::step() {
    State& s = *state_;
    if (!s.failure.empty()) return false;
    const std::string why = std::visit(
        [&](auto& oneStep) {
            std::string reason = oneStep.step(s.problem, s.time(), s.step, s.y, s.next, s.counts);
            if (reason.empty()) oneStep.accept();
            return reason;
        },
        s.oneStep);
    if (!why.empty()) {
        s.failure = "gave up at t = " + numberText(s.time()) + ": no step " + std::to_string(s.index + 1) + " by " +
                    std::string(methodName(s.method)) + ", because " + why;
        return false;
    }
    std::swap(s.y, s.next);
    ++s.index;
    ++s.counts.accepted;
    return true;
}

std::int64_t FixedStepper::index() const { return state_->index; }
double FixedStepper::time() const { return state_->time(); }
std::span<const double> FixedStepper::state() const { return state_->y; }
const OdeCounts& FixedStepper::counts() const { return state_->counts; }
const std::string& FixedStepper::failure() const { return state_->failure; }

OdeResult integrateFixed(const OdeProblem& problem, OdeMethod method, double start, double end, std::int64_t steps,
                         std::vector<double> y, const FixedOptions& options) {
    requireFinite(methodName(method), "end", end);
    if (!(end > start)) throw Error(methodName(method), "end must be after start", numberText(end));
    if (steps < 1) throw Error(methodName(method), "there must be at least one step", std::to_string(steps));
    FixedStepper stepper(problem, method, start, (end - start) / static_cast<double>(steps), std::move(y), options);
    while (stepper.index() < steps && stepper.step()) {
    }
    return {.failure = stepper.failure(),
            .t = stepper.index() == steps ? end : stepper.time(),
            .y = {stepper.state().begin(), stepper.state().end()},
            .counts = stepper.counts()};
}

}  // namespace mv

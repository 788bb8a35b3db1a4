#include "mv/motion/ode_adaptive.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "mv/error.h"
#include "mv/math/require.h"
#include "mv/motion/one_step.h"
#include "mv/motion/radau_step.h"

namespace mv {
namespace {

using Values = std::vector<double>;

constexpr const char* errorTooLarge = "its error is above the tolerance";

void requireOptions(std::string_view subject, const AdaptiveOptions& options) {
    // Written so that NaN is refused.
    if (!(options.relative >= 1e-13 && options.relative <= 0.1)) {
        throw Error(subject, "the relative tolerance must be 1e-13 to 0.1", numberText(options.relative));
    }
    requirePositive(subject, "the absolute tolerance", options.absolute);
    if (options.firstStep != 0) requirePositive(subject, "the first step, where it is given,", options.firstStep);
    if (options.mostSteps < 1) throw Error(subject, "mostSteps must be 1 or more", std::to_string(options.mostSteps));
}

// The largest |x_i| in units of the tolerance at the sizes of a and b; the largest and not the mean square, so that no
// component hides behind many others.
double inTolerances(std::span<const double> x, std::span<const double> a, std::span<const double> b,
                    const AdaptiveOptions& options) {
    double size = 0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double tolerance = options.absolute + options.relative * std::max(std::abs(a[i]), std::abs(b[i]));
        size = std::max(size, std::abs(x[i]) / tolerance);
    }
    return size;
}

double shortestStep(double t) {
    return 16 * (std::nextafter(std::abs(t), std::numeric_limits<double>::infinity()) - std::abs(t));
}

// A first step that an explicit Euler step and the second derivative beside it bear out.
double firstStep(const OdeProblem& problem, double t, double length, const Values& y, int order,
                 const AdaptiveOptions& options, OdeCounts& counts) {
    Values slope(y.size()), moved(y), movedSlope(y.size());
    problem.slope(t, y, slope);
    ++counts.evaluations;
    if (!allFinite(slope)) return length * 1e-6;  // the step itself will say what is wrong
    const double size = inTolerances(y, y, y, options), speed = inTolerances(slope, y, y, options);
    double h = size < 1e-5 || speed < 1e-5 ? 1e-6 * length : 0.01 * size / speed;
    h = std::min(h, length);
    for (std::size_t i = 0; i < y.size(); ++i) moved[i] += h * slope[i];
    problem.slope(t + h, moved, movedSlope);
    ++counts.evaluations;
    if (!allFinite(movedSlope)) return h / 100;
    for (std::size_t i = 0; i < y.size(); ++i) movedSlope[i] = (movedSlope[i] - slope[i]) / h;
    const double largest = std::max(speed, inTolerances(movedSlope, y, y, options));
    const double byBoth = largest <= 1e-15 ? std::max(1e-6 * length, h * 1e-3) : std::pow(0.01 / largest, 1.0 / order);
    return std::min({100 * h, byBoth, length});
}

// The bound for radau's error estimate, which is of order 3 in a method of order 5: then the error at the end follows
// the tolerance asked for, as that of the other methods does. Source: Hairer and Wanner's code RADAU5.
AdaptiveOptions forRadau(AdaptiveOptions options) {
    const double relative = 0.1 * std::pow(options.relative, 2.0 / 3);
    options.absolute *= relative / options.relative;
    options.relative = relative;
    return options;
}

// Proportional and integral control of the step by the error e of this step and of the one before, both in tolerances.
class StepControl {
  public:
    explicit StepControl(int order) : beta_(0.04), alpha_(1.0 / order - 0.75 * beta_) {}

    template <typename OneStep>
    double afterAccepted(double e, double, const OneStep&) {
        const double factor = std::pow(std::max(e, 1e-10), -alpha_) * std::pow(before_, beta_) * safety;
        before_ = std::max(e, 1e-4);
        const double most = wasRejected_ ? 1.0 : 8.0;
        wasRejected_ = false;
        return std::clamp(factor, 0.2, most);
    }
    template <typename OneStep>
    double afterRejected(double e, const OneStep&) {
        wasRejected_ = true;
        return std::clamp(std::pow(e, -alpha_) * safety, 0.1, 0.9);
    }
    // The step without an error to go by.
    double afterFailed() {
        wasRejected_ = true;
        return 0.1;
    }

  private:
    static constexpr double safety = 0.9;
    double beta_, alpha_, before_ = 1e-4;
    bool wasRejected_ = false;
};

// Radau's step: by the error of this step and, after two accepted ones, by how it grew from one to the other; more
// careful where Newton's method worked hard; and what would be hardly longer stays as it is, with its matrices. Source:
// Gustafsson (1994); Hairer and Wanner II, IV.8.
class PredictiveControl {
  public:
    double afterAccepted(double e, double h, const RadauStep& step) {
        double factor = byError(e, step);
        if (lastStep_ > 0) {
            const double grown = safety * (h / lastStep_) * std::pow(lastError_ / (e * e), 0.25);
            factor = std::min(factor, std::clamp(grown, shortest, longest));
        }
        lastStep_ = h;
        lastError_ = std::max(e, 1e-2);
        if (wasRejected_) factor = std::min(factor, 1.0);
        wasRejected_ = false;
        return step.keepsJacobian() && factor >= 1 && factor <= 1.2 ? 1 : factor;
    }
    double afterRejected(double e, const RadauStep& step) {
        wasRejected_ = true;
        return lastStep_ == 0 ? 0.1 : std::min(byError(e, step), 0.9);
    }
    double afterFailed() {
        wasRejected_ = true;
        return 0.5;
    }

  private:
    static constexpr double safety = 0.9, shortest = 0.2, longest = 8;
    static double byError(double e, const RadauStep& step) {
        const int most = step.mostIterations();
        const double careful = safety * (1 + 2 * most) / (step.iterations() + 2 * most);
        return std::clamp(std::min(safety, careful) * std::pow(std::max(e, 1e-10), -0.25), shortest, longest);
    }
    double lastStep_ = 0, lastError_ = 1e-2;
    bool wasRejected_ = false;
};

template <typename OneStep, typename Control>
OdeResult integrate(const OdeProblem& problem, OdeMethod method, OneStep oneStep, Control control, double start,
                    double end, Values y, const AdaptiveOptions& options) {
    OdeResult result{.t = start, .y = std::move(y)};
    OdeCounts& counts = result.counts;
    Values next(problem.dimension);
    std::array<Values, 3> vectors;
    double h = options.firstStep > 0
                   ? std::min(options.firstStep, end - start)
                   : firstStep(problem, start, end - start, result.y, methodOrder(method), options, counts);
    std::string last = "there was none";
    auto stop = options.stops.begin();
    const auto giveUp = [&](const std::string& why) {
        result.failure = "gave up at t = " + numberText(result.t) + " after " + std::to_string(counts.accepted) +
                         " steps by " + std::string(methodName(method)) + ", because " + why +
                         "; the step that failed last: " + last;
        return std::move(result);
    };

    while (result.t < end) {
        if (counts.accepted + counts.rejected == options.mostSteps) {
            return giveUp(std::to_string(options.mostSteps) + " steps are not enough, the next one being " +
                          numberText(h) + " long");
        }
        if (!(h >= shortestStep(result.t))) {
            return giveUp("a step of " + numberText(h) + " would be shorter than 16 roundings of t");
        }
        // The last step ends at the end or stop, and none is left over that would be too short.
        const double target = stop != options.stops.end() ? *stop : end, wanted = h;
        const bool isLast = h * 1.01 >= target - result.t;
        if (isLast) h = target - result.t;
        const double to = isLast ? target : result.t + h;

        const std::string why = oneStep.step(problem, result.t, h, result.y, next, counts);
        const double error =
            why.empty() ? inTolerances(oneStep.error(), result.y, next, options) : std::numeric_limits<double>::max();
        if (!(error <= 1)) {
            ++counts.rejected;
            last = why.empty() ? errorTooLarge : why;
            h *= why.empty() && std::isfinite(error) ? control.afterRejected(error, oneStep) : control.afterFailed();
            continue;
        }
        ++counts.accepted;
        if (options.observe) {
            oneStep.dense(h, result.y, next, vectors);
            options.observe(AcceptedStep(result.t, to, result.y, next, vectors));
        }
        oneStep.accept();
        std::swap(result.y, next);
        result.t = to;
        h *= control.afterAccepted(error, h, oneStep);
        if (isLast && stop != options.stops.end()) {
            result.atStops.push_back(result.y);
            ++stop;
            h = std::max(h, wanted);  // which the stop cut short
        }
    }
    return result;
}

}  // namespace

void AcceptedStep::at(double t, std::span<double> y) const {
    if (!(t >= from_ && t <= to_)) {
        throw Error("AcceptedStep", "t must be from " + numberText(from_) + " to " + numberText(to_), numberText(t));
    }
    if (y.size() != after_.size()) {
        throw Error("AcceptedStep", "the result must have room for " + std::to_string(after_.size()) + " numbers",
                    std::to_string(y.size()));
    }
    const double x = (t - from_) / (to_ - from_);
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double inner = (*vectors_)[1][i] + (1 - x) * (*vectors_)[2][i];
        y[i] = before_[i] + x * (after_[i] - before_[i] + (1 - x) * ((*vectors_)[0][i] + x * inner));
    }
}

OdeResult integrateAdaptive(const OdeProblem& problem, OdeMethod method, double start, double end,
                            std::vector<double> y, const AdaptiveOptions& options) {
    const std::string_view subject = methodName(method);
    requireProblem(subject, problem, start, y);
    requireFinite(subject, "end", end);
    if (!(end > start)) throw Error(subject, "end must be after start", numberText(end));
    requireFinite(subject, "end - start", end - start);
    requireOptions(subject, options);
    for (double before = start; const double stop : options.stops) {
        if (!(stop > before && stop <= end)) {
            throw Error(subject, "stops must ascend from after the start to the end", numberText(stop));
        }
        before = stop;
    }
    switch (method) {
        case OdeMethod::dormandPrince:
            return integrate(problem, method, RungeKuttaStep(tableau(method), problem.dimension),
                             StepControl(methodOrder(method)), start, end, std::move(y), options);
        case OdeMethod::rodas:
            return integrate(problem, method, RosenbrockStep(rodasCoefficients(), problem.dimension),
                             StepControl(methodOrder(method)), start, end, std::move(y), options);
        case OdeMethod::radau: {
            const AdaptiveOptions own = forRadau(options);
            const double roundings = 10 * std::numeric_limits<double>::epsilon() / own.relative;
            const RadauTolerance tolerance{.relative = own.relative,
                                           .absolute = own.absolute,
                                           .newton = std::max(roundings, std::min(0.03, std::sqrt(own.relative))),
                                           .mostIterations = 7};
            return integrate(problem, method, RadauStep(tolerance, problem.dimension), PredictiveControl(), start, end,
                             std::move(y), own);
        }
        default:
            throw Error(subject,
                        "must be Dormand-Prince, RODAS or Radau to choose its steps: it has no error estimate");
    }
}

Confirmation confirmAdaptive(const OdeProblem& problem, OdeMethod method, double start, double end,
                             std::vector<double> y, const AdaptiveOptions& options, const OdeResult& result,
                             double allowed) {
    constexpr const char* subject = "confirmAdaptive";
    requirePositive(subject, "the allowed difference", allowed);
    if (!result.reachedEnd()) throw Error(subject, "the result must have reached the end", result.failure);
    if (result.y.size() != y.size() || result.atStops.size() != options.stops.size()) {
        throw Error(
            subject, "the result must be of this problem and these stops",
            std::to_string(result.y.size()) + " numbers at " + std::to_string(result.atStops.size()) + " stops");
    }
    AdaptiveOptions finer = options;
    finer.relative /= 10;
    finer.absolute /= 10;
    finer.observe = {};
    const OdeResult second = integrateAdaptive(problem, method, start, end, std::move(y), finer);
    Confirmation confirmation{.counts = second.counts};
    if (!second.reachedEnd()) {
        confirmation.doubt = "by a tenth of the tolerance it " + second.failure;
        return confirmation;
    }
    double time = end;
    const auto compare = [&](const Values& a, const Values& b, double t) {
        for (std::size_t i = 0; i < a.size(); ++i) {
            const double size = std::max(std::abs(b[i]), options.absolute / options.relative);
            const double difference = std::abs(a[i] - b[i]) / size;
            if (difference <= confirmation.difference) continue;
            confirmation.difference = difference;
            time = t;
        }
    };
    for (std::size_t k = 0; k < options.stops.size(); ++k) {
        compare(result.atStops[k], second.atStops[k], options.stops[k]);
    }
    compare(result.y, second.y, end);
    if (confirmation.difference > allowed) {
        confirmation.doubt = "by a tenth of the tolerance, at t = " + numberText(time) + ", a component differs by " +
                             numberText(confirmation.difference) +
                             " of its size: the problem spreads the errors of steps";
    }
    return confirmation;
}

}  // namespace mv

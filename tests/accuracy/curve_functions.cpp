// mv/motion: ease.h and curve.h. Splines and Catmull-Rom curves solve or divide by uneven spans, and what their errors are
// measured by would be as long as they are: tests/motion has them.
#include <algorithm>
#include <array>
#include <cmath>

#include "accuracy/function.h"
#include "mv/motion/curve.h"
#include "mv/motion/ease.h"

namespace mv::accuracy {
namespace {

Arguments parts(Random& random, Domain domain) {
    return {domain == Domain::whole ? random.logarithmic(1e-140, 1) : random.number(0, 1)};
}

Arguments partsAndSteepness(Random& random, Domain domain) {
    const bool isWhole = domain == Domain::whole;
    return {random.number(0, 1), isWhole ? random.logarithmic(1e-6, 1e6) : random.number(1, 50)};
}

// As the header defines it: the logistic function, shifted and scaled.
Wide logisticTruth(const Arguments& a) {
    const auto logistic = [&](const Wide& t) { return 1 / (1 + exp(-Wide(a[1]) * (t - Wide(0.5)))); };
    return (logistic(a[0]) - logistic(0)) / (logistic(1) - logistic(0));
}
Wide logisticSlopeTruth(const Arguments& a, const Wide& t) {
    const Wide q = exp(-Wide(a[1]) * (t - Wide(0.5))), end = exp(Wide(a[1]) / 2);
    return a[1] * q / ((1 + q) * (1 + q)) / (1 / (1 + 1 / end) - 1 / (1 + end));
}

// ---- curves through four keys: the time, the keys' times in any order, and their values

using Keys = std::vector<Keyframe<double>>;

Keys keysOf(const Arguments& a) {
    std::array<double, 4> times{a[1], a[2], a[3], a[4]};
    std::ranges::sort(times);
    Keys keys;
    for (std::size_t i = 0; i < 4; ++i) keys.push_back({times[i], a[5 + i]});
    return keys;
}

Arguments fourKeys(Random& random, Domain domain) {
    const double size = domain == Domain::whole ? 15 : 3;
    for (;;) {
        Arguments a{};
        const double scale = anyScale(random, domain, 15);
        const double apart = domain == Domain::whole ? random.logarithmic(1e-4, 1) : 1.0;
        for (std::size_t i = 1; i < 5; ++i) a[i] = scale * (1 + apart * random.number(-1, 1));
        for (std::size_t i = 5; i < 9; ++i) a[i] = anyNumber(random, domain, size);
        const auto [low, high] = std::minmax({a[1], a[2], a[3], a[4]});
        a[0] = low + random.number(0, 1) * (high - low);
        if (a[0] >= low && a[0] <= high) return a;
    }
}

// The sum of basis[i] times value i; its error is measured by those terms without their signs, or by the largest value.
Truth sumTruth(const Keys& keys, const std::array<Wide, 4>& basis, bool isByTerms) {
    Wide sum = 0, terms = 0, largest = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        sum += basis[i] * keys[i].value;
        terms += abs(basis[i] * keys[i].value);
        largest = std::max<Wide>(largest, abs(Wide(keys[i].value)));
    }
    Truth truth = entrywise({sum});
    truth.sizes = {sizeOf(isByTerms ? terms : largest)};
    return truth;
}

Truth lagrangeTruth(const Arguments& a) {
    const Keys keys = keysOf(a);
    std::array<Wide, 4> basis;
    for (std::size_t j = 0; j < 4; ++j) {
        basis[j] = 1;
        for (std::size_t k = 0; k < 4; ++k) {
            if (k != j) basis[j] *= (Wide(a[0]) - keys[k].time) / (Wide(keys[j].time) - keys[k].time);
        }
    }
    return sumTruth(keys, basis, true);
}

Truth bezierTruth(const Arguments& a) {
    const Keys keys = keysOf(a);
    const Wide u = (Wide(a[0]) - keys[0].time) / (Wide(keys[3].time) - keys[0].time), v = 1 - u;
    return sumTruth(keys, {v * v * v, 3 * u * v * v, 3 * u * u * v, u * u * u}, false);
}

// The span of a time, and how far in it.
struct Place {
    std::size_t span;
    Wide u;
};
Place placeOf(const Arguments& a, const Keys& keys) {
    std::size_t span = 0;
    while (span < 2 && keys[span + 1].time <= a[0]) ++span;
    return {span, (Wide(a[0]) - keys[span].time) / (Wide(keys[span + 1].time) - keys[span].time)};
}

Truth linearTruth(const Arguments& a) {
    const Keys keys = keysOf(a);
    const auto [span, u] = placeOf(a, keys);
    std::array<Wide, 4> basis{};
    basis[span] = 1 - u;
    basis[span + 1] = u;
    return sumTruth(keys, basis, false);
}

Truth bSplineTruth(const Arguments& a) {
    const Keys keys = keysOf(a);
    const auto [span, u] = placeOf(a, keys);
    const Wide v = 1 - u;
    const Wide parts[] = {v * v * v / 6, (3 * u * u * u - 6 * u * u + 4) / 6, (3 * v * v * v - 6 * v * v + 4) / 6,
                          u * u * u / 6};
    std::array<Wide, 4> basis{};
    for (std::size_t k = 0; k < 4; ++k) {
        // The control point before the first is 2 p[0] - p[1], that behind the last alike.
        const std::size_t at = span + k;
        if (at == 0 || at == 5) {
            basis[at == 0 ? 0 : 3] += 2 * parts[k];
            basis[at == 0 ? 1 : 2] -= parts[k];
        } else {
            basis[at - 1] += parts[k];
        }
    }
    return sumTruth(keys, basis, false);
}

Function curveFunction(const std::string& name, const std::string& returns, const std::string& measured, double bound,
                       const std::string& reason, Truth (*truth)(const Arguments&),
                       Curve<double> (*make)(const Keys&)) {
    return withForms({.name = name,
                      .header = "motion/curve.h",
                      .returns = returns + ", made and asked once (timed and measured: four keys)",
                      .measured = measured,
                      .domain = "times 1e-4 to 1 of their size apart, times and values 1e-15 to 1e15",
                      .bound = bound,
                      .reason = reason,
                      .sample = fourKeys,
                      .truth = truth,
                      .limits = "numbers 0, or from 1e-20 to 1e20 in size",
                      .within = sizesBetween(1e-20, 1e20)},
                     [make](const Arguments& a) { return make(keysOf(a)).position(a[0]); });
}

}  // namespace

std::vector<Function> easeFunctions() {
    const auto eased = [](const std::string& name, const std::string& returns, double (*ease)(double),
                          Wide (*truth)(const Wide&)) {
        return withForms({.name = name,
                          .header = "motion/ease.h",
                          .returns = returns,
                          .measured = "entrywise",
                          .domain = "t from 1e-140 to 1",
                          .reason = "",
                          .sample = parts,
                          .truth = [truth](const Arguments& a) { return entrywise({truth(Wide(a[0]))}); },
                          .limits = "t 0, or from 1e-150",
                          .within = sizesBetween(1e-150, 1)},
                         [ease](const Arguments& a) { return ease(a[0]); });
    };
    std::vector<Function> list;
    list.push_back(eased("rootEase", "√t", rootEase, [](const Wide& t) { return sqrt(t); }));
    list.push_back(eased("rootEaseSlope", "1/(2√t)", rootEaseSlope, [](const Wide& t) { return 1 / (2 * sqrt(t)); }));
    list.push_back(eased("quadraticEase", "t²", quadraticEase, [](const Wide& t) { return t * t; }));
    list.push_back(eased("quadraticEaseSlope", "2t", quadraticEaseSlope, [](const Wide& t) { return 2 * t; }));
    list.push_back(withForms({.name = "logisticEase",
                              .header = "motion/ease.h",
                              .returns = "the logistic curve from 0 to 1",
                              .measured = "ulp of 1",
                              .domain = "steepness 1e-6 to 1e6",
                              .reason = "",
                              .sample = partsAndSteepness,
                              .truth =
                                  [](const Arguments& a) {
                                      Truth truth = entrywise({logisticTruth(a)});
                                      truth.sizes = {Wide(1)};
                                      return truth;
                                  }},
                             [](const Arguments& a) { return logisticEase(a[0], a[1]); }));
    list.push_back(withForms({.name = "logisticEaseSlope",
                              .header = "motion/ease.h",
                              .returns = "its slope",
                              .measured = "ulp of the steepest slope",
                              .domain = "steepness 1e-6 to 1e6",
                              .reason = "",
                              .sample = partsAndSteepness,
                              .truth =
                                  [](const Arguments& a) {
                                      Truth truth = entrywise({logisticSlopeTruth(a, a[0])});
                                      truth.sizes = {logisticSlopeTruth(a, Wide(0.5))};
                                      return truth;
                                  }},
                             [](const Arguments& a) { return logisticEaseSlope(a[0], a[1]); }));
    return list;
}

std::vector<Function> curveFunctions() {
    const std::string byLargest = "ulp of the largest key";
    return {
        curveFunction("linear", "a place on the line from key to key", byLargest, 10,
                      "roundings: three of the part of the span, which moves by twice a key, and four of the sum",
                      linearTruth, [](const Keys& keys) { return Curve<double>::linear(keys); }),
        curveFunction("lagrange", "a place on the polynomial through keys",
                      "ulp of the sum of its terms without their signs", 28,
                      "roundings: 10 of a weight, 4 of its quotient, 5 of the sum, 9 of the product of distances",
                      lagrangeTruth, Curve<double>::lagrange),
        curveFunction("bSpline", "a place on the B-spline", byLargest, 20,
                      "roundings: three of the part of the span, which moves by a key, four of a control point, and "
                      "ten of the sum",
                      bSplineTruth, [](const Keys& keys) { return Curve<double>::bSpline(keys); }),
        curveFunction("bezier", "a place on the Bezier curve", byLargest, 28,
                      "roundings: three of the part of the span, which moves by six times a key, and three of each "
                      "of three levels",
                      bezierTruth, Curve<double>::bezier)};
}

}  // namespace mv::accuracy

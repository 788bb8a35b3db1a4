#include "accuracy/function.h"

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "mv/error.h"

namespace mv::accuracy {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// The gap between neighbouring numbers at this size: of doubles or of floats.
Wide lastPlace(const Wide& size, bool isFloat) {
    const int digits = isFloat ? 24 : 53, least = isFloat ? -149 : -1074;
    if (size == 0) return ldexp(Wide(1), least);
    return ldexp(Wide(1), std::max(static_cast<int>(ilogb(size)) - (digits - 1), least));
}

bool allFinite(const std::vector<Wide>& values) {
    for (const Wide& value : values) {
        if (!isfinite(value)) return false;
    }
    return true;
}

void normalize(std::vector<Wide>& values) {
    Wide squares = 0;
    for (const Wide& value : values) squares += value * value;
    if (squares == 0) return;
    const Wide size = sqrt(squares);
    for (Wide& value : values) value /= size;
}

// The largest error of a block, in ulp and as a part of the block's largest entry.
CallError errorOf(std::vector<Wide> values, Truth truth, bool isFloat) {
    if (values.size() != truth.values.size()) throw std::logic_error("forms and truth must have equally many values");
    if (!allFinite(values)) return {infinite, infinite};
    if (truth.anyScale) {
        normalize(values);
        normalize(truth.values);
    }
    for (std::size_t i = 0; i < truth.weights.size(); ++i) {
        values[i] *= truth.weights[i];
        truth.values[i] *= truth.weights[i];
    }
    CallError worst{.closeness = truth.closeness};
    std::size_t i = 0;
    for (std::size_t block = 0; block < truth.blocks.size(); ++block) {
        const std::size_t length = truth.blocks[block];
        Wide size = truth.sizes.empty() ? Wide(0) : truth.sizes[block], difference = 0;
        for (const std::size_t end = i + length; i < end; ++i) {
            if (truth.sizes.empty()) size = std::max<Wide>(size, abs(truth.values[i]));
            difference = std::max<Wide>(difference, abs(values[i] - truth.values[i]));
        }
        if (size >= anySize) continue;
        worst.ulp = std::max(worst.ulp, static_cast<double>(difference / lastPlace(size, isFloat)));
        if (difference != 0) {
            worst.part = std::max(worst.part, size == 0 ? infinite : static_cast<double>(difference / size));
        }
    }
    if (i != values.size()) throw std::logic_error("the blocks must cover all values");
    return worst;
}

Arguments asFloats(Arguments arguments) {
    for (double& value : arguments) value = static_cast<double>(static_cast<float>(value));
    return arguments;
}

}  // namespace

Truth entrywise(std::vector<Wide> values) {
    const std::size_t count = values.size();
    return {std::move(values), std::vector<std::size_t>(count, 1)};
}
Truth oneBlock(std::vector<Wide> values) {
    const std::size_t count = values.size();
    return {std::move(values), {count}};
}

CallError errorOfCall(const Function& function, const Form& form, const Arguments& given) {
    const Arguments arguments = form.isFloat ? asFloats(given) : given;
    std::vector<Wide> values;
    try {
        values = form.values(arguments);
    } catch (const Error&) {
        return {.isRefused = true};
    }
    return errorOf(std::move(values), function.truth(arguments), form.isFloat);
}

Errors measure(const Function& function, const Form& form, Domain domain, long samples) {
    Random random(2024);
    Errors errors;
    double sum = 0;
    long summed = 0, lost = 0, refused = 0;
    for (long sample = 0; sample < samples; ++sample) {
        const CallError error = errorOfCall(function, form, function.sample(random, domain));
        if (error.isRefused) {
            ++refused;
            continue;
        }
        errors.max = std::max(errors.max, error.ulp);
        if (!(error.part <= 1e-6)) ++lost;
        if (std::isfinite(error.ulp)) {
            sum += error.ulp;
            ++summed;
        }
    }
    errors.mean = summed == 0 ? infinite : sum / static_cast<double>(summed);
    errors.lost = static_cast<double>(lost) / static_cast<double>(samples);
    errors.refused = static_cast<double>(refused) / static_cast<double>(samples);
    return errors;
}

const std::vector<Function>& functions() {
    static const std::vector<Function> all = [] {
        std::vector<Function> list;
        for (const auto& part :
             {typesFunctions(), transformFunctions(), projectionFunctions(), viewFormFunctions(), shadowFunctions(),
              otherFunctions(), robustFunctions(), colorFunctions(), colorDifferenceFunctions(), orientationFunctions(),
              turnFunctions(), easeFunctions(), usualEaseFunctions(), curveFunctions()}) {
            list.insert(list.end(), part.begin(), part.end());
        }
        return list;
    }();
    return all;
}

const std::vector<Function>& attackedFunctions() {
    static const std::vector<Function> all = [] {
        std::vector<Function> list = functions();
        for (Function& function : intersectionFunctions()) list.push_back(std::move(function));
        for (Function& function : twoLinkFunctions()) list.push_back(std::move(function));
        return list;
    }();
    return all;
}

std::vector<const Form*> ownForms(const Function& function) {
    std::vector<const Form*> forms;
    for (const Form& form : function.forms) {
        if (form.name.rfind("mv", 0) == 0) forms.push_back(&form);
    }
    return forms;
}

void put(Arguments& a, std::size_t i, const vec3& v) {
    for (int k = 0; k < 3; ++k) a[i + static_cast<std::size_t>(k)] = v[k];
}
void put(Arguments& a, std::size_t i, const vec4& v) {
    for (int k = 0; k < 4; ++k) a[i + static_cast<std::size_t>(k)] = v[k];
}
void put(Arguments& a, std::size_t i, const mat4& m) {
    for (int column = 0; column < 4; ++column) put(a, i + 4 * static_cast<std::size_t>(column), m[column]);
}

double anyNumber(Random& random, Domain domain, double size) {
    const double exponent = domain == Domain::whole ? size : 3;
    const double sign = random.sign();
    return sign * std::pow(10.0, random.number(-exponent, exponent));
}

double anyScale(Random& random, Domain domain, double size) {
    return domain == Domain::whole ? std::exp2(std::floor(random.number(-size, size) * 3.32)) : 1;
}

std::function<bool(const Arguments&)> sizesBetween(double least, double most) {
    return [=](const Arguments& a) {
        return std::all_of(a.begin(), a.end(), [=](double number) {
            const double size = std::abs(number);
            return size == 0 || (size >= least && size <= most);
        });
    };
}
std::function<bool(const Arguments&)> quotientSizes() { return sizesBetween(1e-100, 1e100); }

bool isPictureSize(double size) { return size >= 1 && size <= 16384 && size == std::floor(size); }

std::vector<Wide> valuesOf(const test::WideMatrix& m) {
    std::vector<Wide> values;
    for (const auto& column : m.column) values.insert(values.end(), column.element.begin(), column.element.end());
    return values;
}

Wide reducedRadians(double degrees) {
    int exponent = 0;
    const double mantissa = std::frexp(degrees, &exponent);  // degrees = mantissa 2^exponent, a whole number of 2^-53
    exponent -= 53;
    if (exponent <= 0) return test::wideRadians(fmod(Wide(degrees), Wide(360)));
    auto turn = static_cast<std::int64_t>(std::ldexp(mantissa, 53)) % 360;
    for (; exponent > 0; --exponent) turn = turn * 2 % 360;
    return test::wideRadians(Wide(turn));
}

}  // namespace mv::accuracy

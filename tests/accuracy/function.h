// How exact the functions of mv/math are: each with samples of its arguments, the true result, and GLM's form beside ours.
//
// Errors are in units of the last place ("ulp"): the gap between neighbouring doubles (for GLM's float form: floats) at the
// size of the true result. Where a result is a vector or a matrix, the size is that of the largest entry of a block, and
// each function says what its blocks are; half an ulp is what rounding alone costs.
#pragma once
#include <array>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "accuracy/values.h"
#include "support/random.h"
#include "support/wide.h"

namespace mv::accuracy {

using test::Random;
using test::Wide;

// The arguments of one call, in the order in which sample() and the forms of a function agree. What is not used is 0.
template <typename T>
using ArgumentsOf = std::array<T, 40>;
using Arguments = ArgumentsOf<double>;

// `whole`: sizes from 1e-150 or so to 1e150 and the edges of what is accepted; `ordinary`: what scenes are made of.
enum class Domain { ordinary, whole };

struct Truth {
    std::vector<Wide> values;
    std::vector<std::size_t> blocks;   // lengths of the runs of values that share the last place of their largest
    std::vector<double> weights = {};  // powers of two that bring values of one block to one size; none: all 1
    bool anyScale = false;             // only the proportions of the values count
    std::vector<Wide> sizes = {};      // of the blocks, where that is not their largest value
    // How near another verdict is, larger where nearer: what a search for a wrong one climbs, since verdicts have no slope.
    double closeness = 0;
};
Truth entrywise(std::vector<Wide> values);  // each value is its own block
Truth oneBlock(std::vector<Wide> values);

// One way to compute a function.
struct Form {
    std::string name;  // "mv", "GLM double", "GLM float"
    bool isFloat;
    std::function<std::vector<Wide>(const Arguments&)> values;  // throws Error where it refuses
    std::function<void(const std::vector<Arguments>&, int calls)> run;
};

struct Function {
    std::string name;
    std::string header;    // in mv/math, or with its floor: "motion/orientation.h"
    std::string returns;   // one line
    std::string measured;  // "entrywise", or what the blocks are
    std::string domain;    // the whole domain's samples, in words
    double bound = 4;      // ulp: more is a defect, anywhere within the limits
    std::string reason;    // why the bound is above 4 ulp; "" where it is not
    std::function<Arguments(Random&, Domain)> sample;
    std::function<Truth(const Arguments&)> truth;
    std::string limits = {};                            // where the bound holds; "": for all that is accepted
    std::function<bool(const Arguments&)> within = {};  // the limits; none: everything finite
    std::vector<Form> forms = {};
};

// Every function of mv/math that computes something, by header and in its order, and those of mv/motion that are formulas.
const std::vector<Function>& functions();
// These, the intersections of mv/geometry/ray.h, and mv/motion/two_link.h: what tests/adversary looks for the worst errors of.
const std::vector<Function>& attackedFunctions();
// The forms of a function that are ours: one, or one for each type that it is compiled for.
std::vector<const Form*> ownForms(const Function& function);

// The error of one call: in ulp and as a part of its block's largest entry; infinity where the result is not finite.
struct CallError {
    double ulp = 0, part = 0;
    double closeness = 0;  // the truth's
    bool isRefused = false;
};
// The arguments as they are, but a float form gets them as floats.
CallError errorOfCall(const Function& function, const Form& form, const Arguments& arguments);

struct Errors {
    double max = 0, mean = 0;  // ulp; infinity where a result was not finite, which the mean leaves out
    double lost = 0;           // part of the samples with an error above 1e-6 of the largest entry of its block
    double refused = 0;        // part of the samples that were refused
};

// The errors of one form. The samples are the same in every run of a program (another compiler may evaluate operands in
// another order, and so draw others), and the first ones of a longer run are those of a shorter.
// GLM's float form gets arguments rounded to float, and the truth of those.
Errors measure(const Function& function, const Form& form, Domain domain, long samples);

// Makes the compiler believe that something reads the whole result: else GLM's inlined functions could leave out calls.
template <typename Result>
void useAll(const Result& result) {
    asm volatile("" : : "r"(&result) : "memory");
}

template <typename T, typename Call>
Form makeForm(const std::string& name, Call call) {
    const auto converted = [](const Arguments& arguments) {
        ArgumentsOf<T> result;
        for (std::size_t i = 0; i < result.size(); ++i) result[i] = static_cast<T>(arguments[i]);
        return result;
    };
    return {name, sizeof(T) == sizeof(float),
            [=](const Arguments& arguments) {
                std::vector<Wide> values;
                appendValues(values, call(converted(arguments)));
                return values;
            },
            [=](const std::vector<Arguments>& sets, int calls) {
                std::vector<ArgumentsOf<T>> inType;
                for (const Arguments& set : sets) inType.push_back(converted(set));
                for (int i = 0; i < calls; ++i) {
                    const auto result = call(inType[static_cast<std::size_t>(i) % inType.size()]);
                    useAll(result);
                }
            }};
}

struct NoTwin {};

// The function with its forms: ours, and where GLM has one, GLM's as a generic call on ArgumentsOf<T>.
template <typename Ours, typename Twin = NoTwin>
Function withForms(Function function, Ours ours, Twin twin = {}) {
    function.forms.push_back(makeForm<double>("mv", ours));
    if constexpr (!std::is_same_v<Twin, NoTwin>) {
        function.forms.push_back(makeForm<double>("GLM double", twin));
        function.forms.push_back(makeForm<float>("GLM float", twin));
    }
    return function;
}

// The lists that functions() is made of.
std::vector<Function> typesFunctions();
std::vector<Function> robustFunctions();
std::vector<Function> transformFunctions();
std::vector<Function> projectionFunctions();
std::vector<Function> shadowFunctions();
std::vector<Function> otherFunctions();
std::vector<Function> colorFunctions();
std::vector<Function> orientationFunctions();
std::vector<Function> easeFunctions();
std::vector<Function> curveFunctions();
std::vector<Function> viewFormFunctions();
std::vector<Function> colorDifferenceFunctions();
std::vector<Function> turnFunctions();
std::vector<Function> usualEaseFunctions();
std::vector<Function> intersectionFunctions();
std::vector<Function> twoLinkFunctions();

// A form of intersectSphere, ours or another, that returns both ends, or two infinities where it finds none: made to return
// where the line is nearest to the centre instead, twice.
Form withMissesOfSphere(Form form);

// ---- arguments

template <typename T>
glm::vec<3, T> vectorAt(const ArgumentsOf<T>& a, std::size_t i) {
    return {a[i], a[i + 1], a[i + 2]};
}
template <typename T>
glm::vec<4, T> pointAt(const ArgumentsOf<T>& a, std::size_t i) {
    return {a[i], a[i + 1], a[i + 2], a[i + 3]};
}
template <typename T>
glm::mat<4, 4, T> matrixAt(const ArgumentsOf<T>& a, std::size_t i) {
    return {pointAt(a, i), pointAt(a, i + 4), pointAt(a, i + 8), pointAt(a, i + 12)};
}
void put(Arguments& a, std::size_t i, const vec3& v);
void put(Arguments& a, std::size_t i, const vec4& v);
void put(Arguments& a, std::size_t i, const mat4& m);

// A number of either sign and any size of the domain: 1e-3..1e3, or 1e-size..1e+size.
double anyNumber(Random& random, Domain domain, double size = 150);
// A power of two of any size of the domain: 1, or from about 1e-size to 1e+size.
double anyScale(Random& random, Domain domain, double size);

// Limits: every number is 0, or of a size from `least` to `most`.
std::function<bool(const Arguments&)> sizesBetween(double least, double most);
// Those of functions that divide one number by another and multiply the quotient by a third, which then neither vanishes
// nor overflows.
inline const std::string quotientLimits = "numbers 0, or from 1e-100 to 1e100 in size";
std::function<bool(const Arguments&)> quotientSizes();

// Whether a number is one of pixels.
bool isPictureSize(double size);

// ---- truths

// The size of a value that rounding decides, such as a verdict at its very bound: no error of it counts.
inline const Wide anySize = ldexp(Wide(1), 100000);
// A number below this has not all digits; so as the size of a value it counts as if it were this.
inline const Wide leastSize = ldexp(Wide(1), -1022);
inline Wide sizeOf(const Wide& value) { return abs(value) + leastSize; }

std::vector<Wide> valuesOf(const test::WideMatrix& m);
// The angle in radians, whole turns taken off in whole numbers: exact for every double.
Wide reducedRadians(double degrees);

}  // namespace mv::accuracy

#include <array>
#include <cmath>
#include <random>
#include <string>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>

#include "bench/benches.h"
#include "mv/error.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

namespace mv::bench {
namespace {

constexpr double bound = 2.0;
constexpr int calls = 200000;

// Arguments of one call: two points and six numbers. Few enough to stay in the cache, so that only the maths is timed.
struct Arguments {
    vec3 a, b;
    std::array<double, 6> number;
};
using Set = std::array<Arguments, 256>;

Set makeArguments() {
    std::mt19937 random(1);
    const auto between = [&](double low, double high) {
        return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
    };
    Set set{};
    for (Arguments& arguments : set) {
        arguments.a = {between(1, 9), between(1, 9), between(1, 9)};
        arguments.b = {between(-9, -1), between(-9, -1), between(-9, -1)};
        // left, right, bottom, top, near, far; the first is an angle as well when it is turned about
        arguments.number = {between(-80, -10), between(10, 80), between(-80, -10),
                            between(10, 80),   between(0.1, 1), between(10, 100)};
    }
    return set;
}

// Makes the compiler believe that something reads the whole matrix. Without it GLM's functions, which are inlined,
// would compute only those elements that the sum below needs, and ours, which are called, all sixteen.
void useAll(const mat4& m) { asm volatile("" : : "r"(&m) : "memory"); }

// Calls `make` for one set of arguments after the other. Both sides of a comparison run through this very function.
// The sum is only there to see that both sides compute the same.
template <typename Make>
double run(const Set& set, Make make) {
    double sum = 0;
    for (int i = 0; i < calls; ++i) {
        const mat4 m = make(set[static_cast<std::size_t>(i) % set.size()]);
        useAll(m);
        sum += m[0][0] + m[1][1] + m[2][2] + m[3][2];
    }
    return sum;
}

template <typename Ours, typename Theirs>
Row measure(const std::string& name, int rounds, Ours ours, Theirs theirs) {
    const Set set = makeArguments();
    double a = 0;
    double b = 0;
    const Ratio ratio = interleaved([&] { a = run(set, ours); }, [&] { b = run(set, theirs); }, rounds);
    // The same task on both sides: sums of some 1e5 numbers below 100, in another order of operations.
    if (!(std::abs(a - b) <= 1e-6 * calls))
        throw Error(name, "both sides must compute the same", numberText(a) + " and " + numberText(b));
    return {"math " + name + " / glm", ratio, bound};
}

}  // namespace

std::vector<Row> mathBench(int rounds) {
    using A = const Arguments&;
    const mat4 one(1);
    const vec3 up(0, 1, 0);
    return {
        measure(
            "lookAt", rounds, [&](A x) { return lookAt(x.a, x.b, up); },
            [&](A x) { return glm::lookAt(x.a, x.b, up); }),
        measure(
            "perspective", rounds, [](A x) { return perspective(x.number[1], x.a.x, x.number[4], x.number[5]); },
            [](A x) { return glm::perspective(radians(x.number[1]), x.a.x, x.number[4], x.number[5]); }),
        measure(
            "ortho", rounds,
            [](A x) {
                const auto& n = x.number;
                return ortho(n[0], n[1], n[2], n[3], n[4], n[5]);
            },
            [](A x) {
                const auto& n = x.number;
                return glm::ortho(n[0], n[1], n[2], n[3], n[4], n[5]);
            }),
        measure(
            "frustum", rounds,
            [](A x) {
                const auto& n = x.number;
                return frustum(n[0], n[1], n[2], n[3], n[4], n[5]);
            },
            [](A x) {
                const auto& n = x.number;
                return glm::frustum(n[0], n[1], n[2], n[3], n[4], n[5]);
            }),
        measure(
            "translate", rounds, [](A x) { return translate(x.a); }, [&](A x) { return glm::translate(one, x.a); }),
        measure(
            "scale", rounds, [](A x) { return scale(x.a); }, [&](A x) { return glm::scale(one, x.a); }),
        measure(
            "rotate", rounds, [](A x) { return rotate(x.number[0], x.a); },
            [&](A x) { return glm::rotate(one, radians(x.number[0]), x.a); }),
    };
}

}  // namespace mv::bench

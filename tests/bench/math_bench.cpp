#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <string>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/matrix_inverse.hpp>

#include "bench/benches.h"
#include "mv/error.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

namespace mv::bench {
namespace {

constexpr double bound = 2.0;

// Runs of about a millisecond, and four pairs of them for each round asked for: on a shared machine a run is then
// either interrupted as a whole or not at all, and the median sees only those that were not.
constexpr int calls = 40000;
constexpr int pairsPerRound = 4;

// Arguments of one call. Both sides read the same ones from memory, so that nothing is known when compiling.
struct Arguments {
    vec3 eye, at, up, axis, factors;
    double angle, fovy, aspect, left, right, bottom, top, near, far;
    mat4 worldFromModel;
};
// Few enough to stay in the cache, so that only the maths is timed.
using Set = std::array<Arguments, 64>;

Set makeArguments() {
    std::mt19937 random(1);
    const auto between = [&](double low, double high) {
        return low + (high - low) * (static_cast<double>(random()) / 4294967296.0);
    };
    const auto point = [&](double low, double high) {
        const double x = between(low, high);
        const double y = between(low, high);
        return vec3(x, y, between(low, high));
    };
    Set set{};
    for (Arguments& a : set) {
        a.eye = point(1, 9);
        a.at = point(-9, -1);
        a.up = vec3(0, 1, 0) + point(-0.3, 0.3);
        a.axis = point(1, 9);
        a.factors = point(0.2, 3);
        a.angle = between(-360, 360);
        a.fovy = between(10, 120);
        a.aspect = between(0.5, 2);
        a.left = between(-80, -10);
        a.right = between(10, 80);
        a.bottom = between(-80, -10);
        a.top = between(10, 80);
        a.near = between(0.1, 1);
        a.far = between(10, 100);
        a.worldFromModel = translate(a.at) * rotate(a.angle, a.axis) * scale(a.factors);
    }
    return set;
}

// Makes the compiler believe that something reads the whole matrix. Without it GLM's functions, which are inlined,
// could leave out elements or whole calls, and ours, which are called, could not.
template <typename Matrix>
void useAll(const Matrix& m) {
    asm volatile("" : : "r"(&m) : "memory");
}

// Calls `make` for one set of arguments after the other. Both sides of a comparison run through this very function.
template <typename Make>
void run(const Set& set, Make make) {
    for (int i = 0; i < calls; ++i) {
        const auto m = make(set[static_cast<std::size_t>(i) % set.size()]);
        useAll(m);
    }
}

// A ratio says something only about two ways to the same matrix.
template <typename Matrix>
void requireSame(const std::string& name, const Matrix& ours, const Matrix& theirs) {
    double largest = 0;
    double difference = 0;
    for (int column = 0; column < Matrix::length(); ++column) {
        for (int row = 0; row < Matrix::col_type::length(); ++row) {
            largest = std::max(largest, std::abs(theirs[column][row]));
            difference = std::max(difference, std::abs(ours[column][row] - theirs[column][row]));
        }
    }
    // Other orders of operations, and angles of 1e4 degrees of which only one side takes whole turns off.
    if (!(difference <= 1e-10 * largest))
        throw Error(name, "both sides must compute the same", numberText(difference) + " apart");
}

// The factor is the caller's to choose, so only the direction can agree: this gives both the same length.
mat3 sized(const mat3& m) { return m / std::sqrt(glm::dot(m[0], m[0]) + glm::dot(m[1], m[1]) + glm::dot(m[2], m[2])); }
const mat4& sized(const mat4& m) { return m; }

template <typename Ours, typename Theirs>
Row measure(const std::string& name, int rounds, Ours ours, Theirs theirs) {
    const Set set = makeArguments();
    for (const Arguments& arguments : set) requireSame(name, sized(ours(arguments)), sized(theirs(arguments)));
    const Ratio ratio =
        interleaved([&] { run(set, ours); }, [&] { run(set, theirs); }, std::max(rounds, fewestRounds) * pairsPerRound);
    return {"math " + name + " / glm", ratio, bound};
}

}  // namespace

std::vector<Row> mathBench(int rounds) {
    using A = const Arguments&;
    // GLM's functions multiply onto a matrix. It is written out, so that the compiler may make the most of the zeros;
    // and its angles are in radians, which a program with angles in degrees has to make of them first.
    return {
        measure(
            "lookAt", rounds, [](A a) { return lookAt(a.eye, a.at, a.up); },
            [](A a) { return glm::lookAt(a.eye, a.at, a.up); }),
        measure(
            "perspective", rounds, [](A a) { return perspective(a.fovy, a.aspect, a.near, a.far); },
            [](A a) { return glm::perspective(radians(a.fovy), a.aspect, a.near, a.far); }),
        measure(
            "ortho", rounds, [](A a) { return ortho(a.left, a.right, a.bottom, a.top, a.near, a.far); },
            [](A a) { return glm::ortho(a.left, a.right, a.bottom, a.top, a.near, a.far); }),
        measure(
            "frustum", rounds, [](A a) { return frustum(a.left, a.right, a.bottom, a.top, a.near, a.far); },
            [](A a) { return glm::frustum(a.left, a.right, a.bottom, a.top, a.near, a.far); }),
        measure(
            "translate", rounds, [](A a) { return translate(a.at); },
            [](A a) { return glm::translate(mat4(1), a.at); }),
        measure(
            "scale", rounds, [](A a) { return scale(a.factors); }, [](A a) { return glm::scale(mat4(1), a.factors); }),
        measure(
            "rotateX", rounds, [](A a) { return rotateX(a.angle); },
            [](A a) { return glm::rotate(mat4(1), radians(a.angle), vec3(1, 0, 0)); }),
        measure(
            "rotateY", rounds, [](A a) { return rotateY(a.angle); },
            [](A a) { return glm::rotate(mat4(1), radians(a.angle), vec3(0, 1, 0)); }),
        measure(
            "rotateZ", rounds, [](A a) { return rotateZ(a.angle); },
            [](A a) { return glm::rotate(mat4(1), radians(a.angle), vec3(0, 0, 1)); }),
        measure(
            "rotate", rounds, [](A a) { return rotate(a.angle, a.axis); },
            [](A a) { return glm::rotate(mat4(1), radians(a.angle), a.axis); }),
        // The angles that an animation gets to in an hour; GLM has no counterpart to taking whole turns off.
        measure(
            "rotate many turns", rounds, [](A a) { return rotate(100 * a.angle, a.axis); },
            [](A a) { return glm::rotate(mat4(1), radians(100 * a.angle), a.axis); }),
        measure(
            "normalMatrix", rounds, [](A a) { return normalMatrix(a.worldFromModel); },
            [](A a) { return glm::inverseTranspose(mat3(a.worldFromModel)); }),
    };
}

}  // namespace mv::bench

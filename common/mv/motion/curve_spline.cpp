// Cubic splines: the accelerations at the keys solve a tridiagonal system, whose rows are divided by the sum of the two
// spans' lengths: then each is (0..1, 2, 0..1), however uneven the times are, and elimination needs no pivots.
#include <cstddef>
#include <utility>

#include "mv/motion/curve_shape.h"

namespace mv {
namespace {

// The row of the key between two spans: before x[i-1] + 2 x[i] + after x[i+1] = right.
template <typename P>
struct Row {
    double before, after;
    P right;
};

template <typename P>
Row<P> rowBetween(double left, double right, const P& first, const P& middle, const P& last) {
    const double both = left + right;
    const P bend = (last - middle) / right - (middle - first) / left;
    return {left / both, right / both, 6.0 * (bend / both)};
}

// That of the key i, neither the first nor the last.
template <typename P>
Row<P> rowOf(const std::vector<Keyframe<P>>& keys, std::size_t i) {
    return rowBetween(keys[i].time - keys[i - 1].time, keys[i + 1].time - keys[i].time, keys[i - 1].value,
                      keys[i].value, keys[i + 1].value);
}

// The solution of rows from the first to the last, whose `before` and `after` count for nothing.
template <typename P>
std::vector<P> solveTridiagonal(const std::vector<Row<P>>& rows) {
    std::vector<P> solution(rows.size());
    std::vector<double> after(rows.size());
    double pivot = 2;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        P right = rows[i].right;
        if (i > 0) {
            pivot = 2 - rows[i].before * after[i - 1];
            right -= rows[i].before * solution[i - 1];
        }
        after[i] = rows[i].after / pivot;
        solution[i] = right / pivot;
    }
    for (std::size_t i = rows.size(); i-- > 1;) solution[i - 1] -= after[i - 1] * solution[i];
    return solution;
}

// The spline with these accelerations at its keys.
template <typename P>
ShapePointer<P> shapeWith(const char* subject, const std::vector<Keyframe<P>>& keys,
                          const std::vector<P>& accelerations) {
    std::vector<CubicSpan<P>> spans;
    spans.reserve(keys.size() - 1);
    for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
        const P from = keys[i].value, to = keys[i + 1].value, a = accelerations[i], b = accelerations[i + 1];
        const double h = keys[i + 1].time - keys[i].time;
        const P slope = (to - from) / h;
        const P first = slope - h / 6 * (2.0 * a + b), last = slope + h / 6 * (a + 2.0 * b);
        spans.push_back({keys[i].time,
                         h,
                         {from, from + h / 3 * first, to - h / 3 * last, to},
                         {first, slope + h / 6 * (a - b), last},
                         {a, b}});
    }
    return cubicShape(subject, std::move(spans));
}

}  // namespace

template <typename P>
ShapePointer<P> naturalShape(const std::vector<Keyframe<P>>& keys) {
    std::vector<Row<P>> rows;
    for (std::size_t i = 1; i + 1 < keys.size(); ++i) rows.push_back(rowOf(keys, i));
    std::vector<P> accelerations = solveTridiagonal(rows);
    accelerations.insert(accelerations.begin(), P(0));
    accelerations.push_back(P(0));
    return shapeWith("Curve::naturalSpline", keys, accelerations);
}

template <typename P>
ShapePointer<P> clampedShape(const std::vector<Keyframe<P>>& keys, const P& startVelocity, const P& endVelocity) {
    const std::size_t last = keys.size() - 1;
    // The slope of the first or last span less the given one, as the bend at a key between spans.
    const double h = keys[1].time - keys[0].time, k = keys[last].time - keys[last - 1].time;
    const P atStart = (keys[1].value - keys[0].value) / h - startVelocity;
    const P atEnd = endVelocity - (keys[last].value - keys[last - 1].value) / k;
    std::vector<Row<P>> rows{{0, 1, 6.0 * (atStart / h)}};
    for (std::size_t i = 1; i < last; ++i) rows.push_back(rowOf(keys, i));
    rows.push_back({1, 0, 6.0 * (atEnd / k)});
    return shapeWith("Curve::clampedSpline", keys, solveTridiagonal(rows));
}

template <typename P>
ShapePointer<P> periodicShape(const std::vector<Keyframe<P>>& keys) {
    // As many unknowns as spans: the last key is the first. Its neighbours there are the key before the last, and the first
    // but one.
    const std::size_t count = keys.size() - 1;
    std::vector<P> accelerations(count + 1, P(0));
    if (count == 1) return shapeWith("Curve::periodicSpline", keys, accelerations);
    std::vector<Row<P>> rows{rowBetween(keys[count].time - keys[count - 1].time, keys[1].time - keys[0].time,
                                        keys[count - 1].value, keys[0].value, keys[1].value)};
    for (std::size_t i = 1; i < count; ++i) rows.push_back(rowOf(keys, i));

    // The last unknown z is put aside: the others are those without it, less z times what it adds to their right sides.
    const Row<P> last = rows.back();
    rows.pop_back();
    std::vector<Row<double>> added;
    added.reserve(rows.size());
    for (const Row<P>& row : rows) added.push_back({row.before, row.after, 0});
    added.front().right += rows.front().before;
    added.back().right += rows.back().after;
    const std::vector<P> without = solveTridiagonal(rows);
    const std::vector<double> share = solveTridiagonal(added);
    const P z = (last.right - last.after * without.front() - last.before * without.back()) /
                (2 - last.after * share.front() - last.before * share.back());
    for (std::size_t i = 0; i + 1 < count; ++i) accelerations[i] = without[i] - share[i] * z;
    accelerations[count - 1] = z;
    accelerations[count] = accelerations[0];
    return shapeWith("Curve::periodicSpline", keys, accelerations);
}

template ShapePointer<double> naturalShape(const std::vector<Keyframe<double>>&);
template ShapePointer<vec3> naturalShape(const std::vector<Keyframe<vec3>>&);
template ShapePointer<double> clampedShape(const std::vector<Keyframe<double>>&, const double&, const double&);
template ShapePointer<vec3> clampedShape(const std::vector<Keyframe<vec3>>&, const vec3&, const vec3&);
template ShapePointer<double> periodicShape(const std::vector<Keyframe<double>>&);
template ShapePointer<vec3> periodicShape(const std::vector<Keyframe<vec3>>&);

}  // namespace mv

// The numbers of a result, one after the other, as wide ones.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "mv/math/projection.h"
#include "mv/math/stereo.h"
#include "support/wide.h"

namespace mv::accuracy {

using Values = std::vector<test::Wide>;

inline void appendValues(Values& values, double value) { values.emplace_back(value); }
inline void appendValues(Values& values, float value) { values.emplace_back(value); }
inline void appendValues(Values& values, int value) { values.emplace_back(value); }
inline void appendValues(Values& values, bool value) { values.emplace_back(value ? 1 : 0); }

template <int N, typename T, glm::qualifier Q>
void appendValues(Values& values, const glm::vec<N, T, Q>& v) {
    for (int i = 0; i < N; ++i) appendValues(values, v[i]);
}
template <int C, int R, typename T, glm::qualifier Q>
void appendValues(Values& values, const glm::mat<C, R, T, Q>& m) {
    for (int column = 0; column < C; ++column) appendValues(values, m[column]);
}
template <typename T, std::size_t N>
void appendValues(Values& values, const std::array<T, N>& list) {
    for (const T& item : list) appendValues(values, item);
}
template <typename T>
void appendValues(Values& values, const std::vector<T>& list) {
    for (const T& item : list) appendValues(values, item);
}
inline void appendValues(Values& values, const FrustumBounds& b) {
    for (const double value : {b.left, b.right, b.bottom, b.top, b.near, b.far}) appendValues(values, value);
}
inline void appendValues(Values& values, const std::optional<Parallax>& parallax) {
    if (!parallax) return;
    for (const double value : {parallax->leastAcross, parallax->mostAcross, parallax->vertical}) {
        appendValues(values, value);
    }
}

}  // namespace mv::accuracy

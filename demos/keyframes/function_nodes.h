// Functions that are interpolated through nodes from -1 to 1, and one polynomial through them in three forms.
#pragma once
#include <functional>
#include <vector>

#include "mv/motion/curve.h"

namespace mv {

// Lagrange's polynomial as textbooks write it, a product for each key: in double, or in float. O(n^2) a value. The
// trap: times that are one as T divide by 0.
template <class T>
double textbookPolynomial(const std::vector<Keyframe<double>>& keys, double time) {
    T sum = 0;
    for (const auto& here : keys) {
        T basis = 1;
        for (const auto& other : keys) {
            if (other.time != here.time) basis *= (T(time) - T(other.time)) / (T(here.time) - T(other.time));
        }
        sum += basis * T(here.value);
    }
    return double(sum);
}

// The function, its nodes and the polynomial's form: a part of a lesson's settings.
struct FunctionNodes {
    enum class Function { runge, sine };
    enum class Spread { even, chebyshev };
    enum class Form { barycentric, textbook, inFloat };

    Function function = Function::runge;
    int count = 21;
    Spread spread = Spread::even;
    Form form = Form::barycentric;

    double valueAt(double x) const;
    double slopeAt(double x) const;
    std::vector<double> places() const;
    std::vector<Keyframe<double>> keys() const;
    // The polynomial through all of the nodes, by the present form.
    std::function<double(double)> polynomial() const;

    bool operator==(const FunctionNodes&) const = default;
};

}  // namespace mv

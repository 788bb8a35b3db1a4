#include "adversary/search.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <type_traits>

namespace mv::adversary {
namespace {

using accuracy::CallError;
using accuracy::Random;
using Bits = std::mt19937_64;  // the standard defines its numbers

// After this many changes that did not rise, a climb is at its top, or on a plateau without an edge in reach.
constexpr int patience = 400;

std::size_t below(Bits& bits, std::size_t count) { return static_cast<std::size_t>(bits() % count); }

template <typename T>
T changed(T value, Bits& bits) {
    using Word = std::conditional_t<sizeof(T) == 8, std::uint64_t, std::uint32_t>;
    constexpr int mantissaBits = std::numeric_limits<T>::digits - 1;
    const auto word = std::bit_cast<Word>(value);
    switch (below(bits, 6)) {
        case 0:  // a bit of the mantissa
        case 1:
            return std::bit_cast<T>(static_cast<Word>(word ^ (Word{1} << below(bits, mantissaBits))));
        case 2: {  // some last places up or down
            const Word step = Word{1} << below(bits, 5);
            return std::bit_cast<T>(static_cast<Word>(bits() % 2 == 0 ? word + step : word - step));
        }
        case 3:
            return std::ldexp(value, bits() % 2 == 0 ? 1 : -1);
        case 4: {  // another size altogether
            const int most = bits() % 2 == 0 ? 8 : std::numeric_limits<T>::max_exponent;
            return std::ldexp(value, static_cast<int>(below(bits, 2 * static_cast<std::size_t>(most) + 1)) - most);
        }
        default: {  // low bits cleared: short numbers make exact ties
            const Word mask = (Word{1} << below(bits, mantissaBits + 1)) - 1;
            return std::bit_cast<T>(static_cast<Word>(word & ~mask));
        }
    }
}

double special(Bits& bits) {
    static constexpr std::array<double, 16> values{0,
                                                   1,
                                                   2,
                                                   0.5,
                                                   3,
                                                   45,
                                                   90,
                                                   180,
                                                   360,
                                                   1e-12,
                                                   1e-6,
                                                   std::numeric_limits<double>::denorm_min(),
                                                   std::numeric_limits<double>::min(),
                                                   std::numeric_limits<double>::max(),
                                                   1e150,
                                                   1e-150};
    return values[below(bits, values.size())];
}

double changedIn(const Form& form, double value, Bits& bits) {
    if (!form.isFloat) return changed(value, bits);
    return static_cast<double>(changed(static_cast<float>(value), bits));
}

Arguments mutated(const Function& function, const Form& form, Domain domain, Arguments a,
                  const std::vector<std::size_t>& used, Bits& bits) {
    const std::size_t changes = 1 + below(bits, 8) / 6;  // mostly one, a quarter two
    for (std::size_t k = 0; k < changes; ++k) {
        double& value = a[used[below(bits, used.size())]];
        const double other = a[used[below(bits, used.size())]];
        switch (below(bits, 12)) {
            case 0:
                value = -value;
                break;
            case 1:
                value = bits() % 2 == 0 ? other : -other;
                break;
            case 2:
                value = changedIn(form, other, bits);
                break;  // a neighbour of another argument
            case 3:
                value = special(bits) * (bits() % 4 == 0 ? -1 : 1);
                break;
            case 4: {  // one of another sample
                Random random(bits() >> 1);
                const Arguments sample = function.sample(random, domain);
                const std::size_t i = used[below(bits, used.size())];
                a[i] = sample[i];
                break;
            }
            case 5: {  // several neighbours times one power of two: a vector, a column
                const std::size_t first = below(bits, used.size()), last = first + below(bits, used.size() - first);
                const int exponent = static_cast<int>(below(bits, 401)) - 200;
                for (std::size_t i = first; i <= last; ++i) a[used[i]] = std::ldexp(a[used[i]], exponent);
                break;
            }
            default:
                value = changedIn(form, value, bits);
        }
    }
    return a;
}

bool areFinite(const Arguments& a) {
    return std::all_of(a.begin(), a.end(), [](double x) { return std::isfinite(x); });
}

}  // namespace

std::vector<std::size_t> usedArguments(const Function& function) {
    Arguments largest{};
    Random random(7);
    for (const Domain domain : {Domain::whole, Domain::ordinary}) {
        for (int sample = 0; sample < 32; ++sample) {
            const Arguments a = function.sample(random, domain);
            for (std::size_t i = 0; i < a.size(); ++i) largest[i] = std::max(largest[i], std::abs(a[i]));
        }
    }
    std::vector<std::size_t> used;
    for (std::size_t i = 0; i < largest.size(); ++i) {
        if (largest[i] > 0) used.push_back(i);
    }
    return used;
}

Worst search(const Function& function, const Form& form, Domain startsFrom, std::uint64_t seed, long evaluations,
             const std::vector<Arguments>& known) {
    Bits bits(seed);
    const std::vector<std::size_t> used = usedArguments(function);
    Worst worst{.ulp = -1};

    // The error of these arguments, or -1 where there is none to have.
    const auto tried = [&](Arguments& a) {
        ++worst.evaluations;
        if (form.isFloat) {
            for (double& value : a) value = static_cast<double>(static_cast<float>(value));
        }
        CallError error{.isRefused = true};
        if (areFinite(a) && (!function.within || function.within(a))) error = errorOfCall(function, form, a);
        if (error.isRefused) {
            ++worst.refused;
            error.ulp = -1;
        } else if (error.ulp > worst.ulp) {
            worst.ulp = error.ulp;
            worst.input = a;
        }
        return error;
    };
    std::size_t starts = 0;
    while (worst.evaluations < evaluations && !std::isinf(worst.ulp)) {
        Random random(bits() >> 1);
        Arguments best = starts < known.size() ? known[starts] : function.sample(random, startsFrom);
        ++starts;
        CallError bestError = tried(best);
        for (int idle = 0; idle < patience && worst.evaluations < evaluations; ++idle) {
            Arguments next = mutated(function, form, startsFrom, best, used, bits);
            const CallError error = tried(next);
            const bool isHigher =
                error.ulp > bestError.ulp || (error.ulp == bestError.ulp && error.closeness > bestError.closeness);
            if (isHigher) idle = 0;
            if (isHigher || (error.ulp == bestError.ulp && error.closeness == bestError.closeness)) {
                best = next;
                bestError = error;
            }
        }
    }
    return worst;
}

}  // namespace mv::adversary

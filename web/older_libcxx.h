// Put before every source by web/CMakeLists.txt: the algorithms of C++20 that the libc++ of Emscripten 3.1.6 (Debian 12) does not
// have yet, each by the older one of its name, so that no source has to be written for it. A newer libc++ has its own.
#pragma once
#include <algorithm>
#include <functional>
#include <iterator>
#include <type_traits>
#include <utility>
#include <vector>

#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 15000
namespace std {

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
    return __builtin_bit_cast(To, from);
}

namespace ranges {

// Of the whole range; and with what is compared of each element.
#define MV_OF_RANGE(name)                                                                  \
    template <class Range, class... More>                                                  \
    constexpr auto name(Range&& range, More&&... more) {                                   \
        return std::name(std::begin(range), std::end(range), std::forward<More>(more)...); \
    }
MV_OF_RANGE(adjacent_find)
MV_OF_RANGE(copy)
MV_OF_RANGE(fill)
MV_OF_RANGE(find)
MV_OF_RANGE(find_if)
MV_OF_RANGE(max_element)
MV_OF_RANGE(transform)
#undef MV_OF_RANGE

// These take a member for what is asked of each element.
#define MV_OF_RANGE(name)                                                            \
    template <class Range, class Asked>                                              \
    constexpr auto name(Range&& range, Asked asked) {                                \
        return std::name(std::begin(range), std::end(range),                         \
                         [&](auto&& one) { return bool(std::invoke(asked, one)); }); \
    }
MV_OF_RANGE(all_of)
MV_OF_RANGE(any_of)
MV_OF_RANGE(count_if)
#undef MV_OF_RANGE

template <class Range, class Value, class Part>
constexpr auto find(Range&& range, const Value& value, Part part) {
    return std::find_if(std::begin(range), std::end(range),
                        [&](auto&& one) { return std::invoke(part, one) == value; });
}

// By merging runs of 1, 2, 4 ... elements: less code for each type than the library's own, which changes its way with the size.
template <class Range, class Less = std::less<>>
constexpr void stable_sort(Range&& range, Less less = {}) {
    using Value = std::decay_t<decltype(*std::begin(range))>;
    std::vector<Value> from(std::make_move_iterator(std::begin(range)), std::make_move_iterator(std::end(range)));
    std::vector<Value> to = from;
    for (std::size_t run = 1; run < from.size(); run *= 2) {
        for (std::size_t start = 0; start < from.size(); start += 2 * run) {
            const std::size_t middle = std::min(start + run, from.size()), last = std::min(middle + run, from.size());
            std::size_t one = start, other = middle;
            for (std::size_t i = start; i < last; ++i) {
                const bool takesOne = one < middle && (other == last || !std::invoke(less, from[other], from[one]));
                to[i] = std::move(from[takesOne ? one++ : other++]);
            }
        }
        from.swap(to);
    }
    std::move(from.begin(), from.end(), std::begin(range));
}
template <class Range, class Less = std::less<>>
constexpr void sort(Range&& range, Less less = {}) {
    stable_sort(std::forward<Range>(range), less);
}
struct by_less {};
template <class Range, class Part>
constexpr void stable_sort(Range&& range, by_less, Part part) {
    stable_sort(std::forward<Range>(range),
                [&](auto&& one, auto&& other) { return std::invoke(part, one) < std::invoke(part, other); });
}

template <class Range, class Other, class... More>
constexpr bool equal(Range&& range, Other&& other, More&&... more) {
    return std::equal(std::begin(range), std::end(range), std::begin(other), std::end(other),
                      std::forward<More>(more)...);
}

template <class Range>
constexpr auto minmax(Range&& range) {
    const auto found = std::minmax_element(std::begin(range), std::end(range));
    using Value = std::decay_t<decltype(*found.first)>;
    return std::pair<Value, Value>(*found.first, *found.second);
}

}  // namespace ranges
}  // namespace std
#endif

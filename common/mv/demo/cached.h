// A value with the settings that it was made for: it is made anew only for others.
#pragma once
#include <optional>
#include <tuple>
#include <type_traits>

namespace mv {

// A member of a lesson's Gpu: `Cached<Mesh, Body, int> body;` and later
//     const Mesh& body = gpu.body.of({s.body, s.divisions}, [&] { return Mesh(bodyOf(s), "body"); });
template <class T, class... What>
class Cached {
  public:
    // What makes a value has no arguments, or it takes the settings and captures nothing: so none that it reads can be forgotten.
    template <class Make>
    static constexpr bool mayMake =
        std::disjunction_v<std::is_invocable<Make>,
                           std::conjunction<std::is_empty<Make>, std::is_invocable<Make, const What&...>>>;
    // The value for these settings. `make` returns it where the value that is there was made for others, or where there is
    // none. An error of `make` passes through, and the next call makes the value anew.
    template <class Make>
    T& of(const std::tuple<What...>& settings, Make make) {
        static_assert(mayMake<Make>, "make: must capture nothing where it takes the settings");
        if (madeFor_ == settings) return value_;
        madeFor_.reset();
        if constexpr (std::is_invocable_v<Make>) {
            value_ = make();
        } else {
            value_ = std::apply(make, settings);
        }
        madeFor_ = settings;
        return value_;
    }
    // The value that was made last; T() before that.
    T& operator*() { return value_; }
    const T& operator*() const { return value_; }
    T* operator->() { return &value_; }
    const T* operator->() const { return &value_; }

  private:
    T value_{};
    std::optional<std::tuple<What...>> madeFor_;
};

}  // namespace mv

// The settings that something was last made for, so that it is made anew only for others.
#pragma once
#include <optional>
#include <tuple>
#include <utility>

namespace mv {

// A member of a lesson's Gpu: `MadeFor<int, double> mapFor;` and later `if (gpu.mapFor.changed(s.size, s.bias)) drawMap();`
template <class... What>
class MadeFor {
  public:
    // Whether this is not what it was last asked with; it is remembered.
    bool changed(const What&... what) {
        std::tuple<What...> now(what...);
        if (last_ == now) return false;
        last_ = std::move(now);
        return true;
    }
    // The next question is answered with true.
    void forget() { last_.reset(); }

  private:
    std::optional<std::tuple<What...>> last_;
};

}  // namespace mv

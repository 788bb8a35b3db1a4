// An object that not every picture needs, made when it is first asked for.
#pragma once
#include <functional>
#include <optional>
#include <utility>

namespace mv {

// A member of a lesson's Gpu: `OnDemand<Program> byMap{"soft-shadows", "map"};` and later `byMap->use()`. A context is current by
// then. Error: as the constructor of T.
template <class T>
class OnDemand {
  public:
    template <class... Arguments>
    explicit OnDemand(Arguments... arguments) : make_([=] { return T(arguments...); }) {}

    T& operator*() {
        if (!made_) made_.emplace(make_());
        return *made_;
    }
    T* operator->() { return &**this; }

  private:
    std::function<T()> make_;
    std::optional<T> made_;
};

}  // namespace mv

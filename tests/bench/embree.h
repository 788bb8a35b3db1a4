// A scene in Embree, the field's own ray tracer: to see what the reference costs beside it. Only isThere() may be called
// where the library is not installed: it is false there.
#pragma once
#include <memory>
#include <vector>

#include "mv/geometry/ray_caster.h"

namespace mv::bench {

class Embree {
  public:
    static bool isThere();

    explicit Embree(const Scene& scene);
    ~Embree();

    // How many of the rays meet something, and how many of the hits do not see the light because of what casts.
    [[nodiscard]] double countNearest(const std::vector<Ray>& rays) const;
    [[nodiscard]] double countShadow(const std::vector<SceneHit>& hits, const vec3& light) const;

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace mv::bench

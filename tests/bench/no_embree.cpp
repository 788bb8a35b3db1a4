// The benchmark is built with this file where Embree is not installed.
#include "bench/embree.h"
#include "mv/error.h"

namespace mv::bench {

struct Embree::State {};

bool Embree::isThere() { return false; }
Embree::Embree(const Scene&) { throw Error("Embree", "must be installed (package libembree-dev)"); }
Embree::~Embree() = default;
double Embree::countNearest(const std::vector<Ray>&) const { return 0; }
double Embree::countShadow(const std::vector<SceneHit>&, const vec3&) const { return 0; }

}  // namespace mv::bench

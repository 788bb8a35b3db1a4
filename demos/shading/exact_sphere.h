// The highlight of the exact sphere, by rays in double precision: what the meshes' highlights are compared with.
#pragma once
#include <optional>
#include <vector>

#include "mv/demo/frame.h"
#include "shading.h"

namespace mv::shading {

class ExactSphere {
  public:
    ExactSphere(const Settings& s, const FrameInfo& frame);

    // The mean of side x side samples of each pixel, the upper row first; -1 where the middle's ray does not meet the
    // sphere, or within a seventh of its radius of the outline, where a coarse mesh has none of it.
    std::vector<double> picture(int width, int height, int side) const;

    bool operator==(const ExactSphere&) const = default;

  private:
    ExactSphere(const Settings& s, const Scene& scene);
    // x and y from -1 to 1 over the picture.
    std::optional<double> at(double x, double y) const;
    double pixel(int column, int row, int width, int height, int side) const;

    mat4 worldFromClip_;
    vec3 eye_, lamp_;
    Lobe lobe_;
    double part_, exponent_;
};

}  // namespace mv::shading

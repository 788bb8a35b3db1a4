// X44, X45: a lamp on the surface that it lights, and a spot whose two cones are one.
#include <algorithm>
#include <cmath>

#include "extremes/measure.h"
#include "extremes/row.h"
#include "lights/lamp_light.h"
#include "mv/math/transform.h"

using namespace mv;
using namespace mv::test;

namespace {

[[maybe_unused]] const bool x44 = addRow([] {
    const volatile float distance = 0;
    const Falloff falloff{.size = 0.05};
    // How far the light is above that at the lamp's own surface, which is the most there is
    const double most = 1 / (0.05 * 0.05);
    return Row{.id = "X44",
               .input = "a lamp of radius 0.05 on the surface that it lights: d = 0",
               .measured = "relative excess over the light at the lamp's own surface",
               .naive = "1/d^2 in float",
               .naiveError = static_cast<double>(1 / (distance * distance)) / most - 1,
               .ours = "Falloff::at",
               .ourError = std::abs(falloff.at(0) / most - 1),
               .tolerance = 4 * 0x1p-53,
               .reason = "three roundings"};
});

[[maybe_unused]] const bool x45 = addRow([] {
    const double cone = std::cos(radians(25));
    const volatile float edge = static_cast<float>(cone);
    const float t = (edge - edge) / (edge - edge);
    return Row{.id = "X45",
               .input = "a spot whose inner cone is its outer one, on the edge and to both sides of it",
               .measured = "error of the part that is lit: 1 on the edge and within, 0 outside",
               .naive = "t = (c - outer)/(inner - outer), 3t^2 - 2t^3, in float",
               .naiveError = static_cast<double>(t * t * (3 - 2 * t)),
               .ours = "spotEdge",
               .ourError = std::max({std::abs(spotEdge(cone, cone, cone) - 1),
                                     std::abs(spotEdge(std::nextafter(cone, 1), cone, cone) - 1),
                                     std::abs(spotEdge(std::nextafter(cone, 0), cone, cone))}),
               .tolerance = 0,
               .reason = "a step has two values"};
});

}  // namespace

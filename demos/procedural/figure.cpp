// Written over procedural: which pattern it is, and by what formula.
#include <algorithm>
#include <array>
#include <string>

#include "procedural.h"

namespace mv::procedural {

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    constexpr std::array names{"brick", "wood", "marble", "noise"};
    constexpr std::array formulas{"1 in a brick, 0 in the mortar: of the parts of x and y after the point",
                                  "1/2 + 1/2 cos 2 pi (4 sqrt(x^2 + y^2) + noise)",
                                  "1/2 + 1/2 cos 2 pi (x + 1.5 noise)", "1/2 + 0.6 noise"};
    const auto which = std::size_t(s.pattern);
    const std::string octaves = s.pattern == Pattern::brick ? ""
                                                            : ", noise of " + std::to_string(s.octaves) +
                                                                  (s.octaves == 1 ? " octave" : " octaves");
    const std::string texels = std::to_string(s.texels);
    const std::string from = isFromTexture(s) ? ", from " + texels + " x " + texels + " x " + texels + " texels" : "";
    const int size = std::clamp(frame.height() / 34, 8, 22);
    const vec4 ink(0.1, 0.1, 0.1, 1), paper(1, 1, 1, 0.8);
    gpu.drawing.begin(frame);
    gpu.drawing.text({10, 3.6 * size}, std::string(names.at(which)) + octaves + from, {size, ink, paper});
    gpu.drawing.text({10, 1.9 * size}, std::string("f(x, y, z) = ") + formulas.at(which), {size, ink, paper});
    gpu.drawing.draw(frame);
}

}  // namespace mv::procedural

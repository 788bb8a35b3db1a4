// The readouts of cube-ortho.
#include "cube-ortho.h"

namespace mv::cube_ortho {

void readOut(Gpu&, const Settings& s, const Frame& frame, Numbers& numbers) {
    numbers.set("near", nearDistance(s));
    numbers.set("far", farDistance(s));
    numbers.set("pixels-per-unit", frame.width() / s.width);
}

}  // namespace mv::cube_ortho

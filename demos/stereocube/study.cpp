// The readouts of stereocube.
#include "stereocube.h"

namespace mv::stereocube {

void readOut(Gpu&, const Settings& s, const Frame& frame, Numbers& numbers) {
    const std::optional<Parallax> parallax = parallaxOf(s, frame);
    if (!parallax) return;
    numbers.set("vertical-parallax", parallax->vertical);
    numbers.set("parallax-min", parallax->leastAcross);
    numbers.set("parallax-max", parallax->mostAcross);
    const std::optional<OnScreen> here = onScreen(s, frame);
    if (!here) return;
    numbers.set("parallax-mm", here->most);
    if (here->atInfinity) numbers.set("infinity-mm", *here->atInfinity);
}

}  // namespace mv::stereocube

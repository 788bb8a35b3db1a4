// What stereocube tells in numbers.
#include <vector>

#include "mv/math/stereo.h"
#include "stereocube.h"

namespace mv::stereocube {

// Of the corners that are before both eyes' near planes.
void readOut(Gpu&, const Settings& s, const Frame& frame, Numbers& numbers) {
    const Eye left = leftEye(s, frame.aspect()), right = rightEye(s, frame.aspect());
    const mat4 worldFromModel = worldFromModelOf(s);
    std::vector<vec3> corners;
    for (const fvec3& corner : wireCube().positions) corners.emplace_back(worldFromModel * vec4(vec3(corner), 1));
    const auto parallax = parallaxOf(corners, left.clipFromEye * left.eyeFromWorld,
                                     right.clipFromEye * right.eyeFromWorld, frame.width(), frame.height(), near);
    if (!parallax) return;
    numbers.set("vertical-parallax", parallax->vertical);
    numbers.set("parallax-min", parallax->leastAcross);
    numbers.set("parallax-max", parallax->mostAcross);
}

}  // namespace mv::stereocube

// The scene of bump-map: the wall or the orange, the lamp, the eye.
#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>

#include "bump-map.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "shared/strip.h"

namespace mv::bump_map {

// A parallel projection shows the whole wall at one angle.
Scene sceneAt(const Settings& s, double aspect) {
    Scene scene;
    if (s.body == ReliefBody::orange) {
        const double up = 1.1 * std::max(1.0, 1 / aspect);
        scene.clipFromView = ortho(-up * aspect, up * aspect, -up, up, -2, 2);
        scene.viewFromWorld = worldFromBody(s);
    } else {
        scene.clipFromView = ortho(-aspect, aspect, -1, 1, -70, 70);
        scene.viewFromWorld = rotateY(-s.angle);
    }
    scene.lights = {{.position = vec4(glm::transpose(mat3(worldFromBody(s))) * towardsLamp(s), 0)}};
    return scene;
}
Scene sceneOf(const Settings& s, const FrameInfo& frame) { return sceneAt(s, frame.aspect()); }

Relief reliefOf(const Gpu& gpu, const Settings& s) {
    return {s.body, s.depth, isMirrored(s), s.picture.isSet() ? &*gpu.heights : nullptr};
}
mat4 worldFromBody(const Settings& s) {
    return s.body == ReliefBody::orange ? rotateX(s.spinX) * rotateY(s.spinY) : mat4(1);
}
vec3 towardsLamp(const Settings& s) { return {rotateY(s.lampTurn) * rotateX(-s.lampHeight) * vec4(0, 0, 1, 0)}; }
vec3 towardsEye(const Settings& s) {
    return s.body == ReliefBody::orange ? vec3(0, 0, 1)
                                        : vec3(std::sin(radians(s.angle)), 0, std::cos(radians(s.angle)));
}

// The first and the last piece in view. Piece 0 of the wall begins at x = 0 and is 2 units long. The relief lies below the wall's
// plane and is seen from the right, so the view reaches farther to the left.
std::pair<int, int> piecesInView(const Settings& s, double aspect) {
    if (s.body == ReliefBody::orange) return {0, 0};
    const double half = aspect / std::cos(radians(s.angle)), below = s.depth * std::tan(radians(s.angle));
    return {static_cast<int>(std::floor(std::max(-half - below, -wallEnd) / 2)),
            static_cast<int>(std::ceil(std::min(half, wallEnd) / 2)) - 1};
}

bool isMirrored(const Settings& s) { return s.mirrored && s.body == ReliefBody::wall; }
bool showsBoth(const Settings& s) { return s.method != Method::displaced && s.beside; }

Pane leftPane(const Settings& s, const Frame& frame) {
    if (frame.measuring()) return {0, 0, frame.width(), frame.height()};
    return paneAboveStrip(frame, 0, showsBoth(s) ? 0.498 : 1);
}
Pane rightPane(const FrameInfo& frame) { return paneAboveStrip(frame, 0.502, 1); }

}  // namespace mv::bump_map

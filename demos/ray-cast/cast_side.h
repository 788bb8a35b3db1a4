// ray-cast's right half: the scene from the side, with one ray and what it meets.
#pragma once
#include <vector>

#include "cast_objects.h"
#include "mv/demo/frame.h"
#include "mv/geometry/ray.h"
#include "mv/gl/drawing.h"

namespace mv {

inline const vec4 castInk(0.12, 0.12, 0.15, 1), castRed(0.8, 0.1, 0.1, 1);  // of words, and of the one ray

// The eye looks along -w; u is to the right and v upwards.
struct CastEye {
    vec3 at, u, v, w;
    double half = 1;  // of the image plane, which is 1 before the eye
};

struct CastCandidate {
    CastHit hit;
    CastKind kind = CastKind::plane;
};

// Seen along -u, a little from above. The side view of a far eye shows only the room round the objects. Lengths in the
// world are `scale` times those of the scene; `distance` of the eye is not.
class CastSide {
  public:
    CastSide(const Pane& pane, const CastEye& eye, double distance, double scale);

    mat4 clipFromWorld() const { return clipFromWorld_; }
    // The ray to the nearest of `met`, in that order, and faint beyond it; the candidates with their numbers; the eye.
    void draw(Drawing& drawing, const Ray& ray, const std::vector<CastCandidate>& met, const TextStyle& words) const;

  private:
    bool eyeIsSeen() const { return distance_ <= 12; }
    vec2 at(const vec3& point) const;
    void drawEye(Drawing& drawing, const TextStyle& words) const;

    Pane pane_;
    CastEye eye_;
    double distance_, scale_;
    mat4 clipFromWorld_;
};

// Lists the objects that the ray meets, each with its t, and below them those of `shown` that it misses.
void drawCandidates(Drawing& drawing, const Pane& pane, const std::vector<CastCandidate>& met,
                    const std::vector<CastKind>& shown, const TextStyle& words);

}  // namespace mv

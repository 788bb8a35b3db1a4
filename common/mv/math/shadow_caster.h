// Whether a caster throws a shadow on a floor, and the sentence to say where it does not, or only in part.
#pragma once
#include <span>
#include <string>
#include <string_view>

#include "mv/math/types.h"

namespace mv {

struct CasterVerdict {
    bool casts = false;    // some part of it throws a true shadow: draw it, cut off by shadowCasterBounds
    std::string sentence;  // for the user; "" where the whole caster throws its shadow
};

// The plane's name in the sentence: "above the floor", "in front of the wall".
enum class PlaneKind { floor, wall };

// The verdict for a caster of one piece with these corners (all vertices of its mesh, or of its convex hull), in the
// space of light and floor, called `name` in the sentence ("square"). Light and floor as for shadowProjection; here the
// side matters: above the floor (in front of the wall) is where its normal points, and the floor shows what falls on
// its upper side. A light in the floor, which shadowProjection refuses, and a light below it are verdicts, not errors;
// so a demo asks here first. A part casts where it is above the floor and below the light; heights within 1e-12 of the
// size of the coordinates, the light's and the caster's, count as equal, since that much may be rounding.
// The verdict is right where each number is 0 or its size is from 1e-100 to 1e100.
// Refused: no corners, heights that overflow, and what shadowProjection refuses for other reasons than the light's height.
CasterVerdict judgeCaster(std::string_view name, std::span<const vec3> corners, const vec4& light, const vec4& floor,
                          PlaneKind kind = PlaneKind::floor);

}  // namespace mv

#include "mv/geometry/cube_faces.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "mv/error.h"

namespace mv {
namespace {

// The table of OpenGL's specification ("Cube Map Texture Selection"): where each face looks, and where its s and t go.
struct Face {
    vec3 forward, right, up;
};
const std::array<Face, cubeFaces> faces{{{{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
                                         {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                                         {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                                         {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
                                         {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
                                         {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}}};

const Face& faceOf(int face) {
    if (face < 0 || face >= cubeFaces) throw Error("cube face", "must be 0 .. 5", std::to_string(face));
    return faces.at(static_cast<std::size_t>(face));
}

}  // namespace

CubePlace cubePlace(const vec3& direction) {
    const vec3 size = glm::abs(direction);
    if (!(std::isfinite(size.x) && std::isfinite(size.y) && std::isfinite(size.z)) || direction == vec3(0))
        throw Error("cube map", "must be looked up in a direction, finite and not 0");
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    const int face = 2 * axis + (direction[axis] < 0 ? 1 : 0);
    const Face& found = faceOf(face);
    const vec3 onFace = direction / size[axis];  // before the sums, so that huge and tiny directions stay in range
    return {face, 0.5 + 0.5 * vec2(glm::dot(onFace, found.right), glm::dot(onFace, found.up))};
}

vec3 cubeDirection(const CubePlace& place) {
    if (std::isnan(place.at.x) || std::isnan(place.at.y)) throw Error("cube map", "must have a place that is a number");
    const Face& face = faceOf(place.face);
    return face.forward + (2 * place.at.x - 1) * face.right + (2 * place.at.y - 1) * face.up;
}

mat4 cubeFaceView(int face) {
    const Face& seen = faceOf(face);
    mat4 view(1);
    for (int column = 0; column < 3; ++column)
        view[column] = vec4(seen.right[column], seen.up[column], -seen.forward[column], 0);
    return view;
}

}  // namespace mv

// The maps of bump-map: heights, their paint, and the normals that are computed from them; made when they change, and bound.
#include "bump-map.h"
#include "mv/gl/gl.h"
#include "mv/image/mipmap.h"
#include "shared/own_picture.h"
#include "shared/relief_maps.h"

namespace mv::bump_map {

// Make the maps that have changed, and bind them: the normals, which are computed from the heights, and the heights with their paint.
void bindMaps(Gpu& gpu, const Settings& s) {
    const int version = s.picture.version();
    const FloatPicture& heights = gpu.heights.of({s.body, s.mapSize, version}, [&] { return heightMap(s); });
    if (usesNormals(s.method)) {
        const Texture& normals = gpu.normals.of({s.body, s.mapSize, version, formatOf(s), s.depth}, [&] {
            return upload(s, reliefNormals(reliefOf(gpu, s), heights), "normals");
        });
        normals.bind(1);
    }
    const Texture& painted =
        gpu.painted.of({s.body, s.mapSize, version, formatOf(s)}, [&] { return upload(s, heights, "painted"); });
    painted.bind(0);
}
bool usesNormals(Method method) {
    return method == Method::normal || method == Method::parallax || method == Method::occlusion;
}
Texture upload(const Settings& s, const FloatPicture& map, const char* label) {
    Texture made(mipmaps(map), {.texels = formatOf(s), .label = label});
    made.filterBy({.minify = GL_LINEAR_MIPMAP_LINEAR, .magnify = GL_LINEAR, .wrap = GL_REPEAT});
    if (s.body == ReliefBody::orange)  // nothing lies beyond a pole
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return made;
}
FloatPicture heightMap(const Settings& s) {
    if (!s.picture.isSet()) return paintedMap(s.body, s.mapSize);
    return ownHeights(*s.picture.content(), s.body == ReliefBody::orange ? 2 * s.mapSize : s.mapSize, s.mapSize);
}
Texels formatOf(const Settings& s) { return s.texels == Kept::bytes ? Texels::bytes : filteredFloats(); }

}  // namespace mv::bump_map

// The maps of bump-map: heights, their paint, and the normals that are computed from them; made when they change, and bound.
#include "bump-map.h"
#include "mv/gl/gl.h"
#include "mv/image/mipmap.h"
#include "shared/own_picture.h"
#include "shared/relief_maps.h"

namespace mv::bump_map {

// Remake the maps that have changed, and bind them: heights with paint, and normals computed from the heights.
void bindMaps(Gpu& gpu, const Settings& s) {
    const auto upload = [&](const FloatPicture& map, int unit, const char* label) {
        Texture made(mipmaps(map), {.texels = formatOf(s), .label = label});
        made.filterBy({.minify = GL_LINEAR_MIPMAP_LINEAR, .magnify = GL_LINEAR, .wrap = GL_REPEAT}, unit);
        if (s.body == ReliefBody::orange)  // nothing lies beyond a pole
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        return made;
    };
    if (gpu.heightsFor.changed(s.body, s.mapSize, s.picture.version())) gpu.heights = heightMap(s);
    if (usesNormals(s.method)) {
        if (gpu.normalsFor.changed(s.body, s.mapSize, s.picture.version(), formatOf(s), s.depth)) {
            gpu.normals = upload(reliefNormals(reliefOf(gpu, s), gpu.heights), 1, "normals");
            gpu.paintedFor.forget();  // upload it again: its texture unit was used
        } else {
            gpu.normals.bind(1);
        }
    }
    if (gpu.paintedFor.changed(s.body, s.mapSize, s.picture.version(), formatOf(s)))
        gpu.painted = upload(gpu.heights, 0, "painted");
    else
        gpu.painted.bind(0);
}
FloatPicture heightMap(const Settings& s) {
    if (!s.picture.isSet()) return paintedMap(s.body, s.mapSize);
    return ownHeights(*s.picture.content(), s.body == ReliefBody::orange ? 2 * s.mapSize : s.mapSize, s.mapSize);
}
Texels formatOf(const Settings& s) { return s.texels == Kept::bytes ? Texels::bytes : filteredFloats(); }

}  // namespace mv::bump_map

// The pattern as a 3D texture: computed once at the middle of each texel, and read between them.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "mv/gl/functions.h"
#include "mv/math/transform.h"
#include "procedural.h"
#include "shared/in_rows.h"

namespace mv::procedural {

void drawFromTexture(Gpu& gpu, const Settings& s, const Frame& frame) {
    // Make the texture anew where another pattern is asked for, and bind it
    const double side = textureSide(s, frame);
    if (gpu.solidFor.changed(s.pattern, s.octaves, s.distance, s.texels, side)) gpu.solid = solidTexture(s, side);
    glBindTexture(GL_TEXTURE_3D, gpu.solid.id());

    // Place the body, and map each of its points to 0..1 in the texture
    const Program& program = *gpu.byTexture;
    program.use();
    const BodyMatrices matrices = bodyMatrices(s, frame);
    program.set("clipFromBody", matrices.clipFromBody);
    program.set("viewFromBody", matrices.viewFromBody);
    program.set("textureFromBody", translate(0.5, 0.5, 0.5) * scale(1 / side) * matrices.offsetFromBody);
    program.set("isRound", s.view == View::sphere);
    program.set("solid", 0);  // texture unit
    program.set("dark", rampOf(s.pattern).dark);
    program.set("light", rampOf(s.pattern).light);
    drawBody(gpu, s);
}

// The cube that the texture fills, in units. The outermost texels have their middles on the sphere's box, or on the wall's
// edges, so that no point lies beyond them.
double textureSide(const Settings& s, const FrameInfo& frame) {
    const double body = s.view == View::sphere ? 2 * sphereRadius : 3 * std::max(1.0, frame.aspect());
    return body * s.texels / (s.texels - 1);
}

// Compute the pattern in double precision, and upload a byte a texel: layer by layer, the lower row of each first.
TextureObject solidTexture(const Settings& s, double side) {
    const int n = s.texels;
    const PatternPlace place = placeOf(s);
    std::vector<std::uint8_t> texels;
    texels.resize(static_cast<std::size_t>(n * n * n));
    const auto middle = [&](int i) { return side * ((i + 0.5) / n - 0.5); };
    inRows(n, 0, [&](int layer) {
        std::vector<vec3> offsets;
        for (int row = 0; row < n; ++row) {
            for (int column = 0; column < n; ++column) offsets.emplace_back(middle(column), middle(row), middle(layer));
        }
        auto texel = texels.begin() + std::ptrdiff_t(layer) * n * n;
        for (const double value : patternAt(place, offsets))
            *texel++ = static_cast<std::uint8_t>(std::lround(255 * value));
    });

    TextureObject texture = makeTexture();
    glBindTexture(GL_TEXTURE_3D, texture.id());
    labelObject(GL_TEXTURE, texture.id(), "solid");
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage3D(GL_TEXTURE_3D, 0, GL_R8, n, n, n, 0, GL_RED, GL_UNSIGNED_BYTE, texels.data());
    glTexParameteri(GL_TEXTURE_3D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    for (const GLenum wrap : {GLenum(GL_TEXTURE_WRAP_S), GLenum(GL_TEXTURE_WRAP_T), GLenum(GL_TEXTURE_WRAP_R)})
        glTexParameteri(GL_TEXTURE_3D, wrap, GL_CLAMP_TO_EDGE);
    return texture;
}

}  // namespace mv::procedural

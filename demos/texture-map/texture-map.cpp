// texture-map: which point of a texture a pixel shows: parametrized surfaces, and what is interpolated between corners.
#include "texture-map.h"

#include <array>

#include "mv/gl/gl.h"
#include "perspective_quad.h"

namespace mv::texture_map {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Pane pane = paneOf(frame);
    glViewport(pane.x, pane.y, pane.width, pane.height);
    if (isCircle(s)) return;  // the figure draws it
    bindTexture(gpu, s);

    // Choose the program by what it interpolates between the corners
    const Program& program = programOf(gpu, s);
    program.use();
    program.set("clipFromModel", clipFromModel(s, pane));
    program.set("beyond", s.reach - 1);
    if (isByHand(s)) program.set("divided", s.surface.method == Method::byHand);
    if (isTriangle(s)) setPlaneMap(program, planeMap(s.triangle));  // triangle.cpp
    setMeasured(program, s, pane);

    // Draw the surface: triangles with texture coordinates, or a point for each texel
    glEnable(GL_DEPTH_TEST);
    if (gpu.meshFor.changed(s.shape, s.surface.method, s.texels, s.surface.divisions, s.surface.formula, s.surface.seam,
                            s.triangle.distance))
        gpu.mesh = Mesh(meshOf(s), "surface");
    gpu.mesh.draw();
}

// Upload the texture when another one is set, with its wrapping beyond 0..1. Else bind the texture that is there.
void bindTexture(Gpu& gpu, const Settings& s) {
    if (!gpu.imageFor.changed(s.texels, s.picture.version(), s.wrap)) return gpu.image.bind(0);
    gpu.image = Texture(imageOf(s), GL_NEAREST, "chart");  // a new texture clamps
    if (s.wrap == Wrap::clamp) return;
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, static_cast<GLint>(wrapping(s.wrap)));
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, static_cast<GLint>(wrapping(s.wrap)));
}
// GL_TEXTURE_WRAP_S for u, GL_TEXTURE_WRAP_T for v.
GLenum wrapping(Wrap wrap) {
    constexpr std::array<GLenum, 3> names{GL_CLAMP_TO_EDGE, GL_REPEAT, GL_MIRRORED_REPEAT};
    return names.at(static_cast<std::size_t>(wrap));
}
Picture imageOf(const Settings& s) {
    return s.picture.isSet() ? shrink(*s.picture.content(), 1024, 1024) : chart(s.texels);
}

// The programs differ in what the driver interpolates:
//     affine    u and v along the picture (noperspective)
//     correct   u and v along the surface: it divides by w
//     by-hand   u/w, v/w and 1/w along the picture, and the pixel divides
//     point     the point itself, whose texture coordinates the pixel finds
const Program& programOf(Gpu& gpu, const Settings& s) {
    if (isTriangle(s)) return *gpu.byPoint;
    if (isByHand(s)) return *gpu.byHand;
    return s.surface.method == Method::affine ? *gpu.affine : *gpu.correct;
}

// surface.cpp and triangle.cpp have the shapes, and the cameras that look at them.
MeshData meshOf(const Settings& s) {
    if (isTriangle(s)) return withoutTexCoords(triangleMesh(s.triangle));
    return isForward(s) ? texelPoints(s.shape, s.surface, s.texels) : surfaceMesh(s.shape, s.surface);
}
mat4 clipFromModel(const Settings& s, const Pane& pane) {
    return isTriangle(s) ? clipFromTriangle(s.triangle, pane) : clipFromSurface(s.shape, s.surface, pane);
}

// Let the shader measure how far each pixel's texture lies from its place on the square.
void setMeasured(const Program& program, const Settings& s, const Pane& pane) {
    program.set("compared", s.shape == Shape::quad);
    program.set("pixelFromQuad", pixelFromQuad(s.surface.ratio, pane));
    program.set("quadFromPixel", quadFromPixel(s.surface.ratio, pane));
}

bool isTriangle(const Settings& s) { return s.shape == Shape::triangle; }
bool isForward(const Settings& s) { return !isTriangle(s) && s.surface.method == Method::forward; }
bool isByHand(const Settings& s) {
    return !isTriangle(s) && (s.surface.method == Method::byHand || s.surface.method == Method::undivided);
}
bool isCircle(const Settings& s) {
    return s.shape == Shape::cylinder && s.surface.formula == Formula::lecture && !isForward(s);
}

}  // namespace mv::texture_map

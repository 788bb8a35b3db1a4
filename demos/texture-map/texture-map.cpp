// texture-map: which point of a texture a pixel shows: parametrized surfaces, and what is interpolated between corners.
#include "texture-map.h"

#include <array>

#include "mv/gl/gl.h"
#include "perspective_quad.h"

namespace mv::texture_map {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    // Each shape has its texture coordinates from its parametrization, but for the triangle: triangle.cpp
    constexpr std::array ofShape{drawSurface, drawSurface, drawSurface, drawTriangle};  // in the order of Shape
    const Pane pane = paneOf(frame);
    glViewport(pane.x, pane.y, pane.width, pane.height);
    glEnable(GL_DEPTH_TEST);
    ofShape.at(std::size_t(s.shape))(gpu, s, pane);
}

// Draw a parametrized surface: triangles with texture coordinates, or a point for each texel.
void drawSurface(Gpu& gpu, const Settings& s, const Pane& pane) {
    if (isCircle(s)) return;  // the figure draws it
    bindTexture(gpu, s);
    const auto& [method, divisions, ratio, formula, seam, turn] = s.surface;
    const Mesh& mesh = gpu.surface.of({s.shape, method, s.texels, divisions, formula, seam},
                                      [&] { return Mesh(meshOf(s), "surface"); });
    const Program& program = programOf(gpu, method);
    program.use();
    program.set("clipFromModel", clipFromSurface(s.shape, s.surface, pane));  // surface.cpp
    if (isByHand(s)) program.set("divided", method == Method::byHand);
    setLookup(program, s, pane);
    mesh.draw();
}

// The programs differ in what the driver interpolates between the corners:
//     affine    u and v along the picture (noperspective)
//     correct   u and v along the surface: it divides by w
//     by-hand   u/w, v/w and 1/w along the picture, and the pixel divides
const Program& programOf(Gpu& gpu, Method method) {
    const std::array ofMethod{&gpu.affine, &gpu.correct, &gpu.byHand, &gpu.byHand,
                              &gpu.correct};  // in the order of Method
    return **ofMethod.at(std::size_t(method));
}
MeshData meshOf(const Settings& s) {
    return isForward(s) ? texelPoints(s.shape, s.surface, s.texels) : surfaceMesh(s.shape, s.surface);
}

// Bind the texture, which is uploaded when another one is set: GL_TEXTURE_WRAP_S says what u finds beyond 0..1, and
// GL_TEXTURE_WRAP_T what v finds.
void bindTexture(Gpu& gpu, const Settings& s) {
    const Texture& image = gpu.image.of({s.texels, s.picture.version(), s.wrap}, [&] {
        Texture made(imageOf(s), GL_NEAREST, "chart");
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, wrapping(s.wrap));
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, wrapping(s.wrap));
        return made;
    });
    image.bind(0);
}
GLint wrapping(Wrap wrap) {
    constexpr std::array<GLint, 3> names{GL_CLAMP_TO_EDGE, GL_REPEAT, GL_MIRRORED_REPEAT};  // in the order of Wrap
    return names.at(std::size_t(wrap));
}
Picture imageOf(const Settings& s) {
    return s.picture.isSet() ? shrink(*s.picture.content(), 1024, 1024) : chart(s.texels);
}

// Set how far u and v reach, and let the shader measure how far each pixel's texture lies from its place on the square.
void setLookup(const Program& program, const Settings& s, const Pane& pane) {
    program.set("beyond", s.reach - 1);
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

// The triangle of texture-map: its texture coordinates are found in each pixel, from the point of its plane that the pixel shows.
#include "mv/math/projection.h"
#include "mv/math/transform.h"
#include "texture-map.h"

namespace mv::texture_map {

void drawTriangle(Gpu& gpu, const Settings& s, const Pane& pane) {
    bindTexture(gpu, s);
    const Mesh& mesh = gpu.triangle.of({s.triangle.distance},
                                       [&] { return Mesh(withoutTexCoords(triangleMesh(s.triangle)), "surface"); });
    const Program& program = *gpu.byPoint;
    program.use();
    program.set("clipFromModel", clipFromTriangle(s.triangle, pane));
    setPlaneMap(program, planeMap(s.triangle));
    setLookup(program, s, pane);
    mesh.draw();
}

// The corners, in a plane at the distance from the origin.
TexturedTriangle cornersOf(const Triangle& triangle) {
    const mat4 tilt = rotateX(30) * rotateY(25);
    const auto at = [&](double x, double y) { return vec3(tilt * vec4(x, y, triangle.distance, 0)); };
    return {{at(-1.2, -1), at(1.2, -1), at(0, 1.2)}, {vec2(0.1, 0.1), vec2(0.9, 0.1), vec2(0.5, 0.9)}};
}

// Map a point to its texture coordinates: by the inverse of the lecture's matrix P, or along the triangle's edges.
PlaneMap planeMap(const Triangle& triangle) {
    return triangle.map == Map::matrix ? mapByMatrix(cornersOf(triangle)) : mapByEdges(cornersOf(triangle));
}

void setPlaneMap(const Program& program, const PlaneMap& map) {
    program.set("textureFromPoint", map.linear);
    program.set("corner", map.corner);
    program.set("atCorner", map.atCorner);
}

MeshData triangleMesh(const Triangle& triangle) {
    MeshData made;
    const TexturedTriangle corners = cornersOf(triangle);
    for (std::size_t i = 0; i < 3; ++i) {
        made.positions.emplace_back(corners.points.at(i));
        made.texCoords.emplace_back(corners.texture.at(i));
    }
    return made;
}

// The camera moves with the plane, so the triangle looks the same at every distance from the origin.
mat4 clipFromTriangle(const Triangle& triangle, const Pane& pane) {
    return perspective(50, pane.aspect(), 0.1, 20) * translate(0, 0, -3.2) * rotateY(30) *
           translate(0, 0, -triangle.distance) * rotateY(-25) * rotateX(-30);
}

}  // namespace mv::texture_map

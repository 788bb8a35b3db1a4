#include "shared/regular_meshes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "mv/error.h"
#include "mv/geometry/shapes.h"
#include "mv/math/transform.h"

namespace mv {
namespace {

// The sheet rolled up, about the y axis; its first and its last column are the same places, bit for bit.
MeshData tube(int cells, double radius, double height) {
    MeshData mesh = grid(cells, cells);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        const long column = std::lround((double(mesh.positions[i].x) + 0.5) * cells) % cells;
        const double angle = radians(-360.0 * double(column) / cells);
        mesh.normals[i] = {float(std::cos(angle)), 0, float(std::sin(angle))};
        mesh.positions[i] = {float(radius * std::cos(angle)), float(-height) * mesh.positions[i].z,
                             float(radius * std::sin(angle))};
    }
    return mesh;
}

RegularMesh withTopology(std::string name, MeshData mesh) {
    RegularMesh made{std::move(name), std::move(mesh), {}, {.primitive = Primitive::points}};
    made.topology = topologyOf(made.mesh);
    std::map<std::tuple<float, float, float>, fvec3> normals;
    for (std::size_t i = 0; i < made.mesh.positions.size(); ++i) {
        const fvec3& p = made.mesh.positions[i];
        normals[{p.x, p.y, p.z}] = made.mesh.normals[i];
    }
    for (std::size_t i = 0; i < made.topology.positions.size(); ++i) {
        if (!made.topology.isInner[i] || made.topology.degrees[i] == 6) continue;
        const fvec3& p = made.topology.positions[i];
        made.irregular.positions.push_back(p);
        made.irregular.normals.push_back(normals.at({p.x, p.y, p.z}));
    }
    return made;
}

}  // namespace

std::vector<RegularMesh> regularMeshes(int cells) {
    if (cells < 3 || cells > 64) throw Error("regularMeshes", "must have 3 .. 64 cells", std::to_string(cells));
    return {withTopology("plane", grid(cells, cells, 2.4, 2.4)), withTopology("cylinder", tube(cells, 1, 2)),
            withTopology("torus", torus(1, 0.45, cells, cells)), withTopology("sphere", sphere(1.25, cells, cells))};
}

void labelBody(Drawing& drawing, const Pane& pane, const RegularMesh& body) {
    const int words = std::min(pane.height / 16, pane.width / 26);
    if (words < 8) return;
    const vec4 ink(0.1, 0.1, 0.1, 1), red(0.75, 0.15, 0.1, 1);
    const Topology& counts = body.topology;
    double y = pane.height - 8.0;
    const auto line = [&](const std::string& text, const vec4& color) {
        drawing.text({0.66 * pane.width, y}, text, {words, color, vec4(0)});
        y -= 1.4 * words;
    };
    drawing.in(pane);
    line(body.name, ink);
    line("V = " + std::to_string(counts.vertices()), ink);
    line("E = " + std::to_string(counts.edges), ink);
    line("F = " + std::to_string(counts.faces), ink);
    line("V - E + F = " + std::to_string(counts.euler()), ink);
    line("edges missing: " + std::to_string(counts.missing()), ink);
    const long irregular = counts.irregular();
    line(irregular == 0 ? "regular inside" : "irregular: " + std::to_string(irregular), irregular == 0 ? ink : red);
}

}  // namespace mv

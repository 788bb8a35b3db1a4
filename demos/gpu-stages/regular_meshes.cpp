#include "regular_meshes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <tuple>
#include <utility>

#include "mv/error.h"
#include "mv/geometry/shapes.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

namespace mv {
namespace {

// Roll the sheet up about the y axis. Its first and its last column are the same places, bit for bit.
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
    RegularMesh made{std::move(name), withoutTexCoords(std::move(mesh)), {}, {.primitive = Primitive::points}};
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

// ---- The figure

constexpr vec3 eye(0, 0, 5);

// Place a body in the left two thirds of its pane. Words stand at its right.
mat4 clipFromBody(const Pane& pane, const mat4& turn) {
    return translate(-0.28, 0, 0) * perspective(40, pane.aspect(), 1, 20) * lookAt(eye, vec3(0), vec3(0, 1, 0)) * turn;
}

// A pane as a part of the picture.
mat4 clipFromPane(const FrameInfo& frame, const Pane& pane) {
    const vec2 size(frame.width(), frame.height());
    const vec2 middle(pane.x + 0.5 * pane.width, pane.y + 0.5 * pane.height);
    return translate(2 * middle.x / size.x - 1, 2 * middle.y / size.y - 1, 0) *
           scale(pane.width / size.x, pane.height / size.y, 1);
}

void markIrregular(Drawing& drawing, const Pane& pane, const RegularMesh& body, const mat4& turn) {
    for (std::size_t i = 0; i < body.irregular.positions.size(); ++i) {
        const vec3 at(turn * vec4(vec3(body.irregular.positions[i]), 1));
        const vec3 normal(turn * vec4(vec3(body.irregular.normals[i]), 0));
        if (glm::dot(normal, eye - at) > 0)
            drawing.point(clipFromBody(pane, turn), vec3(body.irregular.positions[i]), pane.height / 30.0,
                          vec4(0.8, 0.15, 0.1, 1));
    }
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
    line(body.name, ink);
    line("V = " + std::to_string(counts.vertices()), ink);
    line("E = " + std::to_string(counts.edges), ink);
    line("F = " + std::to_string(counts.faces), ink);
    line("V - E + F = " + std::to_string(counts.euler()), ink);
    line("edges missing: " + std::to_string(counts.missing()), ink);
    const long irregular = counts.irregular();
    line(irregular == 0 ? "regular inside" : "irregular: " + std::to_string(irregular), irregular == 0 ? ink : red);
}

}  // namespace

std::vector<RegularMesh> regularMeshes(int cells) {
    if (cells < 3 || cells > 64) throw Error("regularMeshes", "must have 3 .. 64 cells", std::to_string(cells));
    return {withTopology("plane", grid(cells, cells, 2.4, 2.4)), withTopology("cylinder", tube(cells, 1, 2)),
            withTopology("torus", torus(1, 0.45, cells, cells)), withTopology("sphere", sphere(1.25, cells, cells))};
}

void RegularFigure::draw(const Frame& frame, const mat4& turn, const Program& program, int cells) {
    if (madeFor_.changed(cells)) {
        bodies_ = regularMeshes(cells);
        meshes_.clear();
        for (const RegularMesh& body : bodies_) meshes_.emplace_back(body.mesh, body.name);
    }
    const std::vector<Pane> panes = frame.panes(static_cast<int>(meshes_.size()));
    for (std::size_t i = 0; i < meshes_.size(); ++i) {
        program.set("clipFromWorld", clipFromPane(frame, panes[i]) * clipFromBody(panes[i], turn));
        meshes_[i].draw();
    }
}

void RegularFigure::label(const FrameInfo& frame, const mat4& turn, Drawing& drawing) const {
    const std::vector<Pane> panes = frame.panes(static_cast<int>(bodies_.size()));
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
        drawing.in(panes[i]);
        markIrregular(drawing, panes[i], bodies_[i], turn);
        labelBody(drawing, panes[i], bodies_[i]);
    }
}

long RegularFigure::irregular() const {
    long sum = 0;
    for (const RegularMesh& body : bodies_) sum += body.topology.irregular();
    return sum;
}

}  // namespace mv

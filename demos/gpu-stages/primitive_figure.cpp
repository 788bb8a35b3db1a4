#include "primitive_figure.h"

#include <algorithm>
#include <numeric>
#include <string>

#include "mv/gl/feedback.h"
#include "mv/math/transform.h"

namespace mv {
namespace {

// Vertex i has colour i. A primitive takes the colour of its last vertex.
MeshData meshOf(const PrimitiveType& type, int vertices) {
    const std::array<fvec4, 4> colors{fvec4(0.85F, 0.55F, 0.25F, 1), fvec4(0.35F, 0.6F, 0.75F, 1),
                                      fvec4(0.6F, 0.7F, 0.4F, 1), fvec4(0.7F, 0.5F, 0.65F, 1)};
    MeshData mesh;
    for (const vec2& place : placesOf(type, vertices)) {
        mesh.positions.emplace_back(fvec2(place), 0.0F);
        mesh.colors.push_back(colors.at(mesh.colors.size() % colors.size()));
    }
    if (!type.inCore) mesh.indices = asTriangles(type, vertices);
    return mesh;
}

// The middle of a pane's figure, and half of its side, in pixels of the pane: above the words.
vec2 middleOf(const Pane& pane) { return {0.5 * pane.width, 0.62 * pane.height}; }
double halfOf(const Pane& pane) { return std::min(0.42 * pane.width, 0.34 * pane.height); }

mat4 clipFromFigure(const FrameInfo& frame, const Pane& pane) {
    const vec2 size(frame.width(), frame.height()), middle = vec2(pane.x, pane.y) + middleOf(pane);
    return translate(2 * middle.x / size.x - 1, 2 * middle.y / size.y - 1, 0) *
           scale(2 * halfOf(pane) / size.x, 2 * halfOf(pane) / size.y, 1);
}

}  // namespace

void PrimitiveFigure::draw(const Frame& frame, const Program& program, int vertices, bool counts) {
    const bool anew = madeFor_.changed(vertices, counts);
    if (anew) {
        vertices_ = vertices;
        meshes_.clear();
        counts_ = {};
        for (const PrimitiveType& type : primitiveTypes) meshes_.emplace_back(meshOf(type, vertices), type.name);
    }
    const std::vector<Pane> panes = frame.panes(static_cast<int>(primitiveTypes.size()));
    for (std::size_t i = 0; i < primitiveTypes.size(); ++i) {
        const PrimitiveType& type = primitiveTypes.at(i);
        const Mesh& mesh = meshes_[i];
        program.set("clipFromPane", clipFromFigure(frame, panes[i]));
        if (type.inCore) {
            mesh.drawAs(type.mode);
            if (anew && counts)
                counts_.at(i) = captured(program.primitiveOut(type.mode), [&] { mesh.drawAs(type.mode); }).generated;
        } else {
            mesh.draw();
        }
    }
}

void PrimitiveFigure::label(const FrameInfo& frame, Drawing& drawing) const {
    const std::vector<Pane> panes = frame.panes(static_cast<int>(primitiveTypes.size()));
    const int words = std::min(panes[0].width / 14, panes[0].height / 10);
    if (words < 8) return;
    const vec4 ink(0.1, 0.1, 0.1, 1), grey(0.45, 0.45, 0.47, 1), red(0.75, 0.15, 0.1, 1);
    for (std::size_t i = 0; i < primitiveTypes.size(); ++i) {
        const PrimitiveType& type = primitiveTypes.at(i);
        const Pane& pane = panes[i];
        drawing.in(pane);
        const auto line = [&](double y, const std::string& text, const vec4& color) {
            drawing.textAround({0.5 * pane.width, y}, text, {words, color, vec4(0)});
        };
        line(2.1 * words, type.name, type.inCore ? ink : red);
        const std::string makes = "makes " + std::to_string(primitivesOf(type, vertices_));
        const std::string count = counts_.at(i) == 0 ? "" : ", counted " + std::to_string(counts_.at(i));
        line(0.9 * words, type.inCore ? makes + count : makes + ", not in the core", type.inCore ? grey : red);
        const std::vector<vec2> places = placesOf(type, vertices_);
        for (std::size_t k = 0; k < places.size(); ++k) {
            const vec2 out = standsInRing(type) ? places[k] / 0.75 : vec2(0, places[k].y < 0 ? -1 : 1);
            drawing.textAround(middleOf(pane) + halfOf(pane) * (places[k] + 0.18 * out), std::to_string(k),
                               {std::max(8, 3 * words / 4), ink, vec4(0)});
        }
    }
}

long PrimitiveFigure::counted() const { return std::accumulate(counts_.begin(), counts_.end(), 0L); }

}  // namespace mv

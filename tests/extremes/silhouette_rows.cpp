// X61: silhouettes by triangles that know their neighbours, with the light in a triangle's plane.
#include <cmath>
#include <map>
#include <string>
#include <tuple>
#include <vector>

#include "extremes/row.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/beyond_es.h"
#include "mv/gl/feedback.h"
#include "mv/gl/gl.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"
#include "shadow-volume/neighbours.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

// The corners of a ring at which its silhouette does not close, over lights in the planes of its triangles. `first` is GLSL: the
// corner that is asked first, of corners i, j and k.
double openCorners(const std::string& first) {
    const DemoRun run("shadow-volume");  // a context, and the shaders' stages declared
    std::string geometry = fileText(tree() + "/shaders/shadow-volume/sides.geom");
    const std::size_t begin = geometry.find("int first = "), end = geometry.find(';', begin);
    geometry.replace(begin, end - begin, "int first = " + first);
    const Program program =
        Program::fromTexts("sides", {{"vert", fileText(tree() + "/shaders/shadow-volume/sides.vert")},
                                     {"geom", geometry},
                                     {"frag", fileText(tree() + "/shaders/shadow-volume/sides.frag")}});
    const ClosedMesh ring(torus(1, 0.45, 24, 17));
    const Mesh mesh(withNeighbours(ring), "ring");
    program.use();
    program.set("clipFromObject", mat4(1));
    double open = 0;
    for (const auto& [i, j, k] : ring.triangles()) {
        const vec3 a(ring.positions()[i]), b(ring.positions()[j]), c(ring.positions()[k]);
        program.set("light", vec4(a + 3.3 * (b - a) + 1.9 * (c - a), 1));
        const Captured sides = captured(GL_TRIANGLES, [&] { mesh.drawAs(GL_TRIANGLES_ADJACENCY); });
        std::map<std::tuple<float, float, float>, int> balance;
        for (std::size_t at = 0; at + 5 < sides.positions.size(); at += 6) {
            const fvec4 &to = sides.positions[at], &from = sides.positions[at + 1];
            ++balance[{from.x, from.y, from.z}];
            --balance[{to.x, to.y, to.z}];
        }
        for (const auto& [corner, sum] : balance) open += sum == 0 ? 0 : 1;
    }
    return open;
}

[[maybe_unused]] const bool x61 = addRow([] {
    return Row{.id = "X61 plane",
               .input = "a ring of 816 triangles, and a light in the plane of each of them in turn",
               .measured = "corners at which the silhouette does not close",
               .naive = "a triangle asked from three sides, each with the corners in its own order, in float",
               .naiveError = openCorners("i"),
               .ours = "whoever asks begins with the corner of the least number (sides.geom)",
               .ourError = openCorners(
                   "number[i] < number[j] ? (number[i] < number[k] ? i : k) : (number[j] < number[k] ? j : k)"),
               .tolerance = 0,
               .reason = "the volume is closed with either answer, if it is one"};
});

// X62: many lights of which each is less than half a step of the sum's format.
double stepsOff(const std::string& way, const std::string& sum) {
    DemoRun run("deferred", 200, 120);
    const auto draw = [&](const std::string& by, const std::string& format) {
        return run.preset("too-dim-to-add").set("power", 0.001).set("way", by).set("sum", format).picture();
    };
    const Picture right = draw("forward", "half-float"), made = draw(way, sum);
    double off = 0;
    for (std::size_t i = 0; i < right.rgba.size(); ++i) off += std::abs(int(right.rgba[i]) - int(made.rgba[i]));
    return off / (0.75 * double(right.rgba.size()));
}

[[maybe_unused]] const bool x62 = addRow([] {
    return Row{.id = "X62 dim",
               .input = "96 lamps, each of which gives most surfaces less than 1/510",
               .measured = "mean error of the picture's numbers, of 255",
               .naive = "added one by one in 8 bits",
               .naiveError = stepsOff("lamp-by-lamp", "8-bit"),
               .ours = "added one by one in half floats",
               .ourError = stepsOff("lamp-by-lamp", "half-float"),
               .tolerance = 0.5,
               .reason = "half a step of the picture, which has 8 bits itself"};
});

}  // namespace

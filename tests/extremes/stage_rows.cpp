// X53: levels of tessellation that are none, and neighbours whose levels differ.
#include <cmath>
#include <string>

#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/geometry/tessellation.h"
#include "mv/gl/beyond_es.h"
#include "mv/gl/gl.h"
#include "mv/gl/state.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr int side = 200;

// Two square patches beside each other fill the picture. Their common edge is bent towards the eye of a camera that looks
// along it, so a gap in it shows the background. `level` is GLSL: the level of the edge at x, of the patch `which` (0, 1).
long backgroundPixels(const std::string& level) {
    stage();
    allowVersion(33);
    if (!allow(Newer::tessellation)) throw Error("X53", "needs a context that tessellates");
    const Program program = Program::fromTexts(
        "patches", {{"vert", "in vec3 position;\nvoid main() { gl_Position = vec4(position, 1.0); }\n"},
                    {"tesc",
                     "#include \"tessellation.glsl\"\nlayout(vertices = 4) out;\nuniform float nothing;\n"
                     "float level(float x, int which) { return " +
                         level +
                         "; }\n"
                         "void main() {\n"
                         "    gl_out[gl_InvocationID].gl_Position = gl_in[gl_InvocationID].gl_Position;\n"
                         "    float left = gl_in[0].gl_Position.x, right = gl_in[1].gl_Position.x;\n"
                         "    gl_TessLevelOuter[0] = level(left, gl_PrimitiveID);\n"
                         "    gl_TessLevelOuter[1] = level(0.5 * (left + right), gl_PrimitiveID);\n"
                         "    gl_TessLevelOuter[2] = level(right, gl_PrimitiveID);\n"
                         "    gl_TessLevelOuter[3] = gl_TessLevelOuter[1];\n"
                         "    gl_TessLevelInner[0] = gl_TessLevelInner[1] = max(gl_TessLevelOuter[0], "
                         "gl_TessLevelOuter[2]);\n}\n"},
                    {"tese",
                     "layout(quads, equal_spacing) in;\nvoid main() {\n"
                     "    vec4 low = mix(gl_in[0].gl_Position, gl_in[1].gl_Position, gl_TessCoord.x);\n"
                     "    vec4 high = mix(gl_in[2].gl_Position, gl_in[3].gl_Position, gl_TessCoord.x);\n"
                     "    gl_Position = mix(low, high, gl_TessCoord.y);\n"
                     // The common edge is a wave across the picture
                     "    gl_Position.x += 0.2 * sin(7.0 * gl_Position.y) * (1.0 - abs(gl_Position.x));\n}\n"},
                    {"frag", "out vec4 fragColor;\nvoid main() { fragColor = vec4(1.0); }\n"}});
    MeshData data;
    for (const float x : {-1.0F, 0.0F}) {
        for (const float y : {-1.0F, 1.0F}) {
            data.positions.emplace_back(x, y, 0.0F);
            data.positions.emplace_back(x + 1, y, 0.0F);
        }
    }
    const Target target(side, side, {});
    const Mesh mesh(data, "patches");
    restoreInitialState();
    target.bind();
    glClear(GL_COLOR_BUFFER_BIT);
    program.use();
    glPatchParameteri(GL_PATCH_VERTICES, 4);
    mesh.drawAs(GL_PATCHES);
    long count = 0;
    for (const float red : target.readRed()) count += red == 0 ? 1 : 0;
    restoreInitialState();
    allowVersion(33);
    return count;
}

Row levels(const std::string& id, const std::string& input, const std::string& wanted) {
    return {.id = "X53 " + id,
            .input = input + ", in a picture that two patches fill",
            .measured = "pixels of the background",
            .naive = "the level as it comes",
            .naiveError = double(backgroundPixels(wanted)),
            .ours = "levelInRange",
            .ourError = double(backgroundPixels("levelInRange(" + wanted + ")")),
            .tolerance = 0,
            .reason = "the patches fill the picture"};
}

[[maybe_unused]] const bool x53zero =
    addRow([] { return levels("0", "level 0 of one patch", "which == 0 ? 0.0 : 1.0"); });
[[maybe_unused]] const bool x53nan =
    addRow([] { return levels("NaN", "level 0/0 of one patch", "which == 0 ? sqrt(-1.0 - nothing) : 1.0"); });
[[maybe_unused]] const bool x53unequal = addRow([] {
    return Row{.id = "X53 neighbours",
               .input = "two patches that share an edge, at levels 4 and 9, in a picture that they fill",
               .measured = "pixels of the background",
               .naive = "each patch cuts its edges by its own level",
               .naiveError = double(backgroundPixels("which == 0 ? 4.0 : 9.0")),
               .ours = "an edge's level from the edge alone",
               .ourError = double(backgroundPixels("x < -0.9 ? 4.0 : x > 0.9 ? 9.0 : 6.0")),
               .tolerance = 0,
               .reason = "both patches cut the edge at the same places"};
});

[[maybe_unused]] const bool x53beyond = addRow([] {
    // Drivers draw what they have, which is 64 levels; so does the rule, and who counts by it knows how many there will be.
    const auto drawn = [](double level) { return double(trianglesOfSquare(level, level)); };
    return Row{.id = "X53 65",
               .input = "level 65 of a square patch",
               .measured = "triangles that are counted and not drawn",
               .naive = "2 n^2 of the level as it comes",
               .naiveError = 2.0 * 65 * 65 - drawn(largestLevel),
               .ours = "trianglesOfSquare of levelInRange",
               .ourError = drawn(levelInRange(65)) - drawn(largestLevel),
               .tolerance = 0,
               .reason = "a count of triangles"};
});

}  // namespace

// Over the picture of displacement: what is drawn, the lamp, the colours of the levels.
#include <algorithm>
#include <string>

#include "displacement.h"
#include "mv/gl/beyond_es.h"
#include "mv/gl/feedback.h"
#include "mv/gl/gl.h"
#include "mv/gl/word_size.h"

namespace mv::displacement {
namespace {

const vec4 ink(0.1, 0.1, 0.1, 1), paper(1, 1, 1, 0.8);

double reach(const FrameInfo& frame) { return 0.07 * std::min(frame.height(), frame.width()); }

std::string titleOf(const Settings& s) {
    const std::string how = isByDistance(s) ? "levels by distance" : "level " + std::to_string(s.level);
    if (!isTessellated(s)) return "prepared mesh, " + std::to_string(s.level) + " cells a patch";
    return (s.method == Method::bumped ? "not moved, only lit so: " : "moved by the height map: ") + how;
}

}  // namespace

LampDial lampDial(const FrameInfo& frame) { return {vec2(1.5 * reach(frame)), reach(frame)}; }

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    Drawing& drawing = gpu.drawing;
    drawing.begin(frame);
    const int size = std::clamp(std::min(frame.height() / 36, frame.width() / 50), leastWords, 16);
    const bool hasRoom = reach(frame) > 12;
    const vec2 box(2.75 * reach(frame) + (hasRoom ? 4 * size : 0), 2.75 * reach(frame));
    drawing.fill({vec2(0.25 * reach(frame)), box}, paper);
    lampDial(frame).draw(drawing, towardsLamp(s), hasRoom ? size : 0);
    if (hasRoom) drawing.text(vec2(0.5, -0.5) * double(size) + vec2(0, frame.height()), titleOf(s), {size, ink, paper});
    if (s.paint == Paint::levels && hasRoom) drawLevelColors(drawing, frame, size);
    drawing.draw(frame);
}

// Draw the meshes. Count the triangles that reach the rasterizer if a readout asks for their number.
void drawCounted(Gpu& gpu, const std::vector<Mesh>& meshes, GLenum mode, const Frame& frame) {
    const auto draw = [&] {
        for (const Mesh& mesh : meshes) mesh.drawAs(mode);
    };
    gpu.rasterized.reset();
    if (!frame.readouts() || !has(beyond_es::countingQueries)) return draw();
    gpu.rasterized = double(countedBy(GL_PRIMITIVES_GENERATED, draw));
}

void tell(const PatchCount& counted, const Settings& s, const Frame& frame) {
    frame.count("triangles made", double(counted.triangles));
    if (!s.cull && counted.outside > 0)
        frame.needless(std::to_string(counted.outside) + " patches out of view, cut all the same");
}

}  // namespace mv::displacement

// displacement: a wall of bricks and an orange whose vertices are really moved, by tessellation stages or by the processor.
#include "displacement.h"

#include <string>

#include "mv/gl/gl.h"
#include "mv/image/mipmap.h"
#include "shared/relief_maps.h"

namespace mv::displacement {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    if (frame.measuring()) clearCoverage();
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);  // the wall's back and the orange's inside show only through cracks

    // Draw patches, which the tessellator cuts and the evaluation shader moves, or triangles cut and moved by the processor
    bindMap(gpu, s);
    const Program& program = programOf(gpu, s, frame);
    program.use();
    setLight(program, s, frame);
    if (isTessellated(s))
        drawPatches(gpu, program, s, frame);
    else
        drawPrepared(gpu, program, s, frame);
}

// Send the corners of the patches. The tessellator makes the vertices between them.
void drawPatches(Gpu& gpu, const Program& program, const Settings& s, const Frame& frame) {
    const LevelRule rule = ruleOf(s, frame);
    makePatches(gpu, s, rule, frame);
    setTessellator(program, s, rule);
    glPatchParameteri(GL_PATCH_VERTICES, 4);
    drawCounted(gpu, gpu.corners, GL_PATCHES, frame);
}

// Count the triangles by the same rule as the control shader, whose levels OpenGL does not report. Upload the patches in as
// many parts as a driver can number the vertices of.
void makePatches(Gpu& gpu, const Settings& s, const LevelRule& rule, const Frame& frame) {
    if (gpu.patchesFor.changed(s.body)) gpu.patches = reliefPatches(s.body);
    gpu.counted = countPatches(gpu.patches, {s.body, s.depth}, rule, sceneOf(s, frame).clipFromWorld());
    if (const int parts = gpu.counted.partsToDraw(); gpu.cornersFor.changed(s.body, parts)) {
        gpu.corners.clear();
        for (const MeshData& part : patchCorners(gpu.patches, parts)) gpu.corners.emplace_back(part, "patches");
    }
    tell(gpu.counted, s, frame);
}

// Set what the control shader needs for the levels, and the evaluation shader for the positions.
void setTessellator(const Program& program, const Settings& s, const LevelRule& rule) {
    program.set("eye", rule.eye);
    program.set("fixedLevel", double(s.level));
    program.set("fineness", rule.fineness);
    program.set("byDistance", isByDistance(s));
    program.set("agrees", rule.agrees);
    program.set("leavesOut", rule.leavesOut);
    program.set("depth", s.depth);
    program.set("moved", s.method == Method::bumped ? 0.0 : s.depth);
    program.set("texel", unitsOfRepeat(s.body).y / s.mapSize);
    program.set("isRound", s.body == ReliefBody::orange);
}
LevelRule ruleOf(const Settings& s, const FrameInfo& frame) {
    return {.fixedLevel = isByDistance(s) ? 0.0 : double(s.level),
            .fineness = s.fineness,
            .agrees = s.agree,
            .eye = eyeOf(s, frame),
            .leavesOut = s.cull};
}

void drawPrepared(Gpu& gpu, const Program& program, const Settings& s, const Frame& frame) {
    const bool isMoved = s.method != Method::bumped;
    if (gpu.preparedFor.changed(s.body, s.depth, s.level, isMoved)) {
        const MeshData smooth = cutPatches(s.body, s.level);
        MeshData made = displaced({s.body, s.depth}, smooth);
        if (!isMoved) made.positions = smooth.positions;
        gpu.prepared.clear();
        gpu.prepared.emplace_back(made, "prepared mesh");
    }
    frame.count("triangles made", gpu.prepared.front().count() / 3.0);
    program.set("cells", double(s.level));
    drawCounted(gpu, gpu.prepared, GL_TRIANGLES, frame);
}

// One program for each kind: with or without tessellation, with or without lines.
const Program& programOf(Gpu& gpu, const Settings& s, const Frame& frame) {
    const std::pair<bool, bool> kind(isTessellated(s), hasLines(s, frame));
    const auto known = gpu.programs.find(kind);
    if (known != gpu.programs.end()) return known->second;
    std::vector<std::string> files{"displacement.vert"};
    if (kind.first) files = {"patch.vert", "patch.tesc", "patch.tese"};
    if (kind.second) files.emplace_back("lines.geom");
    files.emplace_back(kind.second ? "lines.frag" : "displacement.frag");
    for (std::string& file : files) file.insert(0, "displacement/");
    return gpu.programs.emplace(kind, Program::fromFiles(files.front() + "...", files)).first->second;
}
void setLight(const Program& program, const Settings& s, const Frame& frame) {
    const Scene scene = sceneOf(s, frame);
    program.set("clipFromBody", scene.clipFromWorld());
    program.set("light", vec3(scene.lights.front().position));
    program.set("view", towardsEye(s));
    if (hasLines(s, frame)) program.set("halfPicture", 0.5 * vec2(frame.width(), frame.height()));
    program.set("showsLevels", s.paint == Paint::levels);
    if (s.paint == Paint::levels) program.set("levelColors", levelColors());
}

// Bind the height map with its paint.
void bindMap(Gpu& gpu, const Settings& s) {
    if (!gpu.paintedFor.changed(s.body, s.mapSize)) return gpu.painted.bind(0);
    gpu.painted = Texture(mipmaps(paintedMap(s.body, s.mapSize)), {.texels = filteredFloats(), .label = "painted"});
    gpu.painted.filterBy({.minify = GL_LINEAR_MIPMAP_LINEAR, .magnify = GL_LINEAR, .wrap = GL_REPEAT});
    if (s.body == ReliefBody::orange) glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
}

bool isTessellated(const Settings& s) { return s.method != Method::prepared && s.hasTessellator; }
bool isByDistance(const Settings& s) { return s.method != Method::prepared && s.levels == Levels::distance; }
bool hasLines(const Settings& s, const Frame& frame) { return s.wireframe && !frame.measuring(); }

}  // namespace mv::displacement

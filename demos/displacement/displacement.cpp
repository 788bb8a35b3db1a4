// displacement: a wall of bricks and an orange whose vertices are really moved, by tessellation stages or by the processor.
#include "displacement.h"

#include <array>
#include <string>

#include "mv/gl/gl.h"
#include "mv/image/mipmap.h"
#include "shared/relief_maps.h"

namespace mv::displacement {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_CULL_FACE);  // the wall's back and the orange's inside show only through cracks

    // Draw patches, which the tessellator cuts and the evaluation shader moves, or triangles cut and moved by the processor
    bindMap(gpu, s);
    const Program& program = programOf(gpu, s, frame);
    program.use();
    setLight(program, s, frame);
    const auto drawSurface = isTessellated(s) ? drawPatches : drawPrepared;
    drawSurface(gpu, program, s, frame);
}

// Send the corners of the patches. The tessellator makes the vertices between them.
void drawPatches(Gpu& gpu, const Program& program, const Settings& s, const Frame& frame) {
    const LevelRule rule = ruleOf(s, frame);
    const std::vector<Mesh>& corners = makePatches(gpu, s, rule, frame);
    setTessellator(program, s, rule);
    glPatchParameteri(GL_PATCH_VERTICES, 4);
    drawCounted(gpu, corners, GL_PATCHES, frame);
}

// Count the triangles by the same rule as the control shader, whose levels OpenGL does not report. Upload the patches in as
// many parts as a driver can number the vertices of.
const std::vector<Mesh>& makePatches(Gpu& gpu, const Settings& s, const LevelRule& rule, const Frame& frame) {
    const std::vector<ReliefPatch>& patches = gpu.patches.of({s.body}, [&] { return reliefPatches(s.body); });
    gpu.counted = countPatches(patches, {s.body, s.depth}, rule, sceneOf(s, frame).clipFromWorld());
    tell(gpu.counted, s, frame);
    const int parts = gpu.counted.partsToDraw();
    return gpu.corners.of({s.body, parts}, [&] {
        std::vector<Mesh> corners;
        for (const MeshData& part : patchCorners(patches, parts)) corners.emplace_back(part, "patches");
        return corners;
    });
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
    const std::vector<Mesh>& prepared = gpu.prepared.of({s.body, s.depth, s.level, isMoved}, [&] {
        std::vector<Mesh> meshes;
        meshes.emplace_back(preparedMesh(s, isMoved), "prepared mesh");
        return meshes;
    });
    frame.count("triangles made", prepared.front().count() / 3.0);
    program.set("cells", double(s.level));
    drawCounted(gpu, prepared, GL_TRIANGLES, frame);
}

// Cut the patches by the processor. A mesh that is not moved is lit as if it were.
MeshData preparedMesh(const Settings& s, bool isMoved) {
    const MeshData smooth = cutPatches(s.body, s.level);
    MeshData made = displaced({s.body, s.depth}, smooth);
    if (!isMoved) made.positions = smooth.positions;
    return made;
}

// One program for each kind: with or without tessellation, with or without lines.
const Program& programOf(Gpu& gpu, const Settings& s, const Frame& frame) {
    static const std::array<std::vector<std::string>, 4> files{
        {{"displacement.vert", "displacement.frag"},
         {"displacement.vert", "lines.geom", "lines.frag"},
         {"patch.vert", "patch.tesc", "patch.tese", "displacement.frag"},
         {"patch.vert", "patch.tesc", "patch.tese", "lines.geom", "lines.frag"}}};
    return gpu.programs.of(files.at(2 * std::size_t(isTessellated(s)) + std::size_t(hasLines(s, frame))));
}

void setLight(const Program& program, const Settings& s, const Frame& frame) {
    const Scene scene = sceneOf(s, frame);
    program.set("clipFromBody", scene.clipFromWorld());
    program.set("light", vec3(scene.lights.front().position));
    program.set("view", towardsEye(s));
    if (hasLines(s, frame)) program.set("halfPicture", 0.5 * vec2(frame.width(), frame.height()));
    program.set("showsLevels", s.paint == Paint::levels);
    program.set("levelColors", levelColors());
}

// Bind the height map with its paint.
void bindMap(Gpu& gpu, const Settings& s) {
    const Texture& painted = gpu.painted.of({s.body, s.mapSize}, [&] {
        Texture map(mipmaps(paintedMap(s.body, s.mapSize)), {.texels = filteredFloats(), .label = "painted"});
        map.filterBy({.minify = GL_LINEAR_MIPMAP_LINEAR, .magnify = GL_LINEAR, .wrap = GL_REPEAT});
        if (s.body == ReliefBody::orange) glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
        return map;
    });
    painted.bind(0);
}

bool isTessellated(const Settings& s) { return s.method != Method::prepared && s.hasTessellator; }
bool isByDistance(const Settings& s) { return s.method != Method::prepared && s.levels == Levels::distance; }
bool hasLines(const Settings& s, const Frame& frame) { return s.wireframe && !frame.measuring(); }

}  // namespace mv::displacement

// The scene of shadow-volume, and the drawing over it: volumes as glass, or the stencil buffer in colours.
#include <cmath>
#include <glm/matrix.hpp>
#include <string>

#include "mv/demo/seen.h"
#include "mv/gl/text.h"
#include "mv/math/transform.h"
#include "shadow-volume.h"
#include "shared/scenes.h"
#include "shared/wide_lines.h"

namespace mv::shadow_volume {

static Scene lit(const Settings& s, double aspect) {
    if (s.scene == Which::cube) return cubeOnPlane(aspect);
    return s.scene == Which::stillLife ? stillLife(aspect) : nestedShells(aspect, s.shells);
}

// From inside a shadow, looking out of it.
static mat4 viewFromVolume(Which scene) {
    if (scene == Which::stillLife) return lookAt({2.6, 0.3, -1.2}, {1.2, 0.3, 1.0}, {0, 1, 0});
    return lookAt({0.8, 0.15, -0.5}, {0.6, 0.2, 1.5}, {0, 1, 0});
}

Scene sceneOf(const Settings& s, const FrameInfo& frame) {
    Scene scene = lit(s, frame.aspect());
    vec4& light = scene.lights[0].position;
    light = rotateY(s.lightTurn) * scale(1, s.lightHeight, 1) * light;
    if (s.atInfinity) light.w = 0;
    // Leave the far plane out, unless one is to cut the volumes off
    scene.clipFromView = withDepths(scene.clipFromView, 0.1, s.far == 0 ? HUGE_VAL : s.far);
    scene.viewFromWorld =
        s.eye == Eye::outside ? seenFrom(s.orbit, scene.viewFromWorld) : turnOf(s.orbit) * viewFromVolume(s.scene);
    return scene;
}

// Draws the sides of the volumes as glass: yellow where a way from the eye enters, blue where it leaves.
static void drawGlass(Gpu& gpu, const Settings& s, const Scene& scene) {
    glDisable(GL_STENCIL_TEST);
    glDepthFunc(GL_LESS);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glEnable(GL_CULL_FACE);
    gpu.volumeProgram.use();
    for (const bool front : {false, true}) {
        const vec4 color = front ? vec4(1, 0.72, 0.1, 0.2) : vec4(0.2, 0.4, 1, 0.2);
        glCullFace(front ? GL_BACK : GL_FRONT);
        if (findsByShader(s)) {
            drawSidesByShader(gpu, s, scene, 0, gpu.volumes.casters().size(), color);
            continue;
        }
        gpu.volumeProgram.set("color", color);
        for (const Caster& caster : gpu.volumes.casters()) drawVolume(gpu, scene, caster, caster.volume.sides);
    }
}

static std::vector<Mesh> silhouettesOf(const CasterVolumes& volumes, const Scene& scene) {
    std::vector<Mesh> meshes;
    for (const Caster& caster : volumes.casters()) {
        const SceneObject& object = scene.objects[caster.object];
        MeshData lines;
        lines.primitive = Primitive::lines;
        const vec4 light = glm::inverse(object.worldFromObject) * scene.lights[0].position;
        for (const auto& edge : silhouette(caster.closed, light)) {
            for (const auto vertex : edge.vertex) lines.positions.push_back(caster.closed.positions()[vertex]);
        }
        meshes.emplace_back(lines, object.name + " silhouette");
    }
    return meshes;
}

static void drawSilhouettes(Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame) {
    if (gpu.silhouettesFor.changed(s.scene, s.shells, scene.lights[0].position))
        gpu.silhouettes = silhouettesOf(gpu.volumes, scene);
    gpu.volumeProgram.use();
    gpu.volumeProgram.set("color", vec4(0.05, 0.05, 0.05, 1));  // told from all else by its darkness alone
    for (std::size_t i = 0; i < gpu.silhouettes.size(); ++i) {
        // A silhouette lies in its solid's faces: draw it a little nearer
        const SceneObject& object = scene.objects[gpu.volumes.casters()[i].object];
        gpu.volumeProgram.set("clipFromObject",
                              translate(0, 0, -5e-5) * (scene.clipFromWorld() * object.worldFromObject));
        drawWide(frame, [&] { gpu.silhouettes[i].draw(); });
    }
}

// The binary digits of a count as a colour: 1 is blue, 2 green, 4 red; 8, 16, 32 the same, darker.
static vec3 colorOf(int count) {
    vec3 color(0);
    for (int bit = 0; bit < 8; ++bit) {
        if (count >> bit & 1) color[2 - bit % 3] += 0.4 / (1 << (bit / 3));
    }
    return color;
}

// Adds the count's colours to the darkened picture.
static void drawCount(Gpu& gpu, const Frame& frame) {
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_FALSE);
    glEnable(GL_BLEND);
    glStencilFunc(GL_ALWAYS, 0, ~0U);
    glBlendFunc(GL_ZERO, GL_SRC_COLOR);
    drawEverywhere(gpu, vec4(0.3));
    glBlendFunc(GL_ONE, GL_ONE);
    for (int bit = 0; bit < 8; ++bit) {
        glStencilFunc(GL_EQUAL, 1 << bit, 1U << bit);
        drawEverywhere(gpu, vec4(colorOf(1 << bit), 1));
    }
    glDisable(GL_STENCIL_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    std::vector<TextLine> legend;
    for (int count = 1; count < 8; ++count) {
        const vec4 color(0.15 + 1.5 * colorOf(count), 1);
        legend.push_back({20 * count - 12, 8, std::to_string(count), {.color = vec4(1), .background = color}});
    }
    legend.push_back({20 * 8 - 12, 8, "volumes that a point is in"});
    drawText(frame, legend);
}

// Names the colours, from the lower edge up; each on a line of its own where the picture is too narrow for two.
static void nameColors(const Frame& frame) {
    std::vector<std::string> names{"black: the silhouettes that the light sees",
                                   "yellow: the way from the eye goes in, blue: out again"};
    if (textWidth(names[1]) + 16 > frame.width()) {
        names[1] = "blue: out again";
        names.emplace_back("yellow: the way from the eye goes in");
    }
    std::vector<TextLine> lines;
    for (const std::string& name : names) {
        const int up = static_cast<int>(lines.size()) + 1;
        lines.push_back({8, frame.height() - up * (textHeight() + 2) - 4, name});
    }
    drawText(frame, lines);
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    if (s.show == Show::count) drawCount(gpu, frame);
    if (s.show != Show::volumes) return;
    const Scene scene = seen(sceneOf(s, frame), frame);
    drawGlass(gpu, s, scene);
    drawSilhouettes(gpu, s, scene, frame);
    nameColors(frame);
}

// The edges that are drawn out, and the triangles that are counted. The geometry shader does not tell its own.
static std::pair<std::size_t, std::size_t> edgesAndTriangles(const Gpu& gpu, const Settings& s, const Scene& scene) {
    std::size_t edges = 0, triangles = 0;
    for (const Caster& caster : gpu.volumes.casters()) {
        if (isByShader(s)) {
            const vec4& light = scene.lights[0].position;
            const auto found =
                silhouette(caster.closed, glm::inverse(scene.objects[caster.object].worldFromObject) * light).size();
            edges += found;
            triangles += light.w == 0 ? found : 2 * found;
        } else {
            edges += caster.volume.edges;
            triangles += countedIndices(s, caster) / 3;
        }
    }
    return {edges, triangles};
}

void tell(const Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame) {
    frame.show("viewFromWorld", scene.viewFromWorld);
    frame.show("clipFromView", scene.clipFromView);
    if (!isByShader(s)) frame.count("volume triangles", double(edgesAndTriangles(gpu, s, scene).second));
    const std::size_t casters = gpu.volumes.casters().size();
    const int around = volumesRoundEye(gpu, scene, 0, casters);
    if (s.method == Method::zPass && around > 0) {
        frame.say("The eye is in " + std::to_string(around) + (around == 1 ? " volume" : " volumes") +
                  ", and z-pass counts from 0: the shadows are wrong.");
    }
    if (casters > mostInOneCount && !needsGroups(s, casters)) {
        frame.say(std::to_string(casters) +
                  " volumes may lie over one another; eight bits count 256 of them as 0, which reads as lit.");
    }
}

void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers) {
    const auto [edges, triangles] = edgesAndTriangles(gpu, s, seen(sceneOf(s, frame), frame));
    numbers.set("extruded-edges", double(edges));
    numbers.set("volume-triangles", double(triangles));
}

}  // namespace mv::shadow_volume

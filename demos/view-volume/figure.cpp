// The edges of the view volume and of the cube in view-volume, and words for them.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/matrix.hpp>
#include <string>

#include "mv/gl/functions.h"
#include "mv/math/transform.h"
#include "view-volume.h"

namespace mv::view_volume {

static const vec4 sightColor(0.55, 0.1, 0.6, 1);

// Corner i of the canonical cube is at 1 where bits 0, 1, 2 of i say so of x, y, z.
static vec3 cubeCorner(unsigned i) { return 2.0 * vec3(i & 1U, i >> 1 & 1U, i >> 2 & 1U) - 1.0; }

// Draw the edges of the canonical cube, or those of the volume that it is made of: of all corners, or of the near four.
static void drawEdges(Drawing& drawing, const mat4& paneFromClip, unsigned corners = 8) {
    for (const unsigned bit : {4U, 1U, 2U}) {
        for (unsigned i = 0; i < corners; ++i) {
            if ((i & bit) != 0) continue;
            const vec4 color = bit == 4 ? vec4(0.2, 0.2, 0.2, 1) : (i & 4U) != 0 ? farColor : nearColor;
            drawing.edge(paneFromClip, cubeCorner(i), cubeCorner(i | bit), {.color = color});
        }
    }
}

// Mark the middles of the near and the far plane, which are dragged, and draw lines from the eye to the near plane's corners.
static void drawSight(Drawing& drawing, const Settings& s, const mat4& outsideFromCamera) {
    drawing.point(outsideFromCamera, {0, 0, -s.nearUsed()}, 7, nearColor);
    drawing.point(outsideFromCamera, {0, 0, -s.far}, 7, farColor);
    if (s.projection == Projection::orthographic) return;
    const double top = s.nearUsed() * std::tan(radians(fovy / 2));
    for (unsigned i = 0; i < 4; ++i)
        drawing.edge(outsideFromCamera, vec3(0), vec3(vec2(cubeCorner(i)) * vec2(top * aspect, top), -s.nearUsed()),
                     {.color = vec4(0.6, 0.6, 0.6, 1), .width = 1});
    drawing.point(outsideFromCamera, vec3(0), 7, vec4(0.3, 0.3, 0.3, 1));
    drawing.text(outsideFromCamera, vec3(0), {-6, -4}, "eye", {.background = vec4(0)});
}

// Lines of sight through the volume, from near to far, through nine places of the near plane.
std::vector<std::array<vec3, 2>> sightLines(const Settings& s) {
    const vec3 nearCorner = vec3(aspect, 1, 0) * std::tan(radians(fovy / 2)) * s.nearUsed();
    const double grown = s.far / s.nearUsed();
    const bool isParallel = s.projection == Projection::orthographic;
    std::vector<std::array<vec3, 2>> lines;
    for (const double x : {-0.6, 0.0, 0.6}) {
        for (const double y : {-0.6, 0.0, 0.6}) {
            const vec2 from = vec2(x, y) * (isParallel ? boxHalf() * vec2(aspect, 1) : vec2(nearCorner));
            lines.push_back({vec3(from, -s.nearUsed()), vec3((isParallel ? 1 : grown) * from, -s.far)});
        }
    }
    return lines;
}
static void drawSightLines(Drawing& drawing, const Settings& s, const mat4& paneFromCamera) {
    for (const auto& [begin, end] : sightLines(s)) {
        drawing.edge(paneFromCamera, begin, end, {.color = sightColor, .width = 1.5});
        drawing.point(paneFromCamera, begin, 5, sightColor);
    }
}

// Name what the right pane shows.
static void nameStage(Drawing& drawing, const Settings& s, const Pane& pane) {
    const std::array titles{"after projection and division",
                            s.projection == Projection::perspective ? "sides at 45 degrees" : "sides at -1 and 1",
                            "onto a plane"};
    drawing.text({6, pane.height - 6}, titles.at(std::size_t(s.stage)), {.height = 18});
    if (s.stage != Stage::cube) return;
    drawing.text({6, 30}, "near: z = -1", {.color = nearColor});
    drawing.text({110, 30}, "far: z = 1", {.color = farColor});
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    const SixPlanes planes = cameraPlanes(s);
    if (std::count(planes.begin(), planes.end(), vec4(0)) > 0)
        frame.say("A plane's normal has cancelled to 0 in float: that plane culls nothing.");

    const std::vector<Pane> panes = panesOf(frame);
    const mat4 outside = outsideFromWorld(s, panes[0]);
    const std::size_t drawn = keptOf(gpu, s).things.size();
    glDisable(GL_SCISSOR_TEST);
    const FrameInfo inPixels = frame.inPixels();
    glViewport(0, 0, inPixels.width(), inPixels.height());
    Drawing& drawing = gpu.drawing;
    drawing.begin(frame);
    drawing.in(panes[0]);
    drawEdges(drawing, outside * glm::inverse(clipFromCamera(s) * cameraFromWorld(s)));
    drawSight(drawing, s, outside * glm::inverse(cameraFromWorld(s)));
    drawing.text({6, panes[0].height - 6}, "world", {.height = 18});
    drawing.text({6, 30}, std::to_string(drawn) + " drawn, " + std::to_string(gpu.things.size() - drawn) + " culled");
    if (s.sight) drawSightLines(drawing, s, outside * glm::inverse(cameraFromWorld(s)));
    drawing.in(panes[1]);
    const mat4 rightFromCamera = paneFromStage(s, panes[1]) * stageFromCamera(s);
    if (s.stage == Stage::cube)
        drawEdges(drawing, paneFromStage(s, panes[1]));
    else
        drawEdges(drawing, rightFromCamera * glm::inverse(clipFromCamera(s)), s.stage == Stage::plane ? 4 : 8);
    if (s.stage == Stage::sides) drawSight(drawing, s, rightFromCamera);
    nameStage(drawing, s, panes[1]);
    if (s.sight) drawSightLines(drawing, s, rightFromCamera);
    drawing.draw(frame);
}

}  // namespace mv::view_volume

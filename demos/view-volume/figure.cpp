// The edges of the view volume and of the cube in view-volume, and words for them.
#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <string>

#include "mv/gl/functions.h"
#include "mv/math/transform.h"
#include "view-volume.h"

namespace mv::view_volume {

// Corner i of the canonical cube is at 1 where bits 0, 1, 2 of i say so of x, y, z.
static vec3 cubeCorner(unsigned i) { return 2.0 * vec3(i & 1U, i >> 1 & 1U, i >> 2 & 1U) - 1.0; }

// Draw the edges of the canonical cube, or those of the volume that it is made of.
static void drawEdges(Drawing& drawing, const mat4& paneFromClip) {
    for (const unsigned bit : {4U, 1U, 2U}) {
        for (unsigned i = 0; i < 8; ++i) {
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

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    if (std::ranges::count(cameraPlanes(s), vec4(0)) > 0)
        frame.say("A plane's normal has cancelled to 0 in float: that plane culls nothing.");

    const std::vector<Pane> panes = frame.panes(2);
    const mat4 outside = outsideFromWorld(s, panes[0]);
    const std::size_t drawn = keptOf(gpu, s).things.size();
    glDisable(GL_SCISSOR_TEST);
    glViewport(0, 0, frame.width(), frame.height());
    Drawing& drawing = gpu.drawing;
    drawing.begin(frame);
    drawing.in(panes[0]);
    drawEdges(drawing, outside * glm::inverse(clipFromCamera(s) * cameraFromWorld(s)));
    drawSight(drawing, s, outside * glm::inverse(cameraFromWorld(s)));
    drawing.text({6, panes[0].height - 6}, "world", {.height = 18});
    drawing.text({6, 30}, std::to_string(drawn) + " drawn, " + std::to_string(gpu.things.size() - drawn) + " culled");
    drawing.in(panes[1]);
    drawEdges(drawing, cubeFromClip(s, panes[1]));
    drawing.text({6, panes[1].height - 6}, "after projection and division", {.height = 18});
    drawing.text({6, 30}, "near: z = -1", {.color = nearColor});
    drawing.text({110, 30}, "far: z = 1", {.color = farColor});
    drawing.draw(frame);
}

}  // namespace mv::view_volume

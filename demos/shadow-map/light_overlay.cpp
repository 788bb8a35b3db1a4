#include "shadow-map/light_overlay.h"

#include <algorithm>
#include <cmath>
#include <glm/matrix.hpp>
#include <string>

#include "mv/geometry/shapes.h"
#include "mv/gl/gl.h"
#include "mv/gl/state.h"
#include "mv/gl/text.h"
#include "mv/math/transform.h"
#include "shared/wide_lines.h"

namespace mv {
namespace {

const char* const lineVertex = R"(uniform mat4 clipFromModel;
in vec4 position;
void main() { gl_Position = clipFromModel * position; }
)";
const char* const lineFragment = R"(uniform vec3 color;
out vec4 fragColor;
void main() { fragColor = vec4(color, 1); }
)";
const char* const cornerVertex = R"(uniform vec4 corner;  // clip coordinates of the lower left end, width and height
in vec4 position;
out vec2 uv;
void main() {
    uv = vec2(0.5 + position.x, 0.5 - position.z);
    gl_Position = vec4(corner.xy + corner.zw * uv, 0, 1);
}
)";
// The depth itself would be white nearly everywhere: a perspective gives most of 0..1 to near things.
const char* const cornerFragment = R"(uniform sampler2D map;
uniform float near;
uniform float far;
uniform bool atInfinity;
in vec2 uv;
out vec4 fragColor;
void main() {
    float depth = texture(map, uv).r;
    float distance = atInfinity ? mix(near, far, depth) : near * far / mix(far, near, depth);
    fragColor = vec4(vec3((distance - near) / (far - near)), 1);
}
)";

}  // namespace

void LightOverlay::init() {
    lines_ = Program::fromText("light-overlay.lines", lineVertex, lineFragment);
    corner_ = Program::fromText("light-overlay.corner", cornerVertex, cornerFragment);
    edges_ = Mesh(wireCube(), "light's frustum");
    square_ = Mesh(positionsOnly(square()), "map in the corner");
}

void LightOverlay::drawFrustum(const FrameInfo& frame, const mat4& clipFromWorld, const LightView& light) {
    lines_.use();
    lines_.set("color", vec3(1, 1, 1));
    // The edges of clip space's cube -1..1, taken back through the light's projection
    lines_.set("clipFromModel", clipFromWorld * glm::inverse(light.clipFromWorld()) * scale(2));
    drawWide(frame, [&] { edges_.draw(); });
    if (light.atInfinity) return;
    lines_.set("color", vec3(1, 0.8, 0.2));
    lines_.set("clipFromModel", clipFromWorld * glm::inverse(light.viewFromWorld) * scale(0.08));
    ball_->draw();
}

void LightOverlay::drawMap(const FrameInfo& frame, const DepthMap& map, const LightView& light) const {
    const FrustumBounds& bounds = light.bounds;
    const double aspect = std::abs((bounds.right - bounds.left) / (bounds.top - bounds.bottom));
    const double most = 0.3 * std::min(frame.width(), frame.height());
    const double width = std::min(most, most * aspect), height = width / aspect;
    TextStyle style;
    style.height = 14;
    const std::string size = std::to_string(map.size());
    drawText(frame, 0, frame.height() - int(std::lround(height)) - textHeight(style), "map " + size + " x " + size,
             style);
    const StateScope scope;
    switchOff(GL_DEPTH_TEST);
    switchOff(GL_CULL_FACE);
    corner_.use();
    corner_.set("map", 0);
    map.bind(0, DepthLookup::depth);
    corner_.set("corner", vec4(-1, -1, 2 * width / frame.width(), 2 * height / frame.height()));
    corner_.set("near", bounds.near);
    corner_.set("far", bounds.far);
    corner_.set("atInfinity", light.atInfinity);
    square_.draw();
}

}  // namespace mv

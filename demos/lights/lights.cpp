// lights: ambient, directional, point and spot, up to eight of them, on surfaces that only scatter.
#include "lights.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "mv/gl/gl.h"
#include "mv/math/color.h"
#include "mv/math/transform.h"
#include "shared/lamp_reach.h"

namespace mv::lights {

void draw(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Scene scene = sceneOf(s, frame);
    const std::vector<std::size_t> sent = sentLights(s, scene);
    const Pane pane = drawnPane(frame);
    gpu.meshes.follow(scene);
    glViewport(pane.x, pane.y, pane.width, pane.height);
    glEnable(GL_DEPTH_TEST);

    // Draw the scene once. The shader adds up the lights for each pixel
    gpu.program.use();
    setLights(gpu.program, s, sent);
    for (const auto& [object, mesh] : gpu.meshes.of(scene)) {
        gpu.program.set("clipFromObject", scene.clipFromWorld() * object.worldFromObject);
        gpu.program.set("worldFromObject", object.worldFromObject);
        gpu.program.set("worldFromNormal", normalMatrix(object.worldFromObject));
        const vec3 color = tinted(s.surfaceColor, object.color);
        gpu.program.set("color", s.encode ? linearFromSrgb(color) : color);
        mesh.draw();
    }
    glViewport(0, 0, frame.width(), frame.height());
    tell(s, scene, sent, frame);
}

// Leave out lights that are off or reach nothing. Ambient lights are sent separately, as one sum.
std::vector<std::size_t> sentLights(const Settings& s, const Scene& scene) {
    std::vector<std::size_t> sent;
    for (std::size_t i = 0; i < lightCount; ++i) {
        if (s.kinds[i] != Kind::ambient && (s.ask == Ask::all || reaches(s, scene, i))) sent.push_back(i);
    }
    return sent;
}
bool reaches(const Settings& s, const Scene& scene, std::size_t light) {
    const bool isEndless = !isLamp(s.kinds[light]) || std::isinf(reach(s));
    return hasPlace(s.kinds[light]) &&
           (isEndless || canReach(scene, scene.clipFromWorld(), placeOf(s, light), reach(s)));
}

// The shader knows directional lights (0), points (1) and spots (2). A lamp that is off is a point without power.
static int shaderKind(Kind kind) {
    constexpr std::array kinds{1, 1, 0, 1, 2};  // in the order of Kind; an ambient light is never sent
    return kinds.at(std::size_t(kind));
}

// Set the uniforms of a light, at its place in the shader's array.
static void setLight(const Program& program, const Settings& s, std::size_t light, std::size_t place) {
    const auto element = [&](const char* name) { return name + ("[" + std::to_string(place) + "]"); };
    const Kind kind = s.kinds[light];
    program.set(element("kind").c_str(), shaderKind(kind));
    program.set(element("power").c_str(), strength(s, light));
    program.set(element("place").c_str(), kind == Kind::directional ? towardsSun(s, light) : placeOf(s, light));
    if (kind == Kind::spot) program.set(element("axis").c_str(), axisOf(s, light));
}
void setLights(const Program& program, const Settings& s, const std::vector<std::size_t>& sent) {
    program.set("ambient", ambient(s));
    program.set("falloff", vec3(s.constant, s.linear, s.quadratic));
    program.set("size", s.size);
    program.set("reach", std::min(reach(s), 1e30));  // farther than anything, where nothing is cut off
    program.set("encode", s.encode);
    program.set("innerCosine", std::cos(radians(s.inner)));
    program.set("outerCosine", std::cos(radians(s.outer)));
    for (std::size_t i = 0; i < sent.size(); ++i) setLight(program, s, sent[i], i);
    program.set("count", static_cast<int>(sent.size()));
}

// A lamp gives its power at 1 m. Ambient and directional lights give the same everywhere.
vec3 strength(const Settings& s, std::size_t light) {
    const std::array<double, 5> powers{0, 0.06, 0.25, s.power, s.power};  // in the order of Kind
    return powers.at(static_cast<std::size_t>(s.kinds[light])) * tinted(s.lightColor, hues.at(light));
}
// A surface reflects the part of each colour that it has: red light on green paper is black.
vec3 tinted(Tint tint, const vec3& own) {
    const std::array<vec3, 5> colors{own, vec3(1), vec3(1, 0, 0), vec3(0, 1, 0), vec3(0, 0, 1)};
    return colors.at(static_cast<std::size_t>(tint));
}
vec3 ambient(const Settings& s) {
    vec3 sum(0);
    for (std::size_t i = 0; i < lightCount; ++i) {
        if (s.kinds[i] == Kind::ambient) sum += strength(s, i);
    }
    return sum;
}
Falloff falloff(const Settings& s) { return {s.constant, s.linear, s.quadratic, s.size}; }
double reach(const Settings& s) { return falloff(s).reach(s.power, s.cutOff); }

vec3 placeOf(const Settings& s, std::size_t light) { return {s.places.at(light).x, s.height, s.places.at(light).y}; }
// A directional light shines to this point below the middle of the scene.
vec3 towardsSun(const Settings& s, std::size_t light) {
    return glm::normalize(placeOf(s, light) - vec3(0.35, -1, -0.4));
}
vec3 axisOf(const Settings& s, std::size_t light) { return glm::normalize(aim(s) - placeOf(s, light)); }

}  // namespace mv::lights

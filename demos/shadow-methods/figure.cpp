// The scenes of shadow-methods, the difference of two methods, and the words in the picture.
#include <cmath>
#include <functional>
#include <glm/matrix.hpp>
#include <string>

#include "mv/geometry/shapes.h"
#include "mv/gl/gl.h"
#include "mv/gl/text.h"
#include "mv/math/transform.h"
#include "shadow-methods.h"
#include "shared/scenes.h"

namespace mv::shadow_methods {

// Two pairs of balls under the sun, alike but for their place. The first of each pair lies on the floor, the second is
// lifted towards the eye and made smaller, by one factor, so that its picture stays the same.
static Scene balls(double aspect, double height) {
    constexpr double radius = 0.35, sides[] = {-1.75, -0.75, 0.75, 1.75};
    static const MeshData ball = sphere(1, 64, 32);
    Scene scene = floorAlone(aspect);
    scene.lights[0].position = vec4(-0.25, 1, 0.1, 0);
    const vec3 eye(glm::inverse(scene.viewFromWorld)[3]);
    for (int i = 0; i < 4; ++i) {
        const double nearer =
            i % 2 == 0 ? 1 : 1 - height / eye.y;  // of the distance, so that the ball's foot rises by height
        const vec3 middle = eye + nearer * (vec3(eye.x + sides[i], radius, 0) - eye);
        scene.objects.push_back(
            {"ball " + std::to_string(i + 1), ball, translate(middle) * scale(nearer * radius), {0.95, 0.55, 0.20}});
    }
    return scene;
}

static Scene lit(const Settings& s, double aspect) {
    if (s.scene == Which::cube) return cubeOnPlane(aspect);
    return s.scene == Which::stillLife ? stillLife(aspect) : balls(aspect, s.ballHeight);
}

// Without a far plane, which would cut the volumes off.
Scene sceneOf(const Settings& s, const FrameInfo& frame) {
    Scene scene = lit(s, frame.aspect());
    scene.viewFromWorld = seenFrom(s.orbit, scene.viewFromWorld);
    scene.clipFromView = withDepths(scene.clipFromView, 0.1, HUGE_VAL);
    return scene;
}

// Draws where the lit fractions by the two methods differ, or those by one and by rays.
void drawDifference(Gpu& gpu, const Settings& s, const Scene& scene, const Frame& frame) {
    const auto lit = [&](Method by) { return [&gpu, &scene, by] { drawScene(gpu, scene, by); }; };
    const std::function<void()> byRays = {};
    gpu.found = gpu.difference.show(scene, frame, lit(s.method), s.against == Against::off ? byRays : lit(secondOf(s)));
}

static void drawNames(const Settings& s, const Frame& frame, const std::string& first, const std::string& second) {
    const int middle = middleOf(s, frame);
    std::vector<TextLine> names;
    if (middle > 0) names.push_back({middle - 8 - textWidth(first), 8, first});
    if (middle < frame.width()) names.push_back({middle + 8, 8, second});
    drawText(frame, names);
}

void drawFigure(Gpu&, const Settings& s, const Frame& frame) {
    const bool isAlone = s.against == Against::off;
    if (!isAlone) glDisable(GL_SCISSOR_TEST);
    const int looks = looksAlong(s.method) * looksAlong(s.method);
    if (usesMap(s.method)) frame.count("texels a lookup", (s.method == Method::map ? 1 : 4) * looks);
    if (s.scene == Which::stillLife && (s.method == Method::matrix || secondOf(s) == Method::matrix))
        frame.say("The matrix flattens onto floor and wall; no body has a shadow of its own or of another.");

    const std::string first = wordOf(methodWords, s.method);
    const std::string second = isAlone ? "rays" : wordOf(methodWords, secondOf(s));
    if (s.show == Show::difference)
        drawText(frame, 8, 8, first + " less " + second + ": red too dark, blue too light");
    else if (!isAlone)
        drawNames(s, frame, first, second);
}

void readOut(Gpu& gpu, const Settings&, const Frame&, Numbers& numbers) {
    if (!gpu.found) return;
    numbers.set("different", gpu.found->beyondHalf);
    numbers.set("difference-rms", gpu.found->rms);
}

}  // namespace mv::shadow_methods

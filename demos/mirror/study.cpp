// The readouts and the plan of mirror, and its study: each pixel against a ray that the mirrors turn round.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>
#include <string>
#include <vector>

#include "mirror.h"
#include "mv/demo/demo.h"
#include "mv/geometry/bounds.h"
#include "mv/geometry/check.h"
#include "mv/geometry/ray_caster.h"
#include "mv/image/picture.h"
#include "mv/math/shadow.h"

namespace mv::mirror {

static bool showsFirst(const Sight& sight) { return !sight.chains.empty() && sight.chains.front().front().which == 0; }

// Steps of a depth buffer of 24 bits from the ball's front to its back, as the eye sees them in the first mirror.
static double depthSteps(const Settings& s, const Sight& sight) {
    const View view = viewAfter(s, sight, 0, 1);
    const vec3 imagedEye(reflection(view.before) * vec4(s.eye, 1)), ball = roomOf(s).ball;
    const vec3 along = MirrorRoom::ballRadius * glm::normalize(ball - imagedEye);
    const vec4 front = view.clipFromWorld * vec4(ball - along, 1), back = view.clipFromWorld * vec4(ball + along, 1);
    return 0.5 * (back.z / back.w - front.z / front.w) * (std::exp2(24) - 1);
}

void tell(const Settings& s, const Sight& sight, const Frame& frame) {
    for (const auto& chain : sight.chains)
        frame.show("worldFromImage" + std::to_string(chain[0].which + 1), chain[0].worldFromShown);
    if (lightSide(vec4(s.eye, 1), sight.mirrors.front().plane()) <= 0)
        frame.say("The eye is not in front of the first mirror: nothing is seen in it.");
    if (!showsFirst(sight) || nearBy(s) != Near::oblique) return;
    const double steps = depthSteps(s, sight);
    if (steps < 256)
        frame.say(rounded("So near the mirror's plane the oblique near plane leaves %.0f steps of depth ", steps) +
                  "from the ball's front to its back; --near clip-distance leaves as many as ever.");
}

void readOut(Gpu& gpu, const Settings& s, const Frame& frame, Numbers& numbers) {
    const Sight sight = sightOf(s, frame);
    const Gpu::Work work = sight.chains.empty() ? Gpu::Work() : gpu.work;
    numbers.set("passes", work.passes);
    numbers.set("drawn", work.drawn);
    numbers.set("left-out", work.leftOut);
    numbers.set("eye-distance", glm::dot(sight.mirrors.front().plane(), vec4(s.eye, 1)));
    if (showsFirst(sight)) numbers.set("depth-steps", depthSteps(s, sight));
}

void drawFigure(Gpu& gpu, const Settings& s, const Frame& frame) {
    const Sight sight = sightOf(s, frame);
    gpu.drawing.begin(frame);
    drawPlan(gpu.drawing, frame, roomOf(s), sight.scene, sight.chains);
    gpu.drawing.draw(frame);
}

namespace {

using namespace mv::claims;

constexpr double wrongBeyond = 0.02;  // of an object's brightness; another object is off by 0.1 at least

// A mirror as a ray meets it: a rectangle, nothing of the matrices that draw it.
struct Rectangle {
    vec3 middle, right, up, normal;  // right and up are half its sides

    // How far along a ray meets it from the front.
    std::optional<double> meets(const Ray& ray) const {
        const double towards = glm::dot(ray.direction, normal);
        if (towards >= 0) return {};
        const double t = glm::dot(middle - ray.origin, normal) / towards;
        const vec3 at = ray.at(t) - middle;
        const bool within =
            std::abs(glm::dot(at, right)) <= glm::dot(right, right) && std::abs(glm::dot(at, up)) <= glm::dot(up, up);
        return t > 0 && within ? std::optional(t) : std::nullopt;
    }
};

std::vector<Rectangle> rectangles(const Demo& demo) {
    std::vector<Rectangle> all;
    for (const Mirror& mirror : MirrorRoom{demo.number("mirror-turn"), demo.word("mirrors") == "two"}.mirrors()) {
        all.push_back(
            {mirror.middle, mirror.halfU, mirror.halfV, glm::normalize(glm::cross(mirror.halfU, mirror.halfV))});
    }
    return all;
}

// A ray's sight, as shaders/include/seen.glsl tells it, and a number for each way: objects and bounces.
struct Sight {
    double value = -1;
    int region = -1;
};

class TracedMirrors {
  public:
    TracedMirrors(const Demo& demo, const FrameInfo& frame)
        : scene_(demo.scene(frame)),
          caster_(scene_),
          worldFromClip_(glm::inverse(scene_.clipFromWorld())),
          bounces_(static_cast<int>(demo.number("bounces"))),
          reflectance_(demo.number("reflectance")),
          mirrors_(rectangles(demo)) {
        for (const SceneObject& object : scene_.objects) triangles_.push_back(trianglesOf(object.mesh));
    }

    // x and y from -1 to 1 over the picture.
    Sight at(double x, double y) const {
        const vec4 near = worldFromClip_ * vec4(x, y, -1, 1), far = worldFromClip_ * vec4(x, y, 1, 1);
        Ray ray{vec3(near) / near.w, vec3(far) / far.w - vec3(near) / near.w};
        ray.direction = glm::normalize(ray.direction);
        double part = 1;
        for (int bounce = 0;; ++bounce) {
            const auto hit = nearestFront(ray);
            const Rectangle* mirror = nullptr;
            double first = hit ? hit->t : HUGE_VAL;
            for (const Rectangle& one : mirrors_) {
                const auto t = one.meets(ray);
                if (!t || *t >= first) continue;
                first = *t;
                mirror = &one;
            }
            if (mirror == nullptr) {
                if (!hit && bounce == 0) return {};
                if (!hit) return seen(part * sky, 0, bounce);
                return seen(part * lit(*hit), hit->object + 1, bounce);
            }
            part *= reflectance_;
            if (bounce == bounces_) return seen(part * sky, 0, bounce + 1);
            // The lecture's v - 2 n (n . v)
            ray.origin = ray.at(first);
            ray.direction -= 2 * glm::dot(mirror->normal, ray.direction) * mirror->normal;
        }
    }

  private:
    static Sight seen(const vec3& light, int object, int bounce) {
        return {object + 0.3 * (light.x + light.y + light.z), 16 * bounce + object};
    }

    // Backs are not drawn.
    std::optional<SceneHit> nearestFront(Ray ray) const {
        double passed = 0;
        for (;;) {
            auto hit = caster_.nearest(ray);
            if (!hit) return {};
            hit->t += passed;
            if (glm::dot(hit->normal, ray.direction) < 0) return hit;
            ray.origin = hit->point + 1e-9 * ray.direction;
            passed = hit->t + 1e-9;
        }
    }

    // Light the hit by the normal of the triangle's corners, as the GPU interpolates it.
    vec3 lit(const SceneHit& hit) const {
        const auto number = static_cast<std::size_t>(hit.object);
        const SceneObject& object = scene_.objects[number];
        const auto& corners = triangles_[number][static_cast<std::size_t>(hit.triangle)];
        mat3 places(1), normals(1);
        for (int i = 0; i < 3; ++i) {
            const auto corner = corners[static_cast<std::size_t>(i)];
            places[i] = vec3(object.worldFromObject * vec4(vec3(object.mesh.positions[corner]), 1));
            normals[i] = mat3(object.worldFromObject) * vec3(object.mesh.normals[corner]);
        }
        // The weights of the corners, by the areas opposite them
        const vec3 whole = glm::cross(places[1] - places[0], places[2] - places[0]);
        vec3 weights(0);
        for (int i = 0; i < 3; ++i) {
            const vec3 &b = places[(i + 1) % 3], &c = places[(i + 2) % 3];
            weights[i] = glm::dot(glm::cross(b - hit.point, c - hit.point), whole) / glm::dot(whole, whole);
        }
        const vec3 normal = glm::normalize(normals * weights);
        const vec3 towardsLight = glm::normalize(vec3(scene_.lights.front().position));
        vec3 color = object.color;
        const double tile = std::floor(hit.point.x / MirrorRoom::tile) + std::floor(hit.point.z / MirrorRoom::tile);
        if (number == 0 && tile - 2 * std::floor(tile / 2) == 1) color *= 0.6;
        return color * (0.3 + 0.7 * std::max(glm::dot(normal, towardsLight), 0.0));
    }

    Scene scene_;
    RayCaster caster_;
    mat4 worldFromClip_;
    int bounces_;
    double reflectance_;
    std::vector<Rectangle> mirrors_;
    std::vector<std::vector<std::array<std::uint32_t, 3>>> triangles_;
};

Reference traced(const Demo& demo, const ReferenceFrame& frame) {
    const TracedMirrors mirrors(demo, frame);
    Reference reference;
    for (int row = 0; row < frame.height(); ++row) {
        for (int column = 0; column < frame.width(); ++column) {
            const Sight sight =
                mirrors.at(2 * (column + 0.5) / frame.width() - 1, 1 - 2 * (row + 0.5) / frame.height());
            reference.values.push_back(sight.value);
            reference.regions.push_back(sight.region);
        }
    }
    return reference;
}

// Whether one of the eight neighbours shows something else, as a study has it.
bool isAtEdge(const Reference& reference, int column, int row, int width, int height) {
    const std::size_t here = pixelIndex(column, row, width);
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, height - 1); ++y) {
        for (int x = std::max(column - 1, 0); x <= std::min(column + 1, width - 1); ++x) {
            const std::size_t there = pixelIndex(x, y, width);
            if (reference.regions[here] != reference.regions[there] ||
                std::abs(reference.values[here] - reference.values[there]) > wrongBeyond) {
                return true;
            }
        }
    }
    return false;
}

// For each object's number, from 1: whether all of it is behind the first mirror.
std::vector<bool> behindFirst(const Demo& demo, const FrameInfo& frame) {
    const Rectangle mirror = rectangles(demo).front();
    std::vector<bool> behind{false};
    for (const SceneObject& object : demo.scene(frame).objects) {
        const auto corners = boundsOf(object.mesh, object.worldFromObject).corners();
        behind.push_back(std::all_of(corners.begin(), corners.end(), [&](const vec3& corner) {
            return glm::dot(corner - mirror.middle, mirror.normal) < 0;
        }));
    }
    return behind;
}

// The readouts of a smaller picture, off edges: the pixels that are wrong, and those that show what is behind the first mirror where no
// ray meets it.
std::vector<double> wrongPixels(Probing& probing) {
    constexpr int width = 480, height = 280;
    const std::vector<float> shown = probing.measured(width, height);
    if (shown.empty()) return {};
    const Demo& demo = probing.demo();
    const FrameInfo frame(probing.frame().index(), width, height);
    const Reference right = traced(demo, ReferenceFrame(frame));
    const auto isBehind = behindFirst(demo, frame);
    double wrong = 0, behind = 0;
    for (std::size_t i = 0; i < shown.size(); ++i) {
        if (isAtEdge(right, static_cast<int>(i) % width, static_cast<int>(i) / width, width, height)) continue;
        const auto object = static_cast<std::size_t>(std::max(shown[i], 0.0F));
        const auto rightOne = static_cast<std::size_t>(std::max(right.values[i], 0.0));
        if (isBehind.at(object) && object != rightOne) ++behind;
        if (right.regions[i] >= 0 && std::abs(double(shown[i]) - right.values[i]) > wrongBeyond) ++wrong;
    }
    return {100 * wrong / double(shown.size()), behind};
}

Study study() {
    Study study;
    study.quantity = "the number of the object that is seen, and 0.9 times its brightness, 0..1";
    study.reference = "a ray a pixel, turned round at each mirror, in double precision";
    study.makeReference = [](const Demo& demo, const ReferenceFrame& frame, const auto&) {
        return traced(demo, frame);
    };
    study.reads = {"mirrors", "bounces",    "reflectance", "mirror-turn", "eye-x",
                   "eye-z",   "eye-height", "ball-x",      "ball-z"};
    study.scenes = {{"one mirror", {}}, {"two mirrors", {{"mirrors", "two"}}}};
    study.lines = {{.method = "stencil, oblique", .settings = {{"method", "stencil"}}},
                   {.method = "stencil, clip distance", .settings = {{"method", "stencil"}, {"near", "clip-distance"}}},
                   {.method = "stencil, no near plane", .settings = {{"method", "stencil"}, {"near", "none"}}},
                   {.method = "texture",
                    .settings = {{"method", "texture"}, {"keep", "off"}},
                    .knob = "coarser",
                    .values = {"1", "2", "4", "8", "16"}},
                   {.method = "texture, kept",
                    .settings = {{"method", "texture"}},
                    .knob = "coarser",
                    .values = {"1", "2", "4", "8", "16"}}};
    study.axis = ErrorAxis::fraction;
    study.wrongBeyond = wrongBeyond;
    study.width = 960;
    study.height = 560;
    const auto textures = rows("texture", "texture, kept");
    study.says = {
        claim("right-by-rays",
              "Away from edges both methods are right in every pixel, with one mirror and with two that show each "
              "other eight "
              "times, by either near plane. At edges less than 0.01 % of the pixels are another one.",
              {zero(of::wrongAwayFromEdges, rows("stencil, oblique", "stencil, clip distance")),
               zero(of::wrongAwayFromEdges, textures.at(1)),
               atMost(of::wrong, rows("stencil, oblique", "stencil, clip distance"), 0.01),
               atMost(of::wrong, textures.at(1), 0.01)}),
        claim("from-behind",
              "Without a near plane more than 2 % of the pixels off edges show what is behind the mirror.",
              {atLeast(of::wrongAwayFromEdges, rows("stencil, no near plane"), 2)}),
        claim("texels",
              "Coarser texels are wrong at the edges in the mirror: in about twice as many pixels when they are twice "
              "as wide.",
              {slope(of::wrong, textures.from(2), 0.85, 1.15)}),
        claim("stencil-first", "The stencil takes less time than a texture as fine as the picture that is made anew.",
              {ratio(of::time, rows("stencil, oblique", "stencil, clip distance"), rows("texture").at(1), 0, 1)}),
        claim("kept", "With two mirrors a texture that is kept takes less time than one that is made anew.",
              {ratio(of::time, rows("texture, kept").in("two mirrors").at(1), rows("texture").at(1), 0, 0.9)}),
        claim(
            "same-triangles",
            "The stencil draws each mirror once more than the texture does, to reset its depths: two triangles a pass.",
            {ratio(of::count("triangles"), rows("stencil, oblique"), rows("texture").at(1), 1, 1.001)}),
        claim("two-mirrors-cost",
              "Eight bounces draw the world eight times more: at least four times the triangles of one.",
              {ratio(of::count("triangles"), rows("stencil, oblique").in("two mirrors"),
                     rows("stencil, oblique").in("one mirror"), 4, 9)}),
        note("A kept texture costs a lookup while neither the eye nor anything in the world moves. When the eye moves, "
             "it is "
             "made anew: a shadow map would not have to be.")};
    return study;
}

const bool studied = addStudy("mirror", study());
const bool probed =
    addProbes("mirror", {{{{"wrong", "pixels off edges that are not as rays show, of a picture of 480 x 280", "%"},
                           {"from-behind", "those that show what stands behind the first mirror, where rays do not"}},
                          wrongPixels}});

}  // namespace
}  // namespace mv::mirror

// The readouts of lights, and its study: the light that arrives, against lamps that are balls and light by all
// of their surface.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <map>
#include <string>
#include <vector>

#include "lights.h"
#include "mv/demo/demo.h"
#include "mv/geometry/check.h"
#include "mv/geometry/ray_caster.h"
#include "mv/math/color.h"
#include "mv/math/transform.h"

namespace mv::lights {

// The light that arrives at a point from one light. The shader computes the same in float.
vec3 arriving(const Settings& s, std::size_t light, const vec3& point, const vec3& normal) {
    const Kind kind = s.kinds[light];
    if (kind == Kind::off || kind == Kind::ambient) return strength(s, light);
    if (kind == Kind::directional) return strength(s, light) * std::max(glm::dot(normal, towardsSun(s, light)), 0.0);
    const vec3 toLamp = placeOf(s, light) - point;
    const double d = glm::length(toLamp);
    if (d > reach(s)) return vec3(0);
    const vec3 towards = toLamp / std::max(d, s.size);
    const double edge = kind == Kind::point ? 1
                                            : spotEdge(glm::dot(-towards, axisOf(s, light)), std::cos(radians(s.inner)),
                                                       std::cos(radians(s.outer)));
    return strength(s, light) * std::max(glm::dot(normal, towards), 0.0) * falloff(s).at(d) * edge;
}

double lightAtMark(const Settings& s) {
    vec3 sum(0);
    for (std::size_t i = 0; i < lightCount; ++i) sum += arriving(s, i, marked(s), {0, 1, 0});
    return (sum.x + sum.y + sum.z) / 3;
}
double stored(double light) { return 255 * std::min(1.0, srgbFromLinear(light)); }

void tell(const Settings& s, const Scene& scene, const std::vector<std::size_t>& sent, const Frame& frame) {
    for (const std::size_t i : sent) {
        if (!reaches(s, scene, i))
            frame.needless("light " + std::to_string(i + 1) +
                           (hasPlace(s.kinds[i]) ? ", which reaches nothing" : ", which is off"));
    }
    frame.count("lights asked for each pixel", double(sent.size()));
}

void readOut(Gpu&, const Settings& s, const Frame& frame, Numbers& numbers) {
    numbers.set("lights-sent", double(sentLights(s, sceneOf(s, frame)).size()));
    numbers.set("mark", lightAtMark(s));
    numbers.set("mark-stored", stored(lightAtMark(s)));
}

namespace {

using namespace mv::claims;

// The interpolated normal of what a ray has hit, as a shader gets it.
vec3 smoothNormal(const SceneObject& object, const std::array<std::uint32_t, 3>& corners, const vec3& point) {
    std::array<vec3, 3> at{};
    for (std::size_t k = 0; k < 3; ++k) {
        at.at(k) = vec3(object.worldFromObject * vec4(vec3(object.mesh.positions[corners.at(k)]), 1));
    }
    const vec3 across = glm::cross(at[1] - at[0], at[2] - at[0]);
    vec3 normal(0);
    for (std::size_t k = 0; k < 3; ++k) {
        const vec3 edge = at.at((k + 2) % 3) - at.at((k + 1) % 3);
        const double part = glm::dot(glm::cross(edge, point - at.at((k + 1) % 3)), across) / glm::dot(across, across);
        normal += part * vec3(object.mesh.normals[corners.at(k)]);
    }
    return glm::normalize(normalMatrix(object.worldFromObject) * normal);
}

// The light of a ball of that radius on a surface: the mean over side x side directions of equal solid angle towards it,
// each with the surface's cosine. A ball of power p has radiance p / (pi radius^2), and so p / d^2 far away, head on.
double lightOfBall(const vec3& toMiddle, const vec3& normal, double radius, int side) {
    const double d = glm::length(toMiddle);
    if (d <= radius) return -1;
    const double cap = 1 - std::sqrt(1 - radius * radius / (d * d));
    // The normal's parts along the way to the ball and across it: round that way the light is symmetrical
    const double along = glm::dot(normal, toMiddle) / d, across = glm::length(glm::cross(normal, toMiddle)) / d;
    std::vector<double> cosines;
    cosines.reserve(static_cast<std::size_t>(side));
    for (int k = 0; k < side; ++k) cosines.push_back(std::cos(2 * std::acos(-1.0) * (k + 0.5) / side));
    double sum = 0;
    for (int i = 0; i < side; ++i) {
        const double cosine = 1 - cap * (i + 0.5) / side, sine = std::sqrt(1 - cosine * cosine);
        for (const double turned : cosines) sum += std::max(cosine * along + sine * across * turned, 0.0);
    }
    return 2 * cap / (radius * radius) * sum / (side * side);
}

Reference byBalls(const Demo& demo, const ReferenceFrame& frame, const std::function<void(double)>& progress) {
    const Scene scene = demo.scene(frame);
    const RayCaster caster(scene);
    std::vector<std::vector<std::array<std::uint32_t, 3>>> triangles;
    for (const SceneObject& object : scene.objects) triangles.push_back(trianglesOf(object.mesh));
    const double radius = demo.number("lamp-size");
    const mat4 worldFromClip = inverse(scene.clipFromWorld());
    const auto unproject = [&](double x, double y, double z) {
        const vec4 at = worldFromClip * vec4(x, y, z, 1);
        return vec3(at) / at.w;
    };
    Reference reference;
    double change = 0, changed = 0;
    for (int row = 0; row < frame.height(); ++row) {
        if (progress) progress(double(row) / frame.height());
        for (int column = 0; column < frame.width(); ++column) {
            const double x = 2 * (column + 0.5) / frame.width() - 1, y = 1 - 2 * (row + 0.5) / frame.height();
            const vec3 eye = unproject(x, y, -1);
            const auto hit = caster.nearest({eye, unproject(x, y, 1) - eye});
            double sum = 0, finer = 0;
            bool counts = hit.has_value();
            if (counts) {
                const auto object = static_cast<std::size_t>(hit->object);
                const auto& corners = triangles[object][static_cast<std::size_t>(hit->triangle)];
                const vec3 normal = smoothNormal(scene.objects[object], corners, hit->point);
                for (const SceneLight& light : scene.lights) {
                    const double power = (light.color.x + light.color.y + light.color.z) / 3;
                    const double part = lightOfBall(vec3(light.position) - hit->point, normal, radius, 12);
                    counts = counts && part >= 0;
                    sum += power * part;
                    // Each 8th pixel of each 8th row tells enough of the error
                    if (frame.ownError && row % 8 == 0 && column % 8 == 0 && part >= 0) {
                        finer += power * (lightOfBall(vec3(light.position) - hit->point, normal, radius, 24) - part);
                    }
                    reference.work += 144;
                }
            }
            reference.values.push_back(sum);
            reference.regions.push_back(counts ? hit->object : -1);
            if (frame.ownError && row % 8 == 0 && column % 8 == 0 && counts) {
                change += finer * finer;
                ++changed;
            }
        }
    }
    if (frame.ownError && changed > 0) reference.ownError = std::sqrt(change / changed);
    return reference;
}

// The first lights are points, as many as that; the others are off.
std::vector<KnobSetting> points(int count) {
    std::vector<KnobSetting> settings;
    for (int i = 1; i <= 8; ++i) settings.push_back({"light-" + std::to_string(i), i <= count ? "point" : "off"});
    return settings;
}

std::vector<KnobSetting> fallsBy(const std::string& constant, const std::string& linear, const std::string& quadratic) {
    return {{"constant", constant}, {"linear", linear}, {"quadratic", quadratic}};
}

// The shader asks all eight lights, also those that are off.
std::vector<KnobSetting> withAll(std::vector<KnobSetting> settings) {
    settings.push_back({"ask", "all"});
    return settings;
}

Study study() {
    Study study;
    study.quantity = "light that arrives at each pixel's surface, mean of red, green and blue, linear";
    study.reference = "each lamp as a ball that shines evenly, 144 directions towards it, in double precision";
    study.makeReference = [](const Demo& demo, const ReferenceFrame& frame, const auto& progress) {
        return byBalls(demo, frame, progress);
    };
    auto one = points(1), eight = points(8);
    for (auto* settings : {&one, &eight}) settings->push_back({"power", "0.1"});
    study.reads = {"light-1", "light-2", "light-3", "light-4", "light-5",   "light-6",    "light-7",
                   "light-8", "places",  "height",  "power",   "lamp-size", "light-color"};
    study.scenes = {{"one lamp", one}, {"eight lamps", eight}};
    const std::vector<std::string> sizes{"0.02", "0.1", "0.2", "0.5"};
    study.lines = {{"1/d^2", fallsBy("0", "0", "1"), "lamp-size", sizes},
                   {"1/d", fallsBy("0", "1", "0"), "lamp-size", sizes},
                   {"constant", fallsBy("1", "0", "0"), "lamp-size", sizes},
                   {"1/d^2, all asked", withAll(fallsBy("0", "0", "1")), "lamp-size", sizes},
                   {"1/(1 + d + d^2)", fallsBy("1", "1", "1"), "lamp-size", sizes},
                   {"1/d^2, cut off",
                    fallsBy("0", "0", "1"),
                    "cut-off",
                    {"0.1", "0.03", "0.01", "0.0039215686", "0.001", "0.0001"}}};
    study.problem = "lamp-size";
    study.wrongBeyond = 1.0 / 255;
    study.width = 320;
    study.height = 240;
    const auto cut = rows("1/d^2, cut off");
    study.says = {
        claim("as-the-square",
              "With 1/d^2 a lamp of up to 10 cm is off in less than 1 % of the pixels by a step of 8 bits, and in none "
              "away "
              "from edges.",
              {atMost(of::wrong, rows("1/d^2").upTo(0.1), 1), zero(of::wrongAwayFromEdges, rows("1/d^2").upTo(0.1))}),
        claim("others-are-not",
              "Without falloff, with 1/d, or with three terms of 1, more than half of the pixels are off, whatever the "
              "lamp's size.",
              {atLeast(of::wrong, rows("1/d", "constant", "1/(1 + d + d^2)"), 50)}),
        claim("cut-off-errs",
              "A lamp that is cut off where it gives a tenth errs in more pixels than one that ends at a "
              "10 000th, by more than ten times.",
              {ratio(of::wrong, cut.at(0.1), cut.at(0.0001), 10, HUGE_VAL)}),
        claim("a-255th-is-enough",
              "Cut off where it gives a 255th, in this room a lamp errs nowhere away from edges by a step of 8 bits; "
              "at a "
              "hundredth it does in some pixels, even alone.",
              {zero(of::wrongAwayFromEdges, cut.upTo(0.004)), atLeast(of::wrongAwayFromEdges, cut.at(0.01), 1)}),
        note("A ball that shines evenly gives exactly p/d^2 to a surface that sees all of it; where a part of the ball "
             "is "
             "below the surface's horizon the point is wrong, by more the larger the ball."),
        note("Asking all eight lights, seven of them off, costs no time here that the table tells from its noise: most "
             "of a "
             "frame are its 26 000 triangles."),
        note("The eight lamps of this room reach something at nearly every cut-off: the count of lights tells when one "
             "is left out. What the loop leaves out for single pixels no count tells, and the time here hardly does.")};
    return study;
}

const bool studied = addStudy("lights", study());

}  // namespace
}  // namespace mv::lights

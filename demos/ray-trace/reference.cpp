// What the study of ray-trace compares with: many samples, every triangle, many wavelengths.
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <string>
#include <vector>

#include "mv/demo/lesson.h"
#include "ray-trace.h"
#include "values.h"

namespace mv::ray_trace {
namespace {

constexpr int manySamples = 4096;

// The subject of the picture, without its sampling; Fresnel's parts exact, the squares asked and not averaged.
TracePicture::Plan referencePlan(const Demo& demo, int columns, int rows) {
    Settings s = settingsOf<Settings>(demo);
    s.fresnel = Fresnel::exact;
    s.filtered = false;
    return planOf(s, columns, rows, {});  // of a teapot the reference asks the triangles itself
}

// A sequence of its own seed, of many samples; for each of the demo's seeds the same picture. References are kept:
// whoever tries one knob after the other asks for the same picture again and again.
Reference ofManySamples(const Demo& demo) {
    static std::map<std::string, Reference> made;
    std::string of;
    for (const char* knob : {"room", "depth", "shadows", "lamp-size", "index", "eye-turn", "eye-height", "globe-turn"})
        of += demo.word(knob) + " ";
    Reference& reference = made[of];
    if (!reference.values.empty()) return reference;
    TracePicture::Plan plan = referencePlan(demo, valueColumns, valueRows);
    plan.view.fovy = halved(plan.view.fovy);
    plan.pattern = SamplePattern::sequence;
    plan.samples = manySamples;
    plan.seed = 12345;
    const TracePicture picture = whole(plan);
    for (int seed = 0; seed < seeds; ++seed) {
        for (const vec3& light : picture.light()) reference.values.push_back(grey(light));
    }
    reference.work = double(picture.rays());
    return reference;
}

// Every triangle asked, by the textbook's form: what is beside it in the same place has the same t.
Reference everyTriangle(const Demo& demo) {
    const int cells = static_cast<int>(std::lround(std::sqrt(demo.number("triangles") / 64)));
    const std::vector<SceneTriangle> triangles = teapotTriangles(cells);
    Reference reference;
    for (const Ray& ray : raysThrough(referencePlan(demo, 40, 25))) {
        double first = 0;
        for (const SceneTriangle& in : triangles) {
            const vec3 ab = in.b - in.a, ac = in.c - in.a, across = glm::cross(ray.direction, ac);
            const double determinant = glm::dot(ab, across);
            if (determinant == 0) continue;
            const vec3 from = ray.origin - in.a, around = glm::cross(from, ab);
            const double u = glm::dot(from, across) / determinant, v = glm::dot(ray.direction, around) / determinant,
                         t = glm::dot(ac, around) / determinant;
            if (u >= 0 && v >= 0 && u + v <= 1 && t > 0 && (first == 0 || t < first)) first = t;
        }
        reference.values.push_back(first);
    }
    reference.work = double(triangles.size());
    return reference;
}

// No ray that leaves a floor upwards meets it again.
Reference noneAgain(const Demo&) {
    constexpr std::size_t rays = 100'000;
    return {.values = std::vector<double>(rays, 0), .work = double(rays)};
}

// The same rays, each traced for 256 wavelengths.
Reference ofManyWavelengths(const Demo& demo) {
    Settings s = settingsOf<Settings>(demo);
    s.fresnel = Fresnel::exact;
    TracePicture::Plan plan = planOf(s, 48, 32, {});
    plan.colors = colorsOf(s, 256);
    Reference reference;
    reference.values = colorsByOneRay(plan);
    return reference;
}

}  // namespace

Reference referenceOf(const Demo& demo) {
    if (demo.word("room") == "strips") return noneAgain(demo);
    if (demo.word("room") == "glass-ball") return ofManyWavelengths(demo);
    return demo.word("room") == "teapot" ? everyTriangle(demo) : ofManySamples(demo);
}

}  // namespace mv::ray_trace

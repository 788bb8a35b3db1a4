// The numbers that the study of ray-trace compares: greys, colours and distances of small pictures, and how much they differ by seed.
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "ray-trace.h"
#include "values.h"

namespace mv::ray_trace {

TracePicture whole(const TracePicture::Plan& plan) {
    TracePicture picture;
    picture.pass(plan, 0);
    const auto passesOf = [&](int samples) { return TracePicture::passesOf(samples, plan.width, plan.height); };
    for (int pass = passesOf(0); pass < passesOf(plan.samples); ++pass) picture.pass(plan, pass);
    return picture;
}

// Kept, so that the time of finding triangles is not that of preparing to.
static std::shared_ptr<const TriangleFinder> keptFinder(const Settings& s) {
    static MadeFor<TracedRoom, RayStructure, int> keptFor;
    static std::shared_ptr<const TriangleFinder> kept;
    if (keptFor.changed(s.room, s.structure, s.triangles)) kept = finderOf(s);
    return kept;
}

std::vector<double> colorsByOneRay(TracePicture::Plan plan) {
    plan.pattern = SamplePattern::regular;
    plan.samples = 1;
    std::vector<double> all;
    const TracePicture picture = whole(plan);
    for (const vec3& light : picture.light()) all.insert(all.end(), {light.x, light.y, light.z});
    return all;
}

// The middle of a picture of 48 x 32 pixels for each of eight seeds, as grey; of triangles the t of a thousand rays, 0 for none;
// of strips, which rays meet again what they leave; of the glass ball colours.
std::vector<double> values(const Settings& s) {
    if (s.room == TracedRoom::strips) return againOffStrips(s.triangles, s.leave);
    std::vector<double> all;
    if (s.room == TracedRoom::teapot) {
        const TracePicture::Plan plan = planOf(s, 40, 25, keptFinder(s));
        for (const Ray& ray : raysThrough(plan)) {
            const auto hit = plan.scene.mesh->nearest(ray);
            all.push_back(hit ? hit->hit.t : 0);
        }
        return all;
    }
    if (s.room == TracedRoom::glassBall) return colorsByOneRay(planOf(s, 48, 32, {}));
    for (int one = 1; one <= seeds; ++one) {
        TracePicture::Plan plan = planOf(s, valueColumns, valueRows, {});
        plan.view.fovy = halved(plan.view.fovy);
        plan.seed = static_cast<std::uint32_t>(100 * s.seed + one);
        const TracePicture picture = whole(plan);
        for (const vec3& light : picture.light()) all.push_back(grey(light));
    }
    return all;
}

// The spread of the seeds' mean squares, each taken from the mean of all seeds' pictures.
std::vector<std::pair<std::string, double>> valueCounts(const Settings& s) {
    if (s.room == TracedRoom::teapot || s.room == TracedRoom::strips || s.room == TracedRoom::glassBall) return {};
    const std::vector<double> greys = values(s);
    constexpr std::size_t pixels = std::size_t{valueColumns} * valueRows;
    std::vector<double> mean(pixels, 0), squares(seeds, 0);
    for (std::size_t i = 0; i < greys.size(); ++i) mean[i % pixels] += greys[i] / seeds;
    for (std::size_t i = 0; i < greys.size(); ++i)
        squares[i / pixels] += (greys[i] - mean[i % pixels]) * (greys[i] - mean[i % pixels]);
    double sum = 0, deviation = 0;
    for (const double one : squares) sum += one / seeds;
    for (const double one : squares) deviation += (one - sum) * (one - sum) / (seeds - 1);
    return {{"deviation of the seeds (%)", sum > 0 ? 100 * std::sqrt(deviation) / sum : 0}};
}

}  // namespace mv::ray_trace

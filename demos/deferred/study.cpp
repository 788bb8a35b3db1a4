// The study of deferred: the sum of light in each pixel against rays, and what each way takes.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "deferred.h"
#include "mv/demo/lesson.h"
#include "mv/geometry/ray_caster.h"

using namespace mv::claims;

namespace mv::deferred {
namespace {

// The light of all lamps on a surface, and what is everywhere. The shaders compute it in float (shaders/include/small_lamps.glsl).
vec3 lightAt(const Lamps& lamps, double reach, const vec3& point, const vec3& normal) {
    vec3 sum(ambient);
    for (std::size_t i = 0; i < static_cast<std::size_t>(lamps.count); ++i) {
        const vec3 toLamp = lamps.place[i] - point;
        const double d = std::max(glm::length(toLamp), 0.05), window = std::max(1 - d * d / (reach * reach), 0.0);
        sum += lamps.power[i] * (std::max(glm::dot(normal, toLamp) / d, 0.0) * window * window / (d * d));
    }
    return sum;
}

// Of the floor its own normal, of a ball the way from its middle: interpolated over a face, places and normals of a ball's mesh stay
// in one line.
vec3 normalAt(const Scene& scene, const SceneHit& hit) {
    const SceneObject& object = scene.objects.at(static_cast<std::size_t>(hit.object));
    return object.name == "floor" ? vec3(0, 1, 0) : glm::normalize(hit.point - vec3(object.worldFromObject[3]));
}

Reference byRays(const Demo& demo, const ReferenceFrame& frame, const std::function<void(double)>& progress) {
    const Settings s = settingsOf<Settings>(demo);
    const Scene scene = demo.scene(frame);
    const Lamps lamps = lampsOf(s);
    const RayCaster caster(scene);
    const mat4 worldFromClip = glm::inverse(scene.clipFromWorld());
    const auto unproject = [&](double x, double y, double z) {
        const vec4 at = worldFromClip * vec4(x, y, z, 1);
        return vec3(at) / at.w;
    };
    Reference reference;
    for (int row = 0; row < frame.height(); ++row) {
        if (progress) progress(double(row) / frame.height());
        for (int column = 0; column < frame.width(); ++column) {
            const double x = 2 * (column + 0.5) / frame.width() - 1, y = 1 - 2 * (row + 0.5) / frame.height();
            const vec3 from = unproject(x, y, -1);
            const auto hit = caster.nearest({from, unproject(x, y, 1) - from});
            reference.regions.push_back(hit ? hit->object : -1);
            if (!hit) {
                reference.values.push_back(0);
                continue;
            }
            const vec3 sum = scene.objects[static_cast<std::size_t>(hit->object)].color *
                             lightAt(lamps, s.reach, hit->point, normalAt(scene, *hit));
            reference.values.push_back((sum.x + sum.y + sum.z) / 3);
            reference.work += s.lamps;
        }
    }
    return reference;
}

// The part of what is seen that has got more light than a picture shows.
std::vector<double> beyondOne(Probing& probing) {
    const std::vector<float> sums = probing.measured(probing.frame().width(), probing.frame().height());
    const auto seen = std::count_if(sums.begin(), sums.end(), [](float sum) { return sum >= 0; });
    if (seen == 0) return {};
    return {100.0 * double(std::count_if(sums.begin(), sums.end(), [](float sum) { return sum > 1; })) / double(seen)};
}

Study study() {
    Study study;
    study.quantity = "light times colour in each pixel, mean of red, green and blue, as it is summed up";
    study.reference = "one ray through each pixel, and all lamps there, in double precision";
    study.makeReference = byRays;
    study.reads = {"lamps", "power", "reach", "spin-x", "spin-y", "distance"};
    study.scenes = {{"far reach", {{"reach", "3"}, {"power", "0.5"}}},
                    {"short reach", {{"reach", "1.2"}, {"power", "1"}}}};
    const std::vector<std::string> lamps{"1", "8", "32", "96"};
    const auto by = [](const std::string& way, std::vector<KnobSetting> more = {}) {
        more.insert(more.begin(), {"way", way});
        return more;
    };
    study.lines = {{"forward", by("forward"), "lamps", lamps},
                   {"deferred", by("deferred"), "lamps", lamps},
                   {"deferred, normals of 8 bits", by("deferred", {{"normal-bits", "8"}}), "lamps", lamps},
                   {"deferred, 8 bits", by("deferred", {{"sum", "8-bit"}}), "lamps", lamps},
                   {"lamp by lamp", by("lamp-by-lamp"), "lamps", lamps},
                   {"lamp by lamp, 8 bits", by("lamp-by-lamp", {{"sum", "8-bit"}}), "lamps", lamps}};
    study.problem = "lamps";
    study.wrongBeyond = 2.0 / 255;
    study.axis = ErrorAxis::fraction;
    study.width = 400;
    study.height = 240;
    const auto deferred = rows("deferred"), eight = rows("deferred, normals of 8 bits"), cut = rows("deferred, 8 bits"),
               added = rows("lamp by lamp");
    study.says = {claim("one-light",
                        "Forward, deferred and lamp by lamp find the same light: with 96 lamps it is off by two steps "
                        "of 255 in 3 % of the pixels at most.",
                        {atMost(of::wrong, rows("forward", "deferred", "lamp by lamp"), 3)}),
                  claim("stored-is-rounded",
                        "What is stored is rounded: at 96 lamps ten times as many pixels are off so as by forward "
                        "drawing, and with normals of 8 bits "
                        "twice as many as with 10, at least.",
                        {ratio(of::wrong, deferred.at(96), rows("forward").at(96), 10, HUGE_VAL),
                         ratio(of::wrong, eight.from(32), deferred.from(32), 2, HUGE_VAL)}),
                  claim("eight-bits-end-at-1",
                        "Eight bits keep nothing above 1: from 32 lamps on the root mean square is a hundred times "
                        "that of half floats.",
                        {ratio(of::rms, cut.from(32), deferred.from(32), 100, HUGE_VAL)}),
                  claim("each-sum-is-rounded",
                        "Each addition to a half float is rounded: with 96 lamps that reach far, lamp by lamp is off "
                        "in five times as many pixels as all in one, at least.",
                        {ratio(of::wrong, added.in("far reach").at(96), deferred, 5, HUGE_VAL)}),
                  claim("asked-once",
                        "On a processor, at 96 lamps forward drawing takes longer than deferred by a fifth at least.",
                        {ratio(of::time, rows("forward").at(96), deferred.at(96), 1.2, HUGE_VAL)}),
                  note("The brightest pixels are beyond 10, and one at the edge of a ball that is another surface's "
                       "weighs much in the root mean square.")};
    return study;
}

const bool studied = addStudy("deferred", study());
const bool probed = addProbes(
    "deferred",
    {{{{"beyond-one", "of what is seen, the part whose light is summed up to more than 1", "%"}}, beyondOne}});

}  // namespace
}  // namespace mv::deferred

// The readouts of stereocube, and the study of its anaglyphs: what each eye sees through its glass, against what it ought to see.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <string>
#include <vector>

#include "mv/demo/lesson.h"
#include "mv/geometry/ray_caster.h"
#include "mv/math/color.h"
#include "stereocube.h"

using namespace mv::claims;

namespace mv::stereocube {

void readOut(Gpu&, const Settings& s, const Frame& frame, Numbers& numbers) {
    if (isShaded(s)) {
        numbers.set("crosstalk-left", crosstalk(Eyes::left));
        numbers.set("crosstalk-right", crosstalk(Eyes::right));
    }
    const std::optional<Parallax> parallax = parallaxOf(s, frame);
    if (!parallax) return;
    numbers.set("vertical-parallax", parallax->vertical);
    numbers.set("parallax-min", parallax->leastAcross);
    numbers.set("parallax-max", parallax->mostAcross);
    const std::optional<OnScreen> here = onScreen(s, frame);
    if (!here) return;
    numbers.set("parallax-mm", here->most);
    if (here->atInfinity) numbers.set("infinity-mm", *here->atInfinity);
}

namespace {

// What an eye sees without glasses, in light: a ray for each pixel, the upper row first.
struct Seen {
    std::vector<vec3> light;
    std::vector<int> objects;  // -1: paper
};

// The normal as GL interpolates it over the triangle that was hit.
vec3 smoothNormal(const SceneObject& object, const SceneHit& hit) {
    const MeshData& mesh = object.mesh;
    std::array<vec3, 3> at{}, normals{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::size_t vertex = 3 * std::size_t(hit.triangle) + i;
        const std::size_t index = mesh.indices.empty() ? vertex : mesh.indices[vertex];
        at.at(i) = vec3(object.worldFromObject * vec4(vec3(mesh.positions[index]), 1));
        normals.at(i) = mat3(object.worldFromObject) * vec3(mesh.normals[index]);
    }
    const auto areaOf = [&](const vec3& a, const vec3& b) {
        return glm::dot(glm::cross(a - hit.point, b - hit.point), hit.normal);
    };
    return glm::normalize(areaOf(at[1], at[2]) * normals[0] + areaOf(at[2], at[0]) * normals[1] +
                          areaOf(at[0], at[1]) * normals[2]);
}

Seen seenBare(const Settings& s, const FrameInfo& frame, Eyes which, const std::function<void(double)>& progress) {
    const Lens lens = lensOf(s, frame);
    const Eye eye = which == Eyes::right ? rightEye(s, lens) : leftEye(s, lens);
    const Scene scene = stillLifeOf(s);
    const RayCaster rays(scene);
    const mat4 worldFromClip = glm::inverse(eye.clipFromEye * eye.eyeFromWorld);
    const vec3 place(glm::inverse(eye.eyeFromWorld)[3]);
    const vec3 light(scene.lights[0].position), paper(s.background == Paper::white ? 1 : 0);
    Seen seen;
    for (int row = 0; row < frame.height(); ++row) {
        if (progress) progress(double(row) / frame.height());
        for (int column = 0; column < frame.width(); ++column) {
            const vec4 far = worldFromClip *
                             vec4(2 * (column + 0.5) / frame.width() - 1, 1 - 2 * (row + 0.5) / frame.height(), 1, 1);
            const auto hit = rays.nearest({place, vec3(far) / far.w - place});
            seen.objects.push_back(hit ? hit->object : -1);
            if (!hit) {
                seen.light.push_back(paper);
                continue;
            }
            const SceneObject& object = scene.objects[std::size_t(hit->object)];
            // The same share of ambient light as in shaders/include/light.glsl
            const double cosine = glm::dot(smoothNormal(object, *hit), glm::normalize(light - hit->point));
            seen.light.push_back(linearFromSrgb(object.color * (0.3 + 0.7 * std::max(cosine, 0.0))));
        }
    }
    return seen;
}

// What both eyes are told of one thing: how far its brightness differs from eye to eye, and how far its colour, the mean of
// what both see, is from its own.
std::vector<double> rivalry(Probing& probing) {
    const auto s = settingsOf<Settings>(probing.demo());
    if (!isShaded(s)) return {};
    const Mixing mixing = mixingOf(s.mix);
    const Seen seen = seenBare(s, FrameInfo(1, 100, 100), Eyes::left, {});
    const mat3 left = seenThrough(Eyes::left), right = seenThrough(Eyes::right);
    const vec3 white = (left + right) * vec3(1);
    double brightness = 0, colors = 0, n = 0;
    for (std::size_t i = 0; i < seen.light.size(); ++i) {
        if (seen.objects[i] < 0) continue;
        const vec3 light = seen.light[i], shown = mixed(mixing, light, light);
        const double differs = glm::dot(brightnessThrough(Eyes::left) - brightnessThrough(Eyes::right), shown);
        const vec3 both = oklabFromLinear((left * shown + right * shown) / white), wanted = oklabFromLinear(light);
        brightness += differs * differs;
        colors += std::pow(both.y - wanted.y, 2) + std::pow(both.z - wanted.z, 2);
        ++n;
    }
    if (n == 0) return {};
    const double percent = 100 * std::sqrt(brightness / n);
    return {percent < 1e-9 ? 0 : percent, std::sqrt(colors / n)};  // of grey there are roundings alone
}

Study study() {
    Study study;
    study.quantity = "brightness that an eye sees through its glass, white being 1";
    study.reference = "a ray for each pixel of that eye's own picture, in double, and the brightness of what it meets";
    study.reads = {"eye-sep", "z-dist", "convergence", "spin-x", "spin-y", "stereo", "background", "eyes", "shape"};
    study.makeReference = [](const Demo& demo, const ReferenceFrame& frame, const auto& progress) {
        const auto s = settingsOf<Settings>(demo);
        const Seen seen = seenBare(s, frame, s.eyes, progress);
        Reference reference{.values = {}};
        reference.regions = seen.objects;
        for (const vec3& light : seen.light) reference.values.push_back(glm::dot(brightnessThrough(Eyes::both), light));
        return reference;
    };
    const std::vector<KnobSetting> still{{"shape", "still-life"}, {"stereo", "off-axis"}, {"convergence", "3"}};
    std::vector<KnobSetting> left = still, right = still, flat = still;
    left.push_back({"eyes", "left"});
    right.push_back({"eyes", "right"});
    flat.push_back({"eyes", "left"});
    flat.push_back({"eye-sep", "0"});
    study.scenes = {{"left eye", left}, {"right eye", right}, {"left eye, no parallax", flat}};
    for (const std::string mix : {"full", "half", "grey", "least-squares"})
        study.lines.push_back({.method = mix, .settings = {{"mix", mix}}});
    study.wrongBeyond = 0.1;
    study.width = study.height = 300;
    study.says = {
        claim(
            "full-colour-is-wrong-for-one-eye",
            "In full colour the left eye sees red alone where it ought to see brightness: it is off by 5 % of white at "
            "least, five times as much as in grey.",
            {atLeast(of::rms, rows("full").in("left eye"), 0.05),
             ratio(of::rms, rows("full").in("left eye"), rows("grey").in("left eye"), 5, HUGE_VAL)}),
        claim(
            "half-mends-one-eye",
            "Half colour is nearly as right as grey for the left eye, to a half, and for the right eye no better than "
            "full colour.",
            {ratio(of::rms, rows("half").in("left eye"), rows("grey").in("left eye"), 0.9, 1.5),
             ratio(of::rms, rows("half").in("right eye"), rows("full").in("right eye"), 1, 1.5)}),
        claim("least-squares-is-fair",
              "Least squares is off by 1.5 % of white at most for each eye. Of the others only grey is.",
              {atMost(of::rms, rows("least-squares", "grey").in("left eye"), 0.015),
               atMost(of::rms, rows("least-squares", "grey").in("right eye"), 0.015),
               atLeast(of::rms, rows("full", "half").in("right eye"), 0.015)}),
        claim("the-rest-is-a-ghost",
              "Grey is wrong by what the glass lets through of the other picture: without parallax its error is a "
              "quarter at most.",
              {ratio(of::rms, rows("grey").in("left eye, no parallax"), rows("grey").in("left eye"), 0, 0.25)}),
        note("All four are the same draws with other numbers in two matrices, so they take the same time; what the "
             "times differ by is the machine's unrest.")};
    return study;
}

const bool studied = addStudy("stereocube", study());
const bool probed = addProbes(
    "stereocube",
    {{.numbers = {{"rivalry", "how far one thing differs in brightness from eye to eye, white being 100", "%"},
                  {"color-loss", "how far the colour of both eyes together is from the thing's own, in OKLab"}},
      .measure = rivalry}});

}  // namespace
}  // namespace mv::stereocube

// The study of cube-shadows: the places of its shadows against rays from the light.
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <iterator>
#include <string>
#include <vector>

#include "cube-shadows.h"
#include "mv/demo/lesson.h"
#include "mv/geometry/ray.h"
#include "mv/math/shadow.h"
#include "mv/math/transform.h"
#include "shared/scenes.h"

using namespace mv::claims;

namespace mv::cube_shadows {

static vec3 cornerOf(const vec3& middle, int i) { return middle + (vec3(i & 1, i >> 1 & 1, i >> 2) * 2.0 - 1.0); }

// The places of the shadows of a cube's corners on the floor, relative to the plane's point. As the GPU computes them: the
// matrix is rounded to float, and multiplied and divided in float.
std::vector<double> values(const Settings& s) {
    const Plane plane = groundsOf(s).front().plane;
    const mat4 worldFromCube = translate(middleOf(s) + vec3(0, 0, s.lift));
    const fmat4 localFromModel(flattened(s, translate(-plane.origin), plane, worldFromCube));
    std::vector<double> places;
    for (int i = 0; i < 8; ++i) {
        const fvec4 shadow = localFromModel * fvec4(cornerOf(vec3(0), i), 1);
        for (int axis = 0; axis < 3; ++axis) places.push_back(shadow[axis] / shadow.w);
    }
    return places;
}

namespace {

// The same places by another way: the ray from the light through each corner of the cube meets the floor. Here are neither
// matrices nor large numbers: all is relative to the floor's point that is nearest to the middle.
struct Rays {
    std::array<vec3, 8> corners;
    vec4 light, floor;

    Rays(const Settings& s, const FrameInfo& frame) {
        const Scene scene = sceneOf(s, frame);
        const bool life = s.scene == Which::stillLife;
        const mat4& worldFromFloor = scene[life ? stillLifeInRoomScene::floor : cubeInRoomScene::floor].worldFromObject;
        const vec3 normal(worldFromFloor[1]), point(worldFromFloor[3]);
        const vec3 middle(0, 0, floorBelow - s.planeDistance);
        const vec3 origin = middle - glm::dot(normal, middle - point) * normal;
        const vec4& position = scene.lights[0].position;
        floor = vec4(normal, 0);
        light = vec4(vec3(position) - position.w * origin, position.w);
        const vec3 cube = middle + vec3(0, 0, s.lift) - origin;
        for (int i = 0; i < 8; ++i) corners[static_cast<std::size_t>(i)] = cornerOf(cube, i);
    }

    // Whether each corner throws a shadow on the floor.
    bool allCast() const {
        if (lightSide(light, floor) <= 0) return false;
        for (const vec4& bound : shadowCasterBounds(light, floor)) {
            for (const vec3& corner : corners)
                if (glm::dot(bound, vec4(corner, 1)) <= 0) return false;
        }
        return true;
    }

    std::vector<double> places() const {
        std::vector<double> places;
        for (const vec3& corner : corners) {
            const vec3 along = light.w * corner - vec3(light);
            const auto t = intersectPlane(Ray{corner, along}, floor);
            if (!t) throw Error("reference", "must have every corner between plane and light");
            const vec3 met = corner + *t * along;
            places.insert(places.end(), {met.x, met.y, met.z});
        }
        return places;
    }
};

std::vector<double> placeError(Probing& probing) {
    const Rays rays(settingsOf<Settings>(probing.demo()), probing.frame());
    if (!rays.allCast()) return {};
    const std::vector<double> drawn = probing.demo().values(), right = rays.places();
    double most = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i) most = std::fmax(most, std::abs(drawn[i] - right[i]));
    if (!std::isfinite(most)) return {};
    return {most};
}

const char* const distances[] = {"1", "10", "100", "1e3", "1e4", "1e5", "1e6", "1e7", "1e8"};

StudyLine lineOf(const std::string& method, const std::string& space) {
    return {.method = method,
            .settings = {{"space", space}},
            .knob = "plane-distance",
            .values = {std::begin(distances), std::end(distances)}};
}

Study study() {
    Study study;
    study.quantity = "place of the shadows of a cube's eight corners, relative to a point on the plane";
    study.reference = "the ray from the light through the corner meets the plane, in double, without a matrix";
    study.makeReference = [](const Demo& demo, const ReferenceFrame& frame, const auto&) {
        return Reference{.values = Rays(settingsOf<Settings>(demo), frame).places()};
    };
    study.reads = {"scene",       "light-theta", "light-phi", "light-distance",
                   "at-infinity", "lift",        "tilt",      "plane-distance"};
    // The original's plane, with the light higher than there
    const std::vector<KnobSetting> level{
        {"scene", "plane"}, {"light-theta", "20"}, {"light-phi", "40"}, {"light-distance", "8.5"}};
    std::vector<KnobSetting> rising = level;
    rising.push_back({"tilt", "-20"});
    study.problem = "plane-distance";
    study.scenes = {{"level plane", level}, {"rising plane", rising}};
    study.lines = {lineOf("world space, float", "world-float"), lineOf("world space, double", "world"),
                   lineOf("plane-local, double", "plane-local")};
    study.wrongBeyond = 2e-5;
    const auto floats = rows("world space, float"), doubles = rows("world space, double"),
               local = rows("plane-local, double");
    study.says = {
        claim("float-level",
              "In world space the matrix has entries as large as the distance of the plane. In float, on the level "
              "plane, its error grows like that distance.",
              {slope(of::rms, floats.in("level plane"), 0.8, 1.2)}),
        claim("float-rising",
              "On the rising plane x and z are both large, and the matrix has their products: from 100 to 1e7 the "
              "error grows like the square of the distance.",
              {slope(of::rms, floats.in("rising plane").from(100).upTo(1e7), 1.8, 2.2)}),
        claim("double-holds",
              "In double the same matrix is as good as one relative to the plane: up to 1e6 on the level plane, up "
              "to 1e4 on the rising one, where it is ten times worse at least at 1e6.",
              {ratio(of::rms, doubles.in("level plane").upTo(1e6), local, 0.99, 1.01),
               ratio(of::rms, doubles.in("rising plane").upTo(1e4), local, 0.99, 1.01),
               atLeast(of::rms, doubles.in("rising plane").at(1e6), 1e-6)}),
        claim("refused",
              "From 1e7 on light and plane are too close together, beside their distance from the origin, for a "
              "matrix in world space: it is refused.",
              {fails(doubles.from(1e7), "the light must be off the plane")}),
        claim("local",
              "Relative to a point on the plane the error is the same at every distance, within 2 %: that of "
              "rounding to float, at most 4.8e-7 for coordinates below 8.",
              {settled(of::rms, local, 1.02), atMost(of::max, local, 4.8e-7)}),
        claim("time", "It takes at most half as long again as the float matrix.",
              {ratio(of::time, local, floats, 0, 1.5)})};
    study.ofValues = true;
    return study;
}

const bool studied = addStudy("cube-shadows", study());
const bool probed = addProbes(
    "cube-shadows",
    {{{{"place-error", "farthest that a corner's shadow on the floor is off, for a cube of side 2"}}, placeError}});

}  // namespace
}  // namespace mv::cube_shadows

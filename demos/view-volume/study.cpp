// The readouts of view-volume, and its study: its six planes, against planes made without a matrix.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "mv/demo/lesson.h"
#include "view-volume.h"

namespace mv::view_volume {

void readOut(Gpu& gpu, const Settings& s, const Frame&, Numbers& numbers) {
    const Kept kept = keptOf(gpu, s);
    numbers.set("drawn", double(kept.things.size()));
    numbers.set("culled", double(gpu.things.size() - kept.things.size()));
    numbers.set("clipped", kept.crossing);
    numbers.set("far-over-near", s.far / s.nearUsed());
}

// Each plane's normal, and its distance as a part of far.
std::vector<double> values(const Settings& s) {
    std::vector<double> numbers;
    for (const vec4& plane : cameraPlanes(s)) {
        if (plane == vec4(0)) throw Error("plane", "must have a normal: it has cancelled to 0 in float");
        numbers.insert(numbers.end(), {plane.x, plane.y, plane.z, plane.w / s.far});
    }
    return numbers;
}

namespace {

using namespace mv::claims;

// The planes by another way, without a matrix: planes through three corners of the volume, in long double.
Reference planesByCorners(const Settings& s) {
    using real = long double;
    using real3 = glm::vec<3, real>;
    const real tangent = std::tan(real(fovy) / 360 * std::acos(real(-1)));
    const real f = real(s.far), n = real(s.near) / real(s.closer);
    // Bits 0, 1, 2 of i: right, top, far
    const auto corner = [&](unsigned i) {
        const real depth = (i & 4U) != 0 ? f : n;
        const real half = (s.projection == Projection::perspective ? depth : real(16)) * tangent;
        return real3(((i & 1U) != 0 ? half : -half) * real(aspect), (i & 2U) != 0 ? half : -half, -depth);
    };
    // Left, right, bottom, top, near, far: counter-clockwise seen from inside
    Reference result;
    for (const auto& [a, b, c] :
         {std::array{4U, 6U, 0U}, {5U, 1U, 7U}, {4U, 0U, 5U}, {6U, 7U, 2U}, {0U, 2U, 1U}, {4U, 5U, 6U}}) {
        const real3 normal = glm::normalize(glm::cross(corner(b) - corner(a), corner(c) - corner(a)));
        for (int axis = 0; axis < 3; ++axis) result.values.push_back(double(normal[axis]));
        result.values.push_back(double(-glm::dot(normal, corner(a)) / f));
    }
    return result;
}

std::vector<double> largestError(Probing& probing) {
    const std::vector<double> right = planesByCorners(settingsOf<Settings>(probing.demo())).values;
    std::vector<double> numbers;
    try {
        numbers = probing.demo().values();
    } catch (const Error&) {
        return {1};  // a normal that is gone is off by its whole length
    }
    double most = 0;
    for (std::size_t i = 0; i < right.size(); ++i) most = std::max(most, std::abs(numbers[i] - right[i]));
    return {most};
}

Study study() {
    Study study;
    study.quantity = "the six planes of the view volume: normals, and distances over far";
    study.reference = "planes through three corners of the volume each, in long double";
    study.makeReference = [](const Demo& demo, const ReferenceFrame&, const auto&) {
        return planesByCorners(settingsOf<Settings>(demo));
    };
    study.reads = {"projection", "near", "far", "closer"};
    study.problem = "closer";
    study.scenes = {{"perspective", {{"near", "6"}, {"far", "60"}}}};
    const std::vector<std::string> closer{"1", "10", "100", "1e3", "1e4", "1e5", "1e6", "1e7", "1e8"};
    study.lines = {{"parameters", {{"planes", "parameters"}}, "closer", closer},
                   {"matrix, double", {{"planes", "matrix"}}, "closer", closer},
                   {"matrix, float", {{"planes", "float-matrix"}}, "closer", closer}};
    study.wrongBeyond = 1e-6;
    const auto parameters = rows("parameters"), doubles = rows("matrix, double"), floats = rows("matrix, float");
    study.says = {
        claim(
            "parameters-exact",
            "Taken from near and far themselves the planes are right to the last place, 1.1e-16 of 1, at any far/near.",
            {atMost(of::max, parameters, 1.12e-16), settled(of::rms, parameters, 1.01)}),
        claim("parameters-faster", "That takes less time than sums of the rows of the matrix in double.",
              {ratio(of::time, parameters, doubles, 0, 1)}),
        claim("a-digit-a-decade",
              "Sums of the matrix's rows lose a digit of the far plane for each decade of far/near, in double and "
              "in float.",
              {slope(of::rms, doubles, 0.8, 1.2), slope(of::rms, floats.upTo(1e6), 0.8, 1.2)}),
        claim("double-far", "In double the far plane is still known to 1e-7 where far/near is 1e9.",
              {atMost(of::max, doubles.at(1e8), 1e-7)}),
        claim("float-far", "In float it is off by 16 % where far/near is 1e7, and gone from 1e8 on.",
              {value(of::max, floats.at(1e6), 0.155, 0.165), fails(floats.from(1e7), "it has cancelled to 0")})};
    study.ofValues = true;
    return study;
}

[[maybe_unused]] const bool studied = addStudy("view-volume", study());
[[maybe_unused]] const bool probed = addProbes(
    "view-volume",
    {{{{"plane-error", "largest error of a plane: of its normal, and of its distance over far"}}, largestError}});

}  // namespace
}  // namespace mv::view_volume

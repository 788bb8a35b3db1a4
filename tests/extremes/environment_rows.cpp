// X57 and X58: cube maps at their edges, and Fresnel's equations at the limits of index and angle.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <initializer_list>
#include <string>

#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/gl/cube_map.h"
#include "mv/gl/gl.h"
#include "shared/fresnel.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

// ---- X57

// A cube of 8 texels a side, with light that is a smooth function of the direction.
CubeMap smoothCube() {
    std::array<FloatPicture, cubeFaces> faces;
    for (int face = 0; face < cubeFaces; ++face) {
        FloatPicture picture(8, 8, 4);
        for (int i = 0; i < 64; ++i) {
            const int row = i / 8;
            const vec3 way = glm::normalize(cubeDirection({face, {(i % 8 + 0.5) / 8, (row + 0.5) / 8}}));
            picture.values[4 * std::size_t(i)] = float(0.5 + 0.45 * glm::dot(way, glm::normalize(vec3(1, -1, -2))));
        }
        faces.at(static_cast<std::size_t>(face)) = picture;
    }
    return CubeMap(faces);
}

// The largest step from a pixel to the next of 256, which look from one direction to another, in levels of 255.
double largestStep(const vec3& from, const vec3& to, bool seamless) {
    (void)stage();
    const CubeMap map = smoothCube();
    const Program program =
        Program::fromText("across", "in vec4 position;\nvoid main() { gl_Position = position; }\n",
                          "uniform samplerCube cube;\nuniform vec3 from, to;\nout vec4 color;\nvoid main() {\n"
                          "    color = texture(cube, mix(from, to, gl_FragCoord.x / 256.0));\n}\n");
    const Mesh pane(
        {.primitive = Primitive::triangleStrip, .positions = {{-1, -1, 0}, {1, -1, 0}, {-1, 1, 0}, {1, 1, 0}}});
    const Target target(256, 1, {});
    target.bind();
    if (seamless) glEnable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    program.use();
    program.set("from", from);
    program.set("to", to);
    map.bind(0);
    pane.draw();
    if (seamless) glDisable(GL_TEXTURE_CUBE_MAP_SEAMLESS);
    const Picture line = target.read();
    double most = 0;
    for (int x = 1; x < 256; ++x) most = std::max(most, double(std::abs(line.at(x, 0).red - line.at(x - 1, 0).red)));
    return most;
}

Row seam(const std::string& name, const std::string& where, const vec3& from, const vec3& to) {
    return {.id = "X57 " + name,
            .input = "256 looks into a cube of 8 texels a side, " + where,
            .measured = "largest step from one look to the next, levels of 255",
            .naive = "each face by itself, clamped to its edge",
            .naiveError = largestStep(from, to, false),
            .ours = "GL_TEXTURE_CUBE_MAP_SEAMLESS",
            .ourError = largestStep(from, to, true),
            .tolerance = 2,
            .reason =
                "a look is less than a fiftieth of a texel from the next, and texels differ by 30 at most; rounding of "
                "both"};
}
[[maybe_unused]] const bool x57edge =
    addRow([] { return seam("edge", "across the edge +x +z", vec3(1, 0.1, 0.5), vec3(0.5, 0.1, 1)); });
[[maybe_unused]] const bool x57corner =
    addRow([] { return seam("corner", "through a corner", vec3(1, 0.6, 0.6), vec3(0.6, 1, 1)); });
[[maybe_unused]] const bool x57zero = addRow([] {
    return Row{.id = "X57 zero",
               .input = "a look in the direction 0",
               .measured = "0: refused; 1: answered",
               .naive = "normalize(direction), which a face is chosen by",
               .naiveError = std::isnan(glm::normalize(vec3(0)).x) ? notANumber : 0,
               .ours = "cubePlace",
               .ourError = accepted([] { (void)cubePlace(vec3(0)); }),
               .tolerance = 0,
               .reason = "there is no such direction"};
});

// ---- X58

// As lectures have it: cos b = sqrt(1 - sin^2 a / index^2), and amplitudes with these cosines; what is reflected and what
// passes, together.
double plainSum(double sine, double index) {
    const double cosA = std::sqrt(1 - sine * sine), cosB = std::sqrt(1 - sine * sine / (index * index));
    const double across = (cosA - index * cosB) / (cosA + index * cosB);
    const double along = (index * cosA - cosB) / (index * cosA + cosB);
    const double passesAcross = 2 * cosA / (cosA + index * cosB), passesAlong = 2 * cosA / (index * cosA + cosB);
    const double ratio = index * cosB / cosA;
    return (across * across + along * along + ratio * (passesAcross * passesAcross + passesAlong * passesAlong)) / 2;
}
// Fresnel's own form, by sines and tangents of both angles.
double sumByAngles(double a, double index) {
    const double b = std::asin(std::sin(a) / index);
    const double across = std::sin(a - b) / std::sin(a + b), along = std::tan(a - b) / std::tan(a + b);
    const double passes = std::sin(2 * a) * std::sin(2 * b) / std::pow(std::sin(a + b), 2);
    return (across * across + along * along + passes + passes / std::pow(std::cos(a - b), 2)) / 2;
}
double offOne(double sum) { return std::isnan(sum) ? notANumber : std::abs(sum - 1); }
double ourSum(double cosine, double index) {
    const Split split = fresnel(cosine, index);
    return offOne(split.reflected + split.transmitted);
}

const char* const measured = "how far what is reflected and what passes are from 1 together";
const char* const reason = "some roundings of parts of 1; the course asks for 1e-12";

[[maybe_unused]] const bool x58one = addRow([] {
    return Row{.id = "X58 index 1",
               .input = "a surface with index 1, a grazing angle of 90°",
               .measured = measured,
               .naive = "amplitudes with cos b = sqrt(1 - sin^2 a / index^2)",
               .naiveError = offOne(plainSum(1, 1)),
               .ours = "fresnel: no surface, nothing reflected",
               .ourError = ourSum(0, 1),
               .tolerance = 1e-12,
               .reason = reason};
});
[[maybe_unused]] const bool x58huge = addRow([] {
    double ours = 0;
    for (int i = 0; i <= 90; ++i) ours = worse(ours, ourSum(std::max(std::cos(radians(i)), 0.0), 1e6));
    return Row{.id = "X58 index 1e6",
               .input = "a surface with index 1e6, all angles from 0° on",
               .measured = measured,
               .naive = "sines and tangents of both angles: 0/0 head on",
               .naiveError = offOne(sumByAngles(0, 1e6)),
               .ours = "fresnel: by cosines",
               .ourError = ours,
               .tolerance = 1e-12,
               .reason = reason};
});
[[maybe_unused]] const bool x58edge = addRow([] {
    double naive = 0, ours = 0;
    for (const double index : {0.4, 0.75, 1 / 1.5, 0.999}) {
        // Sines at the edge of total reflection, and their next neighbours on both sides
        for (const double sine : {index, std::nextafter(index, 0.0), std::nextafter(index, 1.0), index + 1e-9}) {
            naive = worse(naive, offOne(plainSum(sine, index)));
            ours = worse(ours, ourSum(std::sqrt((1 - sine) * (1 + sine)), index));
        }
    }
    return Row{.id = "X58 total reflection",
               .input = "light inside glass, at the angle of total reflection and one rounding from it",
               .measured = measured,
               .naive = "amplitudes with cos b = sqrt(1 - sin^2 a / index^2)",
               .naiveError = naive,
               .ours = "fresnel: 1 where that is the root of what is not above 0",
               .ourError = ours,
               .tolerance = 1e-12,
               .reason = reason};
});

}  // namespace

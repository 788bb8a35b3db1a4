// The claims of gpu-stages, and a test for each.
//
// - [counts-agree] Two queries and what transform feedback leaves in its buffer count the same primitives.
// - [counts-follow-the-rule] The tessellator makes as many triangles as its levels say; a geometry shader, of each triangle
//   one or a line, of each point four triangles.
// - [stages-pass-on] A stage that is on and changes nothing changes no pixel by more than its colours' last place; without
//   fragments there is no picture, and all is counted as before.
// - [hidden-lines] The second draw adds lines behind faces and nothing else, and covers no line in front of them.
// - [ten-primitive-types] The number of primitives follows from that of the vertices in each of the seven types of the core,
//   which refuses the other three.
// - [regular-only-with-euler-0] Of the closed bodies the torus is regular and the sphere is not; what its vertices lack of
//   six edges is 6 times Euler's number.
// - [compute-is-the-same-picture] The compute shader stores the picture that the fragment shader draws.
// - [three-domains] Of one level n the tessellator makes 3/2 n^2 triangles of a triangle, half a one less where n is odd, and of
//   isolines n lines of n pieces each. No geometry shader here takes these.
// - [light-is-scattered] Each ray of light through the water lands where the processor says, and adds 1 there.
// - [says-what-is-lacking] Without a stage the demo draws what it can, and says what it lacks.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "gpu-stages/primitive_types.h"
#include "gpu-stages/regular_meshes.h"
#include "mv/geometry/shapes.h"
#include "mv/geometry/tessellation.h"
#include "mv/gl/beyond_es.h"
#include "mv/gl/gl.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

const std::vector<std::string> stages{"off", "pass", "wireframe", "shapes", "normals", "explode"};

// The left half of the picture, without the table.
std::vector<Pixel> leftOf(const Picture& picture) {
    std::vector<Pixel> pixels;
    for (int y = 0; y < picture.height; ++y) {
        for (int x = 0; x < 0.45 * picture.width; ++x) pixels.push_back(picture.at(x, y));
    }
    return pixels;
}

// The numbers of the four ways of counting, for the picture as it is set.
struct Counts {
    double into, out, written, found;
};
Counts countsOf(DemoRun& run) {
    (void)run.picture();
    return {run.readout("into-geometry"), run.readout("out-of-geometry"), run.readout("written"), run.readout("found")};
}

}  // namespace

TEST(GpuStagesFull, counts_agree) {
    DemoRun run("gpu-stages", 96, 56);
    run.set("own-edges", "on");
    for (const char* tessellation : {"on", "off"}) {
        for (const std::string& geometry : stages) {
            for (const auto& [inner, outer] : {std::pair{1, 1}, {3, 7}, {16, 16}}) {
                run.set("tessellation", tessellation).set("geometry", geometry).set("inner", inner).set("outer", outer);
                const Counts counts = countsOf(run);
                EXPECT_GT(counts.out, 0);
                EXPECT_EQ(counts.out, counts.written) << geometry;
                EXPECT_EQ(counts.out, counts.found) << geometry;
            }
        }
    }
}

TEST(GpuStagesFull, counts_follow_the_rule) {
    DemoRun run("gpu-stages", 96, 56);
    run.set("own-edges", "on");
    for (const auto& [inner, outer] : {std::pair{1, 1}, {1, 6}, {2, 1}, {5, 9}, {9, 5}, {64, 64}}) {
        run.set("inner", inner).set("outer", outer);
        const auto triangles = double(trianglesOfSquare(inner, outer));
        for (const char* geometry : {"off", "pass", "wireframe", "normals", "explode"}) {
            const Counts counts = countsOf(run.set("geometry", geometry));
            EXPECT_EQ(counts.into, triangles) << inner << " " << outer;
            EXPECT_EQ(counts.out, triangles) << geometry;
        }
        const Counts hexagons = countsOf(run.set("geometry", "shapes"));
        EXPECT_EQ(hexagons.out, 4 * hexagons.into);
        // A square cut n times has (n + 1)^2 points.
        if (inner == outer) {
            EXPECT_EQ(hexagons.into, (inner + 1) * (inner + 1));
        }
    }
    // Edges without a level of their own have that of the inside.
    run.set("own-edges", "off").set("inner", 5).set("outer", 9).set("geometry", "off");
    EXPECT_EQ(countsOf(run).out, trianglesOfSquare(5, 5));
    run.set("tessellation", "off");
    EXPECT_EQ(countsOf(run.set("geometry", "off")).out, 18) << "3 x 3 cells between 16 points";
    EXPECT_EQ(countsOf(run.set("geometry", "shapes")).into, 16);
}

TEST(GpuStagesFull, stages_pass_on) {
    DemoRun run("gpu-stages");
    for (const char* tessellation : {"on", "off"}) {
        // Passed on as it came: the same pixels, and the same light on them but for its rounding.
        run.set("tessellation", tessellation).set("geometry", "off");
        const auto without = leftOf(run.picture());
        const double covered = run.readout("fragments-passed");
        EXPECT_GT(covered, 10000);
        const auto passed = leftOf(run.set("geometry", "pass").picture());
        EXPECT_EQ(run.readout("fragments-passed"), covered) << tessellation;
        for (std::size_t i = 0; i < passed.size(); ++i) {
            ASSERT_NEAR(passed[i].red, without[i].red, 1);
            ASSERT_NEAR(passed[i].green, without[i].green, 1);
            ASSERT_NEAR(passed[i].blue, without[i].blue, 1);
        }
        // The wireframe's stage passes triangles on where they are: as many fragments as without it.
        run.set("geometry", "wireframe").set("hidden", "off");
        EXPECT_NE(leftOf(run.picture()), without);
        EXPECT_EQ(run.readout("fragments-passed"), covered) << tessellation;
    }
    // The vertex shader alone moves it.
    run.set("tessellation", "on").set("geometry", "off");
    const auto bent = leftOf(run.picture());
    EXPECT_NE(leftOf(run.set("bend", 0.0).picture()), bent);

    run.set("bend", 0.1).set("geometry", "wireframe").set("fragments", "off");
    const Pixel background = run.picture().at(0, 0);
    for (const Pixel& pixel : leftOf(run.picture())) ASSERT_EQ(pixel, background);
    const Counts counts = countsOf(run);
    EXPECT_EQ(counts.out, trianglesOfSquare(8, 8));
    EXPECT_EQ(counts.found, counts.out);
    EXPECT_EQ(run.readout("fragments-passed"), 0);
}

TEST(GpuStagesFull, hidden_lines) {
    DemoRun run("gpu-stages");
    const auto both = [&] {
        const auto without = leftOf(run.set("hidden", "off").picture());
        return std::pair(without, leftOf(run.set("hidden", "on").picture()));
    };
    // From above nothing hides anything.
    run.set("spin-x", 90).set("spin-y", 0);
    const auto [above, aboveToo] = both();
    EXPECT_EQ(above, aboveToo);

    run.set("spin-x", 20).set("spin-y", -30);
    const auto [without, with] = both();
    long changed = 0;
    for (std::size_t i = 0; i < with.size(); ++i) {
        if (with[i] == without[i]) continue;
        ++changed;
        EXPECT_LE(with[i].red, without[i].red);
        EXPECT_LE(with[i].green, without[i].green);
        EXPECT_LE(with[i].blue, without[i].blue);
        // Half of a line and half of a face, of red 0.1 and 0.88 at least, or the edge of a control point, of red 0.45, before
        // it: so no line is covered, which are darker.
        EXPECT_GE(with[i].red, 255 * 0.45 - 1);
        EXPECT_NE(without[i], with.front()) << "beside the surface there is nothing to be seen through";
    }
    EXPECT_GT(changed, 100) << "the back of the hill";
    // Finer triangles have more lines, and hide as much: faces would be as many fragments, whatever they are cut into.
    const auto fragmentsOfHidden = [&](int level) {
        const auto passed = [&](const char* hidden) {
            (void)run.set("inner", level).set("hidden", hidden).picture();
            return run.readout("fragments-passed");
        };
        return passed("on") - passed("off");
    };
    EXPECT_GT(fragmentsOfHidden(16), 2 * fragmentsOfHidden(4));
}

TEST(GpuStages, ten_primitive_types) {
    DemoRun run("gpu-stages");
    run.preset("primitives");
    for (int vertices = 4; vertices <= 8; ++vertices) {
        (void)run.set("vertices", vertices).picture();
        long sum = 0;
        for (const PrimitiveType& type : primitiveTypes) sum += type.inCore ? primitivesOf(type, vertices) : 0;
        EXPECT_EQ(run.readout("primitives"), double(sum)) << vertices;
    }
    // The core refuses the last three, and takes the others.
    takeErrors();
    const Program any =
        Program::fromText("any", "in vec3 position;\nvoid main() { gl_Position = vec4(position, 1.0); }\n",
                          "out vec4 fragColor;\nvoid main() { fragColor = vec4(1.0); }\n");
    any.use();
    const Mesh square(mv::square());
    const Target target(8, 8, {}, "any");
    int refused = 0;
    for (const PrimitiveType& type : primitiveTypes) {
        square.drawAs(type.mode);
        const std::vector<std::string> errors = takeErrors();
        EXPECT_EQ(errors.empty(), type.inCore) << type.name;
        refused += errors.empty() ? 0 : 1;
    }
    EXPECT_EQ(refused, 3);
}

TEST(GpuStages, regular_only_with_euler_0) {
    for (const int cells : {3, 8, 12, 32}) {
        for (const RegularMesh& body : regularMeshes(cells)) {
            const Topology& counts = body.topology;
            EXPECT_EQ(counts.missing(), 6 * counts.euler()) << body.name;
            EXPECT_EQ(long(body.irregular.positions.size()), counts.irregular()) << body.name;
            const bool isClosed = counts.boundaryEdges == 0;
            EXPECT_EQ(isClosed, body.name == "torus" || body.name == "sphere");
            EXPECT_EQ(counts.euler(), body.name == "plane" ? 1 : body.name == "sphere" ? 2 : 0) << body.name;
            // Two poles with as many edges as there are cells around, and beside each a ring of vertices with 5.
            const long odd = body.name != "sphere" ? 0 : 2 + 2 * cells;
            EXPECT_EQ(counts.irregular(), odd) << body.name << " " << cells;
        }
    }
    DemoRun run("gpu-stages");
    run.preset("meshes");
    const Picture whole = run.picture();
    EXPECT_EQ(run.readout("irregular"), 2 + 2 * 12);
}

TEST(GpuStages, compute_is_the_same_picture) {
    DemoRun run("gpu-stages");
    run.preset("compute");
    for (const auto& [width, height] : {std::pair{960, 560}, {301, 77}, {64, 64}}) {
        stage().resize(width, height);
        const Picture picture = run.picture();
        EXPECT_EQ(run.readout("differing"), 0) << width << "x" << height;
        EXPECT_GT(countColors(picture, 50), 40) << "it is a picture";
    }
}

TEST(GpuStagesFull, three_domains) {
    DemoRun run("gpu-stages", 96, 56);
    for (const int n : {1, 2, 3, 8, 63, 64}) {
        run.set("inner", n).set("domain", "triangles");
        for (const char* geometry : {"off", "wireframe", "explode"})
            EXPECT_EQ(countsOf(run.set("geometry", geometry)).out, (3 * n * n - n % 2) / 2) << n << " " << geometry;
        // By Euler's V - E + F = 1, with 3 n edges at the border
        EXPECT_EQ(countsOf(run.set("geometry", "shapes")).into, 1 + ((3 * n * n - n % 2) / 2 + 3 * n) / 2) << n;
        run.set("domain", "isolines");
        for (const char* geometry : {"off", "wireframe", "shapes"}) {
            const Counts counts = countsOf(run.set("geometry", geometry));
            EXPECT_EQ(counts.out, n * n) << geometry;
            EXPECT_EQ(counts.into, n * n) << "there is no such stage";
            EXPECT_EQ(counts.found, n * n);
        }
    }
    // Both are of the sheet itself: nothing is drawn where that is not
    stage().resize(480, 280);
    run.set("inner", 64).set("geometry", "off");
    const Picture sheet = run.set("domain", "quads").picture();
    for (const char* domain : {"triangles", "isolines"}) {
        const Picture part = run.set("domain", domain).picture();
        long drawn = 0, beside = 0;
        for (int y = 0; y < part.height; ++y) {
            for (int x = 0; x < 200; ++x) {  // the table is beside it
                if (part.at(x, y) == part.at(0, 0)) continue;
                ++drawn;
                bool isSheet = false;  // OpenGL's lines are a pixel wide, at an edge half of it outside
                for (int v = -1; v <= 1; ++v) {
                    for (int u = -1; u <= 1; ++u)
                        isSheet = isSheet ||
                                  sheet.at(std::max(x + u, 0), std::clamp(y + v, 0, part.height - 1)) != sheet.at(0, 0);
                }
                beside += isSheet ? 0 : 1;
            }
        }
        EXPECT_GT(drawn, 1000) << domain;
        EXPECT_EQ(beside, 0) << domain;
    }
}

TEST(GpuStagesFull, light_is_scattered) {
    DemoRun run("gpu-stages");
    const Picture picture = run.preset("compute").set("kernel", "caustics").picture();
    constexpr int width = 479, height = 528, left = 480;  // of the right pane, below its heading
    // The same rays in double
    std::vector<double> counts(static_cast<std::size_t>(width * height), 0);
    const auto slope = [](const vec2& from, double f) {
        const double r = glm::length(from);
        return f * std::cos(f * r) / r * from;
    };
    for (int j = 0; j < 4 * height; ++j) {
        for (int i = 0; i < 4 * width; ++i) {
            const vec2 at = (vec2(i, j) + 0.5) / (4.0 * height);
            const vec2 leans = slope(at - vec2(0.3, 0.35), 40) + slope(at - vec2(0.7, 0.6), 50);
            const vec2 pixel = glm::floor((at - 0.0006 * leans) * double(height));
            if (pixel.x >= 0 && pixel.y >= 0 && pixel.x < width && pixel.y < height)
                ++counts.at(static_cast<std::size_t>(pixel.y) * width + static_cast<std::size_t>(pixel.x));
        }
    }
    // A pixel shows up to 64 rays, as red from 0 to 255. A ray near a border may land beside it by a rounding of float: in blocks
    // of 8 x 8 the mean is right to a ray in a hundred, and half a step of 8 bits
    double brightest = 0;
    for (int y = 0; y + 8 <= height; y += 8) {
        for (int x = 0; x + 8 <= width; x += 8) {
            double shown = 0, right = 0;
            for (int v = y; v < y + 8; ++v) {
                for (int u = x; u < x + 8; ++u) {
                    shown += picture.at(left + u, picture.height - 1 - v).red / 255.0;
                    const double light = counts.at(static_cast<std::size_t>(v) * width + static_cast<std::size_t>(u));
                    right += std::min(light / 64, 1.0);
                }
            }
            EXPECT_NEAR(shown / 64, right / 64, 0.01 * right / 64 + 0.5 / 255 + 0.002) << x << " " << y;
            brightest = std::max(brightest, right / 64);
        }
    }
    EXPECT_GT(brightest, 0.4) << "light is gathered: a quarter is the mean";
}

TEST(GpuStages, says_what_is_lacking) {
    const auto says = [](DemoRun& run, const std::string& words) {
        for (const std::string& message : run.messages()) {
            if (message.starts_with(words)) return true;
        }
        return false;
    };
    stage().close();
    withhold({beyond_es::tessellation});
    {
        DemoRun run("gpu-stages");
        EXPECT_EQ(countsOf(run).out, 18);
        EXPECT_TRUE(says(run, "This driver has no tessellation (OpenGL 4.0; asked for up to 4.6, given "));
        (void)run.set("tessellation", "off").picture();
        EXPECT_TRUE(run.messages().empty()) << "what is not asked for is not missed";
    }
    stage().close();
    withhold({beyond_es::geometryShaders});
    {
        DemoRun run("gpu-stages");
        const Picture picture = run.picture();
        EXPECT_TRUE(says(run, "This driver has no geometry shaders: that stage is off."));
        EXPECT_EQ(run.set("geometry", "off").picture(), picture);
    }
    stage().close();
    withhold({beyond_es::computeShaders});
    {
        DemoRun run("gpu-stages");
        (void)run.preset("compute").picture();
        EXPECT_FALSE(run.measured("differing"));
        EXPECT_TRUE(says(run, "This driver has no compute shaders (OpenGL 4.3; asked for up to 4.6, given "));
    }
    stage().close();
    withhold({});
}

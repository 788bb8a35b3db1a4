#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <vector>

#include "mv/math/transform.h"
#include "shared/relief.h"
#include "support/demo_run.h"

using namespace mv;
using namespace mv::test;

namespace {

constexpr int width = 320, height = 240;

// What the demo draws of it, as luminance, the upper row first; -1 where nothing is.
std::vector<float> drawn(DemoRun& run, const char* method) {
    (void)run.set("method", method).picture();
    return stage().measure(1);
}

double rmsBetween(const std::vector<float>& a, const std::vector<float>& b) {
    double squares = 0, n = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i] < 0 || b[i] < 0) continue;
        squares += std::pow(double(a[i]) - double(b[i]), 2);
        ++n;
    }
    EXPECT_GT(n, 100);
    return std::sqrt(squares / n);
}

// Against the displaced mesh, which the study compares with lines of sight.
double errorOf(DemoRun& run, const char* method) { return rmsBetween(drawn(run, method), drawn(run, "displaced")); }

// A wall of which nothing is seen twice as large or small for this size of picture.
DemoRun wallAt(double angle) {
    DemoRun run("bump-map", width, height);
    run.set("beside", "off").set("angle", angle);
    return run;
}

}  // namespace

TEST(BumpMap, probe) {
    for (const double angle : {0, 20, 40, 60, 70, 75, 80, 85}) {
        DemoRun run = wallAt(angle);
        std::cout << angle;
        for (const char* method : {"smooth", "height", "normal", "parallax", "occlusion"}) std::cout << " " << errorOf(run, method);
        std::cout << "\n";
    }
    DemoRun run = wallAt(0);
    for (const int size : {64, 128, 256, 512}) {
        run.set("map-size", size);
        std::cout << size << " " << errorOf(run, "normal") << " " << errorOf(run, "height");
        run.set("texels", "8-bit");
        std::cout << " " << errorOf(run, "normal") << " " << errorOf(run, "height") << "\n";
        run.set("texels", "float");
    }
    run.set("map-size", 256).set("mirrored", "on").set("angle", 0);
    std::cout << "mirrored " << errorOf(run, "normal");
    std::cout << " " << errorOf(run.set("sign", "off"), "normal") << "\n";
    run.set("mirrored", "off").set("depth", 0);
    for (const char* method : {"height", "normal", "parallax", "occlusion", "displaced"})
        std::cout << " " << rmsBetween(drawn(run, method), drawn(run, "smooth"));
    DemoRun orange("bump-map", width, height);
    orange.set("body", "orange").set("depth", 0);
    for (const char* method : {"height", "normal", "parallax", "occlusion", "displaced"})
        std::cout << " " << rmsBetween(drawn(orange, method), drawn(orange, "smooth"));
    std::cout << "\n";
}

#pragma once
#include <memory>
#include <utility>
#include <vector>

#include "mv/demo/frame.h"
#include "mv/demo/made_for.h"
#include "mv/demo/numbers.h"
#include "mv/image/picture.h"
#include "passes.h"

namespace mv::ray_trace {

enum class Fresnel { exact, schlick };
enum class Show { light, cut, rays };

struct Settings {
    TracedRoom room = TracedRoom::stillLife;
    Show show = Show::light;
    int depth = 8;     // rays that follow each other
    int samples = 16;  // a pixel
    SamplePattern pattern = SamplePattern::sequence;
    double lampSize = 1.1;  // half a side
    double index = 1.5;     // of the glass
    Fresnel fresnel = Fresnel::exact;
    bool shadows = true;
    bool filtered = true;
    RayStructure structure = RayStructure::tree;
    int triangles = 4096;
    Leave leave = Leave::bounded;
    double eyeTurn = 0;  // degrees
    double eyeHeight = 2;
    int seed = 1;
    double highlight = 0;  // Phong's exponent; 0: none
    bool falloff = false;
    double globeTurn = 0;  // degrees
    int wavelengths = 1;   // traced where glass is met; 1: all alike
    double abbe = 64.17;   // of the glass: small where it parts the colours much
};

// The processor makes the picture.
struct Gpu {};

// The result of the passes so far.
struct Made {
    TracePicture picture;
    std::shared_ptr<const TriangleFinder> finder;
    MadeFor<TracedRoom, RayStructure, int> finderFor;
};

// The technique: ray-trace.cpp, with whitted.h; passes.cpp; samples.cpp.
void draw(Gpu& gpu, const Settings& s, const Made& made, const Frame& frame);
void refine(Made& made, const Settings& s, const FrameInfo& frame, int pass);

// The picture that is shown, and the words over it: figure.cpp.
std::vector<TracePicture::Colored> colorsOf(const Settings& s, int wavelengths);
TracePicture::Plan planOf(const Settings& s, int width, int height, std::shared_ptr<const TriangleFinder> finder);
std::shared_ptr<const TriangleFinder> finderOf(const Settings& s);
Picture shown(const Settings& s, const Made& made);
void drawFigure(Gpu& gpu, const Settings& s, const Made& made, const Frame& frame);

// knobs.cpp, study.cpp.
void check(const Settings& s);
const char* nameOf(RayStructure structure);
void readOut(Gpu& gpu, const Settings& s, const Made& made, const Frame& frame, Numbers& numbers);
std::vector<double> values(const Settings& s);
std::vector<std::pair<std::string, double>> valueCounts(const Settings& s);

}  // namespace mv::ray_trace

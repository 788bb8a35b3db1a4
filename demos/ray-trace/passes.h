// Pictures by rays that are traced on, pass by pass: coarse blocks first, then one more sample for each pixel.
#pragma once
#include <cstdint>
#include <memory>
#include <vector>

#include "mv/image/picture.h"
#include "whitted.h"

namespace mv {

// Mirror, glass and coloured balls on a floor of squares; the teapot, of triangles, beside a mirror ball; a ball over a grey
// floor; that floor alone; a mirror and a glass ball in a room whose walls are white and shine, so that whatever way light
// takes, 1 is seen; the ball over a grey floor of triangles; two globes, a near and a far one, with a picture round them, beside
// a mirror ball; a glass ball over the squares, that fills most of the picture.
enum class TracedRoom { stillLife, teapot, softShadow, lamp, white, strips, globes, glassBall };
TracedScene tracedRoom(TracedRoom room, double lampSize, double index, std::shared_ptr<const TriangleFinder> mesh = {},
                       double turn = 0);

struct TraceView {
    vec3 eye{0.3, 2, 6.2}, at{0.1, 0.65, 0};
    double fovy = 34.4;  // degrees
};
// The angle of view, degrees, of the middle half of a picture.
double halved(double fovy);

class TracePicture {
  public:
    // What is traced of one wavelength: its scene, and its share of what is seen.
    struct Colored {
        TracedScene scene;
        mat3 share{1};
    };
    // The settings of a picture, the same for all its passes.
    struct Plan {
        TracedScene scene;
        std::vector<Colored> colors = {};  // with glass that has another index for each wavelength; none: for all alike
        TraceView view;
        TraceOptions options;
        SamplePattern pattern = SamplePattern::sequence;
        int samples = 16;  // a pixel
        std::uint32_t seed = 1;
        int width = 0, height = 0;
        int threads = 0;  // 0: one for each processor; the result does not depend on their number
    };

    // Blocks of 16, 8, 4 and 2 pixels, then the samples, each for one band of rows after the other.
    static int passesOf(int samples, int width, int height) { return coarsePasses + samples * bandsOf(width, height); }
    // Pass 0 begins the picture anew.
    void pass(const Plan& plan, int number);

    int width() const { return width_; }
    int height() const { return height_; }
    // Linear light, the upper row first, and what the depth cut off, as the passes so far have them.
    const std::vector<vec3>& light() const { return shown_; }
    const std::vector<double>& cut() const { return cut_; }
    // The light in sRGB, what is above 1 as white, as developed() makes it of light().
    const Picture& developed() const { return developed_; }
    // A sample, with those to the lamp, for each pixel; and of all passes together.
    const std::vector<double>& raysAt() const { return raysAt_; }
    long rays() const { return rays_; }

  private:
    static constexpr int coarsePasses = 4;
    // A window answers after each pass: one takes no more pixels than two processors trace in a few tenths of a second.
    static int bandsOf(int width, int height) { return (width * height + (1 << 20) - 1) >> 20; }

    int width_ = 0, height_ = 0;
    std::vector<vec3> sum_, shown_;
    std::vector<double> cutSum_, cut_, raysSum_, raysAt_;
    Picture developed_;
    long rays_ = 0;
};

// Through the middle of each pixel of such a picture, the upper row first.
std::vector<Ray> raysThrough(const TracePicture::Plan& plan);

// The picture in sRGB, with light above 1 as white.
Picture developed(const std::vector<vec3>& light, int width, int height);

}  // namespace mv

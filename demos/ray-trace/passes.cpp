#include "passes.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "mv/math/color.h"
#include "mv/math/transform.h"
#include "shared/in_rows.h"

namespace mv {
namespace {

// The rays through a view's picture.
class Lens {
  public:
    Lens(const TraceView& view, int width, int height) : eye_(view.eye), width_(width), height_(height) {
        forward_ = glm::normalize(view.at - view.eye);
        const vec3 right = glm::normalize(glm::cross(forward_, vec3(0, 1, 0)));
        const double half = std::tan(radians(view.fovy) / 2);
        right_ = half * width / height * right;
        up_ = half * glm::cross(right, forward_);
    }
    // (0, 0) is the picture's upper left corner.
    Ray through(const vec2& pixel) const {
        return {eye_, forward_ + (2 * pixel.x / width_ - 1) * right_ + (1 - 2 * pixel.y / height_) * up_};
    }
    // Half a pixel, at a distance of 1
    double spread() const { return glm::length(up_) / height_; }

  private:
    vec3 eye_, forward_{0}, right_{0}, up_{0};
    int width_, height_;
};

// A sample of the picture. Where glass is met, which is where wavelengths part, it is traced for each of them.
Traced traceSample(const TracePicture::Plan& plan, const Ray& ray, double spread, const LampPlace& place) {
    Traced all = traceRay(plan.scene, ray, spread, place, plan.options);
    if (plan.colors.empty() || !all.glass) return all;
    all.light = vec3(0);
    all.cut = 0;
    for (const TracePicture::Colored& color : plan.colors) {
        const Traced one = traceRay(color.scene, ray, spread, place, plan.options);
        all.light += color.share * one.light;
        all.cut += one.cut / double(plan.colors.size());
        all.rays += one.rays;
    }
    return all;
}

// In sRGB, with light above 1 as white.
Pixel pixelOf(const vec3& light) {
    const auto byte = [](double value) {
        return static_cast<std::uint8_t>(std::lround(255 * srgbFromLinear(std::clamp(value, 0.0, 1.0))));
    };
    return {byte(light.x), byte(light.y), byte(light.z)};
}

}  // namespace

TracedScene tracedRoom(TracedRoom room, double lampSize, double index, std::shared_ptr<const TriangleFinder> mesh,
                       double turn) {
    TracedScene scene;
    if (room == TracedRoom::white) {
        scene.ambient = vec3(0);
        scene.skyBelow = scene.skyAbove = vec3(1);
        scene.balls = {{{-1.2, 1, 0}, 1, {.color = vec3(1), .mirrored = 1}}, {{1.2, 1, 0}, 1, {.index = index}}};
        return scene;
    }
    if (room == TracedRoom::glassBall) {
        scene.ambient = vec3(1);
        scene.floor = TracedScene::Floor{0, 0.8, {.color = vec3(0.9)}, {.color = vec3(0.03)}};
        scene.balls = {{{0.2, 1.25, 2.6}, 1, {.index = index}}};
        return scene;
    }
    scene.lamps = {{{-2.5, 5.5, 3}, {lampSize, 0, 0}, {0, 0, lampSize}, vec3(0.85)}};
    scene.ambient = vec3(0.18);
    if (room == TracedRoom::globes) {
        const Surface grey{.color = vec3(0.45)};
        scene.floor = TracedScene::Floor{0, 1, grey, grey};
        const auto texture = std::make_shared<const BallTexture>(globeTexture(turn));
        scene.balls = {{{-0.75, 1.2, 0}, 1.2, {}, texture},
                       {{1.35, 0.3, 1.3}, 0.3, {}, texture},
                       {{1.35, 0.8, -0.7}, 0.8, {.color = vec3(0.9), .mirrored = 0.92}}};
        return scene;
    }
    if (room == TracedRoom::softShadow || room == TracedRoom::lamp || room == TracedRoom::strips) {
        const Surface grey{.color = vec3(0.8)};
        if (room == TracedRoom::strips) {
            scene.mesh = std::move(mesh);
            scene.meshSurface = grey;
        } else {
            scene.floor = TracedScene::Floor{0, 1, grey, grey};
        }
        if (room != TracedRoom::lamp) scene.balls = {{{0, 1.4, 0}, 1, {.color = vec3(0.75, 0.35, 0.25)}}};
        return scene;
    }
    scene.floor = TracedScene::Floor{
        0, 0.8, {.color = vec3(0.85), .mirrored = 0.06}, {.color = vec3(0.06, 0.06, 0.08), .mirrored = 0.12}};
    if (room == TracedRoom::teapot) {
        scene.balls = {{{-1.7, 1, -1.2}, 1, {.color = vec3(0.9), .mirrored = 0.92}}};
        scene.mesh = std::move(mesh);
        scene.meshSurface = {.color = vec3(0.85, 0.45, 0.2), .mirrored = 0.08};
        return scene;
    }
    scene.balls = {{{-1.35, 1, -0.6}, 1, {.color = vec3(0.9), .mirrored = 0.92}},
                   {{0.75, 0.8, 0.75}, 0.8, {.index = index}},
                   {{1.75, 0.6, -1.1}, 0.6, {.color = vec3(0.85, 0.18, 0.12)}},
                   {{-0.15, 0.3, 1.35}, 0.3, {.color = vec3(0.95, 0.65, 0.1), .mirrored = 0.05}},
                   {{0.1, 0.45, -1.9}, 0.45, {.color = vec3(0.15, 0.5, 0.3)}}};
    return scene;
}

void TracePicture::pass(const Plan& plan, int number) {
    std::atomic<long> cast = 0;
    const Lens lens(plan.view, plan.width, plan.height);
    if (number == 0) {
        width_ = plan.width;
        height_ = plan.height;
        const auto pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
        sum_.assign(pixels, vec3(0));
        shown_.assign(pixels, vec3(0));
        cutSum_.assign(pixels, 0);
        cut_.assign(pixels, 0);
        raysSum_.assign(pixels, 0);
        raysAt_.assign(pixels, 0);
        developed_ = Picture(width_, height_);
        rays_ = 0;
    }
    if (number < coarsePasses) {
        // One ray a block, through its middle
        const int side = 16 >> number;
        const auto blocks = [side](int length) { return (length + side - 1) / side; };
        inRows(blocks(height_), plan.threads, [&](int row) {
            long rays = 0;
            for (int column = 0; column < blocks(width_); ++column) {
                const vec2 middle = double(side) * (vec2(column, row) + 0.5);
                const Traced traced = traceSample(plan, lens.through(middle), side * lens.spread(), vec2(0));
                rays += traced.rays;
                const Pixel seen = pixelOf(traced.light);
                for (int y = row * side; y < std::min(height_, (row + 1) * side); ++y) {
                    for (int x = column * side; x < std::min(width_, (column + 1) * side); ++x) {
                        shown_[pixelIndex(x, y, width_)] = traced.light;
                        cut_[pixelIndex(x, y, width_)] = traced.cut;
                        raysAt_[pixelIndex(x, y, width_)] = double(traced.rays);
                        developed_.set(x, y, seen);
                    }
                }
            }
            cast += rays;
        });
        rays_ += cast;
        return;
    }
    const int bands = bandsOf(width_, height_), sample = (number - coarsePasses) / bands,
              band = (number - coarsePasses) % bands;
    const int first = height_ * band / bands, end = height_ * (band + 1) / bands;
    // Each sample stands for its part of the pixel
    const double spread = lens.spread() / std::sqrt(plan.samples);
    inRows(end - first, plan.threads, [&](int index) {
        const int row = first + index;
        long rays = 0;
        for (int x = 0; x < width_; ++x) {
            const std::size_t pixel = pixelIndex(x, row, width_);
            const auto [within, onLamp] =
                samplePoints(plan.pattern, sample, plan.samples, static_cast<std::uint32_t>(pixel), plan.seed);
            const Traced traced = traceSample(plan, lens.through(vec2(x, row) + within), spread, 2.0 * onLamp - 1.0);
            rays += traced.rays;
            sum_[pixel] += traced.light;
            cutSum_[pixel] += traced.cut;
            raysSum_[pixel] += double(traced.rays);
            shown_[pixel] = sum_[pixel] / double(sample + 1);
            cut_[pixel] = cutSum_[pixel] / (sample + 1);
            raysAt_[pixel] = raysSum_[pixel] / (sample + 1);
            developed_.set(x, row, pixelOf(shown_[pixel]));
        }
        cast += rays;
    });
    rays_ += cast;
}

double halved(double fovy) { return 2 * degrees(std::atan(std::tan(radians(fovy) / 2) / 2)); }

std::vector<Ray> raysThrough(const TracePicture::Plan& plan) {
    const Lens lens(plan.view, plan.width, plan.height);
    std::vector<Ray> rays;
    for (int y = 0; y < plan.height; ++y) {
        for (int x = 0; x < plan.width; ++x) rays.push_back(lens.through(vec2(x, y) + 0.5));
    }
    return rays;
}

Picture developed(const std::vector<vec3>& light, int width, int height) {
    Picture picture(width, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) picture.set(x, y, pixelOf(light[pixelIndex(x, y, width)]));
    }
    return picture;
}

}  // namespace mv

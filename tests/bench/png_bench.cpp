#include <cstdint>
#include <string>

#include "bench/bench_pictures.h"
#include "bench/benches.h"
#include "mv/error.h"
#include "mv/image/png.h"

#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#define STBI_WRITE_NO_STDIO
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace mv::bench {
namespace {

constexpr double timeBound = 0.25;
constexpr double sizeBound = 1.15;

std::size_t stbSize(const Picture& picture, int channels, const std::vector<std::uint8_t>& values) {
    std::vector<std::uint8_t> bytes;
    const auto append = [](void* context, void* data, int size) {
        const auto* begin = static_cast<const std::uint8_t*>(data);
        auto* target = static_cast<std::vector<std::uint8_t>*>(context);
        target->insert(target->end(), begin, begin + size);
    };
    if (stbi_write_png_to_func(append, &bytes, picture.width, picture.height, channels, values.data(), 0) == 0)
        throw Error("stbi_write_png_to_func", "must be able to encode the picture");
    return bytes.size();
}

// The rival gets the picture without its alpha channel, already packed: it has less to do than encodePng, which finds
// out by itself that every pixel is opaque, and packs.
std::vector<std::uint8_t> withoutAlpha(const Picture& picture) {
    std::vector<std::uint8_t> rgb;
    rgb.reserve(picture.rgba.size() / 4 * 3);
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4)
        rgb.insert(rgb.end(), {picture.rgba[i], picture.rgba[i + 1], picture.rgba[i + 2]});
    return rgb;
}

void measure(std::vector<Row>& rows, const std::string& name, const Picture& picture, int rounds) {
    const std::vector<std::uint8_t> rgb = withoutAlpha(picture);
    std::size_t ours = 0;
    std::size_t theirs = 0;
    const Ratio time =
        interleaved([&] { ours = encodePng(picture).size(); }, [&] { theirs = stbSize(picture, 3, rgb); }, rounds);
    Ratio size;
    size.median = static_cast<double>(ours) / static_cast<double>(theirs);
    rows.push_back({"png time / stb, " + name, time, timeBound});
    rows.push_back({"png size / stb, " + name, size, sizeBound});
}

}  // namespace

std::vector<Row> pngBench(int rounds) {
    std::vector<Row> rows;
    measure(rows, "rendered 1280x720", renderedLike(1280, 720), rounds);
    measure(rows, "flat cube 512x512", flatCube(512), rounds);
    return rows;
}

}  // namespace mv::bench

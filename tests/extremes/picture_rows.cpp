// X40, X42, X43: pictures: files that cannot be written or are cut off, and sizes that cannot be.
#include <cstring>
#include <filesystem>
#include <fstream>

#include "extremes/measure.h"
#include "extremes/row.h"
#include "mv/image/compare.h"
#include "mv/image/load.h"
#include "mv/image/png.h"
#include "mv/math/projection.h"
#include "support/random.h"
#include "support/temporary_folder.h"

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_NO_STDIO
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STB_IMAGE_WRITE_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

using namespace mv;
using namespace mv::test;

namespace {

Picture noise(int width, int height) {
    Picture picture(width, height);
    Random random(40);
    for (auto& value : picture.rgba) value = static_cast<std::uint8_t>(random.number(0, 256));
    for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 255;
    return picture;
}

[[maybe_unused]] const bool x40 = addRow([] {
    double naive = 0, ours = 0;
    for (const int side : {4, 64, 512}) {
        const Picture picture = noise(side, side);
        naive += stbi_write_png("/dev/full", side, side, 4, picture.rgba.data(), 4 * side) != 0 ? 1 : 0;
        ours += accepted([&] { writePng("/dev/full", picture); });
    }
    return Row{.id = "X40 full disk",
               .input = "pictures of 4, 64 and 512 pixels' side onto a full disk",
               .measured = "failures reported as success",
               .naive = "stbi_write_png",
               .naiveError = naive,
               .ours = "writePng: closing is checked, too",
               .ourError = ours,
               .tolerance = 0,
               .reason = "a picture is written or it is not"};
});

[[maybe_unused]] const bool x40partial = addRow([] {
    // A name that is taken by a folder, a missing folder, and a picture that fails half-way: what is left behind?
    double naive = 0, ours = 0;
    Picture broken = noise(64, 64);
    broken.rgba.resize(broken.rgba.size() / 2);
    {
        const TemporaryFolder folder;
        std::ofstream stream(folder.file("a.png"), std::ios::binary);  // opened first, then found to be impossible
        naive += static_cast<double>(folder.entries());
    }
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "taken.png");
    ours += accepted([&] { writePng(folder / "a.png", broken); });
    ours += accepted([&] { writePng(folder / "taken.png", noise(4, 4)); });
    ours += accepted([&] { writePng(folder / "missing" / "a.png", noise(4, 4)); });
    ours += static_cast<double>(folder.entries() - 1);
    return Row{.id = "X40 partial",
               .input = "a picture that cannot be encoded, a name that is a folder's, a folder that is missing",
               .measured = "files left behind, or failures not reported",
               .naive = "open the file, then encode",
               .naiveError = naive,
               .ours = "writePng: a temporary file, renamed at the end",
               .ourError = ours,
               .tolerance = 0,
               .reason = "no half-written file"};
});

[[maybe_unused]] const bool x42 = addRow([] {
    const Picture picture = noise(24, 24);
    const std::vector<std::byte> file = encodePng(picture);
    double naive = 0, ours = 0;
    for (std::size_t i = 8; i < file.size(); ++i) {  // after the signature
        std::vector<std::byte> damaged = file;
        damaged[i] ^= std::byte{1};
        int width = 0, height = 0, channels = 0;
        stbi_uc* decoded = stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(damaged.data()),
                                                 static_cast<int>(damaged.size()), &width, &height, &channels, 4);
        naive += decoded != nullptr ? 1 : 0;
        stbi_image_free(decoded);
        ours += accepted([&] { (void)decodePicture(damaged, "damaged"); });
    }
    return Row{.id = "X42",
               .input = "a PNG of 24x24 pixels with one bit turned over, in each of its bytes in turn",
               .measured = "damaged files shown as pictures",
               .naive = "stbi_load_from_memory: checksums are not read",
               .naiveError = naive,
               .ours = "decodePicture",
               .ourError = ours,
               .tolerance = 0,
               .reason = "what was not in the file cannot be shown"};
});

[[maybe_unused]] const bool x43 = addRow([] {
    struct Size {
        int width, height;
        bool possible;
    };
    double naive = 0, ours = 0;
    for (const Size& size : {Size{0, 0, false}, Size{0, 480, false}, Size{640, 0, false}, Size{-1, 480, false},
                             Size{1, 1, true}, Size{16384, 16, true}, Size{16385, 16, false}}) {
        // gluPerspective's first element, and the bytes that a careless program asks for.
        const double element = 1 / std::tan(radians(25)) / (static_cast<double>(size.width) / size.height);
        const bool looksPossible = std::isfinite(element) && element != 0 && size.width * size.height * 4 > 0;
        naive += looksPossible == size.possible ? 0 : 1;
        const double drawn = accepted([&] {
            const Picture picture(size.width, size.height);
            (void)perspective(50, static_cast<double>(size.width) / size.height, 1, 500);
        });
        ours += (drawn > 0) == size.possible ? 0 : 1;
    }
    return Row{.id = "X43",
               .input = "7 sizes: 0x0, 0x480, 640x0, -1x480, 1x1, 16384x16, 16385x16",
               .measured = "sizes wrongly refused, or accepted",
               .naive = "aspect = width/height and the bytes, unchecked",
               .naiveError = naive,
               .ours = "Picture and perspective: each an Error in words",
               .ourError = ours,
               .tolerance = 0,
               .reason = "16384 is the side that drivers have"};
});

// The mean difference of two large pictures that are one level apart everywhere is 1.
[[maybe_unused]] const bool y05 = addRow([] {
    Picture a(4096, 2048), b(4096, 2048);
    std::memset(b.rgba.data(), 1, b.rgba.size());
    float sum = 0;
    for (std::size_t i = 0; i < a.rgba.size(); ++i) sum += static_cast<float>(b.rgba[i] - a.rgba[i]);
    return Row{.id = "Y05",
               .input = "two pictures of 4096x2048 pixels, one level apart in every channel",
               .measured = "error of their mean difference (in levels)",
               .naive = "a sum in float: it stands still at 2^24",
               .naiveError = std::abs(static_cast<double>(sum) / static_cast<double>(a.rgba.size()) - 1),
               .ours = "compare",
               .ourError = std::abs(compare(a, b).mean - 1),
               .tolerance = 1e-12,
               .reason = "a sum of 3e7 whole numbers is exact in double; one division follows"};
});

}  // namespace

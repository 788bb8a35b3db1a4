#include "mv/image/compare.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "mv/error.h"

namespace mv {
namespace {

std::string sizeText(int width, int height) { return std::to_string(width) + " x " + std::to_string(height); }

template <typename AnyPicture>
void checkPair(const AnyPicture& a, const AnyPicture& b, std::string_view subject) {
    checkPicture(a, subject);
    checkPicture(b, subject);
    if (a.width == b.width && a.height == b.height) return;
    throw Error(subject, "both pictures must have the same size",
                sizeText(a.width, a.height) + " and " + sizeText(b.width, b.height));
}

void checkFinite(const FloatPicture& picture) {
    for (std::size_t i = 0; i < picture.values.size(); ++i) {
        if (std::isfinite(picture.values[i])) continue;
        const std::size_t pixel = i / static_cast<std::size_t>(picture.channels);
        const auto width = static_cast<std::size_t>(picture.width);
        throw Error("compare", "every value must be finite",
                    numberText(static_cast<double>(picture.values[i])) + " at column " + std::to_string(pixel % width) +
                        ", row " + std::to_string(pixel / width));
    }
}

// From the sums over all values to the figures. Equal pictures have an infinite psnr, which log10 gives by itself,
// but by a division by zero that the sanitizers would report.
Difference summary(double maximum, double sum, double squares, std::size_t values, long beyond, std::size_t pixels,
                   double peak) {
    Difference result;
    result.maximum = maximum;
    result.mean = sum / static_cast<double>(values);
    result.rmse = std::sqrt(squares / static_cast<double>(values));
    result.psnr = result.rmse > 0 ? 20 * std::log10(peak / result.rmse) : std::numeric_limits<double>::infinity();
    result.fraction = static_cast<double>(beyond) / static_cast<double>(pixels);
    result.beyond = beyond;
    return result;
}

int distance(std::uint8_t a, std::uint8_t b) { return std::abs(int{a} - int{b}); }

// Largest difference of any channel of the pixel whose first byte is at `offset`.
int pixelDistance(const Picture& a, const Picture& b, std::size_t offset) {
    int largest = 0;
    for (std::size_t c = offset; c < offset + 4; ++c) largest = std::max(largest, distance(a.rgba[c], b.rgba[c]));
    return largest;
}

}  // namespace

Difference compare(const Picture& a, const Picture& b, int threshold) {
    checkPair(a, b, "compare");
    if (threshold < 0 || threshold > 255)
        throw Error("compare", "threshold must lie in 0..255 levels", std::to_string(threshold));

    // The sums are integers, hence exact: the order of the pixels cannot matter. At most 2^30 * 255^2 < 2^46.
    int maximum = 0;
    long beyond = 0;
    std::uint64_t sum = 0;
    std::uint64_t squares = 0;
    for (std::size_t offset = 0; offset < a.rgba.size(); offset += 4) {
        const int largest = pixelDistance(a, b, offset);
        if (largest == 0) continue;
        maximum = std::max(maximum, largest);
        if (largest > threshold) ++beyond;
        for (std::size_t c = offset; c < offset + 4; ++c) {
            const auto apart = static_cast<std::uint64_t>(distance(a.rgba[c], b.rgba[c]));
            sum += apart;
            squares += apart * apart;
        }
    }
    return summary(maximum, static_cast<double>(sum), static_cast<double>(squares), a.rgba.size(), beyond,
                   a.rgba.size() / 4, 255);
}

Difference compare(const FloatPicture& a, const FloatPicture& b, double threshold, double peak) {
    checkPair(a, b, "compare");
    if (a.channels != b.channels) {
        throw Error("compare", "both pictures must have the same number of channels",
                    std::to_string(a.channels) + " and " + std::to_string(b.channels));
    }
    if (!std::isfinite(threshold) || threshold < 0)
        throw Error("compare", "threshold must be finite and not negative", numberText(threshold));
    if (!std::isfinite(peak) || peak <= 0) throw Error("compare", "peak must be finite and positive", numberText(peak));
    checkFinite(a);
    checkFinite(b);

    double maximum = 0;
    double sum = 0;
    double squares = 0;
    long beyond = 0;
    const auto channels = static_cast<std::size_t>(a.channels);
    for (std::size_t offset = 0; offset < a.values.size(); offset += channels) {
        double largest = 0;
        for (std::size_t c = offset; c < offset + channels; ++c) {
            const double apart = std::abs(static_cast<double>(a.values[c]) - static_cast<double>(b.values[c]));
            largest = std::max(largest, apart);
            sum += apart;
            squares += apart * apart;
        }
        maximum = std::max(maximum, largest);
        if (largest > threshold) ++beyond;
    }
    return summary(maximum, sum, squares, a.values.size(), beyond, a.values.size() / channels, peak);
}

Picture differenceOutline(const Picture& a, const Picture& b, int width) {
    checkPair(a, b, "differenceOutline");
    if (width < 1 || width > 16) throw Error("differenceOutline", "the width must be 1 .. 16", std::to_string(width));
    const int w = a.width, h = a.height;
    const auto place = [&](int x, int y) {
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(w) + static_cast<std::size_t>(x);
    };
    std::vector<char> differs(a.rgba.size() / 4);
    for (std::size_t i = 0; i < differs.size(); ++i) differs[i] = pixelDistance(a, b, 4 * i) > 0 ? 1 : 0;

    // A pixel lies at the edge where another one within the width is of the other kind. Look along rows, and then along columns
    // of what the rows found: a square of pixels
    const auto near = [&](const std::vector<char>& of, bool along, char outside) {
        std::vector<char> found(of.size());
        for (int y = 0; y < h; ++y) {
            for (int x = 0; x < w; ++x) {
                for (int k = -width; k <= width; ++k) {
                    const int i = along ? x + k : x, j = along ? y : y + k;
                    const bool isIn = i >= 0 && j >= 0 && i < w && j < h;
                    if ((isIn ? of[place(i, j)] : outside) != 0) found[place(x, y)] = 1;
                }
            }
        }
        return found;
    };
    std::vector<char> same;
    for (const char one : differs) same.push_back(one == 0 ? 1 : 0);
    const std::vector<char> nearSame = near(near(same, true, 1), false, 1),
                            nearDiffering = near(near(differs, true, 0), false, 0);
    Picture result(w, h);
    for (int y = 0; y < h; ++y) {
        for (int x = 0; x < w; ++x) {
            const std::size_t i = place(x, y);
            if (differs[i] != 0 && nearSame[i] != 0) result.set(x, y, {255, 210, 0, 255});
            if (differs[i] == 0 && nearDiffering[i] != 0) result.set(x, y, {0, 0, 0, 255});
        }
    }
    return result;
}

Picture differencePicture(const Picture& a, const Picture& b) {
    checkPair(a, b, "differencePicture");
    Picture result(a.width, a.height);
    for (std::size_t offset = 0; offset < a.rgba.size(); offset += 4) {
        std::uint8_t* pixel = result.rgba.data() + offset;
        const int apart = pixelDistance(a, b, offset);
        if (apart > 0) {
            pixel[0] = 255;
            pixel[1] = static_cast<std::uint8_t>(96 + (255 - 96) * apart / 255);
            pixel[2] = 0;
        } else {
            // Luma by the weights of Rec. 709 in thousandths, and 30 % of it: 255 * 1000 * 3 / 10000 = 76.
            const int luma = 213 * a.rgba[offset] + 715 * a.rgba[offset + 1] + 72 * a.rgba[offset + 2];
            std::fill_n(pixel, 3, static_cast<std::uint8_t>(luma * 3 / 10000));
        }
        pixel[3] = 255;
    }
    return result;
}

}  // namespace mv

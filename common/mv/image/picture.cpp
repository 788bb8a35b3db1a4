#include "mv/image/picture.h"

#include <algorithm>
#include <string>

#include "mv/error.h"

namespace mv {
namespace {

void checkSide(std::string_view subject, std::string_view what, int side) {
    if (side >= 1 && side <= maximumPictureSide) return;
    throw Error(subject, std::string(what) + " must lie in 1.." + std::to_string(maximumPictureSide),
                std::to_string(side));
}

void checkChannels(std::string_view subject, int channels) {
    if (channels < 1 || channels > 4) throw Error(subject, "channels must lie in 1..4", std::to_string(channels));
}

std::size_t valueCount(int width, int height, int channels) {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * static_cast<std::size_t>(channels);
}

void checkCount(std::string_view subject, std::size_t expected, std::size_t actual) {
    if (expected == actual) return;
    throw Error(subject, "must hold width * height * channels = " + std::to_string(expected) + " values",
                std::to_string(actual));
}

std::size_t pixelOffset(const Picture& picture, int x, int y) {
    if (x < 0 || x >= picture.width)
        throw Error("Picture", "x must lie in 0.." + std::to_string(picture.width - 1), std::to_string(x));
    if (y < 0 || y >= picture.height)
        throw Error("Picture", "y must lie in 0.." + std::to_string(picture.height - 1), std::to_string(y));
    return valueCount(picture.width, y, 4) + static_cast<std::size_t>(x) * 4;
}

template <typename Value>
void flip(std::vector<Value>& values, int width, int height, int channels) {
    const std::size_t row = valueCount(width, 1, channels);
    for (int top = 0, bottom = height - 1; top < bottom; ++top, --bottom) {
        Value* upper = values.data() + row * static_cast<std::size_t>(top);
        Value* lower = values.data() + row * static_cast<std::size_t>(bottom);
        std::swap_ranges(upper, upper + row, lower);
    }
}

// Which source pixels a result pixel covers along one axis, and how much of each. Lengths are counted in units of
// 1/to of a source pixel, which makes every one of them an integer and their sum `from`.
struct Span {
    int first = 0;
    std::vector<std::uint64_t> weights;
};

std::vector<Span> coverage(int from, int to) {
    std::vector<Span> spans(static_cast<std::size_t>(to));
    for (int i = 0; i < to; ++i) {
        const std::int64_t begin = std::int64_t{i} * from;
        const std::int64_t end = begin + from;
        Span& span = spans[static_cast<std::size_t>(i)];
        span.first = static_cast<int>(begin / to);
        for (std::int64_t left = std::int64_t{span.first} * to; left < end; left += to)
            span.weights.push_back(static_cast<std::uint64_t>(std::min(end, left + to) - std::max(begin, left)));
    }
    return spans;
}

std::uint8_t roundedQuotient(std::uint64_t sum, std::uint64_t weight) {
    return static_cast<std::uint8_t>((sum + weight / 2) / weight);
}

// The mean over columns x rows. The largest sum is 16384^2 * 255 * 255 < 2^45.
Pixel meanPixel(const Picture& picture, const Span& columns, const Span& rows) {
    std::uint64_t area = 0;
    std::uint64_t opacity = 0;
    std::array<std::uint64_t, 3> colour{};
    for (std::size_t j = 0; j < rows.weights.size(); ++j) {
        const std::uint8_t* value = picture.rgba.data() +
                                    valueCount(picture.width, rows.first + static_cast<int>(j), 4) +
                                    static_cast<std::size_t>(columns.first) * 4;
        for (const std::uint64_t columnWeight : columns.weights) {
            const std::uint64_t weight = columnWeight * rows.weights[j];
            const std::uint64_t opaqueWeight = weight * value[3];
            area += weight;
            opacity += opaqueWeight;
            for (std::size_t c = 0; c < 3; ++c) colour[c] += opaqueWeight * value[c];
            value += 4;
        }
    }
    if (opacity == 0) return {0, 0, 0, 0};
    return {roundedQuotient(colour[0], opacity), roundedQuotient(colour[1], opacity),
            roundedQuotient(colour[2], opacity), roundedQuotient(opacity, area)};
}

// side * part / whole to the nearest integer, never below 1.
int scaledSide(int side, int part, int whole) {
    const std::int64_t scaled = (2 * std::int64_t{side} * part + whole) / (2 * std::int64_t{whole});
    return static_cast<int>(std::max<std::int64_t>(1, scaled));
}

}  // namespace

Picture::Picture(int pictureWidth, int pictureHeight) : width(pictureWidth), height(pictureHeight) {
    checkSide("Picture", "width", width);
    checkSide("Picture", "height", height);
    rgba.resize(valueCount(width, height, 4));
}

Pixel Picture::at(int x, int y) const {
    const std::uint8_t* value = rgba.data() + pixelOffset(*this, x, y);
    return {value[0], value[1], value[2], value[3]};
}

void Picture::set(int x, int y, Pixel pixel) {
    std::uint8_t* value = rgba.data() + pixelOffset(*this, x, y);
    value[0] = pixel.red;
    value[1] = pixel.green;
    value[2] = pixel.blue;
    value[3] = pixel.alpha;
}

FloatPicture::FloatPicture(int pictureWidth, int pictureHeight, int pictureChannels)
    : width(pictureWidth), height(pictureHeight), channels(pictureChannels) {
    checkSide("FloatPicture", "width", width);
    checkSide("FloatPicture", "height", height);
    checkChannels("FloatPicture", channels);
    values.resize(valueCount(width, height, channels));
}

void checkPicture(const Picture& picture, std::string_view subject) {
    checkSide(subject, "width", picture.width);
    checkSide(subject, "height", picture.height);
    checkCount(subject, valueCount(picture.width, picture.height, 4), picture.rgba.size());
}

void checkPicture(const FloatPicture& picture, std::string_view subject) {
    checkSide(subject, "width", picture.width);
    checkSide(subject, "height", picture.height);
    checkChannels(subject, picture.channels);
    checkCount(subject, valueCount(picture.width, picture.height, picture.channels), picture.values.size());
}

void flipRows(Picture& picture) {
    checkPicture(picture, "flipRows");
    flip(picture.rgba, picture.width, picture.height, 4);
}

void flipRows(FloatPicture& picture) {
    checkPicture(picture, "flipRows");
    flip(picture.values, picture.width, picture.height, picture.channels);
}

Picture shrink(const Picture& picture, int maximumWidth, int maximumHeight) {
    checkPicture(picture, "shrink");
    checkSide("shrink", "maximumWidth", maximumWidth);
    checkSide("shrink", "maximumHeight", maximumHeight);
    if (picture.width <= maximumWidth && picture.height <= maximumHeight) return picture;

    // The side that needs the stronger reduction decides: the smaller of maximumWidth/width and maximumHeight/height.
    const bool widthDecides =
        std::int64_t{maximumWidth} * picture.height <= std::int64_t{maximumHeight} * picture.width;
    const int part = widthDecides ? maximumWidth : maximumHeight;
    const int whole = widthDecides ? picture.width : picture.height;
    Picture result(scaledSide(picture.width, part, whole), scaledSide(picture.height, part, whole));

    const std::vector<Span> columns = coverage(picture.width, result.width);
    const std::vector<Span> rows = coverage(picture.height, result.height);
    for (int y = 0; y < result.height; ++y) {
        for (int x = 0; x < result.width; ++x) {
            result.set(x, y,
                       meanPixel(picture, columns[static_cast<std::size_t>(x)], rows[static_cast<std::size_t>(y)]));
        }
    }
    return result;
}

}  // namespace mv

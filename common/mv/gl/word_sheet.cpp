#include "mv/gl/word_sheet.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mv/error.h"
#include "mv/gl/font.h"

#define STB_TRUETYPE_IMPLEMENTATION
#define STBTT_STATIC
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <stb/stb_truetype.h>
#pragma GCC diagnostic pop

namespace mv {
namespace {

const stbtt_fontinfo& font() {
    static const stbtt_fontinfo info = [] {
        stbtt_fontinfo made;
        const auto bytes = reinterpret_cast<const unsigned char*>(fontFile().data());
        if (!stbtt_InitFont(&made, bytes, 0)) throw Error("font", "must be a TrueType file");
        return made;
    }();
    return info;
}

// The characters of UTF-8 text; a malformed byte becomes U+FFFD, which the font shows as a question mark in a box.
std::vector<int> codePoints(std::string_view text) {
    std::vector<int> points;
    for (std::size_t i = 0; i < text.size();) {
        const auto first = static_cast<unsigned char>(text[i++]);
        int more = first < 0x80 ? 0 : (first >> 5) == 6 ? 1 : (first >> 4) == 14 ? 2 : (first >> 3) == 30 ? 3 : -1;
        if (more < 0) {
            points.push_back(0xFFFD);
            continue;
        }
        int point = more == 0 ? first : first & (0x3F >> more);
        for (; more > 0 && i < text.size() && (static_cast<unsigned char>(text[i]) >> 6) == 2; --more) {
            point = point << 6 | (static_cast<unsigned char>(text[i++]) & 0x3F);
        }
        points.push_back(more == 0 ? point : 0xFFFD);
    }
    return points;
}

struct Placed {
    int glyph;
    double x;  // of the pen, pixels
};

// The place of each glyph on a line, and the width of the line.
std::vector<Placed> layOut(std::string_view text, double pixelsPerUnit, double& width) {
    std::vector<Placed> line;
    width = 0;
    int previous = 0;
    for (const int point : codePoints(text)) {
        const int glyph = stbtt_FindGlyphIndex(&font(), point);
        int advance = 0, bearing = 0;
        stbtt_GetGlyphHMetrics(&font(), glyph, &advance, &bearing);
        if (previous != 0) width += stbtt_GetGlyphKernAdvance(&font(), previous, glyph) * pixelsPerUnit;
        // Whole pixels: letters of one word then all look alike.
        line.push_back({glyph, std::round(width)});
        width += advance * pixelsPerUnit;
        previous = glyph;
    }
    return line;
}

}  // namespace

Coverage coverageOf(std::string_view text, int height) {
    const float pixelsPerUnit = stbtt_ScaleForPixelHeight(&font(), static_cast<float>(height));
    int ascent = 0, descent = 0, gap = 0;
    stbtt_GetFontVMetrics(&font(), &ascent, &descent, &gap);
    const int baseline = static_cast<int>(std::lround(double(ascent) * double(pixelsPerUnit)));
    double lineWidth = 0;
    const std::vector<Placed> line = layOut(text, pixelsPerUnit, lineWidth);
    Coverage words(static_cast<int>(std::ceil(lineWidth)) + 2 * wordPadding, height + 2 * wordPadding);
    for (const Placed& placed : line) {
        int glyphWidth = 0, glyphHeight = 0, left = 0, top = 0;
        unsigned char* bitmap = stbtt_GetGlyphBitmap(&font(), pixelsPerUnit, pixelsPerUnit, placed.glyph, &glyphWidth,
                                                     &glyphHeight, &left, &top);
        const int x0 = wordPadding + static_cast<int>(placed.x) + left, y0 = wordPadding + baseline + top;
        for (int y = std::max(0, -y0); y < std::min(glyphHeight, words.height - y0); ++y) {
            std::uint8_t* row = words.row(y0 + y);
            for (int x = std::max(0, -x0); x < std::min(glyphWidth, words.width - x0); ++x) {
                row[x0 + x] = std::max(row[x0 + x], bitmap[y * glyphWidth + x]);
            }
        }
        stbtt_FreeBitmap(bitmap, nullptr);
    }
    return words;
}

WordSheet sheetOf(std::span<Coverage> lines) {
    constexpr int usualWidth = 512;  // a wider line stands by itself
    int width = 0, x = 0, y = 0, tallest = 0;
    std::vector<glm::ivec2> places;
    places.reserve(lines.size());
    for (const Coverage& line : lines) {
        if (x > 0 && x + line.width > usualWidth) {
            x = 0;
            y += tallest;
            tallest = 0;
        }
        places.emplace_back(x, y);
        x += line.width;
        width = std::max(width, x);
        tallest = std::max(tallest, line.height);
    }
    WordSheet sheet{Coverage(width, y + tallest), std::move(places)};
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const glm::ivec2 place = sheet.places[i];
        for (int row = 0; row < lines[i].height; ++row) {
            std::copy_n(lines[i].row(row), lines[i].width, sheet.all.row(place.y + row) + place.x);
        }
    }
    return sheet;
}

int widthOf(std::string_view text, int height) {
    double width = 0;
    layOut(text, stbtt_ScaleForPixelHeight(&font(), static_cast<float>(height)), width);
    return static_cast<int>(std::ceil(width)) + 2 * wordPadding;
}

}  // namespace mv

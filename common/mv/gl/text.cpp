#include "mv/gl/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

#include "mv/error.h"
#include "mv/gl/font.h"
#include "mv/gl/program.h"

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

constexpr int padding = 4;  // pixels between the words and the end of their box

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

// Where each glyph stands on a line, and how wide the line is.
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

std::uint8_t byteOf(double value) { return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0, 1.0) * 255)); }

Picture textPicture(std::string_view text, const TextStyle& style) {
    const float pixelsPerUnit = stbtt_ScaleForPixelHeight(&font(), static_cast<float>(style.height));
    int ascent = 0, descent = 0, gap = 0;
    stbtt_GetFontVMetrics(&font(), &ascent, &descent, &gap);
    const int baseline = static_cast<int>(std::lround(double(ascent) * double(pixelsPerUnit)));
    double lineWidth = 0;
    const std::vector<Placed> line = layOut(text, pixelsPerUnit, lineWidth);
    Picture picture(static_cast<int>(std::ceil(lineWidth)) + 2 * padding, style.height + 2 * padding);

    std::vector<double> coverage(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
    for (const Placed& placed : line) {
        int width = 0, height = 0, left = 0, top = 0;
        unsigned char* bitmap =
            stbtt_GetGlyphBitmap(&font(), pixelsPerUnit, pixelsPerUnit, placed.glyph, &width, &height, &left, &top);
        for (int row = 0; row < height; ++row) {
            for (int column = 0; column < width; ++column) {
                const int x = padding + static_cast<int>(placed.x) + left + column;
                const int y = padding + baseline + top + row;
                if (x < 0 || y < 0 || x >= picture.width || y >= picture.height) continue;
                double& c = coverage[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) +
                                     static_cast<std::size_t>(x)];
                c = std::max(c, bitmap[row * width + column] / 255.0);
            }
        }
        stbtt_FreeBitmap(bitmap, nullptr);
    }
    for (std::size_t i = 0; i < coverage.size(); ++i) {
        // The words over their box: "over" of Porter and Duff, alpha not premultiplied.
        const double front = coverage[i] * style.color.a;
        const double back = style.background.a * (1 - front);
        const double alpha = front + back;
        for (int channel = 0; channel < 3; ++channel) {
            const double mixed =
                alpha > 0 ? (style.color[channel] * front + style.background[channel] * back) / alpha : 0;
            picture.rgba[4 * i + static_cast<std::size_t>(channel)] = byteOf(mixed);
        }
        picture.rgba[4 * i + 3] = byteOf(alpha);
    }
    return picture;
}

struct Quad {
    Program program;
    VertexArray vertexArray;  // without attributes: the corners come from gl_VertexID
};

std::unique_ptr<Quad>& quad() {
    static auto& kept = *new std::unique_ptr<Quad>;  // outlives every static that owns a Stage
    return kept;
}

const char* const quadVertex = R"(
uniform vec4 rectangle;  // left, bottom, right, top in normalized device coordinates
out vec2 coordinate;
void main() {
    coordinate = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    gl_Position = vec4(mix(rectangle.xy, rectangle.zw, coordinate), 0.0, 1.0);
}
)";
const char* const quadFragment = R"(
uniform sampler2D picture;
in vec2 coordinate;
out vec4 fragColor;
void main() { fragColor = texture(picture, coordinate); }
)";

// Sets the state for drawQuad, which is to be called for each picture, and makes its program the current one.
void beginQuads() {
    if (!quad()) {
        quad() = std::make_unique<Quad>();
        quad()->program = Program::fromText("image", quadVertex, quadFragment);
        quad()->vertexArray = makeVertexArray();
    }
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    quad()->program.use();
    quad()->program.set("picture", 0);
    glBindVertexArray(quad()->vertexArray.id());
}

void drawQuad(const Frame& frame, int x, int y, const Picture& picture) {
    const Texture texture(picture, GL_NEAREST, "image");
    quad()->program.set("rectangle", vec4(2.0 * x / frame.width() - 1, 1 - 2.0 * (y + picture.height) / frame.height(),
                                          2.0 * (x + picture.width) / frame.width() - 1, 1 - 2.0 * y / frame.height()));
    texture.bind(0);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void endQuads() { glDisable(GL_BLEND); }

}  // namespace

void drawText(const Frame& frame, int x, int y, std::string_view text, const TextStyle& style) {
    drawText(frame, std::array{TextLine{x, y, std::string(text), style}});
}

void drawText(const Frame& frame, std::span<const TextLine> lines) {
    for (const TextLine& line : lines) {
        const int height = line.style.height;
        if (height < 6 || height > 512) throw Error("drawText", "height must be 6 .. 512 px", std::to_string(height));
    }
    beginQuads();
    for (const TextLine& line : lines) drawQuad(frame, line.x, line.y, textPicture(line.text, line.style));
    endQuads();
}

int textWidth(std::string_view text, const TextStyle& style) {
    double width = 0;
    layOut(text, stbtt_ScaleForPixelHeight(&font(), static_cast<float>(style.height)), width);
    return static_cast<int>(std::ceil(width)) + 2 * padding;
}

std::string rounded(const char* format, double value) {
    std::array<char, 64> text{};
    std::snprintf(text.data(), text.size(), format, value);
    return text.data();
}

int textHeight(const TextStyle& style) { return style.height + 2 * padding; }

void showImage(const Frame& frame, int x, int y, const Picture& picture) {
    beginQuads();
    drawQuad(frame, x, y, picture);
    endQuads();
}

void forgetText() { quad().reset(); }

}  // namespace mv

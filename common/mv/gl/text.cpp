#include "mv/gl/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "mv/error.h"
#include "mv/gl/font.h"
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"
#include "mv/gl/state.h"

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

// How much of each pixel words cover, 0 .. 255; the upper row first, with the padding round them.
struct Coverage {
    int width, height;
    std::vector<std::uint8_t> parts;

    Coverage(int w, int h) : width(w), height(h), parts(static_cast<std::size_t>(w) * static_cast<std::size_t>(h)) {}
    std::uint8_t* row(int y) { return parts.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
};

Coverage coverageOf(std::string_view text, int height) {
    const float pixelsPerUnit = stbtt_ScaleForPixelHeight(&font(), static_cast<float>(height));
    int ascent = 0, descent = 0, gap = 0;
    stbtt_GetFontVMetrics(&font(), &ascent, &descent, &gap);
    const int baseline = static_cast<int>(std::lround(double(ascent) * double(pixelsPerUnit)));
    double lineWidth = 0;
    const std::vector<Placed> line = layOut(text, pixelsPerUnit, lineWidth);
    Coverage words(static_cast<int>(std::ceil(lineWidth)) + 2 * padding, height + 2 * padding);
    for (const Placed& placed : line) {
        int glyphWidth = 0, glyphHeight = 0, left = 0, top = 0;
        unsigned char* bitmap = stbtt_GetGlyphBitmap(&font(), pixelsPerUnit, pixelsPerUnit, placed.glyph, &glyphWidth,
                                                     &glyphHeight, &left, &top);
        const int x0 = padding + static_cast<int>(placed.x) + left, y0 = padding + baseline + top;
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

// The words of several lines beside and under each other, for one texture.
struct Sheet {
    Coverage all;
    std::vector<glm::ivec2> places;  // of the lines' upper left corners
};

Sheet sheetOf(std::span<Coverage> lines) {
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
    Sheet sheet{Coverage(width, y + tallest), std::move(places)};
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const glm::ivec2 place = sheet.places[i];
        for (int row = 0; row < lines[i].height; ++row) {
            std::copy_n(lines[i].row(row), lines[i].width, sheet.all.row(place.y + row) + place.x);
        }
    }
    return sheet;
}

TextureObject uploaded(const Coverage& sheet) {
    TextureObject texture = makeTexture();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture.id());
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, sheet.width, sheet.height, 0, GL_RED, GL_UNSIGNED_BYTE, sheet.parts.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    labelObject(GL_TEXTURE, texture.id(), "words");
    return texture;
}

// Appends a rectangle of the picture, pixels from its upper left corner, that shows the sheet from `texel` on; the color
// alone where there is none.
void append(MeshData& mesh, const Frame& frame, const glm::ivec4& rectangle, const vec4& color,
            const std::optional<glm::ivec2>& texel) {
    for (const glm::ivec2& corner : {glm::ivec2(0, 0), {0, 1}, {1, 1}, {0, 0}, {1, 1}, {1, 0}}) {
        const int right = corner.x * rectangle.z, down = corner.y * rectangle.w;
        mesh.positions.emplace_back(2.0 * (rectangle.x + right) / frame.width() - 1,
                                    1 - 2.0 * (rectangle.y + down) / frame.height(), 0);
        mesh.texCoords.emplace_back(texel ? fvec2(texel->x + right, texel->y + down) : fvec2(-1));
        mesh.colors.emplace_back(color);
    }
}

struct Programs {
    Program image, words;
    VertexArray vertexArray;  // of the image's, without attributes: the corners come from gl_VertexID
};

std::unique_ptr<Programs>& programs() {
    static auto& kept = *new std::unique_ptr<Programs>;  // outlives every static that owns a Stage
    return kept;
}

const char* const wordsVertex = R"(
in vec4 position;
in vec2 texCoord;
in vec4 color;
out vec2 texel;
out vec4 ink;
void main() {
    texel = texCoord;
    ink = color;
    gl_Position = position;
}
)";
const char* const wordsFragment = R"(
uniform sampler2D sheet;
in vec2 texel;
in vec4 ink;
out vec4 fragColor;
void main() {
    float part = texel.x < 0.0 ? 1.0 : texelFetch(sheet, ivec2(texel), 0).r;
    fragColor = vec4(ink.rgb, part * ink.a);
}
)";

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

// Sets the state for what lies over a picture; the caller's comes back with its StateScope.
void setOverlayState() {
    if (!programs()) programs() = std::make_unique<Programs>();
    switchOff(GL_DEPTH_TEST);
    switchOff(GL_CULL_FACE);
    glEnable(GL_BLEND);
    // Alpha by itself, so that an opaque picture stays opaque, saved ones too.
    glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

}  // namespace

void drawText(const Frame& frame, int x, int y, std::string_view text, const TextStyle& style) {
    drawText(frame, std::array{TextLine{x, y, std::string(text), style}});
}

void drawText(const Frame& frame, std::span<const TextLine> lines) {
    if (lines.empty()) return;
    std::vector<Coverage> words;
    words.reserve(lines.size());
    for (const TextLine& line : lines) {
        const int height = line.style.height;
        if (height < 6 || height > 512) throw Error("drawText", "height must be 6 .. 512 px", std::to_string(height));
        words.push_back(coverageOf(line.text, height));
    }
    const Sheet sheet = sheetOf(words);
    MeshData rectangles;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const glm::ivec4 box(lines[i].x, lines[i].y, words[i].width, words[i].height);
        if (lines[i].style.background.a > 0) append(rectangles, frame, box, lines[i].style.background, {});
        append(rectangles, frame, box, lines[i].style.color, sheet.places[i]);
    }
    const StateScope scope;
    setOverlayState();
    Program& program = programs()->words;
    if (program.id() == 0) program = Program::fromText("words", wordsVertex, wordsFragment);
    program.use();
    program.set("sheet", 0);
    const TextureObject texture = uploaded(sheet.all);
    Mesh(rectangles, "words").draw();
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
    const StateScope scope;
    setOverlayState();
    Program& program = programs()->image;
    if (program.id() == 0) {
        program = Program::fromText("image", quadVertex, quadFragment);
        programs()->vertexArray = makeVertexArray();
    }
    program.use();
    program.set("picture", 0);
    program.set("rectangle", vec4(2.0 * x / frame.width() - 1, 1 - 2.0 * (y + picture.height) / frame.height(),
                                  2.0 * (x + picture.width) / frame.width() - 1, 1 - 2.0 * y / frame.height()));
    const Texture texture(picture, GL_NEAREST, "image");
    texture.bind(0);
    glBindVertexArray(programs()->vertexArray.id());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void forgetText() { programs().reset(); }

}  // namespace mv

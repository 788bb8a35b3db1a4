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
#include "mv/gl/mesh.h"
#include "mv/gl/program.h"
#include "mv/gl/state.h"
#include "mv/gl/word_sheet.h"

namespace mv {
namespace {

TextureObject uploaded(const Coverage& sheet) {
    TextureObject texture = makeTexture();
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, texture.id());
    labelObject(GL_TEXTURE, texture.id(), "words");
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, sheet.width, sheet.height, 0, GL_RED, GL_UNSIGNED_BYTE, sheet.parts.data());
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    return texture;
}

// Appends a rectangle of the picture, pixels from its upper left corner, that shows the sheet from `texel` on; the color
// alone where there is none.
void append(MeshData& mesh, const FrameInfo& frame, const glm::ivec4& rectangle, const vec4& color,
            const std::optional<glm::ivec2>& texel) {
    for (const glm::ivec2& corner : {glm::ivec2(0, 0), {0, 1}, {1, 1}, {0, 0}, {1, 1}, {1, 0}}) {
        const int right = corner.x * rectangle.z, down = corner.y * rectangle.w;
        mesh.positions.emplace_back(2.0 * (rectangle.x + right) / frame.width() - 1,
                                    1 - 2.0 * (rectangle.y + down) / frame.height(), 0);
        mesh.texCoords.emplace_back(texel ? fvec2(texel->x + right, texel->y + down) : fvec2(-1));
        mesh.colors.emplace_back(color);
    }
}

// The texture of some words, for whatever lines have just these, and where each line's are in it.
struct Words {
    TextureObject sheet;
    std::vector<glm::ivec2> places, sizes;
};

// The lines that one call has drawn, for as long as calls ask for the same.
struct Drawn {
    std::vector<TextLine> lines;
    glm::ivec2 picture;  // its size
    std::shared_ptr<const Words> words;
    Mesh rectangles;
};

struct Kept {
    Program image, words;
    VertexArray vertexArray;   // of the image's, without attributes: the corners come from gl_VertexID
    std::vector<Drawn> drawn;  // the last ones, those drawn latest at the end
    Picture shown;             // the last image, and its texture
    Texture shownTexture;
};

// Demos write by one to three calls a frame; a window that compares two settings, by those of both and three of its own.
constexpr std::size_t mostDrawn = 16;

std::unique_ptr<Kept>& kept() {
    static auto& all = *new std::unique_ptr<Kept>;  // outlives every static that owns a Stage
    return all;
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
void begin() {
    if (!kept()) kept() = std::make_unique<Kept>();
    setOverlayState();
}

bool sameWords(const std::vector<TextLine>& a, std::span<const TextLine> b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const TextLine& one, const TextLine& other) {
        return one.text == other.text && one.style.height == other.style.height;
    });
}

std::shared_ptr<const Words> wordsOf(std::span<const TextLine> lines) {
    for (const Drawn& drawn : kept()->drawn) {
        if (sameWords(drawn.lines, lines)) return drawn.words;
    }
    std::vector<Coverage> coverages;
    coverages.reserve(lines.size());
    auto words = std::make_shared<Words>();
    for (const TextLine& line : lines) {
        coverages.push_back(coverageOf(line.text, line.style.height));
        words->sizes.emplace_back(coverages.back().width, coverages.back().height);
    }
    WordSheet sheet = sheetOf(coverages);
    words->sheet = uploaded(sheet.all);
    words->places = std::move(sheet.places);
    return words;
}

Mesh rectanglesOf(const FrameInfo& frame, std::span<const TextLine> lines, const Words& words) {
    MeshData rectangles;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const glm::ivec4 box(lines[i].x, lines[i].y, words.sizes[i]);
        const int beyond = lines[i].beyond;
        const glm::ivec4 padded = box + glm::ivec4(-beyond, -beyond, 2 * beyond, 2 * beyond);
        if (lines[i].style.background.a > 0) append(rectangles, frame, padded, lines[i].style.background, {});
        append(rectangles, frame, box, lines[i].style.color, words.places[i]);
    }
    return Mesh(rectangles, "words");
}

// The objects that draw these lines: kept from an earlier call, or made.
const Drawn& drawnOf(const FrameInfo& frame, std::span<const TextLine> lines) {
    std::vector<Drawn>& all = kept()->drawn;
    const glm::ivec2 picture(frame.width(), frame.height());
    const auto found = std::find_if(all.begin(), all.end(), [&](const Drawn& drawn) {
        return drawn.picture == picture &&
               std::equal(drawn.lines.begin(), drawn.lines.end(), lines.begin(), lines.end());
    });
    if (found != all.end()) {
        std::rotate(found, found + 1, all.end());
        return all.back();
    }
    std::shared_ptr<const Words> words = wordsOf(lines);
    Mesh rectangles = rectanglesOf(frame, lines, *words);
    if (all.size() == mostDrawn) all.erase(all.begin());
    all.push_back({{lines.begin(), lines.end()}, picture, std::move(words), std::move(rectangles)});
    return all.back();
}

}  // namespace

void drawText(const FrameInfo& frame, int x, int y, std::string_view text, const TextStyle& style) {
    drawText(frame, std::array{TextLine{x, y, std::string(text), style}});
}

std::vector<TextLine> linesInPixels(const FrameInfo& frame, std::span<const TextLine> lines) {
    std::vector<TextLine> all(lines.begin(), lines.end());
    const vec2 scale = frame.scale();
    for (TextLine& line : all) {
        line.x = int(std::lround((line.x + wordPadding) * scale.x)) - wordPadding;
        line.y = int(std::lround((line.y + wordPadding) * scale.y)) - wordPadding;
        line.style.height = std::max(6, int(std::lround(line.style.height * frame.sizeScale())));
        line.beyond = std::max(0, int(std::lround(wordPadding * (frame.sizeScale() - 1))));
    }
    return all;
}

void drawText(const FrameInfo& frame, std::span<const TextLine> lines) {
    if (lines.empty()) return;
    if (frame.scale() != vec2(1)) return drawText(frame.inPixels(), linesInPixels(frame, lines));
    for (const TextLine& line : lines) {
        const int height = line.style.height;
        if (height < 6 || height > 512) throw Error("drawText", "height must be 6 .. 512 px", std::to_string(height));
    }
    const StateScope scope;
    begin();
    Program& program = kept()->words;
    if (program.id() == 0) program = Program::fromText("words", wordsVertex, wordsFragment);
    program.use();
    program.set("sheet", 0);
    const Drawn& drawn = drawnOf(frame, lines);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, drawn.words->sheet.id());
    drawn.rectangles.draw();
}

int textWidth(std::string_view text, const TextStyle& style) { return widthOf(text, style.height); }

int textHeight(const TextStyle& style) { return style.height + 2 * wordPadding; }

void showImage(const FrameInfo& frame, int x, int y, const Picture& picture) {
    if (const vec2 scale = frame.scale(); scale != vec2(1))
        return showImage(frame.inPixels(), int(std::lround(x * scale.x)), int(std::lround(y * scale.y)), picture);
    const StateScope scope;
    begin();
    Program& program = kept()->image;
    if (program.id() == 0) {
        program = Program::fromText("image", quadVertex, quadFragment);
        kept()->vertexArray = makeVertexArray();
    }
    if (kept()->shown != picture) {
        kept()->shownTexture = Texture(picture, GL_NEAREST, "image");
        kept()->shown = picture;
    }
    program.use();
    program.set("picture", 0);
    program.set("rectangle", vec4(2.0 * x / frame.width() - 1, 1 - 2.0 * (y + picture.height) / frame.height(),
                                  2.0 * (x + picture.width) / frame.width() - 1, 1 - 2.0 * y / frame.height()));
    kept()->shownTexture.bind(0);
    glBindVertexArray(kept()->vertexArray.id());
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void forgetText() { kept().reset(); }

}  // namespace mv

#include "mv/gl/state_names.h"

#include <cstdio>
#include <iterator>
#include <utility>

namespace mv {

std::string stateName(GLenum capability) {
    static constexpr std::pair<GLenum, const char*> names[] = {
        {GL_BLEND, "GL_BLEND"},
        {GL_CULL_FACE, "GL_CULL_FACE"},
        {GL_DEPTH_CLAMP, "GL_DEPTH_CLAMP"},
        {GL_DEPTH_TEST, "GL_DEPTH_TEST"},
        {GL_DITHER, "GL_DITHER"},
        {GL_FRAMEBUFFER_SRGB, "GL_FRAMEBUFFER_SRGB"},
        {GL_MULTISAMPLE, "GL_MULTISAMPLE"},
        {GL_POLYGON_OFFSET_FILL, "GL_POLYGON_OFFSET_FILL"},
        {GL_PROGRAM_POINT_SIZE, "GL_PROGRAM_POINT_SIZE"},
        {GL_RASTERIZER_DISCARD, "GL_RASTERIZER_DISCARD"},
        {GL_SAMPLE_COVERAGE, "GL_SAMPLE_COVERAGE"},
        {GL_SCISSOR_TEST, "GL_SCISSOR_TEST"},
        {GL_STENCIL_TEST, "GL_STENCIL_TEST"},
        {GL_TEXTURE_CUBE_MAP_SEAMLESS, "GL_TEXTURE_CUBE_MAP_SEAMLESS"},
    };
    for (const auto& [value, name] : names) {
        if (value == capability) return name;
    }
    if (capability >= GL_CLIP_DISTANCE0 && capability < GL_CLIP_DISTANCE0 + 8) {
        return "GL_CLIP_DISTANCE" + std::to_string(capability - GL_CLIP_DISTANCE0);
    }
    return hexadecimal(capability);
}

std::string valueName(GLenum value) {
#define MV_NAMED(name) \
    { name, #name }
    static constexpr std::pair<GLenum, const char*> names[] = {
        MV_NAMED(GL_ZERO),
        MV_NAMED(GL_ONE),
        MV_NAMED(GL_NEVER),
        MV_NAMED(GL_LESS),
        MV_NAMED(GL_EQUAL),
        MV_NAMED(GL_LEQUAL),
        MV_NAMED(GL_GREATER),
        MV_NAMED(GL_NOTEQUAL),
        MV_NAMED(GL_GEQUAL),
        MV_NAMED(GL_ALWAYS),
        MV_NAMED(GL_SRC_COLOR),
        MV_NAMED(GL_ONE_MINUS_SRC_COLOR),
        MV_NAMED(GL_SRC_ALPHA),
        MV_NAMED(GL_ONE_MINUS_SRC_ALPHA),
        MV_NAMED(GL_DST_ALPHA),
        MV_NAMED(GL_ONE_MINUS_DST_ALPHA),
        MV_NAMED(GL_DST_COLOR),
        MV_NAMED(GL_ONE_MINUS_DST_COLOR),
        MV_NAMED(GL_SRC_ALPHA_SATURATE),
        MV_NAMED(GL_FUNC_ADD),
        MV_NAMED(GL_FUNC_SUBTRACT),
        MV_NAMED(GL_FUNC_REVERSE_SUBTRACT),
        MV_NAMED(GL_MIN),
        MV_NAMED(GL_MAX),
        MV_NAMED(GL_FRONT),
        MV_NAMED(GL_BACK),
        MV_NAMED(GL_FRONT_AND_BACK),
        MV_NAMED(GL_CW),
        MV_NAMED(GL_CCW),
        MV_NAMED(GL_POINT),
        MV_NAMED(GL_LINE),
        MV_NAMED(GL_FILL),
        MV_NAMED(GL_KEEP),
        MV_NAMED(GL_REPLACE),
        MV_NAMED(GL_INCR),
        MV_NAMED(GL_DECR),
        MV_NAMED(GL_INVERT),
        MV_NAMED(GL_INCR_WRAP),
        MV_NAMED(GL_DECR_WRAP),
        MV_NAMED(GL_LOWER_LEFT),
        MV_NAMED(GL_UPPER_LEFT),
        MV_NAMED(GL_ZERO_TO_ONE),
        MV_NAMED(GL_NEGATIVE_ONE_TO_ONE),
        MV_NAMED(GL_TEXTURE_2D),
        MV_NAMED(GL_TEXTURE_CUBE_MAP),
        MV_NAMED(GL_TEXTURE_1D),
        MV_NAMED(GL_TEXTURE_3D),
        MV_NAMED(GL_PATCH_VERTICES),
    };
#undef MV_NAMED
    for (const auto& [known, name] : names) {
        if (known == value) return name;
    }
    return hexadecimal(value);
}

std::string primitiveName(GLenum mode) {
    static constexpr const char* names[] = {"GL_POINTS",    "GL_LINES",          "GL_LINE_LOOP",   "GL_LINE_STRIP",
                                            "GL_TRIANGLES", "GL_TRIANGLE_STRIP", "GL_TRIANGLE_FAN"};
    if (mode < std::size(names)) return names[mode];
    if (mode == GL_TRIANGLES_ADJACENCY) return "GL_TRIANGLES_ADJACENCY";
    return mode == GL_PATCHES ? "GL_PATCHES" : hexadecimal(mode);
}

std::string hexadecimal(GLuint number) {
    char text[16];
    std::snprintf(text, sizeof text, "0x%X", number);
    return text;
}

}  // namespace mv

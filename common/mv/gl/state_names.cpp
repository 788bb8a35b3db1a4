#include "mv/gl/state_names.h"

#include <cstdio>
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
    char text[16];
    std::snprintf(text, sizeof text, "0x%X", capability);
    return text;
}

}  // namespace mv

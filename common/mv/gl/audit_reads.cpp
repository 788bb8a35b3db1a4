#include "mv/gl/audit_reads.h"

#include <array>

#include "mv/gl/tangent_buffer.h"

namespace mv {
namespace {

// Attributes have one place each, whatever the program.
constexpr std::array<const char*, 5> attributeNames{"position", "normal", "color", "texCoord", "tangent"};
static_assert(tangentLocation == attributeNames.size() - 1);

std::string nameOf(GLuint attribute) {
    return attribute < attributeNames.size() ? attributeNames.at(attribute) : std::to_string(attribute);
}

}  // namespace

void ReadParts::meshGone(GLuint vertexArray) {
    std::erase_if(attributes_, [&](const auto& entry) { return entry.first.first == vertexArray; });
}

void ReadParts::textureGone(GLuint texture) {
    levels_.erase(texture);
    filters_.erase(texture);
}

void ReadParts::drawn(GLuint vertexArray, GLuint program) {
    for (auto& [key, read] : attributes_) {
        if (key.first != vertexArray || read || key.second >= attributeNames.size()) continue;
        read = below_->GetAttribLocation(program, attributeNames.at(key.second)) >= 0;
    }
}

void ReadParts::sampled(GLuint texture) {
    const auto found = levels_.find(texture);
    if (found == levels_.end()) return;
    // OpenGL's own filter, until another is set, is one that reads them.
    const auto filter = filters_.find(texture);
    found->second |= filter == filters_.end() || (filter->second != GL_NEAREST && filter->second != GL_LINEAR);
}

void ReadParts::unread(const Say& say) const {
    for (const auto& [key, read] : attributes_) {
        if (!read) say(GL_VERTEX_ARRAY, key.first, "attribute " + nameOf(key.second) + " of ");
    }
    for (const auto& [texture, read] : levels_) {
        if (!read) say(GL_TEXTURE, texture, "levels of ");
    }
}

}  // namespace mv

// For the audit: which parts of meshes and textures no draw ever reads.
#pragma once
#include <functional>
#include <map>
#include <string>
#include <utility>

#include "mv/gl/layer.h"

namespace mv {

// Parts of an object besides those that every object has: an attribute of a mesh, the smaller levels of a texture.
// Calls are those of the layer below the audit, so that its own questions are none of the demo's.
class ReadParts {
  public:
    explicit ReadParts(const FunctionTable& below) : below_(&below) {}

    // ---- what is made; an object that is deleted is forgotten
    void attributeMade(GLuint vertexArray, GLuint attribute) {
        attributes_.emplace(std::pair{vertexArray, attribute}, false);
    }
    void levelsMade(GLuint texture) { levels_.emplace(texture, false); }
    void filterSet(GLuint texture, GLenum filter) { filters_[texture] = filter; }
    void meshGone(GLuint vertexArray);
    void textureGone(GLuint texture);

    // ---- what a draw reads
    void drawn(GLuint vertexArray, GLuint program);
    void sampled(GLuint texture);

    // Each part that nothing has read, as words: "attribute normal", "levels" with the object's name.
    using Say = std::function<void(GLenum kind, GLuint object, const std::string& part)>;
    void unread(const Say& say) const;

  private:
    const FunctionTable* below_;
    std::map<std::pair<GLuint, GLuint>, bool> attributes_;  // of a vertex array: whether a draw has read it
    std::map<GLuint, bool> levels_;     // of a texture with smaller levels: whether one was to be read
    std::map<GLuint, GLenum> filters_;  // for minified textures
};

}  // namespace mv

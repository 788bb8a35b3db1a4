// Vertices on the GPU.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "mv/geometry/mesh_data.h"
#include "mv/geometry/shadow_volume.h"
#include "mv/gl/object.h"

namespace mv {

class Mesh {
  public:
    Mesh() = default;
    // Uploads the data once; the label names the objects in debug messages. Attributes that the data lacks are off.
    explicit Mesh(const MeshData& data, const std::string& label = "mesh");
    // The same for a shadow volume, whose positions have a w. One without triangles draws nothing.
    explicit Mesh(const ShadowVolume& volume, const std::string& label = "shadow volume");
    // One glDrawArrays or glDrawElements with the mesh's primitive.
    void draw() const;
    // A part of it: `count` of its vertices, or of its indices where there are any, from the one numbered `first`. Refused:
    // a part beyond the mesh.
    void draw(std::size_t first, std::size_t count) const;
    // The same vertices as other primitives than the mesh's own: drawAs(GL_PATCHES) after glPatchParameteri, GL_LINE_LOOP.
    void drawAs(GLenum mode) const;
    GLenum primitive() const { return primitive_; }
    GLsizei count() const { return count_; }  // vertices, or indices where there are any

  private:
    void drawPart(GLenum mode, std::size_t first, std::size_t count) const;
    void bindNew(const std::string& label);
    void uploadIndices(const std::vector<std::uint32_t>& indices, const std::string& label);

    VertexArray vertexArray_;
    Buffer vertices_, indices_;
    GLenum primitive_ = GL_TRIANGLES;
    GLsizei count_ = 0;
};

}  // namespace mv

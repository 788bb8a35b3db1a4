// Vertices on the GPU.
#pragma once
#include <string>

#include "mv/geometry/mesh_data.h"
#include "mv/gl/object.h"

namespace mv {

class Mesh {
  public:
    Mesh() = default;
    // Uploads the data once; the label names the objects in debug messages. Attributes that the data lacks are off.
    explicit Mesh(const MeshData& data, const std::string& label = "mesh");
    // One glDrawArrays or glDrawElements with the mesh's primitive.
    void draw() const;
    GLenum primitive() const { return primitive_; }
    GLsizei count() const { return count_; }  // vertices, or indices where there are any

  private:
    VertexArray vertexArray_;
    Buffer vertices_, indices_;
    GLenum primitive_ = GL_TRIANGLES;
    GLsizei count_ = 0;
};

}  // namespace mv

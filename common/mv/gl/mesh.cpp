#include "mv/gl/mesh.h"

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <vector>

#include "mv/error.h"
#include "mv/gl/program.h"

namespace mv {
namespace {

GLenum glPrimitive(Primitive primitive) {
    switch (primitive) {
        case Primitive::triangles:
            return GL_TRIANGLES;
        case Primitive::triangleStrip:
            return GL_TRIANGLE_STRIP;
        case Primitive::triangleFan:
            return GL_TRIANGLE_FAN;
        case Primitive::lines:
            return GL_LINES;
        case Primitive::points:
            return GL_POINTS;
    }
    throw Error("mesh", "must have a known primitive");
}

template <class Vector>
std::size_t byteSize(const std::vector<Vector>& values) {
    return values.size() * sizeof(Vector);
}

// Appends one attribute's array to the buffer's bytes and points the attribute at it.
template <class Vector>
void attach(Attribute attribute, const std::vector<Vector>& values, std::vector<std::byte>& bytes) {
    if (values.empty()) return;
    const std::size_t offset = bytes.size();
    bytes.resize(offset + byteSize(values));
    std::memcpy(bytes.data() + offset, values.data(), byteSize(values));
    const auto index = static_cast<GLuint>(attribute);
    glEnableVertexAttribArray(index);
    glVertexAttribPointer(index, Vector::length(), GL_FLOAT, GL_FALSE, 0, reinterpret_cast<const void*>(offset));
}

}  // namespace

Mesh::Mesh(const MeshData& data, const std::string& label) : primitive_(glPrimitive(data.primitive)) {
    if (data.positions.empty()) throw Error("mesh " + label, "must have vertices");
    bindNew(label);
    std::vector<std::byte> bytes;
    attach(Attribute::position, data.positions, bytes);
    attach(Attribute::normal, data.normals, bytes);
    attach(Attribute::color, data.colors, bytes);
    attach(Attribute::texCoord, data.texCoords, bytes);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
    count_ = static_cast<GLsizei>(data.positions.size());
    if (!data.indices.empty()) uploadIndices(data.indices, label);
}

Mesh::Mesh(const ShadowVolume& volume, const std::string& label) {
    if (volume.positions.empty()) throw Error("mesh " + label, "must have vertices");
    bindNew(label);
    std::vector<std::byte> bytes;
    attach(Attribute::position, volume.positions, bytes);
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STATIC_DRAW);
    uploadIndices(volume.indices, label);
}

// Labels come before what is uploaded, which the audit knows by them.
void Mesh::bindNew(const std::string& label) {
    vertexArray_ = makeVertexArray();
    vertices_ = makeBuffer();
    glBindVertexArray(vertexArray_.id());
    glBindBuffer(GL_ARRAY_BUFFER, vertices_.id());
    labelObject(GL_BUFFER, vertices_.id(), label + " vertices");
    labelObject(GL_VERTEX_ARRAY, vertexArray_.id(), label);
}

// The vertex array is bound, and keeps the indices.
void Mesh::uploadIndices(const std::vector<std::uint32_t>& indices, const std::string& label) {
    indices_ = makeBuffer();
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices_.id());
    labelObject(GL_BUFFER, indices_.id(), label + " indices");
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(byteSize(indices)), indices.data(), GL_STATIC_DRAW);
    count_ = static_cast<GLsizei>(indices.size());
}

void Mesh::draw() const { draw(0, static_cast<std::size_t>(count_)); }

void Mesh::draw(std::size_t first, std::size_t count) const { drawPart(primitive_, first, count); }

void Mesh::drawAs(GLenum mode) const { drawPart(mode, 0, static_cast<std::size_t>(count_)); }

void Mesh::drawPart(GLenum mode, std::size_t first, std::size_t count) const {
    if (!vertexArray_) throw Error("Mesh", "must be made from a shape before it is drawn");
    if (first + count > static_cast<std::size_t>(count_)) {
        throw Error("Mesh", "has only " + std::to_string(count_) + " vertices to draw", std::to_string(first + count));
    }
    if (boundVertexArray() != vertexArray_.id()) glBindVertexArray(vertexArray_.id());
    if (indices_) {
        // An offset in bytes into the bound index buffer, which GL takes as a pointer
        const auto* offset =
            reinterpret_cast<const void*>(first * sizeof(std::uint32_t));  // NOLINT(performance-no-int-to-ptr)
        glDrawElements(mode, static_cast<GLsizei>(count), GL_UNSIGNED_INT, offset);
    } else {
        glDrawArrays(mode, static_cast<GLint>(first), static_cast<GLsizei>(count));
    }
}

}  // namespace mv

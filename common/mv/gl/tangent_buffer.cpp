#include "mv/gl/tangent_buffer.h"

#include "mv/error.h"
#include "mv/gl/functions.h"
#include "mv/math/types.h"

namespace mv {

Buffer attachTangents(std::span<const fvec4> tangents, const std::string& label) {
    if (tangents.empty()) throw Error("tangents " + label, "must be one at least");
    if (boundVertexArray() == 0) throw Error("tangents " + label, "need a mesh that was made just before them");
    Buffer buffer = makeBuffer();
    glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
    labelObject(GL_BUFFER, buffer.id(), label + " tangents");
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(tangents.size_bytes()), tangents.data(), GL_STATIC_DRAW);
    glEnableVertexAttribArray(tangentLocation);
    glVertexAttribPointer(tangentLocation, fvec4::length(), GL_FLOAT, GL_FALSE, 0, nullptr);
    return buffer;
}

}  // namespace mv

#include "mv/gl/feedback.h"

#include "mv/error.h"

namespace mv {
namespace {

GLenum separatePrimitive(GLenum primitive) {
    return primitive == GL_TRIANGLE_STRIP || primitive == GL_TRIANGLE_FAN ? GLenum(GL_TRIANGLES) : primitive;
}

}  // namespace

std::vector<fvec4> transformedPositions(const Mesh& mesh) {
    const Counters before = counters();
    const GLenum primitive = separatePrimitive(mesh.primitive());
    const GLsizei count = primitive == mesh.primitive() ? mesh.count() : (mesh.count() - 2) * 3;
    std::vector<fvec4> positions(static_cast<std::size_t>(count));
    const auto bytes = static_cast<GLsizeiptr>(positions.size() * sizeof(fvec4));
    const Buffer buffer = makeBuffer();
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer.id());
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_STREAM_READ);
    glEnable(GL_RASTERIZER_DISCARD);
    glBeginTransformFeedback(primitive);
    mesh.draw();
    glEndTransformFeedback();
    glDisable(GL_RASTERIZER_DISCARD);
    const void* mapped = glMapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, GL_MAP_READ_BIT);
    if (!mapped) throw Error("transform feedback", "must be read back; the driver maps no feedback buffer");
    const auto first = static_cast<const fvec4*>(mapped);
    positions.assign(first, first + positions.size());
    glUnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    resetCounters(before);
    return positions;
}

}  // namespace mv

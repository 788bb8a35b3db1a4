#include "mv/gl/feedback.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "mv/error.h"
#include "mv/gl/state.h"

namespace mv {
namespace {

GLenum capturedAs(GLenum primitive) {
    return primitive == GL_TRIANGLE_STRIP || primitive == GL_TRIANGLE_FAN ? GLenum(GL_TRIANGLES) : primitive;
}

}  // namespace

std::vector<fvec4> transformedPositions(const Mesh& mesh) {
    const Counters before = counters();
    const GLenum primitive = capturedAs(mesh.primitive());
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

long countedBy(GLenum what, const std::function<void()>& draw) {
    GLuint query = 0, count = 0;
    glGenQueries(1, &query);
    glBeginQuery(what, query);
    draw();
    glEndQuery(what);
    glGetQueryObjectuiv(query, GL_QUERY_RESULT, &count);
    glDeleteQueries(1, &query);
    return static_cast<long>(count);
}

Captured captured(GLenum primitive, const std::function<void()>& draw) {
    const Counters before = counters();
    const StateScope scope;
    glEnable(GL_RASTERIZER_DISCARD);
    Captured result;
    result.generated = countedBy(GL_PRIMITIVES_GENERATED, draw);

    // Room for one more than the query says, and a mark in each place: so the corners that are written are found without it.
    const std::size_t corners = primitive == GL_POINTS ? 1 : primitive == GL_LINES ? 2 : 3;
    const std::size_t room = (static_cast<std::size_t>(result.generated) + 1) * corners;
    const auto bytes = static_cast<GLsizeiptr>(room * sizeof(fvec4));
    const Buffer buffer = makeBuffer();
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, buffer.id());
    glBufferData(GL_TRANSFORM_FEEDBACK_BUFFER, bytes, nullptr, GL_STREAM_READ);
    const auto mapped = [&](GLbitfield access) {
        void* places = glMapBufferRange(GL_TRANSFORM_FEEDBACK_BUFFER, 0, bytes, access);
        if (!places) throw Error("transform feedback", "must be read back; the driver maps no feedback buffer");
        return static_cast<fvec4*>(places);
    };
    std::fill_n(mapped(GL_MAP_WRITE_BIT), room, fvec4(std::numeric_limits<float>::quiet_NaN()));
    glUnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER);
    result.written = countedBy(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, [&] {
        glBeginTransformFeedback(primitive);
        draw();
        glEndTransformFeedback();
    });
    const fvec4* places = mapped(GL_MAP_READ_BIT);
    const auto isMark = [](const fvec4& place) { return std::isnan(place.w); };
    result.positions.assign(places, std::find_if(places, places + room, isMark));
    glUnmapBuffer(GL_TRANSFORM_FEEDBACK_BUFFER);
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
    resetCounters(before);
    return result;
}

}  // namespace mv

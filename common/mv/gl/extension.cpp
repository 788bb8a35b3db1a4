// What the context has beyond its version. (In a page by web/extension.cpp: there it is enabled where it is asked for.)
#include <string>

#include "mv/gl/functions.h"
#include "mv/gl/gl.h"

namespace mv {

bool hasExtension(const char* name) {
    GLint count = 0;
    glGetIntegerv(GL_NUM_EXTENSIONS, &count);
    for (GLint i = 0; i < count; ++i) {
        const auto extension = glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
        if (extension && std::string(reinterpret_cast<const char*>(extension)) == name) return true;
    }
    return false;
}

}  // namespace mv

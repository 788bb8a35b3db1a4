// Extensions in a page: one is there once it is enabled, which takes its time: when somebody asks for it.
#include <emscripten/html5.h>

#include "mv/gl/functions.h"

namespace mv {

bool hasExtension(const char* name) {
    return emscripten_webgl_enable_extension(emscripten_webgl_get_current_context(), name);
}

}  // namespace mv

// The WebGL 2 context of a canvas, as a host of demos.
#pragma once
#include <memory>
#include <string>

#include "mv/host/context.h"

namespace mv {

// What Emscripten calls the canvas that the module was opened with.
inline constexpr const char* canvasName = "!canvas";

// Makes the context of the canvas that the module was opened with, and makes it current. Its buffers are the stage's own;
// the canvas shows what is copied there. Error: the browser gives none.
std::unique_ptr<Context> openWebGl();

}  // namespace mv

// A scene as a picture shows it.
#pragma once
#include "mv/demo/frame.h"
#include "mv/geometry/scene.h"

namespace mv {

// The scene through the camera of this picture, which a probe may have put elsewhere; else as it is.
Scene seen(Scene scene, const Frame& frame);

}  // namespace mv

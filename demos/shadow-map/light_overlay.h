// A shadow map, drawn over a picture: its frustum as lines, and the map itself in a corner.
#pragma once
#include "mv/demo/frame.h"
#include "mv/geometry/light_view.h"
#include "mv/geometry/shapes.h"
#include "mv/gl/depth_map.h"
#include "mv/gl/mesh.h"
#include "mv/gl/on_demand.h"
#include "mv/gl/program.h"

namespace mv {

class LightOverlay {
  public:
    // Makes its programs and meshes; a context is current.
    void init();
    // The edges of the light's view volume, white, and a yellow ball at a light that is a point. Depth-tested as the
    // state says. Changes the current program.
    void drawFrustum(const FrameInfo& frame, const mat4& clipFromWorld, const LightView& light);
    // The map in the lower left corner, up to 0.3 of the picture high and wide, in the shape of its window, with its size
    // above it: distances along the light's gaze, near dark and far bright. Changes the current program and the map's
    // sampling (DepthMap::bind) on unit 0, and switches depth test, culling and blending off.
    void drawMap(const FrameInfo& frame, const DepthMap& map, const LightView& light) const;

  private:
    Program lines_, corner_;
    Mesh edges_, square_;
    OnDemand<Mesh> ball_{positionsOnly(sphere(1, 16, 8)), "light"};  // for the lights that have a place
};

}  // namespace mv

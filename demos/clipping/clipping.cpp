// clipping: what of points, segments and polygons lies in a window, and why space is clipped before the division.
#include "clipping.h"

#include <glm/common.hpp>

namespace mv::clipping {

void draw(Gpu& gpu, const Settings& s, const Frame& inPixels) {
    const Frame frame = inPixels.inUnits();
    constexpr std::array ofSubject{drawPoint, drawSegment, drawPolygon, drawSpace};
    gpu.figure.begin(frame);
    ofSubject.at(std::size_t(s.subject))(gpu.figure, s, frame);
    gpu.figure.draw(frame);
}

Box windowOf(const InPlane& s) { return {glm::min(s.corners[0], s.corners[1]), glm::max(s.corners[0], s.corners[1])}; }
Box farWindowOf(const InPlane& s) {
    const Box window = windowOf(s);
    return {window.low + double(s.offset), window.high + double(s.offset)};
}

}  // namespace mv::clipping

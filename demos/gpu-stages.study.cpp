// What is asked of gpu-stages beside its picture: whether two kinds of shader make the same one.
#include <vector>

#include "mv/demo/demo.h"
#include "mv/gl/beyond_es.h"
#include "shared/stage_table.h"

using namespace mv;

namespace {

// Pixels of the two panes that differ in any channel; of what cannot be compared, nothing.
std::vector<double> differing(Probing& probing) {
    if (probing.demo().word("show") != "compute" || !has(beyond_es::computeShaders)) return {};
    std::vector<Pane> panes = probing.frame().panes(2);
    for (Pane& pane : panes) pane = belowHeading(pane);
    const Picture picture = probing.picture();
    long count = 0;
    for (int y = 0; y < panes[0].height; ++y) {
        const int row = picture.height - 1 - y;  // the picture's upper row is 0
        for (int x = 0; x < panes[0].width; ++x) {
            if (panes[1].x + x >= picture.width || panes[0].y + y >= picture.height) return {};
            count +=
                picture.at(panes[0].x + x, row - panes[0].y) != picture.at(panes[1].x + x, row - panes[1].y) ? 1 : 0;
        }
    }
    return {double(count)};
}

const bool probed =
    addProbes("gpu-stages", {{{{"differing", "pixels in which the two shaders' pictures differ", "px"}}, differing}});

}  // namespace

#include <cstdio>

#include "mv/math/projection.h"
#include "mv/math/transform.h"

int main() {
    const mv::mat4 clipFromWorld = mv::perspective(90, 1, 1, 3) * mv::lookAt({0, 0, 2}, {0, 0, 0}, {0, 1, 0});
    const mv::vec3 ndc = mv::ndcFromClip(clipFromWorld * mv::vec4(1, 1, 0, 1));
    std::printf("%.3f %.3f %.3f\n", ndc.x, ndc.y, ndc.z);
}

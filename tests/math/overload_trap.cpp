// A source that must not compile, one way for each call a user could get wrong.
//
// With MVGL_TRAP undefined or 0 it must compile: the right calls. With MVGL_TRAP = 1 to 13 it must not: under
// `using namespace mv` and with GLM's transform header visible, an unqualified call with float arguments, or onto a
// matrix, would silently be GLM's.
#include <glm/gtc/matrix_transform.hpp>

#include "mv/math/projection.h"
#include "mv/math/shadow.h"
#include "mv/math/transform.h"

#ifndef MVGL_TRAP
#define MVGL_TRAP 0
#endif

using namespace mv;

int main() {
    const glm::vec3 v(0, 0, 4);
    const glm::vec4 light(0, 2, 0, 1);
    const glm::vec4 plane(0, 1, 0, 0);
    const glm::mat4 m(1);
#if MVGL_TRAP == 0
    // Double, braced, integer and mixed arguments go to mv; GLM's own functions can still be had by name.
    const mat4 view = lookAt({0, 0, 4}, {0, 0, 0}, {0, 1, 0}) * lookAt(vec3(v), vec3(0), vec3(0, 1, 0)) *
                      lookAtAnyRoll({0, 0, 4}, {0, 0, 0});
    const mat4 model = translate({1, 2, 3}) * translate(1, 2, 3) * scale({1, 2, 3}) * scale(1, 2, 3) * scale(2) *
                       rotate(30, {1, 0, 0}) * rotateX(30) * rotateY(30.0f) * rotateZ(30.0);
    const mat4 clip = perspective(50, 1, 1, 500) * ortho(-1, 1, -1, 1, -1, 1) * frustum(-1, 1.0, -1, 1, 1, 3) *
                      perspective(50.0f, 1.5, 1, 500);
    const mat4 shadow = shadowProjection({0, 2, 0, 1}, {0, 1, 0, 0}) *
                        shadowProjection({0, 2, 0, 1}, {0, 1, 0, 0}, {0, 0, 0}) * reflection({0, 1, 0, 0});
    const glm::mat4 glms = glm::lookAt(v, glm::vec3(0), glm::vec3(0, 1, 0)) * glm::rotate(m, 1.0f, v);
    const vec2 pixel = pixelFromNdc({0, 0}, 4, 4) + pixelFromNdc({0, 0, 0}, 4, 4);
    const vec4 bound = shadowCasterBounds({0, 2, 0, 1}, {0, 1, 0, 0})[0];
    return (view * model * clip * shadow)[0][0] + static_cast<double>(glms[0][0]) + pixel.x + bound.x +
                       static_cast<double>(light.x + plane.x) ==
                   0.5
               ? 1
               : 0;
#elif MVGL_TRAP == 1
    lookAt(v, glm::vec3(0), glm::vec3(0, 1, 0));
#elif MVGL_TRAP == 2
    lookAt(v, {0, 0, 0}, {0, 1, 0});
#elif MVGL_TRAP == 3
    translate(v);
#elif MVGL_TRAP == 4
    scale(v);
#elif MVGL_TRAP == 5
    rotate(30.0f, v);
#elif MVGL_TRAP == 6
    translate(m, v);
#elif MVGL_TRAP == 7
    scale(m, v);
#elif MVGL_TRAP == 8
    rotate(m, 30.0f, v);
#elif MVGL_TRAP == 9
    rotate(mat4(1), 30.0, vec3(v));
#elif MVGL_TRAP == 10
    lookAtAnyRoll(v, glm::vec3(0));
#elif MVGL_TRAP == 11
    normalMatrix(m);
#elif MVGL_TRAP == 12
    using namespace glm;
    perspective(50.0f, 1.0f, 1.0f, 500.0f);
#elif MVGL_TRAP == 13
    shadowProjection(light, plane);
#else
#error "no such trap"
#endif
}

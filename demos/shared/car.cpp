#include "shared/car.h"

#include "mv/geometry/scene.h"
#include "mv/geometry/shapes.h"
#include "mv/math/transform.h"

namespace mv {

std::array<mat4, 2> carFromCubes() {
    return {scale(10, 3, 2) * translate(0, 0, 0.5), scale(4, 3, 2) * translate(-0.2, 0, 1.5)};
}

MeshData carLookingAlongMinusZ(double size) {
    const mat4 frameFromCar = rotateX(-90) * rotateZ(90) * scale(size);  // x to y to -z, and z to y
    const MeshData cube = box(vec3(-0.5), vec3(0.5));
    const auto [body, cabin] = carFromCubes();
    Scene scene;
    scene.objects = {{"body", cube, frameFromCar * body, {0.25, 0.40, 0.80}},
                     {"cabin", cube, frameFromCar * cabin, {0.75, 0.85, 1.00}}};
    return meshOf(scene);
}

}  // namespace mv

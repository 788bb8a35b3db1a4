// The two pictures that the PNG encoder is measured on, made by code so that they are the same everywhere.
#pragma once
#include "mv/image/picture.h"

namespace mv::bench {

// As a demo renders: a lit sphere above a chequered floor in front of a sky; smooth shading and hard edges, opaque.
[[nodiscard]] Picture renderedLike(int width, int height);

// As the first lessons render: a cube's three visible faces, each in one flat colour, on white.
[[nodiscard]] Picture flatCube(int side);

}  // namespace mv::bench

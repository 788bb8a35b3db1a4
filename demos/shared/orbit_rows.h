// The rows of an orbit, and how the pointer moves it:
//     .rows = together(..., part(&Settings::orbit, orbitRows({-4, 40})))
//     .controls = {orbitDrag, orbitWheel, ...}
#pragma once
#include <vector>

#include "mv/demo/lesson.h"
#include "shared/orbit.h"

namespace mv {

// spin-x and spin-y, degrees, and distance within `steps`.
std::vector<Row<Orbit>> orbitRows(NumberRange steps);

// A degree for each pixel; a quarter step forward for each notch.
inline const Control orbitDrag = drag("spin-y", 1, "spin-x", 1), orbitWheel = wheel("distance", -0.25);

}  // namespace mv

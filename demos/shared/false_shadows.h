// How wrong a picture's shadows are, found while it is shown: a coarse grid of its pixels against rays.
#pragma once
#include <optional>

#include "mv/demo/study.h"
#include "mv/geometry/scene.h"

namespace mv {

struct FalseShadows {
    double dark = 0, lit = 0;  // percent of the pixels: dark though the light reaches them, and the other way round
    long pixels = 0;           // of receivers that face the light, both for the rays and in the picture
};

// Asks for the demo's lit fraction (0..1, -1 where there is none) in at most 96 x 96 pixels, in the shape of the picture,
// and casts a ray through the middle of each into Demo::scene(), and one to its first light. More than half lit is lit.
// A study measures all pixels. Nothing where the context has no targets of floats.
std::optional<FalseShadows> falseShadows(Probing& probing);
// The same against another scene with the demo's camera: the true shape of what casts, say.
std::optional<FalseShadows> falseShadows(Probing& probing, const Scene& scene);

// The readout of a demo of shadows: the part that is wrong.
Probe wrongShadows(Literal help = "part of the pixels of a coarse grid whose shadow is not what rays show");

}  // namespace mv

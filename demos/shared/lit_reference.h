// The reference of a shadow study: the lit fraction by rays.
#pragma once
#include "mv/demo/frame.h"
#include "mv/demo/study.h"
#include "mv/geometry/ray_caster.h"

namespace mv {

struct LitReferenceOptions {
    std::vector<int> lights{0};  // the mean of these, as indices in Scene::lights
    int lightSide = 1;           // an area light is asked at lightSide x lightSide points
    // Above 1: Reference::averages is the mean of pixelSide x pixelSide points of each pixel, whose edges are soft.
    int pixelSide = 1;
    // Casts again with lightSide (or, for point lights, pixelSide) doubled for Reference::ownError, where frame.ownError.
    bool doubled = false;
};

// One value for each pixel of the frame: the lit fraction in its centre. A pixel counts where the object seen there
// receives shadows and has its front towards the first of the lights; its region is the object's index.
Reference litReference(const Scene& scene, const ReferenceFrame& frame, const LitReferenceOptions& options,
                       const Progress& progress);

}  // namespace mv

#include "shared/lit_reference.h"

#include <cmath>

namespace mv {
namespace {

// The mean over the lights; `work` grows by the rays.
LitPicture meanLit(const RayCaster& caster, const FrameInfo& frame, const LitReferenceOptions& options, int lightSide,
                   int pixelSide, const Progress& progress, double& work) {
    LitPicture mean;
    const double share = 1.0 / double(options.lights.size());
    double done = 0;
    for (const int light : options.lights) {
        const LitPicture one =
            caster.lit(frame.width(), frame.height(),
                       {.light = light, .lightSide = lightSide, .pixelSide = pixelSide, .progress = [&](double part) {
                            if (progress) progress((done + part) * share);
                        }});
        ++done;
        work += double(one.rays);
        if (mean.lit.empty()) {
            mean = one;
            for (double& lit : mean.lit) lit *= share;
            continue;
        }
        for (std::size_t i = 0; i < mean.lit.size(); ++i) mean.lit[i] += share * one.lit[i];
    }
    return mean;
}

double rmsBetween(const std::vector<double>& a, const std::vector<double>& b, const std::vector<int>& regions) {
    double squares = 0, n = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (regions[i] < 0) continue;
        squares += (a[i] - b[i]) * (a[i] - b[i]);
        ++n;
    }
    return n > 0 ? std::sqrt(squares / n) : 0;
}

}  // namespace

Reference litReference(const Scene& scene, const ReferenceFrame& frame, const LitReferenceOptions& options,
                       const Progress& progress) {
    const RayCaster caster(scene);
    Reference reference;
    const LitPicture centres = meanLit(caster, frame, options, options.lightSide, 1, progress, reference.work);
    reference.values = centres.lit;
    reference.regions.reserve(centres.object.size());
    for (std::size_t i = 0; i < centres.object.size(); ++i) {
        const int object = centres.object[i];
        const bool counts = object >= 0 && scene.objects[static_cast<std::size_t>(object)].receives && centres.faces[i];
        reference.regions.push_back(counts ? object : -1);
    }
    const int pixelSide = options.pixelSide;
    if (pixelSide > 1) {
        reference.averages =
            meanLit(caster, frame, options, options.lightSide, pixelSide, progress, reference.work).lit;
    }
    if (options.doubled && frame.ownError) {
        double ignored = 0;
        const bool byPixel = pixelSide > 1;
        const std::vector<double> finer =
            meanLit(caster, frame, options, byPixel ? options.lightSide : 2 * options.lightSide,
                    byPixel ? 2 * pixelSide : 1, progress, ignored)
                .lit;
        reference.ownError = rmsBetween(byPixel ? reference.averages : reference.values, finer, reference.regions);
    }
    return reference;
}

}  // namespace mv

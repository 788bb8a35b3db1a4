#include "depth_order.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "mv/error.h"

namespace mv {

float windowDepth(const fmat4& clipFromView, float distance, bool zeroToOne) {
    const float z = clipFromView[2][2] * -distance + clipFromView[3][2], ndc = z / distance;
    return zeroToOne ? ndc : 0.5F * ndc + 0.5F;
}

double keptDepth(DepthFormat format, float depth) {
    const double cut = std::clamp(depth, 0.0F, 1.0F);
    if (format == DepthFormat::d32f) return cut;
    const double steps = format == DepthFormat::d16 ? 0xFFFF : 0xFFFFFF;
    return std::round(cut * steps) / steps;
}

std::vector<double> misorderedPairs(double near, double far, double separation, int count,
                                    const std::function<double(float)>& depthOf) {
    if (!(near > 0)) throw Error("near", "must be above 0", numberText(near));
    if (!(separation >= 0)) throw Error("separation", "must not be below 0", numberText(separation));
    if (!(far > near * (1 + separation))) throw Error("far", "must be beyond near (1 + separation)", numberText(far));
    if (count < 1) throw Error("count", "must be at least 1", std::to_string(count));
    const double ratio = std::pow(far / (1 + separation) / near, 1.0 / count);
    std::vector<double> wrong;
    wrong.reserve(static_cast<std::size_t>(count));
    double distance = near * std::sqrt(ratio);
    for (int i = 0; i < count; ++i, distance *= ratio) {
        const bool inOrder = depthOf(float(distance)) < depthOf(float(distance * (1 + separation)));
        wrong.push_back(inOrder ? 0 : 1);
    }
    return wrong;
}

}  // namespace mv

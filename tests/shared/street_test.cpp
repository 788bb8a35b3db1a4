#include "keyframes/street.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "mv/geometry/bounds.h"
#include "mv/geometry/check.h"
#include "mv/geometry/ray_caster.h"

using namespace mv;

// Rays from where a camera may be: of the objects that one meets, the nearest is the last in the order.
TEST(FigureInStreet, isInPaintersOrder) {
    const Scene street = figureInStreet();
    for (const SceneObject& object : street.objects) EXPECT_NO_THROW(validate(object.mesh)) << object.name;
    std::vector<RayCaster> casters;
    for (const SceneObject& object : street.objects) {
        Scene one;
        one.objects = {object};
        casters.emplace_back(one);
    }
    int hidden = 0;
    for (const double distance : {1.0, 4.0, 30.0, 60.0}) {
        const vec3 eye(0, figureHeight / 2, distance);
        for (int i = 0; i < 80 * 36; ++i) {
            const int column = i % 80, row = i / 80;
            const vec3 target((column - 39.7) * 0.31, 1 + (row - 10.3) * 0.17, -12);
            double nearest = HUGE_VAL;
            for (std::size_t index = 0; index < casters.size(); ++index) {
                const auto hit = casters[index].nearest({eye, target - eye});
                if (!hit) continue;
                hidden += nearest < HUGE_VAL;
                EXPECT_LT(hit->t, nearest) << street.objects[index].name << ", " << index;
                nearest = hit->t;
            }
        }
    }
    EXPECT_GT(hidden, 100);
}

TEST(FigureInStreet, hasItsMeasures) {
    const Scene street = figureInStreet();
    for (const SceneObject& object : street.objects) {
        const Bounds bounds = boundsOf(object.mesh, object.worldFromObject);
        if (object.name == "head") {
            EXPECT_NEAR(bounds.high.y, figureHeight, 1e-6);
        }
        if (object.name != "door") continue;
        EXPECT_NEAR(bounds.high.y, doorHeight, 1e-6);
        EXPECT_NEAR(bounds.high.z, -doorBehindFigure, 1e-6);
    }
}

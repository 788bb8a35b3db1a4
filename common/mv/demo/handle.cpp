#include "mv/demo/handle.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "mv/error.h"
#include "mv/math/projection.h"

namespace mv {
namespace {

constexpr double nearEnough = 0.01;  // px

std::vector<double> valuesOf(const std::vector<Coordinate>& coordinates) {
    std::vector<double> values;
    values.reserve(coordinates.size());
    for (const Coordinate& coordinate : coordinates) values.push_back(coordinate.get());
    return values;
}
void setAll(const std::vector<Coordinate>& coordinates, const std::vector<double>& values) {
    for (std::size_t i = 0; i < values.size(); ++i) coordinates[i].set(values[i]);
}

// The movement of the place for each coordinate, in pixels a unit; towards the inside of its range.
std::vector<vec2> slopes(const std::vector<Coordinate>& coordinates,
                         const std::function<std::optional<vec2>()>& place) {
    std::vector<vec2> slopes;
    const std::optional<vec2> here = place();
    for (const Coordinate& coordinate : coordinates) {
        const double value = coordinate.get(), step = 1e-6 * (coordinate.high - coordinate.low);
        const double moved = value + step <= coordinate.high ? step : -step;
        coordinate.set(value + moved);
        const std::optional<vec2> there = place();
        coordinate.set(value);
        slopes.push_back(here && there ? (*there - *here) / moved : vec2(0));
    }
    return slopes;
}

// The shortest change of all coordinates that makes up for `missing`, as far as they can: of J t = missing the solution by
// J^T (J J^T)^-1, damped where J has less than two directions.
std::vector<double> shortestChange(const std::vector<vec2>& slopes, const vec2& missing) {
    double xx = 0, xy = 0, yy = 0;
    for (const vec2& slope : slopes) {
        xx += slope.x * slope.x;
        xy += slope.x * slope.y;
        yy += slope.y * slope.y;
    }
    std::vector<double> change(slopes.size(), 0);
    const double damping = 1e-6 * (xx + yy);
    if (damping == 0) return change;
    xx += damping;
    yy += damping;
    const vec2 weight = vec2(yy * missing.x - xy * missing.y, xx * missing.y - xy * missing.x) / (xx * yy - xy * xy);
    for (std::size_t i = 0; i < slopes.size(); ++i) change[i] = glm::dot(slopes[i], weight);
    return change;
}

// The same without those that are at an end of their range and would have to go on.
std::vector<double> changeInRange(const std::vector<Coordinate>& coordinates, std::vector<vec2> slopes,
                                  const vec2& missing) {
    for (;;) {
        std::vector<double> change = shortestChange(slopes, missing);
        bool blocked = false;
        for (std::size_t i = 0; i < change.size(); ++i) {
            const Coordinate& c = coordinates[i];
            if (slopes[i] == vec2(0)) continue;
            if ((change[i] > 0 && c.get() >= c.high) || (change[i] < 0 && c.get() <= c.low)) {
                slopes[i] = vec2(0);
                blocked = true;
            }
        }
        if (!blocked) return change;
    }
}

// Rounds to the grid, or to a ten thousandth of the range, by a power of ten.
double rounded(const Coordinate& coordinate) {
    const double range = coordinate.high - coordinate.low;
    const double scale = coordinate.grid > 0 ? 1 / coordinate.grid : std::pow(10.0, std::ceil(4 - std::log10(range)));
    return std::round(coordinate.get() * scale) / scale;
}

}  // namespace

vec2 pictureFromPane(const Pane& pane, const vec2& pixel) { return vec2(pane.x, pane.y) + pixel; }

std::optional<vec2> pictureFromPane(const Pane& pane, const mat4& clipFromModel, const vec3& point) {
    const vec4 clip = clipFromModel * vec4(point, 1);
    if (!(clip.w > 1e-9 * std::max(1.0, glm::length(point)))) return std::nullopt;
    return pictureFromPane(pane, pixelFromNdc(ndcFromClip(clip), pane.width, pane.height));
}

bool Handle::drag(const FrameInfo& frame, std::size_t which, const vec2& pixel) const {
    const std::vector<Coordinate> moving = coordinates(which);
    const std::vector<double> before = valuesOf(moving);
    // Settings that make no picture on the way have no place either
    const auto place = [&]() -> std::optional<vec2> {
        try {
            return where(frame, which);
        } catch (const Error&) {
            return std::nullopt;
        }
    };
    std::optional<vec2> here = place();
    for (int i = 0; i < 50 && here && glm::length(pixel - *here) > nearEnough; ++i) {
        const std::vector<double> from = valuesOf(moving);
        const std::vector<double> change = changeInRange(moving, slopes(moving, place), pixel - *here);
        // Half as far, until it is nearer
        std::optional<vec2> there;
        double part = 1;
        for (int halvings = 0; halvings < 10; ++halvings, part /= 2) {
            for (std::size_t k = 0; k < moving.size(); ++k) moving[k].set(from[k] + part * change[k]);
            there = place();
            if (there && glm::length(pixel - *there) < glm::length(pixel - *here)) break;
            setAll(moving, from);
            there.reset();
        }
        if (!there) break;
        here = there;
    }
    for (std::size_t k = 0; k < moving.size(); ++k) {
        if (moving[k].get() == before[k]) continue;
        moving[k].set(rounded(moving[k]));
    }
    return valuesOf(moving) != before;
}

}  // namespace mv

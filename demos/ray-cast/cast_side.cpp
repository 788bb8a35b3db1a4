#include "cast_side.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <string>
#include <utility>

#include "mv/demo/handle.h"
#include "mv/formatted.h"
#include "mv/gl/text.h"
#include "mv/math/projection.h"
#include "mv/math/transform.h"

namespace mv {
namespace {

const vec4 faint(0.45, 0.45, 0.5, 1), planeColor(0.15, 0.35, 0.75, 1);

mat4 clipFromWorldOf(const Pane& pane, const CastEye& eye, double distance, double scale, bool eyeIsSeen) {
    const vec3 middle = vec3(0, 0.8, 0) + (eyeIsSeen ? (distance - 4) / 2 : 0) * eye.w;
    const double wide = eyeIsSeen ? (distance + 8) / 2 : 6, high = wide / pane.aspect();
    const vec3 away = glm::normalize(eye.u + vec3(0, 0.15, 0));
    return ortho(-wide, wide, -high, high, 1, 60) * lookAt(middle + 30.0 * away, middle, vec3(0, 1, 0)) *
           mv::scale(1 / scale, 1 / scale, 1 / scale);
}

}  // namespace

CastSide::CastSide(const Pane& pane, const CastEye& eye, double distance, double scale)
    : pane_(pane),
      eye_(eye),
      distance_(distance),
      scale_(scale),
      clipFromWorld_(clipFromWorldOf(pane, eye, distance, scale, eyeIsSeen())) {}

vec2 CastSide::at(const vec3& point) const {
    return pictureFromPane({0, 0, pane_.width, pane_.height}, clipFromWorld_, point).value_or(vec2(-100));
}

void CastSide::draw(Drawing& drawing, const Ray& ray, const std::vector<CastCandidate>& met,
                    const TextStyle& words) const {
    drawing.in(pane_);
    drawing.line(vec2(1, 0), vec2(1, pane_.height), {faint, 1});
    drawing.text({8, pane_.height - 2.0},
                 eyeIsSeen() ? "from the side" : formatted("from the side; the eye is %.4g away", distance_ * scale_),
                 words);

    // The ray: to the nearest object, and faint beyond it
    const vec3 start = eyeIsSeen() ? ray.origin : ray.at(scale_ * (distance_ - 7)),
               end = ray.at(scale_ * (distance_ + 5));
    drawing.line(at(start), at(end), {vec4(castRed.r, castRed.g, castRed.b, 0.35), 1.5});
    drawing.line(at(start), at(met.empty() ? end : ray.at(met.front().hit.t)), {castRed, 2});
    if (eyeIsSeen()) drawEye(drawing, words);
    for (std::size_t i = met.size(); i-- > 0;) {
        const vec2 place = at(ray.at(met[i].hit.t));
        drawing.point(place, i == 0 ? 11 : 8, i == 0 ? castRed : castInk);
        // Above and below by turns: near ones would cover each other
        drawing.text(place + vec2(4, i % 2 == 0 ? words.height + 8.0 : -6.0), std::to_string(i + 1),
                     {words.height, i == 0 ? castRed : castInk, vec4(1, 1, 1, 0.5)});
    }
}

void CastSide::drawEye(Drawing& drawing, const TextStyle& words) const {
    const double before = 2 * scale_, half = before * eye_.half;
    const vec2 eye = at(eye_.at);
    std::vector<vec2> corners;
    for (const vec2& corner : {vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, 1), vec2(-1, -1)}) {
        corners.push_back(at(eye_.at + half * (corner.x * eye_.u + corner.y * eye_.v) - before * eye_.w));
        drawing.line(eye, corners.back(), {faint, 1});
    }
    drawing.line(corners, {planeColor, 2});
    drawing.text(corners[2] + vec2(8, 0.6 * words.height), "image plane", {words.height, planeColor, vec4(0)});
    const std::vector<std::pair<const char*, vec3>> axes{{"u", eye_.u}, {"v", eye_.v}, {"w", eye_.w}};
    for (const auto& [name, axis] : axes) {
        // u points at who looks
        const vec2 tip = at(eye_.at + 1.2 * scale_ * axis);
        const bool isSeen = glm::distance(tip, eye) > 12;
        if (isSeen) drawing.arrow(eye, tip, {castInk, 1.5});
        drawing.textAround(tip + 0.3 * (tip - eye) + (isSeen ? vec2(0) : vec2(-14, -8)), name, words);
    }
    drawing.point(eye, 8, castInk);
}

void drawCandidates(Drawing& drawing, const Pane& pane, const std::vector<CastCandidate>& met,
                    const std::vector<CastKind>& shown, const TextStyle& words) {
    drawing.in(pane);
    const double line = std::max(1.0, (pane.height - 12.0) / 8.5);
    const int fitting = std::min(static_cast<int>(line * 0.85), pane.width / 17);  // a row is 17 heights long
    TextStyle style{std::clamp(fitting, 6, words.height), castInk, vec4(0)};
    double top = pane.height - 4.0;
    const auto write = [&](const std::string& order, const std::string& name, const std::string& t, const vec4& color) {
        style.color = color;
        drawing.text({10, top}, order, style);
        drawing.text({10 + 2.0 * style.height, top}, name, style);
        drawing.text({10 + 10.0 * style.height, top}, t, style);
        top -= line;
    };
    const auto nameOf = [](CastKind kind) { return castKindNames.at(static_cast<std::size_t>(kind)); };
    write("", "object", "t", faint);
    for (std::size_t i = 0; i < met.size(); ++i) {
        write(std::to_string(i + 1), nameOf(met[i].kind), formatted("%.7g", met[i].hit.t) + (i == 0 ? "  nearest" : ""),
              i == 0 ? castRed : castInk);
    }
    for (const CastKind kind : shown) {
        if (std::ranges::find(met, kind, &CastCandidate::kind) == met.end()) write("-", nameOf(kind), "missed", faint);
    }
}

}  // namespace mv

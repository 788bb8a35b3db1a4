#include "mv/show/handle_input.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "mv/error.h"
#include "mv/geometry/strokes.h"

namespace mv {
namespace {

const vec2 newcomersStep(24, 24);  // pixels
constexpr double farSteps = 10;    // pixels

// A handle without a place in the present settings is not there.
std::optional<vec2> placeOf(const Handle& handle, const FrameInfo& frame, std::size_t which) {
    try {
        return handle.where(frame, which);
    } catch (const Error&) {
        return std::nullopt;
    }
}

vec2 stepOf(HandleInput::Move move) {
    switch (move) {
        case HandleInput::Move::left:
            return {-1, 0};
        case HandleInput::Move::right:
            return {1, 0};
        case HandleInput::Move::up:
            return {0, 1};
        case HandleInput::Move::down:
            return {0, -1};
        default:
            return {0, 0};
    }
}

}  // namespace

std::vector<HandleInput::Found> HandleInput::found(const Demo& demo, const FrameInfo& frame) {
    std::vector<Found> all;
    for (std::size_t i = 0; i < demo.handles().size(); ++i) {
        const Handle& handle = demo.handles()[i];
        for (std::size_t which = 0; which < handle.count(); ++which) {
            const std::optional<vec2> at = placeOf(handle, frame, which);
            const Box picture{vec2(0), vec2(frame.width(), frame.height())};
            if (at && picture.holds(*at)) all.push_back({{i, which}, *at});
        }
    }
    return all;
}

std::optional<HandleInput::Found> HandleInput::nearest(const Demo& demo, const FrameInfo& frame, const vec2& pointer,
                                                       double reach) {
    double least = reach;
    std::optional<Found> best;
    for (const Found& one : found(demo, frame)) {
        const double distance = glm::length(one.at - pointer);
        if (distance > least) continue;
        least = distance;
        best = one;
    }
    return best;
}

bool HandleInput::press(const Demo& demo, const FrameInfo& frame, const vec2& pointer, double reach) {
    picked_.reset();
    held_.reset();
    if (const auto one = nearest(demo, frame, pointer, reach)) held_ = {one->grip, one->at - pointer};
    return held_.has_value();
}

bool HandleInput::drag(Demo& demo, const FrameInfo& frame, const vec2& pointer) {
    if (!held_) return false;
    const Handle& handle = demo.handles()[held_->grip.handle];
    return handle.drag(frame, held_->grip.which, pointer + held_->offset);
}

void HandleInput::hover(const Demo& demo, const FrameInfo& frame, const std::optional<vec2>& pointer, double reach) {
    // Points may have been taken away beside this
    const auto isGone = [&](const Grip& grip) { return grip.which >= demo.handles()[grip.handle].count(); };
    if (picked_ && isGone(*picked_)) picked_.reset();
    if (held_ && isGone(held_->grip)) held_.reset();
    under_.reset();
    if (!pointer || held_) return;
    if (const auto one = nearest(demo, frame, *pointer, reach)) under_ = one->grip;
}

bool HandleInput::pickNext(const Demo& demo, const FrameInfo& frame) {
    const std::vector<Found> all = found(demo, frame);
    auto next = all.begin();
    if (picked_) {
        next = std::find_if(all.begin(), all.end(), [&](const Found& one) { return one.grip == *picked_; });
        if (next != all.end()) ++next;
    }
    picked_.reset();
    if (next != all.end()) picked_ = next->grip;
    return !demo.handles().empty();
}

bool HandleInput::changeNumber(const Demo& demo, const FrameInfo& frame, bool more, bool& moved) {
    const std::optional<Grip> meant = picked_ ? picked_ : under_;
    if (!meant) return false;
    const Handle& handle = demo.handles()[meant->handle];
    const auto& change = more ? handle.add : handle.remove;
    moved = change && change(meant->which);
    if (!moved) return true;
    held_.reset();
    picked_.reset();
    under_.reset();
    // A new one would be hidden by the one that it was made from
    if (more) {
        picked_ = {meant->handle, meant->which + 1};
        const std::optional<vec2> at = placeOf(handle, frame, picked_->which);
        if (at) handle.drag(frame, picked_->which, *at + newcomersStep);
    }
    return true;
}

bool HandleInput::key(Demo& demo, const FrameInfo& frame, Move move, bool far, bool& moved) {
    if (move == Move::next) return pickNext(demo, frame);
    if (move == Move::more || move == Move::less) return changeNumber(demo, frame, move == Move::more, moved);
    if (!picked_) return false;
    if (move == Move::letGo) {
        picked_.reset();
        return true;
    }
    const Handle& handle = demo.handles()[picked_->handle];
    const std::optional<vec2> at = placeOf(handle, frame, picked_->which);
    if (at) moved = handle.drag(frame, picked_->which, *at + (far ? farSteps : 1) * stepOf(move));
    return true;
}

std::vector<HandleInput::Place> HandleInput::places(const Demo& demo, const FrameInfo& frame) const {
    std::vector<Place> all;
    for (const Found& one : found(demo, frame)) {
        const Handle& handle = demo.handles()[one.grip.handle];
        const bool isActive = under_ == one.grip || picked_ == one.grip || (held_ && held_->grip == one.grip);
        all.push_back({handle.count() == 1 ? handle.name : handle.name + " " + std::to_string(one.grip.which + 1),
                       one.at, isActive});
    }
    return all;
}

}  // namespace mv

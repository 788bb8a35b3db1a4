#include "mv/demo/frame.h"

#include <algorithm>
#include <cmath>

#include "mv/error.h"

namespace mv {

void Frame::show(std::string_view name, const mat4& matrix) const { notes_->matrices.emplace_back(name, matrix); }

void Frame::say(std::string message) const { notes_->messages.push_back(std::move(message)); }

void Frame::count(std::string_view name, double amount) const { notes_->counts.emplace_back(name, amount); }

void Frame::needless(std::string what) const { notes_->needless.push_back(std::move(what)); }

FrameInfo FrameInfo::inUnits() const {
    FrameInfo frame = *this;
    frame.inUnits_ = true;
    frame.width_ = std::max(1, int(std::lround(pixelWidth_ / unit_)));
    frame.height_ = std::max(1, int(std::lround(pixelHeight_ / unit_)));
    return frame;
}

Pane FrameInfo::pixels(const Pane& pane) const {
    const auto across = [&](int x) { return int(std::lround(x * scale().x)); };
    const auto up = [&](int y) { return int(std::lround(y * scale().y)); };
    const int x = across(pane.x), y = up(pane.y);
    return {x, y, std::max(1, across(pane.x + pane.width) - x), std::max(1, up(pane.y + pane.height) - y)};
}

double figureUnit(int width, int height, int declaredWidth, int declaredHeight, double density) {
    constexpr double least = 0.8;  // words of 16 units are 13 pixels high, as in the panel; ticks of 13 are 10
    const double larger = std::min(double(width) / declaredWidth, double(height) / declaredHeight);
    return std::max(larger, least * density);
}

std::vector<Pane> FrameInfo::panes(int count) const {
    if (count < 1) throw Error("panes", "must be 1 or more", std::to_string(count));
    const int columns = static_cast<int>(std::ceil(std::sqrt(count))), rows = (count + columns - 1) / columns;
    const int width = std::max(1, (width_ - columns + 1) / columns), height = std::max(1, (height_ - rows + 1) / rows);
    std::vector<Pane> panes;
    for (int i = 0; i < count; ++i) {
        const int column = i % columns, row = i / columns;
        panes.push_back({column * (width + 1), height_ - (row + 1) * height - row, width, height});
    }
    return panes;
}

}  // namespace mv

#include "mv/demo/frame.h"

#include <algorithm>
#include <cmath>

#include "mv/error.h"

namespace mv {

void Frame::show(std::string_view name, const mat4& matrix) const { notes_->matrices.emplace_back(name, matrix); }

void Frame::say(std::string message) const { notes_->messages.push_back(std::move(message)); }

void Frame::count(std::string_view name, double amount) const { notes_->counts.emplace_back(name, amount); }

void Frame::needless(std::string what) const { notes_->needless.push_back(std::move(what)); }

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

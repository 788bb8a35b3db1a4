#include "mv/window/comparison.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "mv/gl/text.h"
#include "mv/image/compare.h"
#include "mv/show/caught.h"
#include "mv/show/compare.h"

namespace mv {
namespace {

constexpr int margin = 4;  // pixels between a label and the picture's edge

// Copies the columns from `left` to the right edge.
void copyFrom(int left, const Picture& source, Picture& to) {
    const auto bytes = static_cast<std::size_t>(source.width) * 4, start = static_cast<std::size_t>(left) * 4;
    for (std::size_t row = 0; row < source.rgba.size(); row += bytes) {
        std::copy_n(source.rgba.data() + row + start, bytes - start, to.rgba.data() + row + start);
    }
}

// A line three pixels wide, white with black on both sides, that is seen on every picture.
void drawDivider(int middle, Picture& picture) {
    for (int x = std::max(middle - 1, 0); x <= std::min(middle + 1, picture.width - 1); ++x) {
        const auto level = static_cast<std::uint8_t>(x == middle ? 255 : 0);
        for (int y = 0; y < picture.height; ++y) picture.set(x, y, {level, level, level});
    }
}

std::optional<std::string> anotherValue(const Knob& knob) {
    const std::string present = knob.text();
    if (present != knob.initialText()) return knob.initialText();
    const std::vector<std::string> values = knob.sweep();
    const auto last = std::find_if(values.rbegin(), values.rend(), [&](const auto& value) { return value != present; });
    return last == values.rend() ? std::nullopt : std::optional(*last);
}

}  // namespace

void Comparison::start(Knob& knob, const std::string& other) {
    const std::string present = knob.text();
    knob.parse(other);
    other_ = knob.text();  // "1.50" is 1.5
    knob.parse(present);
    knob_ = &knob;
    view_ = View::divider;
    divider_ = 0.5;
}

void Comparison::stop() {
    knob_ = nullptr;
    a_ = b_ = {};
    sheet_ = Target();
}

Comparison::Side Comparison::drawSide(Stage& stage, int index, bool readouts) const {
    Side side;
    const auto start = std::chrono::steady_clock::now();
    stage.draw(index, readouts);
    glFinish();
    side.milliseconds = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    side.picture = stage.picture();
    side.messages = stage.notes().messages;
    for (const Readout* readout : stage.demo().readouts()) side.readouts.push_back(readout->value());
    return side;
}

void Comparison::withOther(const std::function<void()>& action) {
    const std::string present = knob_->text();
    try {
        knob_->parse(other_);
        action();
    } catch (const std::exception&) {
        knob_->parse(present);
        throw Error("with " + labelB(), caughtSentence("the picture"));
    }
    knob_->parse(present);
}

void Comparison::check(const Demo& demo) {
    demo.check();
    withOther([&] { demo.check(); });
}

OtherPicture::Cost Comparison::draw(Stage& stage, int index, bool readouts) {
    Side b;
    stage.timeline().vary(KnobSetting{knob_->name(), other_});
    try {
        withOther([&] { b = drawSide(stage, index, readouts); });
    } catch (...) {
        stage.timeline().vary({});
        throw;
    }
    stage.timeline().vary({});
    a_ = drawSide(stage, index, readouts);
    b_ = std::move(b);
    words_ = labelStyle(stage, index);
    drawnA_ = labelA();
    drawnB_ = labelB();
    difference_.clear();
    stale_ = true;
    return {2, a_.milliseconds};
}

std::vector<std::string> Comparison::messages() const {
    const auto in = [](const std::vector<std::string>& all, const std::string& one) {
        return std::find(all.begin(), all.end(), one) != all.end();
    };
    std::vector<std::string> shown;
    for (const std::string& message : a_.messages) {
        shown.push_back(in(b_.messages, message) ? message : "with " + drawnA_ + ": " + message);
    }
    for (const std::string& message : b_.messages) {
        if (!in(a_.messages, message)) shown.push_back("with " + drawnB_ + ": " + message);
    }
    return shown;
}

void Comparison::setView(View view) {
    stale_ |= view != view_;
    view_ = view;
}

void Comparison::moveDivider(double to) {
    to = std::clamp(to, 0.0, 1.0);
    stale_ |= to != divider_;
    divider_ = to;
}

const std::string& Comparison::difference() {
    if (difference_.empty()) difference_ = differenceText(compare(a_.picture, b_.picture));
    return difference_;
}

Picture Comparison::composed() const {
    switch (view_) {
        case View::a:
            return a_.picture;
        case View::b:
            return b_.picture;
        case View::difference:
            return differencePicture(a_.picture, b_.picture);
        case View::divider:
            break;
    }
    Picture picture = a_.picture;
    const int middle = static_cast<int>(std::lround(divider_ * picture.width));
    copyFrom(middle, b_.picture, picture);
    drawDivider(middle, picture);
    return picture;
}

const Target& Comparison::sheet() {
    const int width = a_.picture.width, height = a_.picture.height;
    if (sheet_.width() != width || sheet_.height() != height) {
        sheet_ = Target(width, height, {}, "comparison");
    } else if (!stale_) {
        return sheet_;
    }
    sheet_.bind();
    const FrameInfo frame(0, width, height);
    showImage(frame, 0, 0, composed());
    if (view_ == View::difference) {
        drawText(frame, margin, margin, difference(), fittedStyle({difference()}, width - 2 * margin, words_));
    } else {
        const bool showA = view_ == View::a || (view_ == View::divider && divider_ > 0);
        const bool showB = view_ == View::b || (view_ == View::divider && divider_ < 1);
        const TextStyle style = fittedStyle({drawnA_, drawnB_}, width - 2 * margin, words_);
        const int widthA = textWidth(drawnA_, style), widthB = textWidth(drawnB_, style);
        // Beside each other, or where there is no room one below the other.
        const bool beside = !showA || widthA + widthB + 3 * margin <= width;
        if (showA) drawText(frame, margin, margin, drawnA_, style);
        if (showB)
            drawText(frame, width - margin - widthB, beside ? margin : style.height + 3 * margin, drawnB_, style);
    }
    stale_ = false;
    return sheet_;
}

bool canCompare(const Knob& knob) {
    return knob.text().find(',') == std::string::npos && anotherValue(knob).has_value();
}

std::string valueToCompareWith(const Knob& knob) { return anotherValue(knob).value_or(knob.text()); }

}  // namespace mv

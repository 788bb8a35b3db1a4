#include "mv/show/session.h"

#include <algorithm>
#include <chrono>

#include "mv/gl/gl.h"
#include "mv/show/caught.h"

namespace mv {

Session::Session(Stage& stage, const DemoInfo& info, const SessionStart& start)
    : stage_(stage),
      info_(info),
      playback_(framesDiffer(info, start.changes), start.frame, start.paused),
      until_(start.until),
      drawnFrame_(start.frame) {
    stage_.open(info, start.width, start.height);
    stage_.begin(start.knobs, start.changes);
    stage_.timeline().record();
}

std::string Session::set(const std::string& name, const std::string& text) {
    try {
        Knob& knob = demo().knob(name);
        const std::string before = knob.text();
        knob.parse(text);
        stale_ |= knob.text() != before;
        return "";
    } catch (const Error& error) {
        return error.what();
    }
}

// ---- What the user does

bool Session::press(Key key) {
    const auto& bindings = demo().bindings();
    const bool bound = std::any_of(bindings.begin(), bindings.end(), [&](const Binding& binding) {
        return binding.gesture == Gesture::key && binding.key == key;
    });
    if (bound) stale_ |= demo().press(key);
    return bound;
}

void Session::pointerDown(double x, double y) {
    dragging_ = true;
    dragX_ = x;
    dragY_ = y;
}

void Session::pointerMove(double x, double y) {
    if (!dragging_) return;
    stale_ |= demo().drag(x - dragX_, y - dragY_);
    dragX_ = x;
    dragY_ = y;
}

void Session::wheel(double notches) { stale_ |= demo().wheel(notches); }

void Session::restart() {
    playback_.restart();
    stage_.timeline().beginAnew();
    stale_ = true;
}

// ---- The picture

void Session::draw(int width, int height, bool readouts, OtherPicture* instead) {
    if (!due(width, height)) return;
    stale_ = false;
    triedWidth_ = width;
    triedHeight_ = height;
    try {
        // before the last picture's buffers go for ones of another size
        instead ? instead->check(demo()) : demo().check();
        const Target& last = stage_.front();
        if (last.width() != width || last.height() != height || last.buffers().samples != stage_.samples()) {
            hasPicture_ = false;
            stage_.resize(width, height);
        }
        const OtherPicture::Cost cost =
            instead ? instead->draw(stage_, playback_.frame(), readouts) : drawDemo(readouts);
        lastMs_ = cost.milliseconds;
        if (pictures_ == 0) firstMs_ = lastMs_;
        pictures_ += cost.pictures;
        drawnFrame_ = playback_.frame();
        hasPicture_ = true;
        error_.clear();
    } catch (const std::exception&) {
        error_ = caughtSentence(info_.name);
        takeErrors();
    }
}

void Session::finish(int width, int height, bool readouts, OtherPicture* instead) {
    do {
        draw(width, height, readouts, instead);
    } while (stale_);
}

OtherPicture::Cost Session::drawDemo(bool readouts) {
    const auto start = std::chrono::steady_clock::now();
    if (until_) {
        listenToDriver(true);  // this is where the driver's words are read
        stage_.draw(playback_.frame(), readouts);
    } else {
        stale_ = !stage_.drawNext(playback_.frame(), readouts);
    }
    glFinish();
    const double milliseconds =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    if (until_) {
        drawnFrame_ = playback_.frame();
        hasPicture_ = true;  // of the whole frame, where there are fewer draws than that
        stage_.stopAfter(playback_.frame(), *until_);
    }
    return {1, milliseconds};
}

FrameTimes Session::times(int runs) {
    if (runs > 0 && error_.empty() && hasPicture_) {
        try {
            const FrameTimes times = timeFrames(stage_, drawnFrame_, runs, firstMs_);
            if (until_) stage_.stopAfter(drawnFrame_, *until_);
            return times;
        } catch (const std::exception&) {
            error_ = caughtSentence(info_.name);
        }
    }
    return {firstMs_, lastMs_, 0, hasPicture_ ? 1 : 0};
}

}  // namespace mv

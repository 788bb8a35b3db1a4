#include "mv/demo/lesson.h"

#include <algorithm>
#include <cmath>

#include "mv/demo/seen.h"

namespace mv {
namespace {

// A WordChoice says which word it has.
class Word final : public WordChoice {
  public:
    Word(Demo* owner, const AnyRow& row, int initial) : WordChoice(owner, row.name, initial, row.options, row.help) {}
    using WordChoice::index;
};

// A Whole whose high end stands for `most`: from there a step leads to the number below it.
class WholeUpTo final : public Whole {
  public:
    WholeUpTo(Demo* owner, const AnyRow& row, int initial, std::function<int()> most)
        : Whole(owner, row.name, initial, row.wholes, row.help, row.unit), range_(row.wholes), most_(std::move(most)) {}
    bool step(double amount) override {
        const std::string before = text();
        take(std::clamp(present() + std::round(amount), double(range_.low), double(end())));
        return text() != before;
    }
    bool widget(Panel& panel) override {
        int shown = present();
        if (!panel.slider(*this, shown, range_.low, end())) return false;
        take(shown);
        return true;
    }

  private:
    int end() const { return std::clamp(most_(), range_.low, range_.high); }
    int present() const { return std::min<int>(*this, end()); }
    void take(double value) { parse(std::to_string(value >= end() ? range_.high : static_cast<int>(value))); }

    Range range_;
    std::function<int()> most_;
};

template <class Value>
const Value& at(const void* settings, const AnyRow& row) {
    return *reinterpret_cast<const Value*>(static_cast<const std::byte*>(settings) + row.offset);
}
template <class Value>
Value& at(void* settings, const AnyRow& row) {
    return *reinterpret_cast<Value*>(static_cast<std::byte*>(settings) + row.offset);
}

std::unique_ptr<Knob> makeKnob(Demo* owner, const AnyRow& row, const void* initial, std::function<int()> most) {
    const void* value = &at<std::byte>(initial, row);
    switch (row.kind) {
        case AnyRow::Kind::number:
            return std::make_unique<Real>(owner, row.name, at<double>(initial, row), row.range, row.help, row.unit);
        case AnyRow::Kind::angle:
            return std::make_unique<Angle>(owner, row.name, at<double>(initial, row), row.help);
        case AnyRow::Kind::whole:
            if (row.most) return std::make_unique<WholeUpTo>(owner, row, at<int>(initial, row), std::move(most));
            return std::make_unique<Whole>(owner, row.name, at<int>(initial, row), row.wholes, row.help, row.unit);
        case AnyRow::Kind::word:
            return std::make_unique<Word>(owner, row, row.index(value));
        case AnyRow::Kind::oneOf:
            return std::make_unique<NumberChoice>(owner, row.name, at<int>(initial, row), row.numbers, row.help);
        case AnyRow::Kind::toggle:
            return std::make_unique<Toggle>(owner, row.name, at<bool>(initial, row), row.help);
        case AnyRow::Kind::points:
            const std::span<const vec2> places = row.places(value);
            return std::make_unique<Points>(owner, row.name, std::vector<vec2>(places.begin(), places.end()),
                                            row.limits, row.help, row.unit);
    }
    throw Error("row " + row.name, "must be of a kind that there is");
}

void storeValue(const AnyRow& row, const Knob& knob, void* settings) {
    void* value = &at<std::byte>(settings, row);
    switch (row.kind) {
        case AnyRow::Kind::number:
        case AnyRow::Kind::angle:
            at<double>(settings, row) = static_cast<const Real&>(knob);
            break;
        case AnyRow::Kind::whole:
            at<int>(settings, row) = static_cast<const Whole&>(knob);
            break;
        case AnyRow::Kind::word:
            row.setIndex(value, static_cast<const Word&>(knob).index());
            break;
        case AnyRow::Kind::oneOf:
            at<int>(settings, row) = static_cast<const NumberChoice&>(knob);
            break;
        case AnyRow::Kind::toggle:
            at<bool>(settings, row) = static_cast<const Toggle&>(knob);
            break;
        case AnyRow::Kind::points:
            row.setPlaces(value, static_cast<const Points&>(knob).points());
            break;
    }
}

}  // namespace

void LessonBase::addRow(const AnyRow& row, const void* initial, std::function<int()> most) {
    bound_.push_back({&row, makeKnob(this, row, initial, std::move(most))});
    if (row.startsOver) bound_.back().knob->beginsAnew();
}

void LessonBase::addControl(const Control& control) {
    Knob& moved = knob(control.knob);
    switch (control.gesture) {
        case Gesture::key:
            if (control.other.empty())
                bindKeys(control.key, control.otherKey, moved, control.amount);
            else
                bindKey(control.key, moved, control.other);
            break;
        case Gesture::dragAcross:
        case Gesture::dragDown:
            bindDrag(moved, control.amount, knob(control.other), control.otherAmount);
            break;
        case Gesture::wheel:
            bindWheel(moved, control.amount);
            break;
    }
}

void LessonBase::addReadout(const Probe::Number& number) {
    told_.push_back(std::make_unique<Readout>(this, number.name, number.help, number.unit));
}

void LessonBase::store(void* settings) const {
    for (const Bound& bound : bound_) storeValue(*bound.row, *bound.knob, settings);
}

std::vector<Real*> LessonBase::reals(const std::vector<Literal>& names) const {
    std::vector<Real*> found;
    for (const Literal name : names) {
        for (const Bound& bound : bound_) {
            const bool isReal = bound.row->kind == AnyRow::Kind::number || bound.row->kind == AnyRow::Kind::angle;
            if (bound.row->name == name && isReal) found.push_back(static_cast<Real*>(bound.knob.get()));
        }
    }
    if (found.size() != names.size()) throw Error("handle", "must name rows that are numbers", names.front());
    return found;
}

Points& LessonBase::points(Literal name) const {
    for (const Bound& bound : bound_) {
        if (bound.row->name == name && bound.row->kind == AnyRow::Kind::points)
            return static_cast<Points&>(*bound.knob);
    }
    throw Error("handle", "must name a row of points", name);
}

void Numbers::set(const char* name, double value) {
    for (Readout* readout : demo_.readouts()) {
        if (readout->name() == std::string_view(name)) {
            *readout = value;
            return;
        }
    }
    throw Error("readout " + std::string(name), "must be one of the lesson's");
}

Scene seen(Scene scene, const Frame& frame) {
    if (const auto& camera = frame.camera()) {
        scene.viewFromWorld = camera->viewFromWorld;
        scene.clipFromView = camera->clipFromView;
    }
    return scene;
}

}  // namespace mv

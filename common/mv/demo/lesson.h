// A lesson: functions of plain settings, and rows that say what the settings are. Only the file knobs.cpp of a lesson
// includes this; the technique includes mv/demo/frame.h and mv/gl/gl.h.
//
//     struct Settings { ... };                                      // a value is a value
//     struct Gpu { Program program{"cube-cull"}; ... };             // what is made once a context is there
//     void draw(Gpu& gpu, const Settings& s, const Frame& frame);   // a function of its arguments
//
//     const bool added = addLesson(about, Lesson<Settings, Gpu>{.rows = {...}, .presets = {...}, .draw = draw});
//
// The comments on a Demo's functions of these names (mv/demo/demo.h) hold for a lesson's; addLesson() makes a Demo of
// it.
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "mv/demo/demo.h"
#include "mv/demo/numbers.h"
#include "mv/demo/row.h"

namespace mv {

// Settings worth a look. The first are Settings{}, which is how the lesson opens.
template <class Settings>
struct SettingsPreset {
    Literal name;
    Literal lookFor;
    Settings settings = {};
    std::vector<ExpectedReadout> expect = {};  // in frame 1; a test looks
};

// These settings with some of them changed: with(closeUp, [](Settings& s) { s.bias = 0; })
template <class Settings, class Change>
Settings with(Settings settings, Change change) {
    change(settings);
    return settings;
}

// Controls: two keys that step a setting, a key that sets it, a drag, and the wheel.
inline Control keys(Key less, Key more, Literal knob, double amount) {
    return {.gesture = Gesture::key, .knob = knob, .key = less, .otherKey = more, .amount = amount};
}
inline Control keySets(Key key, Literal knob, Literal text) {
    return {.gesture = Gesture::key, .knob = knob, .other = text, .key = key};
}
inline Control drag(Literal across, double perPixelAcross, Literal down, double perPixelDown) {
    return {.gesture = Gesture::dragAcross,
            .knob = across,
            .other = down,
            .amount = perPixelAcross,
            .otherAmount = perPixelDown};
}
inline Control wheel(Literal knob, double perNotch) {
    return {.gesture = Gesture::wheel, .knob = knob, .amount = perNotch};
}

// Handles, which are dragged in the picture: numbers by their names, or the points of one setting. `where` is the place of
// it in the picture, in what the frame counts (a figure's units) from the lower left corner; nothing where these settings
// have no such place.
template <class Settings>
struct LessonHandle {
    Literal name;
    std::vector<Literal> knobs;
    std::optional<vec2> (*where)(const Settings&, const FrameInfo&) = {};
    std::optional<vec2> (*wherePoint)(const Settings&, const FrameInfo&, const vec2& value) = {};
};

// The memory of a lesson that remembers nothing.
struct NothingKept {};

namespace lesson_detail {

// The functions of a lesson. `Kept` is what it remembers from frame to frame, or the picture that its passes make.
template <class Settings, class Gpu, class Kept>
struct Functions {
    using Draw = void (*)(Gpu&, const Settings&, const Kept&, const Frame&);
    using ReadOut = void (*)(Gpu&, const Settings&, const Kept&, const Frame&, Numbers&);
};
template <class Settings, class Gpu>
struct Functions<Settings, Gpu, NothingKept> {
    using Draw = void (*)(Gpu&, const Settings&, const Frame&);
    using ReadOut = void (*)(Gpu&, const Settings&, const Frame&, Numbers&);
};

// The address of one for each type.
template <class Settings>
inline constexpr char typeTag = 0;

}  // namespace lesson_detail

template <class Settings, class Gpu, class Kept = NothingKept>
struct Lesson {
    using Functions = lesson_detail::Functions<Settings, Gpu, Kept>;

    std::vector<Row<Settings>> rows = {};
    std::vector<SettingsPreset<Settings>> presets = {};
    std::vector<Control> controls = {};
    std::vector<LessonHandle<Settings>> handles = {};
    std::vector<Probe::Number> readouts = {};  // names, what they say, units

    typename Functions::Draw draw = {};
    // What a study has drawn in the place of that, where the picture's own shaders tell no quantity (measure.glsl).
    typename Functions::Draw measure = {};
    // Over the picture, what only people need: Demo::annotate. Its frame counts units, see FrameInfo::inUnits().
    typename Functions::Draw figure = {};
    typename Functions::ReadOut readOut = {};  // right after draw, where somebody reads the readouts
    void (*check)(const Settings&) = {};
    // These settings as the context can draw them, where it may lack one of needs.beyondEs: draw, figure and readOut
    // get what this returns. A context is current, and has() notes what it lacks.
    Settings (*fallback)(Settings) = {};
    Scene (*scene)(const Settings&, const FrameInfo&) = {};
    // A lesson that remembers: what it does at frame 0, and from frame index - 1 to index.
    Kept (*start)(const Settings&) = {};
    void (*step)(Kept&, const Settings&, int index) = {};
    // A picture made in passes.
    int (*passes)(const Settings&, const FrameInfo&) = {};
    void (*refine)(Kept&, const Settings&, const FrameInfo&, int pass) = {};
    // For a study of values.
    std::vector<double> (*values)(const Settings&) = {};
    std::vector<std::pair<std::string, double>> (*valueCounts)(const Settings&) = {};
};

template <class Settings, class Gpu, class Kept>
class LessonDemo final : public Demo {
  public:
    using Of = Lesson<Settings, Gpu, Kept>;

    explicit LessonDemo(std::shared_ptr<const Of> lesson, const Settings& initial = {})
        : lesson_(std::move(lesson)), settings_(initial) {
        if (lesson_->step) remembered_.emplace(this);
        for (const Row<Settings>& row : lesson_->rows) addRow(row, &settings_, &row_detail::example<Settings>());
        for (const Probe::Number& number : lesson_->readouts) addReadout(number);
        for (const Control& control : lesson_->controls) addControl(control);
        for (const LessonHandle<Settings>& handle : lesson_->handles) addHandle(handle);
    }

    const Settings& settings() const { return settings_; }

    void init() override { gpu_.emplace(); }
    void draw(const Frame& frame) override {
        paint(frame.measuring() && lesson_->measure ? lesson_->measure : lesson_->draw, frame);
        if (!lesson_->readOut || !frame.readouts()) return;
        Numbers numbers(*this);
        if constexpr (remembers)
            lesson_->readOut(*gpu_, drawable(), kept(), frame, numbers);
        else
            lesson_->readOut(*gpu_, drawable(), frame, numbers);
    }
    void annotate(const Frame& frame) override {
        if (lesson_->figure) paint(lesson_->figure, frame.inUnits());
    }
    void check() const override {
        checkFiles();
        if (lesson_->check) lesson_->check(settings_);
    }
    Scene scene(const FrameInfo& frame) const override {
        return lesson_->scene ? lesson_->scene(settings_, frame) : Demo::scene(frame);
    }
    void reset() override {
        if constexpr (remembers) {
            if (lesson_->start) **remembered_ = lesson_->start(settings_);
        }
    }
    void step(int index) override {
        if constexpr (remembers) {
            if (lesson_->step) lesson_->step(**remembered_, settings_, index);
        }
    }
    int passes(const FrameInfo& frame) const override {
        return lesson_->passes ? lesson_->passes(settings_, frame) : 0;
    }
    void refine(const FrameInfo& frame, int pass) override {
        if constexpr (remembers) lesson_->refine(made_, settings_, frame, pass);
    }
    std::vector<double> values() const override {
        return lesson_->values ? lesson_->values(settings_) : Demo::values();
    }
    std::vector<std::pair<std::string, double>> valueCounts() const override {
        return lesson_->valueCounts ? lesson_->valueCounts(settings_) : Demo::valueCounts();
    }
    bool copySettings(const void* type, void* to) const override {
        if (type != &lesson_detail::typeTag<Settings>) return false;
        *static_cast<Settings*>(to) = settings_;
        return true;
    }

  private:
    static constexpr bool remembers = !std::is_same_v<Kept, NothingKept>;

    const Kept& kept() const { return remembered_ ? **remembered_ : made_; }
    void paint(typename Of::Functions::Draw function, const Frame& frame) {
        if constexpr (remembers)
            function(*gpu_, drawable(), kept(), frame);
        else
            function(*gpu_, drawable(), frame);
    }
    Settings drawable() const { return lesson_->fallback ? lesson_->fallback(settings_) : settings_; }
    void addHandle(const LessonHandle<Settings>& handle) {
        if (handle.where) {
            addPlace(handle.name, handle.knobs,
                     [this, &handle](const FrameInfo& frame) { return inPixels(handle.where, frame); });
        } else {
            addPlaces(handle.name, handle.knobs.front(), [this, &handle](const FrameInfo& frame, const vec2& value) {
                return inPixels(handle.wherePoint, frame, value);
            });
        }
    }
    template <class Where, class... Value>
    std::optional<vec2> inPixels(Where where, const FrameInfo& frame, const Value&... value) const {
        const FrameInfo units = frame.inUnits();
        std::optional<vec2> place = where(settings_, units, value...);
        if (place) *place *= units.scale();
        return place;
    }

    std::shared_ptr<const Of> lesson_;
    Settings settings_;
    std::optional<Gpu> gpu_;
    std::optional<Memory<Kept>> remembered_;
    Kept made_{};
};

// What a demo is made of, beside its declaration.
struct DemoParts {
    std::vector<Preset> presets;
    std::function<std::unique_ptr<Demo>()> make;
};
// Adds a demo whose parts are made when somebody asks for it by findDemo() or for all by catalogue(), which tell then what addDemo()
// would refuse in its presets.
bool addDemoWhenAsked(const Declaration& about, std::string page, std::function<DemoParts()> parts);

template <class Settings, class Gpu, class Kept>
DemoParts partsOf(Lesson<Settings, Gpu, Kept> lesson) {
    using Made = LessonDemo<Settings, Gpu, Kept>;
    const auto shared = std::make_shared<const Lesson<Settings, Gpu, Kept>>(std::move(lesson));
    std::vector<Preset> presets;
    for (const auto& preset : shared->presets)
        presets.push_back(
            {preset.name, preset.lookFor, changedKnobs(Made(shared), Made(shared, preset.settings)), preset.expect});
    return {std::move(presets), [shared] { return std::unique_ptr<Demo>(new Made(shared)); }};
}

// Adds a lesson to the catalogue; called at file scope by its knobs.cpp. Its page is demos/NAME/NAME.md. Error: as
// addDemo(), or a preset with a value outside of its row's range. (A macro, so that what stands in the call is made when the lesson is
// asked for: a page has all of them and shows one.)
#define addLesson(about, ...)                                                     \
    addDemoWhenAsked(about, "demos/" + (about).name + "/" + (about).name + ".md", \
                     [] { return mv::partsOf(__VA_ARGS__); })

// The settings of a demo that is a lesson: what its study and its probes compute with. Error: it has settings of another
// type.
template <class Settings>
Settings settingsOf(const Demo& demo) {
    Settings settings;
    if (!demo.copySettings(&lesson_detail::typeTag<Settings>, &settings))
        throw Error("settings", "must be asked of the lesson that has them");
    return settings;
}

}  // namespace mv

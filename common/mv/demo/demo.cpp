#include "mv/demo/demo.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "mv/demo/chapters.h"
#include "mv/demo/lesson.h"
#include "mv/demo/read_number.h"

namespace mv {

Readout::Readout(Demo* owner, Literal name, Literal help, Literal unit) : name_(name), help_(help), unit_(unit) {
    owner->add(this);
}

AnyMemory::AnyMemory(Demo* owner) {
    if (owner->memory_) throw Error("Memory", "must be one for a demo: put all that it remembers into one struct");
    owner->memory_ = this;
}

void Demo::addRow(const AnyRow& row, void* settings, const void* initial) {
    auto made = std::make_unique<Knob>(row, settings, initial);
    for (const Knob* other : knobs_) {
        if (other->name() == made->name()) throw Error("knob " + made->name(), "must be declared once");
    }
    knobs_.push_back(made.get());
    madeKnobs_.push_back(std::move(made));
}

void Demo::addReadout(const Probe::Number& number) {
    madeReadouts_.push_back(std::make_unique<Readout>(this, number.name, number.help, number.unit));
}

void Demo::checkFiles() const {
    for (const Knob* knob : knobs_) {
        if (knob->kind() == Knob::Kind::file) knob->checkFile();
    }
}

Scene Demo::scene(const FrameInfo&) const {
    throw Error("scene", "must be given by a demo that draws one; this one gives none");
}

std::vector<double> Demo::values() const {
    throw Error("values", "must be computed by a demo whose study is of values; this one computes none");
}

Knob& Demo::knob(std::string_view name) const {
    const auto found = std::ranges::find_if(knobs_, [&](const Knob* knob) { return knob->name() == name; });
    if (found != knobs_.end()) return **found;
    std::vector<std::string> names;
    for (const Knob* knob : knobs_) names.push_back(knob->name());
    throw Error("--" + std::string(name), "is no knob of this demo" + suggestion(name, names));
}

double Demo::number(std::string_view name) const {
    const std::string text = word(name);
    double value = 0;
    if (!readNumber(text, value)) throw Error("--" + std::string(name), "must be a knob whose value is a number", text);
    return value;
}

bool Demo::press(Key key) {
    bool moved = false;
    for (const Binding& binding : bindings_) {
        if (binding.gesture != Gesture::key || binding.key != key) continue;
        if (binding.text.empty()) {
            moved |= binding.knob->step(binding.amount);
        } else if (binding.knob->text() != binding.text) {
            binding.knob->parse(binding.text);
            moved = true;
        }
    }
    return moved;
}

bool Demo::drag(double across, double down) {
    bool moved = false;
    for (const Binding& binding : bindings_) {
        if (binding.gesture == Gesture::dragAcross) moved |= binding.knob->step(binding.amount * across);
        if (binding.gesture == Gesture::dragDown) moved |= binding.knob->step(binding.amount * down);
    }
    return moved;
}

bool Demo::wheel(double notches) {
    bool moved = false;
    for (const Binding& binding : bindings_) {
        if (binding.gesture == Gesture::wheel) moved |= binding.knob->step(binding.amount * notches);
    }
    return moved;
}

void Demo::addControl(const Control& control) {
    Knob* const moved = &knob(control.knob);
    switch (control.gesture) {
        case Gesture::key:
            if (!control.other.empty()) {
                bindings_.push_back({Gesture::key, control.key, moved, 0, control.other});
            } else {
                bindings_.push_back({Gesture::key, control.key, moved, -control.amount});
                bindings_.push_back({Gesture::key, control.otherKey, moved, control.amount});
            }
            break;
        case Gesture::dragAcross:
        case Gesture::dragDown:
            bindings_.push_back({Gesture::dragAcross, Key{}, moved, control.amount});
            bindings_.push_back({Gesture::dragDown, Key{}, &knob(control.other), control.otherAmount});
            break;
        case Gesture::wheel:
            bindings_.push_back({Gesture::wheel, Key{}, moved, control.amount});
            break;
    }
}

void Demo::addPlace(Literal name, const std::vector<Literal>& numbers,
                    std::function<std::optional<vec2>(const FrameInfo&)> where) {
    Handle handle{.name = name, .knobs = {}};
    for (const Literal number : numbers) {
        handle.knobs.push_back(&knob(number));
        const Knob::Kind kind = handle.knobs.back()->kind();
        if (kind != Knob::Kind::number && kind != Knob::Kind::angle)
            throw Error("handle", "must name rows that are numbers", number);
    }
    handle.count = [] { return std::size_t{1}; };
    handle.coordinates = [knobs = handle.knobs](std::size_t) {
        std::vector<Coordinate> coordinates;
        for (Knob* knob : knobs) coordinates.push_back(knob->coordinate());
        return coordinates;
    };
    handle.where = [where = std::move(where)](const FrameInfo& frame, std::size_t) { return where(frame); };
    handles_.push_back(std::move(handle));
}

void Demo::addPlaces(Literal name, Literal pointsName,
                     std::function<std::optional<vec2>(const FrameInfo&, const vec2& value)> where) {
    Knob& points = knob(pointsName);
    if (points.kind() != Knob::Kind::points) throw Error("handle", "must name a row of points", pointsName);
    Handle handle{.name = name, .knobs = {&points}};
    handle.count = [&points] { return points.points().size(); };
    handle.coordinates = [&points](std::size_t i) {
        return std::vector<Coordinate>{points.coordinate(i, 0), points.coordinate(i, 1)};
    };
    handle.where = [&points, where = std::move(where)](const FrameInfo& frame, std::size_t i) {
        return where(frame, points.points()[i]);
    };
    if (!points.isFixedNumber()) {
        handle.add = [&points](std::size_t after) { return points.addPoint(after); };
        handle.remove = [&points](std::size_t i) { return points.removePoint(i); };
    }
    handles_.push_back(std::move(handle));
}

std::string keyName(Key key) {
    switch (key) {
        case Key::left:
            return "Left";
        case Key::right:
            return "Right";
        case Key::up:
            return "Up";
        case Key::down:
            return "Down";
    }
    return std::string(1, static_cast<char>(key));
}

namespace {

// A function's static, so that it exists before the first demo at file scope adds itself.
std::vector<DemoInfo>& demos() {
    static std::vector<DemoInfo> all;
    return all;
}

// The studies added so far, by the name of the demo, which may come later.
struct Measures {
    std::optional<Study> study;
    std::vector<Probe> probes;
    void give(DemoInfo& info) const {
        if (study) info.study = study;
        if (!probes.empty()) info.probes = probes;
    }
};

std::map<std::string, Measures, std::less<>>& measures() {
    static std::map<std::string, Measures, std::less<>> all;
    return all;
}

void giveToDemo(const std::string& name) {
    for (DemoInfo& info : demos()) {
        if (info.name == name) measures()[name].give(info);
    }
}

std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

}  // namespace

bool addStudy(const std::string& name, Study study) {
    if (measures()[name].study) throw Error("study of " + name, "must be added once");
    measures()[name].study = std::move(study);
    giveToDemo(name);
    return true;
}

bool addProbes(const std::string& name, std::vector<Probe> probes) {
    if (!measures()[name].probes.empty()) throw Error("probes of " + name, "must be added once");
    measures()[name].probes = std::move(probes);
    giveToDemo(name);
    return true;
}

void addProbedReadouts(Demo& demo, std::string_view name) {
    const auto found = measures().find(name);
    if (found == measures().end()) return;
    for (const Probe& probe : found->second.probes) {
        for (const Probe::Number& number : probe.numbers) demo.addReadout(number);
    }
}

namespace {

// Parts that nobody has asked for yet, by the names of the demos.
std::map<std::string, std::function<DemoParts()>>& unmadeParts() {
    static std::map<std::string, std::function<DemoParts()>> all;
    return all;
}

void giveParts(DemoInfo& info, DemoParts parts) {
    info.presets = std::move(parts.presets);
    checkPresets(info);
    info.make = [make = std::move(parts.make), name = info.name] {
        std::unique_ptr<Demo> demo = make();
        addProbedReadouts(*demo, name);
        return demo;
    };
}

void completeDemo(DemoInfo& info) {
    const auto found = unmadeParts().find(info.name);
    if (found == unmadeParts().end()) return;
    giveParts(info, found->second());
    unmadeParts().erase(found);
}

bool addInOrder(DemoInfo info) {
    auto& all = demos();
    for (const DemoInfo& other : all) {
        if (other.name == info.name) throw Error("demo " + info.name, "must be added once");
    }
    if (const auto found = measures().find(std::string_view(info.name)); found != measures().end())
        found->second.give(info);
    const auto order = [](const DemoInfo& d) { return std::pair(chapterPlace(d), d.number); };
    const auto place = std::find_if(all.begin(), all.end(), [&](const DemoInfo& d) { return order(d) > order(info); });
    all.insert(place, std::move(info));
    return true;
}

}  // namespace

bool addDemo(const Declaration& declaration, std::vector<Preset> presets, std::string page,
             std::function<std::unique_ptr<Demo>()> make) {
    DemoInfo info{declaration, {}, std::move(page)};
    giveParts(info, {std::move(presets), std::move(make)});
    return addInOrder(std::move(info));
}

bool addDemoWhenAsked(const Declaration& about, std::string page, std::function<DemoParts()> parts) {
    addInOrder({about, {}, std::move(page)});
    unmadeParts()[about.name] = std::move(parts);
    return true;
}

const std::vector<DemoInfo>& catalogue() {
    for (DemoInfo& info : demos()) completeDemo(info);
    for (const auto& measured : measures()) {
        const std::string& name = measured.first;
        const bool known =
            std::any_of(demos().begin(), demos().end(), [&](const DemoInfo& info) { return info.name == name; });
        if (!known) throw Error("study of " + name, "must measure a demo of this program");
    }
    return demos();
}

const DemoInfo& findDemo(std::string_view name) {
    std::vector<std::string> names;
    for (DemoInfo& info : demos()) {
        names.push_back(info.name);
        if (info.name != name) continue;
        completeDemo(info);
        return info;
    }
    throw Error("'" + std::string(name) + "'",
                "is no demo of this program (--list shows them)" + suggestion(name, names));
}

void applyKnobs(Demo& demo, const std::vector<KnobSetting>& settings) {
    for (const auto& [name, text] : settings) demo.knob(name).parse(text);
}

std::string nearestName(std::string_view word, const std::vector<std::string>& candidates) {
    std::string best;
    std::size_t least = std::max<std::size_t>(2, word.size() / 3) + 1;  // further off, it is another word
    for (const std::string& candidate : candidates) {
        const std::size_t distance = editDistance(word, candidate);
        if (distance < least) {
            least = distance;
            best = candidate;
        }
    }
    return best;
}

std::string suggestion(std::string_view word, const std::vector<std::string>& candidates) {
    const std::string nearest = nearestName(word, candidates);
    return nearest.empty() ? "" : "; did you mean '" + nearest + "'?";
}

}  // namespace mv

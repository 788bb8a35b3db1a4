#include "mv/show/timeline.h"

#include <algorithm>
#include <chrono>
#include <iterator>
#include <limits>
#include <utility>

namespace mv {
namespace {

// So many ways through time are remembered: the one shown, the other of two compared, and one before.
constexpr std::size_t mostRuns = 3;
// So many frames of each are kept; beyond, every second one is forgotten.
constexpr std::size_t mostKept = 64;

bool isEarlier(const TimedChange& a, const TimedChange& b) { return a.frame < b.frame; }

// The first frame at which they differ, or one that never comes.
int firstDifference(const std::vector<TimedChange>& a, const std::vector<TimedChange>& b) {
    const auto [inA, inB] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    const int never = std::numeric_limits<int>::max();
    return std::min(inA == a.end() ? never : inA->frame, inB == b.end() ? never : inB->frame);
}

}  // namespace

void Timeline::setChanges(std::vector<TimedChange> changes) {
    std::ranges::stable_sort(changes, isEarlier);
    told_.changes = std::move(changes);
}

void Timeline::beginAnew() {
    told_ = {};
    known_.clear();
    at_ = -1;
    runs_.clear();
}

void Timeline::vary(std::optional<KnobSetting> other) {
    if (matters() && !varied_) takeWhatWasMoved();  // before that knob is moved for the other picture
    varied_ = std::move(other);
}

Timeline::Texts Timeline::texts() const {
    Texts all;
    for (const Knob* knob : demo_.knobs()) all.push_back(knob->text());
    return all;
}

// Sets all knobs as they are with the changes of the frames before that one.
void Timeline::setKnobs(const Texts& beginning, const std::vector<TimedChange>& changes, int before) {
    Texts wanted = beginning;
    const std::vector<Knob*>& knobs = demo_.knobs();
    for (const TimedChange& change : changes) {
        if (change.frame >= before) break;
        for (std::size_t i = 0; i < knobs.size(); ++i) {
            if (knobs[i]->name() == change.knob) wanted[i] = change.text;
        }
    }
    for (std::size_t i = 0; i < knobs.size(); ++i) {
        if (knobs[i]->text() != wanted[i]) knobs[i]->parse(wanted[i]);
    }
}

void Timeline::takeWhatWasMoved() {
    const Texts present = texts();
    if (known_.empty()) {
        told_.beginning = known_ = present;
        return;
    }
    const std::vector<Knob*>& knobs = demo_.knobs();
    for (std::size_t i = 0; i < knobs.size(); ++i) {
        const std::string& name = knobs[i]->name();
        if (present[i] == known_[i] || (varied_ && varied_->name == name)) continue;
        std::string told = told_.beginning[i];
        for (const TimedChange& change : told_.changes) {
            if (change.frame <= at_ && change.knob == name) told = change.text;
        }
        if (present[i] == told) continue;
        if (recording_) std::erase_if(told_.changes, [&](const TimedChange& change) { return change.frame > at_; });
        if (!recording_ || at_ < 1) {
            told_.beginning[i] = present[i];
            continue;
        }
        std::erase_if(told_.changes,
                      [&](const TimedChange& change) { return change.frame == at_ && change.knob == name; });
        told_.changes.push_back({at_, name, present[i]});
    }
}

void Timeline::keep(Run& run) const {
    if (run.now % run.keptEach != 0) return;
    run.kept[run.now] = demo_.memory()->copy();
    if (run.kept.size() <= mostKept) return;
    run.keptEach *= 2;
    std::erase_if(run.kept, [&](const auto& each) { return each.first % run.keptEach != 0; });
}

Timeline::Run& Timeline::runOf(const Told& told) {
    auto found = std::find_if(runs_.begin(), runs_.end(),
                              [&](const auto& run) { return run->told.beginning == told.beginning; });
    if (found == runs_.begin() && found != runs_.end()) return *runs_.front();
    if (!runs_.empty() && demo_.memory()) runs_.front()->left = demo_.memory()->copy();
    if (found == runs_.end()) {
        if (runs_.size() == mostRuns) runs_.pop_back();
        found = runs_.insert(runs_.end(), std::make_unique<Run>());
    } else if (demo_.memory() && (*found)->now >= 0) {
        demo_.memory()->restore((*found)->left);
    }
    std::rotate(runs_.begin(), found, found + 1);
    return *runs_.front();
}

void Timeline::change(const Told& told, int frame) {
    bool beginsAnew = false;
    for (const TimedChange& change : told.changes) {
        if (change.frame != frame) continue;
        Knob& knob = demo_.knob(change.knob);
        const std::string before = knob.text();
        knob.parse(change.text);
        beginsAnew |= knob.doesBeginAnew() && knob.text() != before;
    }
    if (beginsAnew) demo_.reset();
}

// Goes back to the nearest frame before `to`, or that one, of which the memory is kept.
void Timeline::jump(Run& run, const Told& told, int to) {
    if (to != run.now || !run.entered) {
        const auto nearest = std::prev(run.kept.upper_bound(to));
        run.now = nearest->first;
        run.entered = nearest->second;
    }
    demo_.memory()->restore(run.entered);
    setKnobs(told.beginning, told.changes, run.now);
    change(told, run.now);
}

void Timeline::follow(Run& run, const Told& told, int index) {
    if (!demo_.memory()) {  // no frame follows from the one before: only the changes count, however far it is
        setKnobs(told.beginning, told.changes, std::min(index, std::numeric_limits<int>::max() - 1) + 1);
        return;
    }
    if (run.now < 0) {
        setKnobs(told.beginning, {}, 0);
        demo_.reset();
        run.now = 0;
        run.entered = run.kept[0] = demo_.memory()->copy();
    } else {
        const int differs = firstDifference(run.told.changes, told.changes);
        std::erase_if(run.kept, [&](const auto& each) { return each.first > differs; });
        const bool isKeptBetween = !run.kept.empty() && std::prev(run.kept.upper_bound(index))->first > run.now;
        if (differs <= run.now || index < run.now || isKeptBetween) {
            jump(run, told, std::min(differs, index));
        } else {
            setKnobs(told.beginning, told.changes, run.now + 1);
        }
    }
    run.told = told;

    auto said = std::chrono::steady_clock::now();
    while (run.now < index) {
        demo_.step(++run.now);
        keep(run);
        // A change at the frame that is shown begins here.
        run.entered = recording_ && run.now == index ? demo_.memory()->copy() : nullptr;
        change(told, run.now);
        if (run.now % 64 != 0 || !progress) continue;
        const auto now = std::chrono::steady_clock::now();
        if (now - said < std::chrono::seconds(2)) continue;
        said = now;
        progress(run.now, index);
    }
}

void Timeline::bring(int index) {
    if (!matters()) return;
    takeWhatWasMoved();
    Told told = told_;
    if (varied_) {
        const std::vector<Knob*>& knobs = demo_.knobs();
        for (std::size_t i = 0; i < knobs.size(); ++i) {
            if (knobs[i]->name() == varied_->name) told.beginning[i] = varied_->text;
        }
        std::erase_if(told.changes, [&](const TimedChange& change) { return change.knob == varied_->name; });
    }
    Run& run = runOf(told);
    try {
        follow(run, told, index);
    } catch (...) {
        runs_.erase(runs_.begin());  // half a step leads nowhere
        throw;
    }
    known_ = texts();
    at_ = index;
}

std::vector<KnobSetting> Timeline::beginning() const {
    std::vector<KnobSetting> all;
    const Texts begins = known_.empty() ? texts() : told_.beginning;
    const std::vector<Knob*>& knobs = demo_.knobs();
    for (std::size_t i = 0; i < knobs.size(); ++i) {
        if (begins[i] != knobs[i]->initialText()) all.push_back({knobs[i]->name(), begins[i]});
    }
    return all;
}

std::vector<TimedChange> Timeline::changesUntil(int index) const {
    std::vector<TimedChange> all;
    for (const TimedChange& change : told_.changes) {
        if (change.frame <= index) all.push_back(change);
    }
    return all;
}

}  // namespace mv

// The memory of a demo from frame to frame.
//
// Most demos need none: their picture is a function of knobs and frame number. One whose next frame follows from the last
// (masses on springs, a clock that sums up) keeps all that it remembers in one copyable struct:
//
//     struct Bodies { std::vector<vec3> places, velocities; };
//     Bodies start(const Settings& s) { ... }                          // at frame 0
//     void step(Bodies& bodies, const Settings& s, int index) { ... }  // from frame index - 1 to index
//     Lesson<Settings, Gpu, Bodies>{..., .draw = draw, .start = start, .step = step}
//
// The framework calls start() and then step() with 1, 2 ... in every mode alike, draws no frame without having stepped to
// it, and copies the struct to come back to a frame: so frame n is the same picture whatever was drawn before.
#pragma once
#include <memory>
#include <string>

namespace mv {

class Demo;

// A demo's memory as the framework knows it: how to keep it, and how to bring it back.
class AnyMemory {
  public:
    explicit AnyMemory(Demo* owner);
    virtual ~AnyMemory() = default;
    AnyMemory(const AnyMemory&) = delete;
    AnyMemory& operator=(const AnyMemory&) = delete;

    virtual std::shared_ptr<const void> copy() const = 0;
    // `kept` is a copy() of this very memory.
    virtual void restore(const std::shared_ptr<const void>& kept) = 0;
};

template <class State>
class Memory final : public AnyMemory {
  public:
    using AnyMemory::AnyMemory;
    State& operator*() { return state_; }
    const State& operator*() const { return state_; }
    State* operator->() { return &state_; }
    const State* operator->() const { return &state_; }

    std::shared_ptr<const void> copy() const override { return std::make_shared<const State>(state_); }
    void restore(const std::shared_ptr<const void>& kept) override { state_ = *static_cast<const State*>(kept.get()); }

  private:
    State state_{};
};

// A knob that is set at a frame: after the step to that frame, before it is drawn.
struct TimedChange {
    int frame;  // from 1; what is set before is how the demo begins
    std::string knob, text;
    bool operator==(const TimedChange&) const = default;
};

}  // namespace mv

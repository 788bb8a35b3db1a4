// Masses on springs that somebody plays with: their steps from frame to frame, and the balance of their energy. No GL.
#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "mv/motion/ode_method.h"
#include "mv/motion/spring_stepper.h"
#include "scenes.h"

namespace mv {

// At a time in seconds, energy and energy + dissipated - work, in J.
struct EnergySample {
    double time, energy, balance;
};

// The settings that somebody may change while it plays.
struct SpringRule {
    SpringSettings springs = {};
    std::optional<OdeMethod> method = {};  // none: energy-momentum
    int substeps = 1;                      // steps in a frame of 1/60 s, 1 or more
    bool operator==(const SpringRule&) const = default;
};

// A value: a copy goes on alike.
class SpringGame {
  public:
    static constexpr double frameTime = 1.0 / 60;
    static constexpr double lowerEdge =
        1.4;  // m below the origin, where heights count from: so there is energy at first

    SpringGame() = default;  // none yet: what follows is for one with a rule
    // At frame 0. Refused: as by makeSprings, and by the method.
    explicit SpringGame(const SpringRule& rule);

    // From frame index - 1 to frame `index`. The energy that another rule puts in is work. Nothing is
    // computed where nothing moves, or where a step has failed.
    void advance(const SpringRule& rule, int index);

    const SpringRule& rule() const { return rule_; }
    const SpringSetup& setup() const { return setup_; }
    const std::vector<double>& state() const { return stepper_->state(); }
    // No mass was faster than 1e-6 m/s nor accelerated by more than 1e-6 m/s^2: it stays where it is.
    bool rests() const { return rests_; }
    // "stopped at step 7, 0.117 s: WHY", or "".
    const std::string& failure() const { return failure_; }
    int stepsNow() const { return stepsNow_; }  // tried for this frame
    // The steps since the rule was last another; and in all, those that Newton's method could not do.
    const OdeCounts& counts() const { return stepper_->counts(); }
    std::int64_t halved() const { return halvedBefore_ + counts().rejected; }

    double energy() const;                               // J
    double dissipated() const;                           // J
    double work() const { return work_; }                // J
    double first() const { return first_; }              // J, the energy at the start
    double whole() const { return first_ + mostWork_; }  // J: that and the largest work so far
    // How far the balance is from the first energy, as a part of the whole; and the largest so far.
    double drift() const;
    double largestDrift() const { return largestDrift_; }
    // The last ten seconds at least.
    const std::vector<EnergySample>& graph() const { return graph_; }

    // Place and speed of the one spring by its formula, which go on where the computed ones rest; and how far it turned
    // in its last step, as computed, rad.
    const vec2& exact() const { return exact_; }
    double turned() const { return turned_; }

  private:
    SpringStepper stepperAt(double time, const std::vector<double>& state) const;
    void take(const SpringRule& rule, double time);
    bool isStill() const;
    void sample(double time);

    SpringRule rule_;
    SpringSetup setup_;
    std::optional<SpringStepper> stepper_;
    double first_ = 0, work_ = 0, mostWork_ = 0, largestDrift_ = 0;
    double dissipatedBefore_ = 0;  // J, by the steppers before this one
    std::int64_t halvedBefore_ = 0;
    bool rests_ = false;
    std::string failure_;
    long steps_ = 0;  // done
    int stepsNow_ = 0;
    vec2 exact_{pulled, 0};
    double turned_ = 0;
    std::vector<EnergySample> graph_;
};

}  // namespace mv

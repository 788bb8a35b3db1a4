// Readouts: numbers a demo reports about its picture. A lesson names them in `readouts` and sets them in `readOut`
// (mv/demo/lesson.h), a probe in its `numbers`; they are shown in the panel, printed by --report and checked by the tests.
#pragma once
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "mv/demo/literal.h"
#include "mv/error.h"

namespace mv {

class Demo;

class Readout {
  public:
    Readout(Demo* owner, Literal name, Literal help, Literal unit = "");
    Readout(const Readout&) = delete;
    Readout& operator=(const Readout&) = delete;

    // Sets the number for this frame. A readout that is not finite is a defect of the demo: Error.
    Readout& operator=(double value) {
        if (!std::isfinite(value)) throw Error("readout " + name_, "must be finite", numberText(value));
        value_ = value;
        return *this;
    }
    void clear() { value_.reset(); }

    Literal name() const { return name_; }
    Literal help() const { return help_; }
    Literal unit() const { return unit_; }
    std::optional<double> value() const { return value_; }  // empty: this setting does not measure it

  private:
    Literal name_, help_, unit_;
    std::optional<double> value_;
};

}  // namespace mv

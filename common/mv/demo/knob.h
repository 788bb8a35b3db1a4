// Knobs: the settings of a demo. Declared once as a member, a knob is a value in the code, a flag on the command line,
// a widget in the window, a row in the documentation and a state of the visits (tests/visits).
#pragma once
#include <atomic>
#include <functional>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "mv/demo/literal.h"
#include "mv/demo/panel.h"
#include "mv/error.h"

namespace mv {

class Demo;

// A knob and the value it is set to, as text.
struct KnobSetting {
    std::string name, text;
};
// The same as a demo declares it.
struct DeclaredSetting {
    Literal name, text;
    operator KnobSetting() const { return {name, text}; }
};

// A number of a knob that a hand in the picture moves (mv/demo/handle.h). `set` stops at the ends; an angle goes on
// past them, and drops whole turns.
struct Coordinate {
    std::function<double()> get;
    std::function<void(double)> set;
    double low, high;
    double grid = 0;  // the value ends as a multiple of this; 0: any number
};

// A setting. To add a kind of knob, derive from it and answer these questions; nothing else has to know the new kind.
// Every way to its value calls noteRead(): a study finds out so what a reference depends on.
class Knob {
  public:
    Knob(Demo* owner, Literal name, Literal help, Literal unit);
    virtual ~Knob() = default;
    Knob& operator=(const Knob&) = delete;

    Literal name() const { return name_; }  // in kebab-case; the flag is --name
    Literal help() const { return help_; }
    Literal unit() const { return unit_; }  // "" for a pure number; degrees are "deg"

    // The present value; parse(text()) gives exactly the same value again.
    virtual std::string text() const = 0;
    // Takes a value, or throws Error naming the flag and its range and leaves the value as it was.
    virtual void parse(std::string_view text) = 0;
    virtual std::string initialText() const = 0;
    // What is allowed, for people: "0.05 .. 10", "none | back | front | both".
    virtual std::string range() const = 0;
    // The same with its unit, and with "logarithmic" where the knob goes by factors.
    std::string rangeInFull() const;
    virtual Scale scale() const { return Scale::linear; }
    // The settings a test tries, as texts: the ends of the range and the initial one, or every choice. A logarithmic range
    // adds its middle, and one that allows 0 begins with it.
    virtual std::vector<std::string> sweep() const = 0;
    // Moves the value by `amount` (a key, a drag, a wheel notch). False where the range ends: nothing moved.
    virtual bool step(double amount) = 0;
    // What a step by `amount` does, for people: "+0.5 m"; of a logarithmic knob its factor.
    virtual std::string stepText(double amount, const std::string& unit) const;
    // Shows the knob; true when the user changed it.
    virtual bool widget(Panel& panel) = 0;
    // What each option means, for a Choice; empty for the rest.
    virtual std::vector<Option> options() const { return {}; }

    // Said in the demo's constructor: the knob changes nothing in the picture where `holds` is false, because of `reason`, a
    // clause: "the method keeps no map". The window greys it then, and whoever sets it is told.
    void onlyWhen(std::function<bool()> holds, Literal reason) { conditions_.push_back({std::move(holds), reason}); }

    // Said in the constructor of a demo with a Memory: a change of this knob calls reset(), as a number of masses does whose
    // places are remembered. Others (a stiffness) act from the next step on.
    void beginsAnew() { beginsAnew_ = true; }
    bool doesBeginAnew() const { return beginsAnew_; }

    bool isInitial() const { return text() == initialText(); }
    void reset() { parse(initialText()); }

    // Whether somebody has asked for the value, as text too, since forgetRead(). A thread may ask.
    bool wasRead() const { return read_.load(std::memory_order_relaxed); }
    void forgetRead() const { read_.store(false, std::memory_order_relaxed); }

  protected:
    // A copy belongs to no demo; it exists so that vec3(0, 0, knob) works, which takes its arguments by value. So it is
    // made to be read.
    Knob(const Knob& other) : name_(other.name_), help_(other.help_), unit_(other.unit_) { other.noteRead(); }
    void noteRead() const { read_.store(true, std::memory_order_relaxed); }
    // The error of a value that is not allowed.
    Error refused(std::string_view text) const;

  private:
    friend class Demo;
    struct Condition {
        std::function<bool()> holds;
        Literal reason;
    };
    Literal name_, help_, unit_;
    std::vector<Condition> conditions_;
    bool beginsAnew_ = false;
    mutable std::atomic<bool> read_{false};
};

// A number. Outside its range it is refused, never clamped.
//     Real near{this, "near", 0.1, {0.01, 2.5, Scale::logarithmic}, "where the view begins", "m"};
// A logarithmic one steps by factors, of 10 to the power of `amount`, and its slider has all decades at the same length;
// Error: its range reaches 0 or below. Where 0 is allowed all the same, as an end of its own below the range's low end,
// `orZero` says so: {1e-7, 0.1, Scale::logarithmic, true}.
class Real : public Knob {
  public:
    using Range = NumberRange;
    Real(Demo* owner, Literal name, double initial, Range range, Literal help, Literal unit = "");
    operator double() const {
        noteRead();
        return value_;
    }

    std::string text() const override { return numberText(double(*this)); }
    void parse(std::string_view text) override;
    std::string initialText() const override { return numberText(initial_); }
    std::string range() const override;
    Scale scale() const override { return range_.scale; }
    std::vector<std::string> sweep() const override;
    bool step(double amount) override;
    std::string stepText(double amount, const std::string& unit) const override;
    bool widget(Panel& panel) override;
    virtual Coordinate coordinate();

  protected:
    bool allowed(double number) const;

    double value_;
    double initial_;
    Range range_;
};

// An angle in degrees between -360 and 360 that goes on turning: a step past either end drops whole turns, with the
// sign kept, as % does in JavaScript.
class Angle : public Real {
  public:
    Angle(Demo* owner, Literal name, double initial, Literal help);
    // Between the ends, which are the same turn as 0, one that is seen.
    std::vector<std::string> sweep() const override { return {"-360", initialText(), "40", "360"}; }
    bool step(double amount) override;
    Coordinate coordinate() override;
};

// A whole number.
class Whole : public Knob {
  public:
    struct Range {
        int low, high;
    };
    Whole(Demo* owner, Literal name, int initial, Range range, Literal help, Literal unit = "");
    operator int() const {
        noteRead();
        return value_;
    }

    std::string text() const override { return std::to_string(int(*this)); }
    void parse(std::string_view text) override;
    std::string initialText() const override { return std::to_string(initial_); }
    std::string range() const override;
    std::vector<std::string> sweep() const override;
    bool step(double amount) override;
    bool widget(Panel& panel) override;

  private:
    int value_;
    int initial_;
    Range range_;
};

// On or off.
class Toggle : public Knob {
  public:
    Toggle(Demo* owner, Literal name, bool initial, Literal help);
    operator bool() const {
        noteRead();
        return value_;
    }

    std::string text() const override { return bool(*this) ? "on" : "off"; }
    void parse(std::string_view text) override;
    std::string initialText() const override { return initial_ ? "on" : "off"; }
    std::string range() const override { return "on | off"; }
    std::vector<std::string> sweep() const override { return {"off", "on"}; }
    bool step(double amount) override;
    bool widget(Panel& panel) override;

  private:
    bool value_;
    bool initial_;
};

// One of a few words; Choice below gives it an enumeration.
class WordChoice : public Knob {
  public:
    WordChoice(Demo* owner, Literal name, int initial, std::initializer_list<DeclaredOption> options, Literal help);

    std::string text() const override { return options_[static_cast<std::size_t>(index())].word; }
    void parse(std::string_view text) override;
    std::string initialText() const override { return options_[static_cast<std::size_t>(initial_)].word; }
    std::string range() const override;
    std::vector<std::string> sweep() const override;
    bool step(double amount) override;
    bool widget(Panel& panel) override;
    std::vector<Option> options() const override { return options_; }

  protected:
    WordChoice(Demo* owner, Literal name, int initial, std::vector<Option> options, Literal help);
    int index() const {
        noteRead();
        return index_;
    }

  private:
    int index_;
    int initial_;
    std::vector<Option> options_;
};

// A choice held as an enumeration whose values count from 0 in the order of the options:
//     enum class Cull { none, back, front, both };
//     Choice<Cull> cull{this, "cull", Cull::back, {{"none"}, {"back"}, {"front"}, {"both"}}, "faces to discard"};
template <class Enum>
class Choice : public WordChoice {
  public:
    Choice(Demo* owner, Literal name, Enum initial, std::initializer_list<DeclaredOption> options, Literal help)
        : WordChoice(owner, name, static_cast<int>(initial), options, help) {}
    operator Enum() const { return static_cast<Enum>(index()); }
};

// A choice of a few whole numbers, which gives the number itself:
//     NumberChoice resolution{this, "resolution", 512, {256, 512, 1024}, "texels along a side of the map"};
// A power of ten from 1000 on is written 1e3; on the command line every way to write a number is understood.
class NumberChoice : public WordChoice {
  public:
    NumberChoice(Demo* owner, Literal name, int initial, std::initializer_list<int> numbers, Literal help);
    NumberChoice(Demo* owner, Literal name, int initial, std::vector<int> numbers, Literal help);
    operator int() const { return numbers_[static_cast<std::size_t>(index())]; }
    void parse(std::string_view text) override;

  private:
    std::vector<int> numbers_;
};

}  // namespace mv

// Knobs: the settings of a lesson by their names. A row (mv/demo/row.h) makes of a member of the lesson's settings a flag on the command
// line, a widget in the window, a row in the documentation and a state of the visits (tests/visits); all these reach it as a knob.
#pragma once
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mv/demo/literal.h"
#include "mv/error.h"
#include "mv/math/types.h"

namespace mv {

struct FileKind;

// A knob and the value it is set to, as text.
struct KnobSetting {
    std::string name, text;
};

// One of the words that a setting can be: what is typed on the command line, and what it means.
struct Word {
    Literal word;
    Literal meaning = {};
};
// The same as text, of one of a few numbers, too.
struct Option {
    std::string word, meaning = {};
};

// How a knob goes through its range: by equal differences, or by equal factors.
enum class Scale { linear, logarithmic };

// The numbers that a knob allows. A logarithmic one steps by factors, of 10 to the power of the step, and its slider has all decades at
// the same length; its range lies above 0. `orZero` allows 0 all the same, as an end of its own below the low one:
// {1e-7, 0.1, Scale::logarithmic, true}.
struct NumberRange {
    double low, high;
    Scale scale = Scale::linear;
    bool orZero = false;
};
struct WholeRange {
    int low, high;
};

// The points that a knob allows. On the command line they are x,y/x,y/x,y.
struct PointLimits {
    vec2 low, high;
    std::size_t least, most;  // points
    double grid;              // each coordinate is a multiple of this
};

// A row without the type of its settings: what a setting is, and where it is in them.
struct AnyRow {
    enum class Kind { number, angle, whole, word, oneOf, toggle, points, file } kind;
    Literal name, help, unit = {};
    std::size_t offset;
    NumberRange range = {};                   // of a number
    WholeRange wholes = {};                   // of a whole number
    std::vector<Word> words = {};             // of a word
    std::vector<int> numbers = {};            // of one of a few
    PointLimits limits = {};                  // of points
    int (*index)(const void* value) = {};     // of a word: its place among the options
    void (*setIndex)(void* value, int) = {};  //
    std::span<const vec2> (*places)(const void* value) = {};
    void (*setPlaces)(void* value, const std::vector<vec2>&) = {};
    const FileKind* files = {};                          // of a file; its value is the name, a std::string
    Literal sample = {};                                 // a file of the tree, which tests set it to
    std::function<int(const void* settings)> most = {};  // of a whole number: how far it does something now
    bool startsOver = false;
    struct Condition {
        std::function<bool(const void* settings)> holds;
        Literal reason;
    };
    std::vector<Condition> conditions = {};
};

// A number of a knob that a hand in the picture moves (mv/demo/handle.h). `set` stops at the ends; an angle goes on
// past them, and drops whole turns.
struct Coordinate {
    std::function<double()> get;
    std::function<void(double)> set;
    double low, high;
    double grid = 0;  // the value ends as a multiple of this; 0: any number
};

class Knob {
  public:
    using Kind = AnyRow::Kind;

    // The setting of `row` in those settings; both stay where they are. The initial value is the one in `initial`.
    // Error: the range is none, or the value lies outside of it.
    Knob(const AnyRow& row, void* settings, const void* initial);

    Kind kind() const { return row_.kind; }
    Literal name() const { return row_.name; }  // in kebab-case; the flag is --name
    Literal help() const { return row_.help; }
    Literal unit() const { return row_.unit; }  // "" for a pure number; degrees are "deg"

    // The present value; parse(text()) gives exactly the same value again.
    std::string text() const { return textIn(settings_); }
    // Takes a value, or throws Error naming the flag and its range and leaves the value as it was. Nothing is clamped.
    void parse(std::string_view text);
    std::string initialText() const { return textIn(initial_); }
    bool isInitial() const { return text() == initialText(); }
    void reset() { parse(initialText()); }

    // The allowed values, for people: "0.05 .. 10", "none | back | front | both".
    std::string range() const;
    // The same with its unit, and with "logarithmic" where the knob goes by factors.
    std::string rangeInFull() const;
    Scale scale() const { return row_.range.scale; }
    // The settings a test tries, as texts: the ends of the range and the initial one, or every choice. A logarithmic range
    // adds its middle, and one that allows 0 begins with it. Points have as few as there may be, in the low corner, the
    // initial ones, and as many as there may be, from corner to corner.
    std::vector<std::string> sweep() const;
    // Moves the value by `amount` (a key, a drag, a wheel notch); points all along x. False where the range ends: nothing moved.
    bool step(double amount);
    // The effect of a step by `amount`, for people: "+0.5 m"; of a logarithmic knob its factor.
    std::string stepText(double amount, const std::string& unit) const;
    // Whether its change begins a remembered lesson anew.
    bool doesBeginAnew() const { return row_.startsOver; }
    // Why it changes nothing in the present settings; "" where it does something.
    std::string idleReason() const;

    // ---- For widgets. A value that a hand has chosen stops at the ends.

    // For a number, an angle or a whole number. A whole one that ends earlier in the present settings (AnyRow::most)
    // goes to there, and is set to its highest value there, which stands for that.
    double number() const;
    void setNumber(double value);
    NumberRange numbers() const;
    bool isOn() const;  // of a toggle
    void setOn(bool on);
    std::vector<Option> options() const;  // of a word, or of one of a few numbers; else none
    int index() const;                    // among these
    void choose(int index);
    // For a file: Error, with the flag before it: one is set, and is missing or of another kind. And whether a file of
    // this name is of the knob's kind, by its ending alone.
    void checkFile() const;
    bool takes(std::string_view file) const;
    // The endings of these names, as a page's field lists them: ".png,.jpg,.jpeg".
    std::string endings() const;
    // For points: x (0) or y (1) of one, for a handle; for a number the number itself.
    std::span<const vec2> points() const;
    bool isFixedNumber() const { return row_.limits.least == row_.limits.most; }
    bool canAddPoint() const { return points().size() < row_.limits.most; }
    bool canRemovePoint() const { return points().size() > row_.limits.least; }
    // One more after that one, at the same place, or one less; false where there are as many, or as few, as there may be.
    bool addPoint(std::size_t after);
    bool removePoint(std::size_t point);
    Coordinate coordinate();
    Coordinate coordinate(std::size_t point, int axis);

  private:
    template <class Value>
    const Value& value(const void* settings) const {
        return *reinterpret_cast<const Value*>(static_cast<const std::byte*>(settings) + row_.offset);
    }
    template <class Value>
    const Value& value() const {
        return value<Value>(settings_);
    }
    template <class Value>
    Value& value() {
        return *reinterpret_cast<Value*>(static_cast<std::byte*>(settings_) + row_.offset);
    }
    std::string textIn(const void* settings) const;
    // The error of a value that is not allowed.
    Error refused(std::string_view text) const;
    bool allows(double number) const;
    bool stepNumber(double amount);
    std::vector<vec2> pointsIn(std::string_view text) const;
    double onGrid(double coordinate, int axis) const;

    const AnyRow& row_;
    void* settings_;
    const void* initial_;
};

}  // namespace mv

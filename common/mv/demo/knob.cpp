#include "mv/demo/knob.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "mv/demo/demo.h"
#include "mv/demo/number.h"

namespace mv {
namespace {

// The number nearest to `value` that has so many significant digits.
double withDigits(double value, int digits) {
    char text[32];
    std::snprintf(text, sizeof text, "%.*e", digits - 1, value);
    double number = value;
    readNumber(text, number);
    return number;
}

// "512", "1e6".
std::string wordOf(int number) {
    int zeros = 0, rest = number;
    for (; rest > 0 && rest % 10 == 0; rest /= 10) ++zeros;
    return rest == 1 && zeros >= 3 ? "1e" + std::to_string(zeros) : std::to_string(number);
}

std::vector<Option> wordsOf(const std::vector<int>& numbers) {
    std::vector<Option> options;
    options.reserve(numbers.size());
    for (const int number : numbers) options.push_back({wordOf(number)});
    return options;
}

int placeOf(int number, const std::vector<int>& numbers) {
    return static_cast<int>(std::find(numbers.begin(), numbers.end(), number) - numbers.begin());
}

}  // namespace

Knob::Knob(Demo* owner, Literal name, Literal help, Literal unit) : name_(name), help_(help), unit_(unit) {
    owner->add(this);
}

Error Knob::refused(std::string_view text) const {
    std::string rule = "must be " + range();
    if (!unit_.empty()) rule += " " + unit_;
    return Error("--" + name_, rule, "'" + std::string(text) + "'");
}

std::string Knob::rangeInFull() const {
    return range() + (unit_.empty() ? "" : " " + unit_) + (scale() == Scale::logarithmic ? ", logarithmic" : "");
}

std::string Knob::stepText(double amount, const std::string& unit) const {
    return (amount > 0 ? "+" : "") + numberText(withDigits(amount, 4)) + (unit.empty() ? "" : " " + unit);
}

// ---- Real

Real::Real(Demo* owner, Literal name, double initial, Range range, Literal help, Literal unit)
    : Knob(owner, name, help, unit), value_(initial), initial_(initial), range_(range) {
    const bool logarithmic = range.scale == Scale::logarithmic;
    if (logarithmic && !(range.low > 0)) {
        throw Error("knob " + this->name(), "must have a logarithmic range above 0", this->range());
    }
    if (range.orZero && !logarithmic) {
        throw Error("knob " + this->name(), "must be logarithmic to have 0 as an end of its own", this->range());
    }
    if (!allowed(initial)) throw refused(numberText(initial));
}

bool Real::allowed(double number) const {
    return (range_.low <= number && number <= range_.high) || (range_.orZero && number == 0);
}

void Real::parse(std::string_view text) {
    double number = 0;
    if (!readNumber(text, number) || !allowed(number)) throw refused(text);
    value_ = number == 0 ? 0 : number;  // -0 would print as "-0"
}

std::string Real::range() const {
    return (range_.orZero ? "0 or " : "") + numberText(range_.low) + " .. " + numberText(range_.high);
}

std::vector<std::string> Real::sweep() const {
    const std::string low = numberText(range_.low), high = numberText(range_.high);
    if (range_.scale == Scale::linear) return {low, initialText(), high};
    const std::string middle = numberText(withDigits(std::sqrt(range_.low) * std::sqrt(range_.high), 3));
    if (range_.orZero) return {"0", low, middle, initialText(), high};
    return {low, middle, initialText(), high};
}

std::string Real::stepText(double amount, const std::string& unit) const {
    if (range_.scale == Scale::linear) return Knob::stepText(amount, unit);
    return "\u00D7 " + numberText(withDigits(std::pow(10.0, amount), 3));
}

bool Real::step(double amount) {
    if (range_.scale == Scale::logarithmic) {
        // Below the low end there is 0, where it is allowed; from there the first step leads to the low end again.
        const bool up = amount > 0;
        double moved = value_ == 0 ? (up ? range_.low : 0) : withDigits(value_ * std::pow(10.0, amount), 4);
        if (value_ == range_.low && range_.orZero && amount < 0) moved = 0;
        if (moved != 0) moved = std::clamp(moved, range_.low, range_.high);
        return std::exchange(value_, moved) != moved;
    }
    // Steps of 0.1 or 0.2 are not exact in binary; on a grid of 1e-9 twenty of them lead from -4 to 0 and not to 1e-15.
    const double moved = std::round((value_ + amount) * 1e9) / 1e9;
    const double stopped = std::clamp(moved, range_.low, range_.high);
    if (stopped == value_) return false;
    value_ = stopped == 0 ? 0 : stopped;
    return true;
}

bool Real::widget(Panel& panel) { return panel.slider(*this, value_, range_); }

Coordinate Real::coordinate() {
    const auto set = [this](double value) { value_ = std::clamp(value, range_.low, range_.high) + 0.0; };  // no -0
    return {[this] { return double(*this); }, set, range_.low, range_.high};
}

// ---- Angle

Angle::Angle(Demo* owner, Literal name, double initial, Literal help)
    : Real(owner, name, initial, {-360, 360}, help, "deg") {}

bool Angle::step(double amount) {
    if (amount == 0) return false;
    value_ = std::fmod(std::round((value_ + amount) * 1e9) / 1e9, 360.0);
    if (value_ == 0) value_ = 0;
    return true;
}

Coordinate Angle::coordinate() {
    const auto set = [this](double value) { value_ = std::fmod(value, 360.0) + 0.0; };
    return {[this] { return double(*this); }, set, range_.low, range_.high};
}

// ---- Whole

Whole::Whole(Demo* owner, Literal name, int initial, Range range, Literal help, Literal unit)
    : Knob(owner, name, help, unit), value_(initial), initial_(initial), range_(range) {
    if (initial < range.low || initial > range.high) throw refused(std::to_string(initial));
}

void Whole::parse(std::string_view text) {
    int number = 0;
    if (!readNumber(text, number) || number < range_.low || number > range_.high) throw refused(text);
    value_ = number;
}

std::string Whole::range() const { return std::to_string(range_.low) + " .. " + std::to_string(range_.high); }

std::vector<std::string> Whole::sweep() const {
    std::vector<std::string> texts;
    if (range_.high - range_.low < 12) {  // few enough to try each
        for (int i = range_.low; i <= range_.high; ++i) texts.push_back(std::to_string(i));
        return texts;
    }
    return {std::to_string(range_.low), initialText(), std::to_string(range_.high)};
}

bool Whole::step(double amount) {
    const int stopped =
        static_cast<int>(std::clamp(value_ + std::round(amount), double(range_.low), double(range_.high)));
    return std::exchange(value_, stopped) != stopped;
}

bool Whole::widget(Panel& panel) { return panel.slider(*this, value_, range_.low, range_.high); }

// ---- Toggle

Toggle::Toggle(Demo* owner, Literal name, bool initial, Literal help)
    : Knob(owner, name, help, ""), value_(initial), initial_(initial) {}

void Toggle::parse(std::string_view text) {
    if (text != "on" && text != "off") throw refused(text);
    value_ = text == "on";
}

bool Toggle::step(double amount) {
    if (amount == 0) return false;
    value_ = !value_;
    return true;
}

bool Toggle::widget(Panel& panel) { return panel.checkbox(*this, value_); }

// ---- Choice

WordChoice::WordChoice(Demo* owner, Literal name, int initial, std::vector<Option> options, Literal help)
    : Knob(owner, name, help, ""), index_(initial), initial_(initial), options_(std::move(options)) {
    if (initial < 0 || initial >= static_cast<int>(options_.size())) throw refused(std::to_string(initial));
}

WordChoice::WordChoice(Demo* owner, Literal name, int initial, std::initializer_list<DeclaredOption> options,
                       Literal help)
    : WordChoice(owner, name, initial, std::vector<Option>(options.begin(), options.end()), help) {}

void WordChoice::parse(std::string_view text) {
    const auto found = std::find_if(options_.begin(), options_.end(), [&](const Option& o) { return o.word == text; });
    if (found == options_.end()) throw refused(text);
    index_ = static_cast<int>(found - options_.begin());
}

std::string WordChoice::range() const {
    std::string words;
    for (const Option& option : options_) words += (words.empty() ? "" : " | ") + option.word;
    return words;
}

std::vector<std::string> WordChoice::sweep() const {
    std::vector<std::string> texts;
    for (const Option& option : options_) texts.push_back(option.word);
    return texts;
}

bool WordChoice::step(double amount) {
    if (amount == 0) return false;
    const int count = static_cast<int>(options_.size());
    index_ = (index_ + (amount > 0 ? 1 : count - 1)) % count;
    return true;
}

bool WordChoice::widget(Panel& panel) { return panel.choose(*this, index_, options_); }

NumberChoice::NumberChoice(Demo* owner, Literal name, int initial, std::initializer_list<int> numbers, Literal help)
    : NumberChoice(owner, name, initial, std::vector<int>(numbers), help) {}

NumberChoice::NumberChoice(Demo* owner, Literal name, int initial, std::vector<int> numbers, Literal help)
    : WordChoice(owner, name, placeOf(initial, numbers), wordsOf(numbers), help), numbers_(std::move(numbers)) {}

void NumberChoice::parse(std::string_view text) {
    double number = 0;
    const bool read = readNumber(text, number);
    const auto found = std::find_if(numbers_.begin(), numbers_.end(), [&](int n) { return read && n == number; });
    if (found == numbers_.end()) throw refused(text);
    WordChoice::parse(wordOf(*found));
}

}  // namespace mv

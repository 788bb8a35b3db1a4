#include "mv/demo/knob.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "mv/demo/own_file.h"
#include "mv/demo/read_number.h"

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

std::string textOf(std::span<const vec2> points) {
    std::string text;
    for (const vec2& point : points)
        text += (text.empty() ? "" : "/") + numberText(point.x) + "," + numberText(point.y);
    return text;
}

void requireRange(const AnyRow& row, const Knob& knob) {
    const bool logarithmic = row.range.scale == Scale::logarithmic;
    if (logarithmic && !(row.range.low > 0))
        throw Error("knob " + row.name, "must have a logarithmic range above 0", knob.range());
    if (row.range.orZero && !logarithmic)
        throw Error("knob " + row.name, "must be logarithmic to have 0 as an end of its own", knob.range());
}

constexpr const char* noFile = "none";

}  // namespace

Knob::Knob(const AnyRow& row, void* settings, const void* initial) : row_(row), settings_(settings), initial_(initial) {
    requireRange(row, *this);
    parse(text());  // refused, if it is none
}

Error Knob::refused(std::string_view text) const {
    std::string rule = (kind() == Kind::whole ? "must be a whole number in " : "must be ") + range();
    if (!unit().empty()) rule += " " + unit();
    return Error("--" + name(), rule, "'" + std::string(text) + "'");
}

std::string Knob::textIn(const void* settings) const {
    switch (kind()) {
        case Kind::number:
        case Kind::angle:
            return numberText(value<double>(settings));
        case Kind::whole:
            return std::to_string(value<int>(settings));
        case Kind::oneOf:
            return wordOf(value<int>(settings));
        case Kind::word:
            return row_.words[static_cast<std::size_t>(row_.index(&value<std::byte>(settings)))].word;
        case Kind::toggle:
            return value<bool>(settings) ? "on" : "off";
        case Kind::points:
            return textOf(row_.places(&value<std::byte>(settings)));
        case Kind::file:
            return value<std::string>(settings);
    }
    return {};
}

bool Knob::allows(double number) const {
    const NumberRange range =
        kind() == Kind::whole ? NumberRange{double(row_.wholes.low), double(row_.wholes.high)} : row_.range;
    return (range.low <= number && number <= range.high) || (range.orZero && number == 0);
}

void Knob::parse(std::string_view text) {
    double number = 0;
    switch (kind()) {
        case Kind::number:
        case Kind::angle:
            if (!readNumber(text, number) || !allows(number)) throw refused(text);
            value<double>() = number == 0 ? 0 : number;  // -0 would print as "-0"
            break;
        case Kind::whole:
            // However it is written: 1e3 is one
            if (!readNumber(text, number) || number != std::floor(number) || !allows(number)) throw refused(text);
            value<int>() = static_cast<int>(number);
            break;
        case Kind::oneOf: {
            const bool isRead = readNumber(text, number);
            const auto found =
                std::find_if(row_.numbers.begin(), row_.numbers.end(), [&](int n) { return isRead && n == number; });
            if (found == row_.numbers.end()) throw refused(text);
            value<int>() = *found;
            break;
        }
        case Kind::word: {
            const auto found =
                std::find_if(row_.words.begin(), row_.words.end(), [&](const Word& w) { return w.word == text; });
            if (found == row_.words.end()) throw refused(text);
            choose(static_cast<int>(found - row_.words.begin()));
            break;
        }
        case Kind::toggle:
            if (text != "on" && text != "off") throw refused(text);
            value<bool>() = text == "on";
            break;
        case Kind::points:
            row_.setPlaces(&value<std::byte>(), pointsIn(text));
            break;
        case Kind::file: {
            const auto isControl = [](char c) { return (static_cast<unsigned char>(c) < 0x20) || c == 0x7F; };
            if (std::any_of(text.begin(), text.end(), isControl))
                throw Error("--" + name(), "must be a file without control characters in its name; rename it");
            if (text.empty()) throw refused(text);
            value<std::string>() = text;
            break;
        }
    }
}

std::string Knob::range() const {
    switch (kind()) {
        case Kind::number:
        case Kind::angle:
            return (row_.range.orZero ? "0 or " : "") + numberText(row_.range.low) + " .. " +
                   numberText(row_.range.high);
        case Kind::whole:
            return std::to_string(row_.wholes.low) + " .. " + std::to_string(row_.wholes.high);
        case Kind::oneOf:
        case Kind::word: {
            std::string words;
            for (const Option& option : options()) words += (words.empty() ? "" : " | ") + option.word;
            return words;
        }
        case Kind::toggle:
            return "on | off";
        case Kind::points: {
            const PointLimits& limits = row_.limits;
            const auto axis = [](const char* name, double low, double high) {
                return std::string(name) + " in " + numberText(low) + " .. " + numberText(high);
            };
            std::string count = std::to_string(limits.least);
            if (!isFixedNumber()) count += " .. " + std::to_string(limits.most);
            return count + (limits.most == 1 ? " point x,y" : " points x,y/x,y") + " with " +
                   axis("x", limits.low.x, limits.high.x) + ", " + axis("y", limits.low.y, limits.high.y) +
                   ", multiples of " + numberText(limits.grid);
        }
        case Kind::file:
            return row_.files->range;
    }
    return {};
}

std::string Knob::rangeInFull() const {
    return range() + (unit().empty() ? "" : " " + unit()) + (scale() == Scale::logarithmic ? ", logarithmic" : "");
}

std::vector<std::string> Knob::sweep() const {
    switch (kind()) {
        case Kind::number: {
            const NumberRange& range = row_.range;
            const std::string low = numberText(range.low), high = numberText(range.high);
            if (range.scale == Scale::linear) return {low, initialText(), high};
            const std::string middle = numberText(withDigits(std::sqrt(range.low) * std::sqrt(range.high), 3));
            if (range.orZero) return {"0", low, middle, initialText(), high};
            return {low, middle, initialText(), high};
        }
        case Kind::angle:
            // Between the ends, which are the same turn as 0, one that is seen
            return {"-360", initialText(), "40", "360"};
        case Kind::whole: {
            const auto [low, high] = row_.wholes;
            if (high - low >= 12) return {std::to_string(low), initialText(), std::to_string(high)};
            std::vector<std::string> each;
            for (int i = low; i <= high; ++i) each.push_back(std::to_string(i));
            return each;
        }
        case Kind::oneOf:
        case Kind::word: {
            std::vector<std::string> each;
            for (const Option& option : options()) each.push_back(option.word);
            return each;
        }
        case Kind::toggle:
            return {"off", "on"};
        case Kind::points: {
            const PointLimits& limits = row_.limits;
            std::vector<vec2> spread;
            for (std::size_t i = 0; i < limits.most; ++i) {
                const double part = double(i) / double(std::max<std::size_t>(limits.most, 2) - 1);
                const vec2 at = limits.low + part * (limits.high - limits.low);
                spread.emplace_back(onGrid(at.x, 0), onGrid(at.y, 1));
            }
            const vec2 corner(onGrid(limits.low.x, 0), onGrid(limits.low.y, 1));
            return {textOf(std::vector<vec2>(limits.least, corner)), initialText(), textOf(spread)};
        }
        case Kind::file:
            return {noFile, row_.sample};
    }
    return {};
}

bool Knob::stepNumber(double amount) {
    const NumberRange& range = row_.range;
    double& now = value<double>();
    if (kind() == Kind::angle) {
        if (amount == 0) return false;
        // A step past either end drops whole turns, with the sign kept, as % does in JavaScript
        now = std::fmod(std::round((now + amount) * 1e9) / 1e9, 360.0) + 0.0;
        return true;
    }
    if (range.scale == Scale::logarithmic) {
        // Below the low end there is 0, where it is allowed; from there the first step leads to the low end again.
        const bool up = amount > 0;
        double moved = now == 0 ? (up ? range.low : 0) : withDigits(now * std::pow(10.0, amount), 4);
        if (now == range.low && range.orZero && amount < 0) moved = 0;
        if (moved != 0) moved = std::clamp(moved, range.low, range.high);
        return std::exchange(now, moved) != moved;
    }
    // Steps of 0.1 or 0.2 are not exact in binary; on a grid of 1e-9 twenty of them lead from -4 to 0 and not to 1e-15.
    const double moved = std::round((now + amount) * 1e9) / 1e9;
    const double stopped = std::clamp(moved, range.low, range.high) + 0.0;  // no -0
    return std::exchange(now, stopped) != stopped;
}

bool Knob::step(double amount) {
    switch (kind()) {
        case Kind::number:
        case Kind::angle:
            return stepNumber(amount);
        case Kind::whole: {
            const int before = value<int>();
            setNumber(number() + std::round(amount));
            return value<int>() != before;
        }
        case Kind::oneOf:
        case Kind::word: {
            if (amount == 0) return false;
            const int count = static_cast<int>(options().size());
            choose((index() + (amount > 0 ? 1 : count - 1)) % count);
            return true;
        }
        case Kind::toggle:
            if (amount == 0) return false;
            value<bool>() = !value<bool>();
            return true;
        case Kind::points: {
            std::vector<vec2> moved(points().begin(), points().end());
            for (vec2& point : moved) point.x = onGrid(point.x + amount, 0);
            if (std::ranges::equal(moved, points())) return false;
            row_.setPlaces(&value<std::byte>(), moved);
            return true;
        }
        case Kind::file:
            return false;  // there is no next file
    }
    return false;
}

std::string Knob::stepText(double amount, const std::string& unit) const {
    if (scale() == Scale::logarithmic) return "\u00D7 " + numberText(withDigits(std::pow(10.0, amount), 3));
    return (amount > 0 ? "+" : "") + numberText(withDigits(amount, 4)) + (unit.empty() ? "" : " " + unit);
}

std::string Knob::idleReason() const {
    for (const AnyRow::Condition& condition : row_.conditions) {
        if (!condition.holds(settings_)) return condition.reason;
    }
    return {};
}

// ---- For widgets

double Knob::number() const {
    return kind() == Kind::whole ? std::min(double(value<int>()), numbers().high) : value<double>();
}

void Knob::setNumber(double number) {
    const NumberRange range = numbers();
    const double stopped = std::clamp(number, range.low, range.high);
    switch (kind()) {
        case Kind::whole:
            value<int>() = stopped == range.high ? row_.wholes.high : static_cast<int>(std::lround(stopped));
            break;
        case Kind::angle:
            // A hand that turns on past an end drops whole turns
            value<double>() = std::fmod(number, 360.0) + 0.0;  // no -0
            break;
        default:
            value<double>() = (allows(number) ? number : stopped) + 0.0;
    }
}

NumberRange Knob::numbers() const {
    if (kind() != Kind::whole) return row_.range;
    const auto [low, high] = row_.wholes;
    return {double(low), double(row_.most ? std::clamp(row_.most(settings_), low, high) : high)};
}

bool Knob::isOn() const { return value<bool>(); }
void Knob::setOn(bool on) { value<bool>() = on; }

std::vector<Option> Knob::options() const {
    std::vector<Option> options;
    if (kind() == Kind::word) {
        for (const auto& [word, meaning] : row_.words) options.push_back({word, meaning});
    }
    if (kind() == Kind::oneOf) {
        for (const int number : row_.numbers) options.push_back({wordOf(number)});
    }
    return options;
}

int Knob::index() const {
    if (kind() == Kind::word) return row_.index(&value<std::byte>());
    const auto found = std::find(row_.numbers.begin(), row_.numbers.end(), value<int>());
    return static_cast<int>(found - row_.numbers.begin());
}

void Knob::choose(int index) {
    if (kind() == Kind::word)
        row_.setIndex(&value<std::byte>(), index);
    else
        value<int>() = row_.numbers[static_cast<std::size_t>(index)];
}

void Knob::checkFile() const {
    if (text() == noFile) return;
    try {
        row_.files->check(text());
    } catch (const Error& error) {
        throw Error("--" + name(), error.what());
    }
}

bool Knob::takes(std::string_view file) const {
    std::string small(file);
    for (char& c : small) c = c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    return std::any_of(row_.files->endings.begin(), row_.files->endings.end(),
                       [&](std::string_view ending) { return small.ends_with(ending); });
}

std::string Knob::endings() const {
    std::string list;
    for (const Literal ending : row_.files->endings) list += (list.empty() ? "" : ",") + std::string(ending);
    return list;
}

// ---- Points

std::span<const vec2> Knob::points() const { return row_.places(&value<std::byte>()); }

// The nearest that is allowed.
double Knob::onGrid(double coordinate, int axis) const {
    const PointLimits& limits = row_.limits;
    // Whole steps of the grid that lie within the limits, as divided once
    const double parts = 1 / limits.grid, low = std::ceil(limits.low[axis] * parts - 1e-9),
                 high = std::floor(limits.high[axis] * parts + 1e-9);
    return std::clamp(std::round(coordinate * parts), low, high) / parts + 0.0;
}

std::vector<vec2> Knob::pointsIn(std::string_view text) const {
    std::vector<vec2> points;
    for (std::string_view rest = text; !rest.empty();) {
        const std::size_t slash = std::min(rest.find('/'), rest.size());
        const std::string_view pair = rest.substr(0, slash);
        rest.remove_prefix(slash);
        const std::size_t comma = pair.find(',');
        vec2 point;
        if (comma == pair.npos || !readNumber(pair.substr(0, comma), point.x) ||
            !readNumber(pair.substr(comma + 1), point.y))
            throw refused(text);
        for (int axis = 0; axis < 2; ++axis) {
            // Equal up to a rounding of the text: 0.3 is no exact multiple of 0.1
            const double allowed = onGrid(point[axis], axis);
            if (std::abs(allowed - point[axis]) > 1e-6 * row_.limits.grid) throw refused(text);
            point[axis] = allowed;
        }
        points.push_back(point);
        if (rest.size() == 1) throw refused(text);  // a slash, and nothing behind it
        if (!rest.empty()) rest.remove_prefix(1);
    }
    if (points.size() < row_.limits.least || points.size() > row_.limits.most) throw refused(text);
    return points;
}

bool Knob::addPoint(std::size_t after) {
    if (!canAddPoint()) return false;
    std::vector<vec2> more(points().begin(), points().end());
    const vec2 point = more[after];
    more.insert(more.begin() + std::ptrdiff_t(after) + 1, point);
    row_.setPlaces(&value<std::byte>(), more);
    return true;
}

bool Knob::removePoint(std::size_t point) {
    if (!canRemovePoint()) return false;
    std::vector<vec2> fewer(points().begin(), points().end());
    fewer.erase(fewer.begin() + std::ptrdiff_t(point));
    row_.setPlaces(&value<std::byte>(), fewer);
    return true;
}

Coordinate Knob::coordinate() {
    const NumberRange range = numbers();
    return {[this] { return number(); }, [this](double value) { setNumber(value); }, range.low, range.high};
}

Coordinate Knob::coordinate(std::size_t point, int axis) {
    const PointLimits& limits = row_.limits;
    const auto set = [this, point, axis, &limits](double value) {
        std::vector<vec2> moved(points().begin(), points().end());
        moved[point][axis] = std::clamp(value, limits.low[axis], limits.high[axis]) + 0.0;
        row_.setPlaces(&this->value<std::byte>(), moved);
    };
    return {[this, point, axis] { return points()[point][axis]; }, set, limits.low[axis], limits.high[axis],
            limits.grid};
}

}  // namespace mv

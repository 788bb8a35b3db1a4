// Rows: how the settings of a lesson, a plain struct, come to be flags, widgets, rows of a page and states of the visits (tests/visits).
//
//     struct Settings { double bias = 0.006; Faces faces = Faces::front; vec3 light{2, 5, 4}; };
//
//     number("bias", &Settings::bias, {1e-4, 0.2, Scale::logarithmic, true}, "how much deeper is not yet shadow"),
//     word("map-faces", &Settings::faces, {{"front"}, {"back"}, {"both"}}, "faces in the map"),
//     number("light-x", x(&Settings::light), {-10, 10}, "x of the light"),
//
// A row names its member once. The value that the member has in a Settings{} is the initial one.
#pragma once
#include <algorithm>
#include <concepts>
#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "mv/demo/knob.h"
#include "mv/demo/own_file.h"
#include "mv/demo/word_list.h"
#include "mv/math/types.h"

namespace mv {

// The place of a row's value in its settings: a member, a coordinate of one, or a member of a part.
template <class Settings, class Value>
struct Place {
    using Owner = Settings;
    using Type = Value;
    std::size_t offset;  // bytes
};

namespace row_detail {

template <class Settings>
const Settings& example() {
    static const Settings settings{};
    return settings;
}
template <class Settings, class Value>
Place<Settings, Value> placeAt(const Value& value) {
    return {static_cast<std::size_t>(reinterpret_cast<const std::byte*>(&value) -
                                     reinterpret_cast<const std::byte*>(&example<Settings>()))};
}
template <class Settings, class Value>
Place<Settings, Value> placeOf(Value Settings::*member) {
    return placeAt<Settings>(example<Settings>().*member);
}
template <class Settings, class Value>
Place<Settings, Value> placeOf(Place<Settings, Value> place) {
    return place;
}

}  // namespace row_detail

// A coordinate of a member.
template <class Settings, class Vector>
Place<Settings, double> x(Vector Settings::*member) {
    return row_detail::placeAt<Settings>((row_detail::example<Settings>().*member).x);
}
template <class Settings, class Vector>
Place<Settings, double> y(Vector Settings::*member) {
    return row_detail::placeAt<Settings>((row_detail::example<Settings>().*member).y);
}
template <class Settings, class Vector>
Place<Settings, double> z(Vector Settings::*member) {
    return row_detail::placeAt<Settings>((row_detail::example<Settings>().*member).z);
}

// An element of a member that is an array.
template <class Settings, class Array>
auto element(Array Settings::*member, std::size_t index) {
    return row_detail::placeAt<Settings>((row_detail::example<Settings>().*member).at(index));
}

// A member of a part, which is a member.
template <class Settings, class Part, class Value>
Place<Settings, Value> within(Part Settings::*part, Value Part::*member) {
    return row_detail::placeAt<Settings>((row_detail::example<Settings>().*part).*member);
}

template <class Settings>
struct Row : AnyRow {
    // The setting changes nothing in the picture where `holds` is false, because of `reason`, a clause.
    Row when(bool (*holds)(const Settings&), Literal reason) && {
        conditions.push_back(
            {[holds](const void* settings) { return holds(*static_cast<const Settings*>(settings)); }, reason});
        return std::move(*this);
    }
    // A whole number that does nothing beyond `count`, and whose highest value stands for it however far that is: keys and
    // sliders go from the low end to there.
    Row upTo(int (*count)(const Settings&)) && {
        most = [count](const void* settings) { return count(*static_cast<const Settings*>(settings)); };
        return std::move(*this);
    }
    // For a lesson with a memory: a change of this setting begins anew, at frame 0.
    Row beginsAnew() && {
        startsOver = true;
        return std::move(*this);
    }
};

// A number in that range. Outside it is refused, never clamped.
template <class Member>
auto number(Literal name, Member member, NumberRange range, Literal help, Literal unit = {}) {
    const Place place = row_detail::placeOf(member);
    using In = decltype(place);
    static_assert(std::same_as<typename In::Type, double>);
    return Row<typename In::Owner>{{.kind = AnyRow::Kind::number,
                                    .name = name,
                                    .help = help,
                                    .unit = unit,
                                    .offset = place.offset,
                                    .range = range}};
}

// An angle in degrees that goes on turning.
template <class Member>
auto angle(Literal name, Member member, Literal help) {
    auto row = number(name, member, {-360, 360}, help, "deg");
    row.kind = AnyRow::Kind::angle;
    return row;
}

template <class Member>
auto whole(Literal name, Member member, WholeRange range, Literal help, Literal unit = {}) {
    const Place place = row_detail::placeOf(member);
    using In = decltype(place);
    static_assert(std::same_as<typename In::Type, int>);
    return Row<typename In::Owner>{{.kind = AnyRow::Kind::whole,
                                    .name = name,
                                    .help = help,
                                    .unit = unit,
                                    .offset = place.offset,
                                    .wholes = range}};
}

// One of these numbers.
template <class Member>
auto oneOf(Literal name, Member member, const std::vector<int>& numbers, Literal help) {
    const Place place = row_detail::placeOf(member);
    using In = decltype(place);
    static_assert(std::same_as<typename In::Type, int>);
    return Row<typename In::Owner>{
        {.kind = AnyRow::Kind::oneOf, .name = name, .help = help, .offset = place.offset, .numbers = numbers}};
}

// On or off.
template <class Member>
auto toggle(Literal name, Member member, Literal help) {
    const Place place = row_detail::placeOf(member);
    using In = decltype(place);
    static_assert(std::same_as<typename In::Type, bool>);
    return Row<typename In::Owner>{{.kind = AnyRow::Kind::toggle, .name = name, .help = help, .offset = place.offset}};
}

// A value of an enumeration, which counts from 0 in the order of the words.
template <class Member>
auto word(Literal name, Member member, WordList words, Literal help) {
    const Place place = row_detail::placeOf(member);
    using In = decltype(place);
    using Value = typename In::Type;
    static_assert(std::is_enum_v<Value>);
    return Row<typename In::Owner>{
        {.kind = AnyRow::Kind::word,
         .name = name,
         .help = help,
         .offset = place.offset,
         .words = {words.begin(), words.end()},
         .index = [](const void* value) { return static_cast<int>(*static_cast<const Value*>(value)); },
         .setIndex = [](void* value, int index) { *static_cast<Value*>(value) = static_cast<Value>(index); }}};
}

// Points of a plane: a std::vector<vec2>, or a std::array<vec2, N> or a vec2 for always as many.
template <class Member>
auto points(Literal name, Member member, PointLimits limits, Literal help, Literal unit = {}) {
    const Place place = row_detail::placeOf(member);
    using In = decltype(place);
    using Value = typename In::Type;
    return Row<typename In::Owner>{{.kind = AnyRow::Kind::points,
                                    .name = name,
                                    .help = help,
                                    .unit = unit,
                                    .offset = place.offset,
                                    .limits = limits,
                                    .places = [](const void* value) -> std::span<const vec2> {
                                        if constexpr (std::same_as<Value, vec2>)
                                            return {static_cast<const vec2*>(value), 1};
                                        else
                                            return *static_cast<const Value*>(value);
                                    },
                                    .setPlaces =
                                        [](void* value, const std::vector<vec2>& places) {
                                            if constexpr (std::same_as<Value, vec2>)
                                                *static_cast<vec2*>(value) = places.front();
                                            else if constexpr (std::same_as<Value, std::vector<vec2>>)
                                                *static_cast<Value*>(value) = places;
                                            else
                                                std::copy(places.begin(), places.end(),
                                                          static_cast<Value*>(value)->begin());
                                        }}};
}

// A file of the user's own: an OwnFile<Content>, whose content says of which kind. `sample` is a file of the tree, which the
// tests set it to. A file that is missing or of another kind is told before check() of the lesson.
template <class Member>
auto file(Literal name, Member member, Literal sample, Literal help) {
    const Place place = row_detail::placeOf(member);
    using In = decltype(place);
    using Value = typename In::Type;
    static_assert(std::is_standard_layout_v<Value> && offsetof(Value, name) == 0);
    return Row<typename In::Owner>{{.kind = AnyRow::Kind::file,
                                    .name = name,
                                    .help = help,
                                    .offset = place.offset,
                                    .files = &fileKind<typename Value::Content>(),
                                    .sample = sample}};
}

namespace row_detail {

template <class Settings>
void append(std::vector<Row<Settings>>& all, Row<Settings>&& row) {
    all.push_back(std::move(row));
}
template <class Settings>
void append(std::vector<Row<Settings>>& all, std::vector<Row<Settings>>&& rows) {
    for (Row<Settings>& row : rows) all.push_back(std::move(row));
}
template <class Settings, class... Rows>
std::vector<Row<Settings>> joined(Rows&&... rows) {
    std::vector<Row<Settings>> all;
    (append(all, std::move(rows)), ...);
    return all;
}

}  // namespace row_detail

// Rows, and lists of rows, one after the other.
template <class Settings, class... Rows>
std::vector<Row<Settings>> together(Row<Settings> first, Rows... rest) {
    return row_detail::joined<Settings>(std::move(first), std::move(rest)...);
}
template <class Settings, class... Rows>
std::vector<Row<Settings>> together(std::vector<Row<Settings>> first, Rows... rest) {
    return row_detail::joined<Settings>(std::move(first), std::move(rest)...);
}

// The rows of a part of a lesson, whose settings are a member of the whole's. Each changes nothing where `holds` is false.
template <class Settings, class Part>
std::vector<Row<Settings>> part(Part Settings::*member, std::vector<Row<Part>> rows,
                                bool (*holds)(const Settings&) = {}, Literal reason = {}) {
    const std::size_t offset = row_detail::placeOf(member).offset;
    std::vector<Row<Settings>> all;
    for (Row<Part>& each : rows) {
        Row<Settings> row{std::move(each)};
        row.offset += offset;
        for (AnyRow::Condition& condition : row.conditions) {
            condition.holds = [offset, ofPart = std::move(condition.holds)](const void* settings) {
                return ofPart(static_cast<const std::byte*>(settings) + offset);
            };
        }
        if (row.most) {
            row.most = [offset, ofPart = std::move(row.most)](const void* settings) {
                return ofPart(static_cast<const std::byte*>(settings) + offset);
            };
        }
        // Ask for the part first: without it, nothing else is the reason
        if (holds) {
            row = std::move(row).when(holds, reason);
            std::rotate(row.conditions.begin(), row.conditions.end() - 1, row.conditions.end());
        }
        all.push_back(std::move(row));
    }
    return all;
}

}  // namespace mv

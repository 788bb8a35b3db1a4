// Text that is written as JSON reads back as the same, by a library's reader.
#include "mv/paper/json_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

using namespace mv;
using Json = nlohmann::ordered_json;

namespace {

TEST(JsonText, EachCharacterReadsBack) {
    std::string all;
    for (int code = 0; code < 128; ++code) all += static_cast<char>(code);
    all += "\u00e9\u2192\U0001f600";
    EXPECT_EQ(Json::parse(jsonQuoted(all)), all);
    JsonText json;
    EXPECT_EQ(Json::parse(json.object().add(all, all).end().text()), (Json{{all, all}}));
}

TEST(JsonText, EachNumberReadsBack) {
    using Limits = std::numeric_limits<double>;
    const std::vector<double> numbers{0.0,   -0.0,          1,      -1.5,          0.1, 1e21, 1e-7, 1.0 / 3,
                                      1e300, Limits::max(), 5e-324, Limits::min(), 123, 1e15, 1e16};
    JsonText json;
    const Json read = Json::parse(json.addAll({}, numbers).text());
    ASSERT_EQ(read.size(), numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i) EXPECT_EQ(read[i].get<double>(), numbers[i]);
    JsonText whole;
    whole.array().add({}, std::numeric_limits<long long>::min()).add({}, std::size_t(-1)).add({}, 7).end();
    EXPECT_EQ(Json::parse(whole.text()), (Json{std::numeric_limits<long long>::min(), std::size_t(-1), 7}));
    for (const double none : {Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()}) {
        JsonText null;
        EXPECT_TRUE(Json::parse(null.array().add({}, none).end().text())[0].is_null());
    }
}

// Lines and spaces are those of the library's writer, so that a report's lines can be compared whoever wrote them.
TEST(JsonText, NestsAsTheLibraryDoes) {
    const Json expected{{"empty", Json::object()},
                        {"none", Json::array()},
                        {"is", true},
                        {"null", nullptr},
                        {"list", {"a", "b"}},
                        {"", {{"in", {{"deeper", {1, Json::array({2, Json::object()})}}}}}}};
    JsonText json;
    json.object().object("empty").end().array("none").end().add("is", true).addNull("null");
    json.addAll("list", std::vector<std::string>{"a", "b"});
    json.object("").object("in").array("deeper").add({}, 1).array().add({}, 2).object().end().end().end();
    json.end().end().end();
    EXPECT_EQ(json.text(), expected.dump(2));
}

}  // namespace

#include "mv/portable_number.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

#include "mv/demo/read_number.h"

namespace {

std::string byTheStandard(double number) {
    char text[64];
    return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

void expectSameText(double number) {
    EXPECT_EQ(mv::portable::shortestText(number), byTheStandard(number));
    EXPECT_EQ(mv::portable::shortestText(-number), byTheStandard(-number));
}

TEST(PortableNumber, WritesWhatTheStandardWrites) {
    for (const double number : {0.0,
                                1.0,
                                10.0,
                                1e4,
                                1e5,
                                123456.0,
                                1e15,
                                1e20,
                                1e22,
                                1e23,
                                123e20,
                                0.1,
                                0.01,
                                1e-3,
                                1e-4,
                                1e-5,
                                1.25e-5,
                                0.3,
                                2.0 / 3,
                                1e300,
                                5e-324,
                                2.2250738585072014e-308,
                                9007199254740993.0})
        expectSameText(number);
    expectSameText(std::numeric_limits<double>::max());
    expectSameText(std::numeric_limits<double>::infinity());
    expectSameText(std::numeric_limits<double>::quiet_NaN());
    std::mt19937_64 random(17);
    for (int i = 0; i < 5'000; ++i) {
        expectSameText(std::bit_cast<double>(static_cast<std::uint64_t>(random())));               // any
        expectSameText(std::round(std::ldexp(double(random() >> 11), -43)) / 1000);                // a few digits
        expectSameText(std::ldexp(double(random() >> 11), static_cast<int>(random() % 64) - 53));  // about 1
    }
}

TEST(PortableNumber, ReadsWhatTheStandardReads) {
    const auto expectSame = [](const std::string& text) {
        double ours = 7, theirs = 7;
        const auto result = std::from_chars(text.data(), text.data() + text.size(), theirs);
        const bool read = result.ec == std::errc() && result.ptr == text.data() + text.size() && std::isfinite(theirs);
        EXPECT_EQ(mv::portable::readFinite(text, ours), read) << "'" << text << "'";
        EXPECT_EQ(std::bit_cast<std::uint64_t>(ours), std::bit_cast<std::uint64_t>(read ? theirs : 7)) << text;
    };
    for (const char* text : {"0",      "-0",
                             "1",      "+1",
                             "-1",     "--1",
                             "-+1",    " 1",
                             "1 ",     "",
                             ".",      ".5",
                             "5.",     "-.5",
                             "1e5",    "1E+5",
                             "1e-5",   "1e",
                             "1e+",    "e5",
                             "1e400",  "-1e400",
                             "1e-400", "0e-400",
                             "5e-324", "0x10",
                             "0x1p3",  "inf",
                             "nan",    "infinity",
                             "1,5",    "1.5.5",
                             "1-1",    "1_000",
                             "1e5.5",  "00012",
                             "1e0005", "123456789012345678901234567890"})
        expectSame(text);
    std::mt19937_64 random(18);
    const std::string letters = "0123456789.eE+- x";
    for (int i = 0; i < 5'000; ++i) {
        std::string text(random() % 7, ' ');
        for (char& letter : text) letter = letters[random() % letters.size()];
        expectSame(text);
        expectSame(byTheStandard(std::bit_cast<double>(static_cast<std::uint64_t>(random()))));
    }
}

}  // namespace

#include <doctest/doctest.h>

#include <cmath>
#include <cstdint>
#include <cstring>
#include <sstream>
#include <string>

#include "LogFiles.h"
#include "NumberFormat.h"

namespace {

double FromBits(uint64_t bits) {
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

std::string FiveDigits(double value) {
    char text[badlog::MAX_NUMBER_LENGTH];
    return {text, badlog::WriteFiveDigits(value, text)};
}

std::string Microseconds(double value) {
    char text[badlog::MAX_NUMBER_LENGTH];
    return {text, badlog::WriteMicroseconds(value, text)};
}

std::string Integer(int64_t value) {
    char text[badlog::MAX_NUMBER_LENGTH];
    return {text, badlog::WriteInteger(value, text)};
}

/** Returns the next bits of the corpus's generator, splitmix64. */
uint64_t NextBits(uint64_t& state) {
    state += 0x9E3779B97F4A7C15u;
    uint64_t bits = state;
    bits = (bits ^ (bits >> 30)) * 0xBF58476D1CE4E5B9u;
    bits = (bits ^ (bits >> 27)) * 0x94D049BB133111EBu;
    return bits ^ (bits >> 31);
}

/** The doubles of a digest of the corpus; the corpus's README describes them. */
double NextValue(const std::string& kind, uint64_t& state) {
    const uint64_t bits = NextBits(state);
    if (kind == "bits") return FromBits(bits);
    if (kind == "subnormals") return FromBits((bits & 0x000F'FFFF'FFFF'FFFF) >> (bits >> 58) % 52);
    double power = 1;
    for (uint64_t i = 0; i < bits >> 60; i++) power *= 10;
    const double tie = (static_cast<double>(bits % 90'000) * 10 + 100'005) / power;
    if (kind == "ties") return tie;
    uint64_t near = 0;
    std::memcpy(&near, &tie, sizeof near);
    return FromBits(near + (bits >> 40) % 5 - 2);
}

uint64_t Digest(const std::string& kind, uint64_t state, int count) {
    uint64_t hash = 0xCBF29CE484222325u;
    for (int i = 0; i < count; i++) {
        for (const char byte : FiveDigits(NextValue(kind, state)) + "\n") {
            hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001B3u;
        }
    }
    return hash;
}

}  // namespace

TEST_CASE("numbers have the corpus's texts, which are Java's") {
    std::istringstream corpus{Read(BADLOG_ROOT "/core/conformance/numbers/five-digits.txt")};
    int cases = 0;
    for (std::string line; std::getline(corpus, line); cases++) {
        std::istringstream words{line};
        std::string kind;
        words >> kind;
        if (kind == "digest") {
            std::string values;
            uint64_t seed = 0;
            int count = 0;
            std::string expected;
            words >> values >> seed >> count >> expected;
            INFO(line);
            CHECK(Digest(values, seed, count) == std::stoull(expected, nullptr, 16));
        } else {
            std::string expected;
            words >> expected;
            INFO(line);
            CHECK(FiveDigits(FromBits(std::stoull(kind, nullptr, 16))) == expected);
        }
    }
    CHECK(cases > 1000);
}

TEST_CASE("a row's numbers equal the table in bag-format.md") {
    CHECK(FiveDigits(12.3456) == "12.346");
    CHECK(FiveDigits(-100) == "-100.00");
    CHECK(FiveDigits(1e-4) == "0.00010000");
    CHECK(FiveDigits(123456) == "1.2346e+05");
    CHECK(FiveDigits(-0.0) == "-0.0000");
    CHECK(FiveDigits(2.00005) == "2.0001");
    CHECK(FiveDigits(std::nan("")) == "NaN");
    CHECK(FiveDigits(-HUGE_VAL) == "-Infinity");
    CHECK(FiveDigits(4.9e-324) == "4.9000e-324");
}

TEST_CASE("times keep their microseconds") {
    CHECK(Microseconds(100.02) == "100.020000");
    CHECK(Microseconds(0.1 + 0.2) == "0.300000");
    CHECK(Microseconds(-0.0000001) == "0.000000");
    CHECK(Microseconds(-2.5) == "-2.500000");
    CHECK(Microseconds(0.9999999) == "1.000000");
    CHECK(Microseconds(-0.0) == "0.000000");
    CHECK(Microseconds(1.7720000001235e9) == "1772000000.123500");
    CHECK(Microseconds(1.772e15) == "1772000000000000.000000");
    CHECK(Microseconds(-1.0e19) == "-1.0000e+19");
}

TEST_CASE("whole numbers keep all their digits") {
    CHECK(Integer(0) == "0");
    CHECK(Integer(-7) == "-7");
    CHECK(Integer(INT64_MAX) == "9223372036854775807");
    CHECK(Integer(INT64_MIN) == "-9223372036854775808");
}

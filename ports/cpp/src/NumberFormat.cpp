#include "NumberFormat.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "ExactDigits.h"

namespace badlog {
namespace {

constexpr double TIE_DISTANCE = 1.0e-9;

char Digit(int value) {
    return static_cast<char>('0' + value);
}

char* WriteWord(const char* word, char* into) {
    const auto length = std::strlen(word);
    std::memcpy(into, word, length);
    return into + length;
}

/** Writes five digits with a point after the first `whole` of them, or without any if all are whole. */
char* WritePointed(int digits, int whole, char* into) {
    int divisor = 10'000;
    for (int i = 0; i < 5; i++) {
        if (i == whole) *into++ = '.';
        *into++ = Digit(digits / divisor % 10);
        divisor /= 10;
    }
    return into;
}

char* WriteExponent(int exponent, char* into) {
    const int size = exponent < 0 ? -exponent : exponent;
    *into++ = 'e';
    *into++ = exponent < 0 ? '-' : '+';
    if (size >= 100) *into++ = Digit(size / 100);
    *into++ = Digit(size / 10 % 10);
    *into++ = Digit(size % 10);
    return into;
}

char* WriteDigits(bool isNegative, RoundedDigits rounded, char* into) {
    if (isNegative) *into++ = '-';
    if (rounded.exponent < -4 || rounded.exponent > 4) {
        return WriteExponent(rounded.exponent, WritePointed(rounded.digits, 1, into));
    }
    if (rounded.exponent >= 0) return WritePointed(rounded.digits, rounded.exponent + 1, into);
    into = WriteWord("0.", into);
    for (int i = rounded.exponent; i < -1; i++) *into++ = '0';
    return WritePointed(rounded.digits, 5, into);
}

/** Floating point is enough here unless the magnitude is next to a decimal tie. */
char* WriteCommon(bool isNegative, double magnitude, char* into) {
    static constexpr double LIMITS[] = {0.001, 0.01, 0.1, 1.0, 10.0, 100.0, 1000.0, 10000.0};
    static constexpr double FACTORS[] = {1.0e8, 1.0e7, 1.0e6, 1.0e5, 1.0e4, 1.0e3, 1.0e2, 1.0e1, 1.0};
    int place = 0;
    while (place < 8 && magnitude >= LIMITS[place]) place++;
    const double scaled = magnitude * FACTORS[place];
    const int exponent = place - 4;
    const int digits = static_cast<int>(scaled + 0.5);
    const double rest = scaled - digits;
    if (rest > 0.5 - TIE_DISTANCE || rest < TIE_DISTANCE - 0.5) {
        return WriteDigits(isNegative, RoundToFiveDigits(magnitude), into);
    }
    if (digits == 100'000) return WriteDigits(isNegative, {10'000, exponent + 1}, into);
    return WriteDigits(isNegative, {digits, exponent}, into);
}

}  // namespace

char* WriteFiveDigits(double value, char* into) {
    const double magnitude = value < 0.0 ? -value : value;
    if (magnitude >= 1.0e-4 && magnitude < 1.0e5) return WriteCommon(value < 0.0, magnitude, into);
    if (value == 0.0) return WriteWord(std::signbit(value) ? "-0.0000" : "0.0000", into);
    if (magnitude <= std::numeric_limits<double>::max()) return WriteDigits(value < 0.0, RoundToFiveDigits(magnitude), into);
    return WriteWord(value > 0.0 ? "Infinity" : value < 0.0 ? "-Infinity" : "NaN", into);
}

char* WriteMicroseconds(double value, char* into) {
    const double magnitude = value < 0.0 ? -value : value;
    if (!(magnitude < 9.0e18)) return WriteFiveDigits(value, into);
    auto whole = static_cast<int64_t>(magnitude);
    // Through memory: a compiler that fuses multiplication and addition would round differently from Java.
    volatile double scaled = (magnitude - static_cast<double>(whole)) * 1'000'000;
    int millionths = static_cast<int>(scaled + 0.5);
    if (millionths == 1'000'000) {
        whole++;
        millionths = 0;
    }
    if (value < 0.0 && (whole > 0 || millionths > 0)) *into++ = '-';
    into = WriteInteger(whole, into);
    *into++ = '.';
    for (int divisor = 100'000; divisor > 0; divisor /= 10) *into++ = Digit(millionths / divisor % 10);
    return into;
}

char* WriteInteger(int64_t value, char* into) {
    // There is one more negative number than positive ones, so the digits are taken from the negative value.
    int64_t rest = value > 0 ? -value : value;
    if (value < 0) *into++ = '-';
    char* const start = into;
    do {
        *into++ = Digit(static_cast<int>(-(rest % 10)));
        rest /= 10;
    } while (rest != 0);
    std::reverse(start, into);
    return into;
}

}  // namespace badlog

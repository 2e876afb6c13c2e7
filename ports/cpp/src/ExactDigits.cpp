#include "ExactDigits.h"

#include <cstdint>
#include <cstring>

#include "PowersOfTen.h"

namespace badlog {
namespace {

constexpr int FRACTION_BITS = 52;
constexpr uint64_t FRACTION_MASK = (uint64_t{1} << FRACTION_BITS) - 1;
constexpr int MIN_UNIT_EXPONENT = -1074;
constexpr uint64_t LOW_HALF = 0xFFFF'FFFFu;
constexpr uint64_t FEW_BITS_LIMIT = uint64_t{1} << 20;
constexpr int FEW_BITS_SCALE = 336;

/** 2^-1074 is 4940656458412.4654417657 times 10^-336. */
constexpr int64_t UNIT = 4'940'656'458'412;
constexpr int64_t UNIT_REST = 4'654'417'657;
constexpr int64_t UNIT_REST_SCALE = 10'000'000'000;

const PowersOfTen96& Powers() {
    static const PowersOfTen96 powers;
    return powers;
}

/** factor * 2^(top - 63) * 10^power rounded; the top bit of factor is set. */
int Scale(uint64_t factor, int top, int power) {
    const auto& powers = Powers();
    const uint64_t high = factor >> 32;
    const uint64_t low = factor & LOW_HALF;
    const uint64_t power0 = powers.Low(power);
    const uint64_t power1 = powers.Middle(power);
    const uint64_t power2 = powers.High(power);
    // Multiplies two by three 32-bit words, and keeps only the top 64 bits. No sum exceeds 64 bits.
    const uint64_t a = high * power0 + ((low * power0) >> 32);
    const uint64_t b = low * power1 + (a & LOW_HALF);
    const uint64_t c = high * power1 + (a >> 32) + (b >> 32);
    const uint64_t d = low * power2 + (c & LOW_HALF);
    const uint64_t product = high * power2 + (c >> 32) + (d >> 32);
    const int integerBits = top + PowersOfTen96::Log2Floor(power) + 2;
    return static_cast<int>(((product >> (63 - integerBits)) + 1) >> 1);
}

/** Rounds reach times 2^exponent, which is value plus margin, to the nearest; a tie rounds down. */
RoundedDigits RoundReach(uint64_t reach, int exponent) {
    int shift = 0;
    while ((reach << shift >> 63) == 0) shift++;
    const uint64_t factor = reach << shift;
    const int top = exponent + 63 - shift;
    // log10(2); 10^(decimal + 1) may still be within the binade.
    int decimal = (top * 315'653) >> 20;
    int digits = Scale(factor, top, 4 - decimal);
    if (digits >= 100'000) {
        decimal++;
        digits = Scale(factor, top, 4 - decimal);
    }
    return {digits, decimal};
}

RoundedDigits RoundGenerated(int64_t generated) {
    int64_t unit = 100'000'000'000'000;
    int decimal = 18 - FEW_BITS_SCALE;
    while (unit * 10'000 > generated) {
        unit /= 10;
        decimal--;
    }
    const int digits = static_cast<int>((generated + unit / 2) / unit);
    return digits == 100'000 ? RoundedDigits{10'000, decimal + 1} : RoundedDigits{digits, decimal};
}

/**
 * Rounds units times 2^-1074, less than 2^20 units. Java's margin is so wide there that its digits have to be generated one
 * by one.
 */
RoundedDigits RoundFewBits(int64_t units) {
    const int64_t scaled = units * UNIT + units * UNIT_REST / UNIT_REST_SCALE;
    const int64_t margin = (units & (units - 1)) == 0 ? UNIT / 4 : UNIT / 2;
    int64_t place = 1'000'000'000'000'000'000;
    while (place > scaled + margin) place /= 10;
    int64_t rest = 0;
    do {
        place /= 10;
        rest = scaled % place;
    } while (rest > margin && place - rest > margin);
    const bool up = place - rest <= margin && (rest > margin || rest > place - rest);
    return RoundGenerated(up ? scaled - rest + place : scaled - rest);
}

}  // namespace

RoundedDigits RoundToFiveDigits(double magnitude) {
    uint64_t bits = 0;
    std::memcpy(&bits, &magnitude, sizeof bits);
    const int biased = static_cast<int>(bits >> FRACTION_BITS);
    const uint64_t fraction = bits & FRACTION_MASK;
    if (biased == 0 && fraction < FEW_BITS_LIMIT) return RoundFewBits(static_cast<int64_t>(fraction));
    const uint64_t significand = biased == 0 ? fraction : fraction | (FRACTION_MASK + 1);
    const int unitExponent = biased == 0 ? MIN_UNIT_EXPONENT : biased - 1 + MIN_UNIT_EXPONENT;
    return (significand & (significand - 1)) == 0 ? RoundReach(4 * significand + 1, unitExponent - 2)
                                                  : RoundReach(2 * significand + 1, unitExponent - 1);
}

}  // namespace badlog

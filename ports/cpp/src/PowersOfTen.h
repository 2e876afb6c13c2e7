#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace badlog {

/**
 * The top 96 bits of the powers of ten from 10^MIN to 10^MAX, cut off, each as three words. `10^power` is their number
 * times 2^(Log2Floor(power) - 95), or more than that by less than one unit.
 */
class PowersOfTen96 {
public:
    /** The largest double has a decimal exponent of 308. */
    static constexpr int MIN = 4 - 308;
    /** 2^20 units of 2^-1074 have a decimal exponent of -318. */
    static constexpr int MAX = 4 + 318;

    PowersOfTen96();

    uint64_t Low(int power) const { return m_words[At(power)]; }
    uint64_t Middle(int power) const { return m_words[At(power) + 1]; }
    /** Its first bit is set. */
    uint64_t High(int power) const { return m_words[At(power) + 2]; }

    /** Largest n with 2^n not above 10^power. */
    static int Log2Floor(int power) { return (power * 1'741'647) >> 19; }

private:
    static constexpr int WORDS = 3;
    /** Five has 2.33 bits; room for the longest power of five and three words more. */
    static constexpr int NUMBER_WORDS = WORDS + 1 + MAX * 233 / 100 / 32 + 1;
    using Number = std::array<uint32_t, NUMBER_WORDS>;

    static constexpr size_t At(int power) { return static_cast<size_t>((power - MIN) * WORDS); }
    void Keep(const Number& number, int power);

    std::array<uint32_t, (MAX - MIN + 1) * WORDS> m_words{};
};

}  // namespace badlog

#include "PowersOfTen.h"

namespace badlog {

PowersOfTen96::PowersOfTen96() {
    // Powers of five times 2^96, which leaves room for three words below the shortest of them.
    Number number{};
    number[WORDS] = 1;
    Keep(number, 0);
    for (int power = 1; power <= MAX; power++) {
        uint64_t carry = 0;
        for (auto& word : number) {
            carry += uint64_t{word} * 5;
            word = static_cast<uint32_t>(carry);
            carry >>= 32;
        }
        Keep(number, power);
    }
    // A large power of two, divided by five repeatedly. Cutting off after each division gives the same result as once at
    // the end.
    number.fill(0);
    number.back() = 1;
    for (int power = -1; power >= MIN; power--) {
        uint64_t rest = 0;
        for (auto i = number.size(); i-- > 0;) {
            const uint64_t part = (rest << 32) | number[i];
            number[i] = static_cast<uint32_t>(part / 5);
            rest = part % 5;
        }
        Keep(number, power);
    }
}

void PowersOfTen96::Keep(const Number& number, int power) {
    auto top = number.size() - 1;
    while (number[top] == 0) top--;
    int shift = 0;
    while ((number[top] << shift & 0x8000'0000u) == 0) shift++;
    for (size_t i = 0; i < WORDS; i++) {
        const auto index = top - WORDS + 1 + i;
        const uint32_t lower = shift == 0 ? 0 : number[index - 1] >> (32 - shift);
        m_words[At(power) + i] = number[index] << shift | lower;
    }
}

}  // namespace badlog

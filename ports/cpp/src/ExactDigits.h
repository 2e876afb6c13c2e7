#pragma once

namespace badlog {

/** Five significant digits, 10000 to 99999, and the decimal exponent of the first of them. */
struct RoundedDigits {
    int digits;
    int exponent;
};

/**
 * The five significant digits of Java 17's `String.format("%.5g")` for any finite double above zero, by integer arithmetic
 * alone. `ExactDigits` in badlog's core explains why this is correct.
 */
RoundedDigits RoundToFiveDigits(double magnitude);

}  // namespace badlog

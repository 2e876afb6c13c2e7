#pragma once

#include <cstdint>

namespace badlog {

/** Length of the longest text that the functions here write. */
constexpr int MAX_NUMBER_LENGTH = 27;

/** Writes the text of Java 17's `String.format(Locale.ROOT, "%.5g", value)`, byte for byte; returns its end. */
char* WriteFiveDigits(double value, char* into);

/**
 * Writes a number with six decimals. A magnitude of 9e18 or more, or a number that is not finite, is written by
 * WriteFiveDigits.
 */
char* WriteMicroseconds(double value, char* into);

/** Writes all digits of a whole number; returns their end. */
char* WriteInteger(int64_t value, char* into);

}  // namespace badlog

#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace badlog::reader {

enum class CellKind { EMPTY, NUMBER, NOT_FINITE, TRUTH_VALUE, TEXT, DECIMAL_COMMA };

/** The content of a cell: its number or NaN, and its bytes if it is a text. */
struct Cell {
    CellKind kind = CellKind::EMPTY;
    double number = std::numeric_limits<double>::quiet_NaN();
    std::string text{};
};

/** Returns the kind and the number of the bytes inside any quotes. */
Cell ReadCell(std::string_view bytes);

/**
 * Returns the number in the bytes, `[+-]digits[.digits][e[+-]digits]` with this character as the point; nothing if
 * they are not a number.
 */
std::optional<double> ReadDecimal(std::string_view bytes, char point);

}  // namespace badlog::reader

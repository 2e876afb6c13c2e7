#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace badlog::reader {

enum class CellKind { EMPTY, NUMBER, NOT_FINITE, TRUTH_VALUE, TEXT, DECIMAL_COMMA };

/** What a cell holds: its number or NaN, and its bytes if it is a text. */
struct Cell {
    CellKind kind = CellKind::EMPTY;
    double number = std::numeric_limits<double>::quiet_NaN();
    std::string text{};
};

/** The kind and the number of the bytes inside any quotes. */
Cell ReadCell(std::string_view bytes);

/**
 * The number that the bytes are with this character as the point: `[+-]digits[.digits][e[+-]digits]`; nothing if they
 * are not one.
 */
std::optional<double> ReadDecimal(std::string_view bytes, char point);

}  // namespace badlog::reader

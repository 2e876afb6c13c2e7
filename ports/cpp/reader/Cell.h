#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace badlog::reader {

enum class CellKind { EMPTY, NUMBER, NOT_FINITE, TRUTH_VALUE, TEXT, DECIMAL_COMMA };

/** What a cell holds: its number or NaN, and its bytes where it is a text. */
struct Cell {
    CellKind kind = CellKind::EMPTY;
    double number = std::numeric_limits<double>::quiet_NaN();
    std::string text{};
};

/** The kind and the number of the bytes inside any quotes. */
Cell ReadCell(std::string_view bytes);

/** The number that is written with this point, `[+-]digits[.digits][e[+-]digits]`, if the bytes are one. */
std::optional<double> ReadDecimal(std::string_view bytes, char point);

}  // namespace badlog::reader

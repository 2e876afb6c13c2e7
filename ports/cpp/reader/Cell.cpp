#include "Cell.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <locale>
#include <sstream>

namespace badlog::reader {
namespace {

constexpr double INFINITE = std::numeric_limits<double>::infinity();

bool IsDigit(char byte) {
    return byte >= '0' && byte <= '9';
}

size_t SkipDigits(std::string_view bytes, size_t& at) {
    const auto start = at;
    while (at < bytes.size() && IsDigit(bytes[at])) at++;
    return at - start;
}

void SkipSign(std::string_view bytes, size_t& at) {
    if (at < bytes.size() && (bytes[at] == '+' || bytes[at] == '-')) at++;
}

bool IsDecimal(std::string_view bytes, char point) {
    size_t at = 0;
    SkipSign(bytes, at);
    auto digits = SkipDigits(bytes, at);
    if (at < bytes.size() && bytes[at] == point) digits += SkipDigits(bytes, ++at);
    if (digits == 0) return false;
    if (at < bytes.size() && (bytes[at] | 0x20) == 'e') {
        SkipSign(bytes, ++at);
        if (SkipDigits(bytes, at) == 0) return false;
    }
    return at == bytes.size();
}

/** Whether a number that no double can hold is too large rather than too small. */
bool IsHuge(std::string_view number) {
    const auto mark = number.find_first_of("eE");
    int64_t exponent = 0;
    if (mark != std::string_view::npos) {
        size_t at = mark + 1;
        SkipSign(number, at);
        for (; at < number.size() && exponent < 1'000'000'000; at++) exponent = exponent * 10 + (number[at] - '0');
        if (number[mark + 1] == '-') exponent = -exponent;
    }
    const auto digits = number.substr(0, mark);
    const auto first = digits.find_first_of("123456789");
    if (first == std::string_view::npos) return false;
    const auto point = std::min(digits.find('.'), digits.size());
    return exponent + static_cast<int64_t>(point) - static_cast<int64_t>(first) > 0;
}

double DoubleOf(std::string_view number) {
    if (number.front() == '+') number.remove_prefix(1);
#if defined(__cpp_lib_to_chars) && __cpp_lib_to_chars >= 201611L
    double value = 0;
    const auto result = std::from_chars(number.data(), number.data() + number.size(), value);
    if (result.ec == std::errc{}) return value;
#else
    std::istringstream stream{std::string{number}};
    stream.imbue(std::locale::classic());
    double value = 0;
    if (stream >> value && std::isfinite(value)) return value;
#endif
    const bool isNegative = number.front() == '-';
    const double size = IsHuge(isNegative ? number.substr(1) : number) ? INFINITE : 0.0;
    return isNegative ? -size : size;
}

bool IsWord(std::string_view bytes, std::string_view word) {
    return std::equal(bytes.begin(), bytes.end(), word.begin(), word.end(), [](char one, char other) { return (one | 0x20) == other; });
}

}  // namespace

std::optional<double> ReadDecimal(std::string_view bytes, char point) {
    if (!IsDecimal(bytes, point)) return std::nullopt;
    if (point == '.') return DoubleOf(bytes);
    std::string number{bytes};
    std::replace(number.begin(), number.end(), point, '.');
    return DoubleOf(number);
}

Cell ReadCell(std::string_view bytes) {
    const auto first = bytes.find_first_not_of(" \t");
    if (first == std::string_view::npos) return {};
    const auto word = bytes.substr(first, bytes.find_last_not_of(" \t") - first + 1);
    if (const auto number = ReadDecimal(word, '.')) {
        return {std::isfinite(*number) ? CellKind::NUMBER : CellKind::NOT_FINITE, *number};
    }
    if (IsWord(word, "null")) return {};
    if (IsWord(word, "true")) return {CellKind::TRUTH_VALUE, 1};
    if (IsWord(word, "false")) return {CellKind::TRUTH_VALUE, 0};
    if (IsWord(word, "nan")) return {CellKind::NOT_FINITE};
    const auto unsignedWord = word.front() == '+' || word.front() == '-' ? word.substr(1) : word;
    if (IsWord(unsignedWord, "inf") || IsWord(unsignedWord, "infinity")) {
        return {CellKind::NOT_FINITE, word.front() == '-' ? -INFINITE : INFINITE};
    }
    Cell cell;
    cell.kind = CellKind::TEXT;
    return cell;
}

}  // namespace badlog::reader

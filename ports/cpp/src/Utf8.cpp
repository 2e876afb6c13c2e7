#include "Utf8.h"

namespace badlog {
namespace {

uint32_t ByteAt(std::string_view text, size_t index) {
    return static_cast<unsigned char>(text[index]);
}

/** Returns the index of the last character of a text, which is not empty. */
size_t LastStart(std::string_view text) {
    auto start = text.size() - 1;
    while (start > 0 && text.size() - start < 4 && (ByteAt(text, start) & 0xC0) == 0x80) start--;
    return start + CharacterAt(text, start).length == text.size() ? start : text.size() - 1;
}

}  // namespace

Character CharacterAt(std::string_view text, size_t index) {
    const uint32_t first = ByteAt(text, index);
    if (first < 0x80) return {first, 1, true};
    const size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || text.size() - index < length) return {0, 1, false};
    uint32_t code = first & (0x7Fu >> length);
    for (size_t i = 1; i < length; i++) {
        const uint32_t next = ByteAt(text, index + i);
        if ((next & 0xC0) != 0x80) return {0, 1, false};
        code = code << 6 | (next & 0x3F);
    }
    const bool isOverlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
    if (isOverlong || code > 0x10FFFF) return {0, 1, false};
    // Half of a surrogate pair, which Java's texts may contain: one invalid character.
    if (code >= 0xD800 && code < 0xE000) return {0, length, false};
    return {code, length, true};
}

bool IsWhitespace(uint32_t code) {
    return code == ' ' || (code >= 0x09 && code <= 0x0D) || (code >= 0x1C && code <= 0x1F) || code == 0xA0 || code == 0x1680 ||
           (code >= 0x2000 && code <= 0x200A) || code == 0x2028 || code == 0x2029 || code == 0x202F || code == 0x205F ||
           code == 0x3000;
}

bool HasOuterWhitespace(std::string_view text) {
    return !text.empty() &&
           (IsWhitespace(CharacterAt(text, 0).code) || IsWhitespace(CharacterAt(text, LastStart(text)).code));
}

bool IsBlank(std::string_view text) {
    return Trimmed(text).empty();
}

std::string_view Trimmed(std::string_view text) {
    while (!text.empty()) {
        const auto first = CharacterAt(text, 0);
        if (!IsWhitespace(first.code)) break;
        text.remove_prefix(first.length);
    }
    while (!text.empty() && IsWhitespace(CharacterAt(text, LastStart(text)).code)) text = text.substr(0, LastStart(text));
    return text;
}

}  // namespace badlog

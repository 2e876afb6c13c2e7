#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace badlog {

/** Stands for bytes that are not UTF-8, and for NUL, which in a bag is a sign of damage. */
constexpr std::string_view REPLACEMENT = "\xEF\xBF\xBD";

/** A character of a text, and its number of bytes there. */
struct Character {
    uint32_t code;
    size_t length;
    /** False if the bytes are not UTF-8. */
    bool isValid;
};

/** Returns the character that begins at an index of a text. */
Character CharacterAt(std::string_view text, size_t index);

/** Returns whether Java counts it as whitespace of any kind. */
bool IsWhitespace(uint32_t code);

/** Returns whether the first or the last character of a text is whitespace. */
bool HasOuterWhitespace(std::string_view text);

/** Returns whether a text is nothing but whitespace. */
bool IsBlank(std::string_view text);

/** Returns the text without whitespace at its ends. */
std::string_view Trimmed(std::string_view text);

}  // namespace badlog

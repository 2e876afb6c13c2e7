#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace badlog::reader {

/** Returns the text of bytes in UTF-8, or otherwise in Windows-1252, which sets `wasNotUtf8`. */
std::string Decode(std::string_view bytes, bool& wasNotUtf8);
std::string Decode(std::string_view bytes);

/** Returns the first bytes of a text, for a message; a shortened text ends in an ellipsis. */
std::string Excerpt(std::string_view bytes, size_t most);

/**
 * Appends a character. Half of a surrogate pair, which JSON can name, becomes the three bytes that UTF-8 would have for
 * it.
 */
void AppendCharacter(std::string& text, uint32_t code);

/** Returns whether it is a letter or a digit of any script. A character of two UTF-16 units counts as neither. */
bool IsLetterOrDigit(uint32_t code);

/** Returns a text with one part replaced by another wherever it occurs. */
std::string Replaced(std::string_view text, std::string_view part, std::string_view by);

}  // namespace badlog::reader

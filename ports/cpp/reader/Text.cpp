#include "Text.h"

#include "Utf8.h"

namespace badlog::reader {
namespace {

// The only place where Windows-1252 differs from Latin-1; its five unassigned bytes stay controls.
constexpr char16_t HIGH_CONTROLS[] =
    u"\u20AC\u0081\u201A\u0192\u201E\u2026\u2020\u2021\u02C6\u2030\u0160\u2039\u0152\u008D\u017D\u008F"
    u"\u0090\u2018\u2019\u201C\u201D\u2022\u2013\u2014\u02DC\u2122\u0161\u203A\u0153\u009D\u017E\u0178";

bool IsUtf8(std::string_view bytes) {
    for (size_t i = 0; i < bytes.size();) {
        const auto character = CharacterAt(bytes, i);
        if (!character.isValid) return false;
        i += character.length;
    }
    return true;
}

}  // namespace

std::string Decode(std::string_view bytes, bool& wasNotUtf8) {
    if (IsUtf8(bytes)) return std::string{bytes};
    wasNotUtf8 = true;
    std::string text;
    for (const char signedByte : bytes) {
        const auto byte = static_cast<unsigned char>(signedByte);
        AppendCharacter(text, byte >= 0x80 && byte < 0xA0 ? HIGH_CONTROLS[byte - 0x80] : byte);
    }
    return text;
}

std::string Decode(std::string_view bytes) {
    bool wasNotUtf8 = false;
    return Decode(bytes, wasNotUtf8);
}

std::string Excerpt(std::string_view bytes, size_t most) {
    if (bytes.size() <= most) return Decode(bytes);
    auto end = most;
    while (end > 0 && (static_cast<unsigned char>(bytes[end]) & 0xC0) == 0x80) end--;
    return Decode(bytes.substr(0, end)) + "…";
}

void AppendCharacter(std::string& text, uint32_t code) {
    if (code < 0x80) {
        text += static_cast<char>(code);
        return;
    }
    const int more = code < 0x800 ? 1 : code < 0x10000 ? 2 : 3;
    static constexpr uint32_t LEADS[] = {0, 0xC0, 0xE0, 0xF0};
    text += static_cast<char>(LEADS[more] | code >> (6 * more));
    for (int shift = 6 * (more - 1); shift >= 0; shift -= 6) text += static_cast<char>(0x80 | (code >> shift & 0x3F));
}

std::string Replaced(std::string_view text, std::string_view part, std::string_view by) {
    std::string result;
    for (size_t at = text.find(part); at != std::string_view::npos; at = text.find(part)) {
        result += text.substr(0, at);
        result += by;
        text.remove_prefix(at + part.size());
    }
    return result += text;
}

}  // namespace badlog::reader

#include "SystemPath.h"

#include "Utf8.h"

namespace badlog {

#if defined(_WIN32)
namespace {

constexpr uint32_t REPLACEMENT_CODE = 0xFFFD;
constexpr uint32_t FIRST_PAIR = 0x10000;

std::wstring Utf16(std::string_view text) {
    std::wstring units;
    for (size_t i = 0; i < text.size();) {
        const auto character = CharacterAt(text, i);
        const auto code = character.isValid ? character.code : REPLACEMENT_CODE;
        if (code < FIRST_PAIR) {
            units += static_cast<wchar_t>(code);
        } else {
            units += static_cast<wchar_t>(0xD800 + ((code - FIRST_PAIR) >> 10));
            units += static_cast<wchar_t>(0xDC00 + ((code - FIRST_PAIR) & 0x3FF));
        }
        i += character.length;
    }
    return units;
}

}  // namespace

std::filesystem::path SystemPath(std::string_view path) {
    return {Utf16(path)};
}
#else
std::filesystem::path SystemPath(std::string_view path) {
    return {path};
}
#endif

std::string TextOf(const std::filesystem::path& path) {
    // A text of char8_t in C++20, of char before.
    const auto text = path.u8string();
    return {text.begin(), text.end()};
}

}  // namespace badlog

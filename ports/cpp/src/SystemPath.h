#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace badlog {

/**
 * Converts a path in UTF-8 to the form of the system's calls. On Windows that is UTF-16, where invalid bytes become U+FFFD;
 * elsewhere, its bytes.
 */
std::filesystem::path SystemPath(std::string_view path);

/** Returns the text of a path in UTF-8. */
std::string TextOf(const std::filesystem::path& path);

}  // namespace badlog

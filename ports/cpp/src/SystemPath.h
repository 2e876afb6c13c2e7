#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace badlog {

/**
 * Returns a path in UTF-8 in the form of the system's calls: on Windows in UTF-16, where invalid bytes become U+FFFD; elsewhere,
 * its bytes.
 */
std::filesystem::path SystemPath(std::string_view path);

/** Returns the text of a path in UTF-8. */
std::string TextOf(const std::filesystem::path& path);

}  // namespace badlog

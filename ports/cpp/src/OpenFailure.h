#pragma once

#include <string>
#include <system_error>

namespace badlog {

/** Returns why the log at a path in UTF-8 cannot be created, and what to do next, for a person. */
std::string OpenFailureText(const std::string& path, std::error_code failure);

}  // namespace badlog

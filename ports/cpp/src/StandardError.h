#pragma once

#include <string_view>

namespace badlog {

/**
 * Says what went wrong on standard error, soon, by a thread of its own: where that is a pipe that nobody reads, writing to it
 * may never return, and a robot's loop cannot wait for that. Messages that come while too many wait are left out.
 */
void SayOnStandardError(std::string_view message) noexcept;

/** Waits until all is said, but not longer than this; whether it is. */
bool AwaitSaid(int milliseconds) noexcept;

}  // namespace badlog

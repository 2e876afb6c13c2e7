#pragma once

#include <string_view>

namespace badlog {

/**
 * Reports what went wrong on standard error, soon, from a thread of its own: if that is a pipe that nobody reads, a write may
 * never return, and a robot's loop cannot wait for that. Messages that come while too many wait are dropped.
 */
void SayOnStandardError(std::string_view message) noexcept;

/** Waits until all messages are written, but no longer than this; returns whether they are. */
bool AwaitSaid(int milliseconds) noexcept;

}  // namespace badlog

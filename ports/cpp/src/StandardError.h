#pragma once

#include <string_view>

namespace badlog {

/**
 * Prints a message on standard error soon, from another thread. If standard error is a pipe without a reader, a write may
 * never return, and a robot's loop cannot wait for that. Messages that arrive while too many are waiting are dropped.
 */
void PrintOnStandardError(std::string_view message) noexcept;

/** Waits until all messages are written, but no longer than this; returns whether they are. */
bool AwaitPrinted(int milliseconds) noexcept;

}  // namespace badlog

#pragma once

#include <exception>
#include <string_view>
#include <utility>

namespace badlog {

/**
 * Runs the robot's code, or code that may run out of memory, and catches every exception. `failed` gets the exception's
 * text. badlog itself throws nothing, and can be compiled without exceptions.
 */
template <typename Action, typename Failed>
void Guarded(Action&& action, [[maybe_unused]] Failed&& failed) noexcept {
#if defined(__cpp_exceptions) || defined(_CPPUNWIND)
    try {
        action();
    } catch (const std::exception& failure) {
        failed(std::string_view{failure.what()});
    } catch (...) {
        failed(std::string_view{"something that is not a std::exception"});
    }
#else
    action();
#endif
}

}  // namespace badlog

#include "StandardError.h"

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <mutex>
#include <string>
#include <thread>

#include "Guarded.h"

namespace badlog {
namespace {

constexpr size_t MAX_WAITING = 200;
constexpr int EXIT_MILLISECONDS = 250;

struct Messages {
    std::mutex mutex;
    std::condition_variable changed;
    std::deque<std::string> waiting;
    bool isStarted = false;
};

/** Never destroyed, because its thread may outlive everything else. */
Messages& TheMessages() {
    static Messages* const messages = new Messages;
    return *messages;
}

[[noreturn]] void PrintAll(Messages& messages) {
    std::unique_lock lock{messages.mutex};
    while (true) {
        messages.changed.wait(lock, [&] { return !messages.waiting.empty(); });
        const auto line = "badlog: " + messages.waiting.front() + "\n";
        lock.unlock();
        std::fwrite(line.data(), 1, line.size(), stderr);
        lock.lock();
        messages.waiting.pop_front();
        messages.changed.notify_all();
    }
}

}  // namespace

void PrintOnStandardError(std::string_view message) noexcept {
    Guarded(
        [&] {
            auto& messages = TheMessages();
            const std::lock_guard lock{messages.mutex};
            if (messages.waiting.size() < MAX_WAITING) messages.waiting.emplace_back(message);
            messages.changed.notify_all();
            if (messages.isStarted) return;
            std::thread{PrintAll, std::ref(messages)}.detach();
            messages.isStarted = true;
            // If the fault ends the program, the message must still be printed.
            std::atexit([] { AwaitPrinted(EXIT_MILLISECONDS); });
        },
        [](std::string_view) {
            // The system has no thread or no memory for this; the next message tries again.
        });
}

bool AwaitPrinted(int milliseconds) noexcept {
    auto& messages = TheMessages();
    std::unique_lock lock{messages.mutex};
    return messages.changed.wait_for(
        lock, std::chrono::milliseconds{milliseconds}, [&] { return messages.waiting.empty(); });
}

}  // namespace badlog

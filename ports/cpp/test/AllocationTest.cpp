#include <doctest/doctest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>
#include <string>

#include "LogFiles.h"

using badlog::BadLog;

namespace {

std::atomic<long> allocations{0};

void* Allocated(std::size_t size) {
    allocations++;
    return std::malloc(size == 0 ? 1 : size);
}

}  // namespace

void* operator new(std::size_t size) {
    if (void* const memory = Allocated(size)) return memory;
    std::abort();
}
void* operator new[](std::size_t size) { return operator new(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept { return Allocated(size); }
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept { return Allocated(size); }
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete[](void* memory, const std::nothrow_t&) noexcept { std::free(memory); }

TEST_CASE("nothing is allocated after FinishInitialization for any numbers, texts and events") {
    const std::string text(200, 'x');
    double number = 0;
    badlog::Publisher publisher;
    badlog::Events events;
    Logged(
        [&] {
            BadLog::CreateTopic("Time", "s", [&] { return number; }, {"xaxis"});
            for (int i = 0; i < 30; i++) BadLog::CreateTopic("Topic " + std::to_string(i), "V", [&] { return number * 1.37; });
            BadLog::CreateTopicLong("Long", "ul", [] { return INT64_MIN; });
            BadLog::CreateTopicBoolean("Boolean", "ul", [] { return true; });
            BadLog::CreateTopicStr("Short", "ul", [] { return "short"; });
            BadLog::CreateTopicSubscriber("Published", "ul", badlog::DataInferMode::DEFAULT, {"log"});
            publisher = BadLog::CreatePublisher("Text", "ul", badlog::DataInferMode::LAST);
            events = BadLog::CreateEvents("Events");
        },
        [&](BadLog& log) {
            const auto before = allocations.load();
            for (int i = 0; i < 2000; i++) {
                number = std::ldexp(1.2345, i - 1000);
                BadLog::Publish("Published", "text, \"quoted\"");
                publisher.Publish(text);
                for (int event = 0; event < i % 50; event++) events.Event(text);
                Row(log);
            }
            CHECK(allocations.load() - before == 0);
            CHECK(log.Counters().rowsWritten == 2000);
        });
}

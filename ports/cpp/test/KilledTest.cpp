#include <doctest/doctest.h>

#if !defined(_WIN32)

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <csignal>
#include <new>
#include <random>
#include <string>
#include <sys/mman.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

#include "LogFiles.h"

using badlog::BadLog;

namespace {

constexpr int KILLS = 200;

/** Logs until it is killed, and counts the calls of Log that have returned. */
[[noreturn]] void RunRobot(const std::string& path, std::atomic<int64_t>& returned) {
    const auto log = BadLog::Init(path);
    int64_t row = 0;
    BadLog::CreateTopicLong("Row", "ul", [&] { return row; });
    for (int i = 0; i < 20; i++) BadLog::CreateTopic("Topic/" + std::to_string(i), "V", [&, i] { return std::sin(static_cast<double>(row)) * i; });
    const auto events = BadLog::CreateEvents("Events");
    log.FinishInitialization();
    while (true) {
        if (row % 100 == 7) events.Event("row " + std::to_string(row) + ", \"quoted\"");
        log.UpdateTopics();
        log.Log();
        returned = ++row;
    }
}

}  // namespace

TEST_CASE("after killing 200 robots within their loops, each file has every row for which Log() returned") {
    void* const shared = mmap(nullptr, sizeof(std::atomic<int64_t>), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    REQUIRE(shared != MAP_FAILED);
    const Folder folder;
    std::mt19937 random{1};
    int64_t allRows = 0;
    for (int i = 0; i < KILLS; i++) {
        auto& returned = *new (shared) std::atomic<int64_t>{0};
        const auto path = folder / (std::to_string(i) + ".bag");
        const auto robot = fork();
        REQUIRE(robot >= 0);
        if (robot == 0) RunRobot(path, returned);
        while (returned == 0) std::this_thread::sleep_for(std::chrono::microseconds{100});
        std::this_thread::sleep_for(std::chrono::microseconds{random() % 20'000});
        kill(robot, SIGKILL);
        waitpid(robot, nullptr, 0);

        const auto rows = RowsIn(path);
        const auto count = returned.load();
        allRows += count;
        REQUIRE(static_cast<int64_t>(rows.size()) >= count);
        for (int64_t row = 0; row < count; row++) {
            const auto& text = rows[static_cast<size_t>(row)];
            REQUIRE(text.rfind(std::to_string(row) + ",", 0) == 0);
            REQUIRE(std::count(text.begin(), text.end(), ',') >= 21);
        }
    }
    MESSAGE(allRows, " rows of ", KILLS, " robots");
    CHECK(allRows > KILLS);
    munmap(shared, sizeof(std::atomic<int64_t>));
}

#endif

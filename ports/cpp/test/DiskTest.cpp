#include <doctest/doctest.h>

#if !defined(_WIN32)

#include <chrono>
#include <csignal>
#include <filesystem>
#include <string>
#include <sys/resource.h>
#include <thread>

#include "LogFiles.h"

using badlog::BadLog;
using badlog::LogState;

namespace {

/** Logs rows until the log is in a state, or two minutes have passed. */
void RowsUntil(const BadLog& log, LogState wanted) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::minutes{2};
    while (log.State() != wanted && std::chrono::steady_clock::now() < end) {
        Row(log);
        std::this_thread::sleep_for(std::chrono::milliseconds{1});
    }
    CHECK(log.State() == wanted);
}

}  // namespace

TEST_CASE("a file that cannot be created is reported, and nothing is logged") {
    const auto messages = StandardErrorOf([] {
        const auto log = BadLog::Init("/dev/null/a.bag");
        BadLog::CreateTopic("A", "ul", [] { return 1; });
        log.FinishInitialization();
        for (int i = 0; i < 10; i++) Row(log);
        CHECK(log.State() == LogState::FAILING);
        CHECK(log.Counters().rowsMissed == 10);
        log.Close();
    });
    CHECK(messages.find("The log /dev/null/a.bag cannot be created") != std::string::npos);
}

TEST_CASE("events that no row could take before the end are counted" * doctest::skip(!std::filesystem::exists("/dev/full"))) {
    const auto messages = StandardErrorOf([] {
        const auto log = BadLog::Init("/dev/full");
        const auto events = BadLog::CreateEvents("Events");
        log.FinishInitialization();
        events.Event("one");
        Row(log);
        log.Close();
        // Including the one that says that nothing can be written.
        CHECK(log.Counters().eventsDropped == 2);
        CHECK(log.Counters().rowsMissed == 1);
    });
    CHECK(messages.find("No space left") != std::string::npos);
}

TEST_CASE("a file that may not grow loses rows and nothing else, and tears no row") {
    const Folder folder;
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    StandardErrorOf([&] {
        const auto log = BadLog::Init(folder / "a.bag");
        int64_t count = 0;
        BadLog::CreateTopicLong("Count", "ul", [&] { return count++; });
        BadLog::CreateTopicStr("Text", "ul", [] { return std::string(100, 'x'); });
        const auto events = BadLog::CreateEvents("Events");
        log.FinishInitialization();
        signal(SIGXFSZ, SIG_IGN);
        rlimit small = before;
        small.rlim_cur = 5'000;
        setrlimit(RLIMIT_FSIZE, &small);
        RowsUntil(log, LogState::FAILING);
        for (int i = 0; i < 100; i++) Row(log);
        events.Event("while it was full");
        setrlimit(RLIMIT_FSIZE, &before);
        RowsUntil(log, LogState::LOGGING);
        Row(log);
        const auto counters = log.Counters();
        CHECK(counters.rowsMissed >= 100);
        CHECK(counters.rowsWritten + counters.rowsMissed == count);
        CHECK(counters.eventsDropped == 0);
        log.Close();
        CHECK(counters.bytesWritten == static_cast<int64_t>(Read(folder / "a.bag").size()));
    });
    bool isNoted = false;
    for (const auto& row : RowsIn(folder / "a.bag")) {
        CHECK(row.find("," + std::string(100, 'x') + ",") != std::string::npos);
        isNoted = isNoted || row.find("while it was full") != std::string::npos;
    }
    CHECK(isNoted);
    CHECK(RowsIn(folder / "a.bag").back().find("rows before this one could not be written") != std::string::npos);
}

TEST_CASE("deleting a file while it is written is noticed, with syncing on or off") {
    for (const bool isSyncing : {true, false}) {
        const Folder folder;
        const auto messages = StandardErrorOf([&] {
            const auto log = BadLog::Init(folder / "a.bag", {/*flushesEachRow=*/true, isSyncing});
            BadLog::CreateTopic("A", "ul", [] { return 1; });
            log.FinishInitialization();
            Row(log);
            std::filesystem::remove(folder / "a.bag");
            RowsUntil(log, LogState::FAILING);
            Row(log);
            CHECK(log.Counters().rowsMissed >= 1);
            log.Close();
        });
        CHECK(messages.find("was deleted, or its disk was removed") != std::string::npos);
    }
}

#endif

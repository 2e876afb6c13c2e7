#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <set>
#include <string>
#include <string_view>

#include "badlog/BadLog.h"

namespace badlog {

class EventTexts;
class Topic;

/** The live counters; any thread may read them. */
struct Counters {
    std::atomic<int64_t> rowsWritten{0};
    std::atomic<int64_t> rowsMissed{0};
    std::atomic<int64_t> bytesWritten{0};
    std::atomic<int64_t> slowestRow{0};
    std::atomic<int64_t> slowWrites{0};
    std::atomic<int64_t> failedSyncs{0};
    std::atomic<int64_t> cellsMissed{0};
    std::atomic<int64_t> callsIgnored{0};
    std::atomic<int64_t> eventsDropped{0};

    LogCounters Snapshot() const;
};

/**
 * Handles the faults in a robot's loop. Each is counted every time, reported once on standard error, and noted as an event if
 * the log has an event log. Texts are built only when they are reported.
 */
class Faults {
public:
    Counters counters;
    /** The column that takes events, if there is one. */
    std::atomic<EventTexts*> room{nullptr};

    /** The cell of a topic stays empty in this row, because its supplier did `what`. */
    void CellMissed(Topic& topic, std::string_view what, std::string_view detail = {}) noexcept;
    /** Handles an ignored call: `about` names it, `why` gives the reason. Each `about` is reported once. */
    void CallIgnored(std::string_view about, std::string_view why) noexcept;
    /** Handles a value that was published to a name but is ignored. */
    void PublishIgnored(std::string_view name) noexcept;
    /** Reports a message, unless its subject, one of the log's own few, was reported before. */
    void ReportOnce(std::string_view about, std::string_view message) noexcept;
    /** Whether ReportOnce would report something. */
    bool IsNew(std::string_view about) noexcept;
    /** Keeps a text for the next row that has room. */
    void Note(std::string_view text) noexcept;

private:
    using Names = std::set<std::string, std::less<>>;

    void Report(std::string_view message) noexcept;
    bool IsCountedNew(Names& before, std::string_view about) noexcept;

    std::mutex m_mutex;
    // Three sets, because a program's names must not clash with each other or with the log's own subjects.
    Names m_reported;
    Names m_ignoredCalls;
    Names m_ignoredNames;
};

}  // namespace badlog

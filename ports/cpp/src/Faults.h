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

/** The counters while they count; any thread reads them. */
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
 * Takes everything that goes wrong in a robot's loop: it is counted each time, reported once on standard error, and noted as an
 * event in the log if that has an event log. Texts are only made when they are reported.
 */
class Faults {
public:
    Counters counters;
    /** The column that takes events, if there is one. */
    std::atomic<EventTexts*> room{nullptr};

    /** The cell of a topic stays empty in this row, because its supplier did `what`. */
    void CellMissed(Topic& topic, std::string_view what, std::string_view detail = {}) noexcept;
    /** A call of what `about` names was ignored, because it `why`; reported once each. */
    void CallIgnored(std::string_view about, std::string_view why) noexcept;
    /** What was published to a name was ignored. */
    void PublishIgnored(std::string_view name) noexcept;
    /** Reports a message, unless its subject, one of the log's own few, was reported before. */
    void SayOnce(std::string_view about, std::string_view message) noexcept;
    /** Whether SayOnce would report something. */
    bool IsNew(std::string_view about) noexcept;
    /** Keeps a text for the next row that has room. */
    void Note(std::string_view text) noexcept;

private:
    using Names = std::set<std::string, std::less<>>;

    void Say(std::string_view message) noexcept;
    bool IsCountedNew(Names& before, std::string_view about) noexcept;

    std::mutex m_mutex;
    // Three, so that the names that a program makes up are confused neither with each other nor with the log's own subjects.
    Names m_said;
    Names m_ignoredCalls;
    Names m_ignoredNames;
};

}  // namespace badlog

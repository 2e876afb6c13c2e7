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
 * Where everything goes that went wrong in a robot's loop: counted each time, said once on standard error, and noted as an event
 * in the log if that has room for events. Texts are made only when they are said.
 */
class Faults {
public:
    Counters counters;
    /** The column that takes events, if there is one. */
    std::atomic<EventTexts*> room{nullptr};

    /** The cell of a topic stays empty in this row, because its supplier did `what`. */
    void CellMissed(Topic& topic, std::string_view what, std::string_view detail = {}) noexcept;
    /** A call of what `about` names was not followed, because it `why`; said once each. */
    void CallIgnored(std::string_view about, std::string_view why) noexcept;
    /** What was published to a name was not taken. */
    void PublishIgnored(std::string_view name) noexcept;
    /** Says a message, unless something was said about one of the log's own few subjects before. */
    void SayOnce(std::string_view about, std::string_view message) noexcept;
    /** Whether SayOnce would say something. */
    bool IsNew(std::string_view about) noexcept;
    /** Keeps a text for the next row that has room. */
    void Note(std::string_view text) noexcept;

private:
    using Names = std::set<std::string, std::less<>>;

    void Say(std::string_view message) noexcept;
    bool IsCountedNew(Names& before, std::string_view about) noexcept;

    std::mutex m_mutex;
    // Three, because the names that a program makes up must neither meet each other nor the log's own subjects.
    Names m_said;
    Names m_ignoredCalls;
    Names m_ignoredNames;
};

}  // namespace badlog

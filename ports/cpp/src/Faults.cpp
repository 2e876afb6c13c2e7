#include "Faults.h"

#include "EventTexts.h"
#include "Guarded.h"
#include "StandardError.h"
#include "Topics.h"

namespace badlog {
namespace {

// A program that invents names must not fill the memory with them.
constexpr size_t MAX_MESSAGES = 100;

void IgnoreFailure(std::string_view) {
    // Without memory for a message, only the counters show the fault.
}

}  // namespace

LogCounters Counters::Snapshot() const {
    LogCounters snapshot;
    snapshot.rowsWritten = rowsWritten;
    snapshot.rowsMissed = rowsMissed;
    snapshot.bytesWritten = bytesWritten;
    snapshot.slowestRowNanos = slowestRow;
    snapshot.slowWrites = slowWrites;
    snapshot.failedSyncs = failedSyncs;
    snapshot.cellsMissed = cellsMissed;
    snapshot.callsIgnored = callsIgnored;
    snapshot.eventsDropped = eventsDropped;
    return snapshot;
}

void Faults::CellMissed(Topic& topic, std::string_view what, std::string_view detail) noexcept {
    counters.cellsMissed++;
    if (topic.isFaultReported.exchange(true)) return;
    Guarded(
        [&] {
            Report("The topic \"" + topic.Name() + "\" " + std::string{what} + std::string{detail} +
                ", so its cell is empty. Further gaps of this topic are only counted.");
        },
        IgnoreFailure);
}

void Faults::CallIgnored(std::string_view about, std::string_view why) noexcept {
    if (!IsCountedNew(m_ignoredCalls, about)) return;
    Guarded([&] { Report(std::string{about} + " " + std::string{why}); }, IgnoreFailure);
}

void Faults::PublishIgnored(std::string_view name) noexcept {
    if (!IsCountedNew(m_ignoredNames, name)) return;
    Guarded(
        [&] {
            Report("Values published to \"" + std::string{name} +
                "\" are ignored: CreateTopicSubscriber() was not called for it.");
        },
        IgnoreFailure);
}

void Faults::ReportOnce(std::string_view about, std::string_view message) noexcept {
    if (!IsNew(about)) return;
    Guarded(
        [&] {
            const std::lock_guard lock{m_mutex};
            m_reported.emplace(about);
        },
        IgnoreFailure);
    Report(message);
}

bool Faults::IsNew(std::string_view about) noexcept {
    const std::lock_guard lock{m_mutex};
    return m_reported.find(about) == m_reported.end();
}

void Faults::Note(std::string_view text) noexcept {
    if (auto* const texts = room.load()) texts->Add(text);
}

void Faults::Report(std::string_view message) noexcept {
    PrintOnStandardError(message);
    Note(message);
}

bool Faults::IsCountedNew(Names& before, std::string_view about) noexcept {
    counters.callsIgnored++;
    bool isNew = false;
    Guarded(
        [&] {
            const std::lock_guard lock{m_mutex};
            isNew = before.size() < MAX_MESSAGES && before.find(about) == before.end() && before.emplace(about).second;
        },
        IgnoreFailure);
    return isNew;
}

}  // namespace badlog

#include "RowSink.h"

#include <utility>

#include "Guarded.h"

namespace badlog {
namespace {

using namespace std::chrono_literals;

constexpr size_t BATCH_BYTES = 6 * 1024;
constexpr auto MAX_WAIT = 250ms;
constexpr auto RETRY_WAIT = 250ms;
constexpr auto SLOW = 5ms;

}  // namespace

RowSink::RowSink(LogFile& file, bool flushesEachRow, Faults& faults)
    : m_file{file}, m_flushesEachRow{flushesEachRow}, m_faults{faults} {}

void RowSink::Begin(std::string lines, std::vector<EventTexts*> events) {
    m_events = std::move(events);
    m_header = std::move(lines);
    Write(std::chrono::steady_clock::now());
}

bool RowSink::IsRefusing(Time now) const {
    return IsWaitingToRetry(now) && (m_flushesEachRow || row.Size() >= BATCH_BYTES);
}

void RowSink::EndRow(Time began) {
    if (!row.EndRow()) {
        DropRow();
        return;
    }
    m_rowsWaiting++;
    const bool isDue = m_flushesEachRow || row.Size() >= BATCH_BYTES || began - m_lastWrite >= MAX_WAIT;
    if (isDue && !IsWaitingToRetry(began)) Write(began);
    const auto nanos = std::chrono::nanoseconds{std::chrono::steady_clock::now() - began}.count();
    if (nanos > m_faults.counters.slowestRow) m_faults.counters.slowestRow = nanos;
}

void RowSink::DropRow() {
    m_faults.counters.rowsMissed++;
    // This includes the events of buffered rows: an event in two rows is better than in none.
    for (auto* texts : m_events) texts->Restore();
    m_faults.ReportOnce("row", "A row of the log was lost: there is not memory enough for its texts.");
}

void RowSink::Flush() {
    if (m_rowsWaiting > 0 || !m_header.empty()) Write(std::chrono::steady_clock::now());
}

void RowSink::FlushWaiting() {
    if (!IsWaitingToRetry(std::chrono::steady_clock::now())) Flush();
}

void RowSink::Finish() {
    Flush();
    for (auto* texts : m_events) texts->End();
}

bool RowSink::IsWaitingToRetry(Time now) const {
    return isFailing && now - m_lastWrite < RETRY_WAIT;
}

void RowSink::Write(Time now) {
    m_lastWrite = now;
    if (!m_header.empty()) {
        if (const auto failure = Append(m_header)) return Failed(failure);
        m_header.clear();
    }
    if (m_rowsWaiting > 0) {
        if (const auto failure = Append(row.Bytes())) return Failed(failure);
    }
    // Writing to a deleted file succeeds silently; a file that was only moved may come back.
    auto& counted = m_file.isMissing ? m_faults.counters.rowsMissed : m_faults.counters.rowsWritten;
    counted += m_rowsWaiting;
    m_faults.counters.bytesWritten = m_file.Length();
    isDirty = true;
    ForgetRows();
    for (auto* texts : m_events) texts->Written();
    if (isFailing) Recovered();
}

std::error_code RowSink::Append(std::string_view bytes) {
    const auto began = std::chrono::steady_clock::now();
    const auto failure = m_file.Append(bytes);
    if (std::chrono::steady_clock::now() - began > SLOW) m_faults.counters.slowWrites++;
    return failure;
}

void RowSink::Failed(std::error_code failure) {
    Lose(m_rowsWaiting);
    ForgetRows();
    for (auto* texts : m_events) texts->Restore();
    isFailing = true;
    if (!m_faults.IsNew("write")) return;
    Guarded(
        [&] {
            m_faults.ReportOnce(
                "write", "The log " + m_file.Path() + " cannot be written: " + failure.message() +
                             ". Rows are lost until it can; check whether the disk is full or was removed.");
        },
        [](std::string_view) {});
}

void RowSink::Lose(int64_t rows) {
    m_rowsLost += rows;
    m_faults.counters.rowsMissed += rows;
}

void RowSink::ForgetRows() {
    row.Clear();
    m_rowsWaiting = 0;
}

void RowSink::Recovered() {
    isFailing = false;
    Guarded(
        [&] { m_faults.Note(std::to_string(m_rowsLost) + " rows before this one could not be written"); },
        [](std::string_view) {});
    m_rowsLost = 0;
}

}  // namespace badlog

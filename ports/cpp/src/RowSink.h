#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <string>
#include <system_error>
#include <vector>

#include "EventTexts.h"
#include "Faults.h"
#include "LogFile.h"
#include "RowWriter.h"

namespace badlog {

/**
 * Writes rows: each at once, or several together at most a quarter of a second after the previous write. Rows that cannot be
 * written are lost and counted. After a failure it waits before the next attempt, because a full or missing disk may be slow
 * to report it. Guarded by the log's lock.
 */
class RowSink {
public:
    using Time = std::chrono::steady_clock::time_point;

    RowSink(LogFile& file, bool flushesEachRow, Faults& faults);

    /** The writer for the next row's cells. */
    RowWriter row;
    /** Whether the last attempt to write failed. */
    std::atomic<bool> isFailing{false};
    /** Whether something was written since this was last set to false. */
    std::atomic<bool> isDirty{false};

    /** Writes lines before any row. Rows will take events from `events`. */
    void Begin(std::string lines, std::vector<EventTexts*> events);
    /** Returns whether a row begun now would be lost. Do not begin it then, so that no events are lost with it. */
    bool IsRefusing(Time now) const;
    /** Counts a row that was not begun. */
    void MissRow() { Lose(1); }
    /** Ends the row in `row`. */
    void EndRow(Time began);
    /** Writes all rows that wait. */
    void Flush();
    /** Does the same as Flush, unless a write has just failed. */
    void FlushWaiting();
    /** Writes the waiting rows; no row may follow. */
    void Finish();

private:
    bool IsWaitingToRetry(Time now) const;
    void Write(Time now);
    std::error_code Append(std::string_view bytes);
    void Failed(std::error_code failure);
    void DropRow();
    void Lose(int64_t rows);
    void ForgetRows();
    void Recovered();

    LogFile& m_file;
    const bool m_flushesEachRow;
    Faults& m_faults;
    std::vector<EventTexts*> m_events;
    std::string m_header;
    int64_t m_rowsWaiting = 0;
    int64_t m_rowsLost = 0;
    Time m_lastWrite = std::chrono::steady_clock::now();
};

}  // namespace badlog

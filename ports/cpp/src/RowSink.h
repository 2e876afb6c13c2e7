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
 * Takes rows and writes them: each at once, or several together, but none later than a quarter of a second after the previous
 * write. Rows that cannot be written are lost and counted; the sink then waits a little before it tries again, because a disk
 * that is full or gone may be slow to say so. Guarded by the log's lock.
 */
class RowSink {
public:
    using Time = std::chrono::steady_clock::time_point;

    RowSink(LogFile& file, bool flushesEachRow, Faults& faults);

    /** The cells of the next row are written here. */
    RowWriter row;
    /** Whether the last attempt to write failed. */
    std::atomic<bool> isFailing{false};
    /** Whether something was written since this was last set to false. */
    std::atomic<bool> isDirty{false};

    /** Writes lines before any row. Rows will take events from `events`. */
    void Begin(std::string lines, std::vector<EventTexts*> events);
    /** Whether a row begun now would be lost. It is better not begun then, so that it takes no events with it. */
    bool IsRefusing(Time now) const;
    /** Counts a row that was not begun. */
    void MissRow() { Lose(1); }
    /** Ends the row in `row`. */
    void EndRow(Time began);
    /** Writes all rows that wait. */
    void Flush();
    /** Does what Flush does, unless that failed a moment ago. */
    void FlushWaiting();
    /** Writes what waits; no row follows. */
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

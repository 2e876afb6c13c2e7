#pragma once

#include <atomic>
#include <condition_variable>
#include <functional>
#include <memory>
#include <mutex>

#include "Faults.h"
#include "LogFile.h"
#include "RowSink.h"

namespace badlog {

/**
 * Four times a second, writes the rows that wait and brings what was written to the disk, so that a loss of power takes no more
 * than that. It holds no lock while it waits for a sync. It also notices when the file is deleted. In the end, it closes the
 * file.
 */
class SyncThread : public std::enable_shared_from_this<SyncThread> {
public:
    SyncThread(LogFile& file, RowSink& sink, Faults& faults, bool isSyncing, std::function<void()> flush);

    /** Whether it syncs rows to the disk; it does the rest anyway. */
    std::atomic<bool> isSyncing;

    /** Starts it; it keeps the owner of all that it uses alive. False if the system has no thread for it. */
    bool Start(std::shared_ptr<void> owner);
    /** Ends it soon, without waiting for it. */
    void Finish();

private:
    void Run();
    bool Pause();
    void Sync();
    void LookForFile();

    LogFile& m_file;
    RowSink& m_sink;
    Faults& m_faults;
    std::function<void()> m_flush;
    std::mutex m_mutex;
    std::condition_variable m_changed;
    bool m_isFinished = false;
    int m_timesMissing = 0;
};

/** Closes a file; a failure is reported, because the disk may be gone by then. */
void CloseFile(LogFile& file, Faults& faults);

}  // namespace badlog

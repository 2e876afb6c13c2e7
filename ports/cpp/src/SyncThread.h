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
 * Writes the waiting rows and syncs the file to the disk, four times a second. So a loss of power costs no more than that
 * time. It holds no lock while it waits for a sync. It also notices if the file was deleted. At the end, it closes the file.
 */
class SyncThread : public std::enable_shared_from_this<SyncThread> {
public:
    SyncThread(LogFile& file, RowSink& sink, Faults& faults, bool isSyncing, std::function<void()> flush);

    /** Whether to sync rows to the disk; the rest is always done. */
    std::atomic<bool> isSyncing;

    /**
     * Starts the thread, which keeps the owner of everything it uses alive. Returns false if the system has no thread for it.
     */
    bool Start(std::shared_ptr<void> owner);
    /** Ends the thread soon, without waiting for it. */
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

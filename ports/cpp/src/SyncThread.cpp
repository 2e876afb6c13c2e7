#include "SyncThread.h"

#include <chrono>
#include <string>
#include <thread>
#include <utility>

#include "Guarded.h"

namespace badlog {
namespace {

constexpr auto INTERVAL = std::chrono::milliseconds{250};

}  // namespace

SyncThread::SyncThread(LogFile& file, RowSink& sink, Faults& faults, bool syncs, std::function<void()> flush)
    : isSyncing{syncs}, m_file{file}, m_sink{sink}, m_faults{faults}, m_flush{std::move(flush)} {}

bool SyncThread::Start(std::shared_ptr<void> owner) {
    bool isStarted = false;
    Guarded(
        [&] {
            std::thread{[self = shared_from_this(), kept = std::move(owner)] { self->Run(); }}.detach();
            isStarted = true;
        },
        [](std::string_view) {});
    return isStarted;
}

void SyncThread::Finish() {
    const std::lock_guard lock{m_mutex};
    m_isFinished = true;
    m_changed.notify_all();
}

void SyncThread::Run() {
    if (isSyncing) m_file.SyncFolder();
    Sync();
    LookForFile();
    while (Pause()) {
        m_flush();
        Sync();
        LookForFile();
    }
    Sync();
    CloseFile(m_file, m_faults);
}

bool SyncThread::Pause() {
    std::unique_lock lock{m_mutex};
    return !m_changed.wait_for(lock, INTERVAL, [&] { return m_isFinished; });
}

void SyncThread::Sync() {
    if (!isSyncing || !m_sink.isDirty) return;
    // Before the sync, so that rows written meanwhile are not missed.
    m_sink.isDirty = false;
    const auto failure = m_file.Sync();
    if (!failure) return;
    m_faults.counters.failedSyncs++;
    m_faults.ReportOnce(
        "sync", "The log " + m_file.Path() + " could not be synced to the disk: " + failure.message() +
                    ". A power cut may cost more than the last quarter of a second.");
}

/** Checks twice before a file counts as missing, because it may be in the middle of being renamed. */
void SyncThread::LookForFile() {
    m_timesMissing = m_file.Exists() ? 0 : m_timesMissing + 1;
    const bool isMissing = m_timesMissing > 1;
    if (isMissing) {
        m_faults.ReportOnce(
            "missing", "The log " + m_file.Path() +
                           " was deleted, or its disk was removed, while it was being written. From now on, data is lost; "
                           "restart the robot program to start a new log.");
    }
    // Reported before the state changes, so that code that sees the log fail can read why.
    m_file.isMissing = isMissing;
}

void CloseFile(LogFile& file, Faults& faults) {
    if (const auto failure = file.Close()) {
        faults.ReportOnce(
            "close", "The log " + file.Path() + " could not be closed: " + failure.message() + ". Its end may be missing.");
    }
}

}  // namespace badlog

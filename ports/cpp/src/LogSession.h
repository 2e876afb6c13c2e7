#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "Faults.h"
#include "LogFile.h"
#include "Namespace.h"
#include "NumberText.h"
#include "RowSink.h"
#include "SyncThread.h"
#include "Topics.h"
#include "badlog/BadLog.h"

namespace badlog {

/**
 * One log from its setup to its end.
 *
 * There are two kinds of locks, so that no thread waits unnecessarily: one is held while a row is built and written, and
 * each SubscribedTopic has its own for its published values. None is held while suppliers are called.
 */
class LogSession : public std::enable_shared_from_this<LogSession> {
public:
    explicit LogSession(LogOptions options) : m_flushesEachRow{options.flushesEachRow}, m_isSyncing{options.isSyncing} {}

    Faults faults;
    NumberText text{faults};

    /** Creates the file; a failure is reported once. */
    void Open(std::string_view path);

    /** Adds a topic. If that is impossible, reports it and returns false. */
    bool Add(std::shared_ptr<Topic> topic);
    bool AddValue(std::string_view name, std::string_view value);
    bool FinishSetup();

    void Update();
    void Log();
    void Flush();
    /** Returns the topic to publish to, or null if the call is to be ignored. */
    SubscribedTopic* Publishing(std::string_view name);
    void SetSyncing(bool isSyncing);
    void Close();

    LogState State() const;

private:
    bool IsSettingUp(std::string_view name);
    void PrepareRows();
    void WriteRow();
    void FlushWaiting();
    void Ignored(const char* call);

    const bool m_flushesEachRow;
    // Recursive, because the program's own formatter is called while it is held, and may call this again.
    mutable std::recursive_mutex m_mutex;
    Namespace m_namespace;
    std::vector<Topic*> m_topics;
    /** By name. Not changed after the setup, so that publishing needs no lock. */
    std::vector<std::pair<std::string_view, SubscribedTopic*>> m_subscribers;
    std::unique_ptr<LogFile> m_file;
    std::unique_ptr<RowSink> m_sink;
    std::shared_ptr<SyncThread> m_syncThread;
    std::atomic<LogState> m_phase{LogState::SETTING_UP};
    std::atomic<bool> m_isSampling{false};
    bool m_isSyncing;
    /** Whether a row is being built: a caller that then holds the lock is the program's own formatter. */
    bool m_isInRow = false;
    bool m_closesAfterRow = false;
};

}  // namespace badlog

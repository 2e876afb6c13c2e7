#include "LogSession.h"

#include <algorithm>
#include <chrono>

#include "Guarded.h"
#include "NumberFormat.h"
#include "OpenFailure.h"
#include "StandardError.h"

namespace badlog {
namespace {

// Room for the rows of a quarter of a second, and one more.
constexpr size_t ROWS_ROOM = 8 * 1024;

}  // namespace

void LogSession::Open(std::string_view path) {
    auto file = std::make_unique<LogFile>(std::string{path});
    const std::lock_guard lock{m_mutex};
    if (!file->IsOpen()) {
        return faults.ReportOnce("open", OpenFailureText(file->Path(), file->Failure()));
    }
    m_file = std::move(file);
    m_sink = std::make_unique<RowSink>(*m_file, m_flushesEachRow, faults);
}

bool LogSession::Add(std::shared_ptr<Topic> topic) {
    const std::lock_guard lock{m_mutex};
    return IsSettingUp(topic->Name()) && m_namespace.Add(std::move(topic));
}

bool LogSession::AddValue(std::string_view name, std::string_view value) {
    const std::lock_guard lock{m_mutex};
    return IsSettingUp(name) && m_namespace.AddValue(name, value);
}

bool LogSession::FinishSetup() {
    const std::lock_guard lock{m_mutex};
    if (m_phase != LogState::SETTING_UP) {
        PrintOnStandardError("The log was set up already: call FinishInitialization() only once.");
        return false;
    }
    EventTexts* subscribed = nullptr;
    EventTexts* room = nullptr;
    std::vector<EventTexts*> events;
    for (const auto& topic : m_namespace.Topics()) {
        m_topics.push_back(topic.get());
        auto* const subscriber = dynamic_cast<SubscribedTopic*>(topic.get());
        if (subscriber != nullptr) m_subscribers.emplace_back(topic->Name(), subscriber);
        auto* const texts = topic->Texts();
        if (texts == nullptr) continue;
        events.push_back(texts);
        auto*& first = subscriber != nullptr ? subscribed : room;
        if (first == nullptr) first = texts;
    }
    std::sort(m_subscribers.begin(), m_subscribers.end());
    faults.room = room != nullptr ? room : subscribed;
    PrepareRows();
    if (m_sink) m_sink->Begin(m_namespace.HeaderLines(), std::move(events));
    m_phase = LogState::LOGGING;
    if (!m_sink) return true;
    m_syncThread = std::make_shared<SyncThread>(*m_file, *m_sink, faults, m_isSyncing, [this] { FlushWaiting(); });
    if (!m_syncThread->Start(shared_from_this())) {
        faults.ReportOnce("thread", "The system has no thread to sync the log with. A power cut may cost its last half minute.");
        m_syncThread.reset();
    }
    return true;
}

void LogSession::PrepareRows() {
    if (!m_sink) return;
    size_t room = ROWS_ROOM;
    for (auto* topic : m_topics) room += TEXT_ROOM + (topic->Texts() != nullptr ? EventTexts::MAX_BYTES * 2 : 0);
    m_sink->row.Reserve(room);
    // Creates the tables for writing numbers.
    char number[MAX_NUMBER_LENGTH];
    WriteFiveDigits(1e100, number);
}

void LogSession::Update() {
    if (m_phase != LogState::LOGGING) return Ignored("UpdateTopics()");
    // The suppliers' code may take locks of its own, or call this again. For a second thread, the first one already does the
    // work.
    if (m_isSampling.exchange(true)) return;
    for (auto* topic : m_topics) topic->Sample();
    {
        const std::lock_guard lock{m_mutex};
        if (m_isInRow) {
            Ignored("UpdateTopics()");
        } else {
            text.Commit();
            for (auto* topic : m_topics) topic->Commit();
        }
    }
    m_isSampling = false;
}

void LogSession::Log() {
    const std::lock_guard lock{m_mutex};
    if (m_phase != LogState::LOGGING || m_isInRow) return Ignored("Log()");
    if (m_sink) {
        WriteRow();
    } else {
        faults.counters.rowsMissed++;
    }
    if (m_closesAfterRow) Close();
}

void LogSession::WriteRow() {
    const auto began = std::chrono::steady_clock::now();
    if (m_sink->IsRefusing(began)) return m_sink->MissRow();
    m_isInRow = true;
    for (auto* topic : m_topics) topic->Write(m_sink->row);
    m_isInRow = false;
    m_sink->EndRow(began);
}

void LogSession::Flush() {
    const std::lock_guard lock{m_mutex};
    if (m_phase == LogState::LOGGING && m_sink && !m_isInRow) m_sink->Flush();
}

void LogSession::FlushWaiting() {
    const std::lock_guard lock{m_mutex};
    if (m_phase == LogState::LOGGING) m_sink->FlushWaiting();
}

SubscribedTopic* LogSession::Publishing(std::string_view name) {
    SubscribedTopic* topic = nullptr;
    if (m_phase == LogState::SETTING_UP) {
        // Kept for the first row.
        const std::lock_guard lock{m_mutex};
        topic = m_namespace.Subscriber(name);
    } else {
        const auto found = std::lower_bound(
            m_subscribers.begin(), m_subscribers.end(), name, [](const auto& entry, auto wanted) { return entry.first < wanted; });
        if (found != m_subscribers.end() && found->first == name) topic = found->second;
    }
    if (topic == nullptr) faults.PublishIgnored(name);
    return topic;
}

void LogSession::SetSyncing(bool isSyncing) {
    const std::lock_guard lock{m_mutex};
    m_isSyncing = isSyncing;
    if (m_syncThread) m_syncThread->isSyncing = isSyncing;
}

void LogSession::Close() {
    const std::lock_guard lock{m_mutex};
    if (m_phase == LogState::CLOSED) return;
    if (m_isInRow) {
        m_closesAfterRow = true;
        return;
    }
    m_phase = LogState::CLOSED;
    if (m_sink) m_sink->Finish();
    if (m_syncThread) {
        m_syncThread->Finish();
        m_syncThread.reset();
    } else if (m_file) {
        CloseFile(*m_file, faults);
    }
}

LogState LogSession::State() const {
    const auto phase = m_phase.load();
    if (phase != LogState::LOGGING) return phase;
    return m_sink && !m_sink->isFailing && !m_file->isMissing ? phase : LogState::FAILING;
}

bool LogSession::IsSettingUp(std::string_view name) {
    if (m_phase == LogState::SETTING_UP) return true;
    PrintOnStandardError(
        "\"" + std::string{name} + "\" was created too late: create all topics and values before FinishInitialization().");
    return false;
}

void LogSession::Ignored(const char* call) {
    const std::string_view why = m_phase == LogState::CLOSED       ? "is ignored, because the log was closed."
                                 : m_phase == LogState::SETTING_UP ? "is ignored until FinishInitialization() is called."
                                                                   : "is ignored while a row is being written; do not call it from "
                                                                     "the function given to SetDoubleToStringFunction().";
    faults.CallIgnored(call, why);
}

}  // namespace badlog

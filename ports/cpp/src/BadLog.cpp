#include "badlog/BadLog.h"

#include <mutex>
#include <utility>

#include "Guarded.h"
#include "LogSession.h"
#include "StandardError.h"
#include "SystemFile.h"
#include "SystemPath.h"
#include "Topics.h"
#include "Utf8.h"

namespace badlog {
namespace {

/** The log in which topics are created; closed at the end of the program. */
struct CurrentLog {
    std::mutex mutex;
    std::shared_ptr<LogSession> session;

    ~CurrentLog() {
        if (session) session->Close();
    }
};

CurrentLog& Current() {
    static CurrentLog current;
    return current;
}

std::shared_ptr<LogSession> CurrentSession() {
    auto& current = Current();
    const std::lock_guard lock{current.mutex};
    return current.session;
}

/** Makes a session the log in which topics are created. Returns the previous one. */
std::shared_ptr<LogSession> Exchange(std::shared_ptr<LogSession> session) {
    auto& current = Current();
    const std::lock_guard lock{current.mutex};
    return std::exchange(current.session, std::move(session));
}

void ReportFailure(std::string_view failure) {
    PrintOnStandardError(failure);
}

/** Returns the session to which a name is added. If there is none, reports that and returns null. */
std::shared_ptr<LogSession> SettingUp(std::string_view name) {
    auto session = CurrentSession();
    if (!session) PrintOnStandardError("\"" + std::string{name} + "\" was created too early: call BadLog::Init(path) first.");
    return session;
}

TopicDescription Described(std::string_view name, std::string_view unit, BadLog::Attributes attributes) {
    return {std::string{name}, std::string{unit}, {attributes.begin(), attributes.end()}};
}

/** Creates a topic that calls a supplier; `more` are the other arguments of its constructor. */
template <typename Queried, typename Supplier, typename... More>
bool CreateQueried(TopicDescription description, Supplier supplier, const std::shared_ptr<LogSession>& session, More&... more) {
    if (!session) return false;
    if (!supplier) {
        PrintOnStandardError("The topic \"" + description.name + "\" was created without a supplier, and left out.");
        return false;
    }
    return session->Add(std::make_shared<Queried>(std::move(description), session->faults, std::move(supplier), more...));
}

std::shared_ptr<SubscribedTopic> CreateSubscribed(TopicDescription description, DataInferMode mode) {
    const auto session = SettingUp(description.name);
    if (!session) return nullptr;
    auto topic = std::make_shared<SubscribedTopic>(
        std::move(description), mode, session->text, session->faults.counters.eventsDropped);
    if (!session->Add(topic)) return nullptr;
    // A publisher may outlive the log.
    return {topic.get(), [topic, session](SubscribedTopic*) {}};
}

/** Returns the result of an action. If it fails, reports that and returns nothing. */
template <typename Action>
auto Result(Action action) noexcept {
    decltype(action()) result{};
    Guarded([&] { result = action(); }, ReportFailure);
    return result;
}

}  // namespace

void Publisher::Publish(double value) const noexcept {
    if (m_topic) m_topic->Publish(value);
}

void Publisher::Publish(std::string_view value) const noexcept {
    if (m_topic) m_topic->Publish(value);
}

void Events::Event(std::string_view text) const noexcept {
    if (!m_topic) return;
    if (!IsBlank(text)) return m_topic->Texts()->Add(text);
    Guarded(
        [&] { m_session->faults.CallIgnored("The event log \"" + m_topic->Name() + "\"", "was given an event without a text."); },
        ReportFailure);
}

BadLog BadLog::Init(std::string_view path, LogOptions options) noexcept {
    auto session = std::make_shared<LogSession>(options);
    const auto before = Exchange(session);
    if (before && before->State() != LogState::CLOSED) {
        PrintOnStandardError("A new log was started while another was open; the other one was closed.");
        before->Close();
    }
    Guarded([&] { session->Open(path); }, ReportFailure);
    return BadLog{std::move(session)};
}

std::string BadLog::FreePath(std::string_view path) {
    const auto wanted = SystemPath(path);
    auto free = wanted;
    for (int number = 2; Exists(free); number++) {
        auto name = wanted.stem();
        name += "_" + std::to_string(number);
        name += wanted.extension();
        free = wanted;
        free.replace_filename(name);
    }
    return TextOf(free);
}

bool BadLog::CreateTopic(std::string_view name, std::string_view unit, NumberSupplier supplier, Attributes attributes) noexcept {
    return Result([&] {
        const auto session = SettingUp(name);
        return session && CreateQueried<NumberTopic>(Described(name, unit, attributes), std::move(supplier), session, session->text);
    });
}

bool BadLog::CreateTopicStr(std::string_view name, std::string_view unit, TextSupplier supplier, Attributes attributes) noexcept {
    return Result([&] { return CreateQueried<TextTopic>(Described(name, unit, attributes), std::move(supplier), SettingUp(name)); });
}

bool BadLog::CreateTopicBoolean(
    std::string_view name, std::string_view unit, std::function<bool()> supplier, Attributes attributes) noexcept {
    return Result([&] { return CreateQueried<BooleanTopic>(Described(name, unit, attributes), std::move(supplier), SettingUp(name)); });
}

bool BadLog::CreateTopicLong(
    std::string_view name, std::string_view unit, std::function<int64_t()> supplier, Attributes attributes) noexcept {
    return Result([&] { return CreateQueried<LongTopic>(Described(name, unit, attributes), std::move(supplier), SettingUp(name)); });
}

bool BadLog::CreateTopicSubscriber(
    std::string_view name, std::string_view unit, DataInferMode mode, Attributes attributes) noexcept {
    return Result([&] { return CreateSubscribed(Described(name, unit, attributes), mode) != nullptr; });
}

Publisher BadLog::CreatePublisher(std::string_view name, std::string_view unit, DataInferMode mode, Attributes attributes) noexcept {
    return Result([&] { return Publisher{CreateSubscribed(Described(name, unit, attributes), mode)}; });
}

Events BadLog::CreateEvents(std::string_view name) noexcept {
    return Result([&] {
        const auto session = SettingUp(name);
        if (!session) return Events{};
        const auto topic = std::make_shared<EventTopic>(std::string{name}, session->faults.counters.eventsDropped);
        return session->Add(topic) ? Events{session, topic} : Events{};
    });
}

bool BadLog::CreateValue(std::string_view name, std::string_view value) noexcept {
    return Result([&] {
        const auto session = SettingUp(name);
        return session && session->AddValue(name, value);
    });
}

void BadLog::Publish(std::string_view name, double value) noexcept {
    const auto session = CurrentSession();
    auto* const topic = session ? session->Publishing(name) : nullptr;
    if (topic != nullptr) topic->Publish(value);
}

void BadLog::Publish(std::string_view name, std::string_view value) noexcept {
    const auto session = CurrentSession();
    auto* const topic = session ? session->Publishing(name) : nullptr;
    if (topic != nullptr) topic->Publish(value);
}

bool BadLog::FinishInitialization() const noexcept {
    return Result([&] { return m_session->FinishSetup(); });
}

void BadLog::UpdateTopics() const noexcept {
    m_session->Update();
}

void BadLog::Log() const noexcept {
    m_session->Log();
}

void BadLog::Flush() const noexcept {
    m_session->Flush();
}

void BadLog::SetDoubleToStringFunction(DoubleToString function) const noexcept {
    Guarded([&] { m_session->text.Set(std::move(function)); }, ReportFailure);
}

void BadLog::SetSyncing(bool isSyncing) const noexcept {
    m_session->SetSyncing(isSyncing);
}

LogState BadLog::State() const noexcept {
    return m_session->State();
}

LogCounters BadLog::Counters() const noexcept {
    return m_session->faults.counters.Snapshot();
}

void BadLog::Close() const noexcept {
    m_session->Close();
}

}  // namespace badlog

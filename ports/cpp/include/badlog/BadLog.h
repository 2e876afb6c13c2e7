#pragma once

#include <cstdint>
#include <functional>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace badlog {

class EventTopic;
class LogSession;
class SubscribedTopic;

/** What a subscriber's cell holds when nothing was published since the update before. */
enum class DataInferMode {
    /** BadLog::DEFAULT_DATA. */
    DEFAULT,
    /** What was published last. */
    LAST,
};

/** What a BadLog is doing. */
enum class LogState {
    /** Topics and values can be created; nothing is logged yet. */
    SETTING_UP,
    /** Rows are being written. */
    LOGGING,
    /** Rows cannot be written at the moment, or end up in a file that was deleted; they are lost, and counted. */
    FAILING,
    /** It was closed; calls are ignored. */
    CLOSED,
};

/** What a log has been through since BadLog::Init, at one moment. */
struct LogCounters {
    /** Rows that were handed to the operating system, and not into a file known to be deleted. */
    int64_t rowsWritten = 0;
    /** Rows that were lost because they could not be written, or because the file is known to be deleted. */
    int64_t rowsMissed = 0;
    /** How long the file is, in bytes. */
    int64_t bytesWritten = 0;
    /** The longest that one call of BadLog::Log took, in nanoseconds. */
    int64_t slowestRowNanos = 0;
    /** Writes that took more than 5 ms, also those that failed. */
    int64_t slowWrites = 0;
    /** Times that the operating system could not bring the file to the disk. */
    int64_t failedSyncs = 0;
    /** Cells left empty because a supplier threw or gave nothing. */
    int64_t cellsMissed = 0;
    /** Calls that could not be followed, such as publishing to a name that was never created. */
    int64_t callsIgnored = 0;
    /** Events that no row took: they came faster than rows, or the log ended before one could be written. */
    int64_t eventsDropped = 0;
};

/** How a log is written. */
struct LogOptions {
    /** True to write each row at once; false to write about a quarter of a second together. */
    bool flushesEachRow = true;
    /**
     * Whether rows are brought to the disk four times a second, by another thread. Without it, a cut of power may cost half a
     * minute instead of a quarter of a second.
     */
    bool isSyncing = true;
};

/** Publishes to one subscriber topic, without looking its name up. Never waits for a file; any thread may use it. */
class Publisher {
public:
    /** Publishes to nothing. */
    Publisher() = default;

    /** Makes value what the next BadLog::UpdateTopics finds; the last one published counts. */
    void Publish(double value) const noexcept;
    void Publish(std::string_view value) const noexcept;

private:
    friend class BadLog;
    explicit Publisher(std::shared_ptr<SubscribedTopic> topic) : m_topic{std::move(topic)} {}

    std::shared_ptr<SubscribedTopic> m_topic;
};

/** An event log, created by BadLog::CreateEvents. Any thread may use it. */
class Events {
public:
    /** Takes no event. */
    Events() = default;

    /**
     * Logs that something happened. It stands in the next row; several events of one row stand in it together, in order, with
     * `; ` between them. Texts without anything in them are ignored.
     */
    void Event(std::string_view text) const noexcept;

private:
    friend class BadLog;
    Events(std::shared_ptr<LogSession> session, std::shared_ptr<EventTopic> topic)
        : m_session{std::move(session)}, m_topic{std::move(topic)} {}

    std::shared_ptr<LogSession> m_session;
    std::shared_ptr<EventTopic> m_topic;
};

/**
 * Logs what a robot does into a bag. There is one log at a time: Init starts it, topics and values are created by static
 * functions, FinishInitialization writes the header, and then each loop calls UpdateTopics and Log.
 *
 * No function throws. A mistake while a log is set up is said on standard error, and false is returned; what fails in the loop
 * leaves a gap or is ignored, is counted (see Counters), said once and noted in the log's first event log, if it has one.
 * After FinishInitialization nothing is allocated, but for the first message of each kind and for texts longer than 256 bytes.
 *
 * All functions may be called by any thread. Suppliers are called by the thread that calls UpdateTopics. Copies of a BadLog are
 * the same log. Texts are UTF-8; any byte that is not becomes U+FFFD.
 */
class BadLog {
public:
    using Attributes = std::initializer_list<std::string_view>;
    using NumberSupplier = std::function<std::optional<double>()>;
    using TextSupplier = std::function<std::optional<std::string>()>;
    using DoubleToString = std::function<std::string(double)>;

    /** The unit of data without a unit. */
    static constexpr std::string_view UNITLESS = "ul";
    /** What stands in a subscriber's cell when there is nothing to put there. */
    static constexpr std::string_view DEFAULT_DATA = "-1.0";

    /**
     * Starts a log. Missing folders are created, a file of that name is replaced. If there is a log already, it is closed first.
     * When the file cannot be created, that is said on standard error and nothing is logged.
     *
     * @param path where to write, such as `/home/lvuser/logs/match.bag`
     */
    static BadLog Init(std::string_view path, LogOptions options = {}) noexcept;

    /** A path that no file has: this one, or one with a number before its ending, such as `robot_2.bag`. */
    static std::string FreePath(std::string_view path);

    /**
     * Creates a topic of numbers; false if the name is taken, the supplier is empty, or it is too early or too late.
     *
     * @param name letters, digits, spaces, `_` and `/`, which makes folders
     * @param unit such as `V`, or UNITLESS
     * @param supplier asked in each UpdateTopics, for a number or for nothing, which leaves the cell empty
     * @param attributes how it is to be shown, such as `hide` or `join:Drivetrain`
     */
    static bool CreateTopic(std::string_view name, std::string_view unit, NumberSupplier supplier, Attributes attributes = {}) noexcept;

    /** Creates a topic of texts, as CreateTopic does. */
    static bool CreateTopicStr(std::string_view name, std::string_view unit, TextSupplier supplier, Attributes attributes = {}) noexcept;

    /** Creates a topic that is true or false, as CreateTopic does. */
    static bool CreateTopicBoolean(
        std::string_view name, std::string_view unit, std::function<bool()> supplier, Attributes attributes = {}) noexcept;

    /** Creates a topic of whole numbers, written with all their digits, as CreateTopic does. */
    static bool CreateTopicLong(
        std::string_view name, std::string_view unit, std::function<int64_t()> supplier, Attributes attributes = {}) noexcept;

    /** Creates a topic whose values are published. The mode says what it holds when nothing was. Otherwise as CreateTopic. */
    static bool CreateTopicSubscriber(
        std::string_view name, std::string_view unit, DataInferMode mode, Attributes attributes = {}) noexcept;

    /** Creates a topic as CreateTopicSubscriber does, and returns the quicker way to publish to it. */
    static Publisher CreatePublisher(
        std::string_view name, std::string_view unit, DataInferMode mode, Attributes attributes = {}) noexcept;

    /** Creates an event log, a topic with the attribute `log`. */
    static Events CreateEvents(std::string_view name) noexcept;

    /** Creates a value: a text known now, such as the match's number. False as CreateTopic. */
    static bool CreateValue(std::string_view name, std::string_view value) noexcept;

    /** Publishes to a subscriber topic. */
    static void Publish(std::string_view name, double value) noexcept;
    static void Publish(std::string_view name, std::string_view value) noexcept;

    /** Ends the set-up: writes the header. False if that was done before. */
    bool FinishInitialization() const noexcept;

    /** Asks all suppliers, and takes what was published. The values are those of all rows until the next call. */
    void UpdateTopics() const noexcept;

    /** Writes a row with the values of the last UpdateTopics. */
    void Log() const noexcept;

    /** Writes the rows that still wait, if the log was started without writing each row at once. */
    void Flush() const noexcept;

    /**
     * Sets how numbers become text, for all topics, also those created before; an empty function for `%.5g` again. It is called
     * while a row is put together, under the log's lock: it must be quick, and must not wait for other threads.
     */
    void SetDoubleToStringFunction(DoubleToString function) const noexcept;

    /** Switches LogOptions::isSyncing. */
    void SetSyncing(bool isSyncing) const noexcept;

    /** What it is doing. */
    LogState State() const noexcept;

    /** What it has been through so far. */
    LogCounters Counters() const noexcept;

    /** Writes what still waits, and closes the file. Calls that follow are ignored. Done at the end of the program, too. */
    void Close() const noexcept;

private:
    explicit BadLog(std::shared_ptr<LogSession> session) : m_session{std::move(session)} {}

    std::shared_ptr<LogSession> m_session;
};

}  // namespace badlog

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

/** The content of a subscriber topic's cell if nothing was published since the last UpdateTopics. */
enum class DataInferMode {
    /** The default, BadLog::DEFAULT_DATA. */
    DEFAULT,
    /** The last published value; the default until there is one. */
    LAST,
};

/** The states of a BadLog. */
enum class LogState {
    /** Topics and values can be created; nothing is logged yet. */
    SETTING_UP,
    /** Rows are being written. */
    LOGGING,
    /** Rows cannot currently be written, or go to a file that was deleted; they are lost and counted. */
    FAILING,
    /** The log was closed; calls are ignored. */
    CLOSED,
};

/** The numbers of rows, cells and calls that a log has written, lost or ignored since BadLog::Init, at one moment. */
struct LogCounters {
    /** Rows that were passed to the operating system, except those written to a file known to be deleted. */
    int64_t rowsWritten = 0;
    /** Rows that were lost because they could not be written, or because the file was deleted. */
    int64_t rowsMissed = 0;
    /** The length of the file in bytes. */
    int64_t bytesWritten = 0;
    /** The longest time that one call of BadLog::Log took, in nanoseconds. */
    int64_t slowestRowNanos = 0;
    /** Writes that took more than 5 ms, including failed ones. */
    int64_t slowWrites = 0;
    /** How often the operating system could not sync the file to the disk. */
    int64_t failedSyncs = 0;
    /** Cells left empty because a supplier threw or returned nothing. */
    int64_t cellsMissed = 0;
    /** Calls that were ignored, such as publishing to a name that was never created. */
    int64_t callsIgnored = 0;
    /** Events that are in no row: they came faster than rows, or the log ended before one could be written. */
    int64_t eventsDropped = 0;
};

/** Options for writing a log. */
struct LogOptions {
    /** True to write each row at once; false to write the rows of about a quarter of a second together. */
    bool flushesEachRow = true;
    /**
     * Whether another thread syncs rows to the disk four times a second. Without it, a loss of power may cost half a minute of
     * data instead of a quarter of a second.
     */
    bool isSyncing = true;
};

/** Publishes to one subscriber topic without looking up its name. Never waits for a file. Thread-safe. */
class Publisher {
public:
    /** Publishes to nothing. */
    Publisher() = default;

    /** Publishes value for the next BadLog::UpdateTopics; the last one published counts. */
    void Publish(double value) const noexcept;
    void Publish(std::string_view value) const noexcept;

private:
    friend class BadLog;
    explicit Publisher(std::shared_ptr<SubscribedTopic> topic) : m_topic{std::move(topic)} {}

    std::shared_ptr<SubscribedTopic> m_topic;
};

/** An event log, created by BadLog::CreateEvents. Thread-safe. */
class Events {
public:
    /** Ignores all events. */
    Events() = default;

    /**
     * Logs that something happened. The event is in the next row; several events of one row are joined in order by `; `. Blank
     * texts are ignored.
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
 * Logs a robot's data into a bag. There is one log at a time: Init starts it, the static functions create topics and values,
 * FinishInitialization writes the header, and then each loop calls UpdateTopics and Log.
 *
 * No function throws. A mistake while a log is set up is reported on standard error, and false is returned. A failure in the loop
 * leaves a gap, or the call is ignored; it is counted (see Counters), reported once, and noted in the log's first event log, if
 * there is one. After FinishInitialization nothing is allocated, except for the first message of each kind and for texts longer
 * than 256 bytes.
 *
 * All functions may be called from any thread. Suppliers are called on the thread that calls UpdateTopics. Copies of a BadLog are
 * the same log. Texts are UTF-8; any byte that is not becomes U+FFFD.
 */
class BadLog {
public:
    using Attributes = std::initializer_list<std::string_view>;
    using NumberSupplier = std::function<std::optional<double>()>;
    using TextSupplier = std::function<std::optional<std::string>()>;
    using DoubleToString = std::function<std::string(double)>;

    /** The unit of data that has none. */
    static constexpr std::string_view UNITLESS = "ul";
    /** The content of a subscriber topic's cell without a value. */
    static constexpr std::string_view DEFAULT_DATA = "-1.0";

    /**
     * Starts a log. Missing folders are created; an existing file of that name is replaced. If there already is a log, it is
     * closed first. If the file cannot be created, this is reported on standard error, and nothing is logged.
     *
     * @param path the path of the file, such as `/home/lvuser/logs/match.bag`; in UTF-8, even on Windows
     */
    static BadLog Init(std::string_view path, LogOptions options = {}) noexcept;

    /** Returns the path of no existing file: this path, or one with a number before its ending, such as `robot_2.bag`. */
    static std::string FreePath(std::string_view path);

    /**
     * Creates a topic of numbers. Returns false if the name is taken, the supplier is empty, or the call is too early or too late.
     *
     * @param name letters, digits, spaces, `_`, and `/` for folders
     * @param unit such as `V`, or UNITLESS
     * @param supplier called in each UpdateTopics; returns a number, or nothing, which leaves the cell empty
     * @param attributes how to show it, such as `hide` or `join:Drivetrain`
     */
    static bool CreateTopic(std::string_view name, std::string_view unit, NumberSupplier supplier, Attributes attributes = {}) noexcept;

    /** Creates a topic of texts, otherwise like CreateTopic. */
    static bool CreateTopicStr(std::string_view name, std::string_view unit, TextSupplier supplier, Attributes attributes = {}) noexcept;

    /** Creates a topic that is true or false, otherwise like CreateTopic. */
    static bool CreateTopicBoolean(
        std::string_view name, std::string_view unit, std::function<bool()> supplier, Attributes attributes = {}) noexcept;

    /** Creates a topic of whole numbers, written with all their digits; otherwise like CreateTopic. */
    static bool CreateTopicLong(
        std::string_view name, std::string_view unit, std::function<int64_t()> supplier, Attributes attributes = {}) noexcept;

    /** Creates a topic for published values. The mode decides its value if nothing was published. Otherwise like CreateTopic. */
    static bool CreateTopicSubscriber(
        std::string_view name, std::string_view unit, DataInferMode mode, Attributes attributes = {}) noexcept;

    /** Creates a topic like CreateTopicSubscriber, and returns a faster way to publish to it. */
    static Publisher CreatePublisher(
        std::string_view name, std::string_view unit, DataInferMode mode, Attributes attributes = {}) noexcept;

    /** Creates an event log: a topic with the attribute `log`. */
    static Events CreateEvents(std::string_view name) noexcept;

    /** Creates a value: a text that is already known, such as the match number. Returns false when CreateTopic would. */
    static bool CreateValue(std::string_view name, std::string_view value) noexcept;

    /** Publishes to a subscriber topic. */
    static void Publish(std::string_view name, double value) noexcept;
    static void Publish(std::string_view name, std::string_view value) noexcept;

    /** Ends the setup and writes the header. Returns false if that was done before. */
    bool FinishInitialization() const noexcept;

    /** Calls all suppliers, and takes over the published values. All rows until the next call have these values. */
    void UpdateTopics() const noexcept;

    /** Writes a row with the values from the last UpdateTopics. */
    void Log() const noexcept;

    /** Writes the rows that are still buffered, if the log was started without writing each row at once. */
    void Flush() const noexcept;

    /**
     * Sets how numbers are converted to text, for all topics, including those already created; an empty function restores
     * `%.5g`. It is called while a row is built, with the log's lock held: it must be quick, and must not wait for other threads.
     */
    void SetDoubleToStringFunction(DoubleToString function) const noexcept;

    /** Sets LogOptions::isSyncing. */
    void SetSyncing(bool isSyncing) const noexcept;

    /** Returns the current state of the log. */
    LogState State() const noexcept;

    /** Returns the numbers of rows, cells and calls that were written, lost or ignored so far. */
    LogCounters Counters() const noexcept;

    /** Writes the buffered rows, and closes the file. Later calls are ignored. Also called at the end of the program. */
    void Close() const noexcept;

private:
    explicit BadLog(std::shared_ptr<LogSession> session) : m_session{std::move(session)} {}

    std::shared_ptr<LogSession> m_session;
};

}  // namespace badlog

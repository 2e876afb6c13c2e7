#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <string_view>

#include "EventTexts.h"
#include "Faults.h"
#include "Guarded.h"
#include "HeaderText.h"
#include "NumberText.h"
#include "RowWriter.h"
#include "badlog/BadLog.h"

namespace badlog {

/** Texts up to this length need no allocation. */
constexpr size_t TEXT_ROOM = 256;

/**
 * One column. A row is made in three steps: Sample calls the robot's code, without holding any lock, because that code may
 * do anything; Commit makes all samples current at once; Write writes them. The last two run under the log's lock.
 */
class Topic {
public:
    explicit Topic(TopicDescription description)
        : m_description{std::move(description)}, m_isXAxis{m_description.Has("xaxis")} {}
    virtual ~Topic() = default;
    Topic(const Topic&) = delete;
    Topic& operator=(const Topic&) = delete;

    const TopicDescription& Description() const { return m_description; }
    const std::string& Name() const { return m_description.name; }
    /** Whether it is the x axis of all other topics, which needs more digits than they do. */
    bool IsXAxis() const { return m_isXAxis; }

    virtual void Sample() noexcept = 0;
    virtual void Commit() noexcept = 0;
    virtual void Write(RowWriter& row) noexcept = 0;

    /** The events that its cells take; null if it takes none. */
    virtual EventTexts* Texts() { return nullptr; }

    /** Whether it was reported that this topic has gaps. */
    std::atomic<bool> isFaultReported{false};

private:
    TopicDescription m_description;
    bool m_isXAxis;
};

/** A topic with values from a supplier in the robot's code. A failed call leaves a gap. */
template <typename Supplier, typename Value>
class QueriedTopic : public Topic {
public:
    QueriedTopic(TopicDescription description, Faults& faults, Supplier supplier)
        : Topic{std::move(description)}, m_faults{faults}, m_supplier{std::move(supplier)} {}

    void Sample() noexcept final {
        m_isSampleMissing = true;
        Guarded(
            [&] {
                m_isSampleMissing = !Take(m_supplier());
                if (m_isSampleMissing) m_faults.CellMissed(*this, "gave nothing");
            },
            [&](std::string_view failure) { m_faults.CellMissed(*this, "threw ", failure); });
    }

    void Commit() noexcept final {
        m_isGap = m_isSampleMissing;
        if (!m_isGap) Guarded([&] { m_current = m_sample; }, [&](std::string_view) { m_isGap = true; });
    }

    void Write(RowWriter& row) noexcept final {
        if (m_isGap) {
            row.Empty();
        } else {
            WriteValue(m_current, row);
        }
    }

protected:
    /** Writes the current value. */
    virtual void WriteValue(const Value& value, RowWriter& row) = 0;

    Value m_sample{};
    Value m_current{};

private:
    bool Take(const Value& value) {
        m_sample = value;
        return true;
    }
    bool Take(const std::optional<Value>& value) {
        if (value) m_sample = *value;
        return value.has_value();
    }

    Faults& m_faults;
    Supplier m_supplier;
    bool m_isSampleMissing = true;
    bool m_isGap = true;
};

/** A queried topic of numbers. */
class NumberTopic : public QueriedTopic<BadLog::NumberSupplier, double> {
public:
    NumberTopic(TopicDescription description, Faults& faults, BadLog::NumberSupplier supplier, NumberText& text)
        : QueriedTopic{std::move(description), faults, std::move(supplier)}, m_text{text} {}

protected:
    void WriteValue(const double& value, RowWriter& row) override { m_text.Write(value, m_text.Current(), *this, row); }

private:
    NumberText& m_text;
};

/** A queried topic of texts. */
class TextTopic : public QueriedTopic<BadLog::TextSupplier, std::string> {
public:
    TextTopic(TopicDescription description, Faults& faults, BadLog::TextSupplier supplier)
        : QueriedTopic{std::move(description), faults, std::move(supplier)} {
        m_sample.reserve(TEXT_ROOM);
        m_current.reserve(TEXT_ROOM);
    }

protected:
    void WriteValue(const std::string& value, RowWriter& row) override { row.Text(value); }
};

/** A queried topic that is true or false. */
class BooleanTopic : public QueriedTopic<std::function<bool()>, bool> {
public:
    using QueriedTopic::QueriedTopic;

protected:
    void WriteValue(const bool& value, RowWriter& row) override { row.Truth(value); }
};

/** A queried topic of whole numbers, written with all their digits. */
class LongTopic : public QueriedTopic<std::function<int64_t()>, int64_t> {
public:
    using QueriedTopic::QueriedTopic;

protected:
    void WriteValue(const int64_t& value, RowWriter& row) override { row.Integer(value); }
};

/** A topic of events: each row has all events since the previous row, however often the topics were updated. */
class EventTopic : public Topic {
public:
    EventTopic(std::string name, std::atomic<int64_t>& dropped)
        : Topic{{std::move(name), std::string{BadLog::UNITLESS}, {"log"}}}, m_texts{dropped} {}

    void Sample() noexcept override {}
    void Commit() noexcept override {}
    void Write(RowWriter& row) noexcept override;
    EventTexts* Texts() override { return &m_texts; }

private:
    EventTexts m_texts;
};

/**
 * A topic with values that the robot's code publishes, from any thread, at any time. It has its own lock, so publishers
 * never wait for a write. An event log also takes the log's own events, in rows without a new text.
 */
class SubscribedTopic : public Topic {
public:
    SubscribedTopic(TopicDescription description, DataInferMode mode, NumberText& numberText, std::atomic<int64_t>& dropped);

    void Publish(double value) noexcept;
    void Publish(std::string_view value) noexcept;

    void Sample() noexcept override {}
    void Commit() noexcept override;
    void Write(RowWriter& row) noexcept override;
    EventTexts* Texts() override { return m_isEventLog ? &m_texts : nullptr; }

private:
    struct Value {
        double number = 0;
        std::string text{BadLog::DEFAULT_DATA};
        bool isText = true;
        const NumberText::Function* function = nullptr;
    };

    const DataInferMode m_mode;
    const bool m_isEventLog;
    NumberText& m_numberText;
    EventTexts m_texts;
    std::mutex m_mutex;
    Value m_published;
    bool m_isPublished = false;
    Value m_current;
    bool m_isNew = false;
};

}  // namespace badlog

#include "Topics.h"

namespace badlog {

void EventTopic::Write(RowWriter& row) noexcept {
    const auto text = m_texts.Take();
    if (text.empty()) {
        row.Empty();
    } else {
        row.Text(text);
    }
}

SubscribedTopic::SubscribedTopic(
    TopicDescription description, DataInferMode mode, NumberText& numberText, std::atomic<int64_t>& dropped)
    : Topic{std::move(description)},
      m_mode{mode},
      m_isEventLog{Description().Has("log")},
      m_numberText{numberText},
      m_texts{dropped} {
    m_published.text.reserve(TEXT_ROOM);
    m_current.text.reserve(TEXT_ROOM);
}

void SubscribedTopic::Publish(double value) noexcept {
    const std::lock_guard lock{m_mutex};
    m_published.number = value;
    m_published.isText = false;
    m_published.function = m_numberText.Latest();
    m_isPublished = true;
}

void SubscribedTopic::Publish(std::string_view value) noexcept {
    const std::lock_guard lock{m_mutex};
    Guarded(
        [&] {
            m_published.text = value;
            m_published.isText = true;
            m_isPublished = true;
        },
        [](std::string_view) {
            // Without memory, the previously published text stays.
        });
}

void SubscribedTopic::Commit() noexcept {
    const std::lock_guard lock{m_mutex};
    m_isNew = m_isPublished;
    if (m_isPublished) {
        m_isPublished = false;
        Guarded([&] { m_current = m_published; }, [&](std::string_view) { m_isNew = false; });
    } else if (m_mode == DataInferMode::DEFAULT) {
        m_current.text = BadLog::DEFAULT_DATA;
        m_current.isText = true;
    }
}

void SubscribedTopic::Write(RowWriter& row) noexcept {
    const auto event = m_isNew ? std::string_view{} : m_texts.Take();
    if (!event.empty()) {
        row.Text(event);
    } else if (m_current.isText) {
        row.Text(m_current.text);
    } else {
        m_numberText.Write(m_current.number, m_current.function, *this, row);
    }
}

}  // namespace badlog

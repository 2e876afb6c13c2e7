#include "EventTexts.h"

#include <algorithm>
#include <array>

#include "Utf8.h"

namespace badlog {
namespace {

constexpr std::string_view SEPARATOR = "; ";
constexpr std::string_view MARK = "event ";
constexpr std::string_view DIGITS = "0123456789";

bool EqualsIgnoringCase(std::string_view text, std::string_view lowerCase) {
    return std::equal(text.begin(), text.end(), lowerCase.begin(), lowerCase.end(), [](char one, char other) {
        return (one >= 'A' && one <= 'Z' ? one - 'A' + 'a' : one) == other;
    });
}

/** Removes digits from the beginning. Returns their number. */
size_t SkipDigits(std::string_view& text) {
    const auto count = std::min(text.find_first_not_of(DIGITS), text.size());
    text.remove_prefix(count);
    return count;
}

bool SkipAny(std::string_view& text, std::string_view characters) {
    if (text.empty() || characters.find(text.front()) == std::string_view::npos) return false;
    text.remove_prefix(1);
    return true;
}

/** Returns whether Java reads a text as a decimal number, suffixes such as `1f` included. */
bool IsNumber(std::string_view text) {
    SkipAny(text, "+-");
    auto digits = SkipDigits(text);
    if (SkipAny(text, ".")) digits += SkipDigits(text);
    if (digits == 0) return false;
    if (SkipAny(text, "eE")) {
        SkipAny(text, "+-");
        if (SkipDigits(text) == 0) return false;
    }
    SkipAny(text, "fFdD");
    return text.empty();
}

bool IsReadAsEvent(std::string_view text) {
    static constexpr std::array<std::string_view, 9> NO_EVENTS = {
        "null", "true", "false", "nan", "inf", "+inf", "-inf", "infinity", "-infinity"};
    const auto word = Trimmed(text);
    if (word.empty() || IsNumber(word)) return false;
    return std::none_of(NO_EVENTS.begin(), NO_EVENTS.end(), [&](auto no) { return EqualsIgnoringCase(word, no); });
}

void AppendEvent(std::string& events, std::string_view text) {
    if (!events.empty()) events += SEPARATOR;
    events += text;
}

}  // namespace

EventTexts::EventTexts(std::atomic<int64_t>& dropped) : m_dropped{dropped} {
    for (auto* text : {&m_waiting, &m_taken, &m_cell}) text->reserve(MAX_BYTES * 2);
}

void EventTexts::Add(std::string_view text) noexcept {
    const std::lock_guard lock{m_mutex};
    if (m_waiting.size() + m_taken.size() + text.size() > MAX_BYTES) {
        m_dropped++;
        return;
    }
    AppendEvent(m_waiting, text);
    m_eventsWaiting++;
    m_isWaiting = true;
}

std::string_view EventTexts::Take() noexcept {
    if (!m_isWaiting.load(std::memory_order_acquire)) return {};
    const std::lock_guard lock{m_mutex};
    m_isWaiting = false;
    m_cell = IsReadAsEvent(m_waiting) ? std::string_view{} : MARK;
    m_cell += m_waiting;
    AppendEvent(m_taken, m_waiting);
    m_waiting.clear();
    m_eventsTaken += m_eventsWaiting;
    m_eventsWaiting = 0;
    m_isTaken = true;
    return m_cell;
}

void EventTexts::Written() noexcept {
    if (!m_isTaken.load(std::memory_order_acquire)) return;
    const std::lock_guard lock{m_mutex};
    ForgetTaken();
}

void EventTexts::Restore() noexcept {
    if (!m_isTaken.load(std::memory_order_acquire)) return;
    const std::lock_guard lock{m_mutex};
    if (!m_waiting.empty()) AppendEvent(m_taken, m_waiting);
    m_waiting = m_taken;
    m_eventsWaiting += m_eventsTaken;
    m_isWaiting = true;
    ForgetTaken();
}

void EventTexts::End() noexcept {
    const std::lock_guard lock{m_mutex};
    m_dropped += m_eventsWaiting;
    m_waiting.clear();
    m_eventsWaiting = 0;
    m_isWaiting = false;
}

void EventTexts::ForgetTaken() {
    m_taken.clear();
    m_eventsTaken = 0;
    m_isTaken = false;
}

}  // namespace badlog

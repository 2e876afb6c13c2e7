#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>

namespace badlog {

/**
 * Events that wait for a row, and events in rows that are not written yet. If writing fails, the latter wait again. Any thread
 * may add events; everything else needs the log's lock.
 */
class EventTexts {
public:
    static constexpr size_t MAX_BYTES = 10'000;

    explicit EventTexts(std::atomic<int64_t>& dropped);

    void Add(std::string_view text) noexcept;

    /**
     * Takes all waiting events, and returns them as the text of one cell; empty if none wait. The text never looks like a
     * number, and is valid until the next call.
     */
    std::string_view Take() noexcept;

    /** Forgets the events of rows that are written now. */
    void Written() noexcept;
    /** Lets the events of lost rows wait again. */
    void Restore() noexcept;
    /** Counts the events that still wait as dropped, because no row will take them. */
    void End() noexcept;

private:
    void ForgetTaken();

    std::atomic<int64_t>& m_dropped;
    std::mutex m_mutex;
    std::string m_waiting;
    std::string m_taken;
    std::string m_cell;
    int64_t m_eventsWaiting = 0;
    int64_t m_eventsTaken = 0;
    // Read without the lock in each row, so that rows without events cost nothing.
    std::atomic<bool> m_isWaiting{false};
    std::atomic<bool> m_isTaken{false};
};

}  // namespace badlog

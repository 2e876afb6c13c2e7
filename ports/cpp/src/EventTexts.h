#pragma once

#include <atomic>
#include <cstdint>
#include <mutex>
#include <string>
#include <string_view>

namespace badlog {

/**
 * Events that wait for a row, and those in rows that are not written yet: they wait again if their rows cannot be written. Any
 * thread may add events; all else is done under the log's lock.
 */
class EventTexts {
public:
    static constexpr size_t MAX_BYTES = 10'000;

    explicit EventTexts(std::atomic<int64_t>& dropped);

    void Add(std::string_view text) noexcept;

    /**
     * All that waited, as the text of one cell, which a reader never takes for a number; empty if nothing waits. Use it before
     * the next call.
     */
    std::string_view Take() noexcept;

    /** Forgets the events of rows that are written now. */
    void Written() noexcept;
    /** Lets the events of lost rows wait again. */
    void Restore() noexcept;
    /** Counts what still waits: no row will take it. */
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

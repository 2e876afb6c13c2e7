#pragma once

#include <atomic>
#include <memory>
#include <mutex>
#include <vector>

#include "Faults.h"
#include "RowWriter.h"
#include "badlog/BadLog.h"

namespace badlog {

/**
 * Converts a log's numbers to text: by `%.5g`, or by the program's own function once it is set. The function that was set when
 * a number was supplied or published converts it.
 */
class NumberText {
public:
    using Function = BadLog::DoubleToString;

    explicit NumberText(Faults& faults) : m_faults{faults} {}

    /** Sets the program's own function, for numbers from now on; an empty one for `%.5g`. */
    void Set(Function function);

    /** The program's own function, if any; it lives as long as this. */
    const Function* Latest() const { return m_function.load(std::memory_order_acquire); }

    /** The value of Latest when the current values were supplied. Guarded by the log's lock, like Commit. */
    const Function* Current() const { return m_current; }
    void Commit() { m_current = Latest(); }

    /** Writes the cell of a topic. */
    void Write(double value, const Function* function, Topic& topic, RowWriter& row);

private:
    Faults& m_faults;
    std::mutex m_mutex;
    // All functions that were ever set: a published number may still wait for an earlier one.
    std::vector<std::unique_ptr<Function>> m_functions;
    std::atomic<const Function*> m_function{nullptr};
    const Function* m_current = nullptr;
};

}  // namespace badlog

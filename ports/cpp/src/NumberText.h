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
 * How a log's numbers become text: by `%.5g`, or by the program's own function once it is set. A number keeps the function that
 * was set when it was supplied or published.
 */
class NumberText {
public:
    using Function = BadLog::DoubleToString;

    explicit NumberText(Faults& faults) : m_faults{faults} {}

    /** Sets the program's own function, for numbers from now on; an empty one for `%.5g`. */
    void Set(Function function);

    /** The program's own function, if any; it lives as long as this. */
    const Function* Latest() const { return m_function.load(std::memory_order_acquire); }

    /** What Latest was when the current values were supplied. Guarded by the log's lock, as Commit is. */
    const Function* Current() const { return m_current; }
    void Commit() { m_current = Latest(); }

    /** Writes the cell of a topic. */
    void Write(double value, const Function* function, Topic& topic, RowWriter& row);

private:
    Faults& m_faults;
    std::mutex m_mutex;
    // All that were ever set: a number that was published may wait with an earlier one.
    std::vector<std::unique_ptr<Function>> m_functions;
    std::atomic<const Function*> m_function{nullptr};
    const Function* m_current = nullptr;
};

}  // namespace badlog

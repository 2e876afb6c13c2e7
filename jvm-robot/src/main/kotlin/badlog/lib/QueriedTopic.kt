package badlog.lib

import badlog.bag.BagTopic
import badlog.bag.RowWriter

/** A topic whose value the log asks the robot's code for. A question that fails leaves a gap. */
internal abstract class QueriedTopic(description: BagTopic, private val faults: Faults) : Topic(description) {
    private var isSampleMissing = true
    private var isGap = true

    /** Asks for the value; false when there is none. */
    protected abstract fun query(): Boolean

    /** Makes the value of the last [query] the current one. */
    protected abstract fun keep()

    /** Writes the current value. */
    protected abstract fun writeValue(row: RowWriter)

    final override fun sample() {
        // Errors, too: a class that fails to load is as much a supplier's private trouble as an exception is.
        isSampleMissing = try {
            val found = query()
            if (!found) faults.cellMissed(this) { "gave null" }
            !found
        } catch (failure: Throwable) {
            faults.cellMissed(this, failure)
            true
        }
    }

    final override fun commit() {
        isGap = isSampleMissing
        if (!isGap) keep()
    }

    final override fun write(row: RowWriter) {
        if (isGap) row.empty() else writeValue(row)
    }
}

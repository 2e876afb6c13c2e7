package badlog.lib

import badlog.core.bag.RowWriter
import java.util.function.Function

/**
 * Converts a log's numbers to text: by core's formatter, or by the program's own [function] once it is set. A number is converted by the
 * function that was set when it was supplied or published.
 */
internal class NumberText(private val faults: Faults) {
    /** The program's own function for numbers from now on; null if there is none. */
    @Volatile
    var function: Function<in Double, out String?>? = null

    /** The value of [function] when the current values were supplied. Guarded by the log's lock. */
    var current: Function<in Double, out String?>? = null
        private set

    fun commit() {
        current = function
    }

    fun write(value: Double, function: Function<in Double, out String?>?, topic: Topic, row: RowWriter) {
        if (function != null) {
            writeWith(function, value, topic, row)
        } else if (topic.isXAxis) {
            row.microseconds(value)
        } else {
            row.number(value)
        }
    }

    private fun writeWith(function: Function<in Double, out String?>, value: Double, topic: Topic, row: RowWriter) {
        val text = try {
            function.apply(value)
        } catch (failure: Throwable) {
            faults.cellMissed(topic) {
                "could not be formatted: the doubleToString function threw ${describe(failure)}"
            }
            row.empty()
            return
        }
        if (text != null) {
            row.text(text)
        } else {
            faults.cellMissed(topic) { "could not be formatted: the doubleToString function gave null" }
            row.empty()
        }
    }
}

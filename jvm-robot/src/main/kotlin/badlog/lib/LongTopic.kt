package badlog.lib

import badlog.bag.RowWriter
import java.util.function.LongSupplier

/** A queried topic of whole numbers, written with all their digits. */
internal class LongTopic(
    name: String,
    unit: String,
    attributes: List<String>,
    faults: Faults,
    private val supplier: LongSupplier,
) : QueriedTopic(name, unit, attributes, faults) {
    private var sample = 0L
    private var current = 0L

    override fun query(): Boolean {
        sample = supplier.asLong
        return true
    }

    override fun keep() {
        current = sample
    }

    override fun writeValue(row: RowWriter) {
        row.integer(current)
    }
}

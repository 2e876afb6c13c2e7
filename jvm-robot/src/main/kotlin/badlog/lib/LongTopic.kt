package badlog.lib

import badlog.bag.BagTopic
import badlog.bag.RowWriter
import java.util.function.LongSupplier

/** A queried topic of whole numbers, written with all their digits. */
internal class LongTopic(description: BagTopic, faults: Faults, private val supplier: LongSupplier) : QueriedTopic(description, faults) {
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

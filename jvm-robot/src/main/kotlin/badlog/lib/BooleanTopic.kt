package badlog.lib

import badlog.bag.BagTopic
import badlog.bag.RowWriter
import java.util.function.BooleanSupplier

/** A queried topic that is true or false. */
internal class BooleanTopic(description: BagTopic, faults: Faults, private val supplier: BooleanSupplier) :
    QueriedTopic(description, faults) {
    private var sample = false
    private var current = false

    override fun query(): Boolean {
        sample = supplier.asBoolean
        return true
    }

    override fun keep() {
        current = sample
    }

    override fun writeValue(row: RowWriter) {
        row.truth(current)
    }
}

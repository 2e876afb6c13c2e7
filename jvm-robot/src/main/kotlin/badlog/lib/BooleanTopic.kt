package badlog.lib

import badlog.bag.RowWriter
import java.util.function.BooleanSupplier

/** A queried topic that is true or false. */
internal class BooleanTopic(
    name: String,
    unit: String,
    attributes: List<String>,
    faults: Faults,
    private val supplier: BooleanSupplier,
) : QueriedTopic(name, unit, attributes, faults) {
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

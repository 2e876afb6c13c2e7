package badlog.lib

import badlog.bag.BagTopic
import badlog.bag.RowWriter
import java.util.function.DoubleSupplier

/** A queried topic of numbers. */
internal class NumberTopic(description: BagTopic, faults: Faults, private val supplier: DoubleSupplier, private val text: NumberText) :
    QueriedTopic(description, faults) {
    private var sample = 0.0
    private var current = 0.0

    override fun query(): Boolean {
        sample = supplier.asDouble
        return true
    }

    override fun keep() {
        current = sample
    }

    override fun writeValue(row: RowWriter) = text.write(current, text.current, this, row)
}

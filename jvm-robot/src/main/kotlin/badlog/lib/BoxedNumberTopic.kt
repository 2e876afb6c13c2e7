package badlog.lib

import badlog.bag.BagTopic
import badlog.bag.RowWriter
import java.util.function.Supplier

/** A queried topic of numbers that come in boxes; the only garbage is the supplier's. */
internal class BoxedNumberTopic(
    description: BagTopic,
    faults: Faults,
    private val supplier: Supplier<out Double?>,
    private val text: NumberText,
) : QueriedTopic(description, faults) {
    private var sample = 0.0
    private var current = 0.0

    override fun query(): Boolean {
        sample = supplier.get() ?: return false
        return true
    }

    override fun keep() {
        current = sample
    }

    override fun writeValue(row: RowWriter) = text.write(current, text.current, this, row)
}

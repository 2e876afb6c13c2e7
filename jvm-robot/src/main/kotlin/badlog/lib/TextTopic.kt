package badlog.lib

import badlog.bag.BagTopic
import badlog.bag.RowWriter
import java.util.function.Supplier

/** A queried topic of texts. */
internal class TextTopic(description: BagTopic, faults: Faults, private val supplier: Supplier<out String?>) :
    QueriedTopic(description, faults) {
    private var sample = ""
    private var current = ""

    override fun query(): Boolean {
        sample = supplier.get() ?: return false
        return true
    }

    override fun keep() {
        current = sample
    }

    override fun writeValue(row: RowWriter) {
        row.text(current)
    }
}

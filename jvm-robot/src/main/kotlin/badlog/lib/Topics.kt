package badlog.lib

import badlog.core.bag.BagTopic
import badlog.core.bag.RowWriter
import java.util.function.BooleanSupplier
import java.util.function.DoubleSupplier
import java.util.function.LongSupplier
import java.util.function.Supplier

/**
 * One column. A row is made in three steps: [sample] calls the robot's code, without holding any lock, because that code may do anything;
 * [commit] makes all samples current at once; [write] writes them. The last two run under the log's lock.
 */
internal abstract class Topic(val description: BagTopic) {
    val name: String get() = description.name

    /** Whether it is the x axis of all other topics; an x axis needs more digits than they do. */
    val isXAxis: Boolean = "xaxis" in description.attributes

    /** Whether it was reported that this topic has gaps. Reporting it twice, when two threads race, does no harm. */
    @Volatile
    var isFaultReported: Boolean = false

    abstract fun sample()

    abstract fun commit()

    abstract fun write(row: RowWriter)
}

/** A topic with values from a supplier in the robot's code. A failing supplier leaves a gap. */
internal abstract class QueriedTopic(description: BagTopic, private val faults: Faults) : Topic(description) {
    private var isSampleMissing = true
    private var isGap = true

    /** Calls the supplier. Returns false if there is no value. */
    protected abstract fun query(): Boolean

    /** Makes the value of the last [query] the current one. */
    protected abstract fun keep()

    /** Writes the current value. */
    protected abstract fun writeValue(row: RowWriter)

    final override fun sample() {
        // Errors are caught, too: a class that fails to load is the supplier's own problem, just like an exception.
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

/** A queried topic of boxed numbers; the only garbage is the supplier's. */
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

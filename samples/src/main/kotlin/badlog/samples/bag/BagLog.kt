package badlog.samples.bag

import badlog.core.bag.BagHeader
import badlog.core.bag.BagTopic
import badlog.core.bag.BagValue
import badlog.core.bag.RowWriter
import badlog.core.recording.Value

/**
 * A bag in memory. Topics are created as in robot code: with a name, a unit, attributes and a supplier.
 *
 * @param measured returns the supplier to log for a topic of this name and unit, given the exact one.
 */
class BagLog(
    private val numberText: NumberText,
    values: List<Pair<String, String>>,
    private val measured: (name: String, unit: String, supplier: () -> Double?) -> () -> Double? = { _, _, supplier -> supplier },
) {
    private class Column(val topic: BagTopic, val writeCell: () -> Unit)

    private val values = values.map { (name, text) -> BagValue(Value(name, text)) }
    private val columns = ArrayList<Column>()
    private val writer = RowWriter()

    /** Creates a topic of numbers; a null is an empty cell. */
    fun number(name: String, unit: String, decimals: Int, vararg attributes: String, supplier: () -> Double?) {
        val sensor = measured(name, unit, supplier)
        columns += Column(BagTopic(name, unit, attributes.toList())) {
            val value = sensor()
            when {
                value == null -> writer.empty()
                numberText == NumberText.FIVE_DIGITS -> writer.number(value)
                else -> writer.text(decimalText(value, decimals))
            }
        }
    }

    fun flag(name: String, supplier: () -> Boolean) = text(name) { supplier().toString() }

    fun text(name: String, vararg attributes: String, supplier: () -> String) {
        columns += Column(BagTopic(name, attributes = attributes.toList())) { writer.text(supplier()) }
    }

    /** Writes the header; no topic can be created afterwards. */
    fun finishInitialization() {
        writer.header(BagHeader(columns.map { it.topic }, values))
    }

    /** Writes the header of a table that is not a bag: only titles. */
    fun writeTitles() {
        for (column in columns) writer.text(column.topic.name)
        writer.endRow()
    }

    fun log() {
        for (column in columns) column.writeCell()
        writer.endRow()
    }

    fun bytes(): ByteArray = writer.bytes.copyOf(writer.size)
}

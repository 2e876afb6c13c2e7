package badlog.page

import badlog.core.bag.BagHeader
import badlog.core.bag.BagTopic
import badlog.core.bag.BagValue
import badlog.core.bag.RowWriter
import badlog.core.recording.Value

/** The topic that is the x axis of a test's bag. */
internal val TIME: BagTopic = BagTopic("Time", "s", listOf("xaxis", "hide"))

/** A bag whose [topics] have, in each of [rows] rows, what [cell] gives: a number, a text, or null for nothing. */
internal fun bagOf(
    topics: List<BagTopic>,
    rows: Int,
    values: Map<String, String> = emptyMap(),
    cell: (row: Int, column: Int) -> Any?,
): ByteArray {
    val writer = RowWriter()
    writer.header(BagHeader(topics, values.map { (name, text) -> BagValue(Value(name, text)) }))
    for (row in 0 until rows) {
        for (column in topics.indices) {
            when (val content = cell(row, column)) {
                null -> writer.empty()
                is Number -> writer.number(content.toDouble())
                else -> writer.text(content.toString())
            }
        }
        writer.endRow()
    }
    return writer.bytes.copyOf(writer.size)
}

/** A bag of [graphs] topics over 10 s at 100 Hz. Each is 0 until [stepAt] seconds and 1 from then on. */
internal fun stepBag(graphs: Int, stepAt: Double = 3.0): ByteArray {
    val topics = listOf(TIME) + List(graphs) { BagTopic("Step ${it + 1}", "V") }
    return bagOf(topics, 1001) { row, column ->
        if (column == 0) {
            row / 100.0
        } else if (row / 100.0 < stepAt) {
            0
        } else {
            1
        }
    }
}

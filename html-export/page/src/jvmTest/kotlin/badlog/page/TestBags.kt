package badlog.page

import badlog.core.bag.BagHeader
import badlog.core.bag.BagTopic
import badlog.core.bag.BagValue
import badlog.core.bag.RowWriter
import badlog.core.recording.Value

/** The topic that is the x axis of a test's bag. */
internal val TIME: BagTopic = BagTopic("Time", "s", listOf("xaxis", "hide"))

/** Returns a bag with [topics] and [rows] rows. [cell] returns each cell: a number, a text, or null for nothing. */
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

/** Returns a bag of [graphs] topics over 10 s at 100 Hz. Each is 0 until [stepAt] seconds and 1 from then on. */
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

/** Returns the log of a minute in which the robot drives, and its arm draws [amps] amperes. */
internal fun matchBag(number: Int, amps: Double): ByteArray {
    val topics = listOf(TIME, BagTopic("Enabled", "ul"), BagTopic("Arm/Current", "A"))
    val values = mapOf("Match Type" to "Qualification", "Match Number" to "$number", "Start Time" to "2026-03-07T10:1$number:00")
    return bagOf(topics, rows = 600, values) { row, column ->
        when (column) {
            0 -> row / 10.0
            1 -> "${row > 20}"
            else -> amps + row % 2
        }
    }
}

/** Seven matches with the usual current of the arm, and an eighth with twice that current. */
internal val UNLIKE_MATCHES: Map<String, ByteArray> by lazy {
    (1..7).associate { "Q$it.bag" to matchBag(it, 10 + it / 10.0) } + ("Q8.bag" to matchBag(8, 21.0))
}

package badlog.season.lake

import badlog.core.analysis.LogView
import badlog.core.analysis.Units
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import badlog.core.text.freeName
import badlog.season.engine.Column
import badlog.season.engine.FlagColumn
import badlog.season.engine.MomentColumn
import badlog.season.engine.NumberColumn
import badlog.season.engine.Table
import badlog.season.engine.TextColumn
import badlog.season.engine.literalOrNull

/** The first columns of each file of samples; a topic with one of these names gets another column name. Engines ignore case. */
internal object FixedColumns {
    const val LOG = "log"
    const val TYPE = "type"
    const val NUMBER = "number"
    const val T = "t"
    const val TIMESTAMP = "timestamp"
    val ALL = setOf(LOG, TYPE, NUMBER, T, TIMESTAMP, "season", "event")
}

/** Returns the columns that are the same in each row of the log [log] with [identity]. */
internal fun constantsOf(log: String, identity: LogIdentity): List<Pair<String, String>> = listOf(
    FixedColumns.LOG to literalOrNull(log),
    FixedColumns.TYPE to literalOrNull(identity.match.type),
    FixedColumns.NUMBER to (identity.number?.toString() ?: "NULL") + "::INTEGER",
)

/**
 * The topics of [view] that share rows, as a table with a column for each topic that is not empty.
 *
 * @property nameOf the name of each topic's column.
 */
internal class SamplesTable(private val view: LogView, private val log: String, private val identity: LogIdentity) {
    private val rows = view.recording.rowCount
    val nameOf: Map<Topic, String> = columnNames()

    /** The table; null if no topics share rows. */
    val table: Table? = if (rows == 0) null else Table(columns(), rows, constantsOf(log, identity))

    private fun columnNames(): Map<Topic, String> {
        val names = LinkedHashMap<Topic, String>()
        val taken = FixedColumns.ALL.toHashSet()
        for (topic in view.recording.topics) {
            if (topic.times != null || topic.size != rows) continue
            when {
                topic === view.xAxis.topic -> names[topic] = FixedColumns.T

                // A topic that is empty in one log may have anything in another.
                topic.kind == TopicKind.EMPTY && !hasTextCells(topic) -> continue

                else -> names[topic] = freeName(topic.name.ifEmpty { "topic" }) { taken.add(it.lowercase()) }
            }
        }
        return names
    }

    private fun columns(): List<Column> {
        val x = view.xAxis
        val columns = ArrayList<Column>()
        columns += NumberColumn(FixedColumns.T, x.positions)
        if (identity.zero != null) {
            columns += MomentColumn(FixedColumns.TIMESTAMP, identity.zero, x.positions, Units.secondsIn(x.unit) ?: 1.0)
        }
        for ((topic, name) in nameOf) if (topic !== x.topic) columns += columnOf(topic, name)
        return columns
    }

    private fun columnOf(topic: Topic, name: String): Column = when {
        hasTextCells(topic) -> TextColumn(name, TextsInRows(topic)::of)
        topic.kind == TopicKind.BOOLEAN -> FlagColumn(name, topic.samples)
        else -> NumberColumn(name, topic.samples)
    }
}

/** Returns whether the cells of [topic] are texts, with numbers written as text. */
internal fun hasTextCells(topic: Topic): Boolean =
    topic.kind == TopicKind.STATE || topic.kind == TopicKind.EVENT || "log" in topic.attributes

/** The cells of [topic] as texts, requested in ascending order, possibly repeatedly from the start. */
internal class TextsInRows(private val topic: Topic) {
    private var next = 0

    /** Returns the text of cell [row]; null for an empty one. */
    fun of(row: Int): String? {
        val texts = topic.texts
        if (next > 0 && texts.rows[next - 1] >= row) next = 0
        while (next < texts.size && texts.rows[next] < row) next++
        if (next < texts.size && texts.rows[next] == row) return texts[next]
        val number = topic.samples.getOrElse(row) { Double.NaN }
        return if (number.isNaN()) null else numberText(number)
    }

    private fun numberText(number: Double) = if (number == Math.rint(number) && Math.abs(number) < MAX_WHOLE) {
        "${number.toLong()}"
    } else {
        "$number"
    }
}

private const val MAX_WHOLE = 1e15

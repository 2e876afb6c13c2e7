package badlog.season.lake

import badlog.season.engine.FieldType
import badlog.season.engine.FieldType.COUNT
import badlog.season.engine.FieldType.FLAG
import badlog.season.engine.FieldType.MOMENT
import badlog.season.engine.FieldType.NUMBER
import badlog.season.engine.FieldType.PROBLEMS
import badlog.season.engine.FieldType.SPANS
import badlog.season.engine.FieldType.TEXT
import badlog.season.engine.FieldType.TEXTS
import badlog.season.engine.FieldType.TEXT_OF_NAME
import badlog.season.engine.FieldType.WHOLE
import badlog.season.engine.RecordColumn
import badlog.season.engine.Table
import badlog.season.engine.quoted

/**
 * A table of a lake with records of many logs; `docs/season.md` explains them. [MATCHES] is written last, because badlog reads it to know
 * the content of a lake.
 *
 * @property fields the columns with their types.
 * @property order the columns by which its rows are sorted.
 */
internal enum class LakeTable(val order: String, vararg val fields: Pair<String, FieldType>) {
    /** The topics of the logs. */
    TOPICS(
        "log, topic",
        "log" to TEXT, "topic" to TEXT, "stored" to TEXT, "column_name" to TEXT, "unit" to TEXT, "attributes" to TEXTS, "kind" to TEXT,
        "type" to TEXT, "samples" to COUNT, "gaps" to COUNT, "rate" to NUMBER, "first_t" to NUMBER, "last_t" to NUMBER,
    ),

    /** The statistics of topics. */
    STATISTICS(
        "log, topic",
        "log" to TEXT, "topic" to TEXT, "unit" to TEXT, "count" to COUNT, "gaps" to COUNT, "min" to NUMBER, "max" to NUMBER,
        "mean" to NUMBER,
        "standard_deviation" to NUMBER, "p5" to NUMBER, "median" to NUMBER, "p95" to NUMBER, "first" to NUMBER, "last" to NUMBER,
    ),

    /** Texts with a time. */
    EVENTS("log, t, topic", "log" to TEXT, "topic" to TEXT, "t" to NUMBER, "timestamp" to MOMENT, "text" to TEXT),

    /** The findings of the rules. */
    FINDINGS(
        "log, t, rule",
        "log" to TEXT, "rule" to TEXT, "severity" to TEXT, "topic" to TEXT, "t" to NUMBER, "timestamp" to MOMENT, "text" to TEXT,
        "next" to TEXT, "evidence" to TEXTS, "spans" to SPANS, "span_count" to WHOLE,
    ),

    /** The logs themselves. */
    MATCHES(
        "log",
        "log" to TEXT, "title" to TEXT, "type" to TEXT, "number" to WHOLE, "alliance" to TEXT, "start" to MOMENT, "duration" to NUMBER,
        "x_name" to TEXT, "x_unit" to TEXT, "format" to TEXT, "rows" to COUNT, "samples" to COUNT, "topics" to COUNT, "events" to COUNT,
        "findings" to COUNT, "salvaged" to FLAG, "problems" to PROBLEMS, "header" to TEXT_OF_NAME, "path" to TEXT, "size" to COUNT,
        "modified" to MOMENT, "files" to TEXTS, "made_by" to TEXT,
    ),
    ;

    /** Its name, in SQL and on the disk. */
    val table: String get() = name.lowercase()

    /** The declaration of its columns in SQL. */
    val declared: String get() = fields.joinToString { (name, type) -> "${quoted(name)} ${type.type}" }

    /**
     * Returns a record of [values], one for each field, by its name.
     *
     * @throws IllegalArgumentException if one is missing, is in another order, or does not have the type of its field.
     */
    fun record(vararg values: Pair<String, Any?>): LakeRecord {
        require(values.map { it.first } == fields.map { it.first }) {
            "The fields of $table are ${fields.joinToString { it.first }}, not ${values.joinToString { it.first }}."
        }
        return LakeRecord(
            values.mapIndexed { i, (name, value) ->
                require(fields[i].second.fits(value)) { "The field $name of $table cannot hold $value." }
                value
            },
        )
    }

    /** Returns [records], each with its season and event before its own fields, as a table. */
    fun staged(records: List<PlacedRecord>): Table {
        val places = listOf(
            RecordColumn("season", WHOLE) { records[it].partition.season },
            RecordColumn("event", TEXT) { records[it].partition.event },
        )
        val own = fields.mapIndexed { i, (name, type) -> RecordColumn(name, type) { records[it].record[i] } }
        return Table(places + own, records.size)
    }
}

package badlog.season.lake

import badlog.core.analysis.LogView
import badlog.core.analysis.Units
import badlog.core.analysis.sampleRateOf
import badlog.core.analysis.statistics
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import badlog.core.text.UniqueNames
import badlog.rules.Finding
import badlog.season.engine.microsOf
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/**
 * The records of one log in the tables of a lake.
 *
 * @param log its name in the lake.
 * @param columnOf the names of topics' columns in the file of samples.
 * @param files the files of its samples, relative to the lake.
 * @param maker identifies everything that affects the records of a log.
 */
internal class LogRecords(
    private val log: String,
    private val source: LogSource,
    private val view: LogView,
    private val findings: List<Finding>,
    private val identity: LogIdentity,
    private val columnOf: Map<Topic, String>,
    private val files: List<String>,
    private val maker: String,
) {
    private val recording = view.recording
    private val secondsPerX = Units.secondsIn(view.xAxis.unit) ?: 1.0
    private val events = recording.topics.filter { holdsEvents(it) }.flatMap { topic ->
        view.eventsOf(topic).events.map {
            LakeTable.EVENTS.record("log" to log, "topic" to topic.name, "t" to it.x, "timestamp" to momentOf(it.x), "text" to it.text)
        }
    }

    /** The records of each table. */
    val all: Map<LakeTable, List<LakeRecord>> by lazy {
        mapOf(
            LakeTable.TOPICS to recording.topics.map(::topicRecord),
            LakeTable.STATISTICS to recording.topics.mapNotNull(::statisticsRecord),
            LakeTable.EVENTS to events,
            LakeTable.FINDINGS to findings.map(::findingRecord),
            LakeTable.MATCHES to listOf(matchRecord()),
        )
    }

    private fun momentOf(x: Double): Long? = identity.zero?.let { microsOf(it + x * secondsPerX) }

    /** Texts among numbers have no other place in a lake. */
    private fun holdsEvents(topic: Topic) = topic.texts.size > 0 && (topic.kind != TopicKind.STATE || "log" in topic.attributes)

    private fun topicRecord(topic: Topic): LakeRecord {
        val positions = topic.times ?: if (topic.size == recording.rowCount) view.xAxis.positions else DoubleArray(0)
        val first = positions.firstOrNull { it.isFinite() }
        val last = positions.lastOrNull { it.isFinite() }
        val column = columnOf[topic]
        val stored = when {
            column != null -> LakeLayout.SAMPLES
            topic.times != null && topic.size > 0 && files.isNotEmpty() -> LakeLayout.SERIES
            else -> null
        }
        return LakeTable.TOPICS.record(
            "log" to log,
            "topic" to topic.name,
            "stored" to stored,
            "column_name" to column,
            "unit" to unitOf(topic),
            "attributes" to textsJson(topic.attributes),
            "kind" to topic.kind.name.lowercase(),
            "type" to topic.type.ifEmpty { null },
            "samples" to topic.size.toLong(),
            "gaps" to topic.counts.empty.toLong() + topic.counts.notFinite,
            "rate" to view.sampleRateOf(topic),
            "first_t" to first,
            "last_t" to last,
        )
    }

    private fun statisticsRecord(topic: Topic): LakeRecord? {
        if (hasTextCells(topic) || topic.samples.isEmpty()) return null
        return view.seriesOf(topic).statistics().run {
            LakeTable.STATISTICS.record(
                "log" to log,
                "topic" to topic.name,
                "unit" to unitOf(topic),
                "count" to count.toLong(),
                "gaps" to gaps.toLong(),
                "min" to min,
                "max" to max,
                "mean" to mean,
                "standard_deviation" to standardDeviation,
                "p5" to percentile5,
                "median" to median,
                "p95" to percentile95,
                "first" to first,
                "last" to last,
            )
        }
    }

    private fun findingRecord(finding: Finding): LakeRecord = finding.run {
        val json = JsonArray(spans.map { JsonObject(mapOf("from" to number(it.from), "to" to number(it.to))) })
        LakeTable.FINDINGS.record(
            "log" to log,
            "rule" to rule,
            "severity" to severity.name.lowercase(),
            "topic" to topic,
            "t" to time,
            "timestamp" to momentOf(time),
            "text" to text,
            "next" to next.ifEmpty { null },
            "evidence" to textsJson(evidence),
            "spans" to "$json",
            "span_count" to spanCount,
        )
    }

    private fun matchRecord(): LakeRecord {
        val range = view.xAxis.range
        return LakeTable.MATCHES.record(
            "log" to log,
            "title" to identity.match.title,
            "type" to identity.match.type,
            "number" to identity.number,
            "alliance" to identity.match.alliance,
            "start" to identity.start?.let(::microsOf),
            "duration" to range?.let { (it.endInclusive - it.start) * secondsPerX }?.takeIf { !view.xAxis.isIndex },
            "x_name" to view.xAxis.name,
            "x_unit" to view.xAxis.unit.takeUnless(Units::isNone),
            "format" to recording.format.id,
            "rows" to recording.rowCount.toLong(),
            "samples" to recording.sampleCount,
            "topics" to recording.topics.size.toLong(),
            "events" to events.size.toLong(),
            "findings" to findings.size.toLong(),
            "salvaged" to recording.isSalvaged,
            "problems" to problemsJson(),
            "header" to headerJson(),
            "path" to source.path,
            "size" to source.size,
            "modified" to source.modified * 1000,
            "files" to textsJson(files),
            "made_by" to maker,
        )
    }

    private fun problemsJson(): String = JsonArray(
        view.problems.map {
            JsonObject(
                mapOf(
                    "severity" to JsonPrimitive(it.severity.name.lowercase()),
                    "message" to JsonPrimitive(it.message),
                    "line" to JsonPrimitive(it.line),
                    "topic" to JsonPrimitive(it.topic),
                    "count" to JsonPrimitive(it.count),
                ),
            )
        },
    ).toString()

    private fun headerJson(): String {
        val names = UniqueNames()
        return JsonObject(recording.values.associate { names.give(it.name) to JsonPrimitive(it.text) }).toString()
    }
}

/** Returns the unit of [topic]; null for none. */
internal fun unitOf(topic: Topic): String? = topic.unit.takeUnless(Units::isNone)

/** Returns [texts] as a JSON list. */
internal fun textsJson(texts: List<String>): String = JsonArray(texts.map(::JsonPrimitive)).toString()

private fun number(value: Double) = JsonPrimitive(value.takeIf { it.isFinite() })

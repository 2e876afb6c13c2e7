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
        view.eventsOf(topic).events.map { listOf(log, topic.name, it.x, momentOf(it.x), it.text) }
    }

    /** The records of each table. */
    val all: Map<LakeTable, List<List<Any?>>> by lazy {
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

    private fun topicRecord(topic: Topic): List<Any?> {
        val positions = topic.times ?: if (topic.size == recording.rowCount) view.xAxis.positions else DoubleArray(0)
        val first = positions.firstOrNull { it.isFinite() }
        val last = positions.lastOrNull { it.isFinite() }
        val column = columnOf[topic]
        val stored = when {
            column != null -> LakeLayout.SAMPLES
            topic.times != null && topic.size > 0 && files.isNotEmpty() -> LakeLayout.SERIES
            else -> null
        }
        return listOf(
            log, topic.name, stored, column, unitOf(topic), textsJson(topic.attributes), topic.kind.name.lowercase(),
            topic.type.ifEmpty { null }, topic.size.toLong(), topic.counts.empty.toLong() + topic.counts.notFinite,
            view.sampleRateOf(topic), first, last,
        )
    }

    private fun statisticsRecord(topic: Topic): List<Any?>? {
        if (isOfTexts(topic) || topic.samples.isEmpty()) return null
        return view.seriesOf(topic).statistics().run {
            listOf(
                log, topic.name, unitOf(topic), count.toLong(), gaps.toLong(), min, max, mean, standardDeviation, percentile5, median,
                percentile95, first, last,
            )
        }
    }

    private fun findingRecord(finding: Finding): List<Any?> = finding.run {
        val json = JsonArray(spans.map { JsonObject(mapOf("from" to number(it.from), "to" to number(it.to))) })
        listOf(
            log, rule, severity.name.lowercase(), topic, time, momentOf(time), text, next.ifEmpty { null }, textsJson(evidence), "$json",
            spanCount,
        )
    }

    private fun matchRecord(): List<Any?> {
        val range = view.xAxis.range
        return listOf(
            log, identity.match.title, identity.match.type, identity.number, identity.match.alliance, identity.start?.let(::microsOf),
            range?.let { (it.endInclusive - it.start) * secondsPerX }?.takeIf { !view.xAxis.isIndex }, view.xAxis.name,
            view.xAxis.unit.takeUnless(Units::isNone), recording.format.id, recording.rowCount.toLong(),
            recording.sampleCount, recording.topics.size.toLong(), events.size.toLong(), findings.size.toLong(), recording.isSalvaged,
            problemsJson(), headerJson(), source.path, source.size, source.modified * 1000,
            textsJson(files), maker,
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

package badlog.page.opened

import badlog.core.analysis.SeriesStatistics
import badlog.core.recording.Severity
import badlog.core.recording.TopicKind
import badlog.page.dom.json
import badlog.rules.number.LogNumbersReader
import badlog.rules.number.LogNumbersText
import badlog.rules.number.toText
import badlog.signals.battery.BatteryUse
import badlog.signals.battery.Resistance
import badlog.signals.match.MatchOfLog
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.FindingSummary
import badlog.viewer.catalog.FoundRule
import badlog.viewer.catalog.LogDate
import badlog.viewer.catalog.LogSummary
import badlog.viewer.catalog.PreviewLine
import badlog.viewer.catalog.ProblemCounts
import badlog.viewer.catalog.TopicSummary
import badlog.viewer.catalog.Verdict

/** A worker's result for a log as a message: the facts that lists show, as plain arrays. */
internal object SummaryMessage {
    private val reader = LogNumbersReader()

    /** Returns the result for [log] as a message; its findings are null while the rules run. */
    fun of(log: OpenedLog): dynamic = with(log) { of(summary, found, numbers.toText()) }

    private fun of(summary: LogSummary, found: FindingSummary?, numbers: LogNumbersText): dynamic = json(
        "match" to with(summary.match) { arrayOf(event, type, number, alliance) },
        "second" to summary.date.second.toDouble(),
        "source" to summary.date.source.ordinal,
        "duration" to summary.duration,
        "unit" to summary.xUnit,
        "samples" to summary.samples.toDouble(),
        "problems" to with(summary.problems) { arrayOf(errors, warnings, notes) },
        "content" to summary.content.ordinal,
        "trouble" to summary.trouble,
        "battery" to summary.battery?.let { battery ->
            with(battery) {
                arrayOf(name, topic, lowest, restBefore, restAfter, energy, resistance?.milliohms, resistance?.uncertainty, isBrownedOut)
            }
        },
        "topics" to summary.topics.map { it.name }.toTypedArray(),
        "units" to summary.topics.map { it.unit }.toTypedArray(),
        "kinds" to summary.topics.map { it.kind.ordinal }.toTypedArray(),
        "numbers" to numbersOf(summary.topics),
        // Lists draw no other topic.
        "preview" to summary.batteryTopic?.let(summary::topic)?.preview?.bytes,
        "hasRun" to (found != null),
        "found" to found?.rules?.map { arrayOf(it.name, it.severity.ordinal) }?.toTypedArray(),
        "verdict" to found?.verdict?.run { arrayOf(severity.ordinal, headline, sentences.toTypedArray(), next, errors, warnings) },
        // Browsers have stored the numbers under this name; “numbers” has the topics' numbers.
        "figures" to arrayOf(numbers.names, numbers.values),
    )

    /** Returns [log] with the result in [message]. */
    fun read(message: dynamic, log: OpenedLog): OpenedLog {
        val match = message.match.unsafeCast<Array<String?>>()
        val problems = message.problems.unsafeCast<Array<Int>>()
        val rules = message.found.unsafeCast<Array<Array<dynamic>>?>()
            ?.map { FoundRule(it[0] as String, Severity.entries[it[1] as Int]) }
        val battery = message.battery.unsafeCast<Array<dynamic>?>()?.let(::batteryIn)
        val summary = LogSummary(
            match = MatchOfLog(match[0], match[1], match[2], match[3]),
            date = LogDate((message.second as Double).toLong(), DateSource.entries[message.source as Int]),
            duration = message.duration as Double?,
            xUnit = message.unit as String,
            samples = (message.samples as Double).toLong(),
            problems = ProblemCounts(problems[0], problems[1], problems[2]),
            content = Content.entries[message.content as Int],
            trouble = message.trouble as String?,
            battery = battery,
            topics = topicsIn(message, battery?.topic),
        )
        val found = if (message.hasRun as Boolean) FindingSummary(0, rules, verdictIn(message.verdict)) else null
        val (names, values) = message.figures.unsafeCast<Array<String>>()
        return log.with(summary, found, reader.read(LogNumbersText(names, values)))
    }

    private fun verdictIn(parts: Array<dynamic>?): Verdict? = parts?.let {
        Verdict(
            Severity.entries[it[0] as Int],
            it[1] as String,
            it[2].unsafeCast<Array<String>>().toList(),
            it[3] as String,
            it[4] as Int,
            it[5] as Int,
        )
    }

    private fun numbersOf(topics: List<TopicSummary>) = DoubleArray(topics.size * NUMBERS).also { numbers ->
        topics.forEachIndexed { i, topic ->
            val spread = with(topic.statistics) { doubleArrayOf(min, max, mean, standardDeviation, percentile5, median, percentile95) }
            val others = with(topic.statistics) { doubleArrayOf(count.toDouble(), gaps.toDouble(), first, last, integral) }
            (spread + others).copyInto(numbers, i * NUMBERS)
        }
    }

    private fun topicsIn(message: dynamic, drawn: String?): List<TopicSummary> {
        val preview = message.preview.unsafeCast<ByteArray?>()?.let(::PreviewLine)
        val units = message.units.unsafeCast<Array<String>>()
        val kinds = message.kinds.unsafeCast<Array<Int>>()
        val all = message.numbers.unsafeCast<DoubleArray>()
        return message.topics.unsafeCast<Array<String>>().mapIndexed { i, name ->
            val n = all.copyOfRange(i * NUMBERS, (i + 1) * NUMBERS)
            val (min, max, mean, standardDeviation, percentile5) = n.asList()
            val statistics =
                SeriesStatistics(n[7].toInt(), n[8].toInt(), min, max, mean, standardDeviation, percentile5, n[5], n[6], n[9], n[10], n[11])
            TopicSummary(name, units[i], TopicKind.entries[kinds[i]], statistics, preview?.takeIf { name == drawn } ?: PreviewLine.NONE)
        }
    }

    private fun batteryIn(parts: Array<dynamic>): BatteryUse {
        val milliohms = parts[6] as Double?
        return BatteryUse(
            parts[0] as String?,
            parts[1] as String?,
            parts[2] as Double?,
            parts[3] as Double?,
            parts[4] as Double?,
            parts[5] as Double?,
            milliohms?.let { Resistance(it, parts[7] as Double) },
            parts[8] == true,
        )
    }

    /** The number of statistics for each topic. */
    private const val NUMBERS = 12
}

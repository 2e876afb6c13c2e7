package badlog.viewer.catalog

import badlog.core.analysis.LogView
import badlog.core.analysis.SeriesStatistics
import badlog.core.analysis.Span
import badlog.core.analysis.Units
import badlog.core.analysis.statistics
import badlog.core.recording.PathName
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.recording.Severity
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import badlog.rules.Finding
import badlog.rules.RuleSet
import badlog.rules.incident.MainFinding
import badlog.rules.incident.incidentsIn
import badlog.rules.incident.mainFinding
import badlog.rules.incident.nextOf
import badlog.signals.battery.BatteryUse
import badlog.signals.battery.batteryUseOf
import badlog.signals.match.MatchOfLog
import badlog.signals.match.matchInName
import badlog.signals.match.matchOf
import badlog.signals.vocabulary.SignalVocabulary
import badlog.viewer.text.minutesText
import badlog.viewer.text.numberText
import badlog.viewer.text.withUnit
import kotlin.math.floor

/**
 * The stored facts about a log, known without reading it again.
 *
 * @property match the match in which the log was recorded.
 * @property date the time when the log began.
 * @property duration the length of the log on x; null if x is only a row number.
 * @property xUnit the unit of [duration].
 * @property samples the number of samples of all topics together.
 * @property problems the number of problems of each severity.
 * @property content whether the log has anything to see.
 * @property trouble the reason why the log cannot be read, as a sentence; null if it can.
 * @property battery the use of the robot's battery; null if the log does not show it.
 * @property topics the topics with numbers, in the order of the file.
 */
data class LogSummary(
    val match: MatchOfLog = MatchOfLog(),
    val date: LogDate,
    val duration: Double? = null,
    val xUnit: String = "",
    val samples: Long = 0,
    val problems: ProblemCounts = ProblemCounts(),
    val content: Content = Content.UNREADABLE,
    val trouble: String? = null,
    val battery: BatteryUse? = null,
    val topics: List<TopicSummary> = emptyList(),
) {
    /** The lowest voltage of the robot's battery, in volts; null if no topic shows it. */
    val batteryMinimum: Double? get() = battery?.lowest

    /** The name of the topic with the battery's voltage; null if there is none. */
    val batteryTopic: String? get() = battery?.topic

    /** Returns the summary of the topic called [name]; null if the log does not have it. */
    fun topic(name: String): TopicSummary? = topics.firstOrNull { it.name == name }

    companion object {
        /** Returns the facts that are known from the [name] of a file alone. The file was last written at [modified], in ms since 1970. */
        fun named(name: String, modified: Long): LogSummary =
            LogSummary(matchInName(name), LogDate.of(emptyList(), name, modified), content = Content.SOMETHING)

        /**
         * Returns the facts that are known from the [name] of an unreadable file alone. The file was last written at [modified], in ms
         * since 1970, and cannot be read because of [trouble].
         */
        fun unreadable(name: String, modified: Long, trouble: String, content: Content = Content.UNREADABLE): LogSummary =
            LogSummary(matchInName(name), LogDate.of(emptyList(), name, modified), trouble = trouble, content = content)

        /**
         * Returns the summary of [view]; [vocabulary] names its topics.
         *
         * @param name the name of the log's file, which was last written at [modified], in ms since 1970.
         * @param isOnlyOfLogs whether only logs have such names.
         */
        fun of(view: LogView, vocabulary: SignalVocabulary, name: String, modified: Long, isOnlyOfLogs: Boolean): LogSummary {
            val recording = view.recording
            if (isTable(recording)) return unreadable(name, modified, "$name is a table that badlog made, not a log.", Content.NO_LOG)
            val topics = recording.topics.filter { it.samples.isNotEmpty() && !isPlumbing(it) }.map { summaryOf(it, view) }
            val axis = view.xAxis
            val time = if (axis.isIndex) timeTopic(recording) else axis.topic
            val duration = if (axis.isIndex) time?.let { finiteSpan(it.samples)?.width } else axis.range?.let { it.endInclusive - it.start }
            val xUnit = if (axis.isIndex) time?.unit.orEmpty() else axis.unit
            val trouble = recording.refusal
            return LogSummary(
                match = vocabulary.matchOf(recording, name),
                date = LogDate.of(recording.values, name, modified),
                duration = duration,
                xUnit = xUnit,
                samples = recording.sampleCount,
                problems = ProblemCounts(view.count(Severity.ERROR), view.count(Severity.WARNING), view.count(Severity.NOTE)),
                content = when {
                    trouble == null -> contentOf(view, topics, time, duration?.let { secondsOf(it, xUnit) })
                    isOnlyOfLogs -> Content.UNREADABLE
                    else -> Content.NO_LOG
                },
                trouble = trouble,
                battery = batteryUseOf(view, vocabulary),
                topics = topics,
            )
        }
    }
}

/** The number of problems of each severity in a recording, each kind counted once. */
data class ProblemCounts(val errors: Int = 0, val warnings: Int = 0, val notes: Int = 0) {
    /** Returns the number for [severity]. */
    fun of(severity: Severity): Int = when (severity) {
        Severity.ERROR -> errors
        Severity.WARNING -> warnings
        Severity.NOTE -> notes
    }
}

/**
 * The stored facts of a topic with numbers, without its samples.
 *
 * @property name the full name.
 * @property unit the unit; `ul` if there is none.
 * @property statistics the statistics over the whole recording.
 * @property preview the shape of the series.
 */
data class TopicSummary(
    val name: String,
    val unit: String,
    val kind: TopicKind,
    val statistics: SeriesStatistics,
    val preview: PreviewLine,
)

private fun summaryOf(topic: Topic, view: LogView): TopicSummary {
    val line = view.seriesOf(topic)
    val statistics = line.statistics()
    val held = if (line.holds) view.xAxis.range else null
    return TopicSummary(
        topic.name,
        topic.unit,
        topic.kind,
        statistics,
        PreviewLine.of(line.data, statistics.min, statistics.max, held),
    )
}

/**
 * Returns whether [recording] is a table of logs, saved among the logs by the window or the program. Each row of such a table is about a
 * file.
 */
private fun isTable(recording: Recording): Boolean = recording.format == RecordingFormat.CSV &&
    recording.topics.take(3).map { it.name }.let { it == listOf("Log", "Date", "File") || it.take(2) == listOf("Match", "File") }

/** Returns whether [topic] is a logger's own data, such as the time of day. */
private fun isPlumbing(topic: Topic) = topic.times != null && "hide" in topic.attributes

/** Returns the time column. A plain CSV file has no x axis, but usually a time column. */
private fun timeTopic(recording: Recording): Topic? = recording.topics.firstOrNull {
    it.samples.isNotEmpty() && PathName.baseNameOf(it.name).lowercase() in setOf("time", "timestamp", "match time")
}

/** Returns [duration] in [unit] as seconds; without a unit, it is in seconds. Null if the unit is not a unit of time. */
fun secondsOf(duration: Double, unit: String): Double? {
    // A log without units is a plain CSV file, nearly always with a time in seconds.
    val seconds = if (Units.isNone(unit)) 1.0 else Units.secondsIn(unit)
    return seconds?.let { duration * it }
}

/** Returns the range of the finite [positions]; null if there are none. */
private fun finiteSpan(positions: DoubleArray): Span? {
    var from = Double.POSITIVE_INFINITY
    var to = Double.NEGATIVE_INFINITY
    for (x in positions) {
        if (!x.isFinite()) continue
        if (x < from) from = x
        if (x > to) to = x
    }
    return if (from <= to) Span(from, to) else null
}

/**
 * The findings of the rules in a log of the folder.
 *
 * @property key identifies the rules that were run; if the rules have another key, they are run again.
 * @property rules the rules that found something, each once, the worst first; null if they could not be run.
 * @property verdict the summary to show first; null if nothing is worse than a note.
 */
data class FindingSummary(val key: Int, val rules: List<FoundRule>?, val verdict: Verdict? = null) {
    /** The worst severity; null if nothing was found. */
    val worst: Severity? get() = rules?.maxOfOrNull { it.severity }

    /** Returns the number of rules that found something of [severity]. */
    fun count(severity: Severity): Int = rules.orEmpty().count { it.severity == severity }
}

/** A rule that found something. */
data class FoundRule(val name: String, val severity: Severity)

/**
 * The rules' summary of a log, for a reader who has only a moment.
 *
 * @property severity the severity of its main finding.
 * @property headline the event and its time, without a full stop: `Browned out at 1:33`.
 * @property sentences the causes and consequences, in order; at least one sentence.
 * @property next the next thing to look at, as a sentence; empty if unknown.
 * @property errors the number of findings that are errors.
 * @property warnings the number of findings that are warnings.
 */
data class Verdict(
    val severity: Severity,
    val headline: String,
    val sentences: List<String>,
    val next: String = "",
    val errors: Int = 0,
    val warnings: Int = 0,
)

/** Returns the summary of [findings] for lists of logs. These rules found them; [key] identifies the rules. */
fun RuleSet.foundIn(findings: List<Finding>, key: Int): FindingSummary {
    val first = mainFinding(findings, incidentsIn(findings)) ?: return FindingSummary(key, emptyList())
    val listed = (listOf(first.finding) + findings).map { FoundRule(it.rule, it.severity) }
    return FindingSummary(key, listed.sortedByDescending { it.severity }.distinctBy { it.name }, verdictOf(first, findings))
}

private fun verdictOf(first: MainFinding, findings: List<Finding>): Verdict? {
    val finding = first.finding
    if (findings.all { it.severity == Severity.NOTE }) return null
    return Verdict(
        finding.severity,
        if (finding.time.isNaN()) finding.rule else "${finding.rule} at ${timeText(finding)}",
        first.incident?.sentences?.map { it.text } ?: listOf(finding.text),
        first.incident.nextOf(finding),
        findings.count { it.severity == Severity.ERROR },
        findings.count { it.severity == Severity.WARNING },
    )
}

// Rounds down, as a clock does: it shows 1:33 until 1:34.
private fun timeText(finding: Finding) = secondsOf(finding.time, finding.timeUnit)?.let { minutesText(floor(it), decimals = 0) }
    ?: withUnit(numberText(finding.time), finding.timeUnit)

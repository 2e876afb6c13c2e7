package badlog.window.folder.index

import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.analysis.Units
import badlog.core.analysis.statisticsOf
import badlog.core.recording.PathName
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.recording.Severity
import badlog.core.recording.Topic
import badlog.files.LogFile
import badlog.files.LogName
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import badlog.rules.FolderRules
import badlog.signals.signalTopicsOf
import badlog.signals.vocabulary.SignalTopic
import badlog.signals.vocabulary.matchOf
import badlog.signals.withSignals
import badlog.viewer.draw.axis.overItsTime
import java.io.IOException
import java.nio.file.Path
import java.util.concurrent.CancellationException

/**
 * Reads [file], and returns what the library wants to know about it. Problems of the file become part of the entry. It uses
 * one core: the library reads several files at a time, and the window is in use.
 *
 * @param library the folder of logs, see [FolderRules.of]; null for only that of [file].
 * @param checkpoint called repeatedly while the file is read; to cancel, it may throw a [CancellationException], the only
 *   exception that is passed on.
 */
internal fun summarize(file: LogFile, library: Path? = null, checkpoint: () -> Unit = {}): LogEntry = try {
    when {
        isLikelyLog(file) -> summaryOf(file, library, readRecording(file.path, LOG_FORMATS, cores = 1) { _, _ -> checkpoint() })
        else -> unreadable(file, "${file.name} is not a log.").copy(content = Content.NO_LOG)
    }
} catch (e: CancellationException) {
    throw e
} catch (e: IOException) {
    unreadable(file, e.message ?: "${file.name} could not be read; is its drive still connected?")
} catch (_: OutOfMemoryError) {
    withoutSamples(file, library, checkpoint)
} catch (e: RuntimeException) {
    // A bug that affects one file must not affect all others.
    unreadable(file, "${file.name} made badlog fail (${e.javaClass.simpleName}); send us the file.")
}

/** Returns the summary of a file whose samples do not fit in memory. */
private fun withoutSamples(file: LogFile, library: Path?, checkpoint: () -> Unit): LogEntry = try {
    val recording = readRecording(file.path, LOG_FORMATS, keepSamples = false, cores = 1) { _, _ -> checkpoint() }
    summaryOf(file, library, recording).copy(content = Content.SOMETHING)
} catch (e: IOException) {
    unreadable(file, e.message ?: "${file.name} could not be read; is its drive still connected?")
} catch (_: OutOfMemoryError) {
    unreadable(file, "${file.name} is too large for the available memory.")
}

private fun unreadable(file: LogFile, trouble: String) =
    LogEntry(file, MatchFacts.of(emptyList(), file.name, logged = null), LogDate.ofFile(file), trouble = trouble)

private fun summaryOf(file: LogFile, library: Path?, read: Recording): LogEntry {
    if (isTable(read)) return unreadable(file, "${file.name} is a table that badlog made, not a log.").copy(content = Content.NO_LOG)
    val recording = read.overItsTime()
    val vocabulary = FolderRules.of(file.path, library).rules.signals
    val view = LogView.of(recording).withSignals(vocabulary)
    val topics = recording.topics.filter { it.samples.isNotEmpty() && !isPlumbing(it) }.map { summaryOf(it, view) }
    val match = MatchFacts.of(recording.values, file.name, vocabulary.matchOf(recording))
    val axis = view.xAxis
    val time = if (axis.isIndex) timeTopic(recording) else axis.topic
    val duration = if (axis.isIndex) time?.let { finiteSpan(it.samples)?.width } else axis.range?.let { it.endInclusive - it.start }
    val xUnit = if (axis.isIndex) time?.unit.orEmpty() else axis.unit
    val battery = signalTopicsOf(view, vocabulary).of("battery").firstOrNull()
    val trouble = if (recording.isReadable) null else recording.problems.last().message
    return LogEntry(
        source = file,
        match = match,
        date = LogDate.of(recording.values, file),
        duration = duration,
        xUnit = xUnit,
        samples = recording.sampleCount,
        problems = ProblemCounts(view.count(Severity.ERROR), view.count(Severity.WARNING), view.count(Severity.NOTE)),
        content = when {
            trouble == null -> {
                val seconds = duration?.let { secondsOf(it, xUnit) }
                contentOf(view, topics, time, seconds)
            }

            LogName.of(file.name).isOnlyOfLogs -> Content.UNREADABLE

            else -> Content.NO_LOG
        },
        trouble = trouble,
        batteryMinimum = battery?.let { lowestVoltage(recording.topics, it) },
        batteryTopic = battery?.topic,
        topics = topics,
    )
}

private fun summaryOf(topic: Topic, view: LogView): TopicSummary {
    val line = view.seriesOf(topic)
    val statistics = view.statisticsOf(line)
    val held = if (line.holds) view.xAxis.range else null
    return TopicSummary(
        topic.name,
        topic.unit,
        topic.kind,
        statistics,
        PreviewLine.of(line.data, statistics.min, statistics.max, held),
    )
}

/** Returns whether [recording] is a table of logs, as the window and the program may save them among the logs: each row is about a file. */
private fun isTable(recording: Recording): Boolean = recording.format == RecordingFormat.CSV &&
    recording.topics.take(3).map { it.name }.let { it == listOf("Log", "Date", "File") || it.take(2) == listOf("Match", "File") }

/** Returns whether [topic] is a logger's own data, such as the time of day. */
private fun isPlumbing(topic: Topic) = topic.times != null && "hide" in topic.attributes

/** Returns the time column: a plain CSV file has no x axis, but usually a time column. */
private fun timeTopic(recording: Recording): Topic? = recording.topics.firstOrNull {
    it.samples.isNotEmpty() && PathName.baseNameOf(it.name).lowercase() in setOf("time", "timestamp", "match time")
}

/** Before a sensor has been read for the first time, it returns 0, which no battery of a running robot has. */
private fun lowestVoltage(topics: List<Topic>, battery: SignalTopic): Double? {
    var lowest = Double.POSITIVE_INFINITY
    for (voltage in topics.first { it.name == battery.topic }.samples) if (voltage > 0 && voltage < lowest) lowest = voltage
    return lowest.takeIf { it.isFinite() }?.let { it * (battery.scale ?: 1.0) }
}

/** Returns [duration] in [unit] as seconds; null if the unit is not one of time. */
internal fun secondsOf(duration: Double, unit: String): Double? {
    // A log without units is a plain CSV file, whose time is nearly always in seconds.
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

package badlog.viewer.recording

import badlog.analysis.EnabledSpan
import badlog.analysis.EventLog
import badlog.analysis.LogView
import badlog.analysis.enabledSpans
import badlog.file.readRecording
import badlog.plot.Span
import badlog.viewer.inspector.RecordingEvents
import java.io.IOException
import java.nio.file.Path

/**
 * A recording whose file was read, with all that can be drawn of it.
 *
 * @property file where it was read from; absolute.
 */
internal class OpenRecording(val file: Path, val view: LogView) {
    /** All that can be drawn: the topics in the order of the file, then what is derived from them. */
    val signals: List<Signal> = signalsOf(view)

    private val byName = signals.associateBy { it.name }

    /** The events of all topics of texts. */
    val eventLogs: List<EventLog> = view.folders.flatMap { it.eventLogs }

    /** All events of those, in the order of x. */
    val events: RecordingEvents by lazy { RecordingEvents(eventLogs) }

    /** When the robot was enabled; empty when nothing tells. */
    val enabled: List<EnabledSpan> by lazy { view.enabledSpans() }

    /** All of the x axis that has samples; wider than that where there is a single x. */
    val span: Span

    /** The smallest x; 0 without any. */
    val firstX: Double

    init {
        val placed = finiteSpan(view.xAxis.positions)
        firstX = placed?.from ?: 0.0
        span = when {
            placed == null -> Span(0.0, 1.0)
            placed.width > 0 -> placed
            else -> Span(placed.from - 0.5, placed.from + 0.5)
        }
    }

    /** Where on x there are rows, ascending: the places the cursor steps to. */
    val positions: DoubleArray by lazy { ascending(view.xAxis.positions) }

    /** What a person would call it: the match, or else the name of the file. */
    val label: String get() = view.title ?: file.fileName.toString()

    /** The signal called [name], or null when this recording has none. */
    fun signal(name: String): Signal? = byName[name]

    /** Finds out now what the first frame needs, so that the window's thread does not have to. */
    private fun prepare() {
        enabled
        events
    }

    companion object {
        /**
         * Reads [file], an absolute path; see [readRecording] for what it may throw besides.
         *
         * @param isGrowing whether what follows the last line end is left out, as a row that is half written.
         * @param progress hears how much is done, from 0 to 1.
         * @throws IOException with a sentence for the person, when it is no recording.
         */
        fun read(file: Path, isGrowing: Boolean = false, progress: (Float) -> Unit = {}): OpenRecording {
            val recording = readRecording(file, untilLastLineEnd = isGrowing) { done, total ->
                if (total > 0) progress(done.toFloat() / total)
            }
            if (!recording.isReadable) throw IOException("${file.fileName}: ${recording.problems.last().message}")
            return OpenRecording(file, LogView.of(recording)).also { it.prepare() }
        }
    }
}

private fun signalsOf(view: LogView): List<Signal> {
    val logged = view.recording.topics
        .filter { it !== view.xAxis.topic && (it.samples.isNotEmpty() || it.texts.size > 0) }
        .map { Signal(it.name, isDerived = false, view.seriesOf(it)) }
    val derived = view.folders.flatMap { it.graphs }
        .filter { graph -> graph.series.all { it.isDerived } }
        .map { Signal(it.name, isDerived = true, it.series.single()) }
    return logged + derived
}

private fun ascending(positions: DoubleArray): DoubleArray {
    val isAscending = positions.indices.all { positions[it].isFinite() && (it == 0 || positions[it] >= positions[it - 1]) }
    return if (isAscending) positions else positions.filter { it.isFinite() }.toDoubleArray().apply { sort() }
}

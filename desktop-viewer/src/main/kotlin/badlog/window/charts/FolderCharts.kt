package badlog.window.charts

import badlog.catalog.examine.ExaminedLog
import badlog.catalog.folder.LogEntry
import badlog.charts.chartsOf
import badlog.charts.match.ChartedLog
import badlog.files.writeAtomically
import badlog.rules.number.LogNumbersReader
import badlog.viewer.catalog.DateSource
import badlog.window.export.figure.FigureFormat
import badlog.window.files.FileChoice
import badlog.window.files.askToWrite
import badlog.window.folder.Library
import badlog.window.state.StateHolder
import badlog.window.task.LongTasks
import badlog.window.task.Notices
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Job
import kotlinx.coroutines.delay
import kotlinx.coroutines.flow.Flow
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.launch
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds
import kotlin.time.TimeMark
import kotlin.time.TimeSource

/**
 * The state of the window's charts.
 *
 * @property charts the charts that were drawn last; null before the first.
 * @property of the logs of [charts].
 * @property asked the requested logs; they differ from [of] while charts are being drawn, or after a person stopped that.
 * @property isDrawing whether charts are being drawn.
 */
internal data class ChartsState(
    val charts: DrawnCharts? = null,
    val of: List<LogEntry> = emptyList(),
    val asked: List<LogEntry> = emptyList(),
    val isDrawing: Boolean = false,
) {
    /** Whether a person stopped drawing the requested charts. */
    val isStopped: Boolean get() = !isDrawing && asked != of

    /**
     * Returns the charts if they show any of [logs], otherwise null. Charts of another folder or event could be mistaken for charts of
     * [logs].
     */
    fun chartsFor(logs: List<LogEntry>): DrawnCharts? {
        val files = logs.mapTo(HashSet()) { it.file }
        return charts?.takeIf { of.any { it.file in files } }
    }
}

/**
 * The charts of the logs in the folder's list. Use it only on the window's thread.
 *
 * @param makeCharts draws charts, see [drawCharts].
 */
internal class FolderCharts(
    private val scope: CoroutineScope,
    private val library: Library,
    private val files: FileChoice,
    private val tasks: LongTasks,
    private val notices: Notices,
    private val makeCharts: (List<LogEntry>, (LogEntry) -> ExaminedLog?, (Float) -> Unit) -> DrawnCharts = ::drawCharts,
) : StateHolder<ChartsState>(ChartsState()) {
    private var drawing: Job? = null

    /** The time of the list's first change since the last drawing began; null if there was none. */
    private var changedAt: TimeMark? = null

    /**
     * Draws charts of the newest of [lists]: soon after it stops changing, or every few seconds while it changes. Cancelling it stops
     * drawing.
     */
    suspend fun follow(lists: Flow<List<LogEntry>>) {
        try {
            lists.collectLatest(::show)
        } finally {
            stop()
        }
    }

    private suspend fun show(logs: List<LogEntry>) {
        if (logs.isEmpty() || (state.charts != null && state.of == logs)) {
            stop()
            return
        }
        // Charts of another search or folder are no longer wanted. A folder that is being read only grows: if each of its logs restarted
        // the drawing, there would be no charts until the last log.
        if (!state.asked.isPartOf(logs)) stop()
        // A person types a search faster than charts can be drawn.
        val since = changedAt ?: TimeSource.Monotonic.markNow().also { changedAt = it }
        delay(minOf(CALM, (if (state.charts == null) LONGEST_CALM else REST) - since.elapsedNow()))
        val running = drawing?.takeIf { it.isActive }
        if (running != null) {
            running.join()
            // A person who stopped it does not want the next drawing either.
            if (running.isCancelled) return
        }
        draw(logs)
    }

    /** Stops drawing; the drawn logs become the requested ones. */
    private fun stop() {
        drawing?.cancel()
        drawing = null
        changedAt = null
        if (state.isDrawing || state.asked != state.of) change { copy(asked = of, isDrawing = false) }
    }

    /** Draws charts of [logs] in the background. An earlier drawing is canceled; its charts stay until these are ready. */
    fun draw(logs: List<LogEntry>) {
        drawing?.cancel()
        changedAt = null
        change { copy(charts = chartsFor(logs), asked = logs, isDrawing = true) }
        val examined = library.examined
        val job = tasks.run("Drawing charts of ${logs.size} logs", { progress -> makeCharts(logs, examined, progress) }) { drawn ->
            change { ChartsState(drawn, of = logs, asked = logs) }
        }
        drawing = job
        scope.launch {
            job.join()
            if (drawing === job) change { copy(isDrawing = false) }
        }
    }

    /** Asks for a file, and writes [chart] to it. */
    fun save(chart: DrawnChart, format: FigureFormat) {
        val file = askToWrite(files, notices, "Save the chart", library.state.folder, chart.name, ".${format.ending}") ?: return
        tasks.run("Saving ${file.fileName}", { writeAtomically(file) { it.write(chart.bytes(format)) } }) {
            notices.say("Saved the chart to $file.")
        }
    }

    private companion object {
        val CALM = 400.milliseconds

        /** The longest time that the first charts wait for the list to stop changing. */
        val LONGEST_CALM = 2.seconds

        /** The longest time that later charts wait for the list, because a machine that reads a folder is busy. */
        val REST = 8.seconds
    }
}

private fun List<LogEntry>.isPartOf(others: List<LogEntry>): Boolean {
    val files = others.mapTo(HashSet()) { it.file }
    return all { it.file in files }
}

/**
 * The charts of some logs.
 *
 * @property all the drawn charts, the most useful first.
 * @property lacking a sentence for each of the other charts, about the data that it lacks.
 * @property unknown the number of logs left out because today's rules have not been run over them.
 */
internal class DrawnCharts(val all: List<DrawnChart>, val lacking: List<String>, val unknown: Int = 0)

/**
 * Draws the charts of [logs]. It takes several seconds: call it off the window's thread. Interrupting its thread stops it.
 *
 * @param examined returns the stored results of a log; null if there are none.
 * @param progress receives the fraction done, 0 to 1.
 */
internal fun drawCharts(logs: List<LogEntry>, examined: (LogEntry) -> ExaminedLog?, progress: (Float) -> Unit): DrawnCharts {
    val reader = LogNumbersReader()
    val known = logs.mapNotNull { entry ->
        stopIfInterrupted()
        val date = entry.summary.date
        val began = date.second.takeIf { date.source != DateSource.FILE_TIME }
        examined(entry)?.let { ChartedLog(entry.summary.match, entry.fileName, began, it.numbers(reader)) }
    }
    val charts = chartsOf(known) { stopIfInterrupted() }
    val drawn = charts.all.mapIndexed { place, chart ->
        stopIfInterrupted()
        val done = DrawnChart(chart.name, chart.title, chart.question, chart.reading, chart.svg(), chart.png())
        progress((place + 1f) / charts.all.size)
        done
    }
    return DrawnCharts(drawn, charts.lacking, logs.size - known.size)
}

private fun stopIfInterrupted() {
    if (Thread.interrupted()) throw InterruptedException()
}

/**
 * A drawn chart of the folder's logs. It holds bytes rather than an object of the chart library, so that this library is loaded only when
 * the first chart is drawn.
 *
 * @property name its name in the names of files.
 * @property title its title.
 * @property question the question that it answers.
 * @property reading an explanation of how to read it.
 */
internal class DrawnChart(
    val name: String,
    val title: String,
    val question: String,
    val reading: String,
    private val svg: String,
    private val png: ByteArray,
) {
    /** Returns the content of its file in [format]. */
    fun bytes(format: FigureFormat): ByteArray = when (format) {
        FigureFormat.SVG -> svg.encodeToByteArray()
        FigureFormat.PNG -> png
    }
}

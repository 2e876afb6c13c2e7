package badlog.window.charts

import badlog.catalog.folder.LogEntry
import badlog.files.writeAtomically
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
import kotlinx.coroutines.launch
import kotlin.time.Duration.Companion.milliseconds

/**
 * What the window's charts show.
 *
 * @property charts the charts that were drawn last; null before any were.
 * @property of the logs that [charts] are of.
 * @property asked the logs whose charts are wanted; others than [of] while they are being drawn, or if a person stopped that.
 * @property isDrawing whether charts are being drawn.
 */
internal data class ChartsState(
    val charts: DrawnCharts? = null,
    val of: List<LogEntry> = emptyList(),
    val asked: List<LogEntry> = emptyList(),
    val isDrawing: Boolean = false,
) {
    /** Whether a person stopped drawing the charts that are wanted. */
    val isStopped: Boolean get() = !isDrawing && asked != of
}

/** The charts of the logs that the list of the folder shows. Use it only on the window's thread. */
internal class FolderCharts(
    private val scope: CoroutineScope,
    private val library: Library,
    private val files: FileChoice,
    private val tasks: LongTasks,
    private val notices: Notices,
) : StateHolder<ChartsState>(ChartsState()) {
    private var drawing: Job? = null

    /** Draws charts of [logs] as soon as they have not changed for a moment, unless that is done; cancelling it stops drawing. */
    suspend fun follow(logs: List<LogEntry>) {
        if (state.charts != null && state.of == logs) return
        // While logs are read, or somebody types a search, the list changes faster than it can be drawn.
        delay(CALM)
        val job = draw(logs)
        try {
            job.join()
        } finally {
            job.cancel()
        }
    }

    /** Draws charts of [logs]. */
    fun draw(logs: List<LogEntry>): Job {
        drawing?.cancel()
        val wanted = logs.mapTo(HashSet()) { it.file }
        // Those of another folder, or of another event, would be taken for the new ones.
        change { copy(charts = charts?.takeIf { of.any { it.file in wanted } }, asked = logs, isDrawing = true) }
        val examined = library.examined
        val job = tasks.run("Drawing charts of ${logs.size} logs", { progress -> drawCharts(logs, examined, progress) }) { drawn ->
            change { ChartsState(drawn, of = logs, asked = logs) }
        }
        drawing = job
        scope.launch {
            job.join()
            if (drawing === job) change { copy(isDrawing = false) }
        }
        return job
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
    }
}

package badlog.page.compare

import badlog.core.analysis.LogView
import badlog.core.analysis.enabledSpans
import badlog.core.recording.Recording
import badlog.page.formula.Formulas
import badlog.page.opened.OpenedLog
import badlog.signals.match.matchOf
import badlog.viewer.choices.board.BoardLines
import badlog.viewer.choices.comparison.Alignment
import badlog.viewer.choices.comparison.LogMoments
import badlog.viewer.choices.comparison.LogOffsets
import badlog.viewer.shown.comparison.ComparedLog
import badlog.viewer.shown.comparison.LogName
import badlog.viewer.shown.comparison.namesBeside
import org.w3c.files.File

/**
 * The logs compared with the page's own, in the order in which they were added, and their offsets on x.
 *
 * @param file the name of the page's own file.
 */
internal class PageComparison(private val formulas: Formulas, file: String) {
    private class Log(val id: Int, val files: List<File>, val path: String, val view: LogView, val name: LogName, val moments: LogMoments)

    private val open = logOf(OPEN, emptyList(), file, file, formulas.logged)
    private val logs = ArrayList<Log>()
    private var offsets = LogOffsets<Int>()
    private var lastId = OPEN
    private val gone = ArrayList<File>()
    private val listeners = ArrayList<() -> Unit>()

    /** The view with the page's own formulas when the lines of the others were calculated. */
    private var calculated: LogView? = null
    private val lines = HashMap<Int, BoardLines>()

    /** The rule by which the compared logs are moved along the x axis. */
    val alignment: Alignment get() = offsets.alignment

    /** The compared logs as they are drawn. */
    var drawn: List<ComparedLog> = emptyList()
        private set

    /** The name under which the page's own log is shown beside the others. */
    var openName = ""
        private set

    /** Calls [listener] after each change. */
    fun onChange(listener: () -> Unit) {
        listeners += listener
    }

    /** The files of the compared logs. */
    val files: List<File> get() = logs.flatMap { it.files }

    /** The files of logs that were removed. */
    val removed: List<File> get() = gone

    /** Adds [log], read as [recording]; it replaces a log from the same place. */
    fun add(log: OpenedLog, recording: Recording) {
        for (same in logs.filter { it.path == log.path }) gone += same.files
        logs.removeAll { it.path == log.path }
        logs += logOf(++lastId, log.files, log.path, log.fileName, formulas.viewOf(recording, log.fileName))
        show()
    }

    /** Removes the log at [index] of [drawn]. */
    fun remove(index: Int) {
        val log = logs.removeAt(index)
        gone += log.files
        offsets = offsets.without(log.id)
        show()
    }

    /** Removes all compared logs. */
    fun clear() {
        gone += files
        logs.clear()
        show()
    }

    /** Aligns all logs by [wanted]. */
    fun alignBy(wanted: Alignment) {
        offsets = offsets.alignedBy(wanted, OPEN, moments())
        show()
    }

    /** Moves the log at [index] of [drawn] to [offset], as set by hand. */
    fun move(index: Int, offset: Double) {
        offsets = offsets.moved(logs[index].id, offset, OPEN, moments())
        show()
    }

    /** Calculates the formulas of all logs again, if they have changed. */
    fun followFormulas() {
        if (logs.isNotEmpty() && calculated !== formulas.view) show()
    }

    private fun show() {
        if (calculated !== formulas.view) lines.clear()
        calculated = formulas.view
        val names = namesBeside((listOf(open) + logs).map { it.name })
        val moments = moments()
        openName = names[0]
        drawn = logs.mapIndexed { i, log ->
            val own = lines.getOrPut(log.id) { BoardLines(formulas.extended(log.view)) }
            ComparedLog(names[i + 1], own, offsets.of(log.id, OPEN, moments))
        }
        for (listener in listeners) listener()
    }

    private fun moments() = (listOf(open) + logs).associate { it.id to it.moments }

    private fun logOf(id: Int, files: List<File>, path: String, file: String, view: LogView): Log {
        val match = formulas.signals.matchOf(view.recording, file)
        val name = LogName(match.event, match.match, view.title ?: file, path)
        return Log(id, files, path, view, name, LogMoments(view.xAxis.range?.start ?: 0.0, view.enabledSpans().firstOrNull()?.span?.from))
    }
}

/** The page's own log. */
private const val OPEN = 0

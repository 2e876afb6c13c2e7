package badlog.window.folder

import androidx.compose.runtime.snapshotFlow
import badlog.catalog.examine.ExaminedLog
import badlog.catalog.folder.LogEntry
import badlog.rules.Finding
import badlog.rules.RuleSet
import badlog.rules.comparison.compared
import badlog.rules.folder.FolderRules
import badlog.rules.number.FigureReader
import badlog.rules.number.LogFigures
import badlog.viewer.shown.folder.isOfSameRun
import badlog.window.log.CurrentRecording
import badlog.window.log.assertOffWindow
import badlog.window.state.StateHolder
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.withContext
import java.nio.file.Path

/**
 * How the open log differs from the matches before it in its folder.
 *
 * @property differences what is unusual, as the comparisons of the rules say it, the largest first.
 * @property previous the log of the match before it; null if there is none.
 */
internal data class Changes(val differences: List<Finding> = emptyList(), val previous: Path? = null)

/** Compares the open log with the ones before it, whenever the rules have run over more of them. Use it only on the window's thread. */
internal class SinceLastMatch(private val current: CurrentRecording, private val library: Library) : StateHolder<Changes>(Changes()) {
    private data class Compared(val folder: Path?, val earlier: List<LogEntry>, val log: LogEntry?)

    /** Follows the open log and the folder, until cancelled. */
    suspend fun run() {
        var shown: Path? = null
        snapshotFlow { compared() }.collectLatest { wanted ->
            if (wanted.log?.file != shown) change { Changes() }
            shown = wanted.log?.file
            val log = wanted.log ?: return@collectLatest
            val examined = library.examined
            val changes =
                withContext(Dispatchers.Default) { changesOf(log, wanted.earlier, FolderRules.of(log.file, wanted.folder).rules, examined) }
            change { changes }
        }
    }

    private fun compared(): Compared {
        val known = library.state.ofRobots.filter { !it.isGray && it.found?.rules != null }
        val log = known.find { it.file == current.recording?.file }
        return Compared(library.state.folder, log?.let { earlierThan(it, known) }.orEmpty(), log)
    }
}

/** Returns those of [logs] that are of matches before that of [log], in the order of time; only as many of the last as may be needed. */
internal fun earlierThan(log: LogEntry, logs: List<LogEntry>): List<LogEntry> = logs.filter {
    it.summary.date.second < log.summary.date.second && !isOfSameRun(it, log)
}.sortedBy { it.summary.date.second }.takeLast(MOST_READ)

/** Returns how [log] differs from those of the [earlier] ones that are of the same kind, by [rules], whose results [examined] returns. */
internal fun changesOf(log: LogEntry, earlier: List<LogEntry>, rules: RuleSet, examined: (LogEntry) -> ExaminedLog?): Changes {
    assertOffWindow()
    val reader = FigureReader()

    fun figuresOf(entry: LogEntry) = examined(entry)?.figures(reader) ?: LogFigures.NONE
    val own = figuresOf(log)
    if (own.keys.isEmpty()) return Changes()
    val alike = earlier.map {
        it to figuresOf(it)
    }.filter { (_, figures) -> figures.kind == own.kind && figures.keys.isNotEmpty() }.takeLast(MOST)
    return Changes(rules.compared(alike.map { it.second } + own).last().findings, alike.lastOrNull()?.first?.file)
}

/** A robot changes over a season. */
private const val MOST = 20

/** Between the matches of an event there is practice, and the Driver Station has logs of its own. */
private const val MOST_READ = 100

package badlog.window.folder.index

import badlog.core.analysis.LogView
import badlog.files.LogFile
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import badlog.rules.FolderRules
import badlog.rules.RuleSet
import badlog.rules.over
import badlog.rules.toJson
import badlog.signals.withSignals
import badlog.viewer.draw.axis.overItsTime
import kotlinx.coroutines.CancellationException
import java.io.IOException
import java.nio.file.Path
import kotlin.time.Duration.Companion.seconds
import kotlin.time.TimeMark
import kotlin.time.TimeSource

/** Runs the rules over the logs of [folder]: those of the nearest file of rules. Use it on one thread at a time. */
internal class FolderSearch(private val folder: Path) {
    private class Known(val rules: RuleSet, val key: Int, val since: TimeMark)

    private val byFolder = HashMap<Path, Known>()

    /** Returns what distinguishes the rules for [file] from others. */
    fun keyOf(file: Path): Int = rulesFor(file).key

    /**
     * Returns what the rules find in [file]. Reads it again, on one core.
     *
     * @param checkpoint called repeatedly; to cancel, it may throw a [CancellationException], the only exception that is passed on.
     */
    fun found(file: LogFile, checkpoint: () -> Unit): LogFound {
        val known = rulesFor(file.path)
        val rules = try {
            val recording = readRecording(file.path, LOG_FORMATS, cores = 1) { _, _ -> checkpoint() }.overItsTime()
            val view = LogView.of(recording).withSignals(known.rules.signals)
            val findings = known.rules.over(view, file.name) { checkpoint() }.findings
            findings.map { FoundRule(it.rule, it.severity) }.distinctBy { it.name }.sortedByDescending { it.severity }
        } catch (e: CancellationException) {
            throw e
        } catch (_: IOException) {
            null
        } catch (_: OutOfMemoryError) {
            null
        } catch (_: RuntimeException) {
            // A bug that affects one file must not affect all others.
            null
        }
        return LogFound(known.key, rules)
    }

    private fun rulesFor(file: Path): Known {
        val place = file.parent ?: file
        byFolder[place]?.takeIf { it.since.elapsedNow() < REST }?.let { return it }
        val rules = FolderRules.of(file, folder).rules
        val same = byFolder[place]?.takeIf { it.rules == rules }
        val now = TimeSource.Monotonic.markNow()
        return Known(rules, same?.key ?: rules.toJson().hashCode(), now).also { byFolder[place] = it }
    }

    private companion object {
        /** How long a changed file of rules may go unnoticed. */
        val REST = 3.seconds
    }
}

package badlog.cli.export

import badlog.cli.input.readLog
import badlog.files.LogMaker
import badlog.files.NotReadException
import badlog.files.ReadResult
import badlog.files.terminal.Progress
import badlog.report.hook.HookException
import badlog.report.hook.HookOutcome
import badlog.report.hook.HookRunner
import java.nio.file.Path

/**
 * Findings embedded in the page of a log because the page cannot find them itself.
 *
 * @property hooks the results of hooks.
 * @property unreadable the reason why no hook could run; null if there is none.
 */
internal class PageFindings private constructor(val hooks: List<HookOutcome>, val unreadable: String?) {
    /** The number of findings; null if no hook was to run. */
    val count: Int? get() = if (hooks.isEmpty()) null else hooks.sumOf { it.result?.findings?.size ?: 0 }

    /** The hooks that failed, with their failures. */
    val failures: List<Pair<String, HookException>> get() = hooks.mapNotNull { hook -> hook.failure?.let { hook.hook to it } }

    companion object {
        /** Nothing, because there are no hooks. */
        val NONE = PageFindings(emptyList(), null)

        /** Runs [hooks] on the log in [file], which is read with its samples, using [maker]. */
        fun of(file: Path, hooks: List<HookRunner>, maker: LogMaker, progress: Progress): PageFindings = try {
            val recording = readLog(file, progress, maker = maker)
            PageFindings(hooks.map { HookOutcome.of(it, recording) }, null)
        } catch (e: NotReadException) {
            // The page itself needs little memory.
            if (e.why.cause == ReadResult.Cause.TOO_LARGE) PageFindings(emptyList(), e.why.sentence) else throw e
        } catch (e: OutOfMemoryError) {
            PageFindings(emptyList(), ReadResult.NotRead.of(file, e).sentence)
        }
    }
}

package badlog.cli.export

import badlog.analysis.LogView
import badlog.cli.input.readLog
import badlog.expression.withVirtualTopics
import badlog.html.PageAdditions
import badlog.report.hook.HookException
import badlog.report.hook.HookOutcome
import badlog.report.hook.HookRunner
import badlog.report.page.pageAdditions
import badlog.rules.LogFindings
import badlog.rules.RuleSet
import badlog.rules.SkippedRule
import badlog.rules.over
import badlog.terminal.Progress
import java.nio.file.Path

/**
 * What was found in a log, for its page.
 *
 * @property unreadable why nothing could be looked for, or null.
 */
internal class Found private constructor(private val rules: LogFindings, private val hooks: List<HookOutcome>, val unreadable: String?) {
    /** How much that is. */
    val count: Int get() = rules.findings.size + hooks.sumOf { it.result?.findings?.size ?: 0 }

    /** The rules that were skipped for the log. */
    val skipped: List<SkippedRule> get() = rules.skipped

    /** The programs that failed. */
    val failures: List<Pair<String, HookException>> get() = hooks.mapNotNull { hook -> hook.failure?.let { hook.hook to it } }

    /** What the page shows of it, besides [virtualTopics]. */
    fun additions(virtualTopics: List<String>): PageAdditions = pageAdditions(virtualTopics, rules.findings, hooks)

    companion object {
        /** Runs [rules] over the log in [file] with [virtualTopics], and [hooks] for it. */
        fun of(file: Path, rules: RuleSet, hooks: List<HookRunner>, virtualTopics: List<String>, progress: Progress): Found = try {
            val recording = readLog(file, progress)
            val view = LogView.of(recording).withVirtualTopics(virtualTopics).view
            Found(rules.over(view, file.fileName.toString()), hooks.map { HookOutcome.of(it, recording) }, null)
        } catch (_: OutOfMemoryError) {
            // The page itself needs little.
            val reason = "the log is too large for the memory at hand; set JAVA_OPTS=-Xmx8g or so and try again."
            Found(LogFindings(emptyList(), emptyList()), emptyList(), reason)
        }
    }
}

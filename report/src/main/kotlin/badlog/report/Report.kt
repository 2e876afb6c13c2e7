package badlog.report

import badlog.file.LogFile
import badlog.report.rules.Finding
import badlog.report.rules.RuleRunner
import badlog.report.rules.RuleSet
import java.nio.file.Path
import kotlinx.serialization.Serializable

/**
 * Runs rules over many logs.
 *
 * @property rules what to look for.
 * @param cache a folder for what was found out before, so that a file that did not change is not read again; null for none.
 */
public class Report(public val rules: RuleSet = RuleSet.DEFAULT, private val cache: Path? = null) {
    private val runner = RuleRunner(rules)

    @Serializable
    internal class Stored(
        val title: String?,
        val findings: List<Finding>,
        val asked: List<Asked>,
        val unreadable: String?,
    )

    @Serializable
    internal class Asked(val rule: String, val refusal: String? = null, val mistake: String? = null)

    /**
     * Runs the rules over each of [files], on all cores.
     *
     * @param progress hears on this thread how many files are done.
     * @param each gets each result on this thread, as soon as it and those before it are there. What it or [progress] throws stops
     *   the work and is passed on.
     * @throws InterruptedException when the thread was interrupted.
     */
    public fun over(
        files: List<LogFile>,
        progress: (done: Int, total: Int) -> Unit = { _, _ -> },
        each: (LogReport) -> Unit = {},
    ): ReportResult {
        val logs = ArrayList<LogReport>(files.size)
        val asked = HashMap<String, MutableList<Asked>>()
        val known = cache?.let { ResultCache(it, "report\n${rules.source}", Stored.serializer()) }
        runCached(files, known, ::examine) { file, stored ->
            val log = LogReport(file, stored.title, stored.findings, stored.unreadable)
            logs += log
            for (rule in stored.asked) asked.getOrPut(rule.rule) { ArrayList() } += rule
            each(log)
            progress(logs.size, files.size)
        }
        return ReportResult(logs, rules.rules.mapNotNull { rule -> asked[rule.name]?.let { skipped(rule.name, it) } })
    }

    private fun examine(file: LogFile): Found<Stored> = try {
        examine(file, LogContent.of(file))
    } catch (_: OutOfMemoryError) {
        examine(file, LogContent.tooLarge())
    }

    private fun examine(file: LogFile, content: LogContent): Found<Stored> = when (content) {
        is LogContent.None -> Found(Stored(null, emptyList(), emptyList(), content.message), content.isOfFile)
        is LogContent.Log -> {
            val findings = ArrayList<Finding>()
            val asked = ArrayList<Asked>()
            val match = content.view.title ?: file.name
            runner.run(content.view, match, file.name, { findings += it }) { rule, refusal ->
                asked += Asked(rule.name, refusal?.message, refusal?.mistake)
            }
            Found(Stored(content.view.title, findings, asked, null), isLasting = true)
        }
    }

    private fun skipped(rule: String, asked: List<Asked>): SkippedRule? {
        val refused = asked.filter { it.refusal != null }
        val mistaken = refused.find { it.mistake != null }
        val first = mistaken ?: refused.firstOrNull() ?: return null
        // A rule that can be asked of one log is right; another log only lacks its topics.
        val isMistake = mistaken != null && refused.size == asked.size
        return SkippedRule(rule, refused.size, (if (isMistake) first.mistake else first.refusal).orEmpty(), isMistake)
    }
}

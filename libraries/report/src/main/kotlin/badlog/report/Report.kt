package badlog.report

import badlog.file.LogFile
import badlog.report.hook.HookOutcome
import badlog.report.hook.HookRunner
import badlog.rules.BUILT_IN
import badlog.rules.Finding
import badlog.rules.LogShape
import badlog.rules.Rule
import badlog.rules.RuleProgram
import badlog.rules.RuleSet
import badlog.rules.SkippedRule
import badlog.rules.incident.incidentsIn
import badlog.rules.toJson
import badlog.rules.worstFirst
import kotlinx.serialization.Serializable
import kotlinx.serialization.Transient
import java.nio.file.Path

/**
 * Runs rules, and programs of the user's, over many logs.
 *
 * @param rules what to look for.
 * @param hooks programs to run for each log; what they find joins what the rules find.
 * @param virtualTopics definitions of topics that the rules may use beside a log's own, such as `Power = Voltage * Current`.
 * @param cache a folder for what was found out before, so that a file that did not change is not read again; null for none. What
 *   hooks return is not kept there: nobody knows what it depends on.
 * @param xTopic the topic to take as x axis, which plain CSV does not name; null for what the log itself says.
 */
public class Report(
    private val rules: RuleSet = RuleSet.BUILT_IN,
    private val hooks: List<HookRunner> = emptyList(),
    private val virtualTopics: List<String> = emptyList(),
    private val cache: Path? = null,
    private val xTopic: String? = null,
) {
    private val ruleOf = rules.rules.associateBy { it.name }
    private val programs = LruCache<LogShape, RuleProgram>(MAX_PROGRAMS) { RuleProgram(rules, it) }

    @Serializable
    internal class Stored(
        val title: String?,
        val findings: List<
            @Serializable(with = FindingSerializer::class)
            Finding,
            >,
        val asked: List<Asked>,
        val unreadable: String?,
        val isNoLog: Boolean = false,
        val isSalvaged: Boolean = false,
        val undefined: List<UndefinedTopic> = emptyList(),
        @Transient val hooks: List<HookOutcome> = emptyList(),
    )

    @Serializable
    internal class Asked(val rule: String, val refusal: String? = null, val mistake: String? = null)

    /**
     * Runs the rules over each of [files], on all cores.
     *
     * @param progress hears on this thread how many files are done.
     * @param each gets each result on this thread, as soon as it and those before it are there, with all that the hooks returned,
     *   which is not held any longer. What it or [progress] throws stops the work and is passed on.
     * @throws InterruptedException when the thread was interrupted.
     */
    public fun over(
        files: List<LogFile>,
        progress: (done: Int, total: Int) -> Unit = { _, _ -> },
        each: (LogReport, List<HookOutcome>) -> Unit = { _, _ -> },
    ): ReportResult {
        val logs = ArrayList<LogReport>(files.size)
        val asked = HashMap<String, MutableList<Asked>>()
        val question = "report\n${virtualTopics.joinToString("\n")}\n\n${xTopic.orEmpty()}\n${rules.toJson()}"
        val known = cache?.takeIf { hooks.isEmpty() }?.let { ResultCache(it, question, Stored.serializer()) }
        runCached(files, known, ::examine) { file, stored ->
            val failures = stored.hooks.mapNotNull { hook -> hook.failure?.let { HookFailure(hook.hook, it.message) } }
            val log = LogReport(
                file, stored.title, stored.findings, rules.incidentsIn(stored.findings),
                stored.asked.mapNotNull {
                    skipped(ruleOf.getValue(it.rule), listOf(it))
                },
                stored.unreadable,
                stored.isNoLog, stored.isSalvaged, stored.undefined, failures,
            )
            logs += log
            for (rule in stored.asked) asked.getOrPut(rule.rule) { ArrayList() } += rule
            each(log, stored.hooks)
            progress(logs.size, files.size)
        }
        val readable = logs.count { it.unreadable == null }
        val skipped = rules.rules.mapNotNull { rule ->
            asked[rule.name].let { if (it == null) unasked(rule, readable) else skipped(rule, it) }
        }
        return ReportResult(logs, skipped)
    }

    private fun examine(file: LogFile, cores: Int): CachedResult<Stored> =
        LogContent.examined(file, virtualTopics, rules.signals, xTopic, cores = cores) { examine(file, it) }

    private fun examine(file: LogFile, content: LogContent): CachedResult<Stored> = when (content) {
        is LogContent.None -> CachedResult(Stored(null, emptyList(), emptyList(), content.message, content.isNoLog), content.isNoLog)

        is LogContent.Log -> {
            val findings = ArrayList<Finding>()
            val asked = ArrayList<Asked>()
            for (rule in programs[LogShape.of(content.view)].run(content.view, file.name)) {
                findings += rule.findings
                asked += Asked(rule.rule.name, rule.refusal?.message, rule.refusal?.mistake)
            }
            val outcomes = hooks.map { HookOutcome.of(it, content.recording) }
            for (outcome in outcomes) findings += outcome.findings(content.view.xAxis.unit)
            val isSalvaged = content.recording.isSalvaged
            val stored =
                Stored(
                    content.view.title,
                    findings.worstFirst(),
                    asked,
                    null,
                    isSalvaged = isSalvaged,
                    undefined = content.undefined,
                    hooks = outcomes,
                )
            CachedResult(stored, isLasting = true)
        }
    }

    private fun unasked(rule: Rule, logs: Int): SkippedRule? {
        val types = rule.only.joinToString(" or ") { "“$it”" }
        return if (logs == 0) null else SkippedRule(rule.name, logs, "it is only for matches of the type $types", isMistake = false)
    }

    private fun skipped(rule: Rule, asked: List<Asked>): SkippedRule? {
        val refused = asked.filter { it.refusal != null }
        val mistaken = refused.find { it.mistake != null }
        val first = mistaken ?: refused.firstOrNull() ?: return null
        // A rule that can be asked of one log is right; another log only lacks its topics.
        val isMistake = mistaken != null && refused.size == asked.size
        return SkippedRule(rule.name, refused.size, (if (isMistake) first.mistake else first.refusal).orEmpty(), isMistake, rule.isBuiltIn)
    }

    private companion object {
        // Each knows all names of its logs several times over.
        const val MAX_PROGRAMS = 16
    }
}

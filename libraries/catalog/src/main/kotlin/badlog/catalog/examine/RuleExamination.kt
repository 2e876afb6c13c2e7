package badlog.catalog.examine

import badlog.catalog.store.CachedResult
import badlog.catalog.store.ResultCache
import badlog.core.recording.ProblemKind
import badlog.rules.Finding
import badlog.rules.RuleProgram
import badlog.rules.RuleSet
import badlog.rules.comparison.numbersOf
import badlog.rules.number.LogNumbers
import badlog.rules.number.toText
import badlog.rules.toJson
import badlog.signals.ShapeCache
import badlog.signals.battery.batteryUseOf
import badlog.signals.match.matchInName
import badlog.signals.match.matchOf
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.LogDate
import java.nio.file.Path
import java.util.concurrent.ConcurrentHashMap

/**
 * Runs [rules] over one log after another. The folder view in the window and the report both use it, so each can reuse results that the
 * other stored. Thread-safe.
 *
 * @param with everything else that affects the results, as a text: virtual topics and the x axis; empty for nothing.
 * @param measures whether the numbers of each log are calculated, as comparisons and charts need.
 */
class RuleExamination(
    private val rules: RuleSet,
    private val with: String = "",
    private val measures: Boolean = rules.comparisons.isNotEmpty(),
) {
    private val alike = ConcurrentHashMap<List<RuleOutcome>, List<RuleOutcome>>()
    private val programs = ShapeCache(MAX_PROGRAMS) { RuleProgram(rules, it) }

    /** Returns the results stored in [folder] by the [version] of the program. */
    fun storedIn(folder: Path, version: String): ResultCache<ExaminedLog> =
        ResultCache(folder, "$version\nreport $measures\n$with\n${rules.toJson()}", ExaminedLog.serializer())

    /**
     * Returns the results of the rules for [content], the content of the file called [name].
     *
     * @param checkpoint called repeatedly; an exception from it stops the work and is passed on.
     */
    fun of(content: LogContent, name: String, checkpoint: () -> Unit = {}): CachedResult<ExaminedLog> = when (content) {
        is LogContent.None -> {
            val named = matchInName(name)
            val none = ExaminedLog(
                title = null,
                findings = emptyList(),
                asked = emptyList(),
                unreadable = content.why.message,
                isNoLog = content.why.isLasting,
                matchType = named.type,
                event = named.event,
                matchNumber = named.number,
            )
            CachedResult(none, content.why.isLasting)
        }

        // A log that is left out of a match is named each time.
        is LogContent.Log -> CachedResult(
            of(content, name, checkpoint),
            isLasting = content.recording.problems.none { it.kind == ProblemKind.LOG_LEFT_OUT },
        )
    }

    private fun of(log: LogContent.Log, name: String, checkpoint: () -> Unit): ExaminedLog {
        val findings = ArrayList<Finding>()
        val asked = ArrayList<RuleOutcome>()
        for (rule in programs[log.view].run(log.view, name)) {
            checkpoint()
            findings += rule.findings
            asked += rule.refusal.let { RuleOutcome(rule.rule.name, it?.message, it?.mistake, it?.lacking, it?.simulated) }
        }
        val battery = batteryUseOf(log.view, rules.signals)
        val numbers = if (measures) numbersOf(log.view, rules.signals, name, battery).toText() else NO_NUMBERS
        val match = rules.signals.matchOf(log.recording, name)
        val date = LogDate.of(log.recording.values, name, modified = 0)
        return ExaminedLog(
            title = log.view.title,
            findings = findings,
            asked = alike.computeIfAbsent(asked) { asked },
            unreadable = null,
            isSalvaged = log.recording.isSalvaged,
            undefined = log.undefined,
            matchType = match.type,
            numberNames = numbers.names,
            numberValues = numbers.values,
            numberDistributions = numbers.distributions,
            event = match.event,
            matchNumber = match.number,
            began = date.second.takeIf { date.source != DateSource.FILE_TIME },
            battery = battery,
        )
    }

    private companion object {
        // Limited, because each program holds all names of its logs several times.
        const val MAX_PROGRAMS = 16
        val NO_NUMBERS = LogNumbers.NONE.toText()
    }
}

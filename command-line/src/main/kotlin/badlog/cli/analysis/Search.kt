package badlog.cli.analysis

import badlog.file.UnreadableFileException
import badlog.file.reading
import badlog.file.requireRegularFile
import badlog.report.Report
import badlog.report.ReportResult
import badlog.report.SkippedRule
import badlog.report.hook.HookRunner
import badlog.report.rules.RuleSet
import badlog.report.rules.RulesException
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.Path

/**
 * What to look for in logs.
 *
 * @property virtualTopics definitions of topics that logs have beside their own.
 */
internal class Search(private val rules: Path?, private val hooks: List<HookRunner>, val virtualTopics: List<String>) {
    /** Whether nothing is asked for. */
    val isEmpty: Boolean get() = rules == null && hooks.isEmpty()

    /**
     * The report that looks for it. The hooks that the rules name run too, since the person who named the rules knows them.
     *
     * @param unnamed the rules where none are named.
     * @param cache where findings are kept; null for nowhere.
     * @param xTopic the topic to take as x axis, or null.
     * @throws SearchException when there are no such rules.
     */
    fun report(unnamed: RuleSet, cache: Path? = null, xTopic: String? = null): Report {
        val ruleSet = when (rules) {
            null -> unnamed
            Path.of(DEFAULT_RULES) -> RuleSet.DEFAULT
            else -> read(rules)
        }
        return Report(ruleSet, hooks + ruleSet.hooks, virtualTopics, cache, xTopic)
    }

    private val hasOwnRules get() = rules != null && rules != Path.of(DEFAULT_RULES)

    /** Those of [skipped] that the user has to know: a log need not have all that badlog's own rules look for. */
    fun toldOf(skipped: List<SkippedRule>): List<SkippedRule> = if (hasOwnRules) skipped else emptyList()

    /** Whether a rule is wrong; one that could be asked of any log is right, others only lack its topics. */
    fun isMistaken(results: List<ReportResult>): Boolean {
        val skipped = results.flatMap { it.skipped }.groupBy { it.rule }.values
        val logs = results.sumOf { result -> result.logs.count { it.unreadable == null } }
        return skipped.any { ofRule -> ofRule.any { it.isMistake } && ofRule.sumOf { it.logs } == logs }
    }

    /** Whether a rule of the user's file could be asked of no log at all; of those of badlog's own, that is nothing unusual. */
    fun isNeverAsked(result: ReportResult): Boolean =
        hasOwnRules && result.skipped.any { it.logs == result.logs.count { log -> log.unreadable == null } }

    private fun read(file: Path) = try {
        RuleSet.parse(textOf(file), file.toAbsolutePath().parent)
    } catch (e: RulesException) {
        throw SearchException("$file: ${e.message}")
    }

    private fun textOf(file: Path): String = try {
        requireRegularFile(file)
        reading(file) { Files.readAllBytes(file) }.decodeToString(throwOnInvalidSequence = true)
    } catch (e: UnreadableFileException) {
        throw SearchException(e.message)
    } catch (_: CharacterCodingException) {
        throw SearchException("$file is not in UTF-8, as rules have to be; save it so in your editor.")
    }

    companion object {
        /** The name of the rules that badlog brings along. */
        const val DEFAULT_RULES = "default"
    }
}

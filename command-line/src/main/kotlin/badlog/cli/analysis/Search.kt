package badlog.cli.analysis

import badlog.report.Report
import badlog.report.hook.HookRunner
import badlog.report.rules.RuleSet
import badlog.report.rules.RulesException
import java.io.IOException
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
     * @throws SearchException when there are no such rules.
     */
    fun report(unnamed: RuleSet, cache: Path? = null): Report {
        val ruleSet = when (rules) {
            null -> unnamed
            Path.of(DEFAULT_RULES) -> RuleSet.DEFAULT
            else -> read(rules)
        }
        return Report(ruleSet, hooks + ruleSet.hooks, virtualTopics, cache)
    }

    private fun read(file: Path) = try {
        RuleSet.parse(Files.readString(file), file.toAbsolutePath().parent)
    } catch (e: RulesException) {
        throw SearchException("$file: ${e.message}")
    } catch (_: IOException) {
        throw SearchException("The rules in $file cannot be read; look for a typing error in its name.")
    }

    companion object {
        /** The name of the rules that badlog brings along. */
        const val DEFAULT_RULES = "default"
    }
}

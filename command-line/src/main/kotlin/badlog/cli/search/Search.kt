package badlog.cli.search

import badlog.files.UnreadableFileException
import badlog.files.reading
import badlog.files.requireRegularFile
import badlog.report.hook.HookRunner
import badlog.rules.RulesException
import badlog.rules.RulesFile
import badlog.rules.SkippedRule
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.Path

/**
 * The rules and hooks to run over logs.
 *
 * @property virtualTopics definitions of topics added to the logs' own.
 */
internal class Search(
    private val rules: Path?,
    private val isWithoutRules: Boolean,
    private val hooks: List<HookRunner>,
    val virtualTopics: List<String>,
) {
    private val hasOwnRules get() = rules != null && rules != Path.of(DEFAULT_RULES)

    /**
     * Returns the rules that were specified; null if none were.
     *
     * @throws SearchException if the rules file does not exist, cannot be read, or contains a mistake.
     */
    fun namedRules(): RulesFile? = when {
        isWithoutRules -> RulesFile.NONE
        rules == null -> null
        !hasOwnRules -> RulesFile.BUILT_IN
        else -> read(rules)
    }

    /** Returns all hooks to run, including those in [named], since the user specified that file. */
    fun hooksWith(named: RulesFile?): List<HookRunner> =
        hooks + named?.hooks.orEmpty().map { HookRunner.of(it, rules?.toAbsolutePath()?.parent) }

    /**
     * Returns the rules in [skipped] to report to the user. Built-in rules are not reported, because a log need not have all their topics.
     */
    fun reportedOf(skipped: List<SkippedRule>): List<SkippedRule> = if (hasOwnRules) skipped else emptyList()

    /** Returns the rules that were skipped for all logs; [skipped] has the skipped rules of each log. */
    fun skippedForAll(skipped: List<List<SkippedRule>>): List<SkippedRule> =
        reportedOf(skipped.flatten()).groupBy { it.rule }.values.filter { it.size == skipped.size }.flatten()

    private fun read(file: Path) = try {
        RulesFile.parse(textOf(file))
    } catch (e: RulesException) {
        throw SearchException("$file: ${e.message}")
    }

    private fun textOf(file: Path): String = try {
        requireRegularFile(file)
        reading(file) { Files.readAllBytes(file) }.decodeToString(throwOnInvalidSequence = true)
    } catch (e: UnreadableFileException) {
        throw SearchException(e.message)
    } catch (_: CharacterCodingException) {
        throw SearchException("$file is not UTF-8 text; save it as UTF-8 in your editor.")
    }

    companion object {
        /** The name of the built-in rules. */
        const val DEFAULT_RULES = "default"
    }
}

/** Thrown if a search cannot be run as requested. The message is for the user. */
internal class SearchException(override val message: String) : Exception(message)

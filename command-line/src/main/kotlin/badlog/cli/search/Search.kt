package badlog.cli.search

import badlog.file.UnreadableFileException
import badlog.file.reading
import badlog.file.requireRegularFile
import badlog.report.hook.HookRunner
import badlog.rules.RulesException
import badlog.rules.RulesFile
import badlog.rules.SkippedRule
import java.nio.charset.CharacterCodingException
import java.nio.file.Files
import java.nio.file.Path

/**
 * What to look for in logs.
 *
 * @property virtualTopics definitions of topics that logs have beside their own.
 */
internal class Search(
    private val rules: Path?,
    private val isWithoutRules: Boolean,
    private val hooks: List<HookRunner>,
    val virtualTopics: List<String>,
) {
    private val hasOwnRules get() = rules != null && rules != Path.of(DEFAULT_RULES)

    /**
     * The rules that were named; null where nothing is said of rules.
     *
     * @throws SearchException when there are no such rules.
     */
    fun namedRules(): RulesFile? = when {
        isWithoutRules -> RulesFile.NONE
        rules == null -> null
        !hasOwnRules -> RulesFile.BUILT_IN
        else -> read(rules)
    }

    /** All programs to run. Those that [named] names are among them, since the person who named that file knows them. */
    fun hooksWith(named: RulesFile?): List<HookRunner> =
        hooks + named?.hooks.orEmpty().map { HookRunner.of(it, rules?.toAbsolutePath()?.parent) }

    /** Those of [skipped] that the user has to know: a log need not have all that badlog's own rules look for. */
    fun reportedOf(skipped: List<SkippedRule>): List<SkippedRule> = if (hasOwnRules) skipped else emptyList()

    /** Of the rules that were refused by each of many logs, [skipped], those that all of them refused. */
    fun neverAsked(skipped: List<List<SkippedRule>>): List<SkippedRule> =
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

/** Nothing can be looked for as it was asked. The message is for a person. */
internal class SearchException(override val message: String) : Exception(message)

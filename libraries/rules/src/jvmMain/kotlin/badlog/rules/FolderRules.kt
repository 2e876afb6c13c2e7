package badlog.rules

import java.nio.file.Files
import java.nio.file.Path

/**
 * The rules for the logs of a folder, and the names of topics there.
 *
 * @property rules the rules, with the built-in vocabulary and the folder's additions.
 * @property file where they come from; null for the built-in ones.
 * @property problem why an existing file is not used, as a sentence, with the line of the mistake below it if there is one;
 *   null if all is well.
 */
class FolderRules private constructor(val rules: RuleSet, val file: Path?, val problem: String?) {
    companion object {
        /**
         * Returns the rules for [log]: those of the nearest file called [RulesFile.NAME] in its folder, or in one above it up to [top],
         * which is null for only its own folder; otherwise the built-in ones, also if that file has a mistake. The nearest file called
         * [SignalsFile.NAME] has further names of topics. Hooks in these rules are never run, because they may have come with the logs.
         */
        fun of(log: Path, top: Path? = null): FolderRules {
            fun <T> nearest(name: String, parse: (String) -> T) =
                NearestFile.of(log, top, { it.resolve(name).takeIf(Files::isRegularFile) }, parse)
            val signals = nearest(SignalsFile.NAME) { SignalsFile.parse(it) }
            val vocabulary = signals.found?.let(RuleSet.BUILT_IN.signals::with) ?: RuleSet.BUILT_IN.signals
            val rules = nearest(RulesFile.NAME) { RulesFile.parse(it, vocabulary).rules }
            val found = rules.found ?: if (signals.found == null) RuleSet.BUILT_IN else RuleSet.BUILT_IN.with(vocabulary)
            val problems = listOfNotNull(
                rules.problem?.let { "The built-in rules are used instead of ${rules.file}: $it" },
                signals.problem?.let { "The built-in names of signals are used without ${signals.file}: $it" },
            )
            return FolderRules(found, rules.file.takeIf { rules.found != null }, problems.joinToString("\n").ifEmpty { null })
        }
    }
}

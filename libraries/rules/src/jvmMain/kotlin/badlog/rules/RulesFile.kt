package badlog.rules

import badlog.signals.vocabulary.SignalVocabulary
import kotlin.time.Duration

/**
 * The content of a file of rules.
 *
 * @property rules the rules with their names for topics.
 * @property hooks the programs that it names. Run them only if the user of badlog specified the file: a file found among the logs came with
 *   them.
 * @property source the whole text.
 */
class RulesFile internal constructor(val rules: RuleSet, val hooks: List<HookCommand>, val source: String) {
    companion object {
        /** The name of a file of rules among logs. */
        const val NAME: String = "badlog-rules.toml"

        /**
         * Reads [text], which is TOML. The expressions are checked for each log, because its topics decide which names exist.
         *
         * @param signals the names of topics.
         * @throws RulesException at the first mistake.
         */
        fun parse(text: String, signals: SignalVocabulary = RuleSet.BUILT_IN.signals): RulesFile = notTooDeep {
            RulesReader(text, signals).read()
        }

        /** No rules, no hooks. */
        val NONE: RulesFile = RulesFile(RuleSet.NONE, emptyList(), "")

        val BUILT_IN: RulesFile by lazy { RulesFile(RuleSet.BUILT_IN, emptyList(), resource(NAME)) }
    }
}

internal fun resource(name: String): String =
    checkNotNull(RulesFile::class.java.getResourceAsStream("/badlog/rules/$name")).use { it.readBytes().decodeToString() }

/**
 * A program to run for each log, named in a file of rules.
 *
 * @property command the program and its arguments, at least one word.
 * @property name its name in the file, or null.
 * @property timeLimit the maximum time that it may take for a log; null for the default.
 */
class HookCommand internal constructor(val command: List<String>, val name: String?, val timeLimit: Duration?)

package badlog.rules

import badlog.rules.signal.SignalVocabulary
import kotlin.time.Duration

/**
 * What a file of rules says.
 *
 * @property rules the rules with their names for topics.
 * @property hooks the programs that it names. They are to be run only where the person who starts badlog named the file: one that
 *   lay among the logs came with them.
 * @property source the whole text.
 */
public class RulesFile internal constructor(public val rules: RuleSet, public val hooks: List<HookCommand>, public val source: String) {
    public companion object {
        /** What a file of rules among the logs is called. */
        public const val NAME: String = "badlog-rules.toml"

        /**
         * Reads [text], which is TOML. The expressions are checked when they meet a log, because what is a name depends on it.
         *
         * @param signals what topics are called.
         * @throws RulesException at the first mistake.
         */
        public fun parse(text: String, signals: SignalVocabulary = RuleSet.BUILT_IN.signals): RulesFile = notTooDeep {
            RulesReader(text, signals).read()
        }

        /** No rules, no hooks. */
        public val NONE: RulesFile = RulesFile(RuleSet.NONE, emptyList(), "")

        /** The built-in rules. */
        public val BUILT_IN: RulesFile by lazy { RulesFile(RuleSet.BUILT_IN, emptyList(), resource(NAME)) }
    }
}

/** The built-in rules, with the built-in vocabulary. */
public val RuleSet.Companion.BUILT_IN: RuleSet get() = BUILT_IN_RULES

// Reading TOML takes longer than exporting a small page, so that these are also there as JSON.
private val BUILT_IN_RULES by lazy {
    val rules = checkNotNull(RuleSet.fromJson(resource("badlog-rules.json")))
    rules.run { RuleSet(aliases, this.rules, signals, causes, comparisonsOf(resource("badlog-comparisons.json"))) }
}

internal fun resource(name: String): String =
    checkNotNull(RulesFile::class.java.getResourceAsStream("/badlog/rules/$name")).use { it.readBytes().decodeToString() }

/**
 * A program that a file of rules names, to be run for each log.
 *
 * @property command the program and its arguments, at least one word.
 * @property name what the file calls it, or null.
 * @property timeLimit how long it may take for a log; null for the usual time.
 */
public class HookCommand internal constructor(public val command: List<String>, public val name: String?, public val timeLimit: Duration?)

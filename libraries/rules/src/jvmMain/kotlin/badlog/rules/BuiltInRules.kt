package badlog.rules

import java.io.File

private const val RULES_JSON = "badlog-rules.json"
private const val COMPARISONS_JSON = "badlog-comparisons.json"

/** The built-in rules, with the built-in vocabulary. */
val RuleSet.Companion.BUILT_IN: RuleSet get() = BUILT_IN_RULES

private val BUILT_IN_RULES by lazy {
    val rules = checkNotNull(RuleSet.fromJson(resource(RULES_JSON)))
    rules.run { RuleSet(aliases, this.rules, signals, causes, comparisonsOf(resource(COMPARISONS_JSON))) }
}

/** Returns the built-in rules as their file says them; reading that takes longer than exporting a small page. */
internal fun builtInRulesFromToml(): RuleSet =
    RulesReader(resource(RulesFile.NAME), SignalsFile.parse(SignalsFile.builtInSource), isBuiltIn = true).read().rules

/** Writes the built-in rules as JSON into the folder that the only argument names: a step of the build. */
internal fun main(arguments: Array<String>) {
    val folder = File(arguments.single()).apply { mkdirs() }
    val rules = builtInRulesFromToml()
    File(folder, RULES_JSON).writeText(rules.toJson(haveChecklist = true))
    File(folder, COMPARISONS_JSON).writeText(comparisonsJson(rules.comparisons))
}

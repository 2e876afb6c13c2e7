package badlog.rules

import java.io.File

private const val RULES_JSON = "badlog-rules.json"

/** The built-in rules, with the built-in vocabulary. */
val RuleSet.Companion.BUILT_IN: RuleSet get() = BUILT_IN_RULES

private val BUILT_IN_RULES by lazy { checkNotNull(RuleSet.fromJson(resource(RULES_JSON))) }

/** Returns the built-in rules as their file says them; reading that takes longer than exporting a small page. */
internal fun builtInRulesFromToml(): RuleSet =
    RulesReader(resource(RulesFile.NAME), SignalsFile.parse(SignalsFile.builtInSource), isBuiltIn = true).read().rules

/** Writes the built-in rules as JSON into the folder that the only argument names: a step of the build. */
internal fun main(arguments: Array<String>) {
    val folder = File(arguments.single()).apply { mkdirs() }
    File(folder, RULES_JSON).writeText(builtInRulesFromToml().toJson(haveChecklist = true))
}

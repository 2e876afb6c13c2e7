package badlog.rules

import badlog.rules.standing.PROVEN_TRUST
import java.io.File

private const val RULES_JSON = "badlog-rules.json"

/** The built-in rules, with the built-in vocabulary. */
val RuleSet.Companion.BUILT_IN: RuleSet get() = BUILT_IN_RULES

/** The built-in rules as if all of them were proven, to measure their findings and causes. */
val RuleSet.Companion.BUILT_IN_PROVEN: RuleSet get() = PROVEN_RULES

private val PROVEN_RULES by lazy { builtInRulesFromToml { _, _ -> PROVEN_TRUST } }
private val BUILT_IN_RULES by lazy { checkNotNull(RuleSet.fromJson(resource(RULES_JSON))) }

/**
 * Reads the built-in rules from their file, which takes longer than exporting a small page.
 *
 * @param trust returns the trust in a rule from its name and the hash of its text.
 */
internal fun builtInRulesFromToml(trust: (name: String, hash: String) -> Double = ::countedTrust): RuleSet =
    RulesReader(resource(RulesFile.NAME), SignalsFile.parse(SignalsFile.builtInSource), isBuiltIn = true, trust).read().rules

/** Returns the hash of the text of each built-in rule, by its name. */
internal fun hashesOfBuiltInRules(): Map<String, String> {
    val rules = TomlText(resource(RulesFile.NAME)).run { tables(root(setOf("rule", "comparison", "cause", "leads_to")), "rule") }
    return rules.associate { (table, _) -> table.getString("name").orEmpty() to hashOf(table) }
}

/** Writes the built-in rules as JSON into the folder named by the only argument, as a step of the build. */
internal fun main(arguments: Array<String>) {
    val folder = File(arguments.single()).apply { mkdirs() }
    File(folder, RULES_JSON).writeText(builtInRulesFromToml().toJson(haveChecklist = true))
}

package badlog.rules

import badlog.rules.cause.Cause
import badlog.rules.cause.CauseGraph
import org.tomlj.TomlTable

/** Returns the causes and effects in a file of rules. Throws [RulesException] at the first mistake. */
internal fun causeGraphOf(toml: TomlText, root: TomlTable): CauseGraph {
    val causes = toml.tables(root, "cause").map { (table, place) ->
        toml.requireKnown(table, KEYS, "a cause")
        toml.requireKeys(table, place, listOf("name", "shown_by"), "cause")
        Cause(
            name = toml.string(table, "name").orEmpty(),
            shownBy = toml.strings(table, "shown_by"),
            topics = toml.patterns(table, "topics", isNeeded = false),
            except = toml.patterns(table, "except", isNeeded = false),
            together = togetherIn(table, toml),
            onlyWith = toml.optionalStrings(table, "only_with"),
            next = toml.string(table, "next").orEmpty(),
        )
    }
    val value = root.get(listOf("leads_to")) ?: return CauseGraph(causes, emptyMap())
    val table = value as? TomlTable ?: toml.fail(toml.placeOf(root, "leads_to"), "“leads_to” must be a table: [leads_to].")
    return CauseGraph(causes, table.keySet().associateWith { toml.strings(table, it) })
}

private fun togetherIn(table: TomlTable, toml: TomlText): Int {
    val value = table.get(listOf("together")) ?: return 1
    return (value as? Long)?.takeIf { it in 1L..MAX_TOGETHER }?.toInt()
        ?: toml.fail(
            toml.placeOf(table, "together"),
            "“together” is how many topics must have findings: a number from 1 to $MAX_TOGETHER.",
        )
}

private const val MAX_TOGETHER = 16

private val KEYS = setOf("name", "shown_by", "topics", "except", "together", "only_with", "next")

package badlog.rules

import badlog.core.json.quotedJson
import badlog.signals.battery.TeamBatteries
import badlog.signals.battery.TeamBattery
import org.tomlj.TomlTable

/** A file with a team's batteries; `docs/batteries.md` describes its format. */
object BatteriesFile {
    /** The name of such a file among logs. */
    const val NAME: String = "batteries.toml"

    /**
     * Reads [text], which is TOML.
     *
     * @throws RulesException at the first mistake.
     */
    fun parse(text: String): TeamBatteries = notTooDeep { BatteriesReader(TomlText(text)).read() }

    /**
     * Returns [text], which is such a file, with [battery] as the one that was in the robot for [log], a file's name or a match; everything
     * else in it stays as it is. An empty name takes the battery back.
     *
     * @throws RulesException if [text] has a mistake, or is written in a way that only a person can change.
     */
    fun withUse(text: String, log: String, battery: String): String {
        val before = parse(text)
        val own = quotedJson(log)
        val lines = text.lines().filterNot { log in before.used && isFor(it, log) }.toMutableList()
        val line = if (battery.isEmpty()) null else "$own = ${quotedJson(battery)}"
        val place = lines.indexOfFirst { it.substringBefore('#').trim() == "[$USED]" }
        if (line != null) {
            if (place >= 0) {
                lines.add(place + 1, line)
            } else {
                while (lines.lastOrNull()?.isBlank() == true) lines.removeLast()
                lines += listOfNotNull("".takeIf { lines.isNotEmpty() }, "[$USED]", line, "")
            }
        }
        val made = lines.joinToString("\n")
        val expected = if (battery.isEmpty()) before.used - log else before.used + (log to battery)
        if (parse(made).used != expected) throw RulesException(1, "The battery of $log cannot be changed here; change it in an editor.")
        return made
    }

    /** Returns whether [line] is that of [log] among the batteries used. */
    private fun isFor(line: String, log: String): Boolean {
        val key = line.substringBefore('=').trim()
        return key == quotedJson(log) || key == "'$log'" || key == log
    }

    internal const val USED = "used"
}

private class BatteriesReader(private val toml: TomlText) {
    fun read(): TeamBatteries {
        val root = toml.root(setOf("battery", BatteriesFile.USED))
        val names = HashSet<String>()
        val batteries = toml.tables(root, "battery").map { (table, place) ->
            toml.requireKnown(table, KEYS, "a battery")
            toml.requireKeys(table, place, listOf("name"), "battery")
            val name = toml.string(table, "name").orEmpty().trim()
            if (!names.add(name)) toml.fail(toml.placeOf(table, "name"), "There are two batteries named “$name”.")
            TeamBattery(name, bought(table), toml.isTrue(table, "retired"))
        }
        return TeamBatteries(batteries, used(root))
    }

    /** Returns the day, month or year, which may be written with or without quotes. */
    private fun bought(table: TomlTable): String? {
        val value = table.get(listOf("bought"))?.toString() ?: return null
        if (!DATE.matches(value)) toml.fail(toml.placeOf(table, "bought"), "“bought” is a date, as in bought = \"2025-01\".")
        return value
    }

    private fun used(root: TomlTable): Map<String, String> {
        val value = root.get(listOf(BatteriesFile.USED)) ?: return emptyMap()
        val mistake = "“used” is a table of logs or matches and their batteries, below [used]: \"Qualification 12\" = \"A1\"."
        val table = value as? TomlTable ?: toml.fail(toml.placeOf(root, BatteriesFile.USED), mistake)
        return table.keySet().associateWith { key ->
            (table.get(listOf(key)) as? String)?.trim()?.takeIf { it.isNotEmpty() } ?: toml.fail(toml.placeOf(table, key), mistake)
        }
    }

    private companion object {
        val KEYS = setOf("name", "bought", "retired")
        val DATE = Regex("\\d{4}(-\\d{2}(-\\d{2})?)?")
    }
}

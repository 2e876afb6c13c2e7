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
     * Returns [text], the content of such a file, with [battery] as the battery in the robot for [log]. [log] is the path of a log or a
     * match, as written in the file. Everything else in the file stays as it is. An empty name removes the battery.
     *
     * @throws RulesException if [text] has a mistake, or is written in a way that only a person can change.
     */
    fun withUse(text: String, log: String, battery: String): String {
        val before = parse(text)
        if (before.used[log].orEmpty() == battery) return text
        val made = edited(text, log, battery, isKnown = log in before.used)
        val expected = before.copy(used = if (battery.isEmpty()) before.used - log else before.used + (log to battery))
        val isRight = try {
            parse(made) == expected
        } catch (_: RulesException) {
            false
        }
        if (!isRight) throw RulesException(1, "The battery of $log cannot be changed here; change it in an editor.")
        return made
    }

    private fun edited(text: String, log: String, battery: String, isKnown: Boolean): String {
        val lineEnd = if ("\r\n" in text) "\r\n" else "\n"
        val lines = text.lines().toMutableList()
        val entry = "${quotedJson(log)} = ${quotedJson(battery)}"
        val own = if (isKnown) lines.indexOfFirst { isFor(it, log) } else -1
        val table = lines.indexOfFirst { TABLE.matches(it.substringBefore('#').trim()) }
        when {
            own >= 0 && battery.isEmpty() -> lines.removeAt(own)

            own >= 0 -> lines[own] = entry + behindValue(lines[own])

            table >= 0 -> lines.add(table + 1, entry)

            else -> {
                while (lines.lastOrNull()?.isBlank() == true) lines.removeLast()
                lines += listOfNotNull("".takeIf { lines.isNotEmpty() }, "[$USED]", entry, "")
            }
        }
        return lines.joinToString(lineEnd)
    }

    /** Returns whether [line] is the line for [log] among the batteries used. */
    private fun isFor(line: String, log: String): Boolean = listOf(quotedJson(log), "'$log'", log).any { key ->
        line.trimStart().startsWith(key) && line.trimStart().removePrefix(key).trimStart().startsWith("=")
    }

    /** The heading of the table, also behind a mark that some Windows editors write. */
    private val TABLE = Regex("\uFEFF?\\[ *\"?$USED\"? *]")

    /** Returns the text behind the battery's name in [line]: a comment. */
    private fun behindValue(line: String): String = VALUE.find(line)?.let { line.substring(it.range.last + 1) }.orEmpty()

    /** The key of a line, and the battery's name. */
    private val VALUE = Regex("^\\s*(?:\"(?:\\\\.|[^\"\\\\])*\"|'[^']*'|[^\"'=\\s]+)\\s*=\\s*(?:\"(?:\\\\.|[^\"\\\\])*\"|'[^']*')")

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

    /** Returns the day, month or year. */
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
        val DATE = Regex("\\d{4}(-(0[1-9]|1[0-2])(-\\d{2})?)?")
    }
}
